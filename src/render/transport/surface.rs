//! What the layers of a texture do with light: their own and direct light, and what is left for rays that go on.
//!
//! Source: sections 2 and 6 of the shading facts (measured).

use super::global_light::GlobalLight;
use super::secondary::Boundary;
use crate::math::{Color, DVec3, Rgb, gray};
use crate::render::film::{Gather, Term};
use crate::render::light::{ArrivingLight, direct_light};
use crate::render::medium::inside_of;
use crate::render::radiance::Radiance;
use crate::render::random::{Branch, Random};
use crate::render::shade::finish::{self, Reflectivity};
use crate::render::shade::{Layers, Lookup, SurfaceLayer, opacity};
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;

/// Layers after everything that needs no further ray.
#[derive(Default)]
pub(super) struct Shaded<'t, G> {
    /// Own and direct light.
    pub(super) found: G,
    /// What light from the far side crosses, if any comes through.
    pub(super) beyond: Option<Boundary<'t>>,
    /// Layers that mirror, uppermost first.
    pub(super) mirrors: Mirrors<'t>,
}

/// Layers that mirror; mostly none or one.
#[derive(Default)]
pub(super) struct Mirrors<'t> {
    first: Option<Mirror<'t>>,
    others: Vec<Mirror<'t>>,
}

impl<'t> Mirrors<'t> {
    /// In the order in which they were added.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Mirror<'t>> {
        self.first.iter().chain(&self.others)
    }

    fn push(&mut self, mirror: Mirror<'t>) {
        if self.first.is_none() {
            self.first = Some(mirror);
        } else {
            self.others.push(mirror);
        }
    }
}

/// A layer that mirrors.
pub(super) struct Mirror<'t> {
    finish: &'t crate::compiled::texture::Finish,
    /// Unit perturbed normal.
    pub(super) normal: DVec3,
    reflectivity: Reflectivity,
    /// Share of the layer in the picture: what the layers above let through.
    visibility: f32,
    /// How many layers lie above it.
    depth: usize,
}

/// What part of a layer counts, at most all of it.
fn share(filter: Rgb) -> f32 {
    gray(filter).abs().min(1.0)
}

/// Goes through layers from the top; what it finds is put where it stays, being too large to be handed back.
#[inline(always)]
pub(super) fn shade<'t, G: Gather>(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    layers: &Layers<'t>,
    lookup: &mut Lookup<'_>,
    arriving: &mut ArrivingLight,
    shaded: &mut Shaded<'t, G>,
) {
    let (world, options) = (worker.world(), worker.options());
    let bailout = worker.adc_bailout(vertex.path);
    let mut filter = Rgb::ONE;
    let mut albedo = Rgb::ZERO;
    let mut top_normal = vertex.facing;
    let mut global_light = None;
    let wants_lights = worker.wants_lights(vertex.path);
    for (depth, layer) in layers.iter().enumerate() {
        if share(filter) <= bailout {
            break;
        }
        let normal = layer.normal(lookup, options);
        if depth == 0 {
            top_normal = normal;
        }
        let pigment = layer.color(lookup, options);
        let color = pigment.unwrap_or(Color::CLEAR);
        if options.flat() {
            shaded.found.add(Term::Emission, Radiance::opaque(color.rgb));
            shaded.found.note_shading(normal, color.rgb);
            return;
        }
        let finish = layer.finish();
        let relative_ior = || vertex.interiors().relative_ior(&inside_of(world, vertex.surface));
        let mirrors =
            |reflection| finish::reflectivity(reflection, color.rgb, -vertex.view().dot(normal), relative_ior);
        let reflectivity = finish.reflection.as_ref().and_then(mirrors);
        if let Some(reflectivity) = reflectivity.filter(|_| options.reflection_and_normals()) {
            shaded.mirrors.push(Mirror { finish, normal, reflectivity, visibility: share(filter), depth });
        }
        let (opacity, random) = (opacity(world, &color), layers.random());
        let is_only = layers.are_only(vertex.surface);
        let translucency = worker.prepared.subsurface.and(finish.translucency);
        let (diffuse, diffuse_back) = match translucency {
            None => (finish.diffuse, finish.diffuse_back),
            Some(_) => (0.0, 0.0),
        };
        let lit =
            SurfaceLayer { finish, normal, diffuse, diffuse_back, albedo: color.rgb, opacity, depth, is_only, random };
        let emission = color.rgb * worker.own_light(finish) * lit.opacity;
        let direct =
            if finish.uses_lights && wants_lights { direct_light(worker, vertex, &lit, arriving) } else { Rgb::ZERO };
        shaded.found.add_own(filter, emission, direct);
        if worker.prepared.has_global_light {
            let global_light = global_light.get_or_insert_with(GlobalLight::default);
            global_light.add(worker, vertex, (&lit, translucency), filter, &mut shaded.found);
        }
        albedo += filter * color.rgb * lit.opacity;
        if let Some(color) = pigment {
            filter *= color.transmittance();
            if finish.conserve_energy {
                let reflected = reflectivity.map_or(Rgb::ZERO, |r| r.tint);
                filter *= (Rgb::ONE - reflected).min(Rgb::ONE);
            }
        }
    }
    shaded.found.note_shading(top_normal, albedo);
    if share(filter) > bailout && options.refraction() {
        shaded.beyond = Some(Boundary {
            normal: top_normal,
            filter,
            legacy: layers.legacy_finish(),
            top: layers.top_finish(),
            random: layers.random(),
        });
    }
}

impl Mirror<'_> {
    /// Whether it mirrors about a normal.
    pub(super) fn has_normal(&self, normal: DVec3) -> bool {
        // POV-Ray's own limit for normals that agree.
        (self.normal - normal).abs().max_element() < 1e-10
    }

    /// Random choices of the mirrored ray, from those of its texture.
    pub(super) fn random(&self, of_texture: Random) -> Random {
        of_texture.branch(Branch::Reflection(self.depth))
    }

    /// How much the mirrored ray counts.
    pub(super) fn weight(&self, vertex: &Vertex<'_>) -> f32 {
        vertex.path.weight * self.visibility * self.reflectivity.importance
    }

    /// Light from the mirrored direction as the layer sends it back.
    pub(super) fn tinted(&self, worker: &Worker<'_>, vertex: &Vertex<'_>, direction: DVec3, mut light: Rgb) -> Rgb {
        if self.finish.irid_amount != 0.0 {
            let wavelength = worker.world().settings.irid_wavelength;
            light *= finish::irid(self.finish, wavelength, vertex.point(), direction, self.normal, vertex.view());
        }
        let exponent = self.reflectivity.exponent;
        if exponent != 1.0 {
            let power = |v: f32| v.signum() * v.abs().powf(1.0 / exponent);
            light = Rgb::new(power(light.x), power(light.y), power(light.z));
        }
        light * self.reflectivity.tint
    }
}
