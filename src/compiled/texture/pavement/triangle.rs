//! The cells of pavements that are triangles, or hexagons of six triangles.
//!
//! Each is looked at in the space of the triangle (0, 0), (1, 0), (1/2, H).

use super::{Corner, H, Spokes, Style, bits, has, least};
use crate::math::DVec2;

/// 2 sqrt(3): one over the distance from the middle of a triangle to its sides.
const K: f64 = 4.0 * H;

/// Corners, counter-clockwise from x towards z.
const CORNERS: [DVec2; 3] = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, H)];
/// Unit directions of the two sides at each corner.
const ALONG: [[DVec2; 2]; 3] =
    [[DVec2::X, DVec2::new(0.5, H)], [DVec2::new(-0.5, H), DVec2::NEG_X], [DVec2::new(-0.5, -H), DVec2::new(0.5, -H)]];
/// Unit directions from each corner to the middle.
const INWARD: [DVec2; 3] = [DVec2::new(H, 0.5), DVec2::new(-H, 0.5), DVec2::NEG_Y];
const MIDDLE: DVec2 = DVec2::new(0.5, H / 3.0);

/// What a triangle has, bit by bit: sides by the corner where they begin, in the order of the corners. Corners count
/// where the style draws them.
#[derive(Clone, Copy, Debug)]
pub(super) struct TriangleCell {
    /// Sides that are borders.
    borders: u8,
    /// Corners from which borders lead only outside of the cell.
    concave: u8,
    /// Corners between two borders.
    convex: u8,
    /// Corners with one border where the tile is two triangles wide: those whose open side is the first, the second.
    bent: [u8; 2],
}

impl TriangleCell {
    /// The two triangles between four lattice points, of which these are the spokes.
    pub(super) fn pair([here, right, across, up]: [Spokes; 4], style: Style) -> [Self; 2] {
        let of = |spokes: [Spokes; 3], first: usize| {
            Self::new([0, 1, 2].map(|i| Corner::new(spokes[i], 6, first + 2 * i)), style)
        };
        [of([here, right, up], 0), of([across, up, right], 3)]
    }

    fn new(corners: [Corner; 3], style: Style) -> Self {
        let is_bent = |c: Corner, open: usize| c.border[1 - open] && !c.border[open] && c.beyond[open];
        let bent = |open: usize| bits(corners.map(|c| is_bent(c, open) && style.form > 0));
        Self {
            borders: bits(corners.map(|c| c.border[0])),
            concave: bits(corners.map(|c| c.concave)),
            convex: bits(corners.map(|c| c.convex() && style.exterior > 0)),
            bent: [bent(0), bent(1)],
        }
    }

    /// The value at a point.
    #[inline(always)]
    pub(super) fn value(self, style: Style, x: f64, z: f64) -> f64 {
        let [below, right, left] = to_sides(x, z);
        let value = 1.0 - K * least(self.borders, [below, right, left, f64::INFINITY]);
        let value = if value > 0.0 { value } else { 0.0 };
        let is_plain = self.concave | self.convex | self.bent[0] | self.bent[1] == 0;
        if is_plain { value } else { self.with_corners(style, x, z, value) }
    }

    /// The value where corners make a difference.
    #[inline(never)]
    fn with_corners(self, style: Style, x: f64, z: f64, mut value: f64) -> f64 {
        let p = DVec2::new(x, z);
        let own = |k: usize| {
            let distance = |k: usize| (p - CORNERS[k]).length_squared();
            (0..3).all(|other| distance(k) <= distance(other))
        };
        for k in (0..3).filter(|k| has(self.concave, *k)) {
            let offset = p - CORNERS[k];
            value = value.max(match style.interior {
                0 => 1.0 - K * offset.dot(INWARD[k]),
                1 if own(k) => 1.0 - 3.0 * offset.dot(ALONG[k][0]).max(offset.dot(ALONG[k][1])),
                2 => 1.0 - 3.0 * offset.length(),
                _ => 0.0,
            });
        }
        for k in 0..3 {
            if has(self.convex, k) {
                let to_opposite = H - (p - CORNERS[k]).dot(INWARD[k]);
                let sides = to_sides(x, z);
                match style.exterior {
                    1 if sides[k].max(sides[(k + 2) % 3]) <= 1.0 / K => {
                        value = (K * (to_opposite - H / 3.0).abs()).min(1.0);
                    }
                    2 if own(k) => value = (K * (p - MIDDLE).length()).min(1.0),
                    _ => {}
                }
            }
            let open = (0..2).find(|open| has(self.bent[*open], k));
            if let Some(open) = open
                && own(k)
            {
                let along = ALONG[k][open];
                let from_far = p - (CORNERS[k] + along);
                value = if style.form == 2 {
                    (K * (from_far.length() - 2.0 * H / 3.0)).clamp(0.0, 1.0)
                } else {
                    (2.0 * (-2.0 * from_far.dot(along) - 1.0)).min(1.0)
                };
            }
        }
        value
    }
}

/// Distances to the sides.
#[inline(always)]
fn to_sides(x: f64, z: f64) -> [f64; 3] {
    [z.abs(), (0.5 * z + H * (x - 1.0)).abs(), (0.5 * z - H * x).abs()]
}
