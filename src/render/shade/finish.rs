//! The terms of a finish as functions of angles.
//!
//! Source: section 5 of the shading facts (measured).

use crate::compiled::texture::{Finish, Reflection};
use crate::math::noise::{Octaves, turbulence};
use crate::math::{DVec3, Rgb, power};
use std::f64::consts::{FRAC_PI_2, TAU};

/// How much a layer mirrors.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Reflectivity {
    /// Factor for each channel.
    pub(in crate::render) tint: Rgb,
    /// How much the mirrored ray counts.
    pub(in crate::render) importance: f32,
    /// Mirrored light is raised to 1 / exponent.
    pub(in crate::render) exponent: f32,
}

/// Geometry of light arriving at a surface.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Incidence {
    /// Unit direction of the view ray.
    pub(in crate::render) view: DVec3,
    /// Unit direction to the light.
    pub(in crate::render) light: DVec3,
    /// Unit perturbed normal.
    pub(in crate::render) normal: DVec3,
    /// Cosine between normal and light, not negative.
    pub(in crate::render) cosine: f64,
}

/// Tint of a metallic highlight or reflection: the pigment's colour head on, white at grazing angles.
pub(in crate::render) fn metallic_tint(metallic: f32, cosine: f64, pigment: Rgb) -> Rgb {
    if metallic == 0.0 {
        return Rgb::ONE;
    }
    let x = cosine.clamp(-1.0, 1.0).acos().abs() / FRAC_PI_2;
    let fresnel = (0.014_567_225 / (x - 1.12).powi(2) - 0.011_612_903).clamp(0.0, 1.0) as f32;
    Rgb::ONE + metallic * (1.0 - fresnel) * (pigment - Rgb::ONE)
}

/// Phong and Blinn highlights, without the light's colour.
pub(in crate::render) fn highlights(finish: &Finish, at: &Incidence, pigment: Rgb) -> Rgb {
    let mut amount = 0.0;
    if finish.phong > 0.0 {
        let mirrored = at.view - 2.0 * at.view.dot(at.normal) * at.normal;
        let q = mirrored.dot(at.light);
        // POV-Ray's own limit: tight highlights end where the power would be nothing.
        if q > 0.0 && (finish.phong_size < 60.0 || q > 0.0008) {
            amount += finish.phong * power(q, finish.phong_size) as f32;
        }
    }
    if finish.specular > 0.0 {
        let half = at.light - at.view;
        let q = half.dot(at.normal) / half.length();
        if q > 0.0 {
            amount += finish.specular * power(q, finish.specular_exponent) as f32;
        }
    }
    if amount == 0.0 { Rgb::ZERO } else { amount * metallic_tint(finish.metallic, at.cosine, pigment) }
}

/// Power of the cosine for diffuse light.
pub(in crate::render) fn brilliance(finish: &Finish, cosine: f64) -> f32 {
    power(cosine, finish.brilliance) as f32
}

/// Octaves by which the thickness of a thin film varies.
const FILM_OCTAVES: Octaves = Octaves { count: 5, lambda: 2.0, omega: 0.5 };

/// Thin film interference; `point` is where on the surface, in world space.
pub(in crate::render) fn irid(
    finish: &Finish,
    wavelength: Rgb,
    point: DVec3,
    light: DVec3,
    normal: DVec3,
    view: DVec3,
) -> Rgb {
    let thickness = finish.irid_turbulence.map_or(finish.irid_thickness, |(amount, generator)| {
        finish.irid_thickness * (1.0 + amount * (2.0 * turbulence(generator, FILM_OCTAVES, point) - 1.0))
    });
    let path = thickness * (normal.dot(light).abs() + normal.dot(view).abs());
    let factor = |lambda: f32| (1.0 + finish.irid_amount * (TAU * path / f64::from(lambda)).cos()) as f32;
    Rgb::new(factor(wavelength.x), factor(wavelength.y), factor(wavelength.z))
}

/// How much a mirroring layer mirrors at a signed cosine between the view and the normal; `None` for nothing.
///
/// `relative_ior` is that of the far side over the near side.
pub(in crate::render) fn reflectivity(
    reflection: &Reflection,
    pigment: Rgb,
    cosine: f64,
    relative_ior: impl FnOnce() -> f64,
) -> Option<Reflectivity> {
    let (min, max) = (reflection.min, reflection.max);
    let (plain, importance) = if reflection.fresnel {
        let share = fresnel(cosine, relative_ior());
        let r = max * share + min * (1.0 - share);
        (r, r.max_element())
    } else {
        let k = if min == max { 1.0 } else { power(1.0 - cosine, reflection.falloff) as f32 };
        (k * max + (1.0 - k) * min, max.max_element().max(min.max_element()))
    };
    let tint = plain * metallic_tint(reflection.metallic, cosine, pigment);
    (tint != Rgb::ZERO).then_some(Reflectivity { tint, importance, exponent: reflection.exponent })
}

/// Share of unpolarised light that a surface mirrors; 1 for total reflection.
pub(in crate::render) fn fresnel(cosine: f64, relative_ior: f64) -> f32 {
    let q = relative_ior * relative_ior + cosine * cosine - 1.0;
    if q <= 0.0 {
        return 1.0;
    }
    let g = q.sqrt();
    let (sum, difference) = (g + cosine, g - cosine);
    let parallel = (cosine * sum - 1.0) / (cosine * difference + 1.0);
    let share = 0.5 * (difference / sum).powi(2) * (1.0 + parallel * parallel);
    // A grazing ray at index 1 gives 0/0: nothing is mirrored there.
    if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) as f32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIGMENT: Rgb = Rgb::new(1.0, 0.5, 0.25);

    fn lit() -> Incidence {
        let light = DVec3::new(0.0, 1.0, -1.0).normalize();
        Incidence { view: DVec3::Z, light, normal: -DVec3::Z, cosine: -light.z }
    }

    fn check(found: Rgb, expected: [f32; 3]) {
        assert!((found - Rgb::from(expected)).abs().max_element() < 2e-5, "{found} instead of {expected:?}");
    }

    #[test]
    fn highlights_are_those_of_povray() {
        let show = |finish: Finish| 0.8 * highlights(&finish, &lit(), PIGMENT);
        let phong = || Finish { phong: 0.9, phong_size: 3.0, ..Finish::default() };
        check(show(phong()), [0.254551; 3]);
        check(show(Finish { metallic: 1.0, ..phong() }), [0.254551, 0.130617, 0.068650]);
        check(show(Finish { metallic: 0.5, ..phong() }), [0.254551, 0.192584, 0.161608]);
        let specular = |exponent: f64| Finish { specular: 0.5, specular_exponent: exponent, ..Finish::default() };
        check(show(specular(20.0)), [0.082109; 3]);
        check(show(specular(10.0)), [0.181216; 3]);
        check(show(specular(0.0)), [0.4; 3]);
    }

    #[test]
    fn reflections_are_those_of_povray() {
        let background = Rgb::new(0.2, 0.4, 0.6);
        let show = |min: f32, max: f32, fresnel: bool, falloff: f64, metallic: f32, ior: f64| {
            let (min, max) = (Rgb::splat(min), Rgb::splat(max));
            let reflection = Reflection { min, max, fresnel, falloff, exponent: 1.0, metallic };
            reflectivity(&reflection, PIGMENT, 0.5f64.sqrt(), || ior).map_or(Rgb::ZERO, |r| r.tint * background)
        };
        check(show(0.2, 0.8, false, 1.0, 0.0, 1.0), [0.075151, 0.150301, 0.225437]);
        check(show(0.2, 0.8, false, 3.0, 0.0, 1.0), [0.043015, 0.086030, 0.129046]);
        check(show(0.0, 1.0, true, 1.0, 0.0, 1.5), [0.010040, 0.020096, 0.030137]);
        check(show(0.1, 0.9, true, 1.0, 0.0, 1.0), [0.020005, 0.039994, 0.059998]);
        check(show(0.1, 0.9, true, 1.0, 0.0, 1.5), [0.028031, 0.056077, 0.084108]);
        check(show(0.8, 0.8, false, 1.0, 1.0, 1.0), [0.160006, 0.164202, 0.129458]);
        check(show(0.8, 0.8, false, 1.0, 0.5, 1.0), [0.160006, 0.242100, 0.304738]);
    }
}
