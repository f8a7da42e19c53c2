//! Quadrics: any surface of second degree.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, gamma, quadratic_roots};

/// A x² + E y² + H z² + B xy + C xz + F yz + D x + G y + I z + J = 0; inside where not positive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadric {
    /// A, E, H.
    pub(crate) squares: DVec3,
    /// B, C, F.
    pub(crate) products: DVec3,
    /// D, G, I.
    pub(crate) linear: DVec3,
    /// J.
    pub(crate) constant: f64,
    /// POV-Ray leaves the normal of an inverted quadric as it was; this takes the inversion back.
    pub(crate) keeps_normal: bool,
}

impl Quadric {
    /// The symmetric quadratic form of two vectors, twice.
    fn form(&self, a: DVec3, b: DVec3) -> f64 {
        let q = self.products;
        2.0 * (self.squares * a).dot(b)
            + q.x * (a.x * b.y + a.y * b.x)
            + q.y * (a.x * b.z + a.z * b.x)
            + q.z * (a.y * b.z + a.z * b.y)
    }

    fn value(&self, p: DVec3) -> f64 {
        0.5 * self.form(p, p) + self.linear.dot(p) + self.constant
    }

    fn gradient(&self, p: DVec3) -> DVec3 {
        DVec3::new(self.form(p, DVec3::X), self.form(p, DVec3::Y), self.form(p, DVec3::Z)) + self.linear
    }

    /// The sum of the magnitudes of all terms, for coordinates that are not negative: what rounding errors are
    /// proportional to.
    fn magnitudes(&self) -> Self {
        Self {
            squares: self.squares.abs(),
            products: self.products.abs(),
            linear: self.linear.abs(),
            constant: self.constant.abs(),
            keeps_normal: false,
        }
    }

    /// Coefficients of the value along a ray, falling.
    fn along(&self, o: DVec3, d: DVec3) -> [f64; 3] {
        [0.5 * self.form(d, d), self.gradient(o).dot(d), self.value(o)]
    }

    /// A length typical of the surface, at which moving the ray's origin loses nothing.
    fn size(&self) -> f64 {
        let curvature = self.squares.abs().max_element().max(self.products.abs().max_element());
        (self.constant.abs() / curvature).sqrt() + self.linear.abs().max_element() / curvature
    }
}

impl Primitive for Quadric {
    /// Exact for ellipsoids along the axes, infinite for the rest.
    fn bounds(&self) -> Bounds {
        let positive = self.squares.min_element() > 0.0 || self.squares.max_element() < 0.0;
        if !positive || self.products != DVec3::ZERO {
            return Bounds::INFINITE;
        }
        let center = -0.5 * self.linear / self.squares;
        let level = -self.value(center);
        let half = (DVec3::splat(level) / self.squares).max(DVec3::ZERO);
        let half = DVec3::new(half.x.sqrt(), half.y.sqrt(), half.z.sqrt()) * (1.0 + gamma(16));
        Bounds { min: center - half, max: center + half }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let size = self.size();
        let near = NearRay::new(ray, DVec3::ZERO, if size.is_finite() { 4.0 * size } else { f64::INFINITY });
        let [a, b, c] = self.along(near.origin, near.direction);
        if let Some(roots) = quadratic_roots(a, b, c) {
            // A lone root of the linear case is one crossing.
            let count = if a == 0.0 { 1 } else { 2 };
            let hits = roots.into_iter().take(count).map(|s| ShapeHit { t: near.t(s), part: 0 });
            out.extend(hits.filter(|h| range.contains(h.t)));
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        self.value(p) <= 0.0
    }

    fn span(&self, ray: &Ray, range: Range) -> Range {
        /// Of a dozen roundings each for the point, the value there, and the coefficients here.
        const SLACK: f64 = gamma(128);
        let [a, b, c] = self.along(ray.origin, ray.direction);
        let [rounded_a, rounded_b, rounded_c] = self.magnitudes().along(ray.origin.abs(), ray.direction.abs());
        let a = a - SLACK * rounded_a;
        let opens_upward = a > SLACK * rounded_a;
        if !opens_upward || range.min < 0.0 {
            return range;
        }
        // For t from 0 on, the least that the value can be.
        match quadratic_roots(a, b - SLACK * rounded_b, c - SLACK * rounded_c) {
            Some([low, high]) if low < high => {
                let (low, high) = (low - SLACK * low.abs(), high + SLACK * high.abs());
                Range { min: range.min.max(low), max: range.max.min(high) }
            }
            Some(_) => range,
            None => Range::EMPTY,
        }
    }

    fn has_span(&self) -> bool {
        true
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let (point, error, gradient) =
            super::onto_surface(ray.at(t), |p| (self.value(p), self.gradient(p), self.magnitudes().value(p.abs())));
        let normal = if gradient == DVec3::ZERO { DVec3::X } else { gradient };
        LocalSurface::plain(point, error, if self.keeps_normal { -normal } else { normal })
    }
}
