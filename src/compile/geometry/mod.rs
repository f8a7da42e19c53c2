//! From scene objects to compiled geometry, as named passes.

mod builder;
mod census;
mod copies;
mod extent;
mod freeform;
mod half_spaces;
mod height_field;
mod implicit;
mod inherit;
mod labels;
mod lights;
mod patch;
mod photon_targets;
mod primitive;
mod quadric_reach;
mod room;
mod sweep;
#[cfg(test)]
mod tests;
mod text;
mod watch;

use crate::compile::function::Functions;
use crate::compiled::geometry::{Geometry, Group, GroupBuilder, InteriorId, LightGroupId, TextureId};
use crate::compiled::photons::PhotonTarget;
use crate::compiled::{Labels, Table};
use crate::diag::{Diagnostic, SourceResult, Span};
use crate::math::Transform;
use crate::omission::{Keep, Ledger};
use crate::scene::{Interior, LightSource, Object, Scene, Settings, Texture};
use builder::Builder;
use census::Census;
use copies::Copies;
use lights::collect_lights;
use photon_targets::Targets;
use std::sync::Arc;

pub(crate) use extent::extent;
pub use watch::Watched;

/// POV-Ray's number for "nothing": lengths, and squares that it compares with each other, below it count
/// as zero, whatever the scale of the scene. Kept, because it decides which input degenerates.
const POV_TINY: f64 = 1e-10;

/// The geometry, with the tables that its handles refer to.
#[derive(Debug, Default)]
pub struct CompiledGeometry {
    /// What rays meet.
    pub geometry: Geometry,
    /// Each different texture once.
    pub textures: Table<TextureId, Arc<Texture>>,
    /// One for each object that owns an interior.
    pub interiors: Table<InteriorId, Arc<Interior>>,
    /// Every light source of the scene, moved to world space.
    pub lights: Vec<PlacedLight>,
    /// In file order.
    pub light_groups: Table<LightGroupId, LightGroup>,
    /// At which photons are shot.
    pub targets: Vec<PhotonTarget>,
    /// Names of objects and textures.
    pub labels: Labels,
    /// Isosurfaces that may have something to say after rendering, in file order.
    pub watched: Vec<Watched>,
    /// What is left out or unusual.
    pub warnings: Vec<Diagnostic>,
    /// What rays do not need.
    pub ledger: Ledger,
}

/// A light source in world space.
#[derive(Clone, Debug)]
pub struct PlacedLight {
    /// Where its statement stands.
    pub span: Span,
    /// The light; all positions in world space.
    pub light: Arc<LightSource>,
    /// The light group it belongs to; `None` for global lights.
    pub group: Option<LightGroupId>,
}

/// What a light group says about its members.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightGroup {
    /// GroupBuilder are lit by global lights, too.
    pub global_lights: bool,
}

/// Compiles a whole scene: unions split, copies shared, hierarchies built.
///
/// # Errors
/// Located messages for shapes that are not supported yet and for limits.
pub fn compile(scene: &Scene, functions: &Functions, keep: Keep) -> SourceResult<CompiledGeometry> {
    let fallback = Arc::new(Texture::default());
    let default_of = |i: usize| scene.default_textures.get(i).unwrap_or(&fallback);
    let objects: Vec<_> = scene.objects.iter().enumerate().map(|(i, o)| (o, default_of(i))).collect();
    build(&objects, true, &scene.settings, (functions, keep))
}

/// Compiles one object by itself, for `trace`, `inside`, object patterns and `projected_through`.
///
/// # Errors
/// As [`compile`].
pub fn compile_object(object: &Object) -> SourceResult<Geometry> {
    compile_object_sharing(object, &Functions::default())
}

/// The same, with what was made of functions already.
///
/// # Errors
/// As [`compile`].
pub(in crate::compile) fn compile_object_sharing(object: &Object, functions: &Functions) -> SourceResult<Geometry> {
    Ok(build(&[(object, &Arc::default())], false, &Settings::default(), (functions, Keep::NONE))?.geometry)
}

/// All passes in order.
fn build(
    objects: &[(&Object, &Arc<Texture>)],
    split: bool,
    settings: &Settings,
    (functions, keep): (&Functions, Keep),
) -> SourceResult<CompiledGeometry> {
    let mut census = Census::new(settings.photons.is_some());
    for (object, _) in objects {
        census.count(object);
    }
    let (mut copies, mut n_parts) = (Copies::new(&census), 0_u64);
    for (object, _) in objects {
        n_parts = n_parts.saturating_add(copies.count(object, split));
        let max_parts = settings.max_parts;
        if n_parts > max_parts {
            let message = format!("with all its copies this makes more than {max_parts} objects");
            let advice = "copy less often what was copied before; if that is meant, raise it with --limit parts=N";
            return Err(vec![Diagnostic::error(object.span, message).hint(advice)]);
        }
    }
    let mut out = CompiledGeometry::default();
    for (object, _) in objects {
        collect_lights(object, &Transform::IDENTITY, None, &census, &mut out);
    }
    let mut builder = Builder::new(&census, objects.len(), functions, keep);
    builder.with_radiosity = settings.radiosity.is_some();
    builder.targets = settings.photons.as_ref().map(|_| Targets::default());
    let mut items = GroupBuilder::with_capacity(objects.len());
    builder.place_roots(objects, split, &mut items);
    if !builder.errors.is_empty() {
        return Err(builder.errors);
    }
    let Builder { mut geometry, textures, interiors, labeler, mut watched, ledger, targets, .. } = builder;
    watched.sort_by_key(|w| w.span);
    geometry.root = Group::new(items);
    let targets = targets.map(|targets| targets.finish(&out.light_groups)).unwrap_or_default();
    Ok(CompiledGeometry { geometry, textures, interiors, targets, labels: labeler.finish(), watched, ledger, ..out })
}
