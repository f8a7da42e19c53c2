//! `cubic`, `quartic`, `poly`: surfaces of any degree up to 35.

use super::outline::settle;
use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, MAX_DEGREE, Range, Ray, Roots, roots_in};
use std::sync::Arc;

/// The zeros of a polynomial in x, y and z; inside where not positive.
#[derive(Clone, Debug)]
pub(crate) struct Polynomial {
    /// Highest total degree.
    pub(crate) order: usize,
    /// Of x^i y^j z^k with i, then j, then k falling.
    pub(crate) coefficients: Arc<[f64]>,
}

/// Bits of the highest term's weight that may be lost to the others before far roots are looked for by themselves: less than
/// a third of what there are.
const SPARE_BITS: i32 = 16;

/// The highest degree up to which the interval next to a shape is one piece, and of more, one for so many degrees: over each,
/// the highest power grows by less than a few thousand times.
const HIGH_DEGREE: usize = 16;
const DEGREES_A_PIECE: usize = 8;

/// A polynomial along a ray, rising.
type Along = [f64; MAX_DEGREE + 1];

impl Polynomial {
    /// Combines all terms by Horner's rule in x, within it in y, within it in z: `step(sum, axis)`
    /// multiplies by a coordinate, `leaf(sum, c)` and `add` add. Most surfaces have few terms: what has
    /// none yet is not multiplied.
    #[inline]
    fn horner<S>(
        &self,
        zero: impl Fn() -> S,
        step: impl Fn(&mut S, usize),
        leaf: impl Fn(&mut S, f64),
        add: impl Fn(&mut S, &S),
    ) -> S {
        let shift = |sum: &mut Option<S>, axis: usize| {
            if let Some(sum) = sum {
                step(sum, axis);
            }
        };
        let join = |sum: &mut Option<S>, other: Option<S>| match (sum.as_mut(), other) {
            (Some(sum), Some(other)) => add(sum, &other),
            (None, other) => *sum = other,
            (Some(_), None) => {}
        };
        let mut next = self.coefficients.iter();
        let mut in_x = None;
        for i in (0..=self.order).rev() {
            let mut in_y = None;
            for j in (0..=self.order - i).rev() {
                let mut in_z = None;
                for _ in 0..=self.order - i - j {
                    shift(&mut in_z, 2);
                    if let Some(c) = next.next().filter(|c| **c != 0.0) {
                        leaf(in_z.get_or_insert_with(&zero), *c);
                    }
                }
                shift(&mut in_y, 1);
                join(&mut in_y, in_z);
            }
            shift(&mut in_x, 0);
            join(&mut in_x, in_y);
        }
        in_x.unwrap_or_else(zero)
    }

    /// Coefficients along a ray.
    fn along(&self, o: DVec3, d: DVec3) -> Along {
        // The orders of most surfaces, for each of which there is a program of its own.
        match self.order {
            0..=3 => self.along_in::<4>(o, d),
            4 => self.along_in::<5>(o, d),
            5..=6 => self.along_in::<7>(o, d),
            _ => self.along_in::<{ MAX_DEGREE + 1 }>(o, d),
        }
    }

    /// The same with room for `N` coefficients on the way.
    fn along_in<const N: usize>(&self, o: DVec3, d: DVec3) -> Along {
        let n = if N <= MAX_DEGREE { N - 1 } else { self.order };
        let multiply = |sum: &mut [f64; N], axis: usize| {
            for k in (1..=n).rev() {
                sum[k] = sum[k] * o[axis] + sum[k - 1] * d[axis];
            }
            sum[0] *= o[axis];
        };
        let add = |sum: &mut [f64; N], other: &[f64; N]| {
            for k in 0..=n {
                sum[k] += other[k];
            }
        };
        let mut along = [0.0; MAX_DEGREE + 1];
        along[..N].copy_from_slice(&self.horner(|| [0.0; N], multiply, |sum, c| sum[0] += c, add));
        along
    }

    /// A root by what the polynomial is there, not by its coefficients along the ray: high powers of these differ so much that
    /// a ray which leaves the surface would meet it again.
    fn polished(&self, ray: &Ray, root: f64, radius: f64) -> f64 {
        let mut t = root;
        // Newton's step doubles the digits.
        for _ in 0..2 {
            let (value, gradient, _) = self.sample(ray.at(t));
            t -= value / gradient.dot(ray.direction);
        }
        // Not where the ray only touches the surface, or to another root.
        let moved = (t - root).abs() * ray.direction.length();
        if moved <= f64::EPSILON.sqrt() * radius { t } else { root }
    }

    fn value(&self, p: DVec3) -> f64 {
        self.horner(|| 0.0, |sum, axis| *sum *= p[axis], |sum, c| *sum += c, |sum, other| *sum += other)
    }

    /// Value, gradient, and the sum of the magnitudes of all terms.
    fn sample(&self, p: DVec3) -> (f64, DVec3, f64) {
        type Sum = (f64, DVec3, f64);
        let multiply = |sum: &mut Sum, axis: usize| {
            sum.1 = sum.1 * p[axis] + DVec3::AXES[axis] * sum.0;
            sum.0 *= p[axis];
            sum.2 *= p[axis].abs();
        };
        let add = |sum: &mut Sum, other: &Sum| *sum = (sum.0 + other.0, sum.1 + other.1, sum.2 + other.2);
        let leaf = |sum: &mut Sum, c: f64| *sum = (sum.0 + c, sum.1, sum.2 + c.abs());
        self.horner(|| (0.0, DVec3::ZERO, 0.0), multiply, leaf, add)
    }
}

impl Primitive for Polynomial {
    fn bounds(&self) -> Bounds {
        Bounds::INFINITE
    }

    /// Roots near the point closest to the origin come from the polynomial itself, far ones from
    /// its reversal in 1/s, so that a vanishing leading coefficient does no harm.
    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let near = NearRay::new(ray, DVec3::ZERO, 0.0);
        let n = self.order;
        let along = &self.along(near.origin, near.direction)[..=n];
        let inside = near.range(range);
        let radius = balance(along);
        let mut record = |s: f64| {
            let t = if n > HIGH_DEGREE { self.polished(ray, near.t(s), radius) } else { near.t(s) };
            if range.contains(t) {
                out.push(ShapeHit { t, part: 0 });
            }
        };
        // A little further the polynomial does as well.
        let radius = if inside.max.max(-inside.min) <= radius * power_of_two(SPARE_BITS / n.max(1) as i32) {
            f64::INFINITY
        } else {
            radius
        };
        near_roots(along, [inside.min.max(-radius), inside.max.min(radius)]).into_iter().for_each(&mut record);
        let mut reversed = [0.0; MAX_DEGREE + 1];
        for (k, c) in along.iter().enumerate() {
            reversed[n - k] = *c;
        }
        let far = 1.0 / radius;
        for (low, high) in [(-far, 0.0), (0.0, far)] {
            let wanted = if high > 0.0 { inside.max > radius } else { inside.min < -radius };
            if wanted {
                let roots = roots_in(&reversed[..=n], low, high);
                roots.into_iter().filter(|u| u.abs() < far).for_each(|u| record(1.0 / u));
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        self.value(p) <= 0.0
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let (point, error, gradient) = super::onto_surface(ray.at(t), |p| self.sample(p));
        LocalSurface::plain(point, error, if gradient == DVec3::ZERO { DVec3::X } else { gradient })
    }
}

/// Roots in an interval around the point next to the shape. High powers differ so much between its middle and its ends that
/// what is of rounding at the ends hides the middle; so it is cut into pieces.
fn near_roots(along: &[f64], [low, high]: [f64; 2]) -> Roots {
    let n_pieces = (along.len() - 1).div_ceil(DEGREES_A_PIECE);
    if along.len() - 1 <= HIGH_DEGREE || !(high - low).is_finite() || low >= high {
        return roots_in(along, low, high);
    }
    let value = |s: f64| along.iter().rev().fold(0.0, |sum, c| sum * s + c);
    let end_of =
        |piece: usize| if piece == n_pieces { high } else { low + (high - low) * (piece as f64 / n_pieces as f64) };
    let mut all = Roots::new();
    for piece in 0..n_pieces {
        let ends = [end_of(piece), end_of(piece + 1)];
        let mut roots = roots_in(along, ends[0], ends[1]);
        settle(&mut roots, ends, ends.map(value));
        all.extend(roots);
    }
    all
}

/// A power of two near which the lowest and the highest term weigh the same, times 1.7: roots of even surfaces lie just
/// there, and a cut beside them keeps them whole. As if these weighed the same at 1, where one is missing.
fn balance(coefficients: &[f64]) -> f64 {
    let n = coefficients.len() as i32 - 1;
    let ratio = (coefficients[0] / coefficients[coefficients.len() - 1]).abs();
    let exponent = if ratio.is_normal() { exponent(ratio).div_euclid(n.max(1)) } else { 0 };
    1.7 * power_of_two(exponent)
}

/// What a power of two has to be raised to for a normal number not to be below it.
fn exponent(v: f64) -> i32 {
    (v.to_bits() >> 52 & 0x7ff) as i32 - 1023
}

/// 2^n for exponents of normal numbers.
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}
