//! The picture in blocks, on all cores, in an order that does not depend on them.
//!
//! First all samples are taken that every picture needs: pixel centres, or corners where the second way of smoothing
//! edges wants them. Then, if edges are smoothed, each block is refined by itself; what blocks share was traced once.

use super::antialias::Base;
use super::film::{Block, Detail, Film, Gather, blocks, encoded, rows_of};
use super::observer::{FinishedBlock, Observer};
use super::options::{Options, Region};
use super::prepare::Prepared;
use super::radiance::Radiance;
use super::sensor::at_grid;
use super::statistics::Statistics;
use super::worker::Worker;
use crate::compiled::World;
use crate::imaging::Picture;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A picture and what it cost.
#[derive(Debug)]
pub struct Rendered {
    /// The picture in linear light.
    pub picture: Picture,
    /// Rays of all kinds.
    pub statistics: Statistics,
    /// False if the observer stopped it: then pixels are missing.
    pub complete: bool,
}

/// Renders the picture, or the part of it that is asked for, on the threads of the caller's pool.
///
/// The result is the same bits for any number of them, and a part's pixels are those of the whole picture.
pub fn render(world: &World, options: &Options, observer: &dyn Observer) -> Rendered {
    let prepared = Prepared::new(world, options);
    if options.layers.is_empty() {
        return render_film::<Radiance>(&prepared, observer).0;
    }
    let (mut rendered, film) = render_film::<Detail>(&prepared, observer);
    rendered.picture.layers = options.layers.iter().flat_map(|layer| layer.build(world, film.pixels())).collect();
    rendered
}

fn render_film<G: Gather>(prepared: &Prepared<'_>, observer: &dyn Observer) -> (Rendered, Film<G>) {
    let (world, options) = (prepared.world, prepared.options);
    let window = options.window();
    let base = Base::of(options);
    let grid = base.window();
    let work = Work { prepared, observer, done: AtomicUsize::new(0), all: base.n_steps(&window) };
    let finish = |block: &Block, pixels: &[G]| {
        if observer.wants_blocks() {
            let pixels = pixels.iter().map(|pixel| encoded(world, options, pixel)).collect();
            observer.finished(&FinishedBlock { x: block.x, y: block.y, width: block.width, pixels });
        }
    };
    let (samples, first) = work.each_block(&grid, |worker, block| {
        let samples = at_grid(worker, block.width, block.height, base.position(block.x, block.y));
        if base.antialias().is_none() {
            finish(&Block { x: block.x + window.left, y: block.y + window.top, ..*block }, &samples);
        }
        samples
    });
    let (pixels, second) = match base.antialias() {
        None => (samples, Statistics::default()),
        Some(antialias) => work.each_block(&window, |worker, block| {
            let pixels = antialias.block(worker, &base, &samples, block);
            finish(block, &pixels);
            pixels
        }),
    };
    let film = Film::new(window, pixels);
    let picture = film.picture(world, options);
    (Rendered { picture, statistics: first.plus(second), complete: !observer.cancels() }, film)
}

/// What all blocks have in common.
struct Work<'a> {
    prepared: &'a Prepared<'a>,
    observer: &'a dyn Observer,
    /// Samples and pixels.
    done: AtomicUsize,
    all: usize,
}

impl Work<'_> {
    /// Fills a window block by block.
    fn each_block<G: Gather>(
        &self,
        window: &Region,
        fill: impl Fn(&mut Worker<'_>, &Block) -> Vec<G> + Sync,
    ) -> (Vec<G>, Statistics) {
        let blocks = blocks(window);
        let mut all = vec![G::default(); window.width() * window.height()];
        let parts = rows_of(&blocks, window, &mut all);
        let one = |worker: &mut Worker<'_>, (block, rows): (&Block, Vec<&mut [G]>)| {
            if !self.observer.cancels() {
                let pixels = fill(worker, block);
                let done = self.done.fetch_add(pixels.len(), Ordering::Relaxed) + pixels.len();
                self.observer.advanced(done, self.all);
                rows.into_iter().flatten().zip(pixels).for_each(|(out, pixel)| *out = pixel);
            }
            worker.take_statistics()
        };
        let counts: Vec<Statistics> =
            blocks.par_iter().zip(parts).map_init(|| Worker::new(self.prepared), one).collect();
        (all, counts.into_iter().fold(Statistics::default(), Statistics::plus))
    }
}
