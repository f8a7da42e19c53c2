//! Light sources: angles become cosines, defaults become what they mean.

use super::geometry::{PlacedLight, compile_object};
use super::photons;
use crate::compiled::light::{Area, Beam, Light};
use crate::diag::{Diagnostic, SourceResult, Topic};
use crate::math::DVec3;
use crate::scene::{self, LightKind};

/// Compiles a light that stands in world space.
///
/// # Errors
/// What is wrong with a `projected_through` object.
pub(super) fn light(placed: &PlacedLight) -> SourceResult<Light> {
    let light = &placed.light;
    let projected_through = match &light.projected_through {
        Some(object) => Some(Box::new(compile_object(object)?)),
        None => None,
    };
    // POV-Ray's own limit for a fade distance.
    let fades = light.fade_power > 0.0 && light.fade_distance.abs() > 1e-10;
    // `area_illumination` without `area_light` is written as a light without extent.
    let extended = light.area.filter(|a| a.axis1 != DVec3::ZERO || a.axis2 != DVec3::ZERO);
    Ok(Light {
        location: light.location,
        color: light.color,
        dark: Light::dark(light.color),
        beam: beam(light.kind),
        axis: light.axis,
        point_at: light.point_at,
        parallel: light.parallel,
        shadowless: light.kind == LightKind::Shadowless,
        fade: fades.then_some((light.fade_distance, light.fade_power)),
        area: extended.as_ref().map(area),
        two_sided: extended.is_none() && light.area.is_some_and(|a| a.area_illumination),
        projected_through,
        media_attenuation: light.media_attenuation && light.media_interaction,
        lights_media: light.media_interaction && light.kind != LightKind::Shadowless,
        photons: photons::role(&light.photons),
        samples_shoot: light.photons.area_light && extended.is_some(),
    })
}

fn beam(kind: LightKind) -> Beam {
    match kind {
        LightKind::Point | LightKind::Shadowless => Beam::Even,
        LightKind::Spot { radius_deg, falloff_deg, tightness } => Beam::Spot {
            cos_radius: radius_deg.to_radians().cos(),
            cos_falloff: falloff_deg.to_radians().cos(),
            tightness,
        },
        LightKind::Cylinder { radius, falloff, tightness } => Beam::Cylinder { radius, falloff, tightness },
    }
}

fn area(area: &scene::AreaLight) -> Area {
    Area {
        axis1: area.axis1,
        axis2: area.axis2,
        n1: area.size1.max(1) as usize,
        n2: area.size2.max(1) as usize,
        adaptive: area.adaptive,
        jitter: area.jitter,
        circular: area.circular || area.orient,
        orient: area.orient,
        illumination: area.area_illumination,
    }
}

/// What lights say that is not done yet.
pub(super) fn warnings(placed: &PlacedLight) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    if let Some(area) = placed.light.area
        && u64::from(area.size1) * u64::from(area.size2) > 1_000_000
    {
        let message = format!("an area light of {} x {} samples will take very long", area.size1, area.size2);
        warnings.push(Diagnostic::warning(Topic::Cost, placed.span, message));
    }
    warnings
}
