//! From the evaluated scene to the compiled one, as named passes.

mod camera;
mod function;
pub mod geometry;
mod light;
mod medium;
mod photons;
mod picture;
mod queries;
mod radiosity;
mod subsurface;
pub mod texture;
mod world;

pub use function::Functions;
pub use picture::Pictures;
pub use queries::Queries;
pub use world::{Compiled, compile, compile_with};
