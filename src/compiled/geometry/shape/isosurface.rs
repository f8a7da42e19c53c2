//! The surface where a function takes a value.
//!
//! A search halves the ray as POV-Ray does, because what it finds depends on the points at which it halves (function
//! facts, section 9.2). What may be left out is known for certain where the function can be enclosed, and believed of
//! `max_gradient` elsewhere. POV-Ray's hits lie up to `accuracy` behind the surface; here they are then moved in front of
//! it, so that nothing shades itself.

mod notes;
mod search;

pub(crate) use notes::SearchNotes;

use super::container::Container;
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::Function;
use crate::function::Slots;
use crate::math::{Bounds, DVec3, Range, Ray, gamma};
use search::Search;
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

/// POV-Ray's distance from a spherical container at which its normal counts.
const ON_SPHERE: f64 = 1e-10;

impl Isosurface {
    fn value(&self, p: DVec3, slots: &mut Slots) -> f64 {
        self.function.at_in(p, slots) - self.threshold
    }

    /// All hits until the first in `range`, or all, in POV-Ray's order.
    ///
    /// With `polishes` hits lie in front of the surface by no more than rounding, else up to `accuracy` behind it.
    fn search(&self, ray: &Ray, range: Range, first_only: bool, polishes: bool, out: &mut ShapeHits) {
        let Some((start, end)) = self.container.interval(ray) else { return };
        let start = start.max(0.0);
        if end < start {
            return;
        }
        let mut search = Search::new(self, ray, end, range.max, polishes);
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

    /// Forward differences over `accuracy`, as POV-Ray takes them; where that is not much more than rounding, over the
    /// length for which rounding and curvature cost alike.
    fn gradient(&self, p: DVec3) -> DVec3 {
        /// Roundings of a coordinate below which differences over `accuracy` have less than a third of all digits.
        const FEW_DIGITS: f64 = f64::EPSILON * (1 << 16) as f64;
        let size = p.abs().max_element();
        let step = if self.accuracy > FEW_DIGITS * size { self.accuracy } else { f64::EPSILON.sqrt() * size };
        let mut slots = Slots::new();
        let here = self.function.at_in(p, &mut slots);
        let slope = |axis: DVec3, slots: &mut Slots| self.function.at_in(p + axis * step, slots) - here;
        let g = DVec3::new(slope(DVec3::X, &mut slots), slope(DVec3::Y, &mut slots), slope(DVec3::Z, &mut slots));
        if g == DVec3::ZERO || !g.is_finite() {
            return DVec3::X;
        }
        // The square of its length has to be a number, too.
        if g.length_squared().is_normal() { g } else { g / g.abs().max_element() }
    }
}

impl Primitive for Isosurface {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        self.search(ray, range, false, true, out);
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let mut hits = ShapeHits::new();
        self.search(ray, range, true, true, &mut hits);
        super::nearest_of(hits)
    }

    fn occluded(&self, ray: &Ray, range: Range) -> bool {
        let mut hits = ShapeHits::new();
        self.search(ray, range, true, false, &mut hits);
        !hits.is_empty()
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
