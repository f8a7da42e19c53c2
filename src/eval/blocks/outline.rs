//! Shapes by a row of points: prism, lathe, sor, sphere_sweep.

use super::modifiers::MODIFIERS;
use super::shape::{OPEN, POV_DEGENERATE};
use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Span};
use crate::eval::Evaluator;
use crate::math::DVec2;
use crate::scene::{Prism, Shape, SweepSpline};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// How to go from point to point.
static SPLINES: Block<SweepSpline> = Block::new(
    "spline of points",
    "how it goes from point to point",
    &[
        Item::new(K::LinearSpline, Takes::Nothing(|s| *s = SweepSpline::Linear), "", "straight"),
        Item::new(K::QuadraticSpline, Takes::Nothing(|s| *s = SweepSpline::Quadratic), "", "along parabolas"),
        Item::new(K::CubicSpline, Takes::Nothing(|s| *s = SweepSpline::Cubic), "", "smoothly through the points"),
        Item::new(K::BezierSpline, Takes::Nothing(|s| *s = SweepSpline::Bezier), "", "four points for each stretch"),
        Item::since(350, K::BSpline, Takes::Nothing(|s| *s = SweepSpline::B), "", "smoothly near the points"),
    ],
);

/// Whether a prism comes to a point.
static SWEEPS: Block<bool> = Block::new(
    "sweep of a prism",
    "what becomes of the outline on its way",
    &[
        Item::new(K::LinearSweep, Takes::Nothing(|conic| *conic = false), "", "it stays as it is"),
        Item::new(K::ConicSweep, Takes::Nothing(|conic| *conic = true), "", "it grows from a point at height 0"),
    ],
);

pub(super) static PRISM: Block<bool> =
    Block::<bool>::new("prism", "an outline in x and z, swept along y", &[OPEN]).with(&[&SPLINES, &SWEEPS, &MODIFIERS]);

pub(super) static LATHE: Block<()> =
    Block::<()>::new("lathe", "an outline in x and y, turned about y", &[]).with(&[&SPLINES, &MODIFIERS]);

pub(super) static SOR: Block<bool> =
    Block::<bool>::new("sor", "an outline in x and y that rises, turned about y", &[OPEN]).with(&[&MODIFIERS]);

pub(super) static SPHERE_SWEEP: Block<f64> = Block::<f64>::new(
    "sphere_sweep",
    "what a ball goes through on its way",
    &[Item::new(K::Tolerance, Takes::Float(|tolerance| tolerance), "0.000001", "how exactly its surface is found")],
)
.with(&[&SPLINES, &MODIFIERS]);

impl Evaluator<'_> {
    pub(super) fn prism(&mut self, span: Span) -> SourceResult<Shape> {
        let (mut spline, mut conic) = (SweepSpline::Linear, false);
        while self.item_of(&SPLINES, &mut spline)? || self.item_of(&SWEEPS, &mut conic)? {
            self.comma()?;
        }
        let h1 = self.float()?;
        self.comma()?;
        let h2 = self.float()?;
        self.comma()?;
        let points = self.counted_points()?;
        let (least, unit) = match spline {
            SweepSpline::Linear => (3, 1),
            SweepSpline::Quadratic => (5, 1),
            SweepSpline::Cubic => (6, 1),
            SweepSpline::Bezier => (4, 4),
            SweepSpline::B => return self.error(span, "a prism takes no b_spline"),
        };
        self.check_points(points.len(), least, unit, "prism", span)?;
        self.comma()?;
        let mut open = false;
        self.item_of(&PRISM, &mut open)?;
        let heights = [h1.min(h2), h1.max(h2)];
        Ok(Shape::Prism(Arc::new(Prism { spline, conic, heights, points, open, sturm: false })))
    }

    fn check_points(&mut self, n: usize, least: usize, unit: usize, what: &str, span: Span) -> SourceResult<()> {
        if n < least {
            return self.error(span, format!("this {what} needs at least {least} points, it has {n}"));
        }
        if !n.is_multiple_of(unit) {
            return self.error(span, format!("a bezier_spline {what} needs a multiple of {unit} points, it has {n}"));
        }
        Ok(())
    }

    pub(super) fn lathe(&mut self, span: Span) -> SourceResult<Shape> {
        let mut spline = SweepSpline::Linear;
        self.item_of(&SPLINES, &mut spline)?;
        self.comma()?;
        let points = self.counted_points()?;
        let (least, unit) = match spline {
            SweepSpline::Linear => (2, 1),
            SweepSpline::Quadratic => (3, 1),
            SweepSpline::Cubic => (4, 1),
            SweepSpline::Bezier => (4, 4),
            SweepSpline::B => return self.error(span, "a lathe takes no b_spline"),
        };
        self.check_points(points.len(), least, unit, "lathe", span)?;
        let last = points.len() - 1;
        if points.iter().enumerate().any(|(i, p)| p.x < 0.0 && i != 0 && i != last) {
            return self.error(span, "the points of a lathe must not have a negative radius");
        }
        Ok(Shape::Lathe { spline, points: points.into(), sturm: false })
    }

    pub(super) fn sor(&mut self, span: Span) -> SourceResult<Shape> {
        let points = self.counted_points()?;
        self.check_points(points.len(), 4, 1, "sor", span)?;
        if points.iter().any(|p| p.x < 0.0) {
            return self.error(span, "the points of a sor must not have a negative radius");
        }
        let falls = points[1..points.len() - 1].windows(2).any(|w| w[1].y <= w[0].y);
        let size = points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max).min(1.0);
        let flat = points.windows(3).any(|w| (w[2].y - w[0].y).abs() < POV_DEGENERATE * size);
        if falls || flat {
            return self.error(span, "the heights of a sor's points must rise from point to point");
        }
        self.comma()?;
        let mut open = false;
        self.item_of(&SOR, &mut open)?;
        Ok(Shape::Sor { points: points.into(), open, sturm: false })
    }

    pub(super) fn sphere_sweep(&mut self, span: Span) -> SourceResult<Shape> {
        let mut spline = SweepSpline::Linear;
        if !self.item_of(&SPLINES, &mut spline)? {
            return self.expected("'linear_spline', 'b_spline' or 'cubic_spline'");
        }
        let least = match spline {
            SweepSpline::Linear => 2,
            SweepSpline::B | SweepSpline::Cubic => 4,
            _ => return self.error(span, "a sphere_sweep takes linear_spline, b_spline or cubic_spline"),
        };
        self.comma()?;
        let n = self.integer()?.max(0) as usize;
        self.check_points(n, least, 1, "sphere_sweep", span)?;
        let mut spheres = Vec::new();
        for _ in 0..n {
            self.comma()?;
            let center = self.vector()?;
            self.comma()?;
            spheres.push((center, self.float()?));
        }
        self.comma()?;
        let mut tolerance = 1e-6; // POV-Ray's default
        self.item_of(&SPHERE_SWEEP, &mut tolerance)?;
        Ok(Shape::SphereSweep { spline, spheres: spheres.into(), tolerance })
    }

    /// `n, <a, b>, …`: the count and that many points.
    pub(super) fn counted_points(&mut self) -> SourceResult<Vec<DVec2>> {
        let n = self.integer()?.max(0) as usize;
        self.comma()?;
        self.vector2_list(n)
    }
}
