//! Height fields: pixels become a grid of whole heights.
//!
//! Source: freeform facts, section 3.

use crate::compile::function::Functions;
use crate::compile::picture::stored_level;
use crate::compile::texture::Refusal;
use crate::compiled::Function;
use crate::compiled::geometry::HeightGrid;
use crate::function::Translate as _;
use crate::imaging::{Pixels, linear_from_srgb};
use crate::scene::{self, ImageFormat, ImageSource, Working};
use std::sync::Arc;

/// All that decides what the grid of a height field is; its picture lives as long as the scene, so its address serves.
pub(super) type GridKey = [u64; 6];

/// What tells a height field from others.
pub(super) fn grid_key(field: &scene::HeightField) -> GridKey {
    let (address, size) = match &field.image.source {
        ImageSource::File { file, format } => (Arc::as_ptr(file).addr(), [*format as u32, 0]),
        ImageSource::Function { width, height, function } => (Arc::as_ptr(function).addr(), [*width, *height]),
    };
    let gamma = match field.image.gamma {
        None => f64::NEG_INFINITY,
        Some(Working::Srgb) => f64::INFINITY,
        Some(Working::Power(power)) => power,
    };
    let [a, b] = size.map(u64::from);
    [address as u64, a, b, gamma.to_bits(), field.water_level.to_bits(), u64::from(field.smooth)]
}

/// Builds the grid of a height field.
///
/// # Errors
/// A message if the picture cannot be read, or the function not be called.
pub(super) fn height_grid(field: &scene::HeightField, functions: &Functions) -> Result<Option<HeightGrid>, Refusal> {
    let (width, depth, top_down) = match &field.image.source {
        ImageSource::File { file, format } => {
            let pixels = file.pixels()?;
            if *format == ImageFormat::Pot {
                let heights = from_potential(&pixels).ok_or("a pot file must be a GIF of even width")?;
                (pixels.width / 2, pixels.height, heights)
            } else {
                (pixels.width, pixels.height, from_pixels(&pixels, *format, field.image.gamma))
            }
        }
        ImageSource::Function { width, height, function } => {
            let (w, h) = (*width as usize, *height as usize);
            (w, h, from_function(w, h, &*functions.function(function)?))
        }
    };
    if width < 2 || depth < 2 {
        return Ok(None);
    }
    // The picture's bottom row stands at z = 0.
    let heights: Vec<u16> = top_down.chunks_exact(width).rev().flatten().copied().collect();
    Ok(Some(HeightGrid::new(width, heights, field.water_level * 65536.0, field.smooth)))
}

/// Fractint's 16-bit files: the left half holds the high bytes, the right half the low ones.
fn from_potential(pixels: &Pixels) -> Option<Vec<u16>> {
    let indices = pixels.indices.as_ref().filter(|_| pixels.width >= 2 && pixels.width.is_multiple_of(2))?;
    let row = |row: &[u8]| {
        let (high, low) = row.split_at(row.len() / 2);
        high.iter().zip(low).map(|(h, l)| u16::from_be_bytes([*h, *l])).collect::<Vec<_>>()
    };
    Some(indices.chunks_exact(pixels.width).flat_map(row).collect())
}

/// Raw numbers count, unless a `gamma` was written.
fn decoded(gamma: Option<Working>, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
    let linear = |v: f32| match gamma {
        None => v,
        Some(Working::Srgb) => linear_from_srgb(v),
        Some(Working::Power(power)) => f64::from(v.max(0.0)).powf(power) as f32,
    };
    [linear(r), linear(g), linear(b), a]
}

/// How a picture that is not a palette holds its heights (freeform facts, section 3).
#[derive(Clone, Copy, Debug, PartialEq)]
enum Levels {
    /// Colours of any range in floating point: the same numbers as 8-bit colours, wrapping around.
    Float,
    /// Grey of at most 8 bits, which POV-Ray rounds down in single precision.
    RoundedGrey,
    /// Other greys: the share of 65535.
    Grey,
    /// Red above green.
    Bytes,
    /// Colours of 16 bits: their brightness.
    Brightness,
}

impl Levels {
    fn of(pixels: &Pixels, format: ImageFormat) -> Self {
        /// A 16-bit value that 8 bits cannot hold is at least 1/257 of a step away from one that they can, and single
        /// precision adds less than 1e-4 to that.
        const EIGHT_BITS: f32 = 1e-3;
        let deep = |p: [f32; 4]| p[..3].iter().any(|v| (v * 255.0 - (v * 255.0).round()).abs() > EIGHT_BITS);
        if matches!(format, ImageFormat::Exr | ImageFormat::Hdr) {
            Self::Float
        } else if pixels.grey8 {
            Self::RoundedGrey
        } else if pixels.rgba().all(|[r, g, b, _]| r == g && g == b) {
            Self::Grey
        } else if pixels.rgba().any(deep) {
            Self::Brightness
        } else {
            Self::Bytes
        }
    }

    fn height(self, [r, g, b, _]: [f32; 4]) -> f64 {
        /// Pixels are single precision: less than this below a whole number is that number.
        const ROUNDING: f64 = 0.01;
        let byte = |v: f32| (f64::from(v) * 255.0).round();
        let [x, y, z] = [r, g, b].map(f64::from);
        match self {
            Self::Float => (255.0 * (256.0 * x + y)).floor().rem_euclid(65536.0),
            Self::RoundedGrey => {
                let level = 255.0 * (0.297_f32 * r + 0.589_f32 * g + 0.114_f32 * b);
                f64::from(level.floor()) * 257.0
            }
            Self::Grey => (x * 65535.0 + ROUNDING).floor(),
            Self::Bytes => byte(r) * 256.0 + byte(g),
            Self::Brightness => {
                let [r, g, b] = [x, y, z].map(|v| (v * 65535.0).round());
                (0.297 * r + 0.589 * g + 0.114 * b).floor()
            }
        }
    }
}

/// Heights by the kind of picture, top row first.
fn from_pixels(pixels: &Pixels, format: ImageFormat, gamma: Option<Working>) -> Vec<u16> {
    // As the file has them: gamma makes other numbers of them.
    let levels = Levels::of(pixels, format);
    match &pixels.indices {
        Some(indices) => indices.iter().map(|i| u16::from(*i) * 256).collect(),
        None => pixels.rgba().map(|p| levels.height(decoded(gamma, p)) as u16).collect(),
    }
}

/// Samples a function over the unit square, x to the right, y down.
fn from_function(width: usize, height: usize, function: &Function) -> Vec<u16> {
    let share = |i: usize, n: usize| if n > 1 { i as f64 / (n - 1) as f64 } else { 0.0 };
    let mut heights = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let value = function.call(&[share(column, width), share(row, height), 0.0]);
            let level = if function.width() == 1 {
                stored_level(value[0])
            } else {
                (65535.0 * (0.297 * value[0] + 0.589 * value[1] + 0.114 * value[2])).floor().clamp(0.0, 65535.0)
            };
            heights.push(level as u16);
        }
    }
    heights
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::Samples;

    /// Heights of a picture of these pixels.
    fn check(format: ImageFormat, grey8: bool, rgb: &[[f32; 3]], expected: &[u16]) {
        let rgba = rgb.iter().map(|[r, g, b]| [*r, *g, *b, 1.0]).collect();
        let samples = Samples::Floats(Arc::new(rgba));
        let pixels = Pixels { width: rgb.len(), height: 1, samples, grey8, ..Pixels::default() };
        assert_eq!(from_pixels(&pixels, format, None), expected, "{format:?} {rgb:?}");
    }

    /// Probe values of section 3 of the freeform facts.
    #[test]
    fn heights_follow_the_kind_of_picture() {
        let byte = |v: u8| f32::from(v) / 255.0;
        let word = |v: u16| f32::from(v) / 65535.0;
        let grey = |v: f32| [v; 3];
        check(ImageFormat::Pnm, false, &[grey(0.4), grey(0.5)], &[26214, 32767]);
        check(ImageFormat::Png, false, &[grey(byte(40))], &[10280]);
        check(ImageFormat::Png, true, &[grey(byte(40))], &[10023]);
        check(ImageFormat::Png, true, &[grey(byte(68))], &[17476]);
        check(ImageFormat::Png, false, &[grey(word(40000)), grey(word(1)), grey(word(65534))], &[40000, 1, 65534]);
        check(ImageFormat::Tga, false, &[grey(byte(40))], &[10280]);
        check(ImageFormat::Png, false, &[[byte(40), byte(200), byte(9)], grey(byte(7))], &[10440, 7 * 257]);
        check(ImageFormat::Png, false, &[[word(40000), word(20000), word(5)]], &[23660]);
        check(ImageFormat::Exr, false, &[[0.25, 0.5, 0.0]], &[16447]);
        let samples = Samples::Floats(Arc::new(vec![[0.3, 0.2, 0.1, 1.0]; 2]));
        let indices = Some(Arc::new(vec![40, 255]));
        let pixels = Pixels { width: 2, height: 1, samples, indices, ..Pixels::default() };
        assert_eq!(from_pixels(&pixels, ImageFormat::Gif, None), [10240, 65280]);
    }
}
