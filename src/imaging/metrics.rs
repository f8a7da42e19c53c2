//! How much two pictures differ, in the measures of our sample judge.

use super::{ImageError, Picture, flip, srgb_from_linear};

/// Figures of a comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Mean over pixels of the largest channel difference, in display values 0 to 255.
    pub mean_display: f64,
    /// Root of the mean squared difference of linear values.
    pub rmse: f64,
    /// `rmse` relative to the first picture's root mean square.
    pub relative_rmse: f64,
    /// Share of pixels within 2, 8 and 24 of 255.
    pub within: [f64; 3],
    /// Mean perceived difference, 0 to 1 (see [`flip`]).
    pub flip: f64,
    /// Whether every value of both pictures is finite.
    pub finite: bool,
}

/// One word for a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// 99.5 % of pixels within 2 and a mean of at most 0.25.
    Same,
    /// 98 % of pixels within 8 and a mean of at most 1.
    Close,
    /// 90 % of pixels within 24 and a mean of at most 6.
    Alike,
    /// Anything else, and whatever is not finite.
    Differs,
}

impl Difference {
    /// The first verdict that holds.
    pub fn verdict(&self) -> Verdict {
        let limits = [(0.995, 0.25, Verdict::Same), (0.98, 1.0, Verdict::Close), (0.90, 6.0, Verdict::Alike)];
        let holds = |i: usize| self.finite && self.within[i] >= limits[i].0 && self.mean_display <= limits[i].1;
        (0..3).find(|&i| holds(i)).map_or(Verdict::Differs, |i| limits[i].2)
    }
}

/// Display value 0 to 255 of linear light, clamped.
fn display(linear: f32) -> f64 {
    255.0 * f64::from(srgb_from_linear(linear.clamp(0.0, 1.0)))
}

/// Largest channel difference of two pixels in display values.
pub(super) fn display_distance(a: &[f32; 4], b: &[f32; 4]) -> f64 {
    (0..3).map(|i| (display(a[i]) - display(b[i])).abs()).fold(0.0, f64::max)
}

/// Compares `image` with `reference`; alpha and layers are not looked at.
///
/// # Errors
/// [`ImageError::SizeMismatch`].
pub fn compare(reference: &Picture, image: &Picture) -> Result<Difference, ImageError> {
    let sizes = ([reference.width, reference.height], [image.width, image.height]);
    if sizes.0 != sizes.1 {
        return Err(ImageError::SizeMismatch(sizes.0, sizes.1));
    }
    let n = reference.pixels.len().max(1) as f64;
    let pairs = || reference.pixels.iter().zip(&image.pixels);
    let distances: Vec<f64> = pairs().map(|(a, b)| display_distance(a, b)).collect();
    let within = [2.0, 8.0, 24.0].map(|limit| distances.iter().filter(|d| **d <= limit).count() as f64 / n);
    let squares = |f: fn(f32, f32) -> f32| -> f64 {
        let sum: f64 = pairs().map(|(a, b)| (0..3).map(|i| f64::from(f(a[i], b[i])).powi(2)).sum::<f64>()).sum();
        sum / (3.0 * n)
    };
    let (error, power) = (squares(|a, b| a - b), squares(|a, _| a));
    Ok(Difference {
        mean_display: distances.iter().sum::<f64>() / n,
        rmse: error.sqrt(),
        // A black reference has no scale; the floor keeps the quotient finite, as in the judge.
        relative_rmse: (error / power.max(1e-12)).sqrt(),
        within,
        flip: flip(reference, image).iter().map(|&e| f64::from(e)).sum::<f64>() / n,
        finite: pairs().all(|(a, b)| a[..3].iter().chain(&b[..3]).all(|v| v.is_finite())),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(a: f32, b: f32, verdict: Verdict) {
        let (a, b) = (Picture::filled(8, 8, [a, a, a, 1.0]), Picture::filled(8, 8, [b, b, b, 1.0]));
        assert_eq!(compare(&a, &b).unwrap().verdict(), verdict);
    }

    #[test]
    fn verdicts_follow_the_judge() {
        check(0.5, 0.5, Verdict::Same);
        check(0.5, 0.503, Verdict::Close);
        check(0.5, 0.52, Verdict::Alike);
        check(0.5, 0.6, Verdict::Differs);
        check(2.0, 3.0, Verdict::Same);
        check(0.5, f32::NAN, Verdict::Differs);
    }

    #[test]
    fn sizes_must_agree() {
        assert!(compare(&Picture::filled(2, 2, [0.0; 4]), &Picture::filled(2, 3, [0.0; 4])).is_err());
    }
}
