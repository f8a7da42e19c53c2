//! Pigments at four places at once, one in each SIMD lane.

use crate::compiled::texture::Layer;
use crate::math::{Color, DVec3, LANES, Points, Uv};
use smallvec::SmallVec;
use std::cell::OnceCell;

/// Four points of one texture, and what colours its layers have there.
pub(in crate::render) struct Lanes<'w> {
    layers: &'w [Layer],
    points: Points,
    uvs: [Uv; LANES],
    /// By layer, as far as they have been asked for.
    colors: SmallVec<[OnceCell<[Color; LANES]>; 1]>,
}

impl<'w> Lanes<'w> {
    /// Points in texture space with their surface coordinates.
    pub(in crate::render) fn new(layers: &'w [Layer], points: [DVec3; LANES], uvs: [Uv; LANES]) -> Self {
        Self { layers, points: points.into(), uvs, colors: layers.iter().map(|_| OnceCell::new()).collect() }
    }

    /// One of the four.
    pub(in crate::render) fn lane(&self, lane: usize) -> Lane<'_> {
        Lane { all: self, lane }
    }
}

/// One of four neighbours.
#[derive(Clone, Copy)]
pub(in crate::render) struct Lane<'p> {
    all: &'p Lanes<'p>,
    lane: usize,
}

impl Lane<'_> {
    /// The colour of a layer, by its index, if it is one that is found for all four at once.
    #[inline(never)]
    pub(super) fn color(self, layer: usize) -> Option<Color> {
        let Lanes { layers, points, uvs, colors } = self.all;
        let Layer { pigment, side_by_side: true, .. } = &layers[layer] else { return None };
        Some(colors[layer].get_or_init(|| pigment.colors(points, uvs))[self.lane])
    }
}
