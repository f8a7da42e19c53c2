//! What a ray meets where it meets nothing, and on its way.

use super::texture::Pigment;
use crate::math::noise::{NoiseGenerator, Octaves};
use crate::math::{Color, DVec3, Rgb, Transform};
use std::ops::Range;

/// Background, skies, fogs, rainbows.
#[derive(Debug, Default)]
pub struct Atmosphere {
    /// `background`, if any.
    pub background: Option<Background>,
    /// The scene ends below version 3.7: a picture with alpha shows no sky, and layers of the sky mix by older rules.
    pub legacy: bool,
    /// Pigments on an infinite sphere, if any.
    pub sky: Option<Sky>,
    /// In file order.
    pub fogs: Vec<Fog>,
    /// In file order.
    pub rainbows: Vec<Rainbow>,
    /// Which of the world's media are everywhere outside of solid objects.
    pub media: Range<usize>,
}

impl Atmosphere {
    /// Whether a ray passes neither fog nor rainbow on its way.
    pub fn is_clear(&self) -> bool {
        self.fogs.is_empty() && self.rainbows.is_empty()
    }

    /// Whether light loses something on its way through it.
    pub fn dims_lights(&self) -> bool {
        !(self.fogs.is_empty() && self.media.is_empty())
    }
}

/// `background`, as rays of different kinds see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Background {
    /// In a picture with alpha.
    pub translucent: Color,
    /// In a picture with alpha, as mirrors show it.
    pub mirrored: Rgb,
    /// In a picture without alpha.
    pub opaque: Rgb,
}

/// `sky_sphere`.
#[derive(Debug)]
pub struct Sky {
    /// Layers, lowest first.
    pub pigments: Vec<Pigment>,
    /// Colour factor.
    pub emission: Rgb,
    /// Carries unit directions, taken as points.
    pub sky_from_world: Transform,
}

impl Sky {
    /// Whether it pays to find the colours of neighbours at once.
    pub fn is_side_by_side(&self) -> bool {
        self.pigments.iter().any(Pigment::is_side_by_side) && !self.pigments.iter().any(Pigment::sees_normals)
    }
}

/// `fog`.
#[derive(Clone, Debug)]
pub struct Fog {
    /// Density falls off with height.
    pub ground: bool,
    /// Way after which 1/e of the light is left; negative brightens.
    pub distance: f64,
    /// Colour, and how much light it lets through at least.
    pub color: Color,
    /// Height up to which a ground fog is constant.
    pub offset: f64,
    /// Height over which it falls to a quarter.
    pub altitude: f64,
    /// Unit.
    pub up: DVec3,
    /// Thinner and thicker places, if any.
    pub turbulence: Option<FogTurbulence>,
}

/// `turbulence` of a fog.
#[derive(Clone, Copy, Debug)]
pub struct FogTurbulence {
    /// Scale of the noise.
    pub scale: DVec3,
    /// Octaves of the noise.
    pub octaves: Octaves,
    /// Which noise.
    pub generator: NoiseGenerator,
    /// Amount.
    pub depth: f64,
}

/// `rainbow`; angles in radians.
#[derive(Debug)]
pub struct Rainbow {
    /// Unit direction away from the sun.
    pub direction: DVec3,
    /// Unit, perpendicular to `direction`.
    pub up: DVec3,
    /// Unit, perpendicular to both.
    pub right: DVec3,
    /// Middle of the band.
    pub angle: f64,
    /// Width of the band.
    pub width: f64,
    /// Strength, as that of a fog.
    pub distance: f64,
    /// Random displacement within the band.
    pub jitter: f64,
    /// Half of the visible arc.
    pub arc: f64,
    /// Half of the arc that does not fade.
    pub falloff: f64,
    /// The band's colours over 0..1.
    pub pigment: Pigment,
}
