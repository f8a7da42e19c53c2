//! `clipped_by` and `bounded_by`: solids outside of which an object is not, or is not looked for.

use super::table::Word;
use crate::diag::{SourceResult, Span};
use crate::eval::Evaluator;
use crate::scene::Object;
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(super) fn clipped_by(e: &mut Evaluator<'_>, object: &mut Object, at: Word) -> SourceResult<()> {
    e.open("clipped_by")?;
    if e.accept(K::BoundedBy)? {
        object.rare.clipped_by = object.rare.bounded_by.clone();
        object.flags.bounds_are_clips = true;
    } else {
        let clips = clip_objects(e, at.span)?;
        object.rare.clipped_by.extend(clips);
    }
    e.close("clipped_by")
}

pub(super) fn bounded_by(e: &mut Evaluator<'_>, object: &mut Object, at: Word) -> SourceResult<()> {
    e.open("bounded_by")?;
    if e.accept(K::ClippedBy)? {
        object.rare.bounded_by = object.rare.clipped_by.clone();
        object.flags.bounds_are_clips = true;
    } else {
        let bounds = clip_objects(e, at.span)?;
        object.rare.bounded_by.extend(bounds);
    }
    e.close("bounded_by")
}

/// Objects with transformations for all of them, between the braces of a clip or bound.
fn clip_objects(e: &mut Evaluator<'_>, span: Span) -> SourceResult<Vec<Arc<Object>>> {
    let mut objects = Vec::new();
    loop {
        if let Some(object) = e.object()? {
            if object.texture.is_some() || object.shape.is_patch() {
                return e.error(span, "a clip or bound must be a solid without a texture");
            }
            objects.push(object);
        } else if let Some(transform) = e.transformation()? {
            for object in &mut objects {
                Arc::make_mut(object).apply(&transform);
            }
        } else {
            break;
        }
        e.comma()?;
    }
    if objects.is_empty() {
        return e.expected("an object");
    }
    Ok(objects)
}
