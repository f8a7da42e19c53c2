//! What was declared and never used: the rest of the program never hears of it.

use super::Value;
use super::names::Names;
use crate::omission::{Keep, Omission};
use crate::scene::{Declared, Unused};
use std::sync::Arc;

/// Parts of scenes that stand under names which nothing asked for. Numbers, functions and arrays are none: what became
/// of these is nowhere to be seen.
pub(super) fn unused(names: &Names, keep: Keep) -> Unused {
    let keeps = keep.holds(Omission::Declarations);
    let mut unused = Unused::default();
    for place in names.unused() {
        let Some(declared) = place.with(|value| value.and_then(part_of_scene)) else { continue };
        unused.count += 1;
        unused.kept.extend(keeps.then_some(declared));
    }
    unused
}

/// A value as what it would be in a scene.
fn part_of_scene(value: &Value) -> Option<Declared> {
    Some(match value {
        Value::Object(object) => Declared::Object(Arc::clone(object)),
        Value::Texture(texture) => Declared::Texture(Arc::clone(texture)),
        Value::Pigment(pigment) => Declared::Pigment(Arc::clone(pigment)),
        Value::Normal(normal) => Declared::Normal(Arc::clone(normal)),
        Value::Camera(_)
        | Value::Finish(_)
        | Value::Interior(_)
        | Value::Material(_)
        | Value::Media(_)
        | Value::Density(_)
        | Value::Fog(_)
        | Value::Rainbow(_)
        | Value::SkySphere(_)
        | Value::ColorMap(_)
        | Value::PigmentMap(_)
        | Value::NormalMap(_)
        | Value::TextureMap(_)
        | Value::SlopeMap(_)
        | Value::DensityMap(_) => Declared::Other,
        Value::Float(_)
        | Value::Vector(_)
        | Value::String(_)
        | Value::Array(_)
        | Value::Function(_)
        | Value::Spline(_)
        | Value::Transform(_)
        | Value::File(_)
        | Value::Macro(_) => return None,
    })
}
