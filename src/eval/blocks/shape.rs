//! The fixed parameters of simple shapes, and what can be asked of shapes while reading.

use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::math::{DVec3, unit};
use crate::scene::{CsgOperation, Shape, SmoothTriangle};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// POV-Ray's highest order of a polynomial.
const MAX_ORDER: i64 = 35;
/// Below this an axis counts as no axis, and two points of a sor have the same height, as in POV-Ray; of what is smaller
/// than 1, in units of its size.
pub(super) const POV_DEGENERATE: f64 = 1e-10;

/// What has two ends may be without them; the word stands before any other.
pub(super) const OPEN: Item<bool> = Item::new(K::Open, Takes::Nothing(|open| *open = true), "", "without its ends");

pub(super) static CYLINDER: Block<bool> =
    Block::<bool>::new("cylinder", "what is round about an axis", &[OPEN]).with(&[&MODIFIERS]);

pub(super) static CONE: Block<bool> =
    Block::<bool>::new("cone", "a cone, or what is left without its tip", &[OPEN]).with(&[&MODIFIERS]);

/// Whether the ends of an axis count as the same point, where a shape has such radii.
fn is_degenerate(ends: [DVec3; 2], radii: [f64; 2]) -> bool {
    let [a, b] = ends;
    let size = a.abs().max(b.abs()).max_element().max(radii[0].abs()).max(radii[1].abs());
    a == b || (b - a).length() < POV_DEGENERATE * size.min(1.0)
}

impl Evaluator<'_> {
    pub(super) fn sphere(&mut self) -> SourceResult<Shape> {
        let center = self.vector()?;
        self.comma()?;
        Ok(Shape::Sphere { center, radius: self.float()? })
    }

    pub(super) fn box_between(&mut self) -> SourceResult<Shape> {
        let corner1 = self.vector()?;
        self.comma()?;
        Ok(Shape::Box { corner1, corner2: self.vector()? })
    }

    pub(super) fn torus(&mut self) -> SourceResult<Shape> {
        let major = self.float()?;
        self.comma()?;
        Ok(Shape::Torus { major, minor: self.float()?, sturm: false })
    }

    pub(super) fn superellipsoid(&mut self) -> SourceResult<Shape> {
        let e = self.vector2()?;
        Ok(Shape::Superellipsoid { east_west: e.x, north_south: e.y })
    }

    pub(super) fn triangle(&mut self, span: Span) -> SourceResult<Shape> {
        let vertices = self.three_vectors()?;
        self.warn_degenerate(vertices, span);
        Ok(Shape::Triangle { vertices })
    }

    pub(super) fn smooth_triangle(&mut self, span: Span) -> SourceResult<Shape> {
        let (mut vertices, mut normals) = ([DVec3::ZERO; 3], [DVec3::ZERO; 3]);
        for i in 0..3 {
            vertices[i] = self.vector()?;
            self.comma()?;
            normals[i] = self.vector()?.normalize_or_zero();
            if i < 2 {
                self.comma()?;
            }
        }
        self.warn_degenerate(vertices, span);
        Ok(Shape::SmoothTriangle(Box::new(SmoothTriangle { vertices, normals })))
    }

    pub(super) fn three_vectors(&mut self) -> SourceResult<[DVec3; 3]> {
        let a = self.vector()?;
        self.comma()?;
        let b = self.vector()?;
        self.comma()?;
        Ok([a, b, self.vector()?])
    }

    fn warn_degenerate(&mut self, [a, b, c]: [DVec3; 3], span: Span) {
        if (b - a).cross(c - a) == DVec3::ZERO {
            self.warn(Topic::Geometry, span, "this triangle has no area and is never seen");
        }
    }

    pub(super) fn plane(&mut self, span: Span) -> SourceResult<Shape> {
        let normal = self.vector()?;
        self.comma()?;
        let distance = self.float()?;
        match unit(normal) {
            Some(normal) => Ok(Shape::Plane { normal, distance }),
            None => self.error(span, "a plane needs a normal that is not zero"),
        }
    }

    pub(super) fn cylinder(&mut self, span: Span) -> SourceResult<Shape> {
        let base = self.vector()?;
        self.comma()?;
        let cap = self.vector()?;
        self.comma()?;
        let radius = self.float()?.abs();
        if is_degenerate([base, cap], [radius; 2]) {
            return self.error(span, "the two ends of a cylinder must not be the same point");
        }
        let mut open = false;
        self.item_of(&CYLINDER, &mut open)?;
        Ok(Shape::Cylinder { base, cap, radius, open })
    }

    pub(super) fn cone(&mut self, span: Span) -> SourceResult<Shape> {
        let base = self.vector()?;
        self.comma()?;
        let base_radius = self.float()?;
        self.comma()?;
        let cap = self.vector()?;
        self.comma()?;
        let cap_radius = self.float()?;
        if is_degenerate([base, cap], [base_radius, cap_radius]) {
            return self.error(span, "the two ends of a cone must not be the same point");
        }
        let mut open = false;
        self.item_of(&CONE, &mut open)?;
        Ok(Shape::Cone { base, base_radius, cap, cap_radius, open })
    }

    pub(super) fn disc(&mut self) -> SourceResult<Shape> {
        let center = self.vector()?;
        self.comma()?;
        let normal = self.vector()?;
        self.comma()?;
        let radius = self.float()?;
        let mut hole_radius = 0.0;
        self.comma()?;
        // Of several numbers the last is the hole, as in POV-Ray.
        while self.starts_expression()? {
            hole_radius = self.float()?;
            self.comma()?;
        }
        Ok(Shape::Disc { center, normal, radius, hole_radius })
    }

    pub(super) fn ovus(&mut self, span: Span) -> SourceResult<Shape> {
        let bottom_radius = self.float()?;
        self.comma()?;
        let top_radius = self.float()?;
        if bottom_radius < 0.0 || top_radius < 0.0 {
            return self.error(span, "the radii of an ovus must not be negative");
        }
        if top_radius >= 2.0 * bottom_radius {
            self.warn(Topic::Geometry, span, "the top of this ovus swallows its bottom: it is a sphere");
            return Ok(Shape::Sphere { center: DVec3::Y * bottom_radius, radius: top_radius });
        }
        Ok(Shape::Ovus { bottom_radius, top_radius, sturm: false })
    }

    pub(super) fn quadric(&mut self) -> SourceResult<Shape> {
        let [squares, products, linear] = self.three_vectors()?;
        self.comma()?;
        Ok(Shape::Quadric { squares, products, linear, constant: self.float()? })
    }

    pub(super) fn polynomial_order(&mut self) -> SourceResult<u32> {
        let span = self.span();
        match self.integer()? {
            n @ 2..=MAX_ORDER => Ok(n as u32),
            n => self.error(span, format!("the order of a polynomial must lie between 2 and {MAX_ORDER}, not {n}")),
        }
    }

    pub(super) fn polynomial_list(&mut self, order: u32) -> SourceResult<Shape> {
        self.expect_punct('<', "before the coefficients")?;
        let n = n_coefficients(order);
        let mut coefficients = Vec::with_capacity(n);
        for i in 0..n {
            coefficients.push(self.float()?);
            if i + 1 < n {
                self.comma()?;
            }
        }
        self.expect_punct('>', format_args!("after {n} coefficients"))?;
        Ok(Shape::Polynomial { order, coefficients: coefficients.into(), sturm: false })
    }

    pub(super) fn polynomial_terms(&mut self) -> SourceResult<Shape> {
        let order = self.polynomial_order()?;
        let mut coefficients = vec![0.0; n_coefficients(order)];
        loop {
            self.comma()?;
            let span = self.span();
            if !self.accept(K::Xyz)? {
                break;
            }
            self.expect_punct('(', "before the three powers")?;
            let mut powers = [0; 3];
            for (i, power) in powers.iter_mut().enumerate() {
                *power = self.integer()?.max(0);
                if i < 2 {
                    self.comma()?;
                }
            }
            self.expect_punct(')', "to close it")?;
            self.expect_punct(':', "before the coefficient")?;
            let value = self.float()?;
            if powers.iter().sum::<i64>() > i64::from(order) {
                return self.error(span, format!("the powers add up to more than the order {order}"));
            }
            coefficients[coefficient_index(order, powers)] = value;
        }
        Ok(Shape::Polynomial { order, coefficients: coefficients.into(), sturm: false })
    }

    pub(super) fn polygon(&mut self, span: Span) -> SourceResult<Shape> {
        let n = self.integer()?;
        if n < 3 {
            return self.error(span, "a polygon needs at least three points");
        }
        self.comma()?;
        let points = self.vector_list(n as usize)?;
        Ok(Shape::Polygon { points: points.into() })
    }
}

/// (n+1)(n+2)(n+3)/6
fn n_coefficients(order: u32) -> usize {
    let n = order as usize;
    (n + 1) * (n + 2) * (n + 3) / 6
}

/// Where the coefficient of x^i y^j z^k stands: i, then j, then k falling.
fn coefficient_index(order: u32, [i, j, k]: [i64; 3]) -> usize {
    let n = i64::from(order);
    let below = |m: i64| m * (m + 1) * (m + 2) / 6;
    let row = |m: i64| m * (m + 1) / 2;
    (below(n - i) + row(n - i - j) + (n - i - j - k)) as usize
}

impl Shape {
    /// Whether `sturm` is legal.
    pub(super) fn takes_sturm(&self) -> bool {
        matches!(
            self,
            Self::Torus { .. }
                | Self::Ovus { .. }
                | Self::Polynomial { .. }
                | Self::Lathe { .. }
                | Self::Prism(_)
                | Self::Sor { .. }
                | Self::Blob(_)
        )
    }

    /// Chooses the Sturm solver.
    pub(super) fn set_sturm(&mut self, on: bool) {
        match self {
            Self::Torus { sturm, .. }
            | Self::Ovus { sturm, .. }
            | Self::Polynomial { sturm, .. }
            | Self::Lathe { sturm, .. }
            | Self::Sor { sturm, .. } => *sturm = on,
            Self::Prism(prism) => Arc::make_mut(prism).sturm = on,
            Self::Blob(blob) => Arc::make_mut(blob).sturm = on,
            _ => {}
        }
    }

    /// Takes the container's caps away.
    pub(super) fn set_open(&mut self) {
        if let Self::Isosurface(surface) = self {
            Arc::make_mut(surface).open = true;
        }
    }

    /// Whether the children are combined by cutting.
    pub fn is_cut(&self) -> bool {
        matches!(self, Self::Csg { operation: CsgOperation::Intersection | CsgOperation::Difference, .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_stand_in_pov_ray_order() {
        // poly 2: x^2 xy xz x y^2 yz y z^2 z 1
        let order2 = [
            [2, 0, 0],
            [1, 1, 0],
            [1, 0, 1],
            [1, 0, 0],
            [0, 2, 0],
            [0, 1, 1],
            [0, 1, 0],
            [0, 0, 2],
            [0, 0, 1],
            [0, 0, 0],
        ];
        for (i, powers) in order2.into_iter().enumerate() {
            assert_eq!(coefficient_index(2, powers), i);
        }
        assert_eq!(coefficient_index(4, [0, 0, 0]), n_coefficients(4) - 1);
    }
}
