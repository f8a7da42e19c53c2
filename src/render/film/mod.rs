//! What is kept of samples: pixels, what they cost and show beside light, and the picture made of them.

mod blocks;
mod coverage;
mod gather;
mod image_layers;

pub use blocks::BLOCK;
pub(super) use blocks::{Block, blocks, rows_of};
pub(super) use gather::{Detail, Gather, Term};

use super::options::{Options, Region};
use crate::compiled::World;
use crate::imaging::Picture;

/// The pixels of a part of the picture.
pub(super) struct Film<G> {
    window: Region,
    /// Row by row.
    pixels: Vec<G>,
}

impl<G: Gather> Film<G> {
    /// Pixels of a window, row by row.
    pub(super) fn new(window: Region, pixels: Vec<G>) -> Self {
        Self { window, pixels }
    }

    /// The pixels, row by row.
    pub(super) fn pixels(&self) -> &[G] {
        &self.pixels
    }

    /// Linear light, in the place that it has in the whole picture.
    pub(super) fn picture(&self, world: &World, options: &Options) -> Picture {
        let window = &self.window;
        let mut picture = Picture::filled(window.width(), window.height(), [0.0, 0.0, 0.0, 1.0]);
        picture.origin = [window.left as i32, window.top as i32];
        picture.full = [options.width, options.height];
        picture.has_alpha = options.alpha;
        picture.pixels.iter_mut().zip(&self.pixels).for_each(|(out, pixel)| *out = encoded(world, options, pixel));
        picture
    }
}

/// Working values to linear light, and alpha.
pub(super) fn encoded<G: Gather>(world: &World, options: &Options, pixel: &G) -> [f32; 4] {
    let light = pixel.light();
    let linear = |v: f32| world.settings.transfer.linear(v);
    let alpha = if options.alpha { 1.0 - light.transparency } else { 1.0 };
    [linear(light.rgb.x), linear(light.rgb.y), linear(light.rgb.z), alpha]
}
