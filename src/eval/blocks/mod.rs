//! The braces of the language: what each keyword block says, as scene data.
//!
//! One file a family. All of it is methods of the evaluator that pull tokens, so that
//! directives and macros work between any two of them.

mod atmosphere;
mod camera;
mod defaults;
mod finish;
mod freeform;
mod function;
mod global_light;
mod image;
mod implicit;
mod interior;
mod layers;
mod light;
mod maps;
mod mesh;
mod modifiers;
mod normal;
mod object;
mod pattern;
mod pattern_modifiers;
mod pigment;
mod settings;
mod shape;
mod spline;
mod table;
#[cfg(test)]
mod tests;
mod texture;

pub use camera::CameraStatement;
pub use defaults::Defaults;
pub use layers::Material;
pub(super) use object::is_object_keyword;
pub use table::Described;
pub(super) use table::{Table, with_words};

use super::{Evaluator, Value};
use crate::diag::{SourceResult, Topic};
use crate::scene::{Blend, MapEntry};
use crate::syntax::Keyword as K;
use std::rc::Rc;
use std::sync::Arc;

/// All tables.
static TABLES: &[&dyn Table] = &[
    &atmosphere::FOG,
    &atmosphere::RAINBOW,
    &camera::CAMERA_TYPES,
    &camera::CAMERA,
    &finish::FINISH,
    &finish::IRID,
    &finish::REFLECTION,
    &finish::SUBSURFACE,
    &global_light::PHOTONS,
    &global_light::RADIOSITY,
    &global_light::SUBSURFACE,
    &image::MAPPING,
    &interior::INTERIOR,
    &interior::MEDIA,
    &layers::MATERIAL,
    &light::LIGHT_SOURCE,
    &modifiers::MODIFIERS,
    &modifiers::PHOTONS,
    &pattern_modifiers::MODIFIERS,
    &pattern_modifiers::TURBULENCE,
    &settings::GLOBAL_SETTINGS,
    &texture::LAYER,
];

/// Blocks by their names, with the words that they take.
pub fn described() -> impl Iterator<Item = (&'static str, Vec<Described>)> {
    TABLES.iter().map(|table| (table.name(), table.words()))
}

impl Evaluator<'_> {
    /// One item of the scene level, if one comes next.
    pub(in crate::eval) fn scene_item(&mut self) -> SourceResult<bool> {
        let span = self.span();
        if let Some(object) = self.own_object()? {
            self.add_to_scene(object);
            return Ok(true);
        }
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        match keyword {
            K::Camera => {
                self.next()?;
                let camera = self.camera_block()?;
                let version = self.version;
                if self.defaults.last_camera.replace(camera.clone()).is_some() && version >= 350 {
                    self.warn(Topic::Ignored, span, "there is more than one camera; the last one is used");
                }
                self.scene.camera = camera.into_camera(version);
            }
            K::GlobalSettings => {
                self.next()?;
                self.global_settings()?;
            }
            K::Background => {
                self.next()?;
                self.scene.background = Some(self.background()?);
            }
            K::Fog => {
                self.next()?;
                let fog = self.fog()?;
                self.scene.fogs.push(fog);
            }
            K::Rainbow => {
                self.next()?;
                let rainbow = self.rainbow()?;
                self.scene.rainbows.push(rainbow);
            }
            K::SkySphere => {
                self.next()?;
                let sky = self.sky_sphere()?;
                if self.scene.sky_sphere.replace(sky).is_some() {
                    self.warn(Topic::Ignored, span, "there is more than one sky_sphere; the last one is used");
                }
            }
            K::Media => {
                self.next()?;
                let media = self.media_block()?;
                self.scene.media.push(media);
            }
            K::MaxTraceLevel | K::MaxIntersections => return self.item_of(&settings::GLOBAL_SETTINGS, &mut ()),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Puts an object into the scene, with the default texture in force now.
    fn add_to_scene(&mut self, object: crate::scene::Object) {
        self.scene.objects.push(object);
        let texture = match self.scene.default_textures.last() {
            Some(last) if self.defaults.is_texture(last) => last.clone(),
            _ => self.defaults.texture(),
        };
        self.scene.default_textures.push(texture);
    }

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
