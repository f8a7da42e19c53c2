//! Settings of light below surfaces, as rays need them.

use crate::compiled::subsurface::{ReducedAlbedo, Subsurface};
use crate::scene::Settings;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// One for each index of refraction: many interiors have the same.
#[derive(Default)]
pub(super) struct ReducedAlbedos(FxHashMap<u64, Arc<ReducedAlbedo>>);

impl ReducedAlbedos {
    pub(super) fn of(&mut self, ior: f64) -> Arc<ReducedAlbedo> {
        Arc::clone(self.0.entry(ior.to_bits()).or_insert_with(|| Arc::new(ReducedAlbedo::new(ior))))
    }
}

pub(super) fn subsurface(settings: &Settings) -> Option<Subsurface> {
    let subsurface = settings.subsurface?;
    let [multiple_samples, single_samples] = subsurface.samples;
    let (radiosity, mm_per_unit) = (subsurface.radiosity, settings.mm_per_unit);
    Some(Subsurface { multiple_samples, single_samples, radiosity, mm_per_unit })
}
