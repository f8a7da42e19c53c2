//! Cells, crackle and facets: patterns of points scattered one to a unit cube.
//!
//! Source: section 6 of the pattern facts (measured).

use crate::math::noise::{NoiseGenerator, lattice_hash, noise, permuted};
use crate::math::{DVec3, MersenneTwister, floor};
use std::sync::LazyLock;
use touching::Share;

mod touching;

/// POV-Ray's offset at the borders of cells.
const CELL_OFFSET: f64 = 1e-10;

/// Random numbers by hash; a cube's point takes three from its hash on.
static RANDOM: LazyLock<Box<[f64; 4096 + 3]>> = LazyLock::new(|| {
    let mut random = MersenneTwister::default();
    Box::new(std::array::from_fn(|_| random.next_f64()))
});

/// Entry `i` of the random table, for offsets of black holes.
pub(super) fn random_number(i: usize) -> f64 {
    RANDOM[i % RANDOM.len()]
}

/// One random number for each unit cube.
pub(super) fn cells(p: DVec3) -> f64 {
    let [x, y, z] = (p + CELL_OFFSET).to_array().map(|c| floor(c) as i64);
    RANDOM[lattice_hash(x, y, z)]
}

/// The crackle pattern: a combination of the distances to the three nearest points.
#[derive(Clone, Debug)]
pub struct Crackle {
    /// Weights of the distances.
    pub form: DVec3,
    /// Exponent of the metric.
    pub metric: f64,
    /// Added to the sum of powers.
    pub offset: f64,
    /// The noise at the nearest point instead.
    pub solid: Option<NoiseGenerator>,
}

impl Crackle {
    /// The value, 0 to 1.
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let metric = Metric::Power(self.metric);
        if let Some(generator) = self.solid {
            return noise(generator, nearest(p, metric)).clamp(0.0, 1.0);
        }
        let shift = if self.offset == 0.0 { 0.0 } else { self.offset.powf(self.metric) };
        let distance = |power: f64| match self.metric {
            2.0 => (power + shift).sqrt(),
            1.0 => power + shift,
            m => (power + shift).powf(1.0 / m),
        };
        let term = |weight: f64, power: f64| if weight == 0.0 { 0.0 } else { weight * distance(power) };
        let distances = self.form.to_array().iter().rposition(|weight| *weight != 0.0).map_or(1, |last| last + 1);
        let [first, second, third] = search(p, metric, Wanted { distances, point: false }).powers;
        (term(self.form.x, first) + term(self.form.y, second) + term(self.form.z, third)).clamp(0.0, 1.0)
    }
}

/// How far apart two points are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Metric {
    /// Sum of absolute values to a power.
    Power(f64),
    /// The signed sum of coordinates, as facets of metric 1 have it in POV-Ray.
    SignedSum,
}

/// The nearest point, and the powers of the smallest distances.
pub(super) struct Nearest {
    /// Of no meaning where only distances were asked for.
    pub(super) point: DVec3,
    /// Of three points; only as many as were asked for are sure to be the smallest.
    powers: [f64; 3],
}

/// Offsets plus 2 of the cubes that are looked at, near ones first: all [`TOUCHING`] the point's come before those
/// that are a cube further along one axis.
static NEIGHBOURS: LazyLock<Vec<[u8; 3]>> = LazyLock::new(|| {
    let mut all: Vec<[u8; 3]> = (0..125).map(|i| [i / 25, i / 5 % 5, i % 5]).collect();
    all.retain(|cube| cube.iter().filter(|c| c.abs_diff(2) == 2).count() <= 1);
    all.sort_by_key(|cube| cube.iter().map(|c| u32::from(c.abs_diff(2)).pow(2)).sum::<u32>());
    all
});

/// How many cubes touch that of the point, itself included.
const TOUCHING: usize = 27;

/// The point nearest to `p`.
pub(super) fn nearest(p: DVec3, metric: Metric) -> DVec3 {
    search(p, metric, Wanted { distances: 1, point: true }).point
}

/// What is asked about the nearest points.
#[derive(Clone, Copy)]
struct Wanted {
    /// Of how many points, 1 to 3.
    distances: usize,
    /// Where the nearest is.
    point: bool,
}

/// Finds the nearest points.
fn search(p: DVec3, metric: Metric, wanted: Wanted) -> Nearest {
    let corner = DVec3::from((p - CELL_OFFSET).to_array().map(floor));
    let none = Nearest { point: corner, powers: [f64::INFINITY; 3] };
    let search = Search { p, corner, wanted: wanted.distances };
    match metric {
        Metric::Power(2.0) => search.beyond(|d| d * d, touching::nearest(p, corner, Share::Square, wanted.point)),
        Metric::Power(1.0) => search.beyond(f64::abs, touching::nearest(p, corner, Share::Absolute, wanted.point)),
        Metric::Power(m) => {
            let share = |d: f64| d.abs().powf(m);
            search.beyond(share, search.among(&NEIGHBOURS[..TOUCHING], share, true, none))
        }
        Metric::SignedSum => search.among(&NEIGHBOURS, |d| d, false, none),
    }
}

/// A search in the cubes around a point.
struct Search {
    p: DVec3,
    /// Of the cube that holds the point.
    corner: DVec3,
    wanted: usize,
}

impl Search {
    /// How far a slab of cubes is away from a coordinate inside the middle one, at least.
    fn slab(offset: f64, inside: f64) -> f64 {
        (offset - inside).max(inside - offset - 1.0).max(0.0)
    }

    /// Goes on to the cubes that do not touch that of the point, where they may be near enough.
    #[inline]
    fn beyond(&self, share: impl Fn(f64) -> f64, near: Nearest) -> Nearest {
        // These cubes begin a whole cube away along some axis.
        let inside = self.p - self.corner;
        let away = (inside + 1.0).min(2.0 - inside).min_element();
        if share(away) > near.powers[self.wanted - 1] {
            return near;
        }
        self.among(&NEIGHBOURS[TOUCHING..], share, true, near)
    }

    /// Searches some cubes. A coordinate's difference adds its `share` to the power of a distance; where shares
    /// `grow` with the difference, cubes that are too far away are not opened.
    fn among(&self, offsets: &[[u8; 3]], share: impl Fn(f64) -> f64, grow: bool, mut near: Nearest) -> Nearest {
        const OFFSETS: [f64; 5] = [-2.0, -1.0, 0.0, 1.0, 2.0];
        let corner = self.corner.to_array();
        // By axis: corners of the five slabs of cubes, their lattice coordinates, and what they are away, at least.
        let corners = corner.map(|c| OFFSETS.map(|offset| c + offset));
        let lattice = corner.map(|c| [-2, -1, 0, 1, 2].map(|offset| (c as i64 + offset) as usize));
        let hashes = lattice[0].map(permuted);
        let least = (self.p - self.corner).to_array().map(|inside| {
            OFFSETS.map(|offset| if grow { share(Self::slab(offset, inside)) } else { f64::NEG_INFINITY })
        });
        let random = &*RANDOM;
        for offset in offsets {
            let [i, j, k] = offset.map(|o| usize::from(o) % 5);
            if least[0][i] + least[1][j] + least[2][k] > near.powers[self.wanted - 1] {
                continue;
            }
            let hash = permuted(permuted(hashes[i] ^ lattice[1][j]) ^ lattice[2][k]) % 4096;
            let cube = DVec3::new(corners[0][i], corners[1][j], corners[2][k]);
            let point = cube + DVec3::new(random[hash], random[hash + 1], random[hash + 2]);
            let d = point - self.p;
            let power = share(d.x) + share(d.y) + share(d.z);
            let [first, second, third] = near.powers;
            if power < first {
                near = Nearest { point, powers: [power, first, second] };
            } else if power < second {
                near.powers = [first, power, second];
            } else if power < third {
                near.powers[2] = power;
            }
        }
        near
    }
}
