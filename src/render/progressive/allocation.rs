//! Which pixels get more samples.
//!
//! The error of n evenly spread samples falls as n^(-3/4) where an edge crosses the pixel, so its square is v n^(-3/2)
//! for samples of variance v. Twice as many take 0.65 v n^(-3/2) off it for n more: each is worth about v n^(-5/2). A
//! round goes on wherever a sample is worth more than the round's limit, so all are worth the same in the end, which is
//! the best that a sum of errors can get for its samples.
//!
//! Source: D. P. Mitchell, "Consequences of Stratified Sampling in Graphics", SIGGRAPH 1996 (the exponent); Neyman
//! allocation, W. G. Cochran, "Sampling Techniques", chapter 5.

use super::accuracy::Moments;
use super::pixel::Pixel;
use crate::compiled::Transfer;
use crate::math::Rgb;
use crate::render::film::Gather;
use rayon::prelude::*;

/// Most samples in each stream of a pixel, as a power of two.
const MAX_LEVEL: u32 = 13;
/// How much the neighbourhood says about a pixel, in samples: its own two say little.
const PRIOR: f32 = 2.0;
/// Powers of two by which a pixel's samples grow in one round at most: with few, little is known of what is there.
const MAX_GROWTH: u32 = 2;
/// Audits in a class below which they say nothing about it.
const ENOUGH_AUDITS: f64 = 32.0;
/// Pixels that are counted together.
const CHUNK: usize = 4096;

/// Variance of a single sample in each pixel, linear light.
pub(super) struct Noise {
    variances: Vec<f32>,
}

/// What a limit would bring.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Plan {
    /// Worth of a sample below which no more are taken.
    pub(super) limit: f64,
    /// Samples that the next round adds.
    pub(super) samples: u64,
    /// Sum over the pixels of the squared errors that are expected once all are taken that are worth it, but for a
    /// factor.
    pub(super) squared_errors: f64,
}

/// What audits have found beyond what was expected, by level: variance that no sample has shown.
#[derive(Clone, Debug, Default)]
pub(super) struct Unseen([Moments; MAX_LEVEL as usize + 1]);

impl Unseen {
    /// Notes what was found beyond expectation, as squared error, in a pixel of so many samples in each stream.
    pub(super) fn note(&mut self, n: u32, beyond: f64) {
        self.0[level(n) as usize].add(beyond);
    }

    /// As variance of a single sample.
    fn variance(&self, n: u32) -> f32 {
        let class = &self.0[level(n) as usize];
        if class.n < ENOUGH_AUDITS { 0.0 } else { (class.mean() * f64::from(2 * n).powf(1.5)).max(0.0) as f32 }
    }
}

impl Noise {
    /// From the samples of each pixel and of its neighbours.
    ///
    /// Neighbours tell by how much their own samples differ, and by how much the pixel bends away from the line between
    /// them: an edge that no pixel has within itself.
    pub(super) fn of<G: Gather>(pixels: &[Pixel<G>], width: usize, transfer: Transfer) -> Self {
        let height = pixels.len() / width.max(1);
        let row = |y: usize| {
            (0..width).map(move |x| {
                let pixel = &pixels[y * width + x];
                let prior = pooled(pixels, width, x, y).max(contrast(pixels, width, x, y));
                let (own, freedom) = pixel.variance();
                let variance = (own * freedom + prior * PRIOR) / (freedom + PRIOR);
                let variance = variance * slope(transfer, pixel.working()).powi(2);
                // No sample mends what is no number.
                if variance.is_finite() { variance } else { 0.0 }
            })
        };
        Self { variances: (0..height).into_par_iter().flat_map_iter(row).collect() }
    }

    /// Adds what audits have found to all pixels like those.
    pub(super) fn add<G: Gather>(&mut self, unseen: &Unseen, pixels: &[Pixel<G>]) {
        let by_level: Vec<f32> = (0..=MAX_LEVEL).map(|level| unseen.variance(1 << level)).collect();
        let all = self.variances.par_iter_mut().zip(pixels);
        all.for_each(|(variance, pixel)| *variance += by_level[level(pixel.n()) as usize]);
    }

    /// Squared error that is expected of a pixel as it is, but for a factor.
    pub(super) fn expected(&self, at: usize, n: u32) -> f64 {
        f64::from(self.variances[at]) * decay(level(n))
    }

    /// Samples that a pixel has in each stream after a round that takes all that are worth more than a limit.
    pub(super) fn wanted(&self, at: usize, n: u32, limit: f64) -> u32 {
        let now = level(n);
        let level = level_for(self.variances[at].log2(), limit.log2() as f32);
        n.max(1 << level.clamp(now, now + MAX_GROWTH))
    }

    /// What limits would bring.
    pub(super) fn plans<G: Gather>(&self, pixels: &[Pixel<G>], limits: &[f64]) -> Vec<Plan> {
        let logs: Vec<f32> = limits.iter().map(|limit| limit.log2() as f32).collect();
        let part = |(chunk, some): (usize, &[Pixel<G>])| {
            let mut plans = vec![Plan::default(); limits.len()];
            for (pixel, variance) in some.iter().zip(&self.variances[chunk * CHUNK..]) {
                let (now, log_variance, variance) = (level(pixel.n()), variance.log2(), f64::from(*variance));
                for (plan, log) in plans.iter_mut().zip(&logs) {
                    let level = level_for(log_variance, *log).max(now);
                    let next = level.min(now + MAX_GROWTH);
                    plan.samples += 2 * ((1 << next) - (1 << now));
                    plan.squared_errors += variance * decay(level);
                }
            }
            plans
        };
        let parts: Vec<Vec<Plan>> = pixels.par_chunks(CHUNK).enumerate().map(part).collect();
        let mut plans: Vec<Plan> = limits.iter().map(|limit| Plan { limit: *limit, ..Plan::default() }).collect();
        for part in parts {
            for (sum, one) in plans.iter_mut().zip(part) {
                sum.samples += one.samples;
                sum.squared_errors += one.squared_errors;
            }
        }
        plans
    }
}

/// The level at which a sample is worth no more than a limit, from the logarithms of variance and limit.
fn level_for(log_variance: f32, log_limit: f32) -> u32 {
    (0.4 * (log_variance - log_limit) - 1.0).ceil().clamp(0.0, MAX_LEVEL as f32) as u32
}

/// The power of two that the samples in each stream are.
fn level(n: u32) -> u32 {
    n.max(1).ilog2()
}

/// The share of a single sample's variance that is the squared error of all samples at a level.
fn decay(level: u32) -> f64 {
    (-1.5 * f64::from(level + 1)).exp2()
}

/// Variance of single samples in a pixel and its eight neighbours, each about its own pixel's mean.
fn pooled<G: Gather>(pixels: &[Pixel<G>], width: usize, x: usize, y: usize) -> f32 {
    let height = pixels.len() / width;
    let (mut sum, mut weight) = (0.0, 0.0);
    for row in y.saturating_sub(1)..(y + 2).min(height) {
        for pixel in &pixels[row * width..][x.saturating_sub(1)..(x + 2).min(width)] {
            let (variance, freedom) = pixel.variance();
            sum += variance * freedom;
            weight += freedom;
        }
    }
    sum / weight
}

/// Variance that an edge between pixels would have in one of them, if there is one: a step is seen as a bend of the
/// values of three pixels in a row, and half of it is how far samples would be from their mean.
fn contrast<G: Gather>(pixels: &[Pixel<G>], width: usize, x: usize, y: usize) -> f32 {
    let (height, at) = (pixels.len() / width, y * width + x);
    let bend = |before: usize, after: usize| {
        let bend = 2.0 * pixels[at].working() - pixels[before].working() - pixels[after].working();
        bend.dot(bend) / 3.0
    };
    let across = if x > 0 && x + 1 < width { bend(at - 1, at + 1) } else { 0.0 };
    let along = if y > 0 && y + 1 < height { bend(at - width, at + width) } else { 0.0 };
    0.25 * across.max(along)
}

/// Slope of the curve from working values to linear light at a colour: what small differences are multiplied by.
fn slope(transfer: Transfer, working: Rgb) -> f32 {
    if transfer == Transfer::Linear {
        return 1.0;
    }
    /// Small for a display, and large beside the rounding of single precision.
    const STEP: f32 = 1e-2;
    let middle = (working.x + working.y + working.z).max(0.0) / 3.0;
    (transfer.linear(middle + STEP) - transfer.linear(middle)) / STEP
}
