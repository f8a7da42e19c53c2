//! Kinds of picture files, and what each leaves open.

use super::{linear_from_srgb, srgb_from_linear};
use std::path::Path;

/// Kinds of files that we write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FileKind {
    /// Linear light, half or single precision, layers.
    Exr,
    /// 8 or 16 bits, straight alpha.
    Png,
    /// 8 or 16 bits, no alpha.
    Ppm,
    /// 8 bits, straight alpha, as they are or packed.
    Tga {
        /// Run-length coded.
        packed: bool,
    },
    /// 8 bits, straight alpha.
    Bmp,
    /// 8 bits with loss, no alpha.
    Jpeg,
    /// Linear light with a shared exponent.
    Hdr,
}

impl FileKind {
    /// Extensions that can be asked for, for messages.
    pub const EXTENSIONS: &str = ".exr, .png, .ppm, .tga, .bmp, .jpg or .hdr";

    /// By the extension of a name, in any case.
    pub fn of(path: &Path) -> Option<Self> {
        Self::named(path.extension()?.to_str()?)
    }

    /// By an extension without its dot, in any case.
    pub fn named(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "exr" => Some(Self::Exr),
            "png" => Some(Self::Png),
            "ppm" => Some(Self::Ppm),
            "tga" => Some(Self::Tga { packed: false }),
            "bmp" => Some(Self::Bmp),
            "jpg" | "jpeg" => Some(Self::Jpeg),
            "hdr" => Some(Self::Hdr),
            _ => None,
        }
    }

    /// The extension that POV-Ray gives such files, with its dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Exr => ".exr",
            Self::Png => ".png",
            Self::Ppm => ".ppm",
            Self::Tga { .. } => ".tga",
            Self::Bmp => ".bmp",
            Self::Jpeg => ".jpg",
            Self::Hdr => ".hdr",
        }
    }

    /// Whether such a file can hold transparency.
    pub fn holds_alpha(self) -> bool {
        !matches!(self, Self::Ppm | Self::Jpeg | Self::Hdr)
    }
}

/// What a kind of file leaves open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encoding {
    /// EXR colours in single instead of half precision.
    pub float: bool,
    /// EXR layers that are no colours in a part of their own.
    pub parts: bool,
    /// Bits of a value in PNG and PPM files, 5 to 16; above 8 they take up two bytes.
    pub bits: u8,
    /// One value for each pixel instead of a colour: PNG and PPM files.
    pub grey: bool,
    /// How much a JPEG file may lose, 1 to 100; 100 is best.
    pub quality: u8,
    /// From light to values, but in EXR and HDR files.
    pub curve: Curve,
    /// From light to the values in which colours were multiplied by alpha: straight ones come from dividing there.
    pub working: Curve,
    /// How light that falls between two values is spread, but in EXR, HDR and JPEG files.
    pub dither: Option<Dither>,
}

impl Default for Encoding {
    /// Half precision, 8 bits, sRGB. Source: quality, camera and image facts, section 4.2.
    fn default() -> Self {
        Self {
            float: false,
            parts: false,
            bits: 8,
            grey: false,
            quality: 85,
            curve: Curve::Srgb,
            working: Curve::Power(1.0),
            dither: None,
        }
    }
}

/// The transfer function of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// IEC 61966-2-1.
    Srgb,
    /// Linear light is the value to this power, above 0.
    Power(f64),
}

impl Curve {
    /// How near to 1 an exponent counts as 1. Source: camera and image facts, section 4.1.
    const LINEAR_WITHIN: f64 = 0.01;

    /// With this exponent; one near 1 leaves values as they are.
    pub fn power(gamma: f64) -> Self {
        // The measured limit is that of the encoding exponent: 1.009 is linear, 1.011 is not.
        Self::Power(if (1.0 / gamma - 1.0).abs() < Self::LINEAR_WITHIN { 1.0 } else { gamma })
    }

    /// Value of linear light.
    pub fn encode(self, linear: f32) -> f32 {
        match self {
            Self::Srgb => srgb_from_linear(linear),
            Self::Power(1.0) => linear,
            Self::Power(gamma) => f64::from(linear.max(0.0)).powf(gamma.recip()) as f32,
        }
    }

    /// Linear light of a value.
    pub fn decode(self, value: f32) -> f32 {
        match self {
            Self::Srgb => linear_from_srgb(value),
            Self::Power(1.0) => value,
            Self::Power(gamma) => f64::from(value.max(0.0)).powf(gamma) as f32,
        }
    }
}

/// Ways of dithering. Source: camera and image facts, section 4.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dither {
    /// Thresholds in squares of 2, 3 or 4 pixels.
    Ordered(u8),
    /// What is lost goes to the next value.
    Next,
    /// What is lost goes to three pixels.
    Simple,
    /// What is lost goes to four pixels: Floyd and Steinberg.
    FloydSteinberg,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_and_extensions_agree() {
        for kind in FileKind::EXTENSIONS.split([' ', ',']).filter(|word| word.starts_with('.')) {
            assert_eq!(FileKind::of(format!("a{kind}").as_ref()).map(FileKind::extension), Some(kind));
        }
        assert_eq!(FileKind::of("A.JPEG".as_ref()), Some(FileKind::Jpeg));
        assert_eq!(FileKind::of("a.xyz".as_ref()), None);
    }

    #[test]
    fn exponents_near_one_are_one() {
        assert_eq!(Curve::power(1.009), Curve::Power(1.0));
        assert_eq!(Curve::power(1.011), Curve::Power(1.011));
    }

    #[test]
    fn curves_and_their_inverses_agree() {
        for curve in [Curve::Srgb, Curve::Power(1.0), Curve::Power(2.2)] {
            for value in [0.0, 0.01, 0.25, 0.9, 1.0] {
                assert!((curve.decode(curve.encode(value)) - value).abs() < 1e-5, "{curve:?} {value}");
            }
        }
    }
}
