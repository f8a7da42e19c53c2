//! `spline { … }`: values at places, and how to go from one to the next.

use super::table::{Block, Item, Takes};
use crate::diag::SourceResult;
use crate::eval::{Evaluator, Value};
use crate::function::{Spline, SplineKind};
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(super) static SPLINE: Block<SplineKind> = Block::new(
    "spline",
    "values at places, and how to go from one to the next: [NAME] [KIND] PLACE, VALUE, …",
    &[
        Item::new(K::LinearSpline, Takes::Nothing(|kind| *kind = SplineKind::Linear), "", "straight, as without any"),
        Item::new(K::QuadraticSpline, Takes::Nothing(|kind| *kind = SplineKind::Quadratic), "", "along parabolas"),
        Item::new(K::CubicSpline, Takes::Nothing(|kind| *kind = SplineKind::Cubic), "", "smoothly, by cubic curves"),
        Item::new(
            K::NaturalSpline,
            Takes::Nothing(|kind| *kind = SplineKind::Natural),
            "",
            "smoothly, and straight at both ends",
        ),
    ],
);

impl Evaluator<'_> {
    /// How to go from one value to the next, if that is said.
    pub(in crate::eval) fn spline_kind(&mut self) -> SourceResult<Option<SplineKind>> {
        let mut kind = SplineKind::Linear;
        Ok(self.item_of(&SPLINE, &mut kind)?.then_some(kind))
    }

    /// `{ [spline] [type] t, value, … }` after `spline`.
    pub(super) fn spline_block(&mut self) -> SourceResult<Arc<Spline>> {
        self.open("spline")?;
        let pick = |v: &Value| if let Value::Spline(s) = v { Some((**s).clone()) } else { None };
        let mut spline = self.take_declared(pick)?.unwrap_or_else(|| Spline::new(SplineKind::Linear));
        self.comma()?;
        if let Some(kind) = self.spline_kind()? {
            spline.set_kind(kind);
        }
        self.comma()?;
        while self.starts_expression()? {
            let t = self.float()?;
            self.comma()?;
            let value = self.any_expression()?.widened(2);
            spline.insert(t, value.v, value.n.into());
            self.comma()?;
        }
        if spline.is_empty() {
            return self.expected("a number and the spline's value there");
        }
        self.close_of(&SPLINE)?;
        Ok(Arc::new(spline))
    }
}
