//! The evaluated scene: what a file says once every macro has run, as plain data.
//!
//! Owns no acceleration structure and no text. POV-Ray's words are used as in its
//! manual. Values are shared through `Arc` and copied on write, so a declared object
//! that is used a thousand times is stored once.
//!
//! What a later stage may rely on:
//! - every matrix is invertible and finite;
//! - `Object::place` takes the shape's own space to the space of whatever
//!   contains the object; texture transforms start from texture space and end in
//!   that same containing space;
//! - defaults (`#default`, inherited pigments) are already filled in, but texture and
//!   interior inheritance from CSG parents to children is not: an absent texture means
//!   "take the parent's";
//! - functions hold the pigments and patterns that they call as data: here nobody can call them;
//! - what `compile` may have to complain about knows where it was written.

mod atmosphere;
mod camera;
mod default_colors;
mod function;
mod global_light;
mod interior;
mod light;
mod mesh_builder;
mod object;
mod pattern;
mod settings;
mod shape;
mod texture;

pub use atmosphere::*;
pub use camera::*;
pub use default_colors::default_colors;
pub use function::*;
pub use global_light::*;
pub use interior::*;
pub use light::*;
pub use mesh_builder::*;
pub use object::*;
pub use pattern::*;
pub use settings::*;
pub use shape::*;
pub use texture::*;

use std::sync::Arc;

/// Everything a scene file describes.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// `global_settings` and the language version in force at the end.
    pub settings: Settings,
    /// The last camera.
    pub camera: Camera,
    /// `background`.
    pub background: Option<Background>,
    /// The last `sky_sphere`.
    pub sky_sphere: Option<SkySphere>,
    /// All `fog` statements.
    pub fogs: Vec<Fog>,
    /// All `rainbow` statements.
    pub rainbows: Vec<Rainbow>,
    /// Atmospheric `media`.
    pub media: Vec<Media>,
    /// Frame-level objects in file order, lights and light groups included.
    pub objects: Vec<Object>,
    /// What an object without any texture gets, as it stood when the object was placed
    /// (parallel to `objects`).
    pub default_textures: Vec<Arc<Texture>>,
    /// What was declared and is nowhere in the scene.
    pub unused: Unused,
}

/// Declarations that nothing used.
#[derive(Clone, Debug, Default)]
pub struct Unused {
    /// How many.
    pub count: usize,
    /// They themselves, where they are to be kept.
    pub kept: Vec<Declared>,
}

/// What a name stood for.
#[derive(Clone, Debug)]
pub enum Declared {
    /// `object` and every shape.
    Object(Arc<Object>),
    /// `texture`.
    Texture(Arc<Texture>),
    /// `pigment`.
    Pigment(Arc<Pigment>),
    /// `normal`.
    Normal(Arc<Normal>),
    /// What compiles to nothing by itself.
    Other,
}
