//! Media along a segment of a path: from what it is inside of to what reaches its start.

use super::march::{Carried, Incoming, Segment, scattered, transmittance};
use super::segment::Lit;
use super::settling::Settling;
use super::{Airlight, Interiors};
use crate::compiled::World;
use crate::compiled::medium::Medium;
use crate::math::{DVec3, Ray, Rgb};
use crate::render::random::{Branch, Dimension, Random};
use smallvec::SmallVec;

/// The numbers of media.
type Media = SmallVec<[usize; 4]>;

/// Where light goes through media.
#[derive(Clone, Copy)]
pub(in crate::render) struct Passage<'a> {
    pub(in crate::render) world: &'a World,
    /// World space, unit direction; it starts where the media do.
    pub(in crate::render) ray: &'a Ray,
    /// How far the media go.
    pub(in crate::render) length: f64,
    /// Random choices along it.
    pub(in crate::render) random: Random,
}

impl Interiors {
    /// The numbers of the media in all of them; none where an object among them is not hollow.
    pub(in crate::render) fn media(&self, world: &World) -> Media {
        if !self.are_hollow() {
            return Media::new();
        }
        self.0.iter().flat_map(|inside| world.interior(inside.key.interior).media.clone()).collect()
    }
}

impl Passage<'_> {
    /// What part of light comes through.
    pub(in crate::render) fn transmittance(&self, media: impl Iterator<Item = usize>) -> Rgb {
        let media = self.of(media);
        if media.is_empty() {
            return Rgb::ONE;
        }
        transmittance(self.segment(&media), numbers(self.random))
    }

    /// What media do to light that passes, and what lights add of the given numbers.
    ///
    /// `incoming` gives the light of a source, by its number, at a point where choices are those of the random numbers
    /// beside it, `carried` what photons have brought there; `settling` says of each of the world's media when samples are
    /// enough.
    pub(in crate::render) fn airlight(
        &self,
        media: impl Iterator<Item = usize> + Clone,
        lights: impl Iterator<Item = usize>,
        settling: &[Settling],
        mut incoming: impl FnMut(usize, DVec3, Random) -> Option<Incoming>,
        carried: Option<&mut Carried<'_>>,
    ) -> Option<Airlight> {
        let of_each = self.of(media.clone());
        if of_each.iter().all(|medium| medium.is_nothing()) {
            return None;
        }
        let source = |index: usize| {
            let light = &self.world.lights[index];
            if light.lights_media { Lit::new(index, light, self.ray, self.length) } else { None }
        };
        let lit: SmallVec<[Lit; 4]> = lights.filter_map(source).collect();
        let master = first_of_most_intervals(media, &self.world.media);
        let at_sample = |light: usize, point: DVec3, sample: u32| {
            incoming(light, point, self.random.branch(Branch::Medium(sample)))
        };
        Some(scattered(self.segment(&of_each), &settling[master], &lit, at_sample, carried, numbers(self.random)))
    }

    fn of(&self, media: impl Iterator<Item = usize>) -> SmallVec<[&Medium; 4]> {
        media.map(|number| &self.world.media[number]).collect()
    }

    fn segment<'s>(&'s self, media: &'s [&'s Medium]) -> Segment<'s> {
        Segment { ray: self.ray, length: self.length, media }
    }
}

/// The medium whose settings hold for all.
fn first_of_most_intervals(media: impl Iterator<Item = usize>, all: &[Medium]) -> usize {
    let intervals = |number: usize| all[number].sampling.intervals;
    media.reduce(|best, next| if intervals(next) > intervals(best) { next } else { best }).unwrap_or_default()
}

/// Numbers in 0..1, one after the other.
fn numbers(random: Random) -> impl FnMut() -> f64 {
    let mut n = 0;
    move || {
        n += 1;
        random.unit(Dimension::Medium(n))
    }
}
