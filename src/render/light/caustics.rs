//! What photons add to a layer.
//!
//! Source: photon facts, section 5 (measured).

use super::direct::{Beam, answer, film};
use crate::math::Rgb;
use crate::render::photons::{Caught, Gathered};
use crate::render::shade::SurfaceLayer;
use crate::render::vertex::{Place as _, Vertex};
use crate::render::worker::Worker;

/// POV-Ray's cosine down to which a photon's light is spread over the surface that it meets.
const GRAZING: f64 = 0.1;

/// Photons at one texture of a vertex, looked for once for all layers, by the first layer's normal.
#[derive(Default)]
pub(in crate::render) struct Caustics {
    found: Option<Option<Gathered>>,
}

impl Caustics {
    /// What a layer sends back of the light that photons have brought.
    #[inline(never)]
    pub(in crate::render) fn reflected(
        &mut self,
        worker: &mut Worker<'_>,
        caught: &Caught<'_>,
        vertex: &Vertex<'_>,
        layer: &SurfaceLayer<'_>,
    ) -> Rgb {
        if !vertex.collects_photons(worker.world()) {
            return Rgb::ZERO;
        }
        let look = || caught.map.gather(caught.settings, (vertex.point(), layer.normal), &mut worker.nearby);
        let Some(Gathered { photons, extent }) = self.found.get_or_insert_with(look) else { return Rgb::ZERO };
        let wavelength = worker.world().settings.irid_wavelength;
        let mut sum = Rgb::ZERO;
        for &(direction, flux) in &*photons {
            if let Some(beam) = Beam::falling(vertex, layer, direction, false) {
                let spread = vertex.facing.dot(direction).clamp(GRAZING, 1.0) as f32;
                sum += answer(vertex, layer, &beam) * film(wavelength, vertex, layer, direction) * flux / spread;
            }
        }
        sum / *extent as f32
    }
}
