//! Roots on superellipsoids that are not convex.
//!
//! A point is inside where the norm across z is no greater than the width there, g(z) = (1 - |z|^p)^(1/p). Between the
//! planes x = 0, y = 0 and z = 0 the slope of either along a line only rises or only falls: a p-norm of lengths is
//! convex where p >= 1 and concave where p <= 1 (Minkowski's inequality and its reverse), and the curve
//! |z|^p + g^p = 1 bends the other way. So what is known at both ends of a stretch bounds all between: slopes lie
//! between theirs, and values between the chord and the tangents. Stretches are halved until these bounds tell how often
//! the sign changes; no root is lost, however thin the shape.

use super::{Chord, Superellipsoid};
use crate::math::{DVec3, gamma};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Value and slope.
type Jet = (f64, f64);

/// What is known about a point of a chord.
#[derive(Clone, Copy)]
struct Place {
    s: f64,
    /// The norm across z.
    across: Jet,
    /// Up to where points with this z are inside.
    width: Jet,
}

impl Place {
    /// Less than 0 inside.
    fn gap(&self) -> f64 {
        self.across.0 - self.width.0
    }

    fn is_inside(&self) -> bool {
        self.gap() < 0.0
    }
}

/// Rounding of a gap: a dozen roundings of numbers up to about 1. What dips less is a contact.
const NOISE: f64 = gamma(16);

/// A stretch of a chord between symmetry planes.
struct Stretch<'a> {
    solid: &'a Superellipsoid,
    chord: &'a Chord,
    /// Signs of the coordinates there.
    side: DVec3,
}

impl Stretch<'_> {
    fn place(&self, s: f64) -> Place {
        // Rounding puts no end on the other side of its plane.
        let (p, d) = ((self.chord.at(s) * self.side).max(DVec3::ZERO), self.chord.near.direction * self.side);
        let [pe, pn] = self.solid.powers();
        let across = Superellipsoid::norm_along((p.x, d.x), (p.y, d.y), pe);
        Place { s, across, width: width((p.z, d.z), pn) }
    }

    /// An end of a stretch that may be where the line meets the plane |z| = 1. There rounding could make the width of a
    /// flat side any number.
    fn end(&self, s: f64, rim: f64) -> Place {
        let mut place = self.place(s);
        if s == rim {
            place.width = width((1.0, self.chord.near.direction.z * self.side.z), self.solid.powers()[1]);
        }
        place
    }

    /// Whether there may be more sign changes between two places than their own signs say.
    fn may_hide(&self, a: &Place, b: &Place) -> bool {
        let span = |f: fn(&Place) -> f64| (f(a).min(f(b)), f(a).max(f(b)));
        let (across, width) = (span(|p| p.across.1), span(|p| p.width.1));
        if across.0 - width.1 >= 0.0 || across.1 - width.0 <= 0.0 {
            return false;
        }
        let [pe, pn] = self.solid.powers();
        if a.is_inside() != b.is_inside() {
            // A concave difference changes sign once.
            return !(pe <= 1.0 && pn <= 1.0);
        }
        // The difference of the larger and the smaller; whether tangents are what bounds it.
        let (larger, smaller) = if a.is_inside() {
            (([a.width, b.width], pn < 1.0), ([a.across, b.across], pe < 1.0))
        } else {
            (([a.across, b.across], pe > 1.0), ([a.width, b.width], pn > 1.0))
        };
        let length = b.s - a.s;
        let reaches_zero = |(ends, by_tangents): ([Jet; 2], bool)| {
            // Both bounds are straight but where tangents meet.
            by_tangents && {
                let u = meeting(ends, length);
                let lower = below(larger.0, length, u);
                let upper = above(smaller.0, length, u);
                // What is not a number proves nothing.
                let excluded = lower - upper >= -NOISE;
                !excluded
            }
        };
        reaches_zero(larger) || reaches_zero(smaller)
    }

    /// The root between two places inside and outside, where there is one: Newton's method, kept inside a shrinking
    /// bracket. Source: Press et al., Numerical Recipes, section 9.4 (`rtsafe`).
    fn root(&self, mut a: Place, mut b: Place) -> f64 {
        let (mut s, mut step) = (a.s + (b.s - a.s) * (a.gap() / (a.gap() - b.gap())), b.s - a.s);
        // Bisection alone ends after about 60 rounds for neighbouring numbers; Newton needs few.
        for _ in 0..100 {
            if !(a.s < s && s < b.s) {
                s = 0.5 * (a.s + b.s);
            }
            if s <= a.s || s >= b.s {
                break;
            }
            let place = self.place(s);
            *if place.is_inside() == a.is_inside() { &mut a } else { &mut b } = place;
            let newton = -place.gap() / (place.across.1 - place.width.1);
            if newton.abs() <= gamma(1) * s.abs() {
                return s + newton;
            }
            let middle = 0.5 * (a.s + b.s);
            // Steps that do not shrink lead nowhere.
            let next = if 2.0 * newton.abs() <= step.abs() { s + newton } else { middle };
            (s, step) = (next, next - s);
        }
        s
    }
}

/// (1 - z^p)^(1/p) and its slope, for z up to 1.
fn width((z, dz): Jet, p: f64) -> Jet {
    let z = z.min(1.0);
    // Below 1 there is always some, however far below the least number: the axis itself is inside.
    let least = if z < 1.0 { f64::from_bits(1) } else { 0.0 };
    let width = (1.0 - z.powf(p)).powf(1.0 / p).max(least);
    // Slopes without end are what bounds are made for.
    (width, if dz == 0.0 { 0.0 } else { -dz * (z / width).powf(p - 1.0) })
}

/// Where tangents at both ends of a stretch meet, from its start.
fn meeting([(v0, d0), (v1, d1)]: [Jet; 2], length: f64) -> f64 {
    if d1.is_infinite() {
        length
    } else if d0.is_infinite() {
        0.0
    } else {
        ((v1 - v0 - d1 * length) / (d0 - d1)).clamp(0.0, length)
    }
}

/// Chord and tangents of a stretch at a distance from its start. A tangent that is not a number is one of
/// infinite slope where it touches: the function is left at once.
fn lines([(v0, d0), (v1, d1)]: [Jet; 2], length: f64, u: f64) -> [f64; 3] {
    [v0 + (v1 - v0) * (u / length), v0 + d0 * u, v1 - d1 * (length - u)]
}

/// The least that a function may be whose slope only rises or only falls.
fn below(ends: [Jet; 2], length: f64, u: f64) -> f64 {
    let [chord, first, second] = lines(ends, length, u);
    chord.min(first.max(second))
}

/// The most.
fn above(ends: [Jet; 2], length: f64, u: f64) -> f64 {
    let [chord, first, second] = lines(ends, length, u);
    chord.max(first.min(second))
}

impl Superellipsoid {
    /// Every root on a chord, in rising order, until `record` breaks.
    pub(super) fn roots(&self, chord: &Chord, mut record: impl FnMut(f64) -> ControlFlow<()>) -> ControlFlow<()> {
        let (o, d) = (chord.near.origin, chord.near.direction);
        // All is outside where |z| > 1. What is not a number does not confine.
        let (top, bottom) = ((1.0 - o.z) / d.z, (-1.0 - o.z) / d.z);
        let rim = (top.min(bottom), top.max(bottom));
        let (low, high) = (chord.low.max(rim.0), chord.high.min(rim.1));
        let mut cuts: SmallVec<[f64; 5]> = SmallVec::from_slice(&[low]);
        cuts.extend((-o / d).to_array().into_iter().filter(|s| low < *s && *s < high));
        cuts.push(high);
        cuts.sort_unstable_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let side = DVec3::ONE.copysign(chord.at(0.5 * (pair[0] + pair[1])));
            let stretch = Stretch { solid: self, chord, side };
            let mut waiting: SmallVec<[(Place, Place); 8]> = SmallVec::new();
            if pair[0] < pair[1] {
                waiting.push((stretch.end(pair[0], rim.0), stretch.end(pair[1], rim.1)));
            }
            while let Some((a, b)) = waiting.pop() {
                let middle = 0.5 * (a.s + b.s);
                if a.s < middle && middle < b.s && stretch.may_hide(&a, &b) {
                    let middle = stretch.place(middle);
                    waiting.extend([(middle, b), (a, middle)]);
                } else if a.is_inside() != b.is_inside() {
                    record(stretch.root(a, b))?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Primitive;
    use super::*;
    use crate::math::{MersenneTwister, Range, Ray};

    /// Between samples of rays there is an odd number of roots exactly where one sample is inside.
    fn check(east_west: f64, north_south: f64) {
        const SAMPLES: usize = 500;
        let solid = Superellipsoid { east_west, north_south };
        let mut twister = MersenneTwister::default();
        let mut random = || 2.0 * twister.next_f64() - 1.0;
        let mut found = 0;
        for _ in 0..40 {
            let mut vector = || DVec3::new(random(), random(), random());
            let (from, to) = (vector().normalize() * 3.0, vector() * 0.6);
            let ray = Ray::new(from, (to - from).normalize());
            let range = Range { min: 1.0, max: 5.0 };
            let mut hits = Vec::new();
            let chord = Chord::new(&ray, range).unwrap();
            let _: ControlFlow<()> = solid.roots(&chord, |s| {
                hits.push(chord.near.t(s));
                ControlFlow::Continue(())
            });
            assert!(hits.is_sorted(), "{hits:?}");
            found += hits.len();
            let nearest = solid.intersect(&ray, range).map(|hit| hit.t);
            assert_eq!(nearest, hits.first().copied());
            let at = |i: usize| range.min + (range.max - range.min) * i as f64 / SAMPLES as f64;
            for i in 0..SAMPLES {
                let n_hits = hits.iter().filter(|t| at(i) <= **t && **t < at(i + 1)).count();
                let [a, b] = [at(i), at(i + 1)].map(|t| solid.contains(ray.at(t)));
                assert_eq!(n_hits % 2 == 1, a != b, "<{east_west}, {north_south}> {ray:?} at {}: {hits:?}", at(i));
            }
        }
        assert!(found > 20, "{found} roots of <{east_west}, {north_south}>");
    }

    #[test]
    fn no_root_is_lost() {
        for east_west in [0.1, 0.5, 1.0, 2.0, 2.5, 4.0] {
            for north_south in [2.5, 3.0, 5.0] {
                check(east_west, north_south);
            }
        }
        for north_south in [0.1, 0.5, 1.0, 2.0] {
            check(2.2, north_south);
            check(3.0, north_south);
        }
    }
}
