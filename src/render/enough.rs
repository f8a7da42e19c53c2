//! When samples are enough: every rule by which sampling goes on or stops.
//!
//! [`Contrast`] refines pixels that differ from their neighbours (antialiasing), [`Confidence`] stops when a mean is
//! known well enough (focal blur), [`corners_agree`] spares what lies between samples that agree (area lights).
//!
//! Source: sections 2 and 3 of the camera facts, section 3.5 of the shading facts (measured).

use super::radiance::Radiance;
use crate::compiled::Transfer;
use crate::math::Rgb;
use std::cell::OnceCell;
use std::f64::consts::PI;

/// POV-Ray's largest difference of neighbouring samples of an area light between which nothing is looked at.
const AREA_THRESHOLD: f32 = 0.1;

/// From which difference on neighbouring samples are not enough.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contrast {
    /// Sum of the differences of the channels, 0 to 1.
    pub(super) threshold: f64,
    /// The power of light that is compared.
    pub(super) exponent: f32,
    /// From the scene's working values to linear light.
    pub(super) transfer: Transfer,
}

/// A sample that is compared with others.
#[derive(Clone, Debug)]
pub(super) struct Compared {
    light: Radiance,
    /// Its colour where colours are compared, once somebody has asked: powers are dear.
    display: OnceCell<Rgb>,
}

impl From<Radiance> for Compared {
    fn from(light: Radiance) -> Self {
        Self { light, display: OnceCell::new() }
    }
}

impl Contrast {
    /// Whether two samples differ.
    pub(super) fn differ(&self, a: &Compared, b: &Compared) -> bool {
        // Most neighbours agree exactly.
        if a.light == b.light {
            return self.threshold <= 0.0;
        }
        let d = (self.display(a) - self.display(b)).abs();
        let transparency = (a.light.transparency - b.light.transparency).abs();
        f64::from(d.x + d.y + d.z + transparency) >= self.threshold
    }

    fn display(&self, sample: &Compared) -> Rgb {
        let of = |v: f32| self.transfer.linear(v).max(0.0).powf(self.exponent);
        *sample.display.get_or_init(|| sample.light.rgb.map(of))
    }
}

/// Whether four samples of an area light, in rows, say enough about what lies between them.
pub(super) fn corners_agree(values: &[Rgb; 4]) -> bool {
    let differ = |a: usize, b: usize| {
        let d = (values[a] - values[b]).abs();
        d.x + d.y + d.z > AREA_THRESHOLD
    };
    !(differ(0, 1) || differ(2, 3) || differ(0, 2) || differ(1, 3))
}

/// Sums over samples: how many, of each channel and of its square.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    n: usize,
    sums: [[f64; 2]; 4],
}

impl Moments {
    /// Counts a sample.
    pub(super) fn add(&mut self, light: &Radiance) {
        let values = [light.rgb.x, light.rgb.y, light.rgb.z, light.transparency];
        for (s, v) in self.sums.iter_mut().zip(values.map(f64::from)) {
            *s = [s[0] + v, s[1] + v * v];
        }
        self.n += 1;
    }

    /// How many samples there are.
    pub(super) fn n(&self) -> usize {
        self.n
    }

    /// Variance of the mean of each channel.
    fn variances(&self) -> [f64; 4] {
        let count = self.n as f64;
        self.sums.map(|s| (s[1] / count - (s[0] / count).powi(2)) / count)
    }
}

/// Stops sampling when the variance of the mean is small, by a chi-square test.
#[derive(Clone, Debug)]
pub(super) struct Confidence {
    min_samples: usize,
    /// Variances below which sampling stops, by sample count.
    thresholds: Vec<f64>,
}

impl Confidence {
    /// For at most `n` samples.
    pub(super) fn new(n: usize, min_samples: usize, confidence: f64, variance: f64) -> Self {
        let quantile = |nu: usize| stopping_quantile(nu, confidence);
        let last = quantile(n.saturating_sub(1));
        let threshold = |nu: usize| if n <= 1 { 0.0 } else { variance * quantile(nu) / last };
        Self { min_samples, thresholds: (0..=n).map(threshold).collect() }
    }

    /// Whether no more samples are wanted.
    pub(super) fn is_reached(&self, moments: &Moments) -> bool {
        let threshold = self.thresholds[moments.n];
        moments.n >= self.min_samples && moments.variances().iter().all(|v| *v < threshold)
    }
}

/// Sizes of batches after which sampling may stop.
pub(super) fn batches(n: usize) -> Vec<usize> {
    let first: &[usize] = match n {
        0..7 => &[],
        7..19 => &[7],
        19..37 => &[7, 6, 6],
        _ => &[7, 6, 6, 4, 4, 4, 4, 2],
    };
    let mut left = n - first.iter().sum::<usize>();
    let mut sizes = first.to_vec();
    while left > 0 {
        sizes.push(left.min(4));
        left -= left.min(4);
    }
    sizes
}

/// Chi-square quantile with POV-Ray's tail: its series for odd degrees up to 25 is off by a factor.
pub(super) fn stopping_quantile(degrees: usize, confidence: f64) -> f64 {
    let odd = degrees % 2 == 1 && degrees <= 25;
    let tail = (1.0 - confidence) * if odd { 1.040_362_905_3 } else { 1.0 };
    if degrees == 0 { 0.0 } else { chi_square_quantile(degrees as f64, tail) }
}

/// The value below which a share `p` of a chi-square distribution lies, by bisection.
fn chi_square_quantile(degrees: f64, p: f64) -> f64 {
    let (mut low, mut high) = (0.0, degrees + 20.0 * (2.0 * degrees).sqrt() + 50.0);
    // Sixty halvings exhaust double precision.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if regularised_gamma(0.5 * degrees, 0.5 * middle) < p { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Regularised lower incomplete gamma function for half-integral `a`, by its series.
///
/// Source: Abramowitz and Stegun, 6.5.29.
fn regularised_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let mut log_gamma = if a.fract() == 0.0 { 0.0 } else { PI.sqrt().ln() };
    let mut b = if a.fract() == 0.0 { 1.0 } else { 0.5 };
    while b < a {
        log_gamma += f64::ln(b);
        b += 1.0;
    }
    let (mut term, mut sum, mut k) = (1.0 / a, 1.0 / a, a);
    while term > sum * f64::EPSILON {
        k += 1.0;
        term *= x / k;
        sum += term;
    }
    (sum.ln() + a * x.ln() - x - log_gamma).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(degrees: f64, tail: f64, expected: f64) {
        let found = chi_square_quantile(degrees, tail);
        assert!((found - expected).abs() < 1e-7, "{found} instead of {expected}");
    }

    #[test]
    fn quantiles_are_those_that_stop_povray() {
        check(36.0, 0.5, 35.335_572_8);
        assert!((stopping_quantile(7, 0.9) - 2.879_020_015_6).abs() < 1e-7);
        assert!((stopping_quantile(13, 0.5) - 12.591_729_637_6).abs() < 1e-7);
    }

    #[test]
    fn batches_hold_all_samples() {
        [1, 4, 6, 7, 10, 19, 25, 37, 50, 200].iter().for_each(|&n| assert_eq!(batches(n).iter().sum::<usize>(), n));
    }

    #[test]
    fn equal_samples_are_enough_and_different_ones_are_not() {
        let confidence = Confidence::new(20, 4, 0.9, 1e-4);
        let moments = |values: [f32; 4]| {
            let mut moments = Moments::default();
            values.iter().for_each(|v| moments.add(&Radiance::opaque(Rgb::splat(*v))));
            moments
        };
        assert!(confidence.is_reached(&moments([0.5; 4])));
        assert!(!confidence.is_reached(&moments([0.0, 1.0, 0.0, 1.0])));
    }
}
