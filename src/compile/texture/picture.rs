//! Pictures that scenes name: loaded once, brought into the scene's working space.

use super::pattern::mapping_of;
use super::{Refusal, TextureCompiler};
use crate::compile::picture::{decoder_name, stored_level};
use crate::compiled::texture::{ImageMap, Raster};
use crate::imaging::{self, Pixels};
use crate::math::{Color, Rgb};
use crate::scene::{self, Gamma, ImageFormat, ImageSource, Working};
use rustc_hash::FxHashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Decoded files and finished rasters, by what was asked for.
#[derive(Debug, Default)]
pub(super) struct PictureCache {
    files: FxHashMap<PathBuf, Arc<Pixels>>,
    values: FxHashMap<PathBuf, Arc<Raster>>,
}

impl TextureCompiler<'_> {
    /// `image_map`: colours in working space with the map's own `filter` and `transmit`.
    pub(super) fn image_map(&mut self, map: &scene::ImageMap) -> Result<ImageMap, Refusal> {
        let mut raster = match &map.image.source {
            ImageSource::File { path, format } => {
                let pixels = self.pixels(path, *format)?;
                let curve = color_curve(&map.image, *format, &pixels);
                to_raster(&pixels, &curve, map.image.premultiplied)
            }
            ImageSource::Function { width, height, function } => sampled(*width, *height, function),
        };
        for (i, pixel) in raster.pixels.iter_mut().enumerate() {
            let index = raster.indices.as_ref().map(|indices| u32::from(indices[i]));
            apply_transparency(map, index, pixel);
        }
        Ok(ImageMap { raster: Arc::new(raster), mapping: mapping_of(&map.mapping) })
    }

    /// Pictures whose numbers are values, not colours: raw unless a `gamma` was written.
    pub(super) fn value_picture(&mut self, image: &scene::Image) -> Result<Arc<Raster>, Refusal> {
        match &image.source {
            ImageSource::Function { width, height, function } => Ok(Arc::new(sampled(*width, *height, function))),
            ImageSource::File { path, format } => {
                if let (Some(raster), None) = (self.pictures.values.get(path), image.gamma) {
                    return Ok(Arc::clone(raster));
                }
                let pixels = self.pixels(path, *format)?;
                let curve = Curve { decode: image.gamma, encode: None };
                let raster = Arc::new(to_raster(&pixels, &curve, image.premultiplied));
                if image.gamma.is_none() {
                    self.pictures.values.insert(path.clone(), Arc::clone(&raster));
                }
                Ok(raster)
            }
        }
    }

    fn pixels(&mut self, path: &Path, format: ImageFormat) -> Result<Arc<Pixels>, Refusal> {
        if let Some(pixels) = self.pictures.files.get(path) {
            return Ok(Arc::clone(pixels));
        }
        if format == ImageFormat::Pot {
            return Err(format!("{}: pot files are for height fields only", path.display()));
        }
        let pixels = Arc::new(imaging::decode(path, decoder_name(format)).map_err(|e| e.to_string())?);
        self.pictures.files.insert(path.to_owned(), Arc::clone(&pixels));
        Ok(pixels)
    }
}

/// Palette entries take their own transparency; in other pictures `all` adds to what the file says.
fn apply_transparency(map: &scene::ImageMap, index: Option<u32>, pixel: &mut Color) {
    let Some(index) = index else {
        pixel.filter += map.filter_all.unwrap_or(0.0);
        pixel.transmit += map.transmit_all.unwrap_or(0.0);
        return;
    };
    let named = |list: &[(u32, f32)]| list.iter().rev().find(|(i, _)| *i == index).map(|(_, v)| *v);
    if let Some(filter) = named(&map.palette_filter).or(map.filter_all) {
        pixel.filter = filter;
    }
    if let Some(transmit) = named(&map.palette_transmit).or(map.transmit_all) {
        pixel.transmit = transmit;
    }
}

/// How a file's value becomes a working value: decoded to linear light, then encoded.
struct Curve {
    decode: Option<Working>,
    encode: Option<Working>,
}

impl Curve {
    fn apply(&self, v: f32) -> f32 {
        let linear = match self.decode {
            None => v,
            Some(Working::Srgb) => imaging::linear_from_srgb(v),
            Some(Working::Power(gamma)) => power(v, gamma),
        };
        match self.encode {
            None => linear,
            Some(Working::Srgb) => imaging::srgb_from_linear(linear),
            Some(Working::Power(gamma)) => power(linear, 1.0 / gamma),
        }
    }
}

/// A curve with the values that it gave last: pictures have few different ones, and powers are slow.
struct Memo<'a> {
    curve: &'a Curve,
    /// What a value became, at a place that its bits choose.
    known: Vec<(f32, f32)>,
}

impl<'a> Memo<'a> {
    /// Room for the values of 8 bits without many meeting in one place.
    const PLACES: u32 = 4096;

    fn new(curve: &'a Curve) -> Self {
        Self { curve, known: vec![(0.0, curve.apply(0.0)); Self::PLACES as usize] }
    }

    fn apply(&mut self, v: f32) -> f32 {
        /// Source of the multiplier: Knuth, The Art of Computer Programming, volume 3, section 6.4.
        const GOLDEN: u32 = 0x9e37_79b1;
        let place = v.to_bits().wrapping_mul(GOLDEN) >> (u32::BITS - Self::PLACES.ilog2());
        let known = &mut self.known[place as usize];
        if known.0.to_bits() != v.to_bits() {
            *known = (v, self.curve.apply(v));
        }
        known.1
    }
}

/// Power laws within 1 % of 1 are the identity, as in POV-Ray.
fn power(v: f32, gamma: f64) -> f32 {
    if (gamma - 1.0).abs() < 0.01 { v } else { f64::from(v.max(0.0)).powf(gamma) as f32 }
}

/// Section 12 of the freeform facts.
fn color_curve(image: &scene::Image, format: ImageFormat, pixels: &Pixels) -> Curve {
    let own = match format {
        ImageFormat::Exr | ImageFormat::Hdr => Some(Working::Power(1.0)),
        _ if pixels.srgb => Some(Working::Srgb),
        _ => pixels.gamma.map(Working::Power),
    };
    let (working, assumed) = match image.mode {
        Gamma::None => return Curve { decode: image.gamma, encode: None },
        Gamma::Legacy(working) => (working, None),
        Gamma::Linear(working) => (
            working,
            match format {
                ImageFormat::Pnm | ImageFormat::Tiff => None,
                _ => Some(Working::Srgb),
            },
        ),
    };
    match image.gamma.or(own).or(assumed) {
        Some(decode) => Curve { decode: Some(decode), encode: Some(working) },
        None => Curve { decode: None, encode: None },
    }
}

fn to_raster(pixels: &Pixels, curve: &Curve, premultiplied: Option<bool>) -> Raster {
    // Grey of up to 8 bits is stored in 8 bits again after decoding, as in POV-Ray.
    let requantised = |v: f32| ((255.0 * (0.297 * v + 0.589 * v + 0.114 * v)) as u32 as f32) / 255.0;
    let mut curve = Memo::new(curve);
    let convert = |p: &[f32; 4]| {
        let mut rgb = [0, 1, 2].map(|i| curve.apply(p[i]));
        if pixels.grey8 {
            rgb = rgb.map(requantised);
        }
        Color { rgb: Rgb::from(rgb), filter: 0.0, transmit: if pixels.has_alpha { 1.0 - p[3] } else { 0.0 } }
    };
    Raster {
        width: pixels.width,
        height: pixels.height,
        pixels: pixels.rgba.iter().map(convert).collect(),
        indices: pixels.indices.clone(),
        premultiplied: premultiplied.unwrap_or(pixels.premultiplied),
        has_alpha: pixels.has_alpha,
    }
}

/// `function W, H { … }`: sampled from corner to corner, the top row at y = 0, in 16 bits that wrap around.
///
/// Source: section 8.2 of the function facts; a picture one pixel wide is sampled at 0 / 0, as in POV-Ray.
fn sampled(width: u32, height: u32, function: &crate::function::Function) -> Raster {
    let quantise = |v: f64| (stored_level(v) / 65535.0) as f32;
    let scalar = function.width() == 1;
    let pixel = |x: u32, y: u32| {
        let at = [f64::from(x) / (f64::from(width) - 1.0), f64::from(y) / (f64::from(height) - 1.0), 0.0];
        let v = function.call(&at);
        if scalar {
            return Color { rgb: Rgb::splat(quantise(v[0])), ..Color::BLACK };
        }
        let alpha = quantise(1.0 - v[4]);
        Color { rgb: Rgb::new(quantise(v[0]), quantise(v[1]), quantise(v[2])), filter: 0.0, transmit: 1.0 - alpha }
    };
    Raster {
        width: width as usize,
        height: height as usize,
        pixels: (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect(),
        indices: None,
        premultiplied: false,
        has_alpha: !scalar,
    }
}
