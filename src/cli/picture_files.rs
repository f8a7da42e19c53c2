//! Options of pictures' files, beside their names.

use crate::imaging::{Curve, Dither, Encoding, FileKind};
use std::path::Path;

/// What kinds of files leave open.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Files {
    /// Kind of picture, whatever its name says: exr, png, ppm, tga, bmp, jpg or hdr [default: by the name; exr for -]
    #[arg(long, value_parser = kind, value_name = "KIND")]
    format: Option<FileKind>,
    /// Bits of each value of PNG and PPM files
    #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u8).range(5..=16), value_name = "N")]
    bits: u8,
    /// Write PNG and PPM files in grey
    #[arg(long)]
    grey: bool,
    /// How good JPEG files are, 1 to 100
    #[arg(long, default_value_t = Encoding::default().quality, value_parser = clap::value_parser!(u8).range(1..=100), value_name = "N")]
    jpeg_quality: u8,
    /// Write display files by a power instead of the sRGB curve; 1 is linear
    #[arg(long, value_parser = super::render::positive, value_name = "GAMMA")]
    file_gamma: Option<f64>,
    /// Spread what rounding loses over neighbours, but in EXR, HDR and JPEG files
    #[arg(long)]
    dither: bool,
    /// Keep layers of an EXR file that are no colours in a second part of it, which says that it is data
    #[arg(long)]
    parts: bool,
}

impl Files {
    pub(super) fn encoding(&self, float: bool) -> Encoding {
        Encoding {
            float,
            parts: self.parts,
            bits: self.bits,
            grey: self.grey,
            quality: self.jpeg_quality,
            curve: self.file_gamma.map_or(Curve::Srgb, Curve::power),
            dither: self.dither.then_some(Dither::FloydSteinberg),
            ..Encoding::default()
        }
    }

    /// The kind of a file with this name, if one can be told.
    pub(super) fn kind(&self, file: &Path) -> Option<FileKind> {
        let by_name = || if file == Path::new("-") { Some(FileKind::Exr) } else { FileKind::of(file) };
        self.format.or_else(by_name)
    }
}

fn kind(text: &str) -> Result<FileKind, String> {
    FileKind::named(text).ok_or_else(|| format!("there are {}", FileKind::EXTENSIONS.replace('.', "")))
}
