//! POV-Ray's three noise generators, its vector noise, and turbulence, to the last bit.
//!
//! Generators 1 and 2 are one lattice noise with constants of six digits (`NOISE_TABLE`, `lattice`),
//! scaled differently; generator 3 is Perlin's gradient noise. Vector noise is the lattice
//! noise read at three offsets of the table, whatever the generator.
//!
//! Source: sections 5.2 to 5.5 of the function facts, measured on POV-Ray 3.7.0.10.

use super::lattice::{self, Scaling};
use super::{DVec3, LANES, Points, each_lane, floor, lattice_points};
use std::sync::LazyLock;
use wide::f64x2;

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

/// Indices that the permutation takes.
const INDICES: usize = 1 << u16::BITS;

/// A permutation of 0..4096, shared by the noise, cells and crackle. It is repeated, so that an index of 16 bits needs
/// neither a remainder nor a check; only the period that is used comes into a cache.
static PERMUTATION: [u16; INDICES] = {
    let mut table = [0; INDICES];
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
    i = PERIOD;
    while i < INDICES {
        table[i] = table[i - PERIOD];
        i += 1;
    }
    table
};

/// The twelve-bit hash of a lattice point: of its coordinates modulo 4096.
pub fn lattice_hash(x: i64, y: i64, z: i64) -> usize {
    let at = |i: i64| i as usize & (PERIOD - 1);
    permuted(permuted(permuted(at(x)) ^ at(y)) ^ at(z))
}

/// Entry `i` of the permutation, for `i` modulo 4096.
#[inline]
pub fn permuted(i: usize) -> usize {
    PERMUTATION[i % INDICES].into()
}

fn smooth(f: f64) -> f64 {
    f * f * (3.0 - 2.0 * f)
}

static ORIGINAL: Scaling = Scaling { shift: 0.5, factor: 1.0 };
/// The two constants make the range of the raw noise fit 0..1.
static CORRECTED: Scaling = Scaling { shift: 1.05242, factor: 0.48985582 };

/// How the lattice noise is scaled; the third generator is not made of it.
#[inline(always)]
fn scaling(generator: NoiseGenerator) -> Option<&'static Scaling> {
    match generator {
        NoiseGenerator::Original => Some(&ORIGINAL),
        NoiseGenerator::Corrected => Some(&CORRECTED),
        NoiseGenerator::Perlin => None,
    }
}

/// Noise at a point, in 0..=1.
#[inline]
pub fn noise(generator: NoiseGenerator, p: DVec3) -> f64 {
    match scaling(generator) {
        Some(scaling) => lattice::noise(scaling, p),
        None => perlin(p),
    }
}

/// The noise at each of four points.
pub fn noise_of_points(generator: NoiseGenerator, points: &Points) -> [f64; LANES] {
    match scaling(generator) {
        Some(scaling) => lattice_points::noises(scaling, points),
        None => points.map(perlin),
    }
}

/// Three unclamped noises at a point, about -1 to 1: displacements.
pub fn vector_noise(p: DVec3) -> DVec3 {
    lattice::vector_noise(p)
}

/// Gradients of the third generator and its permutation.
struct Gradients {
    gradients: Box<[[f64; 3]; PERLIN_PERIOD]>,
    permutation: Box<[u16; PERLIN_PERIOD]>,
}

/// Size of the third generator's tables.
const PERLIN_PERIOD: usize = 2048;
/// Added to coordinates, as in POV-Ray; positions keep about 2e-9 of precision.
const PERLIN_OFFSET: f64 = 10_000_000.023_157_213;

static GRADIENTS: LazyLock<Gradients> = LazyLock::new(|| {
    let mut random = Congruential(1);
    let mut component = || (f64::from(random.draw() % 4096) - 2048.0) / 2048.0;
    let gradients = Box::new(std::array::from_fn(|_| {
        loop {
            let v = [component(), component(), component()];
            let squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if (1e-5..=1.0).contains(&squared) {
                // Rejection keeps directions even; the lower limit is POV-Ray's.
                let scale = 1.0 / squared.sqrt();
                return v.map(|c| c * scale);
            }
        }
    }));
    let mut permutation: Vec<u16> = (0..PERLIN_PERIOD as u16).chain([0]).collect();
    for i in (2..=PERLIN_PERIOD).rev().step_by(2) {
        permutation.swap(i, random.draw() as usize % PERLIN_PERIOD);
    }
    let permutation = Box::new(std::array::from_fn(|i| permutation[i]));
    Gradients { gradients, permutation }
});

fn perlin(p: DVec3) -> f64 {
    let tables = &*GRADIENTS;
    let t = (p + DVec3::splat(PERLIN_OFFSET)).to_array();
    let n = t.map(|t| if t.abs() < -lattice::LOWEST_CELL { floor(t) } else { lattice::LOWEST_CELL });
    let [x, y, z]: [[f64; 2]; 3] = std::array::from_fn(|i| [t[i] - n[i], t[i] - n[i] - 1.0]);
    let sides = n.map(|n| [n as i64 as usize, n as i64 as usize + 1]);
    let hash = |i: usize| usize::from(tables.permutation[i % PERLIN_PERIOD]);
    let first = sides[0].map(&hash);
    let [wx, wy, wz] = [x, y, z].map(|side| smooth(side[0]));
    let lerp = |w: f64, a: f64, b: f64| a + w * (b - a);
    let along_x: [f64; 4] = std::array::from_fn(|k| {
        let corners = first.map(|x| {
            let h = hash(x + sides[1][k & 1] % PERLIN_PERIOD) + sides[2][k >> 1];
            &tables.gradients[h % PERLIN_PERIOD]
        });
        let column = |i: usize| f64x2::from([corners[0][i], corners[1][i]]);
        let slopes = column(0) * f64x2::from(x) + column(1) * y[k & 1] + column(2) * z[k >> 1];
        let [lower, upper] = slopes.to_array();
        lerp(wx, lower, upper)
    });
    let d = lerp(wz, lerp(wy, along_x[0], along_x[1]), lerp(wy, along_x[2], along_x[3]));
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

impl Octaves {
    fn count(self) -> usize {
        self.count.clamp(1, MAX_OCTAVES as u32) as usize
    }
}

/// Sum of vector noises of rising frequency.
#[inline(always)]
pub fn vector_turbulence(octaves: Octaves, p: DVec3) -> DVec3 {
    lattice::vector_sum::<false>(p, f64::from(octaves.lambda), octaves.count(), f64::from(octaves.omega))
}

/// [`vector_turbulence`] at each of four points.
pub fn vector_turbulence_of_points(octaves: Octaves, points: &Points) -> Points {
    lattice_points::vector_sums(points, f64::from(octaves.lambda), octaves.count(), f64::from(octaves.omega))
}

/// Sum of the absolute values of `count` vector noises, each with twice the frequency and half the weight of the one
/// before.
pub fn halving_vector_noises(p: DVec3, count: usize) -> DVec3 {
    lattice::vector_sum::<true>(p, 2.0, count, 0.5)
}

/// Sum of noises of rising frequency.
#[inline(always)]
pub fn turbulence(generator: NoiseGenerator, octaves: Octaves, p: DVec3) -> f64 {
    turbulence_at(generator, octaves, p.x, p.y, p.z)
}

/// Takes the point in registers: it would be written number by number and read in pairs, for which the processor waits.
#[inline(never)]
fn turbulence_at(generator: NoiseGenerator, octaves: Octaves, x: f64, y: f64, z: f64) -> f64 {
    let mut room = [0.0; MAX_OCTAVES];
    let noises = &mut room[..octaves.count()];
    fill(generator, DVec3::new(x, y, z), f64::from(octaves.lambda), noises);
    sum(generator, octaves, noises.iter().copied())
}

/// [`turbulence`] at each of four points.
pub fn turbulence_of_points(generator: NoiseGenerator, octaves: Octaves, points: &Points) -> [f64; LANES] {
    let mut room = [[0.0; LANES]; MAX_OCTAVES];
    let noises = &mut room[..octaves.count()];
    fill_points(generator, points, f64::from(octaves.lambda), noises);
    each_lane(|i| sum(generator, octaves, noises.iter().map(|lanes| lanes[i])))
}

/// The sum of octaves.
#[inline(always)]
fn sum(generator: NoiseGenerator, octaves: Octaves, noises: impl Iterator<Item = f64>) -> f64 {
    let octave = |noise: f64| match generator {
        NoiseGenerator::Original => noise,
        _ => 2.0 * noise - 0.5,
    };
    let omega = f64::from(octaves.omega);
    let mut noises = noises.map(octave);
    let first = noises.next().unwrap_or_default().clamp(0.0, 1.0);
    let mut weight = omega;
    noises.fold(first, |sum, octave| {
        let weighted = weight * octave;
        weight *= omega;
        sum + weighted
    })
}

/// The most noises that are summed up at a point.
pub(super) const MAX_OCTAVES: usize = 10;

/// Noises at `p`, at `p` times `factor` and so on.
pub fn noises<const COUNT: usize>(generator: NoiseGenerator, p: DVec3, factor: f64) -> [f64; COUNT] {
    let mut noises = [0.0; COUNT];
    fill(generator, p, factor, &mut noises);
    noises
}

/// [`noises`] at each of four points.
pub fn noises_of_points<const COUNT: usize>(
    generator: NoiseGenerator,
    points: &Points,
    factor: f64,
) -> [[f64; LANES]; COUNT] {
    let mut noises = [[0.0; LANES]; COUNT];
    fill_points(generator, points, factor, &mut noises);
    noises
}

#[inline(always)]
fn fill(generator: NoiseGenerator, p: DVec3, factor: f64, noises: &mut [f64]) {
    match scaling(generator) {
        Some(scaling) => lattice_points::noises_of_one(scaling, p, factor, noises),
        None => {
            noises.iter_mut().zip(frequencies(factor)).for_each(|(noise, frequency)| *noise = perlin(p * frequency));
        }
    }
}

#[inline(always)]
fn fill_points(generator: NoiseGenerator, points: &Points, factor: f64, noises: &mut [[f64; LANES]]) {
    match scaling(generator) {
        Some(scaling) => lattice_points::series_noises(scaling, points, factor, noises),
        None => {
            let series = noises.iter_mut().zip(frequencies(factor));
            series.for_each(|(noises, frequency)| *noises = points.map(|p| perlin(p * frequency)));
        }
    }
}

/// 1, `factor`, and so on; products round one after the other.
fn frequencies(factor: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(1.0), move |f| Some(f * factor))
}

#[cfg(test)]
mod tests {
    use super::NoiseGenerator::*;
    use super::*;

    const GENERATORS: [NoiseGenerator; 3] = [Original, Corrected, Perlin];

    /// Probes of section 5 of the function facts: the binary's own digits.
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
        // Around the last cell, from where on fractions grow.
        check([2_147_483_647.5, 0.3, 0.2], [0.1743147895647999, 0.3559952662647925, 1.0]);
        check([2_147_483_648.0, 0.3, 0.2], [1.0; 3]);
        check([-2_147_483_648.5, 0.3, 0.2], [0.0, 0.0804132181392583, 0.5230934864638922]);
        check([-2_147_483_649.0, 0.3, 0.2], [0.058625114915841, 0.2993240058240935, 0.5777458706592935]);
        check([0.1, -2_147_483_649.3, 0.2], [0.0, 0.0, 0.4525723176907134]);
        check([0.1, 2_137_483_648.6, 0.2], [0.3081570315171266, 0.4215586674469878, 0.0]);
        check([-2_157_483_648.5, 0.3, 0.2], [1.0, 1.0, 0.0]);
        check([3e9 + 0.37, 0.3, 0.2], [1.0; 3]);
        check([0.3, 3e9 + 0.37, 0.2], [0.0; 3]);
    }

    /// The checks of sections 5.2 and 5.4 of the function facts.
    #[test]
    fn tables_match_the_facts() {
        assert_eq!([0, 1, 2, 3, 4, 5, 4095].map(permuted), [2291, 2574, 3654, 1557, 1196, 3388, 3088]);
        let g = &*GRADIENTS;
        assert_eq!(g.permutation[..6], [0, 1, 386, 3, 649, 1576]);
        assert!((g.gradients[0][0] - 0.60442506942642).abs() < 1e-14);
        assert!((g.gradients[2047][1] - 0.65198806126422).abs() < 1e-14);
    }

    #[test]
    fn four_points_have_the_bits_of_each() {
        let octaves = Octaves { count: 7, lambda: 2.1, omega: 0.55 };
        for step in [0.0, 0.003, 0.4, -70.0, 1.5e9] {
            let points = Points::from(each_lane(|i| DVec3::new(-0.3, 1.7, 0.2) + i as f64 * step * DVec3::NEG_X));
            for generator in GENERATORS {
                assert_eq!(noise_of_points(generator, &points), points.map(|p| noise(generator, p)));
                let expected = points.map(|p| turbulence(generator, octaves, p));
                assert_eq!(turbulence_of_points(generator, octaves, &points), expected, "{generator:?}, {step}");
                let expected = points.map(|p| noises::<10>(generator, p, 2.0));
                let found = noises_of_points::<10>(generator, &points, 2.0);
                assert_eq!(each_lane(|i| found.map(|lanes| lanes[i])), expected, "{generator:?}, {step}");
            }
        }
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
        // Beyond the last cell nothing is clamped: the corners' values times a fraction to the seventh.
        let far = vector_turbulence(one, DVec3::new(3e9 + 0.37, 0.3, 0.2));
        let expected = DVec3::new(
            533_663_574_204_326_203_301_070_603_246_179_975_168.0,
            -1_492_197_118_801_518_400_360_405_294_140_388_016_128.0,
            982_009_019_775_041_687_136_469_655_295_556_059_136.0,
        );
        assert!((far - expected).abs().max_element() < 1e25, "{far} for {expected}");
        let expected = [1.829739707481727, 1.8779891184926383, 2.106165574255146];
        for (generator, expected) in GENERATORS.into_iter().zip(expected) {
            let value = 1.2 + turbulence(generator, four, DVec3::new(1.2, 3.4, 5.6));
            assert!((value - expected).abs() < 1e-15, "{generator:?}: {value} for {expected}");
        }
    }
}
