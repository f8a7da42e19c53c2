//! From a compiled world to pixels: camera rays, recursion, shading, antialiasing, blocks.
//!
//! The same world and options give the same bits for any number of threads: nothing depends
//! on which thread works on a block, and every random choice comes from the position of the
//! camera ray. Rendering cannot fail.

mod antialias;
mod atmosphere;
mod blocks;
mod camera;
mod coverage;
mod dispersion;
mod finish;
mod focal_blur;
mod gather;
mod image_layers;
mod jitter;
mod layers;
mod lights;
mod mesh_camera;
mod neighbours;
mod options;
mod random;
mod ray;
mod refraction;
mod shadow;
mod tracer;

pub use antialias::{Antialias, Method};
pub use blocks::{Progress, Rendered, render};
pub use image_layers::ImageLayer;
pub use options::{Options, Region};
pub use ray::{Radiance, Statistics};
