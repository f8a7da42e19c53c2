//! What light does below surfaces: settings, and what a pigment's colour says about a material.
//!
//! Source: H. W. Jensen, S. R. Marschner, M. Levoy, P. Hanrahan, "A Practical Model for Subsurface Light Transport",
//! SIGGRAPH 2001, for the dipole; docs/povray/subsurface.md (measured) for every rule.

use crate::math::Rgb;
use std::fmt::Write as _;

/// How light below surfaces is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subsurface {
    /// Rays to places where light that was scattered often comes in.
    pub multiple_samples: u32,
    /// Places where light may have been scattered once.
    pub single_samples: u32,
    /// Radiosity shines into materials, too.
    pub radiosity: bool,
    /// Length of a unit of the scene in mm.
    pub mm_per_unit: f64,
}

impl Subsurface {
    /// One line for each setting, for `dump`.
    pub(super) fn dump(&self) -> String {
        let mut out = String::new();
        let Self { multiple_samples, single_samples, radiosity, mm_per_unit } = self;
        let radiosity = if *radiosity { "with" } else { "without" };
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "subsurface light: samples {multiple_samples} and {single_samples}, {radiosity} radiosity, {mm_per_unit} mm a unit"
        );
        out
    }
}

/// How many intervals of the diffuse colour are told apart.
///
/// Source: POV-Ray's pictures agree with this table and not with the exact inverse (measured).
const N_STEPS: usize = 100;

/// Of a material with a smooth surface: from the colour it shows to how much of the light an event of scattering leaves.
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedAlbedo {
    /// At evenly spaced colours from 0 to 1.
    values: Vec<f64>,
}

impl ReducedAlbedo {
    /// Of a material with this index of refraction.
    pub fn new(ior: f64) -> Self {
        let internal_reflection = internal_reflection(ior);
        let step = |k: usize| inverse(k as f64 / N_STEPS as f64, internal_reflection);
        Self { values: (0..=N_STEPS).map(step).collect() }
    }

    /// Reduced albedo α' for each channel of a colour, linear between the steps; beyond 0 to 1 the value at the end.
    pub fn of(&self, color: Rgb) -> [f64; 3] {
        color.to_array().map(|channel| {
            let position = (f64::from(channel) * N_STEPS as f64).clamp(0.0, N_STEPS as f64);
            let k = (position as usize).min(N_STEPS - 1);
            let t = position - k as f64;
            self.values[k] + t * (self.values[k + 1] - self.values[k])
        })
    }
}

/// The ratio A of diffuse fluxes at a surface, which mirrors a part of what comes from within; for an index of refraction
/// over that of what is around.
pub fn internal_reflection(ior: f64) -> f64 {
    let mirrored = diffuse_fresnel(ior);
    (1.0 + mirrored) / (1.0 - mirrored)
}

/// Mean Fresnel reflectance of diffuse light.
///
/// Source: the fit of POV-Ray (measured); that of Jensen et al. gives 0.474 instead of 0.060 for an index of 1.3.
fn diffuse_fresnel(ior: f64) -> f64 {
    if ior >= 1.0 {
        let x = 1.0 - ior.recip();
        0.25 * (x + 3.0 * x.powf(4.5))
    } else {
        ior * ior - ior.powf(2.25)
    }
}

/// Diffuse reflectance of a half space under a dipole of reduced albedo α'. Source: Jensen et al., section 2.4.
fn reflectance(albedo: f64, internal_reflection: f64) -> f64 {
    let s = (3.0 * (1.0 - albedo)).sqrt();
    0.5 * albedo * (1.0 + (-4.0 / 3.0 * internal_reflection * s).exp()) * (-s).exp()
}

/// The albedo with a reflectance; there is one, since reflectance grows with it from 0 to 1.
fn inverse(wanted: f64, internal_reflection: f64) -> f64 {
    if wanted <= 0.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    // Each step gains a bit, and a number between 0 and 1 has no more than its mantissa's.
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (low + high);
        if reflectance(middle, internal_reflection) < wanted { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn albedo_inverts_reflectance_at_the_steps() {
        for ior in [0.8, 1.0, 1.3, 2.5] {
            let table = ReducedAlbedo::new(ior);
            for k in 0..=N_STEPS {
                let color = k as f64 / N_STEPS as f64;
                let [albedo, ..] = table.of(Rgb::splat(color as f32));
                // Colours are single precision, and near 1 the reflectance falls like the square root of 1 - albedo.
                let found = reflectance(albedo, internal_reflection(ior));
                assert!((found - color).abs() < 1e-5, "{ior} {color}: {found}");
            }
        }
    }

    #[test]
    fn albedo_of_more_than_white_is_that_of_white() {
        let table = ReducedAlbedo::new(1.3);
        assert_eq!(table.of(Rgb::new(-1.0, 2.0, 1.0))[1], table.of(Rgb::ONE)[2]);
        assert_eq!(table.of(Rgb::new(-1.0, 2.0, 0.0))[0], table.of(Rgb::ZERO)[2]);
    }
}
