//! Eggs: two spheres joined by the surface of a turned arc.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits, Sphere, Torus};
use crate::math::{Bounds, DVec3, Range, Ray, Uv, gamma, roots_in};

/// A sphere of radius `bottom` around the origin, one of radius `top` around (0, bottom, 0), and
/// between two heights the arc (ρ + H)² + (y - V)² = C².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ovus {
    bottom: f64,
    top: f64,
    arc_radius: f64,
    /// V: height of the arc's centre.
    arc_height: f64,
    /// H: distance of the arc's centre beyond the axis.
    arc_offset: f64,
    /// Heights between which the arc runs.
    low: f64,
    high: f64,
}

const BOTTOM: u32 = 0;
const TOP: u32 = 1;
const ARC: u32 = 2;

impl Ovus {
    /// For `0 < bottom`, `0 <= top < 2 bottom`. Source: shape facts, section 4.2.
    pub(crate) fn new(b: f64, t: f64) -> Self {
        let (c, v, h, low, high);
        if b > t {
            c = 2.0 * b;
            v = 2.0 * t - b - t * t / (2.0 * b);
            h = (b * b - v * v).max(0.0).sqrt();
            (low, high) = (-v, b + (b - v) * t / (2.0 * b - t));
        } else {
            c = 2.0 * t;
            v = b - 2.0 * t + 3.0 * t * t / (2.0 * b);
            h = (t * t - (v - b).powi(2)).max(0.0).sqrt();
            (low, high) = (-v * b / (2.0 * t - b), 2.0 * b - v);
        }
        Self { bottom: b, top: t, arc_radius: c, arc_height: v, arc_offset: h, low, high }
    }

    fn sphere(&self, part: u32) -> Sphere {
        match part {
            TOP => Sphere { center: DVec3::Y * self.bottom, radius: self.top },
            _ => Sphere { center: DVec3::ZERO, radius: self.bottom },
        }
    }

    /// Centre of the arc on the other side of the axis from `p`.
    fn arc_center(&self, p: DVec3) -> DVec3 {
        let outward = DVec3::new(p.x, 0.0, p.z).normalize_or(DVec3::X);
        outward * -self.arc_offset + DVec3::Y * self.arc_height
    }
}

impl Primitive for Ovus {
    fn bounds(&self) -> Bounds {
        let side = (self.arc_radius - self.arc_offset).max(self.bottom).max(self.top);
        Bounds { min: DVec3::new(-side, -self.bottom, -side), max: DVec3::new(side, self.bottom + self.top, side) }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        for part in [BOTTOM, TOP] {
            let Some((near, far)) = self.sphere(part).roots(ray) else { continue };
            for t in [near, far] {
                let y = ray.at(t).y;
                let here = if part == BOTTOM { y <= self.low } else { y >= self.high };
                if here && range.contains(t) {
                    out.push(ShapeHit { t, part });
                }
            }
        }
        let size = self.bottom + self.top;
        let near = NearRay::new(ray, DVec3::Y * self.arc_height, 4.0 * size);
        let middle = near.origin - DVec3::Y * self.arc_height;
        let reach = near.range(range);
        let b = middle.dot(near.direction);
        let c = middle.length_squared() - 4.0 * size * size;
        let Some([enter, leave]) = crate::math::quadratic_roots(1.0, 2.0 * b, c) else { return };
        let torus = Torus { major: self.arc_offset, minor: self.arc_radius };
        let quartic = torus.quartic(middle, near.direction);
        for s in roots_in(&quartic, reach.min.max(enter), reach.max.min(leave)) {
            let p = middle + near.direction * s;
            let (y, rho) = (p.y + self.arc_height, p.x.hypot(p.z));
            // The quartic also holds the outer surface, from the circle on the near side.
            let miss = |offset: f64| ((rho + offset).hypot(p.y) - self.arc_radius).abs();
            let t = near.t(s);
            if self.low < y && y < self.high && miss(self.arc_offset) < miss(-self.arc_offset) && range.contains(t) {
                out.push(ShapeHit { t, part: ARC });
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        let in_arc = self.low < p.y && p.y < self.high && p.distance(self.arc_center(p)) < self.arc_radius;
        in_arc || self.sphere(BOTTOM).contains(p) || self.sphere(TOP).contains(p)
    }

    fn excludes(&self, p: DVec3) -> bool {
        let in_arc = self.low < p.y && p.y < self.high && p.distance(self.arc_center(p)) <= self.arc_radius;
        !in_arc && self.sphere(BOTTOM).excludes(p) && self.sphere(TOP).excludes(p)
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let p = ray.at(t);
        let (center, radius) = match part {
            ARC => (self.arc_center(p), self.arc_radius),
            _ => (self.sphere(part).center, self.sphere(part).radius),
        };
        let normal = (p - center).normalize_or(DVec3::Y);
        let point = center + normal * radius;
        let uv = Uv::Around(point - DVec3::Y * (0.5 * self.top));
        let error = gamma(64) * (self.bottom + self.top);
        LocalSurface { uv: Some(uv), ..LocalSurface::plain(point, error, normal) }
    }
}
