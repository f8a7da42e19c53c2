//! Built-in constants and functions that give a vector.

use super::{Evaluator, Number};
use crate::diag::{SourceResult, Span, Topic};
use crate::math::noise::{Octaves, vector_turbulence};
use crate::math::{DVec3, Transform};
use crate::syntax::Keyword;
use crate::syntax::built_in::Takes;

impl Evaluator<'_> {
    /// The value of a vector constant or of a function that gives a vector.
    pub(super) fn vector_function(&mut self, keyword: Keyword, takes: Takes) -> SourceResult<Number> {
        let span = self.span();
        self.take();
        if let Takes::Axis([x, y, z, t], n) = takes {
            return Ok(Number { n, v: [x, y, z, t, 0.0] });
        }
        let vector = match keyword {
            Keyword::Vcross => {
                let [a, b] = self.vectors()?;
                a.cross(b)
            }
            Keyword::Vnormalize => {
                let [a] = self.vectors()?;
                self.normalized(a, span)
            }
            Keyword::Vrotate => {
                let [v, degrees] = self.vectors()?;
                Transform::rotation_deg(degrees).vector(v)
            }
            Keyword::VaxisRotate => self.arguments(Self::axis_rotation)?,
            Keyword::Vturbulence => self.turbulence()?,
            Keyword::Trace => self.trace()?,
            Keyword::MinExtent | Keyword::MaxExtent => self.extent(keyword == Keyword::MaxExtent)?,
            _ => return self.error(span, format!("'{}' gives no vector here", keyword.word())),
        };
        Ok(Number::vector(vector))
    }

    /// `vaxis_rotate(v, axis, degrees)`.
    fn axis_rotation(&mut self) -> SourceResult<DVec3> {
        let v = self.vector()?;
        self.comma()?;
        let axis = self.vector()?;
        self.comma()?;
        Ok(rotated_about(v, axis, self.float()?))
    }

    /// At length 1; zero stays zero, with a warning.
    pub(super) fn normalized(&mut self, v: DVec3, span: Span) -> DVec3 {
        if v == DVec3::ZERO {
            self.warn_here(Topic::Arithmetic, span, "a vector of length zero cannot be normalised; it stays zero");
            return v;
        }
        v / v.length()
    }

    /// `vturbulence(lambda, omega, octaves, point)`.
    fn turbulence(&mut self) -> SourceResult<DVec3> {
        let (octaves, point) = self.arguments(|e| {
            let lambda = e.float()? as f32;
            e.comma()?;
            let omega = e.float()? as f32;
            e.comma()?;
            let count = e.float()?.clamp(1.0, 10.0) as u32;
            e.comma()?;
            Ok((Octaves { count, lambda, omega }, e.vector()?))
        })?;
        Ok(vector_turbulence(octaves, point))
    }
}

/// A vector turned about an axis of any length; NaN for a zero one.
pub(super) fn rotated_about(v: DVec3, axis: DVec3, degrees: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let n = axis / axis.length();
    v * cos + n.cross(v) * sin + n * (n.dot(v) * (1.0 - cos))
}
