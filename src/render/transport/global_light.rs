//! Light that does not come straight from its sources: carried by photons, out of the material, from other surfaces.

use super::irradiance::Indirect;
use super::translucence::from_below;
use crate::math::Rgb;
use crate::render::film::{Gather, Term};
use crate::render::light::Caustics;
use crate::render::radiance::Radiance;
use crate::render::shade::SurfaceLayer;
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;

/// What is known of it at one texture of a vertex, for all layers.
#[derive(Default)]
pub(super) struct GlobalLight {
    caustics: Caustics,
    indirect: Indirect,
    /// Once light from everywhere went below a layer, those under it get none, as in POV-Ray.
    below_asks: bool,
}

impl GlobalLight {
    /// Adds what a layer behind `filter` sends back of it; `translucency` is there where light goes below the surface.
    #[inline(never)]
    pub(super) fn add<G: Gather>(
        &mut self,
        worker: &mut Worker<'_>,
        vertex: &Vertex<'_>,
        (layer, translucency): (&SurfaceLayer<'_>, Option<Rgb>),
        filter: Rgb,
        found: &mut G,
    ) {
        if vertex.path.kind.is_photon() {
            return;
        }
        let mut add = |term: Term, light: Rgb| found.add(term, Radiance::opaque(filter * light));
        if layer.finish.uses_lights
            && worker.wants_lights(vertex.path)
            && let Some(caught) = &worker.prepared.photons
        {
            add(Term::Caustics, self.caustics.reflected(worker, caught, vertex, layer));
        }
        if let Some((settings, translucency)) = worker.subsurface(vertex.path).zip(translucency) {
            add(Term::Subsurface, from_below(worker, vertex, layer, (settings, translucency)));
            self.below_asks |= settings.radiosity;
        }
        if worker.prepared.radiosity.is_some() && !self.below_asks {
            add(Term::Indirect, self.indirect.reflected(worker, vertex, layer, filter));
        }
    }
}
