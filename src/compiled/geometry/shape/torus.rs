//! Tori around the y axis.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv, gamma, roots_in};

/// A circle of radius `minor` around a circle of radius `major` in the xz plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Torus {
    pub(crate) major: f64,
    pub(crate) minor: f64,
}

/// Into how many parts a minor radius is divided for the room around a tube.
const ROOM: f64 = 64.0;

/// How many times as thin as its circle a tube is from which on its sides are looked for one by one: nearer to each other,
/// the roots lose as many digits as the square of that.
const THIN: f64 = 64.0;

/// How many times as large as its circle a tube is from which on the torus is as good as a sphere: the dimples of its poles are
/// no larger than the square root of a rounding, and the roots of its two surfaces no further apart than about a thousand
/// times what they lose to each other.
const ROUND: f64 = (1 << 16) as f64;

impl Torus {
    fn reach(&self) -> f64 {
        self.major.abs() + self.minor.abs()
    }

    /// Coefficients of (p² + R² - r²)² - 4 R² (x² + z²) along a unit-direction ray, rising.
    ///
    /// With p² - R² - r² = δ, which is small near the tube, no larger terms are left to cancel.
    ///
    /// Source: Hanrahan, A Survey of Ray-Surface Intersection Algorithms, in Glassner, An
    /// Introduction to Ray Tracing, 1989.
    pub(super) fn quartic(&self, o: DVec3, d: DVec3) -> [f64; 5] {
        let four_r2 = 4.0 * self.major * self.major;
        let m = o.dot(d);
        let rho = DVec2::new(o.x, o.z).length();
        let delta = (rho - self.major) * (rho + self.major) + (o.y - self.minor) * (o.y + self.minor);
        [
            self.value(o),
            4.0 * m * delta + 2.0 * four_r2 * (o.y * d.y),
            4.0 * m * m + 2.0 * delta + four_r2 * (d.y * d.y),
            4.0 * m,
            1.0,
        ]
    }

    /// Calls `found` with the parts of a stretch in which a thin tube may be: those not inside of its hole.
    ///
    /// In units of such a part's length both sides of the tube are well apart, however thin it is.
    fn beside_hole(&self, o: DVec3, d: DVec3, (low, high): (f64, f64), mut found: impl FnMut(f64, f64)) {
        let hole = (self.major.abs() - self.minor.abs() * (1.0 + 1.0 / ROOM)) * (1.0 - gamma(32));
        let (a, b) = (d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z);
        let c = DVec2::new(o.x, o.z).length();
        match crate::math::quadratic_roots(a, 2.0 * b, (c - hole) * (c + hole)) {
            Some([enter, leave]) => {
                found(low, high.min(enter));
                found(low.max(leave), high);
            }
            None => found(low, high),
        }
    }

    /// Calls `found` with all crossings of a torus that is all but a sphere, whose outer and inner surfaces are looked for
    /// one by one: each lies between two spheres.
    fn shells(&self, o: DVec3, d: DVec3, mut found: impl FnMut(f64)) {
        let (major, minor) = (self.major.abs(), self.minor.abs());
        let nearest = -o.dot(d);
        let across = (o + d * nearest).length();
        let half = |radius: f64| ((radius - across) * (radius + across)).max(0.0).sqrt();
        let inner = half(minor - major);
        for (circle, outer) in [(major, half(minor + major)), (-major, half(minor))] {
            let height = |s: f64| {
                let p = o + d * s;
                DVec2::new(DVec2::new(p.x, p.z).length() - circle, p.y).length() - minor
            };
            for side in [-1.0, 1.0] {
                let (mut inside, mut outside) = (nearest + side * inner, nearest + side * outer);
                if height(inside) > 0.0 {
                    continue;
                }
                for _ in 0..f64::MANTISSA_DIGITS {
                    let middle = 0.5 * (inside + outside);
                    if height(middle) > 0.0 { outside = middle } else { inside = middle }
                }
                found(outside);
            }
        }
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

    /// The stretch of a unit-direction ray inside the cylinder |y| <= r, ρ <= R + r, with some room: a root at its very
    /// end might be lost to rounding.
    fn clip(&self, o: DVec3, d: DVec3, mut range: Range) -> Option<(f64, f64)> {
        let reach = self.reach();
        let (a, b) = (d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z);
        let room = self.minor.abs() / ROOM;
        let rim = reach * (1.0 + gamma(32)) + room;
        let c = o.x * o.x + o.z * o.z - rim * rim;
        if a > 0.0 {
            let [s0, s1] = crate::math::quadratic_roots(a, 2.0 * b, c)?;
            range = Range { min: range.min.max(s0), max: range.max.min(s1) };
        } else if c > 0.0 {
            return None;
        }
        let half = self.minor.abs() + room;
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
        if self.minor.abs() > ROUND * self.major.abs() {
            self.shells(near.origin, near.direction, |s| {
                let t = near.t(s);
                out.extend(range.contains(t).then_some(ShapeHit { t, part: 0 }));
            });
            return;
        }
        let Some((low, high)) = self.clip(near.origin, near.direction, near.range(range)) else { return };
        let mut search = |middle: f64, low: f64, high: f64| {
            let coefficients = self.quartic(near.origin + near.direction * middle, near.direction);
            let roots = roots_in(&coefficients, low - middle, high - middle);
            let hits = roots.into_iter().map(|s| ShapeHit { t: near.t(s + middle), part: 0 });
            out.extend(hits.filter(|h| range.contains(h.t)));
        };
        if self.minor.abs() * THIN >= self.major.abs() {
            search(0.0, low, high);
            return;
        }
        self.beside_hole(near.origin, near.direction, (low, high), |low, high| {
            if low < high {
                search(0.5 * (low + high), low, high);
            }
        });
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
