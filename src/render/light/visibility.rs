//! What is in the way of light.
//!
//! Source: sections 3.5, 3.6 and 4 of the shading facts (measured).

use super::area::Grid;
use crate::compiled::geometry::{Hit, RayKind, Shadow, Surface};
use crate::compiled::light::{Arrival, Light};
use crate::compiled::texture::Frame;
use crate::math::{DVec3, Range, Ray, Rgb};
use crate::render::medium::{Interiors, fog_transmittance};
use crate::render::random::Random;
use crate::render::shade::{Layers, Lookup, TexturePoint, TextureSpace, resolve, texture_space};
use crate::render::vertex::{Vertex, facing};
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
#[inline]
pub(super) fn light_through(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    index: usize,
    arrival: &Arrival,
    bare: bool,
) -> Rgb {
    let light = &worker.world().lights[index];
    let color = if bare { light.color } else { arrival.color };
    let options = worker.options();
    let casts = !light.shadowless && options.shadows();
    let mut from = |direction, distance| arriving(worker, vertex, (index, light), direction, distance, color);
    match &light.area {
        Some(area) if casts && options.area_lights() && vertex.path.bounce == 0 => {
            Grid::new(vertex, index, light, area, from).mean()
        }
        _ => from(arrival.direction, arrival.distance),
    }
}

/// A colour on its way from a light or one of its samples.
fn arriving(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    (index, light): (usize, &Light),
    direction: DVec3,
    distance: f64,
    color: Rgb,
) -> Rgb {
    let mut reach = distance;
    if let Some(window) = &light.projected_through {
        let (ray, range) = vertex.leave(direction);
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
    let fogged = light.media_attenuation && distance > 0.0;
    let fogged = fogged && worker.has_air(vertex.path) && !worker.world().atmosphere.fogs.is_empty();
    let way = Way { direction, reach, fogged: fogged.then_some(distance), light: index };
    color_after(worker, vertex, way, color)
}

/// The straight way to a light.
struct Way {
    /// Unit, from the vertex.
    direction: DVec3,
    /// How far things are in the way.
    reach: f64,
    /// How far fog is, if at all.
    fogged: Option<f64>,
    /// Number of the light.
    light: usize,
}

/// A colour after all surfaces and fog on a way.
fn color_after(worker: &mut Worker<'_>, vertex: &Vertex<'_>, way: Way, mut color: Rgb) -> Rgb {
    let world = worker.world();
    let (mut ray, range) = vertex.leave(way.direction);
    let mut range = Range { max: way.reach * (1.0 - LIGHT_MARGIN), ..range };
    worker.statistics.shadow_rays += 1;
    let fog = |ray: &Ray, length: Option<f64>, inside: &Interiors| match length {
        Some(length) if inside.are_hollow() => fog_transmittance(world, ray, length),
        _ => Rgb::ONE,
    };
    let opaque = (world.features.see_through_textures > 0).then_some(&world.opaque);
    match world.geometry.shadow(&ray, range, way.light, opaque, &mut worker.scratch) {
        Shadow::Blocked => return Rgb::ZERO,
        Shadow::Clear => return color * fog(&ray, way.fogged, vertex.interiors()),
        Shadow::Filtered => {}
    }
    let mut interiors = None;
    let mut fogged = way.fogged;
    loop {
        let Some(hit) = world.geometry.intersect(&ray, range, RayKind::Shadow, &mut worker.scratch) else {
            worker.scratch.note_filtered(way.light, interiors.is_some());
            return color * fog(&ray, fogged, interiors.as_ref().unwrap_or(vertex.interiors()));
        };
        worker.scratch.note_filtered(way.light, interiors.is_some());
        if world.geometry.blocks(&hit, &world.opaque) {
            return Rgb::ZERO;
        }
        let surface = world.geometry.surface(&ray, &hit);
        if surface.textures.iter().all(|t| world.opaque[t.texture]) {
            return Rgb::ZERO;
        }
        let interiors = interiors.get_or_insert_with(|| vertex.interiors().clone());
        if let Some(length) = &mut fogged {
            color *= fog(&ray, Some(hit.t), interiors);
            *length -= hit.t;
        }
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

/// What all textures of a surface let through.
fn surface_transmittance(worker: &Worker<'_>, surface: &Surface, hit: &Hit, ray: &Ray) -> Rgb {
    let world = worker.world();
    let mut lookup = Lookup::new(surface, ray.direction, facing(surface, ray.direction), None);
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
            filter *= 1.0 + normal.dot(lookup.context.direction).abs().powf(caustics) as f32;
        }
    }
    filter
}
