//! Pavements: the plane of x and z in tiles that are joined squares or triangles.
//!
//! Some sides of the cells are borders of tiles, by a periodic table; everything else follows from which sides at a
//! corner are borders, and is worked out beforehand for every cell of a period. Source: section 10 of the pattern facts
//! (measured).

use super::pavement_table::{HEXAGON_PAVEMENTS, PavementMap, SQUARE_PAVEMENTS, TRIANGLE_PAVEMENTS};
use crate::math::{DVec3, floor_small, lesser};
use square::SquareCell;
use triangle::TriangleCell;

mod square;
mod triangle;

/// Height of a triangle of side 1.
const H: f64 = 0.866_025_403_784_438_6;

/// A pavement.
#[derive(Clone)]
pub struct Pavement {
    period: Period,
    cells: Cells,
    style: Style,
}

impl std::fmt::Debug for Pavement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pavement").field("period", &self.period).field("style", &self.style).finish_non_exhaustive()
    }
}

/// How corners are drawn.
#[derive(Clone, Copy, Debug)]
struct Style {
    interior: u32,
    exterior: u32,
    form: u32,
}

/// The cells of a period, by slot.
#[derive(Clone)]
enum Cells {
    Squares(Box<[SquareCell; SLOTS * SLOTS]>),
    /// The triangle at a lattice point, and that at the far side of it.
    Triangles(Box<[[TriangleCell; 2]; SLOTS * SLOTS]>),
}

/// Slots along each axis: those of a period and one before and after it, where rounding may lead.
const SLOTS: usize = 32;

/// After how many lattice points along either axis a pavement repeats.
#[derive(Clone, Copy, Debug)]
struct Period {
    size: [f64; 2],
    inverse: [f64; 2],
}

/// Which edges that leave a lattice point are borders, bit by bit, counter-clockwise from x towards z.
type Spokes = u8;

/// What makes the corner of a cell.
#[derive(Clone, Copy)]
struct Corner {
    /// Whether the cell's two sides there are borders.
    border: [bool; 2],
    /// Whether the sides next to those, outside the cell, are borders.
    beyond: [bool; 2],
    /// No side of the cell here is a border, but another one is.
    concave: bool,
}

impl Corner {
    /// The corner of a cell at a lattice point with such spokes, `n` edges in all; the cell's sides there lead along the
    /// edges `k` and `k + 1`.
    fn new(spokes: Spokes, n: usize, k: usize) -> Self {
        let is_border = |k: usize| spokes >> (k % n) & 1 == 1;
        let border = [is_border(k), is_border(k + 1)];
        Self { border, beyond: [is_border(k + n - 1), is_border(k + 2)], concave: border == [false; 2] && spokes != 0 }
    }

    fn convex(&self) -> bool {
        self.border == [true; 2]
    }
}

/// A bit for each corner or side of which something is true, the first one lowest.
fn bits(flags: impl IntoIterator<Item = bool>) -> u8 {
    flags.into_iter().enumerate().map(|(i, flag)| u8::from(flag) << i).sum()
}

/// Whether a bit of such a number is set.
#[inline(always)]
fn has(bits: u8, i: usize) -> bool {
    bits >> i & 1 == 1
}

/// Added to distances to what a cell does not have, by its bits.
static FAR: [[f64; 4]; 16] = {
    let mut far = [[f64::INFINITY; 4]; 16];
    let mut i = 0;
    while i < 64 {
        if (i / 4) >> (i % 4) & 1 == 1 {
            far[i / 4][i % 4] = 0.0;
        }
        i += 1;
    }
    far
};

/// The least of four distances, to those things of which a cell has some.
#[inline(always)]
fn least(bits: u8, distances: [f64; 4]) -> f64 {
    let far = &FAR[usize::from(bits) % FAR.len()];
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| distances[i] + far[i]);
    lesser(lesser(a, b), lesser(c, d))
}

impl PavementMap {
    /// The number of a lattice point within the period.
    fn point(&self, i: i64, j: i64) -> usize {
        let (width, height) = (i64::from(self.width), i64::from(self.height));
        let rows = j.div_euclid(height);
        let i = (i - rows * i64::from(self.shift)).rem_euclid(width);
        ((j - rows * height) * width + i) as usize
    }

    /// The spokes of a lattice point of squares, or else of triangles.
    fn spokes(&self, sides: u32, i: i64, j: i64) -> Spokes {
        let per_point = if sides == 4 { 2 } else { 3 };
        let edge = |i: i64, j: i64, edge: usize| (self.borders >> (self.point(i, j) * per_point + edge) & 1) as Spokes;
        let (left, below) = (edge(i - 1, j, 0), edge(i, j - 1, 1));
        let own = edge(i, j, 0) | edge(i, j, 1) << 1;
        if sides == 4 {
            own | left << 2 | below << 3
        } else {
            own | edge(i - 1, j, 2) << 2 | left << 3 | below << 4 | edge(i, j - 1, 2) << 5
        }
    }

    /// After how many points along either axis the map repeats.
    fn period(&self) -> Period {
        let heights = (1..).find(|n| n * u32::from(self.shift) % u32::from(self.width) == 0).unwrap_or(1);
        let size = [f64::from(self.width), f64::from(heights * u32::from(self.height))];
        Period { size, inverse: size.map(f64::recip) }
    }
}

impl Period {
    /// The slot of a lattice point (i, j), which is next below (a, b).
    #[inline(always)]
    fn slot(&self, [i, j]: [f64; 2], [a, b]: [f64; 2]) -> usize {
        // One more than points of the period before this one, in the lowest bits.
        const TO_SLOT: f64 = ((3_u64 << 51) + 1) as f64;
        let slot = |i: f64, a: f64, axis: usize| {
            let before = self.size[axis] * floor_small(a * self.inverse[axis]);
            (i - before + TO_SLOT).to_bits() as usize % SLOTS
        };
        slot(j, b, 1) * SLOTS + slot(i, a, 0)
    }
}

/// What `cell` gives for the lattice point of each slot.
fn slots<T>(cell: impl Fn(i64, i64) -> T) -> Box<[T; SLOTS * SLOTS]> {
    Box::new(std::array::from_fn(|slot| cell((slot % SLOTS) as i64 - 1, (slot / SLOTS) as i64 - 1)))
}

impl Pavement {
    /// Tiles of `tiles` cells in arrangement `pattern` (from 1); `None` where there is none.
    pub fn new(sides: u32, tiles: u32, pattern: u32, [interior, exterior, form]: [u32; 3]) -> Option<Self> {
        let by_tiles: &[&[PavementMap]] = match sides {
            3 => &TRIANGLE_PAVEMENTS,
            4 => &SQUARE_PAVEMENTS,
            6 => &HEXAGON_PAVEMENTS,
            _ => return None,
        };
        let map = by_tiles.get(tiles.checked_sub(1)? as usize)?.get(pattern.checked_sub(1)? as usize)?;
        let form = form % if sides == 4 { 4 } else { 3 };
        // Tiles of hexagons have no exterior corners.
        let exterior = if sides == 6 { 0 } else { exterior % 3 };
        let style = Style { interior: interior % 3, exterior, form };
        let around = |i: i64, j: i64| [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(a, b)| map.spokes(sides, i + a, j + b));
        let cells = if sides == 4 {
            Cells::Squares(slots(|i, j| SquareCell::new(around(i, j), style)))
        } else {
            Cells::Triangles(slots(|i, j| TriangleCell::pair(around(i, j), style)))
        };
        Some(Self { period: map.period(), cells, style })
    }

    /// The value at a point.
    pub(super) fn value(&self, p: DVec3) -> f64 {
        match &self.cells {
            Cells::Squares(cells) => self.in_squares(cells, p.x, p.z),
            Cells::Triangles(cells) => self.in_triangles(cells, p.x, p.z),
        }
    }

    #[inline(never)]
    fn in_squares(&self, cells: &[SquareCell; SLOTS * SLOTS], x: f64, z: f64) -> f64 {
        let (i, j) = (floor_small(x), floor_small(z));
        let cell = cells[self.period.slot([i, j], [x, z])];
        cell.value(self.style, [z - j, i + 1.0 - x, j + 1.0 - z, x - i])
    }

    #[inline(never)]
    fn in_triangles(&self, cells: &[[TriangleCell; 2]; SLOTS * SLOTS], x: f64, z: f64) -> f64 {
        let b = z / H;
        let a = x - 0.5 * b;
        let (i, j) = (floor_small(a), floor_small(b));
        let [near, far] = cells[self.period.slot([i, j], [a, b])];
        // From the lattice point.
        let (x, z) = (x - (i + 0.5 * j), z - H * j);
        if (a - i) + (b - j) < 1.0 {
            near.value(self.style, x, z)
        } else {
            // The far triangle is the near one, turned by half a circle.
            far.value(self.style, 1.5 - x, H - z)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Section 15 of the pattern facts: points P1 to P5; P6 lies on edges.
    fn check(shape: [u32; 3], style: [u32; 3], expected: [f64; 5]) {
        let points =
            [[0.3, 0.7, -1.2], [-1.37, 2.51, 0.68], [0.125, -0.25, 0.5], [12.9, -7.3, 33.4], [-250.75, 1003.3, -87.6]];
        let pavement = Pavement::new(shape[0], shape[1], shape[2], style).expect("a known pavement");
        for (p, expected) in points.into_iter().zip(expected) {
            let found = pavement.value(DVec3::from(p));
            assert!((found - expected).abs() < 2e-6, "{shape:?} {style:?} at {p:?}: {found} for {expected}");
        }
    }

    #[test]
    fn periods_have_room_and_repeat() {
        let all = [(3, &TRIANGLE_PAVEMENTS[..]), (4, &SQUARE_PAVEMENTS), (6, &HEXAGON_PAVEMENTS)];
        let maps =
            all.iter().flat_map(|(sides, by_tiles)| by_tiles.iter().flat_map(|maps| *maps).map(|map| (*sides, map)));
        for (sides, map) in maps {
            let period = map.period();
            assert!(period.size.iter().all(|size| *size <= (SLOTS - 2) as f64), "{period:?}");
            let spokes = slots(|i, j| map.spokes(sides, i, j));
            // Next below a lattice point's successors, too, where rounding leads to one period or the other.
            for (i, j) in (-40..40).flat_map(|i| (-40..40).map(move |j| (i, j))) {
                for above in [0.0, 0.5, 1.0_f64.next_down()] {
                    let at = [i, j].map(f64::from);
                    let slot = period.slot(at, at.map(|c| c + above));
                    assert_eq!(spokes[slot], map.spokes(sides, i.into(), j.into()), "{period:?} at {i}, {j}");
                }
            }
        }
    }

    #[test]
    fn pavements_match_the_binary() {
        check([3, 1, 1], [0, 0, 0], [0.978461, 0.932205, 0.508975, 0.449503, 0.544699]);
        check([4, 4, 3], [0, 0, 0], [0.6, 0.36, 0.75, 0.8, 0.2]);
        check([4, 6, 35], [1, 2, 2], [0.6, 0.36, 0.75, 0.2, 0.538516]);
        check([3, 6, 12], [2, 0, 0], [0.978461, 0.932205, 0.508975, 0.0, 0.544699]);
        check([3, 4, 2], [0, 1, 2], [0.115877, 0.681716, 0.508975, 0.449503, 0.477651]);
        check([6, 5, 22], [1, 0, 1], [1.0, 0.932205, 0.508975, 0.0, 1.0]);
    }
}
