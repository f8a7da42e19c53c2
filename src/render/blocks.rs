//! The picture in blocks, on all cores, in an order that does not depend on them.

use super::antialias::Method;
use super::gather::{Detail, Gather};
use super::options::{Options, Region};
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

/// A rectangle of pixels that is worked on at once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) width: usize,
    pub(super) height: usize,
}

/// Renders the picture, or the part of it that is asked for.
///
/// `options.threads` workers; the result is the same bits for any number of them, and a part's pixels are
/// those of the whole picture.
pub fn render(world: &World, options: &Options, progress: Progress<'_>) -> Rendered {
    if options.layers.is_empty() {
        let (pixels, statistics) = render_pixels::<Radiance>(world, options, progress);
        return Rendered { picture: picture(world, options, &pixels), statistics };
    }
    let (pixels, statistics) = render_pixels::<Detail>(world, options, progress);
    let mut picture = picture(world, options, &pixels);
    picture.layers = options.layers.iter().flat_map(|layer| layer.build(world, &pixels)).collect();
    Rendered { picture, statistics }
}

fn picture<G: Gather>(world: &World, options: &Options, pixels: &[G]) -> Picture {
    let window = options.window();
    let mut picture = Picture::filled(window.width(), window.height(), [0.0, 0.0, 0.0, 1.0]);
    picture.origin = [window.left as i32, window.top as i32];
    picture.full = [options.width, options.height];
    picture.has_alpha = options.alpha;
    picture.pixels.iter_mut().zip(pixels).for_each(|(out, pixel)| *out = encoded(world, options, &pixel.light()));
    picture
}

/// The window's pixels, row by row.
fn render_pixels<G: Gather>(world: &World, options: &Options, progress: Progress<'_>) -> (Vec<G>, Statistics) {
    let window = options.window();
    let blocks = blocks(&window);
    let mut all = vec![G::default(); window.width() * window.height()];
    let parts = rows_of(&blocks, &window, &mut all);
    let work = || -> Vec<Statistics> {
        blocks
            .par_iter()
            .zip(parts)
            .map_init(
                || Tracer::new(world, options),
                |tracer, (block, rows)| {
                    let mut pixels = render_block(tracer, options, block).into_iter();
                    progress(pixels.len());
                    rows.into_iter().flatten().zip(&mut pixels).for_each(|(out, pixel)| *out = pixel);
                    tracer.take_statistics()
                },
            )
            .collect()
    };
    // Deep recursion through glass needs more than the usual stack.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).stack_size(64 << 20).build();
    let counts = match pool {
        Ok(pool) => pool.install(work),
        // Without threads of our own the common ones must do.
        Err(_) => work(),
    };
    (all, counts.into_iter().fold(Statistics::default(), Statistics::plus))
}

/// The pixels of each block, row by row, among all of the window.
fn rows_of<'p, G>(blocks: &[Block], window: &Region, all: &'p mut [G]) -> Vec<Vec<&'p mut [G]>> {
    let mut parts: Vec<Vec<&mut [G]>> = blocks.iter().map(|block| Vec::with_capacity(block.height)).collect();
    for (y, mut row) in (window.top..).zip(all.chunks_mut(window.width().max(1))) {
        // Blocks come row by row.
        let first = blocks.partition_point(|block| block.y + block.height <= y);
        let end = blocks.partition_point(|block| block.y <= y);
        for (block, part) in blocks[first..end].iter().zip(&mut parts[first..end]) {
            let (own, rest) = row.split_at_mut(block.width);
            part.push(own);
            row = rest;
        }
    }
    parts
}

/// The window cut along the lines of the full picture's blocks.
fn blocks(window: &Region) -> Vec<Block> {
    let cuts = |from: usize, to: usize| {
        let inner = (from / BLOCK + 1..).map(|i| i * BLOCK).take_while(move |cut| *cut < to);
        let starts: Vec<usize> = std::iter::once(from).chain(inner).filter(|cut| *cut < to).collect();
        let ends: Vec<usize> = starts.iter().skip(1).copied().chain([to]).collect();
        starts.into_iter().zip(ends).collect::<Vec<_>>()
    };
    let columns = cuts(window.left, window.right);
    let rows = cuts(window.top, window.bottom);
    let block = |(y, bottom): (usize, usize)| {
        columns.iter().map(move |&(x, right)| Block { x, y, width: right - x, height: bottom - y })
    };
    rows.into_iter().flat_map(block).collect()
}

fn render_block<G: Gather>(tracer: &mut Tracer<'_>, options: &Options, block: &Block) -> Vec<G> {
    let Some(antialias) = &options.antialias else {
        return tracer.camera_grid(block.width, block.height, [block.x as f64, block.y as f64]);
    };
    if antialias.method == Method::Adaptive {
        return antialias.block(tracer, block);
    }
    // Pixels above and to the left decide whether one is refined, and so do its neighbours on the right and below.
    let (x, y) = (block.x / BLOCK * BLOCK, block.y / BLOCK * BLOCK);
    let end = |from: usize, to: usize, size: usize| (to + 1).min(from + BLOCK).min(size);
    let (right, bottom) =
        (end(x, block.x + block.width, options.width), end(y, block.y + block.height, options.height));
    let around = Block { x, y, width: right - x, height: bottom - y };
    let pixels = antialias.block(tracer, &around);
    let inside = |i: &usize| {
        let (column, row) = (x + i % around.width, y + i / around.width);
        (block.x..block.x + block.width).contains(&column) && (block.y..block.y + block.height).contains(&row)
    };
    pixels.into_iter().enumerate().filter(|(i, _)| inside(i)).map(|(_, pixel)| pixel).collect()
}

/// Working values to linear light.
fn encoded(world: &World, options: &Options, value: &Radiance) -> [f32; 4] {
    let linear = |v: f32| world.settings.transfer.linear(v);
    let alpha = if options.alpha { 1.0 - value.transparency } else { 1.0 };
    [linear(value.rgb.x), linear(value.rgb.y), linear(value.rgb.z), alpha]
}
