//! Spheres.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, gamma};

/// A sphere; a negative radius turns the normal inward.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sphere {
    pub(crate) center: DVec3,
    pub(crate) radius: f64,
}

impl Sphere {
    /// Both crossings in rising order, anywhere on the line.
    ///
    /// The half chord comes from the vector between centre and ray, the near root from the
    /// product of the roots: neither cancels. Source: Haines et al., Precision Improvements for
    /// Ray/Sphere Intersection, Ray Tracing Gems, chapter 7.
    #[inline]
    pub(crate) fn roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        let offset = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let b = offset.dot(ray.direction);
        let across = offset - ray.direction * (b / a);
        let h2 = self.radius * self.radius - across.length_squared();
        if h2 <= 0.0 || h2.is_nan() {
            return None;
        }
        let distance = offset.length();
        let radius = self.radius.abs();
        let c = (distance - radius) * (distance + radius);
        let q = -b - (a * h2).sqrt().copysign(b);
        let (far, near) = (q / a, c / q);
        Some(if near <= far { (near, far) } else { (far, near) })
    }
}

impl Primitive for Sphere {
    fn bounds(&self) -> Bounds {
        let r = DVec3::splat(self.radius.abs());
        Bounds { min: self.center - r, max: self.center + r }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let Some((near, far)) = self.roots(ray) else { return };
        for t in [near, far] {
            if range.contains(t) {
                out.push(ShapeHit { t, part: 0 });
            }
        }
    }

    #[inline]
    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let (near, far) = self.roots(ray)?;
        let t = if range.contains(near) { near } else { far };
        range.contains(t).then_some(ShapeHit { t, part: 0 })
    }

    fn contains(&self, point: DVec3) -> bool {
        point.distance_squared(self.center) < self.radius * self.radius
    }

    fn excludes(&self, point: DVec3) -> bool {
        point.distance_squared(self.center) > self.radius * self.radius
    }

    fn span(&self, ray: &Ray, Range { min, max }: Range) -> Range {
        // A point inside is no farther away than this, which bounds its rounding and that of the roots.
        let reach = self.center.abs().element_sum() + ray.origin.abs().element_sum() + self.radius.abs();
        let larger = Self { center: self.center, radius: self.radius.abs() + gamma(64) * reach };
        match larger.roots(ray) {
            Some((near, far)) => Range { min: min.max(near), max: max.min(far) },
            None => Range::EMPTY,
        }
    }

    fn has_span(&self) -> bool {
        true
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn is_chordal(&self) -> bool {
        true
    }

    fn is_quick(&self) -> bool {
        true
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let radius = self.radius.abs();
        let outward = (ray.at(t) - self.center).try_normalize().unwrap_or(DVec3::Y);
        let point = self.center + outward * radius;
        let error = gamma(8) * (self.center.abs().max_element() + radius);
        let normal = outward * self.radius.signum();
        // Its coordinates are a matter of the point alone, and left for when they are wanted.
        LocalSurface::plain(point, error, normal)
    }
}
