//! What lies between the ends of a ray.

use crate::render::film::{Gather, Term};
use crate::render::medium::airlight;
use crate::render::path::Path;
use crate::render::radiance::Radiance;
use crate::render::worker::Worker;

/// POV-Ray's length of a ray that meets nothing, for fog.
const MISS_LENGTH: f64 = 2e10;

/// The light along a ray that meets nothing but a sky.
pub(in crate::render) fn escaped<G: Gather>(worker: &Worker<'_>, path: &Path, sky: Radiance) -> G {
    let mut found = G::default();
    found.add(Term::Background, sky);
    through_air(worker, path, MISS_LENGTH, &mut found);
    found
}

/// Carries what was found at the end of a ray through what is in the air.
#[inline(always)]
pub(super) fn through_air<G: Gather>(worker: &Worker<'_>, path: &Path, length: f64, found: &mut G) {
    if worker.has_air(path)
        && path.interiors.are_hollow()
        && let Some(air) = airlight(worker.world(), &path.ray, length, path.random)
    {
        found.pass(&air);
    }
}
