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
    /// The pixel that is furthest off.
    pub worst: Worst,
    /// Whether every value of both pictures is finite.
    pub finite: bool,
}

/// A pixel and how far off it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// Its column.
    pub x: usize,
    /// Its row.
    pub y: usize,
    /// Root of the mean squared difference of its three linear values.
    pub error: f64,
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
        worst: worst(reference, image),
        finite: pairs().all(|(a, b)| a[..3].iter().chain(&b[..3]).all(|v| v.is_finite())),
    })
}

/// The first of the pixels that are furthest off; what is not a number is as far as can be.
fn worst(reference: &Picture, image: &Picture) -> Worst {
    let square = |a: &[f32; 4], b: &[f32; 4]| -> f64 {
        let sum: f64 = (0..3).map(|i| f64::from(a[i] - b[i]).powi(2)).sum();
        if sum.is_nan() { f64::INFINITY } else { sum }
    };
    let mut worst = (0, 0.0);
    for (i, (a, b)) in reference.pixels.iter().zip(&image.pixels).enumerate() {
        let here = square(a, b);
        if here > worst.1 {
            worst = (i, here);
        }
    }
    let width = reference.width.max(1);
    Worst { x: worst.0 % width, y: worst.0 / width, error: (worst.1 / 3.0).sqrt() }
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
    fn the_worst_pixel_is_found() {
        let reference = Picture::filled(4, 3, [0.5, 0.5, 0.5, 1.0]);
        let mut image = reference.clone();
        (image.pixels[2], image.pixels[7]) = ([0.6, 0.5, 0.5, 1.0], [0.5, 0.2, 0.5, 0.0]);
        let worst = compare(&reference, &image).unwrap().worst;
        assert_eq!((worst.x, worst.y), (3, 1));
        assert!((worst.error - 0.3 / 3f64.sqrt()).abs() < 1e-6, "{worst:?}");
        image.pixels[0][1] = f32::NAN;
        assert_eq!(compare(&reference, &image).unwrap().worst, Worst { x: 0, y: 0, error: f64::INFINITY });
    }

    #[test]
    fn sizes_must_agree() {
        assert!(compare(&Picture::filled(2, 2, [0.0; 4]), &Picture::filled(2, 3, [0.0; 4])).is_err());
    }
}
