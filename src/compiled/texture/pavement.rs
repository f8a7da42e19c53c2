//! Pavements: the plane of x and z in tiles that are joined squares or triangles.
//!
//! Some sides of the cells are borders of tiles, by a periodic table; everything else follows
//! from which sides at a corner are borders. Source: section 10 of the pattern facts (measured).

use super::pavement_table::{HEXAGON_PAVEMENTS, PavementMap, SQUARE_PAVEMENTS, TRIANGLE_PAVEMENTS};
use crate::math::{DVec2, DVec3, floor};

/// Height of a triangle of side 1.
const H: f64 = 0.866_025_403_784_438_6;
/// 2 sqrt(3): one over the distance from the middle of a triangle to its sides.
const K: f64 = 4.0 * H;

/// Unit directions of the lattice's edges, counter-clockwise from x towards z: of squares, and of triangles.
const SQUARE_DIRECTIONS: [DVec2; 4] = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
const TRIANGLE_DIRECTIONS: [DVec2; 6] =
    [DVec2::X, DVec2::new(0.5, H), DVec2::new(-0.5, H), DVec2::NEG_X, DVec2::new(-0.5, -H), DVec2::new(0.5, -H)];

/// A pavement.
#[derive(Clone)]
pub struct Pavement {
    map: &'static PavementMap,
    /// For each lattice point of a period the spokes of it and of the points that follow by (1, 0), (1, 1) and (0, 1).
    spokes: Box<[[Spokes; 4]]>,
    /// Three, four or six.
    sides: u32,
    interior: u32,
    exterior: u32,
    form: u32,
}

impl std::fmt::Debug for Pavement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pavement").field("sides", &self.sides).finish_non_exhaustive()
    }
}

/// Which edges that leave a lattice point are borders, bit by bit, in the order of their directions.
type Spokes = u8;

/// A corner of the cell under the point.
struct Corner {
    at: DVec2,
    /// Unit directions of the cell's two sides there.
    along: [DVec2; 2],
    /// Whether those sides are borders.
    border: [bool; 2],
    /// Whether the sides next to those, outside the cell, are borders.
    beyond: [bool; 2],
    /// No side of the cell here is a border, but another one is.
    concave: bool,
}

impl Corner {
    fn convex(&self) -> bool {
        self.border == [true, true]
    }
}

impl PavementMap {
    /// The number of a lattice point within the period.
    fn point(&self, i: i64, j: i64) -> usize {
        let (width, height) = (i64::from(self.width), i64::from(self.height));
        let rows = j.div_euclid(height);
        let i = i.wrapping_sub(rows.wrapping_mul(i64::from(self.shift))).rem_euclid(width);
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
        let forms = if sides == 4 { 4 } else { 3 };
        let spokes = (0..i64::from(map.width) * i64::from(map.height))
            .map(|at| {
                let (i, j) = (at % i64::from(map.width), at / i64::from(map.width));
                [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(a, b)| map.spokes(sides, i + a, j + b))
            })
            .collect();
        Some(Self { map, spokes, sides, interior: interior % 3, exterior: exterior % 3, form: form % forms })
    }

    /// The corner of a cell at a lattice point with such spokes; the cell's sides there lead along `k` and `k + 1` of the
    /// directions.
    #[inline]
    fn corner(spokes: Spokes, at: DVec2, directions: &[DVec2], k: usize) -> Corner {
        let n = directions.len();
        let wrapped = |k: usize| if k >= n { k - n } else { k };
        let is_border = |k: usize| spokes >> k & 1 == 1;
        let border = [is_border(k), is_border(wrapped(k + 1))];
        Corner {
            at,
            along: [directions[k], directions[wrapped(k + 1)]],
            border,
            beyond: [is_border(wrapped(k + n - 1)), is_border(wrapped(k + 2))],
            concave: border == [false, false] && spokes != 0,
        }
    }

    /// The value at a point.
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let p = DVec2::new(p.x, p.z);
        if self.sides == 4 {
            let (i, j) = (floor(p.x), floor(p.y));
            let spokes = self.spokes[self.map.point(i as i64, j as i64)];
            let corner =
                |a: f64, b: f64, k: usize| Self::corner(spokes[k], DVec2::new(i + a, j + b), &SQUARE_DIRECTIONS, k);
            self.square(p, &[corner(0.0, 0.0, 0), corner(1.0, 0.0, 1), corner(1.0, 1.0, 2), corner(0.0, 1.0, 3)])
        } else {
            let b = p.y / H;
            let a = p.x - 0.5 * b;
            let (i, j) = (floor(a), floor(b));
            let spokes = self.spokes[self.map.point(i as i64, j as i64)];
            let corner = |[a, b]: [f64; 2], spokes: Spokes, k: usize| {
                let at = DVec2::new((i + a) + 0.5 * (j + b), H * (j + b));
                Self::corner(spokes, at, &TRIANGLE_DIRECTIONS, k)
            };
            let [here, right, across, up] = spokes;
            let is_lower = (a - i) + (b - j) < 1.0;
            let corners = if is_lower {
                [corner([0.0, 0.0], here, 0), corner([1.0, 0.0], right, 2), corner([0.0, 1.0], up, 4)]
            } else {
                [corner([1.0, 1.0], across, 3), corner([0.0, 1.0], up, 5), corner([1.0, 0.0], right, 1)]
            };
            self.triangle(p, &corners)
        }
    }

    fn square(&self, p: DVec2, corners: &[Corner; 4]) -> f64 {
        let radius = |kind: u32, d: DVec2| match kind {
            0 => d.max_element(),
            1 => d.x + d.y,
            _ => d.length(),
        };
        let from = |c: &Corner| (p - c.at).abs();
        let is_bend = |i: usize| corners[i].concave && corners[(i + 2) % 4].convex();
        if self.form < 3
            && let Some(i) = (0..4).find(|i| is_bend(*i))
        {
            return (2.0 * radius(self.form, from(&corners[i])) - 1.0).abs().min(1.0);
        }
        let mut value: f64 = 0.0;
        for corner in corners {
            let d = from(corner);
            for side in 0..2 {
                if corner.border[side] {
                    // A side along x is as far away as the point is in z.
                    let distance = if corner.along[side].x.abs() > 0.5 { d.y } else { d.x };
                    value = value.max(1.0 - 2.0 * distance);
                }
            }
            if corner.concave {
                value = value.max(1.0 - 2.0 * radius(self.interior, d));
            }
            if corner.convex() {
                match self.exterior {
                    1 => value = value.max((2.0 - 2.0 * (d.x + d.y)).min(1.0)),
                    2 if d.max_element() <= 0.5 => {
                        value = value.max((DVec2::ONE - 2.0 * d).length().min(1.0));
                    }
                    _ => {}
                }
            }
        }
        value
    }

    fn triangle(&self, p: DVec2, corners: &[Corner; 3]) -> f64 {
        let center = (corners[0].at + corners[1].at + corners[2].at) / 3.0;
        let to_side = |c: &Corner, side: usize| c.along[side].perp_dot(p - c.at).abs();
        let mut value: f64 = 0.0;
        for corner in corners {
            for side in 0..2 {
                if corner.border[side] {
                    value = value.max(1.0 - K * to_side(corner, side));
                }
            }
        }
        let own = |c: &Corner| {
            let d = (p - c.at).length_squared();
            corners.iter().all(|other| d <= (p - other.at).length_squared())
        };
        for corner in corners.iter().filter(|c| c.concave) {
            let offset = p - corner.at;
            let inward = (center - corner.at).normalize();
            match self.interior {
                0 => value = value.max(1.0 - K * offset.dot(inward)),
                1 if own(corner) => {
                    let reach = offset.dot(corner.along[0]).max(offset.dot(corner.along[1]));
                    value = value.max(1.0 - 3.0 * reach);
                }
                2 => value = value.max(1.0 - 3.0 * offset.length()),
                _ => {}
            }
        }
        for corner in corners {
            if self.sides == 3 && corner.convex() {
                let inward = (center - corner.at).normalize();
                let to_opposite = H - (p - corner.at).dot(inward);
                match self.exterior {
                    1 if (0..2).all(|side| to_side(corner, side) <= 1.0 / K) => {
                        value = (K * (to_opposite - H / 3.0).abs()).min(1.0);
                    }
                    2 if own(corner) => value = (K * (p - center).length()).min(1.0),
                    _ => {}
                }
            }
            if self.form > 0
                && own(corner)
                && let Some(open) = bent(corner)
            {
                let far = corner.at + corner.along[open];
                value = if self.form == 2 {
                    (K * ((p - far).length() - 2.0 * H / 3.0)).clamp(0.0, 1.0)
                } else {
                    (2.0 * (2.0 * (p - far).dot(corner.at - far) - 1.0)).min(1.0)
                };
            }
        }
        value
    }
}

/// The open side of a corner where the tile's wedge is two triangles wide.
fn bent(corner: &Corner) -> Option<usize> {
    match (corner.border, corner.beyond) {
        ([true, false], [_, true]) => Some(1),
        ([false, true], [true, _]) => Some(0),
        _ => None,
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
    fn pavements_match_the_binary() {
        check([3, 1, 1], [0, 0, 0], [0.978461, 0.932205, 0.508975, 0.449503, 0.544699]);
        check([4, 4, 3], [0, 0, 0], [0.6, 0.36, 0.75, 0.8, 0.2]);
        check([4, 6, 35], [1, 2, 2], [0.6, 0.36, 0.75, 0.2, 0.538516]);
        check([3, 6, 12], [2, 0, 0], [0.978461, 0.932205, 0.508975, 0.0, 0.544699]);
        check([3, 4, 2], [0, 1, 2], [0.115877, 0.681716, 0.508975, 0.449503, 0.477651]);
        check([6, 5, 22], [1, 0, 1], [1.0, 0.932205, 0.508975, 0.0, 1.0]);
    }
}
