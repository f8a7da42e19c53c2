//! Which photons light a point, and over what area.
//!
//! Source: photon facts, section 5 (measured).

use super::map::{Around, Nearest, PhotonMap};
use super::photon::Photon;
use crate::compiled::photons::Photons;
use crate::math::{DVec3, Rgb};
use std::f64::consts::PI;

/// Factor of the radius where photons are few.
const WIDER: f64 = 3.0;

/// POV-Ray's density in the place of none.
const NO_DENSITY: f64 = 1e-16;

/// Fewest and most photons that are asked for the density around them.
const PROBES: [usize; 2] = [100, 1000];

/// One in so many is asked.
const PROBED: usize = 20;

/// Shares of the mean density between which a place is thin, but not empty.
const THIN: [f64; 2] = [0.05, 0.7];

/// By how much thin places widen the radius.
const WIDENED: f64 = 20.0;

/// The photons that light a point.
#[derive(Clone, Debug, Default)]
pub(in crate::render) struct Nearby {
    nearest: Nearest,
    wider: Nearest,
}

/// What was found around a point.
#[derive(Debug)]
pub(in crate::render) struct Gathered {
    /// Unit direction to where each came from, and its light.
    pub(in crate::render) photons: Vec<(DVec3, Rgb)>,
    /// The area, or the volume, over which it is spread.
    pub(in crate::render) extent: f64,
}

/// Whether photons lie on surfaces or in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::render) enum Spread {
    /// Their density is one to an area.
    Flat,
    /// To a volume.
    Solid,
}

impl Spread {
    /// The area or volume within a squared radius.
    fn extent(self, squared: f64) -> f64 {
        match self {
            Self::Flat => PI * squared,
            Self::Solid => 4.0 / 3.0 * PI * squared * squared.sqrt(),
        }
    }

    /// The radius of that area or volume.
    fn radius(self, extent: f64) -> f64 {
        match self {
            Self::Flat => (extent / PI).sqrt(),
            Self::Solid => (3.0 * extent / (4.0 * PI)).cbrt(),
        }
    }
}

impl PhotonMap {
    /// The map with the radius in which photons are looked for: the one that is given, or what their density suggests,
    /// times a factor.
    pub(in crate::render) fn with_radius(
        mut self,
        spread: Spread,
        most: usize,
        given: Option<f64>,
        factor: f64,
    ) -> Self {
        self.radius = given.or_else(|| self.suggested_radius(spread, most).map(|radius| radius * factor));
        self
    }

    /// What the density of photons suggests; nothing where there are no more than light a single point.
    fn suggested_radius(&self, spread: Spread, most: usize) -> Option<f64> {
        if self.len() <= most {
            return None;
        }
        let n = (self.len() / PROBED).clamp(PROBES[0], PROBES[1]).min(self.len());
        // Neighbours in the map are neighbours in space: these are spread evenly.
        let places = |shift: usize| (0..n).map(move |i| (2 * i + shift) * self.len() / (2 * n));
        let density = |place: usize, radius: f64, nearest: &mut Nearest| {
            nearest.begin(most, radius);
            let point = self.photon(place as u32).position();
            self.search(&Around { point, normal: DVec3::ZERO }, nearest);
            nearest.len() as f64 / spread.extent(nearest.reach())
        };
        let mut nearest = Nearest::default();
        let densities = places(0).map(|place| density(place, f64::INFINITY, &mut nearest));
        let known: Vec<f64> = densities.filter(|density| density.is_finite()).collect();
        let mean = known.iter().sum::<f64>() / known.len() as f64;
        let radius = spread.radius(most as f64 / mean);
        if !radius.is_finite() {
            return None;
        }
        let is_thin = |density: f64| density > THIN[0] * mean && density < THIN[1] * mean;
        let thin = places(1).filter(|place| is_thin(density(*place, radius, &mut nearest))).count();
        Some(radius * (1.0 + WIDENED * thin as f64 / n as f64))
    }

    /// The photons around a point in a medium.
    pub(in crate::render) fn gather_in_space(
        &self,
        most: usize,
        point: DVec3,
        nearby: &mut Nearby,
    ) -> Option<Gathered> {
        let nearest = &mut nearby.nearest;
        nearest.begin(most, self.radius?);
        self.search(&Around { point, normal: DVec3::ZERO }, nearest);
        self.gathered(nearest, Spread::Solid)
    }

    fn gathered(&self, found: &Nearest, spread: Spread) -> Option<Gathered> {
        let light = |photon: &Photon| (photon.from(), photon.flux());
        let photons: Vec<_> = found.indices().map(|index| light(self.photon(index))).collect();
        (!photons.is_empty()).then_some(Gathered { photons, extent: spread.extent(found.reach()) })
    }

    /// The photons that light a point of a surface with that unit normal.
    pub(in crate::render) fn gather(
        &self,
        settings: &Photons,
        (point, normal): (DVec3, DVec3),
        nearby: &mut Nearby,
    ) -> Option<Gathered> {
        let radius = self.radius?;
        let [least, most] = settings.gather;
        let around = Around { point, normal };
        let Nearby { nearest, wider } = nearby;
        nearest.begin(most, radius);
        self.search(&around, nearest);
        let mut found = &*nearest;
        if nearest.len() < least {
            wider.begin(most, WIDER * radius);
            self.search(&around, wider);
            let density = |found: &Nearest| found.len() as f64 / found.reach();
            let before = if nearest.len() == 0 { NO_DENSITY } else { density(nearest) };
            let increase = (density(wider) - density(nearest)) / before;
            if increase < settings.expand_increase || (1..settings.expand_minimum).contains(&wider.len()) {
                found = wider;
            }
        }
        self.gathered(found, Spread::Flat)
    }
}
