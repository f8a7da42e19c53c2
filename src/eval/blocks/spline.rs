//! `spline { … }`: values at places, and how to go from one to the next.

use crate::diag::SourceResult;
use crate::eval::{Evaluator, Value};
use crate::function::{Spline, SplineKind};
use std::sync::Arc;

impl Evaluator<'_> {
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
        self.close("spline")?;
        Ok(Arc::new(spline))
    }
}
