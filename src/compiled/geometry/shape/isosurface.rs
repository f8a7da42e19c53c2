//! The surface where a function takes a value.
//!
//! A search halves the ray as POV-Ray does, because what it finds depends on the points at which it halves (function
//! facts, section 9.2). What may be left out is known for certain where the function can be enclosed, and believed of
//! `max_gradient` elsewhere. Hits lie up to `accuracy` behind the surface, as in POV-Ray; rays that leave them start in front
//! of it.

mod notes;
mod search;

pub(crate) use notes::SearchNotes;

use super::container::Container;
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::Function;
use crate::function::{Enclosure, EnclosureSlots, Interval, Slots};
use crate::math::{Bounds, DVec3, Range, Ray, gamma};
use search::{Search, meets_zero};
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
    /// Nothing is left out that enclosures of the function do not rule out.
    pub(crate) guaranteed: bool,
    /// What the searches of all rays found out.
    pub(crate) notes: Arc<SearchNotes>,
}

/// Parts of the surface: the function's own, and the cut by the container.
const SURFACE: u32 = 0;
const CAP: u32 = 1;

/// What POV-Ray skips where a ray leaves the surface, in units of the accuracy.
const SKIPPED: f64 = 5.0;

/// POV-Ray's least distance of what shades. Source: shading facts, shadow rays.
const LEAST_SHADE: f64 = 1e-3;

/// POV-Ray's distance from a spherical container at which its normal counts; of a small one, in units of its radius.
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
        let mut search = Search::new(self, ray, [start, end], range.max);
        let before = out.len();
        search.run(start, end, |t, part| {
            if range.contains(t) {
                out.push(ShapeHit { t, part });
            }
            // The exit through the container comes first but lies last.
            first_only && out.len() > before && t < end
        });
        search.finish();
    }

    /// The ray parameter at which a search ends between two parameters: POV-Ray's accuracy, in world units. A surface that
    /// has been made so small that this would be a good part of it is looked at as closely as before. Places that rounding
    /// cannot tell apart say nothing.
    fn accuracy_along(&self, ray: &Ray, [start, end]: [f64; 2]) -> f64 {
        let speed = ray.direction.length();
        let coarse = self.container.is_coarse(self.accuracy, speed);
        let accuracy = if coarse { self.accuracy / speed } else { self.accuracy };
        accuracy.max(16.0 * self.rounding_along(ray, start.abs().max(end.abs())))
    }

    /// How far rounding moves a point of a ray, up to a parameter, as a parameter.
    fn rounding_along(&self, ray: &Ray, farthest: f64) -> f64 {
        gamma(4) * (ray.origin.abs().max_element() / ray.direction.length() + farthest)
    }

    /// How far behind the surface a hit lies, as a ray parameter: back there is the last point in front of the surface
    /// that rounding can tell from the first one behind it. Rays that start there are outside, however flat they go.
    ///
    /// Nothing for a coarse accuracy, as by default: what POV-Ray skips where a ray leaves such a surface is more than the
    /// least distance of what shades, so that it shades itself at low light, and pictures show it.
    ///
    /// Source: the Illinois method, Dowell and Jarratt 1971, with a bisection wherever it is slower than that.
    fn depth(&self, ray: &Ray, t: f64) -> f64 {
        let Some((start, end)) = self.container.interval(ray) else { return 0.0 };
        let (accuracy, finest) = (self.accuracy_along(ray, [start, end]), self.rounding_along(ray, t));
        if SKIPPED * accuracy >= LEAST_SHADE {
            return 0.0;
        }
        let mut slots = Slots::new();
        let at_hit = self.value(ray.at(t), &mut slots);
        let sign = if at_hit > 0.0 { -1.0 } else { 1.0 };
        let mut value = |t: f64| (t, sign * self.value(ray.at(t), &mut slots));
        // The search halved a stretch that is as long as the accuracy, or half of it.
        let starts = [1.0, 0.5].map(|share| (t - share * accuracy).max(start.max(0.0)));
        let Some(mut near) = starts.into_iter().map(&mut value).find(|(_, at)| *at >= 0.0) else { return 0.0 };
        let mut far = (t, sign * at_hit);
        let mut widths = [f64::INFINITY; 2];
        let mut was_near = None;
        // Every third step halves the stretch, at least.
        for _ in 0..3 * f64::MANTISSA_DIGITS {
            let width = far.0 - near.0;
            if width <= 2.0 * finest {
                break;
            }
            let chord = meets_zero(near, far);
            let next = if width > 0.5 * widths[0] || chord.is_nan() {
                0.5 * (near.0 + far.0)
            } else {
                // A step away from an end next to the root brings the other end there.
                chord.clamp(near.0 + finest, far.0 - finest)
            };
            widths = [widths[1], width];
            let there = value(next);
            let again = was_near == Some(there.1 >= 0.0);
            was_near = Some(there.1 >= 0.0);
            let weight = if again { 0.5 } else { 1.0 };
            if there.1 >= 0.0 {
                (near, far.1) = (there, far.1 * weight);
            } else {
                (far, near.1) = (there, near.1 * weight);
            }
        }
        t - near.0
    }

    /// Forward differences over `accuracy`, as POV-Ray takes them; where that is not much more than rounding, over the
    /// length for which rounding and curvature cost alike. With the distance by which rounding of the value may move the
    /// surface.
    fn gradient(&self, p: DVec3) -> (DVec3, f64) {
        /// Roundings of a coordinate below which differences over `accuracy` have less than a third of all digits.
        const FEW_DIGITS: f64 = f64::EPSILON * (1 << 16) as f64;
        /// Roundings of a value that its differences have to outweigh.
        const MANY_ROUNDINGS: f64 = (1 << 10) as f64;
        let size = p.abs().max_element();
        let step = if self.accuracy > FEW_DIGITS * size { self.accuracy } else { f64::EPSILON.sqrt() * size };
        let mut slots = Slots::new();
        let here = self.function.at_in(p, &mut slots);
        let slope = |axis: DVec3, slots: &mut Slots| self.function.at_in(p + axis * step, slots) - here;
        let g = DVec3::new(slope(DVec3::X, &mut slots), slope(DVec3::Y, &mut slots), slope(DVec3::Z, &mut slots));
        let noise = gamma(8) * here.abs();
        if noise * MANY_ROUNDINGS > g.abs().max_element()
            && let Some(exact) = self.exact_gradient(p)
        {
            return (exact, noise / exact.length());
        }
        if g == DVec3::ZERO || !g.is_finite() {
            return (DVec3::X, 0.0);
        }
        // The square of its length has to be a number, too.
        let largest = g.abs().max_element();
        let g = if g.length_squared().is_normal() { g } else { g / largest };
        (g, noise / largest * step)
    }

    /// By rules of derivation, where these say anything.
    fn exact_gradient(&self, p: DVec3) -> Option<DVec3> {
        if !self.guaranteed {
            return None;
        }
        let mut slots = EnclosureSlots::new();
        let mut slope = |along: usize| {
            let coordinate = |axis: usize| {
                let slope = Interval::point(if axis == along { 1.0 } else { 0.0 });
                Enclosure { value: Interval::point(p[axis]), slope }
            };
            let Interval { low, high } = self.function.enclose_in(&[0, 1, 2].map(coordinate), &mut slots).slope;
            0.5 * low + 0.5 * high
        };
        let gradient = DVec3::new(slope(0), slope(1), slope(2));
        (gradient.is_finite() && gradient.length_squared().is_normal()).then_some(gradient)
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
        super::nearest_of(hits)
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
            if (p.distance(center) - radius).abs() < ON_SPHERE * radius.abs().min(1.0));
        let (gradient, noise) = self.gradient(p);
        let normal = if on_sphere { self.container.boundary(p).1 } else { gradient };
        LocalSurface { depth: self.depth(ray, t), ..LocalSurface::plain(p, error + noise, normal) }
    }
}
