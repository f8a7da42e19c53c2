//! Flat polygons with holes.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray};
use std::sync::Arc;

/// Closed outlines in the plane z = 0; what an odd number of them surrounds is there.
#[derive(Clone, Debug)]
pub(crate) struct Polygon {
    /// Edges of all outlines.
    pub(crate) edges: Arc<[[DVec2; 2]]>,
}

/// Whether a point is surrounded an odd number of times. Edges hold their lower end and not their
/// upper one, so that a corner counts once.
pub(super) fn even_odd(edges: &[[DVec2; 2]], p: DVec2) -> bool {
    let crossed =
        |[a, b]: &&[DVec2; 2]| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
    edges.iter().filter(crossed).count() % 2 == 1
}

impl Primitive for Polygon {
    fn bounds(&self) -> Bounds {
        Bounds::around(self.edges.iter().flatten().map(|p| p.extend(0.0)))
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let t = -ray.origin.z / ray.direction.z;
        if range.contains(t) && t.is_finite() && even_odd(&self.edges, ray.at(t).truncate()) {
            out.push(ShapeHit { t, part: 0 });
        }
    }

    fn contains(&self, _p: DVec3) -> bool {
        false
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        LocalSurface::plain(ray.at(t).with_z(0.0), 0.0, DVec3::Z)
    }
}
