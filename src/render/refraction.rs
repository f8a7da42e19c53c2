//! Light through a surface: indices of refraction, the list of objects a ray is in, total reflection.
//!
//! Source: sections 7 and 8 of the shading facts (measured).

use super::dispersion;
use super::finish;
use super::gather::Gather;
use super::layers::{Place, reflected};
use super::ray::{Inside, Interiors, Path, Radiance};
use super::tracer::Tracer;
use crate::compiled::geometry::{RayKind, Surface};
use crate::compiled::texture::Finish;
use crate::math::{DVec3, Rgb, gray};

/// POV-Ray's difference from 1 below which a ray goes straight on.
const STRAIGHT: f64 = 1e-10;

/// What fills the object that was hit, with legacy finish keywords worked in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Substance {
    inside: Inside,
    dispersion_samples: u32,
    refraction: f32,
}

/// Light from beyond a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Through {
    pub(super) radiance: Radiance,
    /// It comes from this side: nothing got through.
    pub(super) total_reflection: bool,
}

/// How a ray changes by crossing a surface.
struct Crossing {
    /// Index behind over index ahead.
    eta: f64,
    /// The same ratio for dispersion.
    dispersion: f64,
    samples: u32,
    interiors: Interiors,
    leaving: bool,
}

/// A ratio of indices, or of dispersions. Between two objects POV-Ray holds it in single precision, but not where one
/// side is air (measured).
fn ratio(a: f64, b: f64) -> f64 {
    f64::from((a / b) as f32)
}

/// Index of the far side over that of the near side, for Fresnel's equations.
///
/// Where the ray leaves an object that lies in another, this is the ratio that refraction
/// uses; POV-Ray takes 1 there and mirrors nothing.
pub(super) fn relative_ior(interiors: &Interiors, substance: &Substance) -> f64 {
    let own = substance.inside;
    let Some(last) = interiors.last() else { return own.ior };
    match interiors.iter().position(|i| i.key == own.key) {
        None => own.ior / last.ior,
        Some(0) if interiors.len() == 1 => 1.0 / own.ior,
        Some(_) => last.ior / own.ior,
    }
}

fn crossing(interiors: &Interiors, substance: &Substance) -> Crossing {
    let own = substance.inside;
    let mut list = Interiors::from_slice(interiors);
    let samples = substance.dispersion_samples;
    let last = interiors.last();
    let Some(at) = interiors.iter().position(|i| i.key == own.key) else {
        list.push(own);
        let air = (1.0 / own.ior, 1.0 / own.dispersion);
        let (eta, dispersion) = last.map_or(air, |l| (ratio(l.ior, own.ior), ratio(l.dispersion, own.dispersion)));
        return Crossing { eta, dispersion, samples, interiors: list, leaving: false };
    };
    let is_last = at + 1 == interiors.len();
    list.remove(at);
    if !is_last {
        return Crossing { eta: 1.0, dispersion: 1.0, samples, interiors: list, leaving: true };
    }
    let air = (own.ior, own.dispersion);
    let (eta, dispersion) = list.last().map_or(air, |l| (ratio(own.ior, l.ior), ratio(own.dispersion, l.dispersion)));
    Crossing { eta, dispersion, samples, interiors: list, leaving: true }
}

impl Tracer<'_> {
    /// What fills the object behind a surface; `legacy` is the finish of a plain texture's top layer.
    pub(super) fn substance(&self, surface: &Surface, legacy: Option<&Finish>) -> Substance {
        let interior = self.world.interior(surface.interior.interior);
        let legacy_ior = legacy.and_then(|f| f.ior);
        Substance {
            inside: Inside {
                key: surface.interior,
                hollow: surface.hollow,
                ior: legacy_ior.unwrap_or(interior.ior),
                dispersion: if legacy_ior.is_some() { 1.0 } else { interior.dispersion },
            },
            dispersion_samples: interior.dispersion_samples,
            refraction: legacy.map_or(interior.refraction, |f| f.refraction.unwrap_or(1.0)),
        }
    }

    /// Light that comes through a surface whose layers let `filter` through.
    pub(super) fn transmit(
        &mut self,
        place: &Place<'_>,
        substance: &Substance,
        normal: DVec3,
        filter: Rgb,
        top_finish: Option<&Finish>,
    ) -> Through {
        let path = place.path;
        let crossing = crossing(&path.interiors, substance);
        let mut attenuation = Rgb::splat(substance.refraction);
        if crossing.leaving
            && let Some(fade) = self.world.interior(substance.inside.key.interior).fade
        {
            attenuation *= fade.transmittance(place.length);
        }
        let weight = path.weight * filter.abs().max_element();
        let straight = (crossing.eta - 1.0).abs() < STRAIGHT && (crossing.dispersion - 1.0).abs() < STRAIGHT;
        if straight {
            let beyond =
                self.beyond(place, path.ray.direction, weight, path.level, crossing.interiors, path.wavelength);
            return filtered(beyond, attenuation * filter, filter);
        }
        let splits = path.wavelength.is_none() && (crossing.dispersion - 1.0).abs() >= STRAIGHT;
        if splits {
            return self.split(place, &crossing, normal, weight, attenuation, filter);
        }
        let eta =
            path.wavelength.map_or(crossing.eta, |w| dispersion::index_ratio(crossing.eta, crossing.dispersion, w));
        match refracted(path.ray.direction, normal, eta) {
            Some(direction) => {
                let beyond = self.beyond(place, direction, weight, path.level + 1, crossing.interiors, path.wavelength);
                filtered(beyond, attenuation * filter, filter)
            }
            None => {
                let mut mirrored = self.mirrored_within(place, normal, weight);
                if let Some(finish) = top_finish.filter(|f| f.irid_amount != 0.0) {
                    let direction = reflected(path.ray.direction, normal, place.facing());
                    let wavelength = self.world.settings.irid_wavelength;
                    mirrored.rgb *=
                        finish::irid(finish, wavelength, place.surface.point, direction, normal, path.ray.direction);
                }
                let radiance = Radiance { rgb: attenuation * mirrored.rgb, transparency: 0.0 };
                Through { radiance, total_reflection: true }
            }
        }
    }

    /// White light in bands of wavelengths, each bent by itself.
    fn split(
        &mut self,
        place: &Place<'_>,
        crossing: &Crossing,
        normal: DVec3,
        weight: f32,
        attenuation: Rgb,
        filter: Rgb,
    ) -> Through {
        let path = place.path;
        let n = crossing.samples.max(2);
        let mut sum = Radiance::BLACK;
        for band in 0..n {
            let (wavelength, hue) = dispersion::band(band, n);
            let eta = dispersion::index_ratio(crossing.eta, crossing.dispersion, wavelength);
            let light = match refracted(path.ray.direction, normal, eta) {
                Some(direction) => {
                    let interiors = Interiors::from_slice(&crossing.interiors);
                    self.beyond(place, direction, weight, path.level + 1, interiors, Some(wavelength))
                }
                None => self.mirrored_within(place, normal, weight),
            };
            sum.rgb += hue * light.rgb;
            sum.transparency += light.transparency;
        }
        filtered(sum.scaled(1.0 / n as f32), attenuation * filter, filter)
    }

    /// Follows a ray to the far side.
    fn beyond(
        &mut self,
        place: &Place<'_>,
        direction: DVec3,
        weight: f32,
        level: u32,
        interiors: Interiors,
        wavelength: Option<f64>,
    ) -> Radiance {
        let path = place.path;
        if path.level >= self.world.settings.max_trace_level {
            return Radiance::BLACK;
        }
        self.statistics.transmitted_rays += 1;
        let (ray, range) = place.surface.leave(direction);
        let kind = if path.kind == RayKind::Reflected { RayKind::Reflected } else { RayKind::Refracted };
        self.trace(&Path { ray, range, kind, level, weight, interiors, wavelength })
    }

    fn mirrored_within(&mut self, place: &Place<'_>, normal: DVec3, weight: f32) -> Radiance {
        let direction = reflected(place.path.ray.direction, normal, place.facing());
        self.reflect(place, direction, weight)
    }

    /// Follows a ray on this side; its list of objects stays.
    pub(super) fn reflect(&mut self, place: &Place<'_>, direction: DVec3, weight: f32) -> Radiance {
        let path = place.path;
        if path.level >= self.world.settings.max_trace_level || weight < self.world.settings.adc_bailout {
            return Radiance::BLACK;
        }
        self.statistics.reflected_rays += 1;
        let (ray, range) = place.surface.leave(direction);
        self.trace(&Path {
            ray,
            range,
            kind: RayKind::Reflected,
            level: path.level + 1,
            weight,
            interiors: Interiors::from_slice(&path.interiors),
            wavelength: path.wavelength,
        })
    }
}

fn filtered(beyond: Radiance, factor: Rgb, filter: Rgb) -> Through {
    // The backdrop shows through by the same factors, as greys.
    let attenuation = gray(factor).abs().min(gray(filter).abs()).min(1.0);
    let radiance = Radiance { rgb: factor * beyond.rgb, transparency: attenuation * beyond.transparency };
    Through { radiance, total_reflection: false }
}

/// Snell's law for a unit direction; `None` for total reflection.
fn refracted(direction: DVec3, normal: DVec3, eta: f64) -> Option<DVec3> {
    let normal = if direction.dot(normal) <= 0.0 { normal } else { -normal };
    let n = -direction.dot(normal);
    let q = 1.0 + eta * eta * (n * n - 1.0);
    (q >= 0.0).then(|| (eta * direction + (eta * n - q.sqrt()) * normal).normalize_or(direction))
}
