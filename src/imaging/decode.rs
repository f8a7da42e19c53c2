//! Pictures that scenes use: any format in, plain numbers out.

use super::ImageError;
use super::exr_read::decode_exr;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// A decoded file: its numbers as they stand there, 0 to 1 for integer formats.
#[derive(Clone, Debug, Default)]
pub struct Pixels {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Its colours.
    pub samples: Samples,
    /// Palette index of each pixel, for palette pictures.
    pub indices: Option<Arc<Vec<u8>>>,
    /// Whether the file carries alpha.
    pub has_alpha: bool,
    /// Colours are multiplied by alpha.
    pub premultiplied: bool,
    /// Grey of at most 8 bits without alpha in a PNG.
    pub grey8: bool,
    /// The file says that its values are sRGB.
    pub srgb: bool,
    /// The file says which power of its values is linear light.
    pub gamma: Option<f64>,
}

/// Height x width x (red, green, blue, opacity), row-major, top row first; shared with whoever uses them as they are.
#[derive(Clone, Debug)]
pub enum Samples {
    /// Of formats with up to 8 bits: 255 is 1.
    Bytes(Arc<Vec<u8>>),
    /// Of all others.
    Floats(Arc<Vec<[f32; 4]>>),
}

impl Default for Samples {
    fn default() -> Self {
        Self::Floats(Arc::default())
    }
}

impl Pixels {
    /// Red, green, blue and opacity of each pixel.
    pub fn rgba(&self) -> impl Iterator<Item = [f32; 4]> {
        let (bytes, floats): (&[u8], &[[f32; 4]]) = match &self.samples {
            Samples::Bytes(bytes) => (bytes, &[]),
            Samples::Floats(floats) => (&[], floats),
        };
        let small = bytes.as_chunks::<4>().0.iter().map(|p| p.map(|v| f32::from(v) / 255.0));
        small.chain(floats.iter().copied())
    }
}

/// The bytes of a picture, decoded when first asked for.
#[derive(Debug)]
pub struct Encoded {
    path: PathBuf,
    kind: &'static str,
    bytes: Vec<u8>,
    pixels: OnceLock<Result<Arc<Pixels>, String>>,
}

impl Encoded {
    /// What [`decode`] takes.
    pub fn new(path: PathBuf, kind: &'static str, bytes: Vec<u8>) -> Self {
        Self { path, kind, bytes, pixels: OnceLock::new() }
    }

    /// Whether two files are the same, decoded or not.
    pub fn is_like(&self, other: &Self) -> bool {
        self.path == other.path && self.kind == other.kind && self.bytes == other.bytes
    }

    /// The bytes as they were read.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// What errors call it.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The pixels, the same ones whoever asks.
    ///
    /// # Errors
    /// The message of [`decode`].
    pub fn pixels(&self) -> Result<Arc<Pixels>, String> {
        let decoded = || decode(&self.path, self.kind, &self.bytes).map(Arc::new).map_err(|e| e.to_string());
        self.pixels.get_or_init(decoded).clone()
    }
}

/// Decodes the bytes of a picture; `kind` is the language's name of its type (`png`, `gif`, `pot`, `tga`, `bmp`, `pnm`,
/// `jpeg`, `tiff`, `exr`, `hdr`), and `path` is what errors call it.
///
/// # Errors
/// [`ImageError`] naming the file.
pub fn decode(path: &Path, kind: &str, bytes: &[u8]) -> Result<Pixels, ImageError> {
    if kind == "exr" {
        let picture = decode_exr(path, bytes)?;
        let has_alpha = picture.has_alpha;
        let (width, height, samples) = (picture.width, picture.height, Samples::Floats(Arc::new(picture.pixels)));
        return Ok(Pixels { width, height, samples, has_alpha, premultiplied: true, ..Pixels::default() });
    }
    let format = match kind {
        "png" => ImageFormat::Png,
        // Fractint's potential files are GIFs whose indices are halves of heights.
        "gif" | "pot" => ImageFormat::Gif,
        "tga" => ImageFormat::Tga,
        "bmp" => ImageFormat::Bmp,
        "pnm" => ImageFormat::Pnm,
        "jpeg" => ImageFormat::Jpeg,
        "tiff" => ImageFormat::Tiff,
        "hdr" => ImageFormat::Hdr,
        other => {
            return Err(ImageError::Unsupported(path.to_owned(), format!("no reader for pictures of type {other}")));
        }
    };
    let invalid = |e: image::ImageError| ImageError::Invalid(path.to_owned(), e.to_string());
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = image::Limits::default();
    limits.max_alloc = Some(2 << 30);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(invalid)?;
    let original = decoder.original_color_type();
    let image = DynamicImage::from_decoder(decoder).map_err(invalid)?;
    let mut pixels = to_pixels(image);
    match kind {
        "png" => read_png_chunks(bytes, &mut pixels, original),
        "gif" | "pot" => read_gif_indices(bytes, &mut pixels),
        "tiff" => pixels.premultiplied = true,
        _ => {}
    }
    Ok(pixels)
}

fn to_pixels(image: DynamicImage) -> Pixels {
    use image::ColorType as C;
    let has_alpha = image.color().has_alpha();
    let (width, height) = (image.width() as usize, image.height() as usize);
    let samples = match image.color() {
        C::L8 | C::La8 | C::Rgb8 | C::Rgba8 => Samples::Bytes(Arc::new(image.into_rgba8().into_raw())),
        _ => Samples::Floats(Arc::new(image.into_rgba32f().into_raw().as_chunks::<4>().0.to_vec())),
    };
    Pixels { width, height, samples, has_alpha, ..Pixels::default() }
}

/// What the chunks before the pixels say; a damaged file has been refused before.
fn read_png_chunks(bytes: &[u8], pixels: &mut Pixels, original: image::ExtendedColorType) {
    use image::ExtendedColorType as C;
    pixels.grey8 = matches!(original, C::L1 | C::L2 | C::L4 | C::L8);
    let mut rest = bytes.get(8..).unwrap_or_default();
    let (mut palette, mut transparent) = (None, None);
    while let Some((header, body)) = rest.split_at_checked(8) {
        let length = u32::from_be_bytes([header[0], header[1], header[2], header[3]]) as usize;
        let Some(data) = body.get(..length) else { break };
        match &header[4..] {
            b"IHDR" if data.get(9) == Some(&3) => palette = Some(Vec::new()),
            b"sRGB" => pixels.srgb = true,
            b"gAMA" if length == 4 => {
                let stored = u32::from_be_bytes([data[0], data[1], data[2], data[3]]);
                pixels.gamma = (stored > 0).then(|| 100_000.0 / f64::from(stored));
            }
            b"PLTE" if palette.is_some() => palette = Some(data.as_chunks::<3>().0.to_vec()),
            b"tRNS" => transparent = Some(data.to_vec()),
            b"IDAT" => break,
            _ => {}
        }
        rest = body.get(length + 4..).unwrap_or_default();
    }
    if let Some(palette) = palette {
        let alpha = transparent.unwrap_or_default();
        let entries = palette.iter().enumerate().map(|(i, c)| [c[0], c[1], c[2], alpha.get(i).copied().unwrap_or(255)]);
        pixels.indices = Some(Arc::new(indices_of(pixels, entries)));
        pixels.grey8 = false;
        // A palette picture always counts as having alpha.
        pixels.has_alpha = true;
    }
}

/// Palette indices as the file has them: different entries may share a colour.
fn read_gif_indices(bytes: &[u8], pixels: &mut Pixels) {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::Indexed);
    let Ok(mut decoder) = options.read_info(bytes) else { return };
    let Ok(Some(frame)) = decoder.read_next_frame() else { return };
    if (usize::from(frame.width), usize::from(frame.height)) == (pixels.width, pixels.height) {
        pixels.indices = Some(Arc::new(frame.buffer.to_vec()));
    }
}

/// Finds each pixel's palette entry by its colour; of equal entries the first.
fn indices_of(pixels: &Pixels, entries: impl Iterator<Item = [u8; 4]>) -> Vec<u8> {
    let mut table = rustc_hash::FxHashMap::default();
    for (i, entry) in entries.enumerate().take(256) {
        table.entry(entry).or_insert(i as u8);
    }
    let find =
        |[r, g, b, a]: [u8; 4]| table.get(&[r, g, b, a]).or_else(|| table.get(&[r, g, b, 255])).copied().unwrap_or(0);
    // Bytes over 255, which rounding has moved by less than half a step.
    pixels.rgba().map(|p| find(p.map(|v| (v * 255.0 + 0.5) as u8))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(image: DynamicImage, name: &str, kind: &str, expected: [f32; 4]) -> Pixels {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        image.save(&path).unwrap();
        let pixels = decode(&path, kind, &std::fs::read(&path).unwrap()).unwrap();
        let found = pixels.rgba().next().unwrap();
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() < 1e-6, "{name}: {found:?}"));
        pixels
    }

    #[test]
    fn every_format_gives_its_numbers() {
        let rgb = || DynamicImage::from(image::RgbImage::from_pixel(2, 2, image::Rgb([255, 51, 0])));
        for (name, kind) in [("a.png", "png"), ("a.bmp", "bmp"), ("a.tga", "tga"), ("a.ppm", "pnm"), ("a.tiff", "tiff")]
        {
            assert!(!check(rgb(), name, kind, [1.0, 0.2, 0.0, 1.0]).grey8);
        }
        let grey = DynamicImage::from(image::GrayImage::from_pixel(2, 2, image::Luma([51])));
        assert!(check(grey, "g.png", "png", [0.2, 0.2, 0.2, 1.0]).grey8);
        let gif = DynamicImage::from(image::RgbaImage::from_pixel(2, 2, image::Rgba([255, 51, 0, 255])));
        check(gif, "a.gif", "gif", [1.0, 0.2, 0.0, 1.0]);
    }

    #[test]
    fn other_files_are_refused() {
        for kind in ["png", "gif", "tga", "bmp", "pnm", "jpeg", "tiff", "hdr", "exr"] {
            assert!(decode("a".as_ref(), kind, b"no picture").is_err(), "{kind}");
            assert!(decode("a".as_ref(), kind, b"").is_err(), "{kind}");
        }
    }
}
