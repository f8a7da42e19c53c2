//! What rays meet: geometry here, textures and lights beside it.
//!
//! Plain data without spans or paths, made by [`compile`](crate::compile); knows nothing
//! of the scene description. Things refer to each other by
//! handles ([`TextureId`](geometry::TextureId), [`InteriorId`](geometry::InteriorId)) into the [`Table`]s of one scene.

pub mod atmosphere;
pub mod camera;
mod features;
pub mod geometry;
mod handle;
pub mod interior;
mod labels;
pub mod light;
pub mod medium;
pub mod mesh_camera;
pub mod photons;
pub mod radiosity;
pub mod subsurface;
pub mod texture;
mod world;

/// A function whose pigments and patterns are compiled.
pub type Function = crate::function::Function<texture::PointFunction>;

pub use features::Features;
pub use handle::{Handle, Table, TargetId};
pub use labels::Labels;
pub use world::{Settings, Transfer, World};
