//! Sums of noise.

use super::{Call, int32, noise_argument, square};
use crate::math::noise::noise;
use std::sync::OnceLock;

impl Call<f64> {
    /// `f_hetero_mf` and `f_ridge`.
    pub(super) fn fractal_noise(&self, number: u32) -> f64 {
        let p = &self.p;
        let generator = noise_argument(p[5]);
        let at = |f: f64| noise(generator, self.point() * f);
        if number == 29 {
            let term = |i: i32| (2.0 * at(p[1].powi(i)) - 1.0 + p[3]) * p[1].powf(-p[0]).powi(i);
            let mut sum = 2.0 * at(1.0) - 1.0 + p[3];
            let mut i = 1;
            while f64::from(i) < p[2] {
                sum += term(i) * sum.powi(int32(p[4]).max(0.0) as i32);
                i += 1;
            }
            let rest = p[2] - int32(p[2]);
            return if rest == 0.0 { sum } else { sum + rest * sum * term(i) };
        }
        let ridge = |f: f64| (at(f) - p[4]).abs() / p[4].max(1.0 - p[4]) - p[3];
        let (mut value, mut total) = (ridge(1.0), 1.0);
        let whole = int32(p[1]).max(0.0) as i32;
        let mut add = |i: i32, share: f64| {
            let weight = p[2].powi(i - 1) * share;
            value += weight * ridge(p[0].powi(i - 1));
            total += weight;
        };
        (2..=whole).for_each(|i| add(i, 1.0));
        let rest = p[1] - f64::from(whole);
        if rest != 0.0 {
            add(whole.max(1) + 1, rest);
        }
        value / (p[3].max(1.0 - p[3]) * total)
    }

    pub(super) fn ridged(&self, spectrum: &OnceLock<Vec<f64>>) -> f64 {
        let p = &self.p;
        let generator = noise_argument(p[5]);
        let fold = |f: f64| square(p[3] - (2.0 * noise(generator, self.point() * f) - 1.0).abs());
        let n = p[2].clamp(0.0, 64.0).ceil() as i32; // octaves beyond are far below rounding
        let weights = spectrum.get_or_init(|| (0..=n).map(|i| p[1].powi(i).powf(-p[0])).collect());
        let mut signal = fold(1.0);
        let mut result = signal;
        for i in 1..n {
            let gain = (p[4] * signal).clamp(0.0, 1.0);
            signal = fold(p[1].powi(i)) * gain;
            // POV-Ray reads past its table where a later call has more octaves; we go on with fresh weights.
            let weight = weights.get(i as usize).copied().unwrap_or_else(|| p[1].powi(i).powf(-p[0]));
            result += weight * signal;
        }
        result
    }
}
