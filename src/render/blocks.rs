//! The picture in blocks, on all cores, in an order that does not depend on them.

use super::Options;
use super::ray::{Radiance, Statistics};
use super::tracer::Tracer;
use crate::compiled::World;
use crate::imaging::Picture;
use rayon::prelude::*;

/// Side of a block in pixels: POV-Ray's default, on which antialiasing method 1 depends.
const BLOCK: usize = 32;

/// Told how many pixels have been finished; called from any thread.
pub type Progress<'a> = &'a (dyn Fn(usize) + Sync);

/// A picture and what it cost.
#[derive(Debug)]
pub struct Rendered {
    /// The picture in linear light.
    pub picture: Picture,
    /// Rays of all kinds.
    pub statistics: Statistics,
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) width: usize,
    pub(super) height: usize,
}

/// Renders the whole picture.
///
/// `options.threads` workers; the result is the same bits for any number of them.
pub fn render(world: &World, options: &Options, progress: Progress<'_>) -> Rendered {
    let blocks = blocks(options);
    let work = || -> Vec<(Vec<Radiance>, Statistics)> {
        blocks
            .par_iter()
            .map_init(
                || Tracer::new(world, options),
                |tracer, block| {
                    let pixels = render_block(tracer, options, block);
                    progress(pixels.len());
                    (pixels, tracer.take_statistics())
                },
            )
            .collect()
    };
    // Deep recursion through glass needs more than the usual stack.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).stack_size(64 << 20).build();
    let finished = match pool {
        Ok(pool) => pool.install(work),
        // Without threads of our own the common ones must do.
        Err(_) => work(),
    };
    let mut picture = Picture::filled(options.width, options.height, [0.0, 0.0, 0.0, 1.0]);
    picture.has_alpha = options.alpha;
    let mut statistics = Statistics::default();
    for (block, (pixels, counts)) in blocks.iter().zip(finished) {
        statistics = statistics.plus(counts);
        for (row, values) in pixels.chunks(block.width).enumerate() {
            let first = (block.y + row) * options.width + block.x;
            let out = &mut picture.pixels[first..first + block.width];
            out.iter_mut().zip(values).for_each(|(out, value)| *out = encoded(world, options, value));
        }
    }
    Rendered { picture, statistics }
}

fn blocks(options: &Options) -> Vec<Block> {
    let (w, h) = (options.width, options.height);
    let starts = |size: usize| (0..size).step_by(BLOCK);
    starts(h)
        .flat_map(|y| starts(w).map(move |x| Block { x, y, width: BLOCK.min(w - x), height: BLOCK.min(h - y) }))
        .collect()
}

fn render_block(tracer: &mut Tracer<'_>, options: &Options, block: &Block) -> Vec<Radiance> {
    if let Some(antialias) = &options.antialias {
        return antialias.block(tracer, block);
    }
    let pixels = (block.y..block.y + block.height).flat_map(|y| (block.x..block.x + block.width).map(move |x| (x, y)));
    pixels.map(|(x, y)| tracer.camera_ray(x as f64, y as f64)).collect()
}

/// Working values to linear light.
fn encoded(world: &World, options: &Options, value: &Radiance) -> [f32; 4] {
    let linear = |v: f32| world.settings.transfer.linear(v);
    let alpha = if options.alpha { 1.0 - value.transparency } else { 1.0 };
    [linear(value.rgb.x), linear(value.rgb.y), linear(value.rgb.z), alpha]
}
