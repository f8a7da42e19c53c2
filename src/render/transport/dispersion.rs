//! Colours of wavelengths.
//!
//! Source: section 8.4 of the shading facts (measured).

use crate::math::Rgb;
use std::sync::LazyLock;

/// Wavelength of the table's first entry and distance of entries, in nm.
const FIRST: f64 = 375.0;
const STEP: f64 = 5.0;
/// Entries of the table.
const N: usize = 74;
/// The band that white light is split into, in nm.
const LOW: f64 = 380.0;
const WIDTH: f64 = 350.0;
/// Wavelength at which the index of refraction is as given.
const MIDDLE: f64 = 555.0;

/// Share of each channel below a wavelength, rounded as POV-Ray's table is.
static SHARES: LazyLock<Vec<[f64; 3]>> = LazyLock::new(|| {
    let mut sums = vec![[0.0; 3]];
    for k in 1..N {
        let h = 0.03 + 0.934 * (STEP * k as f64) / 365.0;
        let red = 1.15 - (5.0 * (h - 0.75)).powi(2);
        let red = if red < 0.0 { (0.12 - (4.0 * (h - 0.12)).powi(2)).max(0.0) } else { red };
        let green = (0.97 * (1.1 - (4.5 * (h - 0.57)).powi(2))).max(0.0);
        let blue = (0.98 * (1.0 - (4.0 * (h - 0.28)).powi(2))).max(0.0);
        let last: [f64; 3] = sums[k - 1];
        sums.push([last[0] + red, last[1] + green, last[2] + blue]);
    }
    let total = sums[N - 1];
    let rounded = |v: f64| (v * 1e4).round() / 1e4;
    sums.iter().map(|s| std::array::from_fn(|c| rounded(s[c] / total[c]))).collect()
});

fn shares_below(wavelength: f64) -> [f64; 3] {
    let position = ((wavelength - FIRST) / STEP).clamp(0.0, (N - 1) as f64);
    let k = (position as usize).min(N - 2);
    let t = position - k as f64;
    std::array::from_fn(|c| SHARES[k][c] + t * (SHARES[k + 1][c] - SHARES[k][c]))
}

/// Middle wavelength of a band in nm, and its colour; all bands together are nearly white.
pub(super) fn band(index: u32, n: u32) -> (f64, Rgb) {
    let width = WIDTH / f64::from(n);
    let middle = LOW + width * (f64::from(index) + 0.5);
    let (low, high) = (shares_below(middle - 0.5 * width), shares_below(middle + 0.5 * width));
    let channel = |c: usize| (f64::from(n) * (high[c] - low[c])) as f32;
    (middle, Rgb::new(channel(0), channel(1), channel(2)))
}

/// Ratio of indices at a wavelength.
pub(super) fn index_ratio(eta: f64, dispersion: f64, wavelength: f64) -> f64 {
    eta * dispersion.powf(-(wavelength - MIDDLE) / WIDTH)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(index: u32, expected: [f32; 3]) {
        let (_, hue) = band(index, 7);
        assert!((hue - Rgb::from(expected)).abs().max_element() < 2e-4, "{hue} instead of {expected:?}");
    }

    #[test]
    fn bands_have_povrays_hues() {
        check(0, [0.2555, 0.0, 1.4329]);
        check(1, [0.0210, 0.0, 2.5655]);
        check(3, [0.0686, 2.5284, 0.6860]);
        check(5, [2.9169, 1.0542, 0.0]);
        check(6, [1.7990, 0.0, 0.0]);
    }
}
