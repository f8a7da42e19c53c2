//! A photon on its way from a light: to its target, and on from there by glass and mirrors.
//!
//! Where light looks for its sources everywhere else, here it is carried; surfaces bend and mirror it by the same rules.
//! Source: photon facts, section 4 (measured).

use super::secondary::{Refraction, mirrored};
use super::surface::{Mirror, Shaded, shade};
use crate::compiled::TargetId;
use crate::compiled::geometry::{Hit, Surface};
use crate::compiled::light::Light;
use crate::compiled::photons::{PhotonRole, Photons};
use crate::compiled::texture::Frame;
use crate::math::Rgb;
use crate::render::film::Term;
use crate::render::light::{ArrivingLight, surface_transmittance};
use crate::render::medium::{Passage, inside_of};
use crate::render::path::Path;
use crate::render::photons::Photon;
use crate::render::radiance::{Mix, Radiance};
use crate::render::random::{Branch, Dimension};
use crate::render::shade::{Layers, Lookup, TexturePoint, TextureSpace, context, resolve, texture_space};
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;

/// What all photons of a light and a target have in common.
pub(in crate::render) struct Flight<'w> {
    pub(in crate::render) light: &'w Light,
    pub(in crate::render) target: TargetId,
    pub(in crate::render) settings: &'w Photons,
    /// Distance of photons at a distance of one from the light, or at any for parallel light.
    pub(in crate::render) spacing: f64,
}

/// What became of some photons.
#[derive(Default)]
pub(in crate::render) struct Arrived {
    /// Where they stay on surfaces.
    pub(in crate::render) photons: Vec<Photon>,
    /// Where they stay in media.
    pub(in crate::render) in_media: Vec<Photon>,
    /// One has met its target.
    pub(in crate::render) met_target: bool,
}

/// A piece of the way.
#[derive(Clone)]
struct Leg {
    path: Path,
    color: Rgb,
    /// Of the way so far.
    length: f64,
    /// It begins at the target, or beyond.
    is_past: bool,
}

/// Ways on from a surface, with their light.
#[derive(Default)]
struct Legs(Vec<(Path, Rgb)>);

impl Mix for Legs {
    fn add_scaled(&mut self, other: &Self, weight: f32) {
        self.0.extend(other.0.iter().map(|(path, color)| (path.clone(), weight * *color)));
    }

    fn scaled(mut self, weight: f32) -> Self {
        self.0.iter_mut().for_each(|(_, color)| *color *= weight);
        self
    }
}

impl Flight<'_> {
    /// Follows a photon to its end.
    pub(in crate::render) fn follow(&self, worker: &mut Worker<'_>, path: Path, color: Rgb, arrived: &mut Arrived) {
        self.follow_leg(worker, Leg { path, color, length: 0.0, is_past: false }, arrived);
    }

    fn follow_leg(&self, worker: &mut Worker<'_>, mut leg: Leg, arrived: &mut Arrived) {
        let is_over = leg.path.level > self.settings.max_trace_level || leg.path.weight < self.settings.adc_bailout;
        if is_over || leg.color.abs().max_element() == 0.0 {
            return;
        }
        let Some(hit) = worker.intersect(&leg.path) else { return };
        let world = worker.world();
        let surface = world.geometry.surface(&leg.path.ray, &hit);
        let role = world.geometry.photon_role(&surface);
        let length_before = leg.length;
        leg.length += hit.t;
        let meets_target = role.target == Some(self.target);
        if !leg.is_past && !meets_target {
            if role.lets_pass {
                let on = straight_on(worker, &leg, &hit, &surface);
                self.follow_leg(worker, on, arrived);
            }
            return;
        }
        arrived.met_target = true;
        if leg.is_past {
            self.leave_in_media(worker, &leg, length_before, &mut arrived.in_media);
        }
        leg.color *= faded(worker, &leg.path, &surface, hit.t) * through_media(worker, &leg.path, hit.t);
        if leg.is_past && role.collects() {
            arrived.photons.extend(self.photon(&leg, &surface));
        }
        for (path, color) in self.ways_on(worker, &leg, &hit, &surface, &role) {
            self.follow_leg(worker, Leg { path, color, length: leg.length, is_past: true }, arrived);
        }
    }

    /// What stays where a leg has ended.
    fn photon(&self, leg: &Leg, surface: &Surface) -> Option<Photon> {
        let factor = self.light.distance_fade(leg.length) * self.apart(leg.length).powi(2);
        Photon::new(surface.point, leg.color * factor as f32, -leg.path.ray.direction)
    }

    /// How far photons are apart after a way from the light.
    fn apart(&self, length: f64) -> f64 {
        if self.light.parallel { self.spacing } else { self.spacing * length }
    }

    /// Leaves photons in the media of the objects along a leg that begins after a way of `before`.
    fn leave_in_media(&self, worker: &Worker<'_>, leg: &Leg, before: f64, left: &mut Vec<Photon>) {
        let world = worker.world();
        let Some(settings) = self.settings.media.filter(|_| world.features.filled_interiors > 0) else { return };
        let media = leg.path.interiors.media(world);
        let takes = |number: &usize| {
            let medium = &world.media[*number];
            medium.scattering != Rgb::ZERO || medium.extinction != Rgb::ZERO
        };
        if !media.iter().any(takes) {
            return;
        }
        let length = leg.length - before;
        let wanted = length / (self.apart(before) * settings.factor);
        let n = wanted.min(settings.steps.into()).floor();
        if n < 1.0 {
            return;
        }
        // Fewer than wanted stand for longer pieces.
        let factor = settings.factor * if wanted > n + 1.0 { wanted / n } else { 1.0 };
        let ray = &leg.path.ray;
        for i in 0..n as u32 {
            let moved = self.settings.jitter * (leg.path.random.unit(Dimension::Medium(i)) - 0.5);
            let distance = (f64::from(i) + 0.5 + moved) / n * length;
            let apart = self.apart(before + distance);
            let flux = self.light.distance_fade(before + distance) * apart.powi(3) * factor;
            left.extend(Photon::new(ray.at(distance), leg.color * flux as f32, -ray.direction));
        }
    }

    /// Where the light goes from a surface: all ways, each with its share.
    fn ways_on(
        &self,
        worker: &mut Worker<'_>,
        leg: &Leg,
        hit: &Hit,
        surface: &Surface,
        role: &PhotonRole,
    ) -> Vec<(Path, Rgb)> {
        let world = worker.world();
        // What fades on the way is gone already: from here no way lies behind.
        let vertex = Vertex::new(&leg.path, 0.0, surface);
        let mut context = context(surface, vertex.view(), vertex.facing);
        let mut lookup = Lookup { context: &mut context, lane: None };
        let mut all = Legs::default();
        for (i, seen) in surface.textures.iter().enumerate() {
            let mut room = None;
            let TextureSpace { point, texture_from_world } = texture_space(world, surface, hit, seen, &mut room);
            let mut frame = Frame::new(texture_from_world);
            let at = TexturePoint { point, plain: true, random: leg.path.random.texture(i) };
            let mut of_layers =
                |layers: Layers<'_>, lookup: &mut Lookup<'_>| self.of_layers(worker, &vertex, &layers, lookup, role);
            let legs = resolve(world.texture(seen.texture), at, &mut frame, &mut lookup, &mut of_layers);
            all.add_scaled(&legs, seen.weight);
        }
        all.0.into_iter().map(|(path, share)| (path, leg.color * share)).collect()
    }

    /// The same for the layers of one texture, and white light.
    fn of_layers(
        &self,
        worker: &mut Worker<'_>,
        vertex: &Vertex<'_>,
        layers: &Layers<'_>,
        lookup: &mut Lookup<'_>,
        role: &PhotonRole,
    ) -> Legs {
        let mut shaded: Shaded<'_, Radiance> = Shaded::default();
        shade(worker, vertex, layers, lookup, &mut ArrivingLight::default(), &mut shaded);
        // Every surface is a level, also where light goes straight on.
        let on = |path: Path| Path { level: vertex.path.level + 1, ..path };
        let mut legs = Legs::default();
        let mut total_reflection = None;
        if let Some(boundary) = shaded.beyond.as_ref().filter(|_| role.refracts(&self.light.photons)) {
            let rays = Refraction::new(worker, vertex, boundary);
            total_reflection = (rays.term() == Term::Reflection).then_some(boundary.normal);
            for i in 0..rays.n_rays() {
                let ray = rays.ray(vertex, boundary, i);
                let light = rays.weighted(worker.world(), vertex, boundary, Radiance::opaque(ray.hue));
                legs.0.push((on(ray.path), light.rgb));
            }
        }
        let is_left = |mirror: &&Mirror<'_>| !total_reflection.is_some_and(|normal| mirror.has_normal(normal));
        for mirror in shaded.mirrors.iter().filter(|_| role.reflects(&self.light.photons)).filter(is_left) {
            let random = mirror.random(layers.random());
            let path = mirrored(vertex, mirror.normal, mirror.weight(vertex), random);
            let light = mirror.tinted(worker, vertex, path.ray.direction, Rgb::ONE);
            legs.0.push((on(path), light));
        }
        legs
    }
}

/// Through a surface that photons pass by on their way to a target: it colours them, and bends nothing.
fn straight_on(worker: &mut Worker<'_>, leg: &Leg, hit: &Hit, surface: &Surface) -> Leg {
    let world = worker.world();
    let Path { ray, kind, ref interiors, .. } = leg.path;
    let mut interiors = interiors.clone();
    interiors.cross_at(world, surface, (ray.direction, kind), &mut worker.scratch);
    let through = surface_transmittance(worker, surface, hit, &ray);
    let (ray, range) = surface.leave(ray.direction);
    let level = leg.path.level + 1;
    let path = Path { ray, range, level, interiors, ..leg.path.clone() };
    Leg { path, color: leg.color * through, ..*leg }
}

/// What is left of light that comes to a surface from within its object.
fn faded(worker: &Worker<'_>, path: &Path, surface: &Surface, length: f64) -> Rgb {
    let world = worker.world();
    match world.interior(surface.interior.interior).fade {
        Some(fade) if path.interiors.hold(&inside_of(world, surface)) => fade.transmittance(length),
        _ => Rgb::ONE,
    }
}

/// What the media of the objects let through that a photon is inside of.
fn through_media(worker: &Worker<'_>, path: &Path, length: f64) -> Rgb {
    let world = worker.world();
    if world.features.filled_interiors == 0 {
        return Rgb::ONE;
    }
    let random = path.random.branch(Branch::Medium(0));
    Passage { world, ray: &path.ray, length, random }.transmittance(path.interiors.media(world).into_iter())
}
