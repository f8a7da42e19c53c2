//! A material at one place.
//!
//! Source: Jensen et al. 2001, sections 2.1 to 2.3; subsurface facts, section 3 (measured).

use crate::compiled::subsurface::{ReducedAlbedo, internal_reflection};
use crate::math::{DVec3, Rgb, gray};
use std::f64::consts::PI;

/// Coefficients of scattering for each channel, per mm.
///
/// A channel that lets nothing through has 0 for its `scattering`, and some extinction that counts for nothing.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Material {
    /// α': what is left of light at each event.
    albedo: DVec3,
    /// σ'_s.
    pub(in crate::render) scattering: DVec3,
    /// σ'_t = σ'_s + σ_a.
    pub(in crate::render) extinction: DVec3,
    /// σ_tr = √(3 σ_a σ'_t), by which light that was scattered often falls off.
    effective: DVec3,
    /// Depths of the real source, and, above the surface, of the virtual one, in mm.
    dipole: [DVec3; 2],
    /// Mean free path in mm, of all channels together that let light through; 0 where one has no translucency.
    pub(in crate::render) mean_free_path: f64,
}

impl Material {
    /// Of a surface with a diffuse colour, in which light goes a `translucency` in mm from one event of scattering to the
    /// next; `ior` is relative to what is around, and says how much the surface mirrors back.
    pub(in crate::render) fn new(table: &ReducedAlbedo, color: Rgb, translucency: Rgb, ior: f64) -> Self {
        let albedo = DVec3::from_array(table.of(color));
        let path = translucency.as_dvec3();
        let lets_through = albedo.cmpgt(DVec3::ZERO) & path.cmpgt(DVec3::ZERO);
        let some = |v: DVec3, instead: DVec3| DVec3::select(lets_through, v, instead);
        let extinction = some((path * albedo).recip(), DVec3::ONE);
        let scattering = some(path.recip(), DVec3::ZERO);
        let real = extinction.recip();
        Self {
            albedo: some(albedo, DVec3::ZERO),
            scattering,
            extinction,
            effective: (3.0 * (extinction - scattering) * extinction).max(DVec3::ZERO).map(f64::sqrt),
            dipole: [real, real * (1.0 + 4.0 / 3.0 * internal_reflection(ior))],
            mean_free_path: if lets_through.any() && path.cmpgt(DVec3::ZERO).all() {
                let living = some(DVec3::ONE, DVec3::ZERO);
                f64::from(gray(living.as_vec3()) / gray((living * extinction).as_vec3()))
            } else {
                0.0
            },
        }
    }

    /// The dipole's diffuse reflectance R_d, per square mm, for light that comes out at the root of `square` mm from where
    /// it came in.
    pub(in crate::render) fn diffuse_reflectance(&self, square: f64) -> DVec3 {
        let of = |depth: DVec3| {
            let distance = (depth * depth + square).map(f64::sqrt);
            let falloff = (-self.effective * distance).exp();
            depth * (self.effective + distance.recip()) * falloff / (distance * distance)
        };
        self.albedo / (4.0 * PI) * (of(self.dipole[0]) + of(self.dipole[1]))
    }

    /// What is left of light that goes straight through, after so many mm.
    pub(in crate::render) fn transmittance(&self, length: f64) -> DVec3 {
        DVec3::select(self.scattering.cmpgt(DVec3::ZERO), (-self.extinction * length).exp(), DVec3::ZERO)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn material(color: Rgb, translucency: Rgb) -> Material {
        Material::new(&ReducedAlbedo::new(1.3), color, translucency, 1.3)
    }

    #[test]
    fn the_dipole_gives_back_the_colour() {
        // Over the whole plane, by rings that grow geometrically; a geometric sum is good to its step's square.
        let wanted = Rgb::new(0.75, 0.5, 0.25);
        let material = material(wanted, Rgb::splat(0.5));
        let (step, first) = (0.01f64, 1e-6f64);
        let ring = |k: i32| {
            let r = first * (step * f64::from(k)).exp();
            2.0 * PI * r * r * step * material.diffuse_reflectance(r * r)
        };
        let sum: DVec3 = (0..2300).map(ring).sum();
        assert!((sum - wanted.as_dvec3()).abs().max_element() < 1e-4, "{sum}");
    }

    #[test]
    fn what_lets_nothing_through_is_black_there() {
        let check = |material: Material, black: DVec3| {
            let light = material.diffuse_reflectance(1.0) + material.transmittance(1.0) + material.scattering;
            assert!(light.is_finite() && light.cmpeq(DVec3::ZERO) == black.cmpeq(DVec3::ZERO), "{light}");
            material.mean_free_path
        };
        assert!(check(material(Rgb::new(0.5, 0.0, 0.5), Rgb::ONE), DVec3::new(1.0, 0.0, 1.0)) > 0.0);
        assert_eq!(check(material(Rgb::splat(0.5), Rgb::new(0.0, 1.0, -1.0)), DVec3::Y), 0.0);
    }

    #[test]
    fn light_goes_as_far_as_its_coefficients_say() {
        let white = material(Rgb::splat(0.8), Rgb::splat(0.5));
        assert!((white.scattering.x - 2.0).abs() < 1e-12);
        assert!((white.transmittance(white.mean_free_path).x - (-1.0f64).exp()).abs() < 1e-6);
    }
}
