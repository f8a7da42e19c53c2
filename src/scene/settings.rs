//! `global_settings` and the pictures that scenes refer to.

use super::{Function, Photons, Radiosity, Subsurface};
use crate::diag::Span;
use crate::imaging::Encoded;
use crate::math::Rgb;
use std::sync::Arc;

/// `global_settings` with POV-Ray's defaults.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Settings {
    /// Hundredths: 370 for 3.7; 362 for a scene that never says.
    pub version: u32,
    /// Objects and parts of solids that may be built, copies counted as often as they have to be written out.
    pub max_parts: u64,
    pub gamma: Gamma,
    pub ambient_light: Rgb,
    pub irid_wavelength: Rgb,
    pub max_trace_level: u32,
    pub adc_bailout: f64,
    pub number_of_waves: u32,
    /// 1 to 3; the default depends on the version.
    pub noise_generator: Option<u8>,
    pub mm_per_unit: f64,
    /// Where a `subsurface` block switches it on.
    pub subsurface: Option<Subsurface>,
    /// Where a `radiosity` block switches it on.
    pub radiosity: Option<Radiosity>,
    /// Share of sample rays that see what does not say otherwise, and the sky; of the last `#default`.
    pub radiosity_importance: f32,
    /// Where a `photons` block switches them on.
    pub photons: Option<Photons>,
}

/// How colours of the scene relate to linear light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gamma {
    /// Version below 3.7 without `assumed_gamma`: values are display values (sRGB), pictures are taken as they are.
    None,
    /// `assumed_gamma` given, or implied (1.0) at version 3.7.
    Linear(Working),
}

impl Gamma {
    /// What holds where no `assumed_gamma` was met, by the version in hundredths.
    pub fn implied(version: u32) -> Self {
        if version < 370 { Self::None } else { Self::Linear(Working::Power(1.0)) }
    }
}

/// A transfer curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working {
    /// Power law: linear = value ^ gamma.
    Power(f64),
    /// The sRGB curve.
    Srgb,
}

impl Working {
    /// Whether values are linear light: powers within 1 % of 1 are the identity, as in POV-Ray.
    pub fn is_linear(self) -> bool {
        matches!(self, Self::Power(gamma) if (gamma - 1.0).abs() < 0.01)
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            version: 362,
            max_parts: 200_000_000,
            gamma: Gamma::None,
            ambient_light: Rgb::ONE,
            irid_wavelength: Rgb::new(0.70, 0.52, 0.48),
            max_trace_level: 5,
            adc_bailout: 1.0 / 255.0,
            number_of_waves: 10,
            noise_generator: None,
            mm_per_unit: 10.0,
            subsurface: None,
            radiosity: None,
            radiosity_importance: 1.0,
            photons: None,
        }
    }
}

impl Settings {
    /// The noise generator where a pattern names none.
    pub fn noise_generator(&self) -> u8 {
        self.noise_generator.unwrap_or(if self.version < 350 { 1 } else { 2 })
    }
}

/// A picture named by a scene: a file that was found, or a function to sample.
#[derive(Clone, Debug)]
pub struct Image {
    /// The file name, or the word `function`.
    pub span: Span,
    /// Where pixels come from.
    pub source: ImageSource,
    /// `gamma` after the file name.
    pub gamma: Option<Working>,
    /// `premultiplied` after the file name.
    pub premultiplied: Option<bool>,
    /// How colours related to linear light where the picture was named: its values are brought into that space,
    /// whatever the scene says later.
    pub mode: Gamma,
    /// Named where a version below 3.7 was in force: a file that says nothing of its colours is taken as it is, not as
    /// sRGB.
    pub legacy: bool,
}

/// Where pixels come from.
#[derive(Clone, Debug)]
pub enum ImageSource {
    /// A file.
    File {
        /// Its bytes as the scene was given them; statements that name the same file share them.
        file: Arc<Encoded>,
        /// Its type, which decides what its numbers mean.
        format: ImageFormat,
    },
    /// `function W, H { … }`.
    Function {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// Grey for a scalar function, colour for a pigment.
        function: Arc<Function>,
    },
}

/// File types of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum ImageFormat {
    Png,
    Gif,
    Tga,
    Bmp,
    Pnm,
    Jpeg,
    Tiff,
    Exr,
    Hdr,
    Pot,
}

impl ImageFormat {
    /// The name under which [`imaging::decode`](crate::imaging::decode) knows it.
    pub fn decoder(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Gif => "gif",
            Self::Tga => "tga",
            Self::Bmp => "bmp",
            Self::Pnm => "pnm",
            Self::Jpeg => "jpeg",
            Self::Tiff => "tiff",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
            Self::Pot => "pot",
        }
    }
}

/// Projections of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum MapType {
    Planar,
    Spherical,
    Cylindrical,
    Torus,
}
