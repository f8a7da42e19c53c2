//! Gathers light between surfaces before the picture is made.
//!
//! POV-Ray looks over the picture coarsely, then more finely, and finds the rest while it makes the picture, so that each
//! pixel depends on those before it. Here a last pass through every pixel finds that rest, and the picture only reads.
//! A pass goes in waves of blocks: those of one wave see what earlier waves found, and their own; the sizes of waves do not
//! depend on the number of threads, and neither does anything else.

use super::film::{Block, blocks};
use super::observer::{Observer, Stage};
use super::options::Region;
use super::prepare::Prepared;
use super::radiosity::{Phase, PretracePass, Record, passes};
use super::sensor::look;
use super::statistics::Statistics;
use super::worker::Worker;
use rayon::prelude::*;

/// Blocks of the largest wave: as many threads can be busy. The first is one, and each is twice the one before: while
/// little is known, blocks of one wave find the same things.
const LARGEST_WAVE: usize = 16;

/// How far apart blocks of one wave start among directions; it has no factor in common with any usual number of them.
const APART: u32 = 311;

/// POV-Ray's number of rays from which on a pass says whether a block needs another one.
const TELLING: usize = 9;

/// What a block found in a pass.
struct Found {
    records: Vec<(u32, Record, f64)>,
    /// Directions used, by depth.
    used: Vec<u32>,
    /// Finer passes are of use.
    goes_on: bool,
    statistics: Statistics,
}

/// Fills what is known of light between surfaces, if a scene has any.
pub(super) fn pretrace(prepared: &mut Prepared<'_>, observer: &dyn Observer) -> Statistics {
    let Some(radiosity) = &prepared.radiosity else { return Statistics::default() };
    observer.entered(Stage::Radiosity);
    let (width, height) = (prepared.options.width, prepared.options.height);
    let blocks = blocks(&Region { left: 0, top: 0, right: width, bottom: height });
    let passes = passes(radiosity.settings, width, height);
    let mut statistics = Statistics::default();
    let mut goes_on = vec![true; blocks.len()];
    let mut first = vec![0u32; radiosity.settings.recursion_limit as usize];
    for pass in passes.into_iter().map(Some).chain([None]) {
        if pass.is_none() {
            first.fill(0);
        }
        let left: Vec<usize> = (0..blocks.len()).filter(|i| pass.is_none() || goes_on[*i]).collect();
        for wave in waves(&left) {
            if observer.cancels() {
                return statistics;
            }
            let shared: &Prepared<'_> = prepared;
            let one = |worker: &mut Worker<'_>, (k, i): (usize, &usize)| {
                let starts: Vec<u32> = first.iter().map(|next| next.wrapping_add(APART * k as u32)).collect();
                look_over(worker, pass, (&blocks[*i], *i), &starts)
            };
            let wave_of = wave.par_iter().enumerate().map_init(|| Worker::new(shared), |w, (k, i)| one(w, (k, i)));
            let found: Vec<Found> = wave_of.collect();
            for (i, found) in wave.iter().zip(found) {
                goes_on[*i] = found.goes_on;
                statistics = statistics.plus(found.statistics);
                first.iter_mut().zip(&found.used).for_each(|(first, used)| *first = first.wrapping_add(*used));
                if let Some(radiosity) = &mut prepared.radiosity {
                    found.records.into_iter().for_each(|(depth, record, reach)| {
                        radiosity.records.add(depth, record, reach);
                    });
                }
            }
        }
    }
    statistics
}

/// Cuts a pass into waves.
fn waves(mut left: &[usize]) -> Vec<&[usize]> {
    let mut waves = Vec::new();
    let mut size = 1;
    while !left.is_empty() {
        let (wave, rest) = left.split_at(size.min(left.len()));
        waves.push(wave);
        left = rest;
        size = (2 * size).min(LARGEST_WAVE);
    }
    waves
}

/// Sends the rays of a pass through a block; without a pass, one through each pixel.
fn look_over(
    worker: &mut Worker<'_>,
    pass: Option<PretracePass>,
    (block, number): (&Block, usize),
    starts: &[u32],
) -> Found {
    let (phase, positions) = match pass {
        Some(pass) => {
            let within = [block.x..block.x + block.width, block.y..block.y + block.height];
            (Phase::Pretrace, pass.positions(within, number))
        }
        None => (Phase::Completion, centers(block)),
    };
    worker.gathering.begin(phase, starts.iter().copied());
    for position in &positions {
        look(worker, *position);
    }
    let gathering = &mut worker.gathering;
    let enough = worker.prepared.radiosity.as_ref().map_or(0, |r| r.settings.enough_for_pretrace);
    let known = gathering.known / f64::from(gathering.asked.max(1));
    let is_done = gathering.asked == 0 || enough > 0 && known >= f64::from(enough);
    Found {
        records: std::mem::take(&mut gathering.found),
        used: gathering.next.iter().zip(starts).map(|(next, start)| next.wrapping_sub(*start)).collect(),
        goes_on: positions.len() < TELLING || !is_done,
        statistics: worker.take_statistics(),
    }
}

fn centers(block: &Block) -> Vec<[f64; 2]> {
    let row = |y: usize| (block.x..block.x + block.width).map(move |x| [x as f64, y as f64]);
    (block.y..block.y + block.height).flat_map(row).collect()
}
