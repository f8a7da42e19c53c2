//! Layers beside the picture: what there is, and what each is called in the file.

/// Something that can be written beside the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageLayer {
    /// Distance from the camera's plane (for perspective and orthographic cameras, else from the camera)
    /// of the nearest sample.
    Depth,
    /// World position of the nearest sample.
    Position,
    /// Shading normal, world space, towards the viewer; mean of the samples.
    Normal,
    /// Normal of the surface without bumps and smoothing.
    GeometricNormal,
    /// Colour of the pigments, weighted by opacity.
    Albedo,
    /// Ambient light and emission of the first surface.
    Emission,
    /// Light from light sources, by the first surface.
    Direct,
    /// Light from other surfaces, gathered by radiosity, sent back by the first surface.
    Indirect,
    /// Light that photons have brought.
    Caustics,
    /// Light that comes from below the first surface.
    Subsurface,
    /// What the first surface mirrors.
    Reflection,
    /// What comes through the first surface.
    Refraction,
    /// Sky and background.
    Background,
    /// What fog and rainbows add.
    Atmosphere,
    /// What media give off or scatter.
    Media,
    /// Camera rays sent for the pixel.
    Samples,
    /// Mean square distance of the samples from their mean, in working values.
    Variance,
    /// Shares of objects, as Cryptomatte.
    CryptoObject,
    /// Shares of textures, as Cryptomatte.
    CryptoMaterial,
}

impl ImageLayer {
    /// All layers, in the order in which they are documented.
    pub const ALL: [Self; 19] = [
        Self::Depth,
        Self::Position,
        Self::Normal,
        Self::GeometricNormal,
        Self::Albedo,
        Self::Emission,
        Self::Direct,
        Self::Indirect,
        Self::Caustics,
        Self::Subsurface,
        Self::Reflection,
        Self::Refraction,
        Self::Background,
        Self::Atmosphere,
        Self::Media,
        Self::Samples,
        Self::Variance,
        Self::CryptoObject,
        Self::CryptoMaterial,
    ];

    /// What the user calls it, and the layer in the file (for `Z`, the channel).
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "Z",
            Self::Position => "P",
            Self::Normal => "N",
            Self::GeometricNormal => "Ng",
            Self::Albedo => "albedo",
            Self::Emission => "emission",
            Self::Direct => "direct",
            Self::Indirect => "indirect",
            Self::Caustics => "caustics",
            Self::Subsurface => "subsurface",
            Self::Reflection => "reflection",
            Self::Refraction => "refraction",
            Self::Background => "background",
            Self::Atmosphere => "atmosphere",
            Self::Media => "media",
            Self::Samples => "samples",
            Self::Variance => "variance",
            Self::CryptoObject => "CryptoObject",
            Self::CryptoMaterial => "CryptoMaterial",
        }
    }

    /// Whether it is a colour in linear light. Variance is a square of working values; Cryptomatte holds names.
    pub(super) fn is_color(self) -> bool {
        match self {
            Self::Albedo | Self::Emission | Self::Direct | Self::Indirect | Self::Caustics => true,
            Self::Subsurface | Self::Reflection | Self::Refraction => true,
            Self::Background | Self::Atmosphere | Self::Media => true,
            Self::Depth | Self::Position | Self::Normal | Self::GeometricNormal => false,
            Self::Samples | Self::Variance | Self::CryptoObject | Self::CryptoMaterial => false,
        }
    }

    /// The layer of a name, in any case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|layer| layer.name().eq_ignore_ascii_case(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(name: &str, expected: Option<ImageLayer>) {
        assert_eq!(ImageLayer::named(name), expected, "{name}");
    }

    #[test]
    fn layers_have_names() {
        ImageLayer::ALL.iter().for_each(|layer| check(layer.name(), Some(*layer)));
        check("cryptoobject", Some(ImageLayer::CryptoObject));
        check("depth", None);
    }
}
