//! What rays meet: geometry here, textures and lights beside it.
//!
//! Plain data without spans or paths, made by [`compile`](crate::compile); knows nothing
//! of the scene description. Indices ([`TextureId`](geometry::TextureId),
//! [`InteriorId`](geometry::InteriorId)) refer to lists that `compile` hands on.

pub mod atmosphere;
pub mod camera;
mod features;
pub mod geometry;
pub mod interior;
mod labels;
pub mod light;
pub mod mesh_camera;
pub mod texture;
mod world;

pub use features::Features;
pub use labels::Labels;
pub use world::{Group, Settings, Transfer, World};
