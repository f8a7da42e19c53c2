//! The surface where a function takes a value.
//!
//! POV-Ray's search is kept step by step, because its results depend on it: hits lie on the
//! points at which it halves, up to `accuracy` behind the surface (function facts, section 9.2).

use super::container::Container;
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::function::{Function, Slots};
use crate::math::{Bounds, DVec3, Range, Ray, gamma};
use std::sync::Arc;

/// f(x, y, z) = threshold within a container; inside where not above.
#[derive(Clone, Debug)]
pub(crate) struct Isosurface {
    pub(crate) function: Arc<Function>,
    pub(crate) container: Container,
    pub(crate) threshold: f64,
    /// Ray parameter, in world units, at which halving stops.
    pub(crate) accuracy: f64,
    /// What the file states as the steepest slope.
    pub(crate) max_gradient: f64,
    /// Parameters of the adaptive slope.
    pub(crate) evaluate: Option<[f64; 3]>,
    /// Most hits of the surface itself.
    pub(crate) max_trace: u32,
    /// Without caps where the container cuts the solid.
    pub(crate) open: bool,
}

/// Parts of the surface: the function's own, and the cut by the container.
const SURFACE: u32 = 0;
const CAP: u32 = 1;

/// POV-Ray's farthest distance of a search.
const FARTHEST: f64 = 2e10;

/// POV-Ray's distance from a spherical container at which its normal counts.
const ON_SPHERE: f64 = 1e-10;

impl Isosurface {
    fn value(&self, p: DVec3, slots: &mut Slots) -> f64 {
        self.function.at_in(p, slots) - self.threshold
    }

    /// All hits until the first in `range`, or all, in POV-Ray's order.
    fn search(&self, ray: &Ray, range: Range, first_only: bool, out: &mut ShapeHits) {
        let Some((start, end)) = self.container.interval(ray) else { return };
        let start = start.max(0.0);
        if end < start {
            return;
        }
        let mut search = Search {
            surface: self,
            ray,
            speed: ray.direction.length(),
            gradient: self.max_gradient,
            sign: 1.0,
            beyond: range.max,
            slots: Slots::new(),
        };
        let before = out.len();
        search.run(start, end, |t, part| {
            if range.contains(t) {
                out.push(ShapeHit { t, part });
            }
            // The exit through the container comes first but lies last.
            first_only && out.len() > before && t < end
        });
    }

    /// Forward differences over `accuracy`, as POV-Ray takes them.
    fn gradient(&self, p: DVec3) -> DVec3 {
        let mut slots = Slots::new();
        let here = self.function.at_in(p, &mut slots);
        let slope = |axis: DVec3, slots: &mut Slots| self.function.at_in(p + axis * self.accuracy, slots) - here;
        let g = DVec3::new(slope(DVec3::X, &mut slots), slope(DVec3::Y, &mut slots), slope(DVec3::Z, &mut slots));
        if g == DVec3::ZERO || !g.is_finite() { DVec3::X } else { g }
    }
}

/// A ray's search for hits.
struct Search<'a> {
    surface: &'a Isosurface,
    ray: &'a Ray,
    /// Length of the ray's direction.
    speed: f64,
    /// Steepest slope as far as is known.
    gradient: f64,
    /// -1 while the ray is inside.
    sign: f64,
    /// Nothing behind this matters.
    beyond: f64,
    slots: Slots,
}

/// A stretch of the ray with the signed values at its ends.
#[derive(Clone, Copy)]
struct Stretch {
    low: f64,
    high: f64,
    at_low: f64,
    at_high: f64,
    /// Most that the value can change from end to end.
    bound: f64,
}

impl Search<'_> {
    fn value(&mut self, t: f64) -> f64 {
        self.surface.value(self.ray.at(t), &mut self.slots)
    }

    /// Calls `found` with every hit until it returns true.
    fn run(&mut self, start: f64, end: f64, mut found: impl FnMut(f64, u32) -> bool) {
        let (accuracy, far) = (self.surface.accuracy, end.min(FARTHEST));
        let (mut low, mut count) = (start, 0);
        if !self.surface.open {
            // A hit on the container counts only if anything is left to search.
            let mut caps: [Option<f64>; 2] = [None; 2];
            if start > accuracy {
                if self.value(start) < 0.0 {
                    caps[0] = Some(start);
                    count = 1;
                    self.sign = -1.0;
                }
            } else {
                if self.value(start) < self.near_zero() {
                    low = 5.0 * accuracy;
                    self.turn_at(low);
                }
                caps[1] = (self.value(end) < 0.0).then_some(end);
            }
            if far - low.min(far) < accuracy || caps.into_iter().flatten().any(|t| found(t, CAP)) {
                return;
            }
        }
        low = low.min(far);
        if far - low < accuracy {
            return;
        }
        if low < accuracy && self.sign > 0.0 && self.value(low).abs() < self.near_zero() {
            low = 5.0 * accuracy;
            self.turn_at(low);
        }
        while count < self.surface.max_trace {
            let Some(root) = self.first_root(low, far) else { return };
            low = root + 5.0 * accuracy;
            if found(root, SURFACE) || far - low < accuracy {
                return;
            }
            self.sign = -self.sign;
            count += 1;
        }
    }

    /// Values below this may belong to the surface that the ray leaves.
    fn near_zero(&self) -> f64 {
        4.0 * self.gradient * self.surface.accuracy
    }

    /// Starts inside if the function says so there.
    fn turn_at(&mut self, t: f64) {
        if self.value(t) < 0.0 {
            self.sign = -1.0;
        }
    }

    /// Where the signed value first falls below zero.
    fn first_root(&mut self, low: f64, high: f64) -> Option<f64> {
        if let Some([limit, _, factor]) = self.surface.evaluate
            && self.gradient > limit
        {
            self.gradient *= factor;
        }
        let (at_low, at_high) = (self.value(low), self.value(high));
        if self.surface.open && self.sign * at_low < 0.0 {
            self.sign = -self.sign;
        }
        let bound = self.gradient * self.speed * (high - low);
        self.halve(Stretch { low, high, at_low: at_low * self.sign, at_high: at_high * self.sign, bound })
    }

    /// Halves until the stretch is as short as `accuracy`; NaN ends the search there.
    fn halve(&mut self, mut s: Stretch) -> Option<f64> {
        if s.low >= self.beyond {
            return None;
        }
        let length = s.high - s.low;
        if let Some([_, reserve, _]) = self.surface.evaluate {
            let slope = (s.at_high - s.at_low).abs() / (self.speed * length);
            if self.gradient < reserve * slope {
                self.gradient = reserve * reserve * slope;
                s.bound = self.gradient * self.speed * length;
            }
        }
        if length < self.surface.accuracy {
            return (s.at_high < 0.0).then_some(s.high);
        }
        let middle = 0.5 * (s.low + s.high);
        // Neighbouring numbers have no middle, however small the accuracy.
        if s.at_low + s.at_high >= s.bound || (s.at_low + s.at_high).is_nan() || middle <= s.low || middle >= s.high {
            return None;
        }
        let (at_middle, bound) = (self.value(middle) * self.sign, 0.5 * s.bound);
        self.halve(Stretch { high: middle, at_high: at_middle, bound, ..s })
            .or_else(|| self.halve(Stretch { low: middle, at_low: at_middle, bound, ..s }))
    }
}

impl Primitive for Isosurface {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        self.search(ray, range, false, out);
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let mut hits = ShapeHits::new();
        self.search(ray, range, true, &mut hits);
        hits.into_iter().reduce(|best, hit| if hit.t <= best.t { hit } else { best })
    }

    fn contains(&self, p: DVec3) -> bool {
        self.container.contains(p) && self.value(p, &mut Slots::new()) <= 0.0
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let p = ray.at(t);
        let error = gamma(32) * p.abs().max(self.bounds().center().abs()).max_element();
        if part == CAP {
            let (point, normal) = self.container.boundary(p);
            return LocalSurface::plain(point, error, normal);
        }
        let on_sphere = matches!(self.container, Container::Sphere { center, radius }
            if (p.distance(center) - radius).abs() < ON_SPHERE);
        let normal = if on_sphere { self.container.boundary(p).1 } else { self.gradient(p) };
        LocalSurface::plain(p, error, normal)
    }
}
