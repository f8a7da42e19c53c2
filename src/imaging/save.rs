//! A picture to the bytes of a file.

use super::exr_write::encode_exr;
use super::{Encoding, FileKind, ImageError, Metadata, Picture, display_file, mark, write_whole};
use image::Rgb;
use image::codecs::hdr::HdrEncoder;
use std::path::Path;

/// Writes a picture as a file of some kind, `-` being standard output.
///
/// # Errors
/// [`ImageError`] when the format cannot hold the picture or the file cannot be written; then nothing was written at all.
pub fn save_as(
    path: &Path,
    kind: FileKind,
    picture: &Picture,
    metadata: &Metadata,
    encoding: &Encoding,
) -> Result<(), ImageError> {
    let bytes = match kind {
        FileKind::Exr => encode_exr(path, picture, metadata, encoding)?,
        FileKind::Hdr => encode_hdr(picture).map_err(|why| ImageError::Invalid(path.to_owned(), why))?,
        _ => display_file::encode(kind, picture, metadata, encoding)
            .map_err(|why| ImageError::Invalid(path.to_owned(), why))?,
    };
    write_whole(path, &mark::marked(kind, bytes, metadata))
}

/// Writes a picture as a file of the kind that its extension names.
///
/// # Errors
/// Those of [`save_as`], and [`ImageError::Unsupported`] for an unknown extension.
pub fn save(path: &Path, picture: &Picture, metadata: &Metadata, encoding: &Encoding) -> Result<(), ImageError> {
    let Some(kind) = FileKind::of(path) else {
        let why = format!("unknown kind of picture: use {}", FileKind::EXTENSIONS);
        return Err(ImageError::Unsupported(path.to_owned(), why));
    };
    save_as(path, kind, picture, metadata, encoding)
}

/// The bytes of a PNG of 8 bits, as small as they easily get.
///
/// # Errors
/// [`ImageError::Invalid`] for a picture that the format cannot hold, such as one of no size.
pub fn encode_png(picture: &Picture) -> Result<Vec<u8>, ImageError> {
    let encoding = Encoding::default();
    display_file::encode_png(picture, &Metadata::default(), &encoding, png::Compression::High)
        .map_err(|why| ImageError::Invalid("a picture of a page".into(), why))
}

/// Radiance files hold no negative values.
fn encode_hdr(picture: &Picture) -> Result<Vec<u8>, String> {
    let pixels: Vec<Rgb<f32>> = picture.pixels.iter().map(|&[r, g, b, _]| Rgb([r, g, b].map(|v| v.max(0.0)))).collect();
    let mut bytes = Vec::new();
    HdrEncoder::new(&mut bytes).encode(&pixels, picture.width, picture.height).map_err(|error| error.to_string())?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_hold_the_picture() {
        let folder = tempfile::tempdir().unwrap();
        let picture = Picture::filled(3, 2, [0.5, 0.25, 2.0, 1.0]);
        for (name, expected) in [("a.png", [188, 137, 255]), ("a.hdr", [128, 64, 255]), ("a.bmp", [188, 137, 255])] {
            let path = folder.path().join(name);
            save(&path, &picture, &Metadata::default(), &Encoding::default()).unwrap();
            let pixel = image::open(&path).unwrap().to_rgb8().get_pixel(2, 1).0;
            assert_eq!(pixel, expected, "{name}");
        }
    }

    #[test]
    fn pictures_of_no_size_and_unknown_kinds_are_refused() {
        let picture = Picture::filled(0, 0, [0.0; 4]);
        let save = |name: &str| save(Path::new(name), &picture, &Metadata::default(), &Encoding::default());
        for name in ["/nonexistent/a.png", "/nonexistent/a.exr", "a.xyz"] {
            assert!(save(name).is_err(), "{name}");
        }
    }
}
