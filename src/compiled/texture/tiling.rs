//! Tilings of the plane of x and z by regular polygons and their kin.
//!
//! A tiling is a periodic set of convex tiles of several kinds; the value rises from the
//! middle of a tile to its sides: v = (kind + max(0, 1 - d / rho)) / number of kinds, with d the
//! distance to the nearest side. Source: section 9 of the pattern facts (measured).

use super::penrose::Penrose;
use crate::math::{DVec2, DVec3};
pub use periodic::Periodic;

mod periodic;

/// By how much POV-Ray keeps values of some tiles apart from those of other kinds.
pub(super) const POV_EDGE: f64 = 1e-6;

/// Height of a triangle of side 1.
const H: f64 = 0.866_025_403_784_438_6;
/// sqrt(3)
const R3: f64 = 2.0 * H;

/// One of the tilings.
#[derive(Clone, Debug)]
pub enum Tiling {
    /// Tilings 1 to 24.
    Periodic(Box<Periodic>),
    /// Tilings 25 to 27.
    Penrose(Penrose),
}

impl Tiling {
    /// Tiling `n`, 1 to 27.
    pub fn new(n: u32) -> Option<Self> {
        match n {
            1..=24 => Some(Self::Periodic(Box::new(periodic_tiling(n)))),
            25..=27 => Penrose::new(n).map(Self::Penrose),
            _ => None,
        }
    }

    /// The value at a point.
    #[inline(always)]
    pub(super) fn value(&self, p: DVec3) -> f64 {
        match self {
            Self::Periodic(tiles) => tiles.value(p.x, p.z),
            Self::Penrose(penrose) => penrose.value(DVec2::new(p.x, p.z)),
        }
    }
}

/// First corner and unit direction of a side.
type Side = (DVec2, DVec2);

/// A convex polygon, counter-clockwise from x towards z.
#[derive(Clone, Debug)]
struct Tile {
    corners: Vec<DVec2>,
    sides: Vec<Side>,
    kind: f64,
    /// Keeps a kind's lowest values from touching the kind below, as POV-Ray does.
    floor: f64,
    /// Added, for the same reason.
    added: f64,
    /// The dodecagon of tiling 22, whose sides have slopes of their own.
    uneven: bool,
}

impl Tile {
    fn new(kind: u32, corners: Vec<DVec2>) -> Self {
        let area: f64 = (0..corners.len()).map(|i| corners[i].perp_dot(corners[(i + 1) % corners.len()])).sum();
        let corners = if area < 0.0 { corners.into_iter().rev().collect() } else { corners };
        Self { sides: sides_of(&corners), corners, kind: f64::from(kind), floor: 0.0, added: 0.0, uneven: false }
    }

    fn moved(&self, shift: DVec2) -> Self {
        let corners: Vec<_> = self.corners.iter().map(|c| *c + shift).collect();
        Self { sides: sides_of(&corners), corners, ..*self }
    }

    fn floor(self, floor: f64) -> Self {
        Self { floor, ..self }
    }

    fn added(self, added: f64) -> Self {
        Self { added, ..self }
    }

    fn center(&self) -> DVec2 {
        self.corners.iter().sum::<DVec2>() / self.corners.len() as f64
    }

    /// Distance to the nearest side's line; negative outside.
    fn depth(&self, p: DVec2) -> f64 {
        self.sides.iter().map(|(a, along)| along.perp_dot(p - *a)).fold(f64::INFINITY, f64::min)
    }
}

/// The sides of the dodecagon of tiling 22, whose slopes are of their own.
#[derive(Clone, Debug)]
struct Uneven {
    /// How much the value falls from each over a unit of length: away from the strip along the topmost side, and in it.
    sides: Box<[(Side, [f64; 2])]>,
    top: Side,
}

impl Uneven {
    fn new(sides: &[Side], n_kinds: f64) -> Self {
        let faces = |along: DVec2, degrees: f64| DVec2::new(along.y, -along.x).dot(direction(degrees)) > 0.99;
        let slope = |along: DVec2, gentle: &[f64]| if gentle.iter().any(|d| faces(along, *d)) { 3.0 } else { 2.0 * R3 };
        let slopes = |along: DVec2| [&[0.0, 180.0, -90.0][..], &[30.0, 150.0]].map(|g| slope(along, g) / n_kinds);
        let top = *sides.iter().find(|(_, along)| faces(*along, 90.0)).unwrap_or(&(DVec2::ZERO, DVec2::X));
        Self { sides: sides.iter().map(|side| (*side, slopes(side.1))).collect(), top }
    }

    /// The value, which falls from the highest at the sides to the lowest.
    #[inline(never)]
    fn value(&self, highest: f64, lowest: f64, p: DVec2) -> f64 {
        let distance = |(a, along): Side| along.perp_dot(p - a);
        let in_strip = usize::from(distance(self.top) <= 0.5);
        let at = |(side, slopes): &(_, [f64; 2])| highest - slopes[in_strip] * distance(*side);
        self.sides.iter().map(at).fold(lowest, f64::max)
    }
}

/// The sides of a polygon.
fn sides_of(corners: &[DVec2]) -> Vec<Side> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(from, to)| (*from, (*to - *from).normalize())).collect()
}

fn v(x: f64, z: f64) -> DVec2 {
    DVec2::new(x, z)
}

fn direction(degrees: f64) -> DVec2 {
    DVec2::from_angle(degrees.to_radians())
}

fn poly(kind: u32, corners: &[(f64, f64)]) -> Tile {
    Tile::new(kind, corners.iter().map(|(x, z)| v(*x, *z)).collect())
}

/// The rectangle between two corners.
fn rect(kind: u32, x: [f64; 2], z: [f64; 2]) -> Tile {
    poly(kind, &[(x[0], z[0]), (x[1], z[0]), (x[1], z[1]), (x[0], z[1])])
}

/// A regular polygon of side 1 with its first corner in a direction.
fn regular(kind: u32, n: u32, center: DVec2, first_deg: f64) -> Tile {
    let radius = 0.5 / (std::f64::consts::PI / f64::from(n)).sin();
    let corner = |i: u32| center + radius * direction(first_deg + 360.0 * f64::from(i) / f64::from(n));
    Tile::new(kind, (0..n).map(corner).collect())
}

/// A square of side 1 whose sides face `facing_deg` and three more directions.
fn square(kind: u32, center: DVec2, facing_deg: f64) -> Tile {
    regular(kind, 4, center, facing_deg + 45.0)
}

/// Tilings 1 to 24.
fn periodic_tiling(n: u32) -> Periodic {
    let (n_kinds, rho, steps, tiles) = tiles_of(n);
    let tiles: Vec<_> = tiles.iter().flat_map(|tile| copies_at_origin(tile, steps)).collect();
    Periodic::new(n_kinds, rho, steps, &tiles)
}

/// The copies of a tile that overlap the lattice cell at the origin.
fn copies_at_origin(tile: &Tile, [a, b]: [DVec2; 2]) -> Vec<Tile> {
    let area = a.perp_dot(b);
    let mut copies = Vec::new();
    let center = tile.center();
    // In lattice coordinates the tile's centre moves to 0..1; its reach there is bounded by its own corners.
    let lattice = |p: DVec2| v(p.perp_dot(b) / area, a.perp_dot(p) / area);
    let base = lattice(center).floor();
    let reach = 4;
    for i in -reach..=reach {
        for j in -reach..=reach {
            let shift = (f64::from(i) - base.x) * a + (f64::from(j) - base.y) * b;
            let copy = tile.moved(shift);
            let spots: Vec<DVec2> = copy.corners.iter().map(|c| lattice(*c)).collect();
            let low = spots.iter().copied().reduce(DVec2::min).unwrap_or_default();
            let high = spots.iter().copied().reduce(DVec2::max).unwrap_or_default();
            if low.x < 1.0 && low.y < 1.0 && high.x > 0.0 && high.y > 0.0 {
                copies.push(copy);
            }
        }
    }
    copies
}

/// Number of kinds, slope length, lattice and tiles of tilings 1 to 24.
fn tiles_of(n: u32) -> (f64, f64, [DVec2; 2], Vec<Tile>) {
    let rho3 = 1.0 / (2.0 * R3);
    let r2 = 2.0_f64.sqrt();
    match n {
        1 => (1.0, 0.5, [DVec2::X, DVec2::Y], vec![rect(0, [0.0, 1.0], [0.0, 1.0])]),
        2 => (1.0, H, [v(1.5, H), v(0.0, 2.0 * H)], vec![regular(0, 6, v(0.5, H), 0.0)]),
        3 => (2.0, rho3, [DVec2::X, v(0.5, H)], triangle_pair(0.0)),
        4 => (1.0, H / 2.0, [DVec2::X, v(0.5, H)], vec![poly(0, &[(0.0, 0.0), (1.0, 0.0), (1.5, H), (0.5, H)])]),
        5 => (
            3.0,
            H / 2.0,
            [v(3.0, 0.0), v(1.5, H)],
            vec![
                poly(0, &[(0.0, 0.0), (1.0, 0.0), (1.5, H), (0.5, H)]),
                poly(1, &[(1.5, -H), (2.0, 0.0), (1.5, H), (1.0, 0.0)]),
                poly(2, &[(2.0, 0.0), (3.0, 0.0), (2.5, H), (1.5, H)]),
            ],
        ),
        6 => (
            2.0,
            0.5,
            [v(1.0, 1.0), v(4.0, 0.0)],
            vec![rect(0, [1.0, 3.0], [0.0, 1.0]), rect(1, [0.0, 1.0], [0.0, 2.0])],
        ),
        7 => {
            let q = 1.0 + r2;
            let octagon = regular(1, 8, DVec2::ZERO, 22.5).floor(2e-12);
            (2.0, 0.5, [v(q, 0.0), v(0.0, q)], vec![regular(0, 4, v(q / 2.0, q / 2.0), 0.0), octagon])
        }
        8 => {
            let mut tiles = triangle_pair(1.0);
            tiles.push(rect(2, [0.0, 1.0], [0.0, 1.0]).added(1e-7));
            (3.0, rho3, [DVec2::X, v(0.5, 1.0 + H)], tiles)
        }
        9 => (
            3.0,
            rho3,
            [v(2.0, 0.0), v(1.0, 2.0 * H)],
            vec![
                poly(0, &[(-1.0, 0.0), (0.0, 0.0), (-0.5, H)]),
                poly(1, &[(0.0, 0.0), (0.5, -H), (1.0, 0.0)]),
                regular(2, 6, v(0.5, H), 0.0).floor(1e-7),
            ],
        ),
        10 => (1.0, 0.5, [DVec2::X, v(0.5, 1.0)], vec![rect(0, [0.0, 1.0], [0.0, 1.0])]),
        11 => (3.0, 0.5, [v(3.0, 0.0), v(0.0, 3.0)], pinwheel()),
        12 => (3.0, 0.5, [v(6.0, 0.0), v(0.0, 6.0)], pinwheel().iter().flat_map(reflections).collect()),
        13 => (3.0, 0.5 / r2, [v(2.0 * r2, 0.0), v(0.0, 2.0 * r2)], frames([2, 2, 1, 1, 0], 0.0)),
        14 => (5.0, 0.5 / r2, [v(2.0 * r2, 0.0), v(0.0, 2.0 * r2)], frames([0, 1, 2, 3, 4], POV_EDGE)),
        15 => (
            2.0,
            0.5,
            [v(2.0, 1.0), v(-1.0, 2.0)],
            vec![rect(0, [0.0, 1.0], [0.0, 1.0]), rect(1, [1.0, 3.0], [-1.0, 1.0]).added(2e-8)],
        ),
        16 | 17 => (if n == 16 { 3.0 } else { 6.0 }, rho3, hexagon_lattice(), hexagons_in_squares(n)),
        18 => (
            2.0,
            0.5,
            [v(2.0, 2.0), v(4.0, 0.0)],
            vec![
                rect(0, [2.0, 4.0], [0.0, 1.0]),
                rect(0, [2.0, 4.0], [1.0, 2.0]),
                rect(1, [0.0, 1.0], [0.0, 2.0]),
                rect(1, [1.0, 2.0], [0.0, 2.0]),
            ],
        ),
        19 => hexagons_in_triangles([v(-0.5, 3.0 * H), v(2.5, -H)], rho3),
        20 => hexagons_in_triangles([v(0.5, 3.0 * H), v(2.5, H)], rho3),
        21 => squares_in_triangles(rho3),
        22 => {
            let mut dodecagon = regular(2, 12, v(1.0 + H, 1.0 + H), 15.0).added(1e-7);
            dodecagon.uneven = true;
            let lower = poly(0, &[(-0.5, 0.5), (0.5, 0.5), (0.0, 0.5 + H)]);
            let top = 2.0 * (1.0 + H);
            let upper = poly(1, &[(-0.5, top - 0.5), (0.5, top - 0.5), (0.0, top - 0.5 - H)]);
            (3.0, rho3, [v(2.0 + R3, 0.0), v(1.0 + H, 1.5 + R3)], vec![dodecagon, lower, upper])
        }
        _ => dodecagons_and_hexagons(n == 24),
    }
}

/// The two triangles of a strip that starts at height `z`.
fn triangle_pair(z: f64) -> Vec<Tile> {
    vec![poly(0, &[(0.0, z), (1.0, z), (0.5, z + H)]), poly(1, &[(0.5, z + H), (1.0, z), (1.5, z + H)])]
}

fn pinwheel() -> Vec<Tile> {
    vec![
        rect(0, [1.0, 2.0], [1.0, 2.0]),
        rect(1, [1.0, 3.0], [0.0, 1.0]),
        rect(1, [0.0, 2.0], [2.0, 3.0]),
        rect(2, [0.0, 1.0], [0.0, 2.0]),
        rect(2, [2.0, 3.0], [1.0, 3.0]),
    ]
}

/// The tile around (3, 3) instead of the origin, and its images in both axes there.
fn reflections(tile: &Tile) -> [Tile; 4] {
    [v(1.0, 1.0), v(-1.0, 1.0), v(1.0, -1.0), v(-1.0, -1.0)].map(|sign| {
        let corners = tile.corners.iter().map(|c| 3.0 + sign * *c).collect();
        Tile { kind: tile.kind, ..Tile::new(0, corners) }
    })
}

/// A square in a square; trapezia between them by kind: +x, -x, -z, +z, then the centre.
fn frames(kinds: [u32; 5], center_added: f64) -> Vec<Tile> {
    let at = |x: f64, z: f64| ((x + 2.0) / 2.0_f64.sqrt(), (z + 2.0) / 2.0_f64.sqrt());
    vec![
        poly(kinds[0], &[at(1.0, -1.0), at(2.0, -2.0), at(2.0, 2.0), at(1.0, 1.0)]),
        poly(kinds[1], &[at(-1.0, -1.0), at(-1.0, 1.0), at(-2.0, 2.0), at(-2.0, -2.0)]),
        poly(kinds[2], &[at(-1.0, -1.0), at(-2.0, -2.0), at(2.0, -2.0), at(1.0, -1.0)]),
        poly(kinds[3], &[at(-1.0, 1.0), at(1.0, 1.0), at(2.0, 2.0), at(-2.0, 2.0)]),
        poly(kinds[4], &[at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)]).added(center_added),
    ]
}

/// One step up, and that step turned by -60 degrees.
fn hexagon_lattice() -> [DVec2; 2] {
    let up = v(0.0, 1.0 + R3);
    [up, direction(-60.0).rotate(up)]
}

/// Hexagons with squares on their sides and triangles at their corners, for tilings 16 and 17.
fn hexagons_in_squares(n: u32) -> Vec<Tile> {
    let colored = n == 17;
    let c = v(0.5 + H, 0.5 + H);
    let mut tiles = vec![regular(if colored { 5 } else { 2 }, 6, c, 0.0).floor(if colored { POV_EDGE } else { 1e-7 })];
    for k in 0..6 {
        let side = 30.0 + 60.0 * f64::from(k);
        let kind = match k {
            _ if !colored => 0,
            1 | 4 => 0, // above and below
            2 | 5 => 2, // 150 and -30
            _ => 1,     // 30 and 210
        };
        let added = if kind > 0 { POV_EDGE } else { 0.0 };
        tiles.push(square(kind, c + (H + 0.5) * direction(side), side).added(added));
        let corner = 60.0 * f64::from(k);
        let tip = c + direction(corner);
        let kind = match k {
            _ if !colored => 1,
            1 | 3 | 5 => 3, // 60, 180, -60
            _ => 4,
        };
        tiles.push(Tile::new(kind, vec![tip, tip + direction(corner - 30.0), tip + direction(corner + 30.0)]));
    }
    tiles
}

/// Hexagons cut out of the net of triangles, for tilings 19 and 20.
fn hexagons_in_triangles(steps: [DVec2; 2], rho: f64) -> (f64, f64, [DVec2; 2], Vec<Tile>) {
    let hexagon = regular(2, 6, v(1.0, 2.0 * H), 0.0).floor(POV_EDGE);
    let holes = copies_around(&hexagon, steps);
    let mut tiles = vec![hexagon];
    for i in -4..=4 {
        for j in -4..=4 {
            let origin = f64::from(i) * DVec2::X + f64::from(j) * v(0.5, H);
            for triangle in triangle_pair(0.0) {
                let triangle = triangle.moved(origin);
                let center = triangle.center();
                if holes.iter().all(|hole| hole.depth(center) < 0.0) {
                    tiles.push(triangle);
                }
            }
        }
    }
    (3.0, rho, steps, tiles)
}

fn copies_around(tile: &Tile, [a, b]: [DVec2; 2]) -> Vec<Tile> {
    let shifted = |i: i32, j: i32| tile.moved(f64::from(i) * a + f64::from(j) * b);
    (-6..=6).flat_map(|i| (-6..=6).map(move |j| (i, j))).map(|(i, j)| shifted(i, j)).collect()
}

/// Snub squares, tiling 21.
fn squares_in_triangles(rho: f64) -> (f64, f64, [DVec2; 2], Vec<Tile>) {
    let q = 1.0 + R3;
    let first = [v(0.0, 0.5), v(H, 0.0), v(q / 2.0, H), v(0.5, q / 2.0)];
    let mirrored =
        |x: bool, z: bool| first.map(|c| v(if x { q - c.x } else { c.x }, if z { q - c.y } else { c.y })).to_vec();
    let mut tiles = vec![
        Tile::new(4, mirrored(false, false)).floor(POV_EDGE),
        Tile::new(5, mirrored(true, false)).floor(POV_EDGE),
        Tile::new(5, mirrored(false, true)).floor(POV_EDGE),
        Tile::new(4, mirrored(true, true)).floor(POV_EDGE),
    ];
    for c in [DVec2::ZERO, v(q / 2.0, q / 2.0)] {
        let (a, b) = (c + v(0.0, -0.5), c + v(0.0, 0.5));
        tiles.push(Tile::new(0, vec![a, b, c + v(H, 0.0)]));
        tiles.push(Tile::new(2, vec![a, b, c - v(H, 0.0)]));
    }
    for c in [v(q / 2.0, 0.0), v(0.0, q / 2.0)] {
        let (a, b) = (c + v(-0.5, 0.0), c + v(0.5, 0.0));
        tiles.push(Tile::new(1, vec![a, b, c - v(0.0, H)]));
        tiles.push(Tile::new(3, vec![a, b, c + v(0.0, H)]));
    }
    (6.0, rho, [v(q, 0.0), v(0.0, q)], tiles)
}

/// Dodecagons, squares and hexagons, tilings 23 and 24.
fn dodecagons_and_hexagons(colored: bool) -> (f64, f64, [DVec2; 2], Vec<Tile>) {
    let c = v(1.5 + H, 1.0 + R3);
    let mut tiles = vec![regular(if colored { 4 } else { 2 }, 12, c, 15.0).added(POV_EDGE)];
    for k in 0..6 {
        let side = 60.0 * f64::from(k);
        let kind = if colored { 1 + k % 3 } else { 1 };
        tiles.push(square(kind, c + (1.5 + H) * direction(side), side));
        tiles.push(regular(0, 6, c + (1.0 + R3) * direction(side + 30.0), 0.0));
    }
    let steps = [v(3.0 + R3, 0.0), v((3.0 + R3) / 2.0, 1.5 * (1.0 + R3))];
    (if colored { 5.0 } else { 3.0 }, 0.5, steps, tiles)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Section 15 of the pattern facts: points P1 to P5; P6 lies on edges.
    fn check(n: u32, expected: [f64; 5]) {
        let points =
            [[0.3, 0.7, -1.2], [-1.37, 2.51, 0.68], [0.125, -0.25, 0.5], [12.9, -7.3, 33.4], [-250.75, 1003.3, -87.6]];
        let tiling = Tiling::new(n).expect("a known tiling");
        for (p, expected) in points.into_iter().zip(expected) {
            let found = tiling.value(DVec3::from(p));
            assert!((found - expected).abs() < 4e-6, "tiling {n} at {p:?}: {found} for {expected}");
        }
    }

    #[test]
    fn tilings_match_the_binary() {
        check(1, [0.6, 0.36, 0.75, 0.8, 0.5]);
        check(2, [0.39282, 0.785196, 0.586325, 0.616501, 0.825884]);
        check(3, [0.989231, 0.966103, 0.754487, 0.724752, 0.772349]);
        check(4, [0.985641, 0.570393, 0.67265, 0.233002, 0.696466]);
        check(5, [0.66188, 0.984935, 0.55755, 0.077667, 0.232155]);
        check(6, [0.3, 0.18, 0.875, 0.9, 0.25]);
        check(7, [0.992893, 0.487904, 0.5, 0.661165, 0.511683]);
        check(8, [0.76906, 0.666667, 0.855662, 0.324527, 0.880842]);
        check(9, [0.99282, 0.666667, 0.666667, 0.816501, 0.666667]);
        check(10, [0.6, 0.36, 0.75, 0.2, 0.5]);
        check(11, [0.866667, 0.453333, 0.916667, 0.933333, 0.4]);
        check(12, [0.8, 0.453333, 0.916667, 0.4, 0.4]);
        check(13, [0.717157, 0.64111, 0.882149, 0.510178, 0.590072]);
        check(14, [0.230294, 0.584666, 0.329289, 0.706107, 0.554043]);
        check(15, [0.5, 0.5, 0.375, 0.5, 0.25]);
        check(16, [0.205428, 0.785196, 0.0, 0.710591, 0.187072]);
        check(17, [0.436047, 0.892598, 0.166667, 0.855296, 0.426869]);
        check(18, [0.3, 0.18, 0.875, 0.9, 0.75]);
        check(19, [0.659487, 0.785196, 0.502992, 0.816501, 0.514899]);
        check(20, [0.666667, 0.666667, 0.502992, 0.483168, 0.514899]);
        check(21, [0.614594, 0.614953, 0.797249, 0.833333, 0.989991]);
        check(22, [0.666667, 0.666667, 0.333333, 0.666667, 0.666667]);
        check(23, [0.666667, 0.442295, 0.333333, 0.421195, 0.449583]);
        check(24, [0.8, 0.665377, 0.2, 0.652717, 0.26975]);
    }

    #[test]
    fn tiles_leave_no_gaps() {
        for n in 1..=24 {
            let tiling = Tiling::new(n).expect("a known tiling");
            for (i, j) in (-99..99).flat_map(|i| (-99..99).map(move |j| (i, j))) {
                let found = tiling.value(DVec3::new(0.083 * f64::from(i), 0.0, 0.091 * f64::from(j)));
                // Values are higher outside of tiles; POV-Ray adds this much, at most.
                assert!((0.0..1.0 + POV_EDGE).contains(&found), "tiling {n} at {i}, {j}: {found}");
            }
        }
    }

    #[test]
    fn penrose_tilings_match_the_binary() {
        check(25, [0.333334, 0.333334, 0.067174, 0.166668, 0.239076]);
        check(26, [0.309327, 0.0, 0.0, 0.238695, 0.412444]);
        check(27, [0.663681, 0.955816, 0.438899, 0.124366, 0.432663]);
    }
}
