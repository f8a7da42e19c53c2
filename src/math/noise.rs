//! POV-Ray's three noise generators, its vector noise, and turbulence, to the last bit.
//!
//! Generators 1 and 2 are one lattice noise with constants of six digits (`NOISE_TABLE`),
//! scaled differently; generator 3 is Perlin's gradient noise. Vector noise is the lattice
//! noise read at three offsets of the table, whatever the generator.
//!
//! Source: sections 5.2 to 5.5 of the function facts, measured on POV-Ray 3.7.0.10.

use super::DVec3;
use super::noise_table::NOISE_TABLE;
use std::sync::LazyLock;

/// Which of the three noises.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NoiseGenerator {
    /// Before version 3.5: values crowd at 0 and 1.
    Original,
    /// The default: the same lattice, scaled to stay inside.
    Corrected,
    /// Perlin's gradient noise.
    Perlin,
}

/// The linear congruential generator behind all of POV-Ray's tables.
///
/// Fifteen bits a draw, as from the C library it was written for.
#[derive(Clone, Copy, Debug)]
pub struct Congruential(pub u32);

impl Congruential {
    /// The next draw, in 0..32768.
    pub const fn draw(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_812_433_253).wrapping_add(12_345);
        (self.0 >> 16) & 0x7fff
    }
}

/// Size of the lattice's permutation; noise repeats after as many units.
const PERIOD: usize = 4096;

/// A permutation of 0..4096, shared by the noise, cells and crackle.
static PERMUTATION: [u16; PERIOD] = {
    let mut table = [0; PERIOD];
    let mut i = 0;
    while i < PERIOD {
        table[i] = i as u16;
        i += 1;
    }
    let mut random = Congruential(0);
    while i > 0 {
        i -= 1;
        table.swap(i, random.draw() as usize % PERIOD);
    }
    table
};

/// The noise table as it is read: twelve numbers from each of 256 places on, so that a corner's
/// lie together and an eight-bit number needs no check.
static CORNERS: [[f64; 12]; 256] = {
    let mut rows = [[0.0; 12]; 256];
    let mut i = 0;
    while i < 256 * 12 {
        rows[i / 12][i % 12] = NOISE_TABLE[i / 12 + i % 12];
        i += 1;
    }
    rows
};

/// The twelve-bit hash of a lattice point: of its coordinates modulo 4096.
pub fn lattice_hash(x: i64, y: i64, z: i64) -> usize {
    let at = |i: i64| i as usize & (PERIOD - 1);
    permuted(permuted(permuted(at(x)) ^ at(y)) ^ at(z))
}

/// Entry `i` of the permutation, for `i` modulo 4096.
pub fn permuted(i: usize) -> usize {
    PERMUTATION[i & (PERIOD - 1)].into()
}

/// A lattice cell: hashes of its corners and the point inside it.
struct Cell {
    /// Numbers of corner (a, b, c) at position a + 2b + 4c.
    corners: [&'static [f64; 12]; 8],
    /// Distances from the lower and the upper side of the cell, by axis.
    distances: [[f64; 2]; 3],
    /// Corner weights, in the order of `corners`.
    weights: [f64; 8],
}

/// Just below one: coordinates above -1e-10 belong to cell 0, as in POV-Ray.
const POV_ALMOST_ONE: f64 = 1.0 - 1e-10;
/// Moves cells of ordinary coordinates into positive numbers, as in POV-Ray.
const POV_OFFSET: i64 = 10_000;

fn cell_index(c: f64) -> i64 {
    // Saturating: coordinates beyond 2^31 have no defined noise in POV-Ray.
    (if c >= 0.0 { c as i32 } else { (c - POV_ALMOST_ONE) as i32 }).into()
}

fn smooth(f: f64) -> f64 {
    f * f * (3.0 - 2.0 * f)
}

impl Cell {
    fn around(p: DVec3) -> Self {
        let n = [cell_index(p.x), cell_index(p.y), cell_index(p.z)];
        let fraction = [p.x - n[0] as f64, p.y - n[1] as f64, p.z - n[2] as f64];
        let at = |i: i64| (i + POV_OFFSET) as usize & (PERIOD - 1);
        let (x, y, z) = ([at(n[0]), at(n[0] + 1)], [at(n[1]), at(n[1] + 1)], [at(n[2]), at(n[2] + 1)]);
        let first = x.map(permuted);
        let second: [usize; 4] = std::array::from_fn(|i| permuted(first[i & 1] ^ y[i >> 1]));
        let corners = std::array::from_fn(|i| &CORNERS[permuted(second[i & 3] ^ z[i >> 2]) & 255]);
        let [sx, sy, sz] = fraction.map(|f| [1.0 - smooth(f), smooth(f)]);
        let flat: [f64; 4] = std::array::from_fn(|i| sx[i & 1] * sy[i >> 1]);
        let weights = std::array::from_fn(|i| flat[i & 3] * sz[i >> 2]);
        Self { corners, distances: fraction.map(|f| [f, f - 1.0]), weights }
    }

    /// The noise read at one of three offsets of the table, unscaled.
    #[inline]
    fn value<const OFFSET: usize>(&self) -> f64 {
        let [x, y, z] = &self.distances;
        let terms: [f64; 8] = std::array::from_fn(|i| {
            let t = self.corners[i];
            let slope = 0.5 * t[OFFSET] + t[OFFSET + 1] * x[i & 1] + t[OFFSET + 2] * y[(i >> 1) & 1];
            self.weights[i] * (slope + t[OFFSET + 3] * z[i >> 2])
        });
        // In this order, for POV-Ray's last bit.
        terms.iter().fold(0.0, |sum, term| sum + term)
    }
}

/// Noise at a point, in 0..=1.
pub fn noise(generator: NoiseGenerator, p: DVec3) -> f64 {
    match generator {
        NoiseGenerator::Original => (Cell::around(p).value::<0>() + 0.5).clamp(0.0, 1.0),
        // The two constants make the range of the raw noise fit 0..1.
        NoiseGenerator::Corrected => ((Cell::around(p).value::<0>() + 1.05242) * 0.48985582).clamp(0.0, 1.0),
        NoiseGenerator::Perlin => perlin(p),
    }
}

/// Three unclamped noises at a point, about -1 to 1: displacements.
pub fn vector_noise(p: DVec3) -> DVec3 {
    let cell = Cell::around(p);
    DVec3::new(cell.value::<0>(), cell.value::<4>(), cell.value::<8>())
}

/// Gradients of the third generator and its permutation.
struct Gradients {
    gradients: Vec<[f64; 3]>,
    permutation: Vec<u16>,
}

/// Size of the third generator's tables.
const PERLIN_PERIOD: usize = 2048;
/// Added to coordinates, as in POV-Ray; positions keep about 2e-9 of precision.
const PERLIN_OFFSET: f64 = 10_000_000.023_157_213;

static GRADIENTS: LazyLock<Gradients> = LazyLock::new(|| {
    let mut random = Congruential(1);
    let mut component = || (f64::from(random.draw() % 4096) - 2048.0) / 2048.0;
    let gradients = (0..PERLIN_PERIOD)
        .map(|_| {
            loop {
                let v = [component(), component(), component()];
                let squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
                if (1e-5..=1.0).contains(&squared) {
                    // Rejection keeps directions even; the lower limit is POV-Ray's.
                    let scale = 1.0 / squared.sqrt();
                    return v.map(|c| c * scale);
                }
            }
        })
        .collect();
    let mut permutation: Vec<u16> = (0..PERLIN_PERIOD as u16).chain([0]).collect();
    for i in (2..=PERLIN_PERIOD).rev().step_by(2) {
        permutation.swap(i, random.draw() as usize % PERLIN_PERIOD);
    }
    permutation.truncate(PERLIN_PERIOD);
    Gradients { gradients, permutation }
});

fn perlin(p: DVec3) -> f64 {
    let tables = &*GRADIENTS;
    let t = p + DVec3::splat(PERLIN_OFFSET);
    let n = t.floor();
    let f = t - n;
    let at = |v: f64, upper: usize| ((v as i64 & (PERLIN_PERIOD as i64 - 1)) as usize + upper) & (PERLIN_PERIOD - 1);
    let hash = |i: usize| tables.permutation[i & (PERLIN_PERIOD - 1)] as usize;
    let corner = |a: usize, b: usize, c: usize| {
        let g = tables.gradients[(hash(hash(at(n.x, a)) + at(n.y, b)) + at(n.z, c)) & (PERLIN_PERIOD - 1)];
        (f.x - a as f64) * g[0] + (f.y - b as f64) * g[1] + (f.z - c as f64) * g[2]
    };
    let lerp = |w: f64, a: f64, b: f64| a + w * (b - a);
    let (wx, wy, wz) = (smooth(f.x), smooth(f.y), smooth(f.z));
    let along_x = |b: usize, c: usize| lerp(wx, corner(0, b, c), corner(1, b, c));
    let along_y = |c: usize| lerp(wy, along_x(0, c), along_x(1, c));
    let d = lerp(wz, along_y(0), along_y(1));
    (0.5 * (1.59 * d + 0.985)).clamp(0.0, 1.0)
}

/// Octaves of noise: how many, and the factors from one to the next.
///
/// The factors are single precision, as POV-Ray stores them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Octaves {
    /// How many, 1 to 10.
    pub count: u32,
    /// Frequency factor.
    pub lambda: f32,
    /// Weight factor.
    pub omega: f32,
}

/// Sum of vector noises of rising frequency.
pub fn vector_turbulence(octaves: Octaves, p: DVec3) -> DVec3 {
    let mut sum = vector_noise(p);
    for (frequency, weight) in factors(octaves) {
        sum += weight * vector_noise(p * frequency);
    }
    sum
}

/// Sum of noises of rising frequency.
pub fn turbulence(generator: NoiseGenerator, octaves: Octaves, p: DVec3) -> f64 {
    let octave = |p: DVec3| match generator {
        NoiseGenerator::Original => noise(generator, p),
        _ => 2.0 * noise(generator, p) - 0.5,
    };
    let first = octave(p);
    let mut sum = if generator == NoiseGenerator::Original { first } else { first.clamp(0.0, 1.0) };
    for (frequency, weight) in factors(octaves) {
        sum += weight * octave(p * frequency);
    }
    sum
}

/// Frequency and weight from the second octave on, by repeated multiplication.
fn factors(octaves: Octaves) -> impl Iterator<Item = (f64, f64)> {
    let (lambda, omega) = (f64::from(octaves.lambda), f64::from(octaves.omega));
    std::iter::successors(Some((lambda, omega)), move |(l, o)| Some((l * lambda, o * omega)))
        .take(octaves.count.clamp(1, 10) as usize - 1)
}

#[cfg(test)]
mod tests {
    use super::NoiseGenerator::*;
    use super::*;

    const GENERATORS: [NoiseGenerator; 3] = [Original, Corrected, Perlin];

    /// Probes of section 5: the binary's own digits.
    fn check(p: [f64; 3], expected: [f64; 3]) {
        for (generator, expected) in GENERATORS.into_iter().zip(expected) {
            let value = noise(generator, DVec3::from(p));
            assert!((value - expected).abs() <= 4e-16, "{generator:?} at {p:?}: {value} for {expected}");
        }
    }

    #[test]
    fn generators_match_the_binary() {
        check([0.1, 0.2, 0.3], [0.2992429090099138, 0.4171920326566367, 0.6522608537200985]);
        check([-1.5, 20.25, -300.75], [0.1429327293701172, 0.3406225814348368, 0.5560833000176794]);
        check([0.0, 0.0, 0.0], [0.0565805, 0.2983224393079099, 0.5113543053730359]);
    }

    #[test]
    fn tables_match_the_facts() {
        assert_eq!([0, 1, 2, 3, 4, 5, 4095].map(permuted), [2291, 2574, 3654, 1557, 1196, 3388, 3088]);
        let g = &*GRADIENTS;
        assert_eq!(g.permutation[..6], [0, 1, 386, 3, 649, 1576]);
        assert!((g.gradients[0][0] - 0.60442506942642).abs() < 1e-14);
        assert!((g.gradients[2047][1] - 0.65198806126422).abs() < 1e-14);
    }

    #[test]
    fn turbulence_matches_the_binary() {
        let close = |v: DVec3, e: [f64; 3]| {
            assert!((v - DVec3::from(e)).abs().max_element() < 1e-15, "{v} for {e:?}");
        };
        let p = DVec3::new(0.1, 0.2, 0.3);
        let one = Octaves { count: 1, lambda: 2.0, omega: 0.5 };
        close(vector_turbulence(one, p), [-0.20075709099008615, -0.1007243831741798, -0.4612304584962612]);
        let six = Octaves { count: 6, lambda: 2.1, omega: 0.55 };
        close(vector_turbulence(six, p), [-0.12238755877249917, -0.2802788412191853, -0.5072707739414756]);
        let four = Octaves { count: 4, lambda: 2.3, omega: 0.4 };
        let expected = [1.829739707481727, 1.8779891184926383, 2.106165574255146];
        for (generator, expected) in GENERATORS.into_iter().zip(expected) {
            let value = 1.2 + turbulence(generator, four, DVec3::new(1.2, 3.4, 5.6));
            assert!((value - expected).abs() < 1e-15, "{generator:?}: {value} for {expected}");
        }
    }
}
