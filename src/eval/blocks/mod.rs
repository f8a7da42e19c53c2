//! The keyword blocks of the language: objects, textures, lights, cameras, settings.

use super::{Evaluator, Value};
use crate::diag::SourceResult;
use crate::syntax::Keyword;

/// What blocks start from (`#default`).
#[derive(Clone, Debug, Default)]
pub struct Defaults {}

/// A declared camera.
#[derive(Clone, Debug, Default)]
pub struct CameraValue;

/// A declared material.
#[derive(Clone, Debug, Default)]
pub struct Material;

/// Reads one top-level item into the scene; false if the next token starts none.
pub(super) fn scene_item(_: &mut Evaluator<'_>) -> SourceResult<bool> {
    Ok(false)
}

/// Reads the value of a declaration that starts with a block keyword.
pub(super) fn declared_block(_: &mut Evaluator<'_>, _: Keyword) -> SourceResult<Option<Value>> {
    Ok(None)
}

/// Reads the items of `#default { … }`, without the braces.
pub(super) fn default_block(e: &mut Evaluator<'_>) -> SourceResult<()> {
    e.expected("a default texture, pigment, normal, finish or camera")
}
