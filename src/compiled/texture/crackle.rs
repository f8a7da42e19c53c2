//! Cells, crackle and facets: patterns of points scattered one to a unit cube.
//!
//! Source: section 6 of the pattern facts (measured).

use crate::math::noise::{NoiseGenerator, lattice_hash, noise};
use crate::math::{DVec3, MersenneTwister};
use std::sync::LazyLock;

/// POV-Ray's offset at the borders of cells.
const CELL_OFFSET: f64 = 1e-10;

/// Random numbers by hash; a cube's point takes three from its hash on.
static RANDOM: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let mut random = MersenneTwister::default();
    (0..4096 + 3).map(|_| random.next_f64()).collect()
});

/// Entry `i` of the random table, for offsets of black holes.
pub(super) fn random_number(i: usize) -> f64 {
    RANDOM[i % RANDOM.len()]
}

/// One random number for each unit cube.
pub(super) fn cells(p: DVec3) -> f64 {
    let c = (p + CELL_OFFSET).floor();
    RANDOM[lattice_hash(c.x as i64, c.y as i64, c.z as i64)]
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
        let near = nearest(p, Metric::Power(self.metric));
        if let Some(generator) = self.solid {
            return noise(generator, near.point).clamp(0.0, 1.0);
        }
        let shift = if self.offset == 0.0 { 0.0 } else { self.offset.powf(self.metric) };
        let distance = |power: f64| match self.metric {
            2.0 => (power + shift).sqrt(),
            1.0 => power + shift,
            m => (power + shift).powf(1.0 / m),
        };
        let term = |weight: f64, power: f64| if weight == 0.0 { 0.0 } else { weight * distance(power) };
        let [first, second, third] = near.powers;
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

impl Metric {
    fn power(self, d: DVec3) -> f64 {
        match self {
            Self::Power(2.0) => d.length_squared(),
            Self::Power(1.0) => d.x.abs() + d.y.abs() + d.z.abs(),
            Self::Power(m) => d.x.abs().powf(m) + d.y.abs().powf(m) + d.z.abs().powf(m),
            Self::SignedSum => d.x + d.y + d.z,
        }
    }
}

/// The nearest point, and the powers of the three smallest distances.
pub(super) struct Nearest {
    pub(super) point: DVec3,
    powers: [f64; 3],
}

/// Offsets of the cubes that are looked at, near ones first.
static NEIGHBOURS: LazyLock<Vec<[i8; 3]>> = LazyLock::new(|| {
    let side = -2_i8..=2;
    let mut all: Vec<[i8; 3]> = side
        .clone()
        .flat_map(|x| side.clone().flat_map(move |y| (-2_i8..=2).map(move |z| [x, y, z])))
        .filter(|o| o.iter().filter(|c| c.abs() == 2).count() <= 1)
        .collect();
    all.sort_by_key(|o| o.iter().map(|c| i32::from(*c).pow(2)).sum::<i32>());
    all
});

/// Searches the cube of `p` and its neighbours; cubes that are too far away are not opened.
pub(super) fn nearest(p: DVec3, metric: Metric) -> Nearest {
    let corner = (p - CELL_OFFSET).floor();
    let inside = p - corner;
    let (x, y, z) = (corner.x as i64, corner.y as i64, corner.z as i64);
    let mut near = Nearest { point: corner, powers: [f64::INFINITY; 3] };
    let apart = |offset: f64, inside: f64| (offset - inside).max(inside - offset - 1.0).max(0.0);
    for offset in NEIGHBOURS.iter() {
        let [i, j, k] = offset.map(f64::from);
        if let Metric::Power(_) = metric {
            let least = DVec3::new(apart(i, inside.x), apart(j, inside.y), apart(k, inside.z));
            if metric.power(least) > near.powers[2] {
                continue;
            }
        }
        let s = lattice_hash(x + i64::from(offset[0]), y + i64::from(offset[1]), z + i64::from(offset[2]));
        let point = corner + DVec3::new(i, j, k) + DVec3::new(RANDOM[s], RANDOM[s + 1], RANDOM[s + 2]);
        let power = metric.power(point - p);
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
