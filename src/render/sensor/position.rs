//! One image position: the rays that the camera sends through it.

use crate::compiled::camera::Projection;
use crate::compiled::geometry::RayKind;
use crate::math::{DVec3, Range, Ray};
use crate::render::camera::{Lens, RawRay, mesh_rays};
use crate::render::enough::{Moments, batches};
use crate::render::film::{Gather, Term};
use crate::render::medium::Interiors;
use crate::render::path::Path;
use crate::render::radiance::Radiance;
use crate::render::random::{Branch, Random};
use crate::render::transport::radiance;
use crate::render::worker::Worker;

/// The light through a continuous image position, pixel centres being integers.
pub(super) fn at_position<G: Gather>(worker: &mut Worker<'_>, [x, y]: [f64; 2]) -> G {
    let (camera, options) = (&worker.world().camera, worker.options());
    if let Some(lens) = &worker.prepared.lens {
        return through_lens(worker, lens, [x, y]);
    }
    let random = Random::at(x, y);
    if let Projection::Mesh(mesh) = &camera.projection {
        let rays = mesh_rays(camera, mesh, [x, y], [options.width, options.height]);
        let mut sum = G::default();
        for (k, ray) in rays.iter().enumerate() {
            let random = random.branch(Branch::Sample(k));
            sum.add_scaled(&along(worker, *ray, mesh.max_distance, random), 1.0);
        }
        return if rays.is_empty() { nothing() } else { sum.scaled(1.0 / rays.len() as f32) };
    }
    match RawRay::through(camera, x, y, options.width, options.height) {
        Some(raw) => along(worker, raw.finish(camera), f64::INFINITY, random),
        None => nothing(),
    }
}

/// Sends a ray through an image position and the middle of the lens, for what is noted on its way.
pub(in crate::render) fn look(worker: &mut Worker<'_>, [x, y]: [f64; 2]) {
    let (camera, options) = (&worker.world().camera, worker.options());
    if let Projection::Mesh(_) = &camera.projection {
        at_position::<Radiance>(worker, [x, y]);
    } else if let Some(raw) = RawRay::through(camera, x, y, options.width, options.height) {
        along::<Radiance>(worker, raw.finish(camera), f64::INFINITY, Random::at(x, y));
    }
}

/// What an image position gives through which the camera sends no ray.
pub(super) fn nothing<G: Gather>() -> G {
    let mut nothing = G::default();
    nothing.add(Term::Background, Radiance::CLEAR);
    nothing
}

/// The light through an image position and one place of the lens, given by a point of the unit square.
pub(in crate::render) fn at_lens_point<G: Gather>(
    worker: &mut Worker<'_>,
    lens: &Lens,
    [x, y]: [f64; 2],
    place: [f64; 2],
) -> G {
    let options = worker.options();
    match lens.ray_at(&worker.world().camera, [x, y], [options.width, options.height], place) {
        Some(ray) => along(worker, ray, f64::INFINITY, Random::at(x, y)),
        None => nothing(),
    }
}

/// Mean over the lens.
fn through_lens<G: Gather>(worker: &mut Worker<'_>, lens: &Lens, [x, y]: [f64; 2]) -> G {
    let (camera, options) = (&worker.world().camera, worker.options());
    let random = Random::at(x, y);
    let mut moments = Moments::default();
    let mut sum = G::default();
    for batch in batches(lens.n_rays()) {
        for _ in 0..batch {
            let k = moments.n();
            // A lens ray that does not exist counts as clear where samples are compared, but adds nothing.
            let mut light = Radiance::CLEAR;
            if let Some(ray) = lens.ray(camera, [x, y], [options.width, options.height], k) {
                let found: G = along(worker, ray, f64::INFINITY, random.branch(Branch::Sample(k)));
                light = found.light();
                sum.add_scaled(&found, 1.0);
            }
            moments.add(&light);
        }
        if lens.confidence.is_reached(&moments) {
            break;
        }
    }
    sum.scaled(1.0 / moments.n().max(1) as f32)
}

/// Follows a ray that starts at the camera and sees no farther than `far`; its direction is a unit vector.
// Always inline, as what makes the ray: it is put together where it stays.
#[inline(always)]
fn along<G: Gather>(worker: &mut Worker<'_>, ray: Ray, far: f64, random: Random) -> G {
    let path = path(worker, ray, far, random);
    let mut found: G = radiance(worker, &path);
    found.note_sample();
    found
}

/// The path of a ray that starts at the camera.
#[inline(always)]
pub(super) fn path(worker: &mut Worker<'_>, ray: Ray, far: f64, random: Random) -> Path {
    worker.statistics.camera_rays += 1;
    let prepared = worker.prepared;
    let interiors = match &prepared.camera_interiors {
        _ if !prepared.world.features.interiors_matter() => Interiors::default(),
        Some(known) if is_clear(worker, ray.origin) => known.clone(),
        _ => Interiors::at(prepared.world, ray.origin),
    };
    let range = Range { min: prepared.camera_near, max: far };
    Path {
        ray,
        range,
        kind: RayKind::Camera,
        bounce: 0,
        below: 0,
        level: 1,
        weight: 1.0,
        interiors,
        wavelength: None,
        random,
    }
}

/// Whether nothing lies between the middle of the lens and a point of it: then both are inside the same objects.
fn is_clear(worker: &mut Worker<'_>, origin: DVec3) -> bool {
    let world = worker.world();
    let shift = origin - world.camera.location;
    if shift == DVec3::ZERO {
        return true;
    }
    let across = Ray::new(world.camera.location, shift);
    let range = Range { min: 0.0, max: 1.0 };
    world.geometry.intersect(&across, range, RayKind::Probe, &mut worker.scratch).is_none()
}
