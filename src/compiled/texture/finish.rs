//! How a surface answers to light, with everything that does not depend on the place worked out.

use crate::math::Rgb;
use crate::math::noise::NoiseGenerator;

/// Response to light; see section 3.4.5 of POV-Ray's manual for the terms.
#[derive(Clone, Debug, Default)]
pub struct Finish {
    /// Ambient and emission times the pigment, `ambient_light` included.
    pub own_light: Rgb,
    /// Emission alone, for where radiosity takes the place of ambient light.
    pub emission: Rgb,
    /// Diffuse amount on the lit side.
    pub diffuse: f32,
    /// Diffuse amount seen from the far side of the light.
    pub diffuse_back: f32,
    /// Diffuse amount before `albedo` scales it: how much of radiosity's light is sent back.
    pub raw_diffuse: f32,
    /// Exponent of the diffuse cosine.
    pub brilliance: f64,
    /// Random grain.
    pub crand: f32,
    /// Phong highlight and its exponent.
    pub phong: f32,
    /// See `phong`.
    pub phong_size: f64,
    /// Blinn highlight and its exponent.
    pub specular: f32,
    /// See `specular`.
    pub specular_exponent: f64,
    /// Tint of highlights by the pigment.
    pub metallic: f32,
    /// Thin film: amount.
    pub irid_amount: f64,
    /// Thin film: thickness.
    pub irid_thickness: f64,
    /// Thin film: variation of the thickness, with its noise.
    pub irid_turbulence: Option<(f64, NoiseGenerator)>,
    /// Mirror reflection, if any.
    pub reflection: Option<Reflection>,
    /// What is reflected does not go through.
    pub conserve_energy: bool,
    /// Legacy exponent of faked caustics.
    pub caustics: Option<f64>,
    /// Legacy factor of transmitted light.
    pub refraction: Option<f32>,
    /// Free path between events of scattering, in mm, where light goes below the surface.
    pub translucency: Option<Rgb>,
    /// Whether any light source can change the colour.
    pub uses_lights: bool,
}

/// Mirror reflection.
#[derive(Clone, Debug)]
pub struct Reflection {
    /// Head on.
    pub min: Rgb,
    /// At grazing angles.
    pub max: Rgb,
    /// Between the two by Fresnel's equations instead of a power.
    pub fresnel: bool,
    /// The power.
    pub falloff: f64,
    /// Reflected light is raised to 1 / exponent.
    pub exponent: f32,
    /// Tint by the pigment.
    pub metallic: f32,
}
