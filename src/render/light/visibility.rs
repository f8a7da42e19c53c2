//! What is in the way of light.
//!
//! Source: sections 3.5, 3.6 and 4 of the shading facts (measured).

use super::area::Grid;
use crate::compiled::World;
use crate::compiled::geometry::{Hit, RayKind, Shadow, Surface};
use crate::compiled::light::{Arrival, Light};
use crate::compiled::texture::Frame;
use crate::math::{DVec3, Range, Ray, Rgb, power};
use crate::render::medium::{Interiors, Passage, fog_transmittance};
use crate::render::random::{Branch, Random};
use crate::render::shade::{Layers, Lookup, TexturePoint, TextureSpace, context, resolve, texture_space};
use crate::render::vertex::{Place, facing};
use crate::render::worker::Worker;

/// How near to a light a surface may be and still not shade it, as a share of the distance: a
/// light that stands on a surface is meant to shine, and a millionth is far above rounding.
const LIGHT_MARGIN: f64 = 1e-6;

/// POV-Ray's distance by which a blocker must be nearer than the object a light is projected through.
const PROJECTION_MARGIN: f64 = 0.001;

/// The colour of a light, by its number, at a vertex after everything in its way.
///
/// With `bare` the light's own colour is filtered, without cone and fade: for lights whose
/// samples each have their own.
#[inline(always)]
pub(in crate::render) fn light_through<P: Place>(
    worker: &mut Worker<'_>,
    place: &P,
    index: usize,
    arrival: &Arrival,
    bare: bool,
) -> Rgb {
    if worker.world().lights[index].area.is_some() || bare {
        return through_area(worker, place, index, arrival, bare);
    }
    unblocked(worker, place, index, arrival)
}

/// The same for a light with an extent, or a bare one.
#[inline(never)]
fn through_area<P: Place>(worker: &mut Worker<'_>, place: &P, index: usize, arrival: &Arrival, bare: bool) -> Rgb {
    let light = &worker.world().lights[index];
    let color = if bare { light.color } else { arrival.color };
    let options = worker.options();
    let casts = !light.shadowless && options.shadows();
    let mut from = |direction, distance| unblocked(worker, place, index, &Arrival { direction, distance, color });
    match &light.area {
        Some(area) if casts && options.area_lights() && place.path().bounce == 0 => {
            Grid::new(place, index, light, area, from).mean()
        }
        _ => from(arrival.direction, arrival.distance),
    }
}

/// What is left of light on its way from a light or one of its samples.
fn unblocked<P: Place>(worker: &mut Worker<'_>, place: &P, index: usize, arrival: &Arrival) -> Rgb {
    let light = &worker.world().lights[index];
    let Arrival { direction, distance, color } = *arrival;
    let mut reach = distance;
    if let Some(window) = &light.projected_through {
        let (ray, range) = place.leave(direction);
        let range = Range { max: distance, ..range };
        match window.intersect(&ray, range, RayKind::Shadow, &mut worker.scratch) {
            Some(hit) => reach = hit.t - PROJECTION_MARGIN,
            None => return Rgb::ZERO,
        }
    }
    let options = worker.options();
    if light.shadowless || !options.shadows() {
        return color;
    }
    // Behind the plane of a parallel light, at a negative distance, there is no fog (measured).
    let fogged = worker.has_air(place.path())
        && light.media_attenuation
        && distance > 0.0
        && worker.world().atmosphere.dims_lights();
    color_after(worker, place, Way { direction, reach, fogged: fogged.then_some(distance), light: index }, color)
}

/// The straight way to a light.
struct Way {
    /// Unit, from the place.
    direction: DVec3,
    /// How far things are in the way.
    reach: f64,
    /// How far fog and media of the atmosphere are, if at all.
    fogged: Option<f64>,
    /// Number of the light.
    light: usize,
}

/// A colour after all surfaces, fog and media on a way.
#[inline(always)]
fn color_after<P: Place>(worker: &mut Worker<'_>, place: &P, way: Way, color: Rgb) -> Rgb {
    let world = worker.world();
    let (ray, range) = place.leave(way.direction);
    let range = Range { max: way.reach * (1.0 - LIGHT_MARGIN), ..range };
    worker.statistics.shadow_rays += 1;
    let opaque = (world.features.see_through_textures > 0).then_some(&world.opaque);
    match (world.geometry.shadow(&ray, range, way.light, opaque, &mut worker.scratch), way.fogged) {
        (Shadow::Blocked, _) => Rgb::ZERO,
        (Shadow::Clear, None) => color,
        (Shadow::Clear, Some(length)) => color * last_air(world, place, (&ray, length), place.interiors(), 0),
        (Shadow::Filtered, _) => color_filtered(worker, place, &way, (ray, range), color),
    }
}

/// A colour after surfaces that let light through.
///
/// As in POV-Ray the media of objects act on pieces that end on a surface, but not on the last one; those of the
/// atmosphere act on all, even in solid objects.
#[inline(never)]
fn color_filtered<P: Place>(
    worker: &mut Worker<'_>,
    place: &P,
    way: &Way,
    (mut ray, mut range): (Ray, Range),
    mut color: Rgb,
) -> Rgb {
    let world = worker.world();
    let fills = worker.has_air(place.path()) && world.features.filled_interiors > 0;
    let mut interiors = place.interiors().clone();
    let mut fogged = way.fogged;
    let mut n_pieces = 0;
    loop {
        let hit = world.geometry.intersect(&ray, range, RayKind::Shadow, &mut worker.scratch);
        worker.scratch.note_filtered(way.light, n_pieces > 0);
        let Some(hit) = hit else {
            return match fogged {
                Some(length) => color * last_air(world, place, (&ray, length), &interiors, n_pieces),
                None => color,
            };
        };
        if world.geometry.blocks(&hit, &world.opaque) {
            return Rgb::ZERO;
        }
        let surface = world.geometry.surface(&ray, &hit);
        if surface.textures.iter().all(|t| world.opaque[t.texture]) {
            return Rgb::ZERO;
        }
        if is_brought_by_photons(worker, place, &surface, &world.lights[way.light]) {
            return Rgb::ZERO;
        }
        if let Some(length) = &mut fogged {
            color *= fog(world, (&ray, hit.t), &interiors) * air(world, place, (&ray, hit.t), n_pieces);
            *length -= hit.t;
        }
        if fills {
            let media = interiors.media(world).into_iter();
            color *= passage(world, place, (&ray, hit.t), n_pieces + 1).transmittance(media);
        }
        n_pieces += 2;
        let way_through = (way.direction, RayKind::Shadow);
        let fade = match interiors.cross_at(world, &surface, way_through, &mut worker.scratch).leaving {
            true => world.interior(surface.interior.interior).fade.filter(|f| f.power > 0.0),
            false => None,
        };
        let through = surface_transmittance(worker, &surface, &hit, &ray);
        color *= through * fade.map_or(Rgb::ONE, |f| f.transmittance(hit.t));
        if world.lights[way.light].is_spent(color) {
            return Rgb::ZERO;
        }
        let left = range.max - hit.t;
        (ray, range) = surface.leave(way.direction);
        range.max = left;
        worker.statistics.shadow_rays += 1;
    }
}

/// What fog leaves of light on a piece of a way; none is in solid objects.
fn fog(world: &World, (ray, length): (&Ray, f64), inside: &Interiors) -> Rgb {
    if inside.are_hollow() { fog_transmittance(world, ray, length) } else { Rgb::ONE }
}

/// What the media of the atmosphere leave of light on piece number `n` of a way.
fn air(world: &World, place: &impl Place, (ray, length): (&Ray, f64), n: u32) -> Rgb {
    if world.atmosphere.media.is_empty() {
        return Rgb::ONE;
    }
    passage(world, place, (ray, length), n).transmittance(world.atmosphere.media.clone())
}

/// What fog and air leave on the last piece of a way, number `n`.
fn last_air(world: &World, place: &impl Place, (ray, length): (&Ray, f64), inside: &Interiors, n: u32) -> Rgb {
    if !inside.are_hollow() {
        return Rgb::ONE;
    }
    fog(world, (ray, length), inside) * air(world, place, (ray, length), n)
}

/// Whether light through a surface comes with photons, where they stay, and not straight from its source.
fn is_brought_by_photons(worker: &Worker<'_>, place: &impl Place, surface: &Surface, light: &Light) -> bool {
    let world = worker.world();
    if worker.prepared.photons.as_ref().is_none_or(|caught| caught.map.len() == 0) {
        return false;
    }
    let role = world.geometry.photon_role(surface);
    role.target.is_some() && role.refracts(&light.photons) && place.collects_photons(world)
}

/// Piece number `n` of a way to a light.
fn passage<'a>(world: &'a World, place: &impl Place, (ray, length): (&'a Ray, f64), n: u32) -> Passage<'a> {
    let random = place.random().toward(ray.direction).branch(Branch::Medium(n));
    Passage { world, ray, length, random }
}

/// What all textures of a surface let through.
pub(in crate::render) fn surface_transmittance(worker: &Worker<'_>, surface: &Surface, hit: &Hit, ray: &Ray) -> Rgb {
    let world = worker.world();
    let mut context = context(surface, ray.direction, facing(surface, ray.direction));
    let mut lookup = Lookup { context: &mut context, lane: None };
    let caustics = world.interior(surface.interior.interior).caustics;
    let mut sum = Rgb::ZERO;
    for seen in &surface.textures {
        let texture = world.texture(seen.texture);
        let mut room = None;
        let TextureSpace { point, texture_from_world } = texture_space(world, surface, hit, seen, &mut room);
        let mut frame = Frame::new(texture_from_world);
        let caustics = texture.top_layer().and_then(|top| top.finish.caustics).unwrap_or(caustics);
        let at = TexturePoint { point, plain: true, random: Random::default() };
        let mut through =
            |layers: Layers<'_>, lookup: &mut Lookup<'_>| transmittance(worker, &layers, lookup, caustics);
        sum += seen.weight * resolve(texture, at, &mut frame, &mut lookup, &mut through);
    }
    sum
}

/// What layers let through; their bumps count where light is gathered by faked caustics.
fn transmittance(worker: &Worker<'_>, layers: &Layers<'_>, lookup: &mut Lookup<'_>, caustics: f64) -> Rgb {
    let mut filter = Rgb::ONE;
    for layer in layers.iter() {
        if let Some(color) = layer.color(lookup, worker.options()) {
            filter *= color.transmittance();
        }
        if caustics != 0.0 {
            let normal = layer.normal(lookup, worker.options());
            filter *= 1.0 + power(normal.dot(lookup.context.direction).abs(), caustics) as f32;
        }
    }
    filter
}
