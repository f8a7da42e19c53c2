//! Tori around the y axis.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv, gamma, roots_in};

/// A circle of radius `minor` around a circle of radius `major` in the xz plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Torus {
    pub(crate) major: f64,
    pub(crate) minor: f64,
}

impl Torus {
    fn reach(&self) -> f64 {
        self.major.abs() + self.minor.abs()
    }

    /// Coefficients of (p² + R² - r²)² - 4 R² (x² + z²) along a unit-direction ray, rising.
    ///
    /// Source: Hanrahan, A Survey of Ray-Surface Intersection Algorithms, in Glassner, An
    /// Introduction to Ray Tracing, 1989.
    pub(super) fn quartic(&self, o: DVec3, d: DVec3) -> [f64; 5] {
        let four_r2 = 4.0 * self.major * self.major;
        let m = o.dot(d);
        // p² + R² - r² as k + 2 m s + s².
        let k = o.length_squared() + (self.major - self.minor) * (self.major + self.minor);
        let ring = |a: DVec3, b: DVec3| a.x * b.x + a.z * b.z;
        [
            self.value(o),
            4.0 * m * k - 2.0 * four_r2 * ring(o, d),
            4.0 * m * m + 2.0 * k - four_r2 * ring(d, d),
            4.0 * m,
            1.0,
        ]
    }

    /// The value at `o`: (ρ-R)²+y²-r² times (ρ+R)²+y²-r², which does not cancel near the surface.
    fn value(&self, o: DVec3) -> f64 {
        let rho = DVec2::new(o.x, o.z).length();
        let factor = |major: f64| {
            let tube = DVec2::new(rho - major, o.y).length();
            (tube - self.minor) * (tube + self.minor)
        };
        factor(self.major) * factor(-self.major)
    }

    /// The stretch of a unit-direction ray inside the cylinder |y| <= r, ρ <= R + r.
    fn clip(&self, o: DVec3, d: DVec3, mut range: Range) -> Option<(f64, f64)> {
        let reach = self.reach();
        let (a, b) = (d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z);
        let rim = reach * (1.0 + gamma(32));
        let c = o.x * o.x + o.z * o.z - rim * rim;
        if a > 0.0 {
            let [s0, s1] = crate::math::quadratic_roots(a, 2.0 * b, c)?;
            range = Range { min: range.min.max(s0), max: range.max.min(s1) };
        } else if c > 0.0 {
            return None;
        }
        let half = self.minor.abs() * (1.0 + gamma(32));
        let Range { min: low, max: high } = range.between([-half, half], o.y, d.y);
        (low < high).then_some((low, high))
    }
}

impl Primitive for Torus {
    fn bounds(&self) -> Bounds {
        let half = DVec3::new(self.reach(), self.minor.abs(), self.reach());
        Bounds { min: -half, max: half }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let near = NearRay::new(ray, DVec3::ZERO, 2.0 * self.reach());
        let Some((low, high)) = self.clip(near.origin, near.direction, near.range(range)) else { return };
        let coefficients = self.quartic(near.origin, near.direction);
        let hits = roots_in(&coefficients, low, high).into_iter().map(|s| ShapeHit { t: near.t(s), part: 0 });
        out.extend(hits.filter(|h| range.contains(h.t)));
    }

    fn contains(&self, p: DVec3) -> bool {
        (DVec2::new(p.x, p.z).length() - self.major).powi(2) + p.y * p.y <= self.minor * self.minor
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let p = ray.at(t);
        let rho = DVec2::new(p.x, p.z).length();
        let spoke = if rho > 0.0 { DVec3::new(p.x / rho, 0.0, p.z / rho) } else { DVec3::ZERO };
        // The inner surface of a spindle torus belongs to the circle on the other side.
        let center = [self.major, -self.major]
            .map(|major| spoke * major)
            .into_iter()
            .min_by(|a, b| {
                let miss = |c: &DVec3| (p.distance(*c) - self.minor).abs();
                miss(a).total_cmp(&miss(b))
            })
            .unwrap_or(DVec3::ZERO);
        let normal = (p - center).try_normalize().unwrap_or(DVec3::Y);
        let uv = Uv::Ring(DVec2::new(p.x, p.z), DVec2::new(rho - self.major, p.y));
        let point = center + normal * self.minor;
        LocalSurface { uv: Some(uv), ..LocalSurface::plain(point, gamma(32) * self.reach(), normal) }
    }
}
