//! Planes and discs.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, dot_error, gamma};

/// POV-Ray's threshold: what is above a plane by less than this is still inside, in units of the scene; nearer to the
/// origin than 1 it is a share of the distance from there, so that nothing is too small to be cut.
pub(crate) const PLANE_BOUNDARY: f64 = 1e-10;

/// The plane n · p = distance with a unit normal; inside is against the normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) normal: DVec3,
    pub(crate) distance: f64,
}

impl Plane {
    /// Signed distance of a point.
    fn height(&self, p: DVec3) -> f64 {
        self.normal.dot(p) - self.distance
    }

    /// Where a line passes through, how far around that the boundary and rounding reach, and whether it goes inside
    /// there; `None` for lines along the plane.
    pub(crate) fn passage(&self, ray: &Ray) -> Option<(f64, f64, bool)> {
        let (height, slope) = (self.height(ray.origin), self.normal.dot(ray.direction));
        let t = -height / slope;
        let reach = ray.origin.abs().max_element() + t.abs() * ray.direction.abs().max_element() + self.distance.abs();
        // Twice as thick as the boundary is at most.
        let margin = (2.0 * PLANE_BOUNDARY * reach.max(1.0) + gamma(64) * reach) / slope.abs();
        (t.is_finite() && margin.is_finite()).then_some((t, margin, slope < 0.0))
    }
}

impl Primitive for Plane {
    fn bounds(&self) -> Bounds {
        Bounds::INFINITE
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        if let Some(hit) = self.intersect(ray, range) {
            out.push(hit);
        }
    }

    #[inline]
    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let t = -self.height(ray.origin) / self.normal.dot(ray.direction);
        // A parallel ray gives an infinite t or NaN, which no range contains.
        (range.contains(t) && t.is_finite()).then_some(ShapeHit { t, part: 0 })
    }

    /// A plane and its inverse both contain their boundary, which is as thick as POV-Ray's or as rounding makes it.
    fn contains(&self, p: DVec3) -> bool {
        let height = self.height(p);
        // Twice for the rounding of a hit point that another surface put here.
        height <= 0.0
            || height < PLANE_BOUNDARY && height < PLANE_BOUNDARY * p.abs().max_element().max(self.distance.abs())
            || height <= 4.0 * dot_error(self.normal, p) + gamma(2) * self.distance.abs()
    }

    fn span(&self, ray: &Ray, Range { min, max }: Range) -> Range {
        /// Several times the thickness of the boundary and all rounding.
        const SLACK: f64 = gamma(64);
        let height = self.height(ray.origin);
        let slope = self.normal.dot(ray.direction);
        // What heights are uncertain by at the origin, and how that grows along the ray.
        let rounding = SLACK * (self.normal.abs().dot(ray.origin.abs()) + self.distance.abs());
        let slack = PLANE_BOUNDARY + rounding;
        let growth = SLACK * self.normal.abs().dot(ray.direction.abs());
        if slope > growth {
            Range { min, max: max.min((slack - height) / (slope - growth)) }
        } else if slope < -growth {
            Range { min: min.max((height - slack) / (growth - slope)), max }
        } else {
            Range { min, max }
        }
    }

    fn has_span(&self) -> bool {
        true
    }

    fn is_quick(&self) -> bool {
        true
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let p = ray.at(t);
        let point = p - self.normal * self.height(p);
        let error = 2.0 * dot_error(self.normal, point) + gamma(4) * (self.distance.abs() + point.abs().max_element());
        LocalSurface::plain(point, error, self.normal)
    }
}

/// A ring in the plane z = 0, between two squared radii; inside is the half space z < 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disc {
    pub(crate) hole_squared: f64,
    pub(crate) radius_squared: f64,
}

impl Primitive for Disc {
    fn bounds(&self) -> Bounds {
        let r = self.radius_squared.sqrt();
        Bounds { min: DVec3::new(-r, -r, 0.0), max: DVec3::new(r, r, 0.0) }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let t = -ray.origin.z / ray.direction.z;
        if range.contains(t) && t.is_finite() {
            let distance_squared = ray.at(t).truncate().length_squared();
            if self.hole_squared <= distance_squared && distance_squared <= self.radius_squared {
                out.push(ShapeHit { t, part: 0 });
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        p.z < 0.0
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        LocalSurface::plain(ray.at(t).with_z(0.0), 0.0, DVec3::Z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `inside(plane { y, 0 }, h * y)` of POV-Ray 3.7.0.10.
    fn check(height: f64, expected: bool) {
        let plane = Plane { normal: DVec3::Y, distance: 0.0 };
        assert_eq!(plane.contains(DVec3::new(3.0, height, -2.0)), expected, "{height}");
    }

    #[test]
    fn a_plane_is_as_thick_as_povrays() {
        check(-1.0, true);
        check(0.0, true);
        check(0.99e-10, true);
        check(1.01e-10, false);
    }
}
