//! The recursion of Whitted's paper: what a ray meets is lit, and its mirrored and refracted rays are followed in turn.
//!
//! Source: T. Whitted, "An Improved Illumination Model for Shaded Display", Communications of the ACM 23 (6), 1980;
//! the order of terms is that of section 2 of the shading facts (measured).

mod air;
mod dispersion;
mod global_light;
mod irradiance;
mod photon;
mod secondary;
mod surface;
mod told;
mod translucence;

pub(super) use air::escaped;
pub(super) use photon::{Arrived, Flight};
pub(super) use told::{Story, told};

use super::environment;
use super::film::{Gather, Term};
use super::light::ArrivingLight;
use super::path::Path;
use super::radiance::Radiance;
use super::random::Random;
use super::shade::{Known, Layers, Lookup, TexturePoint, TextureSpace, context, resolve, texture_space};
use super::statistics::Statistics;
use super::vertex::Vertex;
use super::worker::Worker;
use crate::compiled::geometry::{Hit, Surface};
use crate::compiled::texture::Frame;
use crate::math::Rgb;
use air::through_media;
use secondary::{Boundary, Refraction, mirrored};
use surface::{Mirror, Shaded, shade};

/// The light that comes along a ray, towards its origin.
pub(super) fn radiance<G: Gather>(worker: &mut Worker<'_>, path: &Path) -> G {
    if path.weight < worker.adc_bailout(path) {
        return G::default();
    }
    match worker.intersect(path) {
        Some(hit) => {
            let surface = worker.world().geometry.surface(&path.ray, &hit);
            reflected(worker, path, &hit, &surface, None)
        }
        None => escaped(worker, path, environment::radiance(worker.world(), worker.options(), path)),
    }
}

/// The light that what a ray met sends back along it.
#[inline(always)]
pub(super) fn reflected<G: Gather>(
    worker: &mut Worker<'_>,
    path: &Path,
    hit: &Hit,
    surface: &Surface,
    known: Option<Known<'_>>,
) -> G {
    let world = worker.world();
    let vertex = Vertex::new(path, hit.t, surface);
    let mut context = context(surface, vertex.view(), vertex.facing);
    let mut lookup = Lookup { context: &mut context, lane: known.and_then(|known| known.lane) };
    let mut arriving = ArrivingLight::default();
    let mut found = G::default();
    for (i, seen) in surface.textures.iter().enumerate() {
        if seen.weight < world.settings.adc_bailout {
            continue;
        }
        let mut room = None;
        let TextureSpace { point, texture_from_world } = match known {
            Some(known) => known.space,
            None => texture_space(world, surface, hit, seen, &mut room),
        };
        let mut frame = Frame::new(texture_from_world);
        let at = TexturePoint { point, plain: true, random: path.random.texture(i) };
        let mut of_layers =
            |layers: Layers<'_>, lookup: &mut Lookup<'_>| layered(worker, &vertex, &layers, lookup, &mut arriving);
        let of_texture: G = resolve(world.texture(seen.texture), at, &mut frame, &mut lookup, &mut of_layers);
        found.add_scaled(&of_texture, seen.weight);
    }
    found.note_hit(surface, hit.t, vertex.facing);
    through_media(worker, path, hit.t, surface, &mut found);
    found
}

/// The light from the layers of one texture: own and direct light, then what comes through, then what is mirrored.
fn layered<G: Gather>(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    layers: &Layers<'_>,
    lookup: &mut Lookup<'_>,
    arriving: &mut ArrivingLight,
) -> G {
    let mut shaded: Shaded<'_, G> = Shaded::default();
    shade(worker, vertex, layers, lookup, arriving, &mut shaded);
    let mut total_reflection = None;
    if let Some(boundary) = &shaded.beyond {
        let (term, light) = transmitted(worker, vertex, boundary);
        shaded.found.add(term, light);
        total_reflection = (term == Term::Reflection).then_some(boundary.normal);
    }
    let is_left = |mirror: &&Mirror<'_>| !total_reflection.is_some_and(|normal| mirror.has_normal(normal));
    for mirror in shaded.mirrors.iter().filter(is_left) {
        shaded.found.add(Term::Reflection, Radiance::opaque(mirror_image(worker, vertex, mirror, layers.random())));
    }
    shaded.found
}

/// The light that comes through a surface, or is reflected there in full.
fn transmitted(worker: &mut Worker<'_>, vertex: &Vertex<'_>, boundary: &Boundary<'_>) -> (Term, Radiance) {
    let rays = Refraction::new(worker, vertex, boundary);
    let mut sum = Radiance::BLACK;
    for i in 0..rays.n_rays() {
        let ray = rays.ray(vertex, boundary, i);
        let found = followed(worker, vertex, &ray.path, |n| &mut n.transmitted_rays);
        sum.rgb += ray.hue * found.rgb;
        sum.transparency += found.transparency;
    }
    (rays.term(), rays.weighted(worker.world(), vertex, boundary, sum))
}

/// What one layer mirrors.
fn mirror_image(worker: &mut Worker<'_>, vertex: &Vertex<'_>, mirror: &Mirror<'_>, random: Random) -> Rgb {
    let path = mirrored(vertex, mirror.normal, mirror.weight(vertex), mirror.random(random));
    let light = followed(worker, vertex, &path, |n| &mut n.reflected_rays).rgb;
    mirror.tinted(worker, vertex, path.ray.direction, light)
}

/// The light along a ray that goes on from a vertex, as far as rays go on; `count` says where it is counted.
fn followed(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    path: &Path,
    count: fn(&mut Statistics) -> &mut u64,
) -> Radiance {
    if vertex.path.level >= worker.max_level(path) || path.weight < worker.adc_bailout(path) {
        return Radiance::BLACK;
    }
    *count(&mut worker.statistics) += 1;
    radiance(worker, path)
}
