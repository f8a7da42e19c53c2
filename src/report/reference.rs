//! The picture that errors are against, and how wrong it is itself.

use crate::imaging::{Picture, compare, read_exr};
use std::path::Path;

/// A picture that is far finer than any rung.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Its pixels.
    pub picture: Picture,
    /// Where it comes from, in words.
    pub origin: String,
    /// Its own RMSE, where that is known.
    pub error: Option<f64>,
}

/// What makes each of the two halves: samples of a seed of its own until the error is small, or for a while.
const HALVES: [[&str; 6]; 2] = [
    ["--target-error", "0.002", "--seed", "1000001", "--time-budget", "300s"],
    ["--target-error", "0.002", "--seed", "1000002", "--time-budget", "300s"],
];
/// About how long one half takes, one sample a pixel being 1.
pub const WEIGHTS: [f64; 2] = [60.0, 60.0];

impl Reference {
    /// Reads it.
    ///
    /// # Errors
    /// Why that cannot be.
    pub fn given(file: &Path) -> Result<Self, String> {
        let picture = read_exr(file).map_err(|error| error.to_string())?;
        Ok(Self { picture, origin: format!("given: {}", file.display()), error: None })
    }

    /// Has two halves made that know nothing of each other; the reference is their mean, and half of their difference
    /// is its error.
    ///
    /// # Errors
    /// Those of `render`, and when the halves differ in size.
    pub fn made(mut render: impl FnMut(&[&str]) -> Result<Picture, String>) -> Result<Self, String> {
        let [mut a, b] = [render(&HALVES[0])?, render(&HALVES[1])?];
        let apart = compare(&a, &b).map_err(|error| error.to_string())?.rmse;
        for (a, b) in a.pixels.iter_mut().zip(&b.pixels) {
            *a = std::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        }
        let origin = "made: the mean of two pictures by whitted of different seeds, each sampled until its error was \
                      below 0.002, or for five minutes";
        Ok(Self { picture: a, origin: origin.into(), error: Some(apart / 2.0) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_two_halves_is_off_by_half_their_difference() {
        let mut values = [0.25f32, 0.75].into_iter();
        let render = |_: &[&str]| Ok(Picture::filled(2, 2, [values.next().unwrap(), 0.5, 0.5, 1.0]));
        let reference = Reference::made(render).unwrap();
        assert_eq!(reference.picture.pixels[3][0], 0.5);
        assert!((reference.error.unwrap() - 0.25 / 3f64.sqrt()).abs() < 1e-9);
        assert_eq!(Reference::made(|_| Err("no".into())).unwrap_err(), "no");
    }
}
