//! The cells of pavements that are squares.

use super::{Corner, Spokes, Style, bits, has, least};

/// What a square has, bit by bit: sides counter-clockwise from the one below (z least), corners from the first of that
/// side (x and z least). Corners count where the style draws them.
#[derive(Clone, Copy, Debug)]
pub(super) struct SquareCell {
    /// Sides that are borders.
    borders: u8,
    /// Corners from which borders lead only outside of the cell.
    concave: u8,
    /// Corners between two borders.
    convex: u8,
    /// The corner around which the tile bends.
    bend: u8,
}

/// Distances to the sides, in their order.
type Distances = [f64; 4];

/// Distances to the lines along x and along z through a corner.
#[inline(always)]
fn to_corner([below, right, above, left]: Distances, corner: usize) -> [f64; 2] {
    let to_right = corner == 1 || corner == 2;
    [if to_right { right } else { left }, if corner < 2 { below } else { above }]
}

/// How far a corner is, in one of three ways.
#[inline(always)]
fn radius(kind: u32, [dx, dz]: [f64; 2]) -> f64 {
    match kind {
        0 if dx < dz => dz,
        0 => dx,
        1 => dx + dz,
        _ => (dx * dx + dz * dz).sqrt(),
    }
}

impl SquareCell {
    /// The square between four lattice points, of which these are the spokes.
    pub(super) fn new(spokes: [Spokes; 4], style: Style) -> Self {
        let corners: [_; 4] = std::array::from_fn(|k| Corner::new(spokes[k], 4, k));
        let bends = |k: usize| style.form < 3 && corners[k].concave && corners[(k + 2) % 4].convex();
        Self {
            borders: bits(corners.map(|c| c.border[0])),
            concave: bits(corners.map(|c| c.concave)),
            convex: bits(corners.map(|c| c.convex() && style.exterior > 0)),
            bend: bits((0..4).map(bends)),
        }
    }

    /// The value at a point that is so far from the sides.
    #[inline(always)]
    pub(super) fn value(self, style: Style, sides: Distances) -> f64 {
        let value = 1.0 - 2.0 * least(self.borders, sides);
        let value = if value > 0.0 { value } else { 0.0 };
        if self.concave | self.convex | self.bend == 0 { value } else { self.with_corners(style, sides, value) }
    }

    /// The value where corners make a difference.
    fn with_corners(self, style: Style, sides: Distances, value: f64) -> f64 {
        if self.bend != 0 {
            let r = radius(style.form, to_corner(sides, self.bend.trailing_zeros() as usize));
            return (2.0 * r - 1.0).abs().min(1.0);
        }
        let concave = |k: usize| radius(style.interior, to_corner(sides, k));
        let value = value.max(1.0 - 2.0 * least(self.concave, [concave(0), concave(1), concave(2), concave(3)]));
        let convex = |k: usize| {
            let [dx, dz] = to_corner(sides, k);
            match style.exterior {
                1 => (2.0 - 2.0 * (dx + dz)).min(1.0),
                _ if dx <= 0.5 && dz <= 0.5 => radius(2, [1.0 - 2.0 * dx, 1.0 - 2.0 * dz]).min(1.0),
                _ => 0.0,
            }
        };
        (0..4).filter(|k| has(self.convex, *k)).map(convex).fold(value, f64::max)
    }
}
