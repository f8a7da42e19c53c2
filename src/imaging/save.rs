//! Which file format a name asks for, and its bytes.

use super::{ImageError, Metadata, Picture, exr_file::encode_exr, srgb_from_linear, write_whole};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{DynamicImage, ImageBuffer, ImageFormat, Rgb, Rgb32FImage, Rgba};
use std::io::Cursor;
use std::path::Path;

/// Formats that we write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// Linear light, half or single precision, layers.
    Exr,
    /// sRGB, 8 or 16 bits, straight alpha.
    Png,
    /// sRGB, 8 bits.
    Ppm,
    /// Linear light with a shared exponent.
    Hdr,
}

/// How precisely values are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Encoding {
    /// EXR colours in single instead of half precision.
    pub float: bool,
    /// PNG in 16 instead of 8 bits.
    pub sixteen_bit: bool,
}

impl FileKind {
    /// By extension in any case; `-` is EXR.
    pub fn of(path: &Path) -> Option<Self> {
        if path == Path::new("-") {
            return Some(Self::Exr);
        }
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "exr" => Some(Self::Exr),
            "png" => Some(Self::Png),
            "ppm" => Some(Self::Ppm),
            "hdr" => Some(Self::Hdr),
            _ => None,
        }
    }
}

/// Writes a picture in the format that the file's extension names.
///
/// # Errors
/// [`ImageError`] for an unknown extension or when the file cannot be written; then nothing
/// was written at all.
pub fn save(path: &Path, picture: &Picture, metadata: &Metadata, encoding: Encoding) -> Result<(), ImageError> {
    let Some(kind) = FileKind::of(path) else {
        let why = "unknown kind of picture: use .exr, .png, .ppm or .hdr".into();
        return Err(ImageError::Unsupported(path.to_owned(), why));
    };
    let bytes = match kind {
        FileKind::Exr => encode_exr(path, picture, metadata, encoding.float)?,
        FileKind::Png => through_image_crate(path, &display_image(picture, encoding.sixteen_bit), ImageFormat::Png)?,
        FileKind::Ppm => {
            through_image_crate(path, &DynamicImage::from(display_image(picture, false).to_rgb8()), ImageFormat::Pnm)?
        }
        FileKind::Hdr => through_image_crate(path, &linear_image(picture), ImageFormat::Hdr)?,
    };
    write_whole(path, &bytes)
}

/// The bytes of a PNG of 8 bits, as small as they easily get.
///
/// # Errors
/// [`ImageError::Invalid`] for a picture that the format cannot hold, such as one of no size.
pub fn encode_png(picture: &Picture) -> Result<Vec<u8>, ImageError> {
    let mut bytes = Vec::new();
    let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive);
    match display_image(picture, false).write_with_encoder(encoder) {
        Ok(()) => Ok(bytes),
        Err(error) => Err(ImageError::Invalid("a picture of a page".into(), error.to_string())),
    }
}

fn through_image_crate(path: &Path, image: &DynamicImage, format: ImageFormat) -> Result<Vec<u8>, ImageError> {
    let mut bytes = Cursor::new(Vec::new());
    match image.write_to(&mut bytes, format) {
        Ok(()) => Ok(bytes.into_inner()),
        Err(error) => Err(ImageError::Invalid(path.to_owned(), error.to_string())),
    }
}

/// sRGB with straight alpha; colours brighter than their alpha raise it, as in POV-Ray.
fn display_image(picture: &Picture, sixteen_bit: bool) -> DynamicImage {
    let (width, height) = (picture.width as u32, picture.height as u32);
    let pixels = picture.pixels.iter().map(|&[r, g, b, a]| {
        let grey = 0.297 * r + 0.589 * g + 0.114 * b;
        let alpha = if picture.has_alpha { a.max(grey.min(1.0)) } else { 1.0 };
        let scale = if picture.has_alpha { alpha.max(1e-6).recip() } else { 1.0 };
        [srgb_from_linear(r * scale), srgb_from_linear(g * scale), srgb_from_linear(b * scale), alpha]
    });
    // NaN quantises to 0: a comparison with it is false.
    let quantise = |v: f32, max: f32| if v > 0.0 { (v.min(1.0) * max + 0.5).floor() } else { 0.0 };
    let fits = "one pixel for each place";
    match (sixteen_bit, picture.has_alpha) {
        (false, false) => {
            let data = pixels.flat_map(|p| [p[0], p[1], p[2]].map(|v| quantise(v, 255.0) as u8)).collect();
            DynamicImage::from(ImageBuffer::<Rgb<u8>, _>::from_raw(width, height, data).expect(fits))
        }
        (false, true) => {
            let data = pixels.flat_map(|p| p.map(|v| quantise(v, 255.0) as u8)).collect();
            DynamicImage::from(ImageBuffer::<Rgba<u8>, _>::from_raw(width, height, data).expect(fits))
        }
        (true, false) => {
            let data = pixels.flat_map(|p| [p[0], p[1], p[2]].map(|v| quantise(v, 65535.0) as u16)).collect();
            DynamicImage::from(ImageBuffer::<Rgb<u16>, _>::from_raw(width, height, data).expect(fits))
        }
        (true, true) => {
            let data = pixels.flat_map(|p| p.map(|v| quantise(v, 65535.0) as u16)).collect();
            DynamicImage::from(ImageBuffer::<Rgba<u16>, _>::from_raw(width, height, data).expect(fits))
        }
    }
}

/// Radiance files hold no negative values.
fn linear_image(picture: &Picture) -> DynamicImage {
    let data = picture.pixels.iter().flat_map(|p| [p[0].max(0.0), p[1].max(0.0), p[2].max(0.0)]).collect();
    let image = Rgb32FImage::from_raw(picture.width as u32, picture.height as u32, data);
    DynamicImage::from(image.expect("one pixel for each place"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Saves one pixel and reads it back through the `image` crate, 0 to 255.
    fn check(name: &str, encoding: Encoding, pixel: [f32; 4], has_alpha: bool, expected: [u8; 4]) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        let picture = Picture { has_alpha, ..Picture::filled(1, 1, pixel) };
        save(&path, &picture, &Metadata::default(), encoding).unwrap();
        assert_eq!(image::open(&path).unwrap().to_rgba8().get_pixel(0, 0).0, expected, "{name}");
    }

    #[test]
    fn display_values_are_those_of_povray() {
        // Camera and image facts, section 4: background rgb <.5,.25,2>, and the alpha probe.
        let eight = Encoding { float: false, sixteen_bit: false };
        let sixteen = Encoding { float: false, sixteen_bit: true };
        check("a.png", eight, [0.5, 0.25, 2.0, 1.0], false, [188, 137, 255, 255]);
        check("a.ppm", eight, [0.5, 0.25, 2.0, 1.0], false, [188, 137, 255, 255]);
        check("a.PNG", sixteen, [0.5, 0.25, f32::NAN, 1.0], false, [188, 137, 0, 255]);
        check("b.png", eight, [0.5, 0.5, 0.5, 0.1], true, [255, 255, 255, 128]);
    }

    #[test]
    fn unknown_extensions_are_refused() {
        let picture = Picture::filled(1, 1, [0.0; 4]);
        let encoding = Encoding { float: false, sixteen_bit: false };
        assert!(save(Path::new("a.xyz"), &picture, &Metadata::default(), encoding).is_err());
    }
}
