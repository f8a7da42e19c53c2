//! When samples of a part of a medium are enough.
//!
//! Source: `docs/povray/media.md`, section 5 (measured).

use crate::compiled::medium::Sampling;
use crate::render::enough::stopping_quantile;

/// Numbers of samples up to which limits are worked out once; beyond, when they are asked for.
const MOST_REMEMBERED: u32 = 1000;

/// The variances of the mean below which sampling stops, by the number of samples.
#[derive(Clone, Debug)]
pub(in crate::render) struct Settling {
    confidence: f64,
    /// Variance over the quantile for all samples.
    unit: f64,
    known: Vec<f64>,
}

impl Settling {
    pub(in crate::render) fn new(sampling: &Sampling) -> Self {
        let Sampling { min_samples, max_samples, confidence, variance, .. } = *sampling;
        let varies = max_samples > min_samples;
        let unit = if varies { variance / stopping_quantile(max_samples as usize - 1, confidence) } else { 0.0 };
        let n = if varies { max_samples.saturating_add(1).min(MOST_REMEMBERED) } else { 0 };
        let known = (0..n).map(|k| unit * stopping_quantile(k as usize, confidence)).collect();
        Self { confidence, unit, known }
    }

    pub(super) fn threshold(&self, n: u32) -> f64 {
        let known = self.known.get(n as usize).copied();
        known.unwrap_or_else(|| self.unit * stopping_quantile(n as usize, self.confidence))
    }
}
