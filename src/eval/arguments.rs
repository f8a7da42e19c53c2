//! Arguments of functions.

use super::{Evaluator, Number};
use crate::diag::SourceResult;
use crate::function::Spline;
use crate::math::DVec3;
use smallvec::SmallVec;

impl Evaluator<'_> {
    /// `( … )` around what `read` reads.
    pub(super) fn arguments<T>(&mut self, read: impl FnOnce(&mut Self) -> SourceResult<T>) -> SourceResult<T> {
        self.bracketed('(', "before the arguments", ')', "behind the arguments", read)
    }

    /// The one float argument of a function, a full expression.
    pub(super) fn one_float(&mut self) -> SourceResult<f64> {
        self.arguments(Self::full_float)
    }

    /// Exactly `N` floats; commas may be missing.
    pub(super) fn floats<const N: usize>(&mut self) -> SourceResult<[f64; N]> {
        self.arguments(|e| {
            let mut values = [0.0; N];
            for (i, value) in values.iter_mut().enumerate() {
                if i > 0 {
                    e.comma()?;
                }
                *value = e.float()?;
            }
            Ok(values)
        })
    }

    /// Exactly `N` vectors; commas may be missing.
    pub(super) fn vectors<const N: usize>(&mut self) -> SourceResult<[DVec3; N]> {
        self.arguments(|e| {
            let mut values = [DVec3::ZERO; N];
            for (i, value) in values.iter_mut().enumerate() {
                if i > 0 {
                    e.comma()?;
                }
                *value = e.vector()?;
            }
            Ok(values)
        })
    }

    /// One or more floats; commas are needed.
    pub(super) fn listed_floats(&mut self) -> SourceResult<SmallVec<[f64; 8]>> {
        self.arguments(|e| {
            let mut values = SmallVec::new();
            values.push(e.float()?);
            while e.accept_punct(',')? {
                values.push(e.float()?);
            }
            Ok(values)
        })
    }

    /// Floats for a user function; commas may be missing.
    pub(super) fn float_arguments(&mut self) -> SourceResult<SmallVec<[f64; 8]>> {
        self.arguments(|e| {
            let mut values = SmallVec::new();
            while !e.at_punct(')')? {
                values.push(e.float()?);
                e.comma()?;
            }
            Ok(values)
        })
    }

    /// `(t)` or `(t, type)` behind a spline.
    pub(super) fn spline_call(&mut self, spline: &Spline) -> SourceResult<Number> {
        let v = self.arguments(|e| {
            let t = e.float()?;
            if !e.accept_punct(',')? {
                return Ok(spline.at(t));
            }
            match e.spline_kind()? {
                Some(kind) => Ok(spline.at_as(t, kind)),
                None => e.expected("a spline type"),
            }
        })?;
        Ok(Number { n: spline.width().clamp(1, 5) as u8, v })
    }
}
