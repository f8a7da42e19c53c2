//! From a compiled world to pixels: camera rays, recursion, shading, antialiasing, blocks.
//!
//! The same world and options give the same bits for any number of threads: nothing depends
//! on which thread works on a block, and every random choice is a function of the camera ray's
//! position and the path from it. Rendering cannot fail.
//!
//! Read from the bottom of this list upwards, each module knows those below it:
//!
//! - `picture`: the whole; `told`: one pixel in words; `progressive`: rounds of samples until the error is small; `antialias`: POV-Ray's positions;
//! - `shoot`: photons, and `pretrace`: light between surfaces, before the picture;
//! - `work`: blocks on all cores; `sensor`: the rays through an image position;
//! - `transport`: the recursion; `light`: what arrives at a vertex from light sources; `shade`: layers as values;
//! - `film`: what is kept of light; `worker`, `prepare`: what a thread owns, what all share;
//! - `radiosity`: records of light between surfaces; `photons`: light that was carried by way of glass and mirrors;
//!   `subsurface`: what materials do with light below theirs;
//! - `medium`, `environment`: what a ray passes, what it sees at the end; `camera`; `vertex`, `path`;
//! - `enough`, `random`, `jitter`, `radiance`, `statistics`, `observer`, `options`.

mod antialias;
mod camera;
mod enough;
mod environment;
mod film;
mod image_layer;
mod jitter;
mod light;
mod medium;
mod observer;
mod options;
mod path;
mod photons;
mod picture;
mod prepare;
mod pretrace;
mod progressive;
mod radiance;
mod radiosity;
mod random;
mod sensor;
mod shade;
mod shoot;
mod statistics;
mod subsurface;
mod told;
mod transport;
mod vertex;
mod work;
mod worker;

pub use film::BLOCK;
pub use image_layer::ImageLayer;
pub use observer::{FinishedBlock, Observer, Piece, Place, Stage, Unobserved};
pub use options::{Antialias, Method, Options, Region, Target};
pub use picture::{Rendered, render};
pub use progressive::{Accuracy, End, Progress};
pub use radiance::Radiance;
pub use radiosity::KnownLight;
pub use statistics::Statistics;
pub use told::{Told, tell};
