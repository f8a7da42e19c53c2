//! What a scene may ask about its objects: `trace`, `inside`, `min_extent`, `max_extent`.

use super::{Evaluator, Number, Place, Value};
use crate::diag::SourceResult;
use crate::math::{DVec3, Ray};
use crate::scene::Object;
use crate::syntax::TokenKind;
use std::sync::Arc;

impl Evaluator<'_> {
    /// An object identifier, as the first argument of these functions.
    fn object_argument(&mut self) -> SourceResult<Arc<Object>> {
        let object = self.take_declared(|value| match value {
            Value::Object(object) => Some(Arc::clone(object)),
            _ => None,
        })?;
        match object {
            Some(object) => Ok(object),
            None => self.expected("the name of an object"),
        }
    }

    /// `inside(object, point)`.
    pub(super) fn inside(&mut self) -> SourceResult<f64> {
        let span = self.feed.last_span();
        self.arguments(|e| {
            let object = e.object_argument()?;
            e.comma()?;
            let point = e.vector()?;
            match e.queries.inside(&object, point) {
                Some(inside) => Ok(f64::from(inside)),
                None => e.error(span, "this object is a surface without an inside"),
            }
        })
    }

    /// `trace(object, origin, direction [, normal])`.
    pub(super) fn trace(&mut self) -> SourceResult<DVec3> {
        let span = self.feed.last_span();
        self.arguments(|e| {
            let object = e.object_argument()?;
            e.comma()?;
            let origin = e.vector()?;
            e.comma()?;
            let direction = e.vector()?;
            let normal = if e.accept_punct(',')? { Some(e.vector_identifier()?) } else { None };
            let length = direction.length();
            if length == 0.0 || !length.is_finite() {
                return e.error(span, "the direction of a traced ray has no length");
            }
            let hit = e.queries.trace(&object, &Ray { origin, direction: direction / length });
            let (point, facing) = hit.unwrap_or_default();
            if let Some(place) = normal {
                place.set(Some(Value::from(Number::vector(facing))));
            }
            Ok(point)
        })
    }

    /// The variable that receives the normal.
    fn vector_identifier(&mut self) -> SourceResult<Place> {
        let TokenKind::Name(_) = self.fill(false)? else {
            return self.expected("the name of a vector that receives the normal");
        };
        let span = self.span();
        let place = self.place()?;
        match place.get() {
            Some(Value::Vector(Number { n: 3, .. })) => Ok(place),
            _ => self.error(span, "the normal goes to a declared vector of three components"),
        }
    }

    /// `min_extent(object)` and `max_extent(object)`, in single precision.
    pub(super) fn extent(&mut self, max: bool) -> SourceResult<DVec3> {
        /// What POV-Ray gives for an infinite extent.
        const INFINITE: f64 = 1e10;
        self.arguments(|e| {
            if max && let Some(size) = e.image_size()? {
                return Ok(size);
            }
            let object = e.object_argument()?;
            let bounds = e.queries.extent(&object);
            let corner = if max { bounds.max } else { bounds.min };
            let single = |c: f64| f64::from(c.clamp(-INFINITE, INFINITE) as f32);
            Ok(DVec3::new(single(corner.x), single(corner.y), single(corner.z)))
        })
    }

    /// `max_extent` of a pigment that shows a picture: its size.
    fn image_size(&mut self) -> SourceResult<Option<DVec3>> {
        let pigment = self.take_declared(|value| match value {
            Value::Pigment(pigment) => Some(Arc::clone(pigment)),
            _ => None,
        })?;
        let Some(pigment) = pigment else { return Ok(None) };
        let span = self.feed.last_span();
        match self.queries.image_size(&pigment) {
            Some([width, height]) => Ok(Some(DVec3::new(f64::from(width), f64::from(height), 0.0))),
            None => self.error(span, "only a pigment with an image_map has an extent"),
        }
    }
}
