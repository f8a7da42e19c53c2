//! Tiles that repeat along two vectors: which one lies under a point, and how deep in it the point lies.
//!
//! Points are measured in steps of the lattice; what is left of them above whole steps tells the place in its cell. The
//! cell is cut into patches, and the few tiles that reach a patch, mostly one, are found beforehand. A tile's sides are
//! looked at four at a time, without a branch.

use super::{Tile, Uneven};
use crate::math::{DVec2, floor_small, lesser};
use std::collections::HashMap;

/// Patches along each side of the cell, a power of two. Each lies around a knot; those of the first knots lie half on
/// the near side of the cell and half on the far one.
const PATCHES: usize = 16;
/// Added to a small number, this leaves in its lowest bits how many knots lie below the nearest one.
const TO_KNOTS: f64 = ((3_u64 << 51) / PATCHES as u64) as f64;
/// Tiles that are this near to a patch reach it: rounding moves no point further whose coordinates are below 2^30.
const MARGIN: f64 = 1e-6;

/// Tiles that repeat along two vectors.
#[derive(Clone, Debug)]
pub struct Periodic {
    /// Steps of the lattice.
    steps: [DVec2; 2],
    /// How many of them x and z are worth.
    per_unit: [DVec2; 2],
    /// Where the first and the last of the tiles that reach a patch stand in `tiles`.
    patches: Box<[[u16; 2]; PATCHES * PATCHES]>,
    tiles: Box<[SideList]>,
    /// On a common side the later tile wins, as far as rounding of coordinates near 1 can tell: when the values differ by
    /// less.
    tie: f64,
}

/// A tile as its sides, in cache lines of its own, and the values at them and in its middle.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct SideList {
    first_sides: Sides,
    highest: f64,
    lowest: f64,
    /// What few tiles have.
    more: Option<Box<More>>,
}

/// What some tiles have beside four sides.
#[derive(Clone, Debug)]
struct More {
    sides: Box<[Sides]>,
    uneven: Option<Uneven>,
}

/// Four sides of a tile, some of which may be the same: by how much the value has fallen from the one at the side, where
/// the cell begins and for a step each along the lattice.
#[derive(Clone, Copy, Debug)]
struct Sides {
    offset: [f64; 4],
    along: [[f64; 4]; 2],
}

impl Periodic {
    /// Tiles in the cell of a lattice; their slopes end `rho` inside.
    pub(super) fn new(n_kinds: f64, rho: f64, steps: [DVec2; 2], tiles: &[Tile]) -> Self {
        let slope = 1.0 / (rho * n_kinds);
        // Patches with the same tiles share a list.
        let (mut known, mut listed) = (HashMap::new(), Vec::new());
        let patches = std::array::from_fn(|i| {
            *known.entry(tiles_near(i, steps, tiles)).or_insert_with_key(|near| {
                let first = listed.len() as u16;
                listed.extend(near.iter().map(|tile| SideList::new(&tiles[*tile], steps, slope, n_kinds)));
                [first, listed.len() as u16 - 1]
            })
        });
        let [a, b] = steps;
        let area = a.perp_dot(b);
        Self {
            steps,
            per_unit: [DVec2::new(b.y, -a.y) / area, DVec2::new(-b.x, a.x) / area],
            patches: Box::new(patches),
            tiles: listed.into(),
            tie: 32.0 * f64::EPSILON * slope,
        }
    }

    /// The value at a point, whose coordinates come in registers.
    #[inline(never)]
    pub(super) fn value(&self, x: f64, z: f64) -> f64 {
        let steps = self.per_unit[0] * x + self.per_unit[1] * z;
        let knot = |v: f64| (v + TO_KNOTS).to_bits() as usize % PATCHES;
        let [first, last] = self.patches[knot(steps.x) * PATCHES + knot(steps.y)];
        // In its cell.
        let (i, j) = (steps.x - floor_small(steps.x), steps.y - floor_small(steps.y));

        let mut index = usize::from(first);
        let mut tile = &self.tiles[index];
        let mut fall = tile.fall(i, j);
        // Tiles do not overlap: none can be deeper than one that holds the point, or as deep.
        while fall <= 2.0 * self.tie && index < usize::from(last) {
            index += 1;
            let other = &self.tiles[index];
            let other_fall = other.fall(i, j);
            if other_fall >= fall - self.tie {
                (tile, fall) = (other, other_fall);
            }
        }
        if let Some(More { uneven: Some(uneven), .. }) = tile.more.as_deref() {
            return uneven.value(tile.highest, tile.lowest, i * self.steps[0] + j * self.steps[1]);
        }
        let value = tile.highest - fall;
        if value > tile.lowest { value } else { tile.lowest }
    }
}

/// The tiles that reach a patch.
fn tiles_near(patch: usize, [a, b]: [DVec2; 2], tiles: &[Tile]) -> Vec<usize> {
    // A patch of the first knots lies on both sides of the cell.
    let middles = |i: usize| if i == 0 { [0.0, 1.0] } else { [i as f64 / PATCHES as f64; 2] };
    let half = 0.5 / PATCHES as f64;
    let reaches = |tile: &Tile, x: f64, y: f64| {
        let corners = [(-half, -half), (-half, half), (half, -half), (half, half)];
        let corners = corners.map(|(dx, dy)| (x + dx) * a + (y + dy) * b);
        // No side keeps all of the patch outside.
        tile.sides.iter().all(|(c, along)| corners.iter().any(|p| along.perp_dot(*p - *c) > -MARGIN))
    };
    let (xs, ys) = (middles(patch / PATCHES), middles(patch % PATCHES));
    let is_near = |tile: &Tile| xs.iter().any(|x| ys.iter().any(|y| reaches(tile, *x, *y)));
    (0..tiles.len()).filter(|i| is_near(&tiles[*i])).collect()
}

impl SideList {
    fn new(tile: &Tile, steps: [DVec2; 2], slope: f64, n_kinds: f64) -> Self {
        let group = |first: usize| {
            let sides = [0, 1, 2, 3].map(|i| tile.sides[(first + i).min(tile.sides.len() - 1)]);
            let along = |step: DVec2| sides.map(|(_, along)| slope * along.perp_dot(step));
            Sides { offset: sides.map(|(c, along)| -slope * along.perp_dot(c)), along: steps.map(along) }
        };
        let has_more = tile.sides.len() > 4 || tile.uneven;
        let more = || More {
            sides: (4..tile.sides.len()).step_by(4).map(group).collect(),
            uneven: tile.uneven.then(|| Uneven::new(&tile.sides, n_kinds)),
        };
        Self {
            first_sides: group(0),
            highest: (tile.kind + 1.0 + tile.added) / n_kinds,
            lowest: (tile.kind + tile.floor + tile.added) / n_kinds,
            more: has_more.then(|| Box::new(more())),
        }
    }

    /// How far the value falls from the nearest side's; negative outside.
    #[inline(always)]
    fn fall(&self, i: f64, j: f64) -> f64 {
        let fall = self.first_sides.fall(i, j);
        let Some(more) = &self.more else { return fall };
        more.sides.iter().fold(fall, |fall, sides| lesser(fall, sides.fall(i, j)))
    }
}

impl Sides {
    #[inline(always)]
    fn fall(&self, i: f64, j: f64) -> f64 {
        let Self { offset, along: [a, b] } = self;
        let from = |side: usize| a[side] * i + b[side] * j + offset[side];
        lesser(lesser(from(0), from(2)), lesser(from(1), from(3)))
    }
}
