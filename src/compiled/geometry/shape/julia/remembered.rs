//! The orbit that POV-Ray takes a hypercomplex set's normal from.
//!
//! POV-Ray keeps one array of orbit points along a ray and overwrites it with every point that it looks at, the hit
//! last. For most functions it tests another point than it steps to (function facts, section 11); where the hit's own
//! orbit escapes, the points behind the escape are those of earlier ones, and the normal is made of both (measured).

use super::hypercomplex::Pair;
use super::{Event, Julia, hypercomplex_gradient};
use crate::math::{DVec3, DVec4, Range, Ray};
use smallvec::SmallVec;

/// The array, for one ray.
pub(super) struct Remembered<'a> {
    julia: &'a Julia,
    /// q₀ to the last point of an orbit that stays.
    points: SmallVec<[Pair; 24]>,
}

impl<'a> Remembered<'a> {
    /// As it is when POV-Ray asks for the normal where the ray meets the set at `t`.
    pub(super) fn at(julia: &'a Julia, ray: &Ray, t: f64) -> Self {
        let points = SmallVec::from_elem(Pair::from(DVec4::ZERO), julia.n_iterations + 1);
        let mut remembered = Self { julia, points };
        // An orbit that stays overwrites everything.
        if remembered.follow(julia.tested_start(ray.at(t))) {
            return remembered;
        }
        let everywhere = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };
        julia.march(ray, everywhere, |event| {
            remembered.follow(match event {
                Event::Sample(p) => julia.start(p),
                Event::Test(p) => julia.tested_start(p),
                Event::Change(t) => julia.tested_start(ray.at(t)),
            });
            matches!(event, Event::Change(change) if change >= t)
        });
        remembered
    }

    /// Notes an orbit; whether it stays.
    fn follow(&mut self, start: DVec4) -> bool {
        let (mut q, c) = (Pair::from(start), Pair::from(self.julia.parameter));
        let (escape, mut norm) = (self.julia.escape(), start.length_squared());
        let Some((last, before)) = self.points.split_last_mut() else { return false };
        for point in before {
            *point = q;
            if norm > escape {
                return false;
            }
            q = q.apply(self.julia.function).plus(c);
            norm = q.norm();
        }
        *last = q;
        true
    }

    /// POV-Ray's direction of growth.
    pub(super) fn gradient(&self) -> DVec3 {
        let julia = self.julia;
        let (Some(first), Some((last, before))) = (self.points.first(), self.points.split_last()) else {
            return DVec3::X;
        };
        let inner = before.iter().skip(1);
        let product = inner.fold(*first, |d, q| d.times(julia.slope(*q, q.apply(julia.function))));
        hypercomplex_gradient(product, last.scaled(julia.gradient_scale(julia.n_iterations)))
    }
}
