//! How far a picture is from the truth: an estimate that holds whatever decided where samples were taken.
//!
//! The squared error of a pixel that is the mean of two independent streams A and B is (A - B)²/4, on average. But who
//! gets more samples is decided by those that are there, so pixels that look right by chance are left alone: that mean is
//! too small. Therefore one pixel in sixteen, chosen by its position alone, is audited: two more streams C and D, which
//! decide nothing, give (P - C)(P - D) for its value P. Its mean is the squared error of P, exactly, however P came about,
//! as C and D are right on average and independent of P and of one another. What both ways of asking differ by on the
//! audited pixels corrects the mean of the first way over all pixels.
//!
//! Space: linear light; errors are taken over pixels and colour channels alike.
//! Source: control variates by difference, W. G. Cochran, "Sampling Techniques", chapter 7; independent replicates for
//! randomised sequences, A. B. Owen, arXiv 2501.00150.

use crate::math::Rgb;

/// What is known about the error of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Mean squared error, estimated; rarely below 0 where it is next to 0.
    pub mean_square: f64,
    /// Standard deviation of that estimate.
    pub deviation: f64,
}

impl Accuracy {
    /// Root mean square error over pixels and channels, linear light.
    pub fn rmse(&self) -> f64 {
        self.mean_square.max(0.0).sqrt()
    }

    /// What the root mean square error is below, but for one case in so many as `deviations` of a normal distribution
    /// say.
    pub fn upper_rmse(&self, deviations: f64) -> f64 {
        (self.mean_square + deviations * self.deviation).max(0.0).sqrt()
    }

    /// How far [`rmse`](Self::rmse) may be off, one standard deviation.
    pub fn uncertainty(&self) -> f64 {
        self.upper_rmse(1.0) - self.rmse()
    }
}

/// Squared error of the mean of two halves.
pub(super) fn of_halves([a, b]: [Rgb; 2]) -> f64 {
    let d = (a - b).as_dvec3();
    d.dot(d) / 12.0
}

/// Squared error of a pixel as two further streams see it; right on average, below 0 at times.
pub(super) fn of_audit(pixel: Rgb, [c, d]: [Rgb; 2]) -> f64 {
    (pixel - c).as_dvec3().dot((pixel - d).as_dvec3()) / 3.0
}

/// Sums for a mean and its variance.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    pub(super) n: f64,
    sum: f64,
    squares: f64,
}

impl Moments {
    pub(super) fn add(&mut self, value: f64) {
        self.n += 1.0;
        self.sum += value;
        self.squares += value * value;
    }

    #[must_use]
    pub(super) fn plus(self, other: Self) -> Self {
        Self { n: self.n + other.n, sum: self.sum + other.sum, squares: self.squares + other.squares }
    }

    pub(super) fn mean(&self) -> f64 {
        if self.n > 0.0 { self.sum / self.n } else { 0.0 }
    }

    /// Variance of the mean.
    fn variance_of_mean(&self) -> f64 {
        if self.n < 2.0 { 0.0 } else { (self.squares / self.n - self.mean().powi(2)).max(0.0) / (self.n - 1.0) }
    }
}

/// The picture's error, from the halves of all pixels and from what audits find beyond that.
pub(super) fn of_picture(halves: &Moments, beyond: &Moments) -> Accuracy {
    let audited = if halves.n > 0.0 { beyond.n / halves.n } else { 0.0 };
    // Where all pixels are audited nothing is left to chance but the audits' own samples; the terms are of like size.
    let variance = halves.variance_of_mean() + (1.0 - audited).max(0.0) * beyond.variance_of_mean();
    Accuracy { mean_square: halves.mean() + beyond.mean(), deviation: variance.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_and_audits_have_the_error_as_mean() {
        assert_eq!(of_halves([Rgb::ZERO, Rgb::splat(2.0)]), 1.0);
        assert_eq!(of_audit(Rgb::splat(1.0), [Rgb::ZERO, Rgb::splat(3.0)]), -2.0);
        let mut halves = Moments::default();
        [1.0, 3.0].iter().for_each(|v| halves.add(*v));
        let accuracy = of_picture(&halves, &Moments::default());
        assert_eq!((accuracy.mean_square, accuracy.deviation), (2.0, 1.0));
    }
}
