//! A grid of lights seen from one place.
//!
//! Source: section 3.5 of the shading facts (measured).

use crate::compiled::light::{Area, Light};
use crate::math::{DVec3, Rgb};
use crate::render::enough::corners_agree;
use crate::render::random::{Dimension, Random};
use crate::render::vertex::Place;

/// Where a sample lies on the grid, displaced at random if the light says so: the same place for its shadow and for
/// its light.
pub(super) fn position(area: &Area, light: usize, [i, j]: [usize; 2], random: Random) -> (f64, f64) {
    let (a, b) = (i as f64, j as f64);
    if !area.jitter {
        return (a, b);
    }
    let shift = |axis: u8| random.unit(Dimension::AreaLight { light, cell: j * area.n1 + i, axis }) - 0.5;
    (a + shift(0), b + shift(1))
}

/// A grid of lights of which each sample is looked at once.
pub(super) struct Grid<'a, P, F> {
    place: &'a P,
    index: usize,
    light: &'a Light,
    area: &'a Area,
    axes: (DVec3, DVec3),
    known: Vec<Option<Rgb>>,
    /// What comes from a direction and a distance.
    arriving: F,
}

impl<'a, P: Place, F: FnMut(DVec3, f64) -> Rgb> Grid<'a, P, F> {
    pub(super) fn new(place: &'a P, index: usize, light: &'a Light, area: &'a Area, arriving: F) -> Self {
        let axes = area.axes((light.location - place.point()).normalize_or(DVec3::Z));
        Self { place, index, light, area, axes, known: vec![None; area.n1 * area.n2], arriving }
    }

    /// Mean of what arrives, looking only as closely as samples differ.
    pub(super) fn mean(&mut self) -> Rgb {
        self.block([0, 0], [self.area.n1 - 1, self.area.n2 - 1], 0)
    }

    fn sample(&mut self, cell: [usize; 2]) -> Rgb {
        let at = cell[1] * self.area.n1 + cell[0];
        if let Some(known) = self.known[at] {
            return known;
        }
        let (a, b) = position(self.area, self.index, cell, self.place.random());
        let source = self.light.location + self.area.offset(a, b, self.axes);
        let (direction, distance) = self.light.toward(self.place.point(), source);
        let found = (self.arriving)(direction, distance);
        self.known[at] = Some(found);
        found
    }

    /// Mean over a block of the grid: of its corners if they agree, else of its quarters.
    fn block(&mut self, low: [usize; 2], high: [usize; 2], depth: u32) -> Rgb {
        let corners = [low, [high[0], low[1]], [low[0], high[1]], high];
        let mut values = corners.map(|cell| self.sample(cell));
        let long = high[0] - low[0] > 1 || high[1] - low[1] > 1;
        if long && (depth < self.area.adaptive || !corners_agree(&values)) {
            let below = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
            let above = [(low[0] + high[0]).div_ceil(2), (low[1] + high[1]).div_ceil(2)];
            values = [
                self.block(low, below, depth + 1),
                self.block([above[0], low[1]], [high[0], below[1]], depth + 1),
                self.block([low[0], above[1]], [below[0], high[1]], depth + 1),
                self.block(above, high, depth + 1),
            ];
        }
        0.25 * (values[0] + values[1] + values[2] + values[3])
    }
}
