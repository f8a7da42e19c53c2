//! Finishes: what does not depend on the place is worked out once.

use super::noise_generator;
use crate::compiled::texture::{Finish, Reflection};
use crate::math::Rgb;
use crate::omission::{Ledger, Omission};
use crate::scene::{self, Settings};

pub(super) fn compile(finish: &scene::Finish, settings: &Settings, ledger: &mut Ledger) -> Finish {
    let mut is_needed = |is_zero: bool| !is_zero || !ledger.omits(Omission::FinishTerms, 0);
    let mirrors = is_needed(finish.reflection_max == Rgb::ZERO && finish.reflection_min == Rgb::ZERO);
    let uses_lights =
        is_needed([finish.diffuse, finish.diffuse_back, finish.specular, finish.phong].iter().all(|term| *term == 0.0));
    Finish {
        own_light: finish.ambient * settings.ambient_light + finish.emission,
        emission: finish.emission,
        diffuse: finish.diffuse,
        diffuse_back: finish.diffuse_back,
        raw_diffuse: finish.raw_diffuse,
        brilliance: f64::from(finish.brilliance),
        crand: finish.crand,
        phong: finish.phong,
        phong_size: f64::from(finish.phong_size),
        specular: finish.specular,
        specular_exponent: f64::from(finish.specular_exponent),
        metallic: finish.metallic,
        irid_amount: f64::from(finish.irid_amount),
        irid_thickness: f64::from(finish.irid_thickness),
        irid_turbulence: (finish.irid_turbulence != 0.0)
            .then(|| (f64::from(finish.irid_turbulence), noise_generator(settings))),
        reflection: mirrors.then(|| Reflection {
            min: finish.reflection_min,
            max: finish.reflection_max,
            fresnel: finish.reflection_fresnel,
            falloff: f64::from(finish.reflection_falloff),
            exponent: finish.reflection_exponent,
            metallic: finish.reflection_metallic,
        }),
        conserve_energy: finish.conserve_energy,
        caustics: finish.caustics.map(f64::from),
        refraction: finish.refraction,
        translucency: finish.subsurface_translucency.filter(|_| settings.subsurface.is_some()),
        uses_lights,
    }
}
