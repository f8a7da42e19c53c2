//! Transformations: `translate rotate scale matrix transform`.

use super::expressions::EPSILON;
use super::{Evaluator, Value};
use crate::diag::{SourceResult, Span, Topic};
use crate::math::{DVec3, Transform};
use crate::syntax::Keyword;
use std::rc::Rc;

#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// Takes one transformation; `None` if the next token starts none.
    pub fn transformation(&mut self) -> SourceResult<Option<Transform>> {
        let Some(word) = self.keyword()? else { return Ok(None) };
        let span = self.span();
        match word {
            Keyword::Translate => {
                self.take();
                self.vector().map(|v| Some(Transform::translation(v)))
            }
            Keyword::Rotate => {
                self.take();
                self.vector().map(|v| Some(Transform::rotation_deg(v)))
            }
            Keyword::Scale => {
                self.take();
                self.scale(span).map(Some)
            }
            Keyword::Matrix => {
                self.take();
                self.matrix(span).map(Some)
            }
            Keyword::Transform => {
                self.take();
                self.transform_block().map(Some)
            }
            _ => Ok(None),
        }
    }

    /// `scale V`: a zero becomes 1, as in POV-Ray, with a warning.
    fn scale(&mut self, span: Span) -> SourceResult<Transform> {
        let mut factors = self.vector()?;
        for axis in 0..3 {
            if factors[axis] == 0.0 {
                factors[axis] = 1.0;
                self.warn_here(Topic::Geometry, span, "a scale factor of zero is taken as 1");
            }
        }
        let made = Transform::scaling(factors);
        if factors.is_finite() && factors.recip().is_finite() {
            return Ok(made);
        }
        self.error(span, "a scale factor is too large or too small")
    }

    /// `matrix < 12 floats >`.
    fn matrix(&mut self, span: Span) -> SourceResult<Transform> {
        let m =
            self.bracketed('<', "before the numbers of the matrix", '>', "behind the 12 numbers of the matrix", |e| {
                let mut m = [0.0; 12];
                for (i, number) in m.iter_mut().enumerate() {
                    if i > 0 {
                        e.comma()?;
                    }
                    *number = e.float()?;
                }
                e.comma()?;
                Ok(m)
            })?;
        self.transform_from_rows(m, span)
    }

    /// Rows are the images of the axes and of the origin.
    fn transform_from_rows(&mut self, mut m: [f64; 12], span: Span) -> SourceResult<Transform> {
        for axis in 0..3 {
            if (0..3).all(|row| m[3 * row + axis].abs() < EPSILON) {
                m[4 * axis] = 1.0;
                self.warn_here(Topic::Geometry, span, "a column of this matrix is zero; it gets a 1 on the diagonal");
            }
        }
        let row = |i: usize| DVec3::new(m[3 * i], m[3 * i + 1], m[3 * i + 2]);
        match Transform::from_columns(row(0), row(1), row(2), row(3)) {
            Ok(transform) => Ok(transform),
            Err(_) => self.error(span, "this matrix is singular: it flattens space and cannot be inverted"),
        }
    }

    /// What follows the word `transform`: an identifier, or items in braces.
    pub fn transform_block(&mut self) -> SourceResult<Transform> {
        if let Some(declared) = self.declared_transform()? {
            return Ok(declared);
        }
        self.open("the transform")?;
        let (mut all, mut inverse) = (Transform::IDENTITY, false);
        loop {
            if let Some(next) = self.transformation()? {
                all = all.then(&next);
            } else if let Some(next) = self.declared_transform()? {
                all = all.then(&next);
            } else if self.accept(Keyword::Inverse)? {
                inverse = true;
            } else {
                break;
            }
        }
        self.close("the transform")?;
        Ok(if inverse { all.inverse() } else { all })
    }

    fn declared_transform(&mut self) -> SourceResult<Option<Transform>> {
        self.take_declared(|value| match value {
            Value::Transform(transform) => Some(*Rc::clone(transform)),
            _ => None,
        })
    }
}
