//! Cylinders and cones, around the z axis.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, gamma, quadratic_roots};

/// The part `low <= z <= 1` of x² + y² = z² (cones), or of x² + y² = 1 from z = 0 (cylinders).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cone {
    /// Radius and height of the small end; `None` for a cylinder.
    pub(crate) taper: Option<f64>,
    /// Without caps.
    pub(crate) open: bool,
}

/// Parts in the order of recording: of equal hits the last wins.
const SIDE: u32 = 0;
const CAP: u32 = 1;
const BASE: u32 = 2;

/// POV-Ray's thickness of the boundary in the inside test, in units of the big radius.
const INSIDE_SLACK: f64 = 1e-10;

impl Cone {
    /// Lower end of z.
    fn low(&self) -> f64 {
        self.taper.unwrap_or(0.0)
    }

    /// Whether a line passes the axis at more than the largest radius; errs on the side of no.
    fn is_passed_by(&self, ray: &Ray) -> bool {
        let (o, d) = (ray.origin, ray.direction);
        let radius = self.low().abs().max(1.0);
        let (a, b) = (o.x * d.y, o.y * d.x);
        let moment = (a - b).abs() - gamma(16) * (a.abs() + b.abs());
        moment > 0.0 && moment * moment > radius * radius * d.truncate().length_squared() * (1.0 + gamma(32))
    }

    /// Squared radius at height `z`.
    fn radius_squared(&self, z: f64) -> f64 {
        if self.taper.is_some() { z * z } else { 1.0 }
    }
}

impl Primitive for Cone {
    fn bounds(&self) -> Bounds {
        let r = self.low().abs().max(1.0);
        Bounds { min: DVec3::new(-r, -r, self.low()), max: DVec3::new(r, r, 1.0) }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        if self.is_passed_by(ray) {
            return;
        }
        let near = NearRay::new(ray, DVec3::new(0.0, 0.0, 0.5), 4.0);
        let (o, d) = (near.origin, near.direction);
        let (slope, height) = if self.taper.is_some() { (d.z, o.z) } else { (0.0, 0.0) };
        // d.x² + d.y² - slope² and the like, in factors that do not cancel for rays along a side.
        let across = d.truncate().length();
        let a = (across - slope.abs()) * (across + slope.abs());
        let b = 2.0 * (o.truncate().dot(d.truncate()) - slope * height);
        let aside = o.truncate().length();
        let rim = if self.taper.is_some() { height.abs() } else { 1.0 };
        let c = (aside - rim) * (aside + rim);
        let mut record = |s: f64, part: u32| {
            let t = near.t(s);
            if range.contains(t) {
                out.push(ShapeHit { t, part });
            }
        };
        // A ray along the axis meets the side of a cone, but never that of a cylinder.
        if across > 0.0 || self.taper.is_some() {
            let mut roots = quadratic_roots(a, b, c);
            if let Some([first, second]) = roots
                && first == second
                && a == 0.0
            {
                roots = Some([first, f64::INFINITY]);
            }
            let mut on_side = 0;
            for s in roots.into_iter().flatten() {
                let z = o.z + s * d.z;
                if self.low() <= z && z <= 1.0 {
                    record(s, SIDE);
                    on_side += 1;
                }
            }
            // A line that passes by the side, or goes through it twice, meets no cap.
            if self.is_convex() && (roots.is_none() || on_side == 2) {
                return;
            }
        }
        if !self.open && d.z != 0.0 {
            for (z, part) in [(self.low(), CAP), (1.0, BASE)] {
                let s = (z - o.z) / d.z;
                if (o + d * s).truncate().length_squared() <= self.radius_squared(z) {
                    record(s, part);
                }
            }
        }
    }

    fn is_convex(&self) -> bool {
        !self.open && self.low() >= 0.0
    }

    fn is_chordal(&self) -> bool {
        self.is_convex()
    }

    fn contains(&self, p: DVec3) -> bool {
        let slack = if self.open { INSIDE_SLACK } else { -INSIDE_SLACK };
        p.truncate().length_squared() <= self.radius_squared(p.z) * (1.0 + slack)
            && p.z >= self.low() - slack
            && p.z <= 1.0 + slack
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let p = ray.at(t);
        match part {
            CAP => LocalSurface::plain(p.with_z(self.low()), gamma(4), DVec3::NEG_Z),
            BASE => LocalSurface::plain(p.with_z(1.0), gamma(4), DVec3::Z),
            _ => {
                let rim = self.radius_squared(p.z).sqrt();
                let outward = p.truncate().normalize_or(glam::DVec2::X);
                let point = (outward * rim).extend(p.z);
                let normal = outward.extend(if self.taper.is_some() { -p.z.signum() } else { 0.0 });
                LocalSurface::plain(point, gamma(12) * (1.0 + self.low().abs()), normal)
            }
        }
    }
}
