//! A picture that gets better until it is good enough: sampling to an error or for a time.
//!
//! Rounds of samples follow one another. After each there is a picture, and an estimate of how far it is from the truth
//! ([`accuracy`]); where more samples are worth most they are taken in the next ([`allocation`]). The truth is the mean
//! over each pixel's square of what the scene gives, its depth of recursion and its area lights' grids as they are.
//!
//! Rounds that are repeated with the same limits give the same bits, for any number of threads.

mod accuracy;
mod allocation;
mod pixel;
mod schedule;
mod stream;

pub use accuracy::Accuracy;
pub use schedule::End;

use super::film::{Block, Film, Gather, encoded};
use super::observer::FinishedBlock;
use super::options::{Region, Target};
use super::sensor::{at_lens_point, at_positions};
use super::statistics::Statistics;
use super::work::Work;
use super::worker::Worker;
use crate::compiled::Transfer;
use crate::imaging::Layer;
use crate::math::Rgb;
use accuracy::Moments;
use allocation::{Noise, Unseen};
use pixel::Pixel;
use rayon::prelude::*;
use schedule::{Schedule, State};
use std::time::Instant;
use stream::{Purpose, Stream, is_audited};

/// Samples that are taken at once, so that neighbours share what they can.
const BATCH: usize = 256;
/// How a picture came about.
#[derive(Clone, Debug)]
pub struct Progress {
    /// How good it is.
    pub accuracy: Accuracy,
    /// The limit of each round, as they are repeated.
    pub rounds: Vec<f64>,
    /// Samples that make the picture.
    pub samples: u64,
    /// Why there were no more.
    pub end: End,
}

impl Progress {
    /// The rounds as words: what [`Target::rounds`] takes, to the last bit.
    pub fn recipe(&self) -> String {
        self.rounds.iter().map(|limit| format!("{limit:e}")).collect::<Vec<_>>().join(",")
    }
}

/// A picture with what was found out about it.
pub(super) struct Found<G> {
    pub(super) film: Film<G>,
    pub(super) statistics: Statistics,
    /// Whether each pixel has samples.
    pub(super) complete: bool,
    pub(super) progress: Progress,
    /// Estimated error and samples of each pixel.
    pub(super) layers: Vec<Layer>,
}

/// A pixel that is looked at once more, by streams of its own.
struct Audit {
    at: usize,
    x: usize,
    y: usize,
    n: u32,
    sums: [Rgb; 2],
}

/// Rounds of samples until the target is reached.
pub(super) fn render<G: Gather>(work: &Work<'_>, target: &Target) -> Found<G> {
    let start = Instant::now();
    let mut sampling = Sampling::<G>::new(work, target.seed);
    sampling.raise(|_, n| n.max(1));
    let mut rounds = Vec::new();
    let mut state = sampling.judge();
    let schedule = Schedule::new(target, start, &state);
    let end = loop {
        if work.observer.cancels() {
            break End::Cancelled;
        }
        schedule.tell(work.observer, &state);
        let limit = match schedule.next(&sampling.pixels, &state, &rounds) {
            Ok(limit) => limit,
            Err(end) => break end,
        };
        rounds.push(limit);
        sampling.raise(|at, n| state.noise.wanted(at, n, limit));
        state = sampling.judge();
    };
    sampling.finish(state, rounds, end)
}

/// The picture so far.
struct Sampling<'a, G> {
    work: &'a Work<'a>,
    seed: u64,
    window: Region,
    pixels: Vec<Pixel<G>>,
    audits: Vec<Audit>,
    statistics: Statistics,
}

impl<'a, G: Gather> Sampling<'a, G> {
    fn new(work: &'a Work<'a>, seed: u64) -> Self {
        let window = work.prepared.options.window();
        let (width, height) = (window.width(), window.height());
        let places = (0..width * height).map(|at| (at, window.left + at % width, window.top + at / width));
        let audits = places
            .filter(|(_, x, y)| is_audited(*x, *y))
            .map(|(at, x, y)| Audit { at, x, y, n: 0, sums: [Rgb::ZERO; 2] })
            .collect();
        let pixels = vec![Pixel::default(); width * height];
        Self { work, seed, window, pixels, audits, statistics: Statistics::default() }
    }

    fn transfer(&self) -> Transfer {
        self.work.prepared.world.settings.transfer
    }

    /// Raises the samples of all pixels to what is wanted, by a pixel's place and what it has.
    fn raise(&mut self, wanted: impl Fn(usize, u32) -> u32 + Sync) {
        let Self { work, seed, window, pixels, .. } = self;
        let (world, options) = (work.prepared.world, work.prepared.options);
        let counts = work.each_block(window, pixels, |worker, block, rows| {
            let place = |i: usize, j: usize| (block.y + j - window.top) * window.width() + block.x + i - window.left;
            raise_block(worker, *seed, block, rows, |i, j, n| wanted(place(i, j), n));
            if work.observer.wants_blocks() {
                let all = rows.iter().flat_map(|row| row.iter());
                let pixels = all.map(|pixel| encoded(world, options, &pixel.mean())).collect();
                work.observer.finished(&FinishedBlock { x: block.x, y: block.y, width: block.width, pixels });
            }
        });
        self.statistics = self.statistics.plus(counts);
        self.audit();
    }

    /// Gives each of the two streams of an audit as many samples as those have that make its pixel; an audit with fewer
    /// is as right.
    fn audit(&mut self) {
        let Self { work, seed, pixels, audits, .. } = self;
        let seed = *seed;
        if work.observer.cancels() {
            return;
        }
        let one = |worker: &mut Worker<'_>, audits: &mut [Audit]| {
            for audit in audits {
                let wanted = pixels[audit.at].n();
                for half in 0..2 {
                    let stream = Stream::new(seed, audit.x, audit.y, Purpose::Audit(half as u8));
                    let samples: Vec<_> = (audit.n..wanted).map(|k| (stream, k)).collect();
                    audit.sums[half] +=
                        light::<G>(worker, &samples).iter().map(|sample| sample.light().rgb).sum::<Rgb>();
                }
                audit.n = wanted;
            }
            worker.take_statistics()
        };
        let parts = audits.par_chunks_mut(BATCH).map_init(|| Worker::new(work.prepared), one);
        let counts: Vec<Statistics> = parts.collect();
        self.statistics = counts.into_iter().fold(self.statistics, Statistics::plus);
    }

    /// How good the picture is.
    fn judge(&self) -> State {
        let (transfer, width) = (self.transfer(), self.window.width());
        let mut noise = Noise::of(&self.pixels, width, transfer);
        let rows: Vec<(Moments, f64, u64)> = (self.pixels.par_chunks(width.max(1)).enumerate())
            .map(|(y, row)| {
                let (mut halves, mut expected, mut samples) = (Moments::default(), 0.0, 0);
                for (x, pixel) in row.iter().enumerate() {
                    halves.add(accuracy::of_halves(pixel.halves(transfer)));
                    expected += noise.expected(y * width + x, pixel.n());
                    samples += u64::from(2 * pixel.n());
                }
                (halves, expected, samples)
            })
            .collect();
        let (mut halves, mut expected, mut samples) = (Moments::default(), 0.0, 0);
        for row in rows {
            (halves, expected, samples) = (halves.plus(row.0), expected + row.1, samples + row.2);
        }
        let (mut beyond, mut unseen) = (Moments::default(), Unseen::default());
        for audit in &self.audits {
            let pixel = &self.pixels[audit.at];
            let squared = accuracy::of_audit(pixel.light(transfer), audit.halves(transfer));
            beyond.add(squared - accuracy::of_halves(pixel.halves(transfer)));
            unseen.note(pixel.n(), squared - noise.expected(audit.at, pixel.n()));
        }
        noise.add(&unseen, &self.pixels);
        let accuracy = accuracy::of_picture(&halves, &beyond);
        let factor = accuracy.mean_square * halves.n / expected;
        // Where nothing is expected, or all is by chance, expectations stand for themselves.
        let factor = if factor.is_finite() && factor > 0.0 { factor } else { 1.0 };
        State { accuracy, noise, factor, samples }
    }

    fn finish(self, state: State, rounds: Vec<f64>, end: End) -> Found<G> {
        let transfer = self.transfer();
        let complete = self.pixels.iter().all(|pixel| pixel.n() > 0);
        let error = |(at, pixel): (usize, &Pixel<G>)| {
            // Two halves say little about one pixel: what is expected of all like it counts for three more.
            let own = accuracy::of_halves(pixel.halves(transfer));
            (0.25 * (own + 3.0 * state.factor * state.noise.expected(at, pixel.n()))).sqrt() as f32
        };
        let layer = |name: &str, values: Vec<f32>| Layer {
            name: name.into(),
            is_color: false,
            channels: vec![("Y".into(), values)],
            attributes: Vec::new(),
        };
        let layers = vec![
            layer("error", self.pixels.iter().enumerate().map(error).collect()),
            layer("samples", self.pixels.iter().map(|pixel| (2 * pixel.n()) as f32).collect()),
        ];
        let progress = Progress { accuracy: state.accuracy, rounds, samples: state.samples, end };
        let film = Film::new(self.window, self.pixels.iter().map(Pixel::mean).collect());
        Found { film, statistics: self.statistics, complete, progress, layers }
    }
}

impl Audit {
    /// Linear light of each stream.
    fn halves(&self, transfer: Transfer) -> [Rgb; 2] {
        self.sums.map(|sum| pixel::linear(transfer, sum / self.n.max(1) as f32))
    }
}

/// Takes samples in a block until each pixel has what is wanted, by its column, row and what it has.
fn raise_block<G: Gather>(
    worker: &mut Worker<'_>,
    seed: u64,
    block: &Block,
    rows: &mut [&mut [Pixel<G>]],
    wanted: impl Fn(usize, usize, u32) -> u32,
) {
    // Of neighbours together, so that they share what they can.
    let (mut raised, mut samples) = (Vec::new(), Vec::new());
    for j in 0..block.height {
        for i in 0..block.width {
            let now = rows[j][i].n();
            let more = now..wanted(i, j, now);
            if more.is_empty() {
                continue;
            }
            for half in 0..2 {
                let stream = Stream::new(seed, block.x + i, block.y + j, Purpose::Picture(half));
                samples.extend(more.clone().map(|k| (stream, k)));
            }
            raised.push((i, j, more.len()));
            if samples.len() >= BATCH {
                extend(rows, &mut raised, &light(worker, &samples));
                samples.clear();
            }
        }
    }
    extend(rows, &mut raised, &light(worker, &samples));
}

/// Hands samples to the pixels for which they were taken: to each so many of its first stream, then of its second.
fn extend<G: Gather>(rows: &mut [&mut [Pixel<G>]], raised: &mut Vec<(usize, usize, usize)>, mut found: &[G]) {
    for (i, j, n) in raised.drain(..) {
        let (first, rest) = found.split_at(n);
        let (second, rest) = rest.split_at(n);
        rows[j][i].extend(first, second);
        found = rest;
    }
}

/// What samples of streams see, given by their numbers.
fn light<G: Gather>(worker: &mut Worker<'_>, samples: &[(Stream, u32)]) -> Vec<G> {
    match &worker.prepared.lens {
        Some(lens) => {
            let each = samples.iter();
            each.map(|(stream, k)| at_lens_point(worker, lens, stream.position(*k), stream.second_point(*k))).collect()
        }
        None => at_positions(worker, &samples.iter().map(|(stream, k)| stream.position(*k)).collect::<Vec<_>>()),
    }
}
