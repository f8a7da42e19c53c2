//! Settings of photons, as rays need them.

use crate::compiled::light::Light;
use crate::compiled::photons::{PhotonRole, PhotonTarget, Photons};
use crate::diag::{Diagnostic, SourceResult, Topic};
use crate::scene::{self, PhotonFlags, Settings};

/// More photons than this would not fit into memory: each takes 20 bytes where it stays, and it may stay several times.
const MOST: f64 = 2e8;

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
    let not_yet = [
        (written.media_steps > 0, "photons are not left in media"),
        (written.file.is_some(), "photons are neither saved nor loaded: they are shot"),
    ];
    let warn = |(_, why): (bool, &str)| Diagnostic::warning(Topic::Unsupported, written.span, why);
    warnings.extend(not_yet.into_iter().filter(|(is_asked, _)| *is_asked).map(warn));
    Ok(Some(photons))
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
        radius: written.surface_radius.length.map(|radius| radius * written.surface_radius.factor),
        radius_factor: written.surface_radius.factor,
        max_trace_level: written.max_trace_level.unwrap_or(settings.max_trace_level),
        adc_bailout: written.adc_bailout.unwrap_or(settings.adc_bailout) as f32,
    }
}
