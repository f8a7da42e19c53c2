//! From the evaluated scene to the compiled one, as named passes.

mod camera;
pub mod geometry;
mod light;
pub mod texture;
mod world;

pub use world::compile;
