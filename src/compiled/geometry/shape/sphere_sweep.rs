//! Spheres of changing size, swept along a curve.
//!
//! With the sphere at u written as F(t, u) = |o + t d - C(u)|² - R(u)² <= 0, the surface of the
//! union lies where F = 0 and ∂F/∂u = 0, or on the spheres at the ends. All those places are
//! candidates; which stretches between them are inside is asked of F itself, so that nothing
//! depends on how many roots were found where the ray grazes.
//!
//! Source: van Wijk, Ray Tracing Objects Defined by Sweeping a Sphere, 1985.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::slab::SlabRay;
use crate::math::{Bounds, DVec3, Range, Ray, gamma, quadratic_roots, roots_in};
use smallvec::SmallVec;
use std::sync::Arc;

/// A polynomial in u, rising; up to the tenth degree.
type Polynomial = SmallVec<[f64; 12]>;

/// Candidates, or ends of stretches, along a ray.
type Places = SmallVec<[f64; 32]>;

/// One piece of the curve, for u from 0 to 1.
#[derive(Clone, Debug)]
pub(crate) struct SweepSegment {
    /// Coefficients of the centre, rising; all but two vanish where `is_line`.
    center: [DVec3; 4],
    radius: [f64; 4],
    is_line: bool,
    bounds: Bounds,
}

/// The union of the spheres of all segments.
#[derive(Clone, Debug)]
pub(crate) struct SphereSweep {
    pub(crate) segments: Arc<[SweepSegment]>,
    pub(crate) bounds: Bounds,
    /// Hits up to this ray parameter do not count.
    pub(crate) tolerance: f64,
}

impl SweepSegment {
    /// From coefficients of the centre and the radius, rising.
    pub(crate) fn new(center: [DVec3; 4], radius: [f64; 4], is_line: bool) -> Self {
        // The curve lies within the hull of its Bézier points, and so do its two shifts by R.
        let bezier =
            |c: [DVec3; 4]| [c[0], c[0] + c[1] / 3.0, c[0] + (c[1] * 2.0 + c[2]) / 3.0, c[0] + c[1] + c[2] + c[3]];
        let shifted = |side: f64| bezier(std::array::from_fn(|i| center[i] + DVec3::splat(side * radius[i])));
        let bounds = Bounds::around(shifted(1.0).into_iter().chain(shifted(-1.0)));
        Self { center, radius, is_line, bounds }
    }

    /// The box around all its spheres.
    pub(crate) fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn center_at(&self, u: f64) -> DVec3 {
        let [a, b, c, d] = self.center;
        a + (b + (c + d * u) * u) * u
    }

    fn radius_at(&self, u: f64) -> f64 {
        let [a, b, c, d] = self.radius;
        a + (b + (c + d * u) * u) * u
    }

    fn degree(&self) -> usize {
        if self.is_line { 1 } else { 3 }
    }

    /// |p - C(u)|² - R(u)² as a polynomial in u.
    fn power_of_point(&self, p: DVec3) -> Polynomial {
        let n = self.degree();
        let mut sum = Polynomial::from_elem(0.0, 2 * n + 1);
        let offset = |i: usize| if i == 0 { p - self.center[0] } else { -self.center[i] };
        for i in 0..=n {
            for j in 0..=n {
                sum[i + j] += offset(i).dot(offset(j)) - self.radius[i] * self.radius[j];
            }
        }
        sum
    }

    fn contains(&self, p: DVec3) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let power = self.power_of_point(p);
        power[0] <= 0.0 || power.iter().sum::<f64>() <= 0.0 || !roots_in(&power, 0.0, 1.0).is_empty()
    }

    /// The sphere whose surface is nearest to a point on the sweep.
    fn nearest(&self, p: DVec3) -> f64 {
        let power = self.power_of_point(p);
        let inner = roots_in(&derivative(&power), 0.0, 1.0);
        let ends = [0.0, 1.0].into_iter().chain(inner);
        ends.min_by(|a, b| value(&power, *a).total_cmp(&value(&power, *b))).unwrap_or(0.0)
    }

    /// Where a line meets the sphere at u.
    fn meet(&self, o: DVec3, d: DVec3, u: f64, out: &mut Places) {
        let (w, r) = (o - self.center_at(u), self.radius_at(u));
        out.extend(quadratic_roots(1.0, 2.0 * w.dot(d), w.length_squared() - r * r).into_iter().flatten());
    }

    /// Everywhere a line with unit direction may enter or leave, in order.
    fn candidates(&self, o: DVec3, d: DVec3) -> Places {
        let mut places = Places::new();
        self.meet(o, d, 0.0, &mut places);
        self.meet(o, d, 1.0, &mut places);
        if self.is_line {
            self.meet_cone(o, d, &mut places);
        } else {
            for u in roots_in(&self.envelope(o, d), 0.0, 1.0) {
                self.meet(o, d, u, &mut places);
            }
        }
        places.sort_unstable_by(f64::total_cmp);
        places
    }

    /// Where a line meets the cone that touches all spheres of a straight segment: there the
    /// best u is linear in t, and F a quadratic.
    fn meet_cone(&self, o: DVec3, d: DVec3, out: &mut Places) {
        let (w, axis) = (o - self.center[0], self.center[1]);
        let (r, widening) = (self.radius[0], self.radius[1]);
        let a = axis.length_squared() - widening * widening;
        if a <= 0.0 {
            return; // one sphere holds all others
        }
        let (start, rate) = ((axis.dot(w) + r * widening) / a, axis.dot(d) / a);
        let (square, linear) = (1.0 - a * rate * rate, 2.0 * (w.dot(d) - a * start * rate));
        let roots = quadratic_roots(square, linear, w.length_squared() - r * r - a * start * start);
        out.extend(roots.into_iter().flatten().filter(|t| (0.0..=1.0).contains(&(start + rate * t))));
    }

    /// The polynomial in u whose roots are the spheres on which a line touches the envelope:
    /// F = t² + 2 b t + c and ∂F/∂u = 2 b' t + c' without t.
    fn envelope(&self, o: DVec3, d: DVec3) -> Polynomial {
        let c = self.power_of_point(o);
        let mut b: Polynomial = self.center.iter().map(|k| -k.dot(d)).collect();
        b[0] += o.dot(d);
        let (db, dc) = (derivative(&b), derivative(&c));
        let mut sum = product(&dc, &dc);
        let mixed = product(&product(&b, &db), &dc);
        let last = product(&product(&db, &db), &c);
        for (total, (m, l)) in sum.iter_mut().zip(mixed.iter().zip(&last)) {
            *total += 4.0 * (l - m);
        }
        sum
    }

    /// Stretches of a line inside, in order.
    fn stretches(&self, o: DVec3, d: DVec3, segment: u32, out: &mut Vec<Stretch>) {
        let places = self.candidates(o, d);
        let mut open: Option<Stretch> = None;
        for pair in places.windows(2) {
            let inside = pair[0] < pair[1] && self.contains(o + d * (0.5 * (pair[0] + pair[1])));
            match &mut open {
                Some(stretch) if inside => stretch.high = pair[1],
                Some(_) if pair[0] < pair[1] => out.extend(open.take()),
                None if inside => {
                    open = Some(Stretch { low: pair[0], high: pair[1], low_segment: segment, high_segment: segment });
                }
                _ => {}
            }
        }
        out.extend(open);
    }
}

/// A stretch of a line inside the sweep, with the segments that begin and end it.
#[derive(Clone, Copy)]
struct Stretch {
    low: f64,
    high: f64,
    low_segment: u32,
    high_segment: u32,
}

fn derivative(p: &[f64]) -> Polynomial {
    p.iter().enumerate().skip(1).map(|(i, c)| c * i as f64).collect()
}

fn product(a: &[f64], b: &[f64]) -> Polynomial {
    let mut sum = Polynomial::from_elem(0.0, a.len() + b.len() - 1);
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            sum[i + j] += x * y;
        }
    }
    sum
}

fn value(p: &[f64], u: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, c| sum * u + c)
}

impl Primitive for SphereSweep {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let size = self.bounds.size().length();
        let near = NearRay::new(ray, self.bounds.center(), size);
        let line = Ray::new(near.origin, near.direction);
        let everywhere = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };
        let slabs = SlabRay::new(&line);
        let mut stretches = Vec::new();
        for (i, segment) in self.segments.iter().enumerate() {
            if slabs.may_meet(&segment.bounds, everywhere) {
                segment.stretches(near.origin, near.direction, i as u32, &mut stretches);
            }
        }
        stretches.sort_unstable_by(|a, b| a.low.total_cmp(&b.low));
        let mut record = |s: f64, part: u32| {
            let t = near.t(s);
            if range.contains(t) && t > self.tolerance {
                out.push(ShapeHit { t, part });
            }
        };
        let mut rest = stretches.into_iter();
        let Some(mut open) = rest.next() else { return };
        for next in rest.chain([Stretch { low: f64::INFINITY, high: 0.0, low_segment: 0, high_segment: 0 }]) {
            if next.low > open.high {
                record(open.low, open.low_segment);
                record(open.high, open.high_segment);
                open = next;
            } else if next.high > open.high {
                (open.high, open.high_segment) = (next.high, next.high_segment);
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        self.segments.iter().any(|segment| segment.contains(p))
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let p = ray.at(t);
        let segment = &self.segments[part as usize];
        let u = segment.nearest(p);
        let (center, radius) = (segment.center_at(u), segment.radius_at(u).abs());
        let normal = (p - center).normalize_or(DVec3::X);
        // Along a line of touch the sphere is only known to the square root of the rounding of u,
        // which moves the point by that squared.
        let size = self.bounds.min.abs().max(self.bounds.max.abs()).max_element();
        LocalSurface::plain(center + normal * radius, gamma(256) * size, normal)
    }
}
