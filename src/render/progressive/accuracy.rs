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
    number(d.dot(d) / 12.0)
}

/// Squared error of a pixel as two further streams see it; right on average, below 0 at times.
pub(super) fn of_audit(pixel: Rgb, [c, d]: [Rgb; 2]) -> f64 {
    number((pixel - c).as_dvec3().dot((pixel - d).as_dvec3()) / 3.0)
}

/// Light that is no number is wrong by no amount that samples could mend.
fn number(v: f64) -> f64 {
    if v.is_finite() { v } else { 0.0 }
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
///
/// What they find is mostly small and as uncertain as it is large: it counts as far as it stands out of its noise. An
/// estimate that is shrunk so errs less than the bare sum.
pub(super) fn of_picture(halves: &Moments, beyond: &Moments) -> Accuracy {
    let (found, doubt) = (beyond.mean(), beyond.variance_of_mean());
    let weight = if found > 0.0 { found * found / (found * found + doubt) } else { 0.0 };
    let variance = halves.variance_of_mean() + weight * doubt;
    Accuracy { mean_square: halves.mean() + weight * found, deviation: variance.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::super::stream::{Purpose, Stream};
    use super::*;

    /// What light is at a place of a pixel, whose square goes from -1/2 to 1/2.
    type Integrand = fn(f64, f64) -> f64;

    /// Integrands with their means.
    const INTEGRANDS: [(Integrand, f64); 5] = [
        // Half-planes: the first cuts two opposite sides of the square, the second a corner with legs of 0.4 and 0.8.
        (|x, y| f64::from(u8::from(x + 0.3 * y < 0.1)), 0.6),
        (|x, y| f64::from(u8::from((x + 0.5) / 0.4 + (y + 0.5) / 0.8 < 1.0)), 0.16),
        // A disc of radius 0.4.
        (|x, y| f64::from(u8::from(x * x + y * y < 0.16)), 0.16 * std::f64::consts::PI),
        // A checkered plane towards its horizon: so many squares in the pixel that they are in balance.
        (|x, y| ((1e4 * x).floor() + (1e4 * y).floor()).rem_euclid(2.0), 0.5),
        // Waves of two frequencies, whose means over whole periods vanish.
        (
            |x, y| 0.5 + 0.3 * (62.831_853_071_795_86 * x).sin() + 0.2 * (12.566_370_614_359_172 * (x + 2.0 * y)).cos(),
            0.5,
        ),
    ];

    /// Means of so many points of a pixel's streams, one pixel of 10,000 after the other.
    fn means(f: Integrand, n: u32, purpose: Purpose) -> impl Iterator<Item = f64> {
        (0..10_000).map(move |seed| {
            let stream = Stream::new(seed, 0, 0, purpose);
            let sum: f64 = (0..n).map(|i| stream.position(i)).map(|[x, y]| f(x, y)).sum();
            sum / f64::from(n)
        })
    }

    /// Whether a mean of estimates is that of what they estimate, within four standard deviations of the difference.
    fn agrees(differences: &Moments) -> bool {
        differences.mean().abs() <= 4.0 * differences.variance_of_mean().sqrt()
    }

    /// What estimates are off by, over 10,000 pixels: by halves, and by audits.
    fn check(f: Integrand, truth: f64, n: u32, factor: f64) -> [Moments; 2] {
        let [a, b] = [0, 1].map(|half| means(f, n, Purpose::Picture(half)));
        let [c, d] = [0, 1].map(|half| means(f, n, Purpose::Audit(half)));
        let gray = |v: f64| Rgb::splat(v as f32);
        let mut off = [Moments::default(); 2];
        for (((a, b), c), d) in a.zip(b).zip(c).zip(d) {
            let mean = 0.5 * (a + b);
            let error = (mean - truth).powi(2);
            off[0].add(factor * of_halves([gray(a), gray(b)]) - error);
            off[1].add(factor * of_audit(gray(mean), [gray(c), gray(d)]) - error);
        }
        off
    }

    #[test]
    fn estimates_are_right_on_average() {
        for (i, (f, truth)) in INTEGRANDS.into_iter().enumerate() {
            for n in [1, 4, 16] {
                let off = check(f, truth, n, 1.0);
                assert!(off.iter().all(agrees), "integrand {i}, {n} points: {off:?}");
            }
        }
    }

    #[test]
    fn half_of_the_estimate_would_be_found_out() {
        for (f, truth) in INTEGRANDS {
            assert!(!check(f, truth, 4, 0.25).iter().all(agrees));
        }
    }

    #[test]
    fn the_truth_lies_between_the_halves_half_of_the_time() {
        // As for any two independent values with a symmetric distribution about it, which that of a sum over many points
        // of waves nearly has. The standard deviation of 10,000 throws is 50.
        let (f, truth) = INTEGRANDS[4];
        let [a, b] = [0, 1].map(|half| means(f, 16, Purpose::Picture(half)));
        let between = a.zip(b).filter(|(a, b)| (a - truth) * (b - truth) <= 0.0).count();
        assert!((4_800..5_200).contains(&between), "{between} of 10000");
    }

    #[test]
    fn halves_and_audits_add_up() {
        assert_eq!(of_halves([Rgb::ZERO, Rgb::splat(2.0)]), 1.0);
        assert_eq!(of_audit(Rgb::splat(1.0), [Rgb::ZERO, Rgb::splat(3.0)]), -2.0);
        let (mut halves, mut beyond) = (Moments::default(), Moments::default());
        [1.0, 3.0].iter().for_each(|v| halves.add(*v));
        let accuracy = of_picture(&halves, &beyond);
        assert_eq!((accuracy.mean_square, accuracy.deviation), (2.0, 1.0));
        // A correction without any doubt counts in full, one that is all doubt not at all.
        [0.5, 0.5].iter().for_each(|v| beyond.add(*v));
        assert_eq!(of_picture(&halves, &beyond).mean_square, 2.5);
        [9.0, -10.0].iter().for_each(|v| beyond.add(*v));
        assert_eq!(of_picture(&halves, &beyond).mean_square, 2.0);
    }
}
