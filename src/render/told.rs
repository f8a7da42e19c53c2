//! One pixel, told step by step.

use super::film::encoded;
use super::observer::Unobserved;
use super::options::Options;
use super::prepare::Prepared;
use super::pretrace::pretrace;
use super::sensor::told_at;
use super::shoot::shoot;
use super::worker::Worker;
use crate::compiled::World;

/// How a pixel comes about.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// The rays, from the camera on, as an indented tree.
    pub text: String,
    /// The pixel of a picture without antialiasing: linear light and alpha, to the bit.
    pub pixel: [f32; 4],
}

/// Tells how the pixel in a column and row comes about, without antialiasing.
pub fn tell(world: &World, options: &Options, [column, row]: [usize; 2]) -> Told {
    let mut prepared = Prepared::new(world, options);
    shoot(&mut prepared, &Unobserved);
    pretrace(&mut prepared, &Unobserved);
    let mut worker = Worker::new(&prepared);
    let (light, text) = told_at(&mut worker, [column as f64, row as f64]);
    Told { text, pixel: encoded(world, options, &light) }
}
