//! The braces of the language: what each keyword block says, as scene data.
//!
//! One file a family. All of it is methods of the evaluator that pull tokens, so that
//! directives and macros work between any two of them.

mod atmosphere;
mod blob;
mod built_ins;
mod camera;
mod clips;
mod colors;
mod defaults;
mod density;
mod described;
mod directive_words;
mod finish;
mod function;
mod global_light;
mod image;
mod implicit;
mod interior;
mod layers;
mod light;
mod maps;
mod mesh;
mod mesh2;
mod modifiers;
mod normal;
mod object;
mod object_words;
mod outline;
mod patch;
mod pattern;
mod pattern_modifiers;
mod photon_flags;
mod pigment;
mod scene_level;
mod settings;
mod shape;
mod spline;
mod table;
#[cfg(test)]
mod tests;
mod text;
mod texture;
mod warp;

pub use camera::CameraStatement;
pub use defaults::Defaults;
pub use described::{Described, DescribedBlock};
pub(super) use described::{Table, with_words};
pub use layers::Material;
pub(super) use object_words::is_object_keyword;

use super::{Evaluator, Value};
use crate::diag::SourceResult;
use crate::scene::{Blend, MapEntry};
use crate::syntax::Keyword as K;
use std::rc::Rc;
use std::sync::Arc;

/// All tables that stand for themselves.
static TABLES: &[&dyn Table] = &[
    &scene_level::SCENE,
    &object_words::OBJECTS,
    &modifiers::MODIFIERS,
    &light::LIGHT_SOURCE,
    &light::LIGHT_GROUP,
    &shape::CYLINDER,
    &shape::CONE,
    &mesh::MESH,
    &mesh2::MESH2,
    &patch::HEIGHT_FIELD,
    &patch::BICUBIC_PATCH,
    &blob::BLOB,
    &blob::COMPONENT,
    &outline::PRISM,
    &outline::LATHE,
    &outline::SOR,
    &outline::SPHERE_SWEEP,
    &implicit::ISOSURFACE,
    &implicit::PARAMETRIC,
    &implicit::CONTAINER,
    &implicit::JULIA_FRACTAL,
    &texture::TEXTURE,
    &texture::LAYER,
    &pigment::PIGMENT,
    &pigment::IMAGE_MAP,
    &normal::NORMAL,
    &normal::BUMP_MAP,
    &finish::FINISH,
    &finish::IRID,
    &finish::REFLECTION,
    &finish::SUBSURFACE,
    &image::MAPPING,
    &colors::COLORS,
    &pattern::PATTERNS,
    &pattern_modifiers::MODIFIERS,
    &pattern_modifiers::TURBULENCE,
    &pattern_modifiers::OF_KINDS,
    &warp::WARP,
    &warp::REPEAT,
    &warp::BLACK_HOLE,
    &warp::MAPPING,
    &layers::MATERIAL,
    &interior::INTERIOR,
    &interior::MEDIA,
    &interior::SCATTERING,
    &density::DENSITY,
    &photon_flags::PHOTONS,
    &camera::CAMERA,
    &atmosphere::FOG,
    &atmosphere::RAINBOW,
    &atmosphere::SKY_SPHERE,
    &settings::GLOBAL_SETTINGS,
    &global_light::RADIOSITY,
    &global_light::PHOTONS,
    &global_light::SUBSURFACE,
    &spline::SPLINE,
    &built_ins::ALL,
    &built_ins::IN_FUNCTIONS,
    &directive_words::DIRECTIVES,
];

/// All tables that stand for themselves.
fn tables() -> impl Iterator<Item = &'static dyn Table> {
    TABLES.iter().copied()
}

/// The blocks of the language.
pub fn described() -> impl Iterator<Item = DescribedBlock> {
    tables().map(DescribedBlock::of)
}

impl Evaluator<'_> {
    /// The value of a declaration or macro argument that starts with a block keyword.
    pub(in crate::eval) fn declared_block(&mut self, keyword: K) -> SourceResult<Option<Value>> {
        let value = match keyword {
            K::Texture => Value::Texture(self.layered_textures()?),
            K::Function => {
                self.next()?;
                Value::Function(self.function_block()?)
            }
            K::Spline => {
                self.next()?;
                Value::Spline(self.spline_block()?)
            }
            K::Camera
            | K::Pigment
            | K::Normal
            | K::Finish
            | K::Interior
            | K::Material
            | K::Media
            | K::Density
            | K::Fog
            | K::Rainbow
            | K::SkySphere
            | K::ColorMap
            | K::ColourMap
            | K::PigmentMap
            | K::NormalMap
            | K::TextureMap
            | K::SlopeMap
            | K::DensityMap => {
                self.next()?;
                self.appearance_value(keyword)?
            }
            _ => match self.object()? {
                Some(object) => Value::Object(object),
                None => return Ok(None),
            },
        };
        Ok(Some(value))
    }

    fn appearance_value(&mut self, keyword: K) -> SourceResult<Value> {
        Ok(match keyword {
            K::Camera => Value::Camera(Arc::new(self.camera_block()?)),
            K::Pigment => {
                let start = (*self.defaults.layer.pigment).clone();
                Value::Pigment(Arc::new(self.pigment_block(start)?))
            }
            K::Normal => {
                let start = self.defaults.layer.normal.clone();
                Value::Normal(self.normal_block(start)?.unwrap_or_default())
            }
            K::Finish => {
                let start = (*self.defaults.layer.finish).clone();
                Value::Finish(Arc::new(self.finish_block(start)?))
            }
            K::Interior => Value::Interior(Arc::new(self.interior_block(None)?)),
            K::Material => Value::Material(Arc::new(self.material_block()?)),
            K::Media => Value::Media(Arc::new(self.media_block()?)),
            K::Density => Value::Density(Arc::new(self.density_block()?)),
            K::Fog => Value::Fog(Arc::new(self.fog()?)),
            K::Rainbow => Value::Rainbow(Arc::new(self.rainbow()?)),
            K::SkySphere => Value::SkySphere(Arc::new(self.sky_sphere()?)),
            K::PigmentMap => Value::PigmentMap(entries_of(self.pigment_map(false)?)),
            K::NormalMap => Value::NormalMap(entries_of(self.normal_map(false)?)),
            K::TextureMap => Value::TextureMap(entries_of(self.texture_map(false)?)),
            K::DensityMap => Value::DensityMap(entries_of(self.density_map(false)?)),
            K::SlopeMap => Value::SlopeMap(Rc::new(self.slope_map()?)),
            _ => Value::ColorMap(Rc::new(self.color_map()?)),
        })
    }
}

fn entries_of<T>(map: Blend<T>) -> Rc<Vec<MapEntry<T>>> {
    match map {
        Blend::Map(entries) | Blend::Average(entries) => Rc::new(entries),
        Blend::List(_) | Blend::Default => Rc::default(),
    }
}
