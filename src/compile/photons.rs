//! Settings of photons, as rays need them.

use crate::compiled::light::Light;
use crate::compiled::photons::{MediaPhotons, PhotonRole, PhotonTarget, Photons};
use crate::diag::{Diagnostic, SourceResult, Topic};
use crate::scene::{self, GatherRadius, PhotonFlags, Settings};

/// More photons than this would not fit into memory: each takes 20 bytes where it stays, and it may stay several times.
const MOST: f64 = 2e8;

/// Photons in media are looked for twice as far as is written, or as their density suggests.
const MEDIA_RADIUS: f64 = 2.0;

/// So many take minutes.
const MANY: f64 = 2e7;

/// What an object or a light says.
pub(super) fn role(flags: &PhotonFlags) -> PhotonRole {
    let PhotonFlags { refraction, reflection, collect, pass_through, .. } = *flags;
    PhotonRole { refraction, reflection, collect, lets_pass: pass_through, target: None }
}

/// The settings; `None` where none are shot.
///
/// # Errors
/// Where photons would be so many that no memory holds them.
pub(super) fn photons(
    settings: &Settings,
    targets: Vec<PhotonTarget>,
    lights: &[Light],
    shining: &[usize],
    warnings: &mut Vec<Diagnostic>,
) -> SourceResult<Option<Photons>> {
    let Some(written) = settings.photons.as_ref().filter(|p| p.spacing > 0.0 && !targets.is_empty()) else {
        return Ok(None);
    };
    let photons = compiled(written, settings, targets);
    let estimate = photons.estimate(shining.iter().map(|i| &lights[*i]));
    let n = written.count.map_or(estimate, f64::from);
    let message = || format!("about {n:.1e} photons would be shot");
    if n > MOST {
        let advice = "let `spacing` be larger, or give a `count`";
        return Err(vec![Diagnostic::error(written.span, message()).hint(advice)]);
    }
    if n > MANY {
        warnings.push(Diagnostic::warning(Topic::Cost, written.span, format!("{}, which takes long", message())));
    }
    if written.file.is_some() {
        let message = "photons are neither saved nor loaded: they are shot";
        warnings.push(Diagnostic::warning(Topic::Unsupported, written.span, message));
    }
    Ok(Some(photons))
}

/// What is written, if it is above 0.
fn radius(written: &GatherRadius) -> Option<f64> {
    written.length.filter(|length| *length > 0.0).map(|length| length * written.factor)
}

fn compiled(written: &scene::Photons, settings: &Settings, targets: Vec<PhotonTarget>) -> Photons {
    Photons {
        targets,
        spacing: written.spacing,
        count: written.count,
        gather: written.gather.map(|n| n as usize),
        jitter: written.jitter,
        autostop: written.autostop,
        expand_increase: written.expand_increase,
        expand_minimum: written.expand_minimum as usize,
        radius: radius(&written.surface_radius),
        radius_factor: written.surface_radius.factor,
        media: (written.media_steps > 0).then_some(MediaPhotons {
            steps: written.media_steps,
            factor: written.media_factor,
            radius: radius(&written.media_radius).map(|radius| MEDIA_RADIUS * radius),
            radius_factor: MEDIA_RADIUS * written.media_radius.factor,
        }),
        max_trace_level: written.max_trace_level.unwrap_or(settings.max_trace_level),
        adc_bailout: written.adc_bailout.unwrap_or(settings.adc_bailout) as f32,
    }
}
