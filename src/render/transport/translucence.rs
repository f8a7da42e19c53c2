//! Light from below a surface: scattered often, scattered once, and what goes straight through.
//!
//! Source: Jensen et al. 2001, sections 2.1 to 2.3 and 4; subsurface facts, sections 2 to 6 (measured).

use super::secondary::refracted;
use super::{followed, irradiance};
use crate::compiled::geometry::{Hit, InteriorId, Surface};
use crate::compiled::subsurface::Subsurface;
use crate::math::{DVec3, Range, Ray, Rgb};
use crate::render::light::light_through;
use crate::render::medium::inside_of;
use crate::render::path::Path;
use crate::render::random::{Branch, Dimension, Random};
use crate::render::shade::SurfaceLayer;
use crate::render::shade::finish::fresnel;
use crate::render::subsurface::{Depths, Directions, Material, Roulette};
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;
use std::f64::consts::PI;

/// POV-Ray's depth of objects seen straight through one another from which on nothing comes from below.
const MOST_BELOW: u8 = 2;

/// POV-Ray's least cosine by which a place counts that is seen from the side.
const LEAST_COSINE: f64 = 0.01;

/// POV-Ray's phase function, times 4π, over 4: that of light scattered evenly, with the π of Jensen et al. left out.
const PHASE: f64 = 0.25;

/// The ways of light, each with its own random choices.
const MULTIPLE: u32 = 0;
const SINGLE: u32 = 1;
const STRAIGHT: u32 = 2;

/// What comes from below a layer towards the ray that came there.
#[inline(never)]
pub(super) fn from_below(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    layer: &SurfaceLayer<'_>,
    (settings, translucency): (&Subsurface, Rgb),
) -> Rgb {
    let world = worker.world();
    let Some(table) = &world.interior(vertex.surface.interior.interior).reduced_albedo else { return Rgb::ZERO };
    if vertex.path.below >= MOST_BELOW {
        return Rgb::ZERO;
    }
    let object = inside_of(world, vertex.surface);
    let across = vertex.interiors().relative_ior(&object);
    // Seen from within it is still the material over what is around it, as in POV-Ray. Smoothed normals do not tell.
    let ior = if vertex.interiors().are_in(&object) { across.recip() } else { across };
    let cosine = -vertex.view().dot(vertex.facing);
    let below = Below {
        settings,
        vertex,
        material: Material::new(table, layer.albedo * layer.finish.raw_diffuse, translucency, ior),
        ior,
        leaving: 1.0 - f64::from(fresnel(cosine, ior)),
        random: layer.random.branch(Branch::Layer(layer.depth)),
    };
    let scattered_often = below.multiple(worker);
    (scattered_often + below.along_view(worker)).as_vec3()
}

/// A place on a surface, and what is below.
struct Below<'a> {
    settings: &'a Subsurface,
    vertex: &'a Vertex<'a>,
    material: Material,
    /// Of the inside over the outside.
    ior: f64,
    /// What the surface lets out of light towards the viewer.
    leaving: f64,
    random: Random,
}

/// A place where light comes in.
struct Entry<'p> {
    vertex: Vertex<'p>,
}

impl Below<'_> {
    /// As many samples as asked for; where another such object is in front, one.
    fn samples(&self, wanted: u32) -> u32 {
        if self.vertex.path.below == 0 { wanted } else { wanted.min(1) }
    }

    /// Light that was scattered often: of the dipole at places that are seen from one point below the surface.
    ///
    /// The mean is over what is met, so weights of directions that meet nothing must be known, too.
    fn multiple(&self, worker: &mut Worker<'_>) -> DVec3 {
        let wants_lights = worker.wants_lights(self.vertex.path);
        if !wants_lights && !self.settings.radiosity {
            return DVec3::ZERO;
        }
        let Some((start, is_halfway)) = self.start(worker) else { return DVec3::ZERO };
        let random = self.random.branch(Branch::Below(MULTIPLE));
        let shifts = [random.unit(Dimension::Shift(0)), random.unit(Dimension::Shift(1))];
        let directions = Directions::new(self.samples(self.settings.multiple_samples), self.vertex.facing, is_halfway);
        let mm = self.settings.mm_per_unit;
        let mut path = self.path((Ray::new(start, self.vertex.facing), Range::FORWARD), random);
        let mut roulette = Roulette::default();
        let (mut sum, mut met) = (DVec3::ZERO, 0.0);
        for i in 0..directions.len() {
            let (direction, share) = directions.get(i, shifts);
            path.ray.direction = direction;
            path.random = random.branch(Branch::Below(i));
            let Some(hit) = first_hit(worker, &path) else { continue };
            met += share;
            let surface = worker.world().geometry.surface(&path.ray, &hit);
            if !self.is_same(&surface) {
                continue;
            }
            let cosine = direction.dot(surface.normal).abs().max(LEAST_COSINE);
            let area = 4.0 * PI * (hit.t * mm).powi(2) / cosine;
            let square = (surface.point - self.vertex.point()).length_squared() * mm * mm;
            let visible = share * area * self.material.diffuse_reflectance(square);
            let Some(weight) = roulette.weight(visible.max_element(), path.random) else { continue };
            let entry = Entry { vertex: Vertex::new(&path, hit.t, &surface) };
            sum += weight * visible * self.arriving(worker, &entry, wants_lights);
        }
        if met == 0.0 { DVec3::ZERO } else { self.leaving * sum / met }
    }

    /// The light that comes in at a place from everywhere.
    fn arriving(&self, worker: &mut Worker<'_>, entry: &Entry<'_>, wants_lights: bool) -> DVec3 {
        let mut sum = DVec3::ZERO;
        if wants_lights {
            let world = worker.world();
            for &index in world.lights_for(entry.vertex.light_group()) {
                let direction = world.lights[index].toward(entry.vertex.point(), world.lights[index].location).0;
                let cosine = entry.cosine(direction);
                sum += entry.light(worker, index) * (cosine * self.entering(cosine));
            }
        }
        if self.settings.radiosity {
            let normal = entry.vertex.surface.normal;
            sum += self.entering(1.0) * irradiance::on_side(worker, &entry.vertex, normal).as_dvec3();
        }
        sum
    }

    /// The point below the surface from which others are looked at: one mean free path deep, halfway through what is
    /// thinner than two; and whether it is halfway.
    fn start(&self, worker: &mut Worker<'_>) -> Option<(DVec3, bool)> {
        let depth = self.material.mean_free_path / self.settings.mm_per_unit;
        if depth <= 0.0 {
            return None;
        }
        let inward = -self.vertex.facing;
        let (ray, range) = self.vertex.leave(inward);
        let path = self.path((ray, Range { max: 2.0 * depth, ..range }), self.random);
        let Some(hit) = first_hit(worker, &path) else { return Some((ray.at(depth), false)) };
        let surface = worker.world().geometry.surface(&path.ray, &hit);
        Some(match self.is_same(&surface) {
            true => (ray.at(0.5 * hit.t), true),
            false if hit.t > depth => (ray.at(depth), false),
            false => (surface.leave(-inward).0.origin, false),
        })
    }

    /// What comes out along the refracted view ray: scattered once there, or from behind the object.
    fn along_view(&self, worker: &mut Worker<'_>) -> DVec3 {
        let Some(direction) = refracted(self.vertex.view(), self.vertex.facing, self.ior.recip()) else {
            return DVec3::ZERO;
        };
        let path = self.path(self.vertex.leave(direction), self.random.branch(Branch::Below(STRAIGHT)));
        let exit = first_hit(worker, &path);
        let thickness = exit.as_ref().map_or(f64::INFINITY, |hit| hit.t) * self.settings.mm_per_unit;
        let mut sum = DVec3::ZERO;
        if worker.wants_lights(self.vertex.path) {
            sum += self.single(worker, &path, thickness);
        }
        if let Some(hit) = exit {
            sum += self.straight(worker, &path, &hit);
        }
        sum
    }

    /// Light that was scattered once, on a straight way from each source: Snell's law counts by cosines only.
    fn single(&self, worker: &mut Worker<'_>, view: &Path, thickness: f64) -> DVec3 {
        let random = self.random.branch(Branch::Below(SINGLE));
        let shifts = [random.unit(Dimension::Shift(0)), random.unit(Dimension::Shift(1))];
        let depths = Depths::new(&self.material, thickness);
        let cosine_out = view.ray.direction.dot(self.vertex.facing).abs();
        let n = self.samples(self.settings.single_samples);
        let mut sum = DVec3::ZERO;
        for i in 0..n {
            let Some((depth, weight)) = depths.depth(i, n, shifts) else { break };
            let point = view.ray.at(depth / self.settings.mm_per_unit);
            let random = random.branch(Branch::Below(i));
            sum += weight * self.scattered_at(worker, point, cosine_out, random);
        }
        if n == 0 { DVec3::ZERO } else { PHASE * self.leaving * self.material.scattering * sum / f64::from(n) }
    }

    /// The light that reaches a point within, over the extinction of both ways.
    fn scattered_at(&self, worker: &mut Worker<'_>, point: DVec3, cosine_out: f64, random: Random) -> DVec3 {
        let world = worker.world();
        let extinction = self.material.extinction;
        let mut sum = DVec3::ZERO;
        for &index in world.lights_for(self.vertex.light_group()) {
            let light = &world.lights[index];
            let direction = light.toward(point, light.location).0;
            let path = self.path((Ray::new(point, direction), Range::FORWARD), random);
            let Some(hit) = first_hit(worker, &path) else { continue };
            let surface = world.geometry.surface(&path.ray, &hit);
            if !self.is_same(&surface) {
                continue;
            }
            let entry = Entry { vertex: Vertex::new(&path, hit.t, &surface) };
            let cosine = entry.cosine(direction);
            let within = 1.0 - (1.0 - cosine * cosine) / (self.ior * self.ior);
            if within <= 0.0 {
                continue;
            }
            let cosine_in = within.sqrt();
            let length = hit.t * self.settings.mm_per_unit * cosine / cosine_in;
            let reaching = (-extinction * length).exp() / (extinction * (1.0 + cosine_out / cosine_in));
            sum += reaching * entry.light(worker, index) * (cosine * self.entering(cosine));
        }
        sum
    }

    /// What is seen straight through the object, bent where it leaves it.
    fn straight(&self, worker: &mut Worker<'_>, view: &Path, hit: &Hit) -> DVec3 {
        let left = self.material.transmittance(hit.t * self.settings.mm_per_unit);
        let most = left.max_element() as f32;
        if most <= worker.adc_bailout(self.vertex.path) {
            return DVec3::ZERO;
        }
        let exit = worker.world().geometry.surface(&view.ray, hit);
        if !self.is_same(&exit) {
            return DVec3::ZERO;
        }
        let Some(direction) = refracted(view.ray.direction, exit.normal, self.ior) else { return DVec3::ZERO };
        let came = self.vertex.path;
        let path = Path {
            kind: came.kind.transmitted(),
            below: came.below + 1,
            level: came.level + 1,
            weight: came.weight * most,
            ..self.path(exit.leave(direction), view.random)
        };
        left * followed(worker, self.vertex, &path, |n| &mut n.transmitted_rays).rgb.as_dvec3()
    }

    /// A ray from within; what it sees is lit as from outside.
    fn path(&self, (ray, range): (Ray, Range), random: Random) -> Path {
        Path { ray, range, random, ..self.vertex.path.clone() }
    }

    /// What the surface lets in of light at a cosine.
    fn entering(&self, cosine: f64) -> f64 {
        1.0 - f64::from(fresnel(cosine, self.ior))
    }

    /// Whether a surface is one of the same material: of the same interior, or, where none was written, of the same object.
    fn is_same(&self, other: &Surface) -> bool {
        let own = self.vertex.surface;
        other.interior == own.interior && (own.interior.interior != InteriorId::default() || other.object == own.object)
    }
}

impl Entry<'_> {
    /// Cosine between a direction and the normal on its side.
    fn cosine(&self, direction: DVec3) -> f64 {
        self.vertex.surface.normal.dot(direction).abs()
    }

    /// What a light gives there after everything in its way.
    fn light(&self, worker: &mut Worker<'_>, index: usize) -> DVec3 {
        let light = &worker.world().lights[index];
        let arrival = light.arrival(self.vertex.point(), light.location);
        if light.is_spent(arrival.color) {
            return DVec3::ZERO;
        }
        light_through(worker, &self.vertex, index, &arrival, false).as_dvec3()
    }
}

/// The nearest thing on a way, which is counted.
fn first_hit(worker: &mut Worker<'_>, path: &Path) -> Option<Hit> {
    worker.statistics.sample_rays += 1;
    worker.intersect(path)
}
