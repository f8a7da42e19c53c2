//! Files of whole numbers: PNG, PPM, TGA, BMP and JPEG.

use super::quantise::{Channels, Quantised};
use super::{Curve, Encoding, FileKind, Metadata, Picture, tga};
use image::ExtendedColorType as Color;
use image::codecs::{bmp::BmpEncoder, jpeg::JpegEncoder};
use std::borrow::Cow;
use std::fmt::Display;

/// The bytes of a file of one of the kinds above, or why the format cannot hold the picture.
pub(super) fn encode(
    kind: FileKind,
    picture: &Picture,
    metadata: &Metadata,
    encoding: &Encoding,
) -> Result<Vec<u8>, String> {
    match kind {
        FileKind::Png => encode_png(picture, metadata, encoding, png::Compression::Fast),
        FileKind::Ppm => Ok(encode_ppm(picture, metadata, encoding)),
        _ => encode_bytes(kind, picture, encoding),
    }
}

/// Values of 8 bits.
fn encode_bytes(kind: FileKind, picture: &Picture, encoding: &Encoding) -> Result<Vec<u8>, String> {
    let has_alpha = picture.has_alpha && kind.holds_alpha();
    let (channels, color) = if has_alpha { (Channels::Rgba, Color::Rgba8) } else { (Channels::Rgb, Color::Rgb8) };
    // What a JPEG file loses would make dots of dithering.
    let dither = encoding.dither.filter(|_| kind != FileKind::Jpeg);
    let quantised = Quantised::new(picture, channels, 8, &Encoding { dither, ..*encoding });
    let ([width, height], values) = (quantised.size, quantised.bytes());
    let mut bytes = Vec::new();
    let written = match kind {
        FileKind::Tga { packed } => return tga::encode([width, height], &values, has_alpha, packed),
        FileKind::Jpeg => {
            JpegEncoder::new_with_quality(&mut bytes, encoding.quality).encode(&values, width, height, color)
        }
        _ => BmpEncoder::new(&mut bytes).encode(&values, width, height, color),
    };
    written.map(|()| bytes).map_err(|error| error.to_string())
}

/// A portable pixmap, or greymap, with what made it in comments.
fn encode_ppm(picture: &Picture, metadata: &Metadata, encoding: &Encoding) -> Vec<u8> {
    let (channels, magic) = if encoding.grey { (Channels::Grey, "P5") } else { (Channels::Rgb, "P6") };
    let Quantised { size: [width, height], max, values, .. } =
        Quantised::new(picture, channels, encoding.bits, encoding);
    let comments: String = remarks(metadata).map(|(name, text)| format!("# {name}: {}\n", one_line(&text))).collect();
    let mut bytes = format!("{magic}\n{comments}{width} {height}\n{max}\n").into_bytes();
    match encoding.bits {
        ..=8 => bytes.extend(values.iter().map(|value| *value as u8)),
        _ => bytes.extend(values.iter().flat_map(|value| value.to_be_bytes())),
    }
    bytes
}

/// A portable network graphic that says its curve and what made it.
pub(super) fn encode_png(
    picture: &Picture,
    metadata: &Metadata,
    encoding: &Encoding,
    compression: png::Compression,
) -> Result<Vec<u8>, String> {
    let (channels, color) = match (encoding.grey, picture.has_alpha) {
        (true, false) => (Channels::Grey, png::ColorType::Grayscale),
        (true, true) => (Channels::GreyAlpha, png::ColorType::GrayscaleAlpha),
        (false, false) => (Channels::Rgb, png::ColorType::Rgb),
        (false, true) => (Channels::Rgba, png::ColorType::Rgba),
    };
    let quantised = Quantised::new(picture, channels, encoding.bits, encoding);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, quantised.size[0], quantised.size[1]);
    encoder.set_color(color);
    encoder.set_depth(if encoding.bits > 8 { png::BitDepth::Sixteen } else { png::BitDepth::Eight });
    encoder.set_compression(compression);
    match encoding.curve {
        Curve::Srgb => encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual),
        Curve::Power(gamma) => encoder.set_source_gamma(png::ScaledFloat::new(gamma.recip() as f32)),
    }
    write_png(encoder, &quantised, metadata, encoding.bits).map_err(|error| error.to_string())?;
    Ok(bytes)
}

fn write_png(
    encoder: png::Encoder<'_, &mut Vec<u8>>,
    quantised: &Quantised,
    metadata: &Metadata,
    bits: u8,
) -> Result<(), png::EncodingError> {
    let mut writer = encoder.write_header()?;
    if !matches!(bits, 8 | 16) {
        writer.write_chunk(png::chunk::ChunkType(*b"sBIT"), &vec![bits; quantised.channels as usize])?;
    }
    for (name, text) in remarks(metadata) {
        // Software keeps its place in the words that the format names; other names are ours.
        let text: String = text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect();
        writer.write_text_chunk(&png::text_metadata::TEXtChunk::new(name, text))?;
    }
    writer.write_image_data(&file_bytes(quantised, bits))?;
    writer.finish()
}

/// Samples of 8 or 16 bits: values of fewer bits are shifted up, and their upper bits fill the room below.
///
/// Source: camera and image facts, section 4.2.
fn file_bytes(quantised: &Quantised, bits: u8) -> Vec<u8> {
    let widened = |value: u16, to: u8| {
        let up = to - bits;
        if up == 0 { value } else { (value << up) | (value >> (bits - up.min(bits))) }
    };
    match bits {
        ..=8 => quantised.values.iter().map(|value| widened(*value, 8) as u8).collect(),
        _ => quantised.values.iter().flat_map(|value| widened(*value, 16).to_be_bytes()).collect(),
    }
}

/// What made the picture, by name.
fn remarks(metadata: &Metadata) -> impl Iterator<Item = (&'static str, Cow<'_, str>)> {
    let software = (!metadata.software.is_empty()).then_some(("Software", metadata.software.as_str().into()));
    let options = (!metadata.options.is_empty()).then_some(("Comment", metadata.options.as_str().into()));
    let notes = metadata.notes.iter().map(|(name, text)| (*name, text.as_str().into()));
    software.into_iter().chain(options).chain(notes)
}

fn one_line(text: &(impl Display + ?Sized)) -> String {
    text.to_string().replace(['\n', '\r'], " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(bits: u8, value: u16) -> Vec<u8> {
        let quantised = Quantised { size: [1, 1], channels: Channels::Grey, max: u16::MAX, values: vec![value] };
        file_bytes(&quantised, bits)
    }

    #[test]
    fn few_bits_fill_their_samples() {
        assert_eq!(samples(5, 0b10110), [0b1011_0101]);
        assert_eq!(samples(8, 188), [188]);
        assert_eq!(samples(12, 0xabc), [0xab, 0xca]);
        assert_eq!(samples(9, 0b1_0110_0111), [0b1011_0011, 0b1101_1001]);
        assert_eq!(samples(16, 48192), 48192_u16.to_be_bytes());
    }

    #[test]
    fn files_are_read_back_by_other_means() {
        let mut picture = Picture::filled(17, 5, [0.5, 0.25, 0.1, 1.0]);
        picture.pixels[16] = [0.0, 0.1, 0.2, 0.5];
        picture.has_alpha = true;
        let kinds = [
            FileKind::Png,
            FileKind::Ppm,
            FileKind::Tga { packed: false },
            FileKind::Tga { packed: true },
            FileKind::Bmp,
            FileKind::Jpeg,
        ];
        for kind in kinds {
            let bytes = encode(kind, &picture, &Metadata::default(), &Encoding::default()).unwrap();
            let format = image::ImageFormat::from_extension(&kind.extension()[1..]).unwrap();
            let read = image::load_from_memory_with_format(&bytes, format).unwrap();
            let pixel = read.to_rgba8().get_pixel(0, 0).0;
            assert!([188, 137, 89].iter().zip(pixel).all(|(a, b)| b.abs_diff(*a) <= 1), "{kind:?} {pixel:?}");
            assert_eq!((read.width(), read.height()), (17, 5), "{kind:?}");
            assert_eq!(read.color().has_alpha(), kind.holds_alpha(), "{kind:?}");
        }
    }
}
