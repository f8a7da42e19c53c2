//! The recursion again, told step by step: what each ray meets in which space, its layers, light by light, and the rays
//! that go on from there.
//!
//! It goes the same way as the one that makes pictures, by the same functions, and comes to the same light to the bit;
//! a test holds the two together. Only what tells is beside them, so pictures pay nothing for it.

use super::secondary::{Boundary, Refraction, mirrored};
use super::surface::{Mirror, Shaded, shade};
use super::{escaped, through_media};
use crate::compiled::geometry::{Hit, Surface};
use crate::compiled::texture::Frame;
use crate::math::{DVec3, Rgb};
use crate::render::environment;
use crate::render::film::{Gather as _, Term};
use crate::render::light::{ArrivingLight, light_through};
use crate::render::path::Path;
use crate::render::radiance::{Mix as _, Radiance};
use crate::render::shade::{Layers, Lookup, TexturePoint, TextureSpace, context, resolve, texture_space};
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;
use std::fmt::Display;

/// What is told, an indented line for each step.
#[derive(Debug, Default)]
pub(in crate::render) struct Story {
    pub(in crate::render) text: String,
    depth: usize,
}

impl Story {
    pub(in crate::render) fn line(&mut self, text: impl Display) {
        use std::fmt::Write as _;
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{:width$}{text}", "", width = 2 * self.depth);
    }

    fn inside<T>(&mut self, tell: impl FnOnce(&mut Self) -> T) -> T {
        self.depth += 1;
        let told = tell(self);
        self.depth -= 1;
        told
    }
}

/// The light that comes along a ray, and how it comes about.
pub(in crate::render) fn told(worker: &mut Worker<'_>, path: &Path, what: &str, story: &mut Story) -> Radiance {
    let (origin, direction) = (vector(path.ray.origin), vector(path.ray.direction));
    story
        .line(format_args!("{what} ray from {origin} along {direction}, level {}, weight {}", path.level, path.weight));
    let light = story.inside(|story| {
        if path.weight < worker.adc_bailout(path) {
            story.line("counts for too little (adc_bailout)");
            return Radiance::default();
        }
        match worker.intersect(path) {
            Some(hit) => {
                let surface = worker.world().geometry.surface(&path.ray, &hit);
                reflected(worker, path, &hit, &surface, story)
            }
            None => {
                story.line("meets nothing: background, sky and what lies before them");
                escaped(worker, path, environment::radiance(worker.world(), worker.options(), path))
            }
        }
    });
    story.line(format_args!("{what} ray brings {}", color(light.rgb)));
    light
}

/// As the picture's own.
fn reflected(worker: &mut Worker<'_>, path: &Path, hit: &Hit, surface: &Surface, story: &mut Story) -> Radiance {
    let world = worker.world();
    let vertex = Vertex::new(path, hit.t, surface);
    let name = world.labels.object(world.labels.statement(surface.object));
    story.line(format_args!("meets {name} at distance {}", hit.t));
    world.geometry.way(&path.ray, hit).iter().for_each(|step| story.inside(|story| story.line(step)));
    let side = if surface.from_inside { ", from inside" } else { "" };
    story.line(format_args!(
        "back in the world: point {}, normal {}{side}",
        vector(surface.point),
        vector(surface.normal)
    ));
    let mut context = context(surface, vertex.view(), vertex.facing);
    let mut lookup = Lookup { context: &mut context, lane: None };
    let mut arriving = ArrivingLight::default();
    let mut found = Radiance::default();
    for (i, seen) in surface.textures.iter().enumerate() {
        if seen.weight < world.settings.adc_bailout {
            continue;
        }
        let mut room = None;
        let TextureSpace { point, texture_from_world } = texture_space(world, surface, hit, seen, &mut room);
        story.line(format_args!("texture {} at {} in its own space", seen.texture.number(), vector(point)));
        let mut frame = Frame::new(texture_from_world);
        let at = TexturePoint { point, plain: true, random: path.random.texture(i) };
        let mut of_layers = |layers: Layers<'_>, lookup: &mut Lookup<'_>| {
            story.inside(|story| layered(worker, &vertex, &layers, lookup, &mut arriving, story))
        };
        let of_texture: Radiance = resolve(world.texture(seen.texture), at, &mut frame, &mut lookup, &mut of_layers);
        found.add_scaled(&of_texture, seen.weight);
    }
    let before = found.rgb;
    through_media(worker, path, hit.t, surface, &mut found);
    if found.rgb != before {
        story.line(format_args!("fog and media on the way make it {}", color(found.rgb)));
    }
    found
}

/// As the picture's own.
fn layered(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    layers: &Layers<'_>,
    lookup: &mut Lookup<'_>,
    arriving: &mut ArrivingLight,
    story: &mut Story,
) -> Radiance {
    layers_told(worker, layers, lookup, story);
    lights_told(worker, vertex, story);
    let mut shaded: Shaded<'_, Radiance> = Shaded::default();
    shade(worker, vertex, layers, lookup, arriving, &mut shaded);
    story.line(format_args!("own and direct light: {}", color(shaded.found.rgb)));
    let mut total_reflection = None;
    if let Some(boundary) = &shaded.beyond {
        let (term, light) = transmitted(worker, vertex, boundary, story);
        shaded.found.add(term, light);
        total_reflection = (term == Term::Reflection).then_some(boundary.normal);
    }
    let is_left = |mirror: &&Mirror<'_>| !total_reflection.is_some_and(|normal| mirror.has_normal(normal));
    for mirror in shaded.mirrors.iter().filter(is_left) {
        let random = mirror.random(layers.random());
        let path = mirrored(vertex, mirror.normal, mirror.weight(vertex), random);
        let light = followed(worker, vertex, &path, "mirrored", story).rgb;
        let light = mirror.tinted(worker, vertex, path.ray.direction, light);
        story.line(format_args!("of it the layer mirrors {}", color(light)));
        shaded.found.add(Term::Reflection, Radiance::opaque(light));
    }
    shaded.found
}

/// Each layer's colour and normal; looking leaves no trace for those who look next.
fn layers_told(worker: &Worker<'_>, layers: &Layers<'_>, lookup: &mut Lookup<'_>, story: &mut Story) {
    let context = *lookup.context;
    for (depth, layer) in layers.iter().enumerate() {
        let normal = layer.normal(lookup, worker.options());
        let shown = match layer.color(lookup, worker.options()) {
            Some(c) => format!("{} filter {} transmit {}", color(c.rgb), c.filter, c.transmit),
            None => "nothing: the picture has a hole here".to_owned(),
        };
        story.line(format_args!("layer {depth} from the top: {shown}, normal {}", vector(normal)));
    }
    *lookup.context = context;
}

/// What comes from each light, before any layer answers.
fn lights_told(worker: &mut Worker<'_>, vertex: &Vertex<'_>, story: &mut Story) {
    let world = worker.world();
    for &index in world.lights_for(vertex.light_group()) {
        let light = &world.lights[index];
        let arrival = light.arrival(vertex.point(), light.location);
        let cosine = vertex.facing.dot(arrival.direction);
        let given = color(arrival.color);
        if cosine <= 0.0 {
            story.line(format_args!("light {index} stands behind the surface (cosine {cosine})"));
            continue;
        }
        let left = light_through(worker, vertex, index, &arrival, false);
        let fate = if left == Rgb::ZERO { "is blocked".to_owned() } else { format!("arrives as {}", color(left)) };
        story.line(format_args!(
            "light {index} gives {given} from {}, cosine {cosine}: {fate}",
            vector(arrival.direction)
        ));
    }
}

/// As the picture's own.
fn transmitted(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    boundary: &Boundary<'_>,
    story: &mut Story,
) -> (Term, Radiance) {
    let rays = Refraction::new(worker, vertex, boundary);
    let what = if rays.term() == Term::Reflection { "totally reflected" } else { "transmitted" };
    let mut sum = Radiance::BLACK;
    for i in 0..rays.n_rays() {
        let ray = rays.ray(vertex, boundary, i);
        let found = followed(worker, vertex, &ray.path, what, story);
        sum.rgb += ray.hue * found.rgb;
        sum.transparency += found.transparency;
    }
    let light = rays.weighted(worker.world(), vertex, boundary, sum);
    story.line(format_args!("of it the surface lets through {}", color(light.rgb)));
    (rays.term(), light)
}

/// As the picture's own.
fn followed(worker: &mut Worker<'_>, vertex: &Vertex<'_>, path: &Path, what: &str, story: &mut Story) -> Radiance {
    if vertex.path.level >= worker.max_level(path) {
        story.line(format_args!("no {what} ray: max_trace_level is reached"));
        return Radiance::BLACK;
    }
    if path.weight < worker.adc_bailout(path) {
        story.line(format_args!("no {what} ray: a weight of {} is below adc_bailout", path.weight));
        return Radiance::BLACK;
    }
    told(worker, path, what, story)
}

fn vector(v: DVec3) -> String {
    format!("<{}, {}, {}>", v.x, v.y, v.z)
}

fn color(c: Rgb) -> String {
    format!("rgb <{}, {}, {}>", c.x, c.y, c.z)
}
