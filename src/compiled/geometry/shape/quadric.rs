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
    /// How far from here a ray's origin may be to stay where it is: some lengths typical of the surface.
    reach: f64,
}

impl Quadric {
    /// From its coefficients, in the order of the fields.
    pub(crate) fn new(squares: DVec3, products: DVec3, linear: DVec3, constant: f64, keeps_normal: bool) -> Self {
        // The surface is the same whatever all are multiplied by; a power of two keeps their digits, and squares of them in
        // range.
        let largest = squares.abs().max(products.abs()).max(linear.abs()).max_element().max(constant.abs());
        let factor = 2f64.powi(if (largest * largest).is_normal() { 0 } else { -(largest.log2() as i32) });
        let (squares, products, linear, constant) =
            (squares * factor, products * factor, linear * factor, constant * factor);
        let curvature = squares.abs().max_element().max(products.abs().max_element());
        let size = (constant.abs() / curvature).sqrt() + linear.abs().max_element() / curvature;
        let reach = if size.is_finite() { 4.0 * size } else { f64::INFINITY };
        Self { squares, products, linear, constant, keeps_normal, reach }
    }

    /// The terms of second degree.
    #[inline(always)]
    fn form(&self, v: DVec3) -> f64 {
        let q = self.products;
        (self.squares * v).dot(v) + q.x * (v.x * v.y) + q.y * (v.x * v.z) + q.z * (v.y * v.z)
    }

    #[inline(always)]
    fn value(&self, p: DVec3) -> f64 {
        self.form(p) + self.linear.dot(p) + self.constant
    }

    #[inline(always)]
    fn gradient(&self, p: DVec3) -> DVec3 {
        let (s, q) = (2.0 * (self.squares * p), self.products);
        let curved = DVec3::new(
            s.x + q.x * p.y + q.y * p.z, //
            s.y + q.x * p.x + q.z * p.z,
            s.z + q.y * p.x + q.z * p.y,
        );
        curved + self.linear
    }

    /// The sum of the magnitudes of all terms, for coordinates that are not negative: what rounding errors are
    /// proportional to.
    fn magnitudes(&self) -> Self {
        Self {
            squares: self.squares.abs(),
            products: self.products.abs(),
            linear: self.linear.abs(),
            constant: self.constant.abs(),
            ..*self
        }
    }

    /// Coefficients of the value along a ray, falling.
    #[inline(always)]
    fn along(&self, o: DVec3, d: DVec3) -> [f64; 3] {
        [self.form(d), self.gradient(o).dot(d), self.value(o)]
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
        let near = NearRay::new(ray, DVec3::ZERO, self.reach);
        let [a, b, c] = self.along(near.origin, near.direction);
        let Some([first, second]) = quadratic_roots(a, b, c) else { return };
        let mut hit = |s: f64| {
            let t = near.t(s);
            if range.contains(t) {
                out.push(ShapeHit { t, part: 0 });
            }
        };
        hit(first);
        // A lone root of the linear case is one crossing.
        if a != 0.0 {
            hit(second);
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

    /// Without mixed products, squares that are not negative are a sum that is not, however it rounds.
    fn is_convex(&self) -> bool {
        self.products == DVec3::ZERO && self.squares.min_element() >= 0.0
    }

    fn is_chordal(&self) -> bool {
        self.is_convex()
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let (point, error, gradient) =
            super::onto_surface(ray.at(t), |p| (self.value(p), self.gradient(p), self.magnitudes().value(p.abs())));
        let normal = if gradient == DVec3::ZERO { DVec3::X } else { gradient };
        LocalSurface::plain(point, error, if self.keeps_normal { -normal } else { normal })
    }
}
