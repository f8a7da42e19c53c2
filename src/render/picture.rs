//! The picture in blocks, on all cores, in an order that does not depend on them.
//!
//! First all samples are taken that every picture needs: pixel centres, or corners where the second way of smoothing
//! edges wants them. Then, if edges are smoothed, each block is refined by itself; what blocks share was traced once.

use super::antialias::Base;
use super::film::{Block, Detail, Film, Gather, encoded};
use super::image_layer::ImageLayer;
use super::observer::{FinishedBlock, Observer, Piece, Place, Stage};
use super::options::Options;
use super::prepare::Prepared;
use super::pretrace::pretrace;
use super::progressive::{self, Found, Progress};
use super::radiance::Radiance;
use super::radiosity::KnownLight;
use super::sensor::at_grid;
use super::shoot::shoot;
use super::statistics::Statistics;
use super::work::Work;
use super::worker::Worker;
use crate::compiled::World;
use crate::imaging::Picture;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A picture and what it cost.
#[derive(Debug)]
pub struct Rendered {
    /// The picture in linear light.
    pub picture: Picture,
    /// Rays of all kinds.
    pub statistics: Statistics,
    /// False if the observer stopped it before every pixel was there.
    pub complete: bool,
    /// How a picture with a target came about.
    pub progress: Option<Progress>,
    /// Light between surfaces, if it is wanted and the scene has any.
    pub light: Option<KnownLight>,
}

/// Renders the picture, or the part of it that is asked for, on the threads of the caller's pool.
///
/// The result is the same bits for any number of them, and a part's pixels are those of the whole picture.
pub fn render(world: &World, options: &Options, observer: &dyn Observer) -> Rendered {
    let mut prepared = Prepared::new(world, options);
    shoot(&mut prepared, observer);
    let before = pretrace(&mut prepared, observer);
    observer.entered(Stage::Picture);
    let work = Work { prepared: &prepared, observer };
    let with_before = |rendered: Rendered| {
        let shared = prepared.radiosity.as_ref().filter(|_| options.keeps_light);
        let light = shared.map(|shared| shared.known_light(options.known_light.as_deref()));
        Rendered { statistics: rendered.statistics.plus(before), light, ..rendered }
    };
    if options.layers.is_empty() {
        return with_before(render_film::<Radiance>(&work).0);
    }
    let (rendered, film) = render_film::<Detail>(&work);
    let mut rendered = with_before(rendered);
    // Where samples went is told already if there was a target.
    let layers = options.layers.iter().filter(|layer| options.target.is_none() || **layer != ImageLayer::Samples);
    rendered.picture.layers.extend(layers.flat_map(|layer| layer.build(world, film.pixels())));
    rendered
}

fn render_film<G: Gather>(work: &Work<'_>) -> (Rendered, Film<G>) {
    let options = work.prepared.options;
    match &options.target {
        Some(target) => {
            let Found { film, statistics, complete, progress, layers } = progressive::render(work, target);
            let mut picture = film.picture(work.prepared.world, options);
            picture.layers = layers;
            (Rendered { picture, statistics, complete, progress: Some(progress), light: None }, film)
        }
        None => render_once(work),
    }
}

/// Takes POV-Ray's samples.
fn render_once<G: Gather>(work: &Work<'_>) -> (Rendered, Film<G>) {
    let (world, options) = (work.prepared.world, work.prepared.options);
    let window = options.window();
    let base = Base::of(options);
    let grid = base.window();
    let (done, all) = (AtomicUsize::new(0), base.n_steps(&window));
    let advance = |n: usize| work.observer.advanced(done.fetch_add(n, Ordering::Relaxed) + n, all);
    let finish = |block: &Block, pixels: &[G]| {
        if work.observer.wants_blocks() {
            let pixels = pixels.iter().map(|pixel| encoded(world, options, pixel)).collect();
            work.observer.finished(&FinishedBlock { x: block.x, y: block.y, width: block.width, pixels });
        }
    };
    let keep = |rows: &mut [&mut [G]], pixels: Vec<G>| {
        advance(pixels.len());
        rows.iter_mut().flat_map(|row| row.iter_mut()).zip(pixels).for_each(|(out, pixel)| *out = pixel);
    };
    let mut samples = vec![G::default(); grid.width() * grid.height()];
    let first = work.each_block(&grid, &mut samples, |worker, block, rows| {
        let at = base.position(block.x, block.y);
        let samples = piece(work, 0, worker, block, |worker| at_grid(worker, block.width, block.height, at));
        if base.antialias().is_none() {
            finish(&Block { x: block.x + window.left, y: block.y + window.top, ..*block }, &samples);
        }
        keep(rows, samples);
    });
    let (pixels, second) = match base.antialias() {
        None => (samples, Statistics::default()),
        Some(antialias) => {
            let mut pixels = vec![G::default(); window.width() * window.height()];
            let second = work.each_block(&window, &mut pixels, |worker, block, rows| {
                let pixels = piece(work, 1, worker, block, |worker| antialias.block(worker, &base, &samples, block));
                finish(block, &pixels);
                keep(rows, pixels);
            });
            (pixels, second)
        }
    };
    let film = Film::new(window, pixels);
    let picture = film.picture(world, options);
    let complete = !work.observer.cancels();
    (Rendered { picture, statistics: first.plus(second), complete, progress: None, light: None }, film)
}

/// The samples of a block: those of an earlier run if there are any, else made now.
fn piece<G: Gather>(
    work: &Work<'_>,
    stage: u32,
    worker: &mut Worker<'_>,
    block: &Block,
    make: impl FnOnce(&mut Worker<'_>) -> Vec<G>,
) -> Vec<G> {
    let place = Place { stage, x: block.x as u32, y: block.y as u32 };
    if let Some(Piece { samples, statistics, .. }) = work.observer.kept(place)
        && samples.len() == block.width * block.height
        && let Some(samples) = samples.into_iter().map(G::restored).collect()
    {
        worker.statistics = statistics;
        return samples;
    }
    let samples = make(worker);
    if work.observer.keeps()
        && let Some(stored) = samples.iter().map(G::stored).collect()
    {
        work.observer.keep(Piece { place, samples: stored, statistics: worker.statistics });
    }
    samples
}
