//! Media: densities become pigments, what is the same everywhere one factor.

use super::texture::{Refusal, TextureCompiler};
use crate::compiled::medium::{Density as Varying, Medium, Method, Phase, Sampling};
use crate::compiled::texture::Pigment;
use crate::math::Rgb;
use crate::scene::{self, Blend, Density, MapEntry, PigmentKind};
use crate::stack::roomy;
use std::sync::Arc;

/// Halving a step more often than a double has digits finds nothing new.
const MOST_HALVINGS: u32 = 53;

/// Compiles a medium.
///
/// # Errors
/// What is wrong with a density.
pub(super) fn medium(media: &scene::Media, compiler: &mut TextureCompiler<'_>) -> Result<Medium, Refusal> {
    let (kind, scattering, eccentricity, extinction) = media.scattering;
    let mut uniform = Rgb::ONE;
    let mut densities = Vec::new();
    for density in &media.density {
        match compiler.pigment(&pigment(density)).map_err(|r| r.at(media.span))? {
            Pigment::Solid(color) => uniform *= color.rgb,
            pigment => densities.push(Varying { side_by_side: pigment.is_side_by_side(), pigment }),
        }
    }
    densities.sort_by_key(|density: &Varying| density.pigment.is_dear());
    Ok(Medium {
        sampling: sampling(media),
        emission: media.emission,
        scattering: if kind == 0 { Rgb::ZERO } else { scattering },
        extinction: media.absorption + if kind == 0 { Rgb::ZERO } else { extinction as f32 * scattering },
        phase: phase(kind, eccentricity),
        uniform,
        densities,
        has_density: !media.density.is_empty(),
        ends_plain: media.density.last().is_none_or(|last| matches!(**last, Density::Solid(_))),
        collects_photons: media.collect,
    })
}

fn sampling(media: &scene::Media) -> Sampling {
    Sampling {
        method: match media.method {
            1 => Method::Random,
            2 => Method::Even,
            _ => Method::Adaptive,
        },
        intervals: media.intervals,
        min_samples: media.samples[0],
        max_samples: media.samples[1],
        jitter: media.jitter,
        depth: (media.aa_level - 1).min(MOST_HALVINGS),
        threshold: media.aa_threshold as f32,
        confidence: media.confidence,
        variance: media.variance,
        ratio: media.ratio,
    }
}

fn phase(kind: u8, eccentricity: f64) -> Option<Phase> {
    match kind {
        0 => None,
        1 => Some(Phase::Isotropic),
        2 => Some(Phase::Hazy),
        3 => Some(Phase::Murky),
        4 => Some(Phase::Rayleigh),
        _ => Some(Phase::HenyeyGreenstein(eccentricity)),
    }
}

/// A density as a pigment of the same pattern and map: both have the same default colours.
fn pigment(density: &Density) -> scene::Pigment {
    let kind = match density {
        Density::Solid(color) => PigmentKind::Solid(*color),
        Density::Colors(pattern, map) => PigmentKind::Colors(Box::new(pattern.clone()), Arc::new(map.clone())),
        Density::Densities(pattern, map) => PigmentKind::Pigments(Box::new(pattern.clone()), Arc::new(pigments(map))),
    };
    scene::Pigment { kind, ..scene::Pigment::default() }
}

fn pigments(map: &Blend<Arc<Density>>) -> Blend<Arc<scene::Pigment>> {
    let inside = |density: &Arc<Density>| Arc::new(roomy(|| pigment(density)));
    let entries = |list: &[MapEntry<Arc<Density>>]| {
        list.iter().map(|e| MapEntry { value: e.value, item: inside(&e.item) }).collect()
    };
    match map {
        Blend::Default => Blend::Default,
        Blend::Map(list) => Blend::Map(entries(list)),
        Blend::Average(list) => Blend::Average(entries(list)),
        Blend::List(list) => Blend::List(list.iter().map(inside).collect()),
    }
}
