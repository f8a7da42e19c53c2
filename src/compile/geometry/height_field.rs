//! Height fields: pixels become a grid of whole heights.
//!
//! Source: shape facts, freeform, section 3.

use crate::compile::picture::{decoder_name, stored_level};
use crate::compiled::geometry::HeightGrid;
use crate::function::Function;
use crate::imaging::{Pixels, decode, linear_from_srgb};
use crate::scene::{self, ImageFormat, ImageSource, Working};

/// Builds the grid of a height field.
///
/// # Errors
/// A message if the picture cannot be read.
pub(super) fn height_grid(field: &scene::HeightField) -> Result<Option<HeightGrid>, String> {
    let (width, depth, top_down) = match &field.image.source {
        ImageSource::File { path, format } => {
            let name = decoder_name(*format).ok_or("this picture type is not supported in height_field")?;
            let mut pixels = decode(path, name).map_err(|e| e.to_string())?;
            if *format == ImageFormat::Pot {
                let heights = from_potential(&pixels).ok_or("a pot file must be a GIF of even width")?;
                (pixels.width / 2, pixels.height, heights)
            } else {
                apply_gamma(&mut pixels, field.image.gamma);
                (pixels.width, pixels.height, from_pixels(&pixels, *format))
            }
        }
        ImageSource::Function { width, height, function } => {
            let (w, h) = (*width as usize, *height as usize);
            (w, h, from_function(w, h, function))
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
fn apply_gamma(pixels: &mut Pixels, gamma: Option<Working>) {
    let Some(gamma) = gamma else { return };
    let linear = |v: f32| match gamma {
        Working::Srgb => linear_from_srgb(v),
        Working::Power(power) => f64::from(v.max(0.0)).powf(power) as f32,
    };
    for p in &mut pixels.rgba {
        *p = [linear(p[0]), linear(p[1]), linear(p[2]), p[3]];
    }
}

/// Heights by the kind of picture, top row first.
fn from_pixels(pixels: &Pixels, format: ImageFormat) -> Vec<u16> {
    if let Some(indices) = &pixels.indices {
        return indices.iter().map(|i| u16::from(*i) * 256).collect();
    }
    let byte = |v: f32| (f64::from(v) * 255.0).round();
    let floats = matches!(format, ImageFormat::Exr | ImageFormat::Hdr);
    let height = |&[r, g, b, _]: &[f32; 4]| -> f64 {
        let gray = r == g && g == b;
        if floats {
            (255.0 * (256.0 * f64::from(r) + f64::from(g))).floor().rem_euclid(65536.0)
        } else if pixels.grey8 {
            // POV-Ray stores such greys in single precision, rounded down.
            let level = 255.0 * (0.297_f32 * r + 0.589_f32 * g + 0.114_f32 * b);
            f64::from(level.floor()) * 257.0
        } else if gray && format != ImageFormat::Tga {
            // 8 and 16 bits alike: v 257 and v are both 65535 times the share.
            (f64::from(r) * 65535.0).round()
        } else {
            byte(r) * 256.0 + byte(g)
        }
    };
    pixels.rgba.iter().map(|p| height(p) as u16).collect()
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
