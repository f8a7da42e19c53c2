//! Shoots photons before the picture is made.
//!
//! Each light shoots at each of its targets in rings, which end where they miss it. The photons of a ring are followed side by
//! side; what they leave is kept in their order, so that no number of threads shows.
//!
//! Source: photon facts, section 3 (measured).

use super::medium::Interiors;
use super::observer::{Observer, Stage};
use super::path::Path;
use super::photons::{Caught, PhotonMap, Rings, Shot, Spread};
use super::prepare::Prepared;
use super::random::Random;
use super::transport::{Arrived, Flight};
use super::worker::Worker;
use crate::compiled::TargetId;
use crate::compiled::geometry::{Geometry, RayKind, Scratch};
use crate::compiled::light::{Area, Light};
use crate::compiled::photons::{PhotonTarget, Photons};
use crate::math::{DVec3, MersenneTwister, Range, Ray, Rgb};
use rayon::prelude::*;

/// POV-Ray's brightness below which nothing is shot.
const DARK: f32 = 1e-5;

/// How many random numbers there are before they start again.
const N_NUMBERS: usize = 1 << 15;

/// Photons that one thread follows at a time.
const TOGETHER: usize = 256;

/// Photons that are on their way together, at most, up to a ring.
const MOST_TOGETHER: usize = 1 << 16;

/// The middle of all rings.
const MIDDLE: Shot = Shot { theta: 0.0, phi: 0.0 };

/// The numbers that move photons within their rings: POV-Ray's, in its order.
struct Numbers {
    all: Vec<f64>,
    next: usize,
}

impl Numbers {
    fn new() -> Self {
        let mut twister = MersenneTwister::default();
        // The first is never delivered.
        twister.next_u32();
        Self { all: (0..N_NUMBERS).map(|_| twister.next_f64()).collect(), next: 0 }
    }

    fn next(&mut self) -> f64 {
        let number = self.all[self.next];
        self.next = (self.next + 1) % N_NUMBERS;
        number
    }
}

/// Shoots all photons, if a scene has any.
pub(super) fn shoot(prepared: &mut Prepared<'_>, observer: &dyn Observer) {
    let world = prepared.world;
    let Some(settings) = world.photons.as_ref().filter(|_| prepared.options.indirect_light()) else {
        return;
    };
    observer.entered(Stage::Photons);
    let shining = || world.global_lights.iter().map(|index| &world.lights[*index]);
    let spacing = match settings.count {
        Some(count) => settings.spacing * (settings.estimate(shining()) / f64::from(count.max(1))).sqrt(),
        None => settings.spacing,
    };
    let mut numbers = Numbers::new();
    let (mut photons, mut in_media) = (Vec::new(), Vec::new());
    let pairs: Vec<_> =
        shining().flat_map(|light| settings.targets_of(light).map(move |target| (light, target))).collect();
    for (done, (light, target)) in pairs.iter().enumerate() {
        observer.advanced(done, pairs.len());
        let gun = Gun::new(light, *target, spacing, settings);
        let arrived = gun.shoot(prepared, observer, &mut numbers);
        photons.extend(arrived.photons);
        in_media.extend(arrived.in_media);
    }
    let most = settings.gather[1];
    let map = PhotonMap::new(photons).with_radius(Spread::Flat, most, settings.radius, settings.radius_factor);
    let (given, factor) = settings.media.map_or((None, 1.0), |media| (media.radius, media.radius_factor));
    let in_media = PhotonMap::new(in_media).with_radius(Spread::Solid, most, given, factor);
    prepared.photons = Some(Caught { settings, map, in_media });
    prepared.has_global_light = true;
}

/// A light and the target that it shoots at.
struct Gun<'w> {
    flight: Flight<'w>,
    /// From the light, or from each of its samples.
    rings: Vec<Rings>,
    /// Of each of them.
    color: Rgb,
}

impl<'w> Gun<'w> {
    fn new(light: &'w Light, (id, target): (TargetId, &PhotonTarget), spacing: f64, settings: &'w Photons) -> Self {
        let spacing = target.spacing * spacing;
        let samples = light.area.filter(|_| light.samples_shoot);
        let n = samples.map_or(1, |area| area.n1 * area.n2);
        // Samples share the work.
        let spacing = if light.parallel { spacing } else { spacing * (n as f64).sqrt() };
        let rings: Vec<Rings> = match samples {
            None => vec![Rings::new(light, light.location, target, spacing)],
            Some(area) => places(light, &area).map(|at| Rings::new(light, at, target, spacing)).collect(),
        };
        let spacing = rings.first().map_or(0.0, |rings| rings.spacing);
        let flight = Flight { light, target: id, settings, spacing };
        Self { flight, rings, color: light.color / n as f32 }
    }

    /// All photons that stay.
    fn shoot(&self, prepared: &Prepared<'_>, observer: &dyn Observer, numbers: &mut Numbers) -> Arrived {
        let mut stay = Arrived::default();
        let Some(rings) = self.rings.first() else { return stay };
        let interiors: Vec<Interiors> =
            self.rings.iter().map(|rings| Interiors::at(prepared.world, rings.ray(MIDDLE).origin)).collect();
        let settings = self.flight.settings;
        let mut has_met = false;
        // Up to here no empty ring ends anything: all its photons go at once.
        let sure = settings.autostop * rings.end;
        let thetas = |k: usize| k as f64 * rings.step;
        let mut k = 0;
        while thetas(k) < rings.end && !observer.cancels() {
            let mut shots = Vec::new();
            let first = k;
            while thetas(k) < rings.end && (k == first || thetas(k) <= sure && shots.len() < MOST_TOGETHER) {
                shots.extend(rings.ring(thetas(k), settings.jitter, &mut || numbers.next()));
                k += 1;
            }
            let arrived: Vec<Arrived> = shots
                .par_chunks(TOGETHER)
                .map_init(|| Worker::new(prepared), |worker, shots| self.follow(worker, shots, &interiors))
                .collect();
            let meets = arrived.iter().any(|arrived| arrived.met_target);
            for arrived in arrived {
                stay.photons.extend(arrived.photons);
                stay.in_media.extend(arrived.in_media);
            }
            if has_met && !meets && thetas(first) > sure {
                break;
            }
            has_met |= meets;
        }
        stay
    }

    /// Follows some photons from all samples of the light.
    fn follow(&self, worker: &mut Worker<'_>, shots: &[Shot], interiors: &[Interiors]) -> Arrived {
        let mut arrived = Arrived::default();
        for shot in shots {
            for (rings, interiors) in self.rings.iter().zip(interiors) {
                let ray = rings.ray(*shot);
                let light = self.flight.light;
                let factor = light.angular(ray.origin + ray.direction, -ray.direction);
                let color = self.color * factor as f32;
                if color.abs().max_element() < DARK {
                    continue;
                }
                let random = Random::at(shot.theta, shot.phi);
                let mut path = Path {
                    ray,
                    range: Range::FORWARD,
                    bounce: 0,
                    below: 0,
                    kind: RayKind::Photon,
                    level: 1,
                    weight: 1.0,
                    interiors: interiors.clone(),
                    wavelength: None,
                    random,
                };
                if let Some(window) = &light.projected_through {
                    let Some(beyond) = beyond(window, path.ray, &mut worker.scratch) else { continue };
                    (path.ray, path.range) = beyond;
                }
                self.flight.follow(worker, path, color, &mut arrived);
            }
        }
        arrived
    }
}

/// The ray behind the last surface of an object that light is projected through, if it meets any.
fn beyond(window: &Geometry, ray: Ray, scratch: &mut Scratch) -> Option<(Ray, Range)> {
    let mut beyond = None;
    let (mut ray, mut range) = (ray, Range::FORWARD);
    while let Some(hit) = window.intersect(&ray, range, RayKind::Shadow, scratch) {
        (ray, range) = window.surface(&ray, &hit).leave(ray.direction);
        beyond = Some((ray, range));
    }
    beyond
}

/// Where the samples of an area light stand, without jitter and not bent into a disc.
fn places(light: &Light, area: &Area) -> impl Iterator<Item = DVec3> + use<> {
    let (location, plain) = (light.location, Area { circular: false, ..*area });
    let axes = (plain.axis1, plain.axis2);
    let samples = (0..plain.n2).flat_map(move |j| (0..plain.n1).map(move |i| (i, j)));
    samples.map(move |(i, j)| location + plain.offset(i as f64, j as f64, axes))
}
