//! From scene objects to compiled geometry, as named passes.

use crate::compiled::geometry::{Geometry, LightGroupId};
use crate::diag::{Diagnostic, SourceResult};
use crate::scene::{Interior, LightSource, Object, Scene, Texture};
use std::sync::Arc;

/// The geometry, with the lists that its indices refer to.
#[derive(Debug, Default)]
pub struct CompiledGeometry {
    /// What rays meet.
    pub geometry: Geometry,
    /// What a `TextureId` stands for; each different texture once.
    pub textures: Vec<Arc<Texture>>,
    /// What an `InteriorId` stands for; one entry for each object that owns an interior.
    pub interiors: Vec<Arc<Interior>>,
    /// Every light source of the scene, moved to world space.
    pub lights: Vec<PlacedLight>,
    /// What a `LightGroupId` stands for.
    pub light_groups: Vec<LightGroup>,
    /// What is left out or unusual.
    pub warnings: Vec<Diagnostic>,
}

/// A light source in world space.
#[derive(Clone, Debug)]
pub struct PlacedLight {
    /// The light; all positions in world space.
    pub light: Arc<LightSource>,
    /// The light group it belongs to; `None` for global lights.
    pub group: Option<LightGroupId>,
}

/// What a light group says about its members.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightGroup {
    /// Members are lit by global lights, too.
    pub global_lights: bool,
}

/// Compiles a whole scene: unions split, copies shared, hierarchies built.
///
/// # Errors
/// Located messages for shapes that are not supported yet and for limits.
pub fn compile(_scene: &Scene) -> SourceResult<CompiledGeometry> {
    Ok(CompiledGeometry::default())
}

/// Compiles one object by itself, for `trace`, `inside`, object patterns and `projected_through`.
///
/// # Errors
/// As [`compile`].
pub fn compile_object(_object: &Arc<Object>) -> SourceResult<Geometry> {
    Ok(Geometry::default())
}
