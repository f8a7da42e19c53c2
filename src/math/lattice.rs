//! The lattice noise at a point, in SIMD lanes: the work behind all noise but Perlin's.
//!
//! A cell of the lattice is found with the point's coordinates in the lanes. Its corners are then summed up four at a
//! time for the noise; for the vector noise its three components are the lanes, and the table is so ordered that a
//! corner is four loads and no shuffle. Sums keep POV-Ray's order and nothing is fused, so that the bits are the
//! same on every processor.
//!
//! Source: section 5.2 of the function facts (measured).

use super::DVec3;
use super::lanes::{Lanes, Work, dispatch};
use super::noise::permuted;
use super::noise_table::NOISE_TABLE;
use bytemuck::cast;
use pulp::{f64x4, u64x4};

/// How the sum over a cell's corners becomes a noise from 0 to 1.
#[derive(Debug)]
pub(super) struct Scaling {
    /// Added to the sum.
    pub(super) shift: f64,
    /// Multiplies it then.
    pub(super) factor: f64,
}

impl Scaling {
    #[inline(always)]
    pub(super) fn noise(&self, sum: f64) -> f64 {
        ((sum + self.shift) * self.factor).clamp(0.0, 1.0)
    }

    /// Four noises.
    #[inline(always)]
    pub(super) fn noises<S: Lanes>(&self, simd: S, sums: f64x4) -> f64x4 {
        let noises = simd.mul_f64s(simd.add_f64s(sums, simd.splat_f64s(self.shift)), simd.splat_f64s(self.factor));
        simd.min_f64s(simd.max_f64s(noises, simd.splat_f64s(0.0)), simd.splat_f64s(1.0))
    }
}

/// The noise at a point.
pub(super) fn noise(scaling: &'static Scaling, point: DVec3) -> f64 {
    scaling.noise(dispatch(Noise(point)))
}

/// The vector noise at a point.
pub(super) fn vector_noise(point: DVec3) -> DVec3 {
    dispatch(VectorNoise(point))
}

/// The sum of `count` vector noises, or of their absolute values, at a point, at `factor` times the point and so on. The
/// first has weight 1, every other `ratio` times that of the one before.
pub(super) fn vector_sum<const ABSOLUTE: bool>(point: DVec3, factor: f64, count: usize, ratio: f64) -> DVec3 {
    dispatch(VectorSum::<ABSOLUTE> { point, factor, count, ratio })
}

struct Noise(DVec3);

impl Work for Noise {
    type Output = f64;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> f64 {
        Cell::around(simd, lanes(self.0)).sum(simd)
    }
}

struct VectorNoise(DVec3);

impl Work for VectorNoise {
    type Output = DVec3;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> DVec3 {
        vector(Cell::around(simd, lanes(self.0)).vector_noise(simd))
    }
}

struct VectorSum<const ABSOLUTE: bool> {
    point: DVec3,
    factor: f64,
    count: usize,
    ratio: f64,
}

impl<const ABSOLUTE: bool> Work for VectorSum<ABSOLUTE> {
    type Output = DVec3;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> DVec3 {
        let point = lanes(self.point);
        let (mut frequency, mut weight) = (self.factor, 1.0);
        let mut sum = simd.splat_f64s(0.0);
        // A cell waits for its table rows while the noise of the one before is summed up: that is worth the one
        // cell too many.
        let mut next = Cell::around(simd, point);
        for _ in 0..self.count {
            let cell =
                std::mem::replace(&mut next, Cell::around(simd, simd.mul_f64s(point, simd.splat_f64s(frequency))));
            let noise = cell.vector_noise(simd);
            let noise = if ABSOLUTE { simd.abs_f64s(noise) } else { noise };
            sum = simd.add_f64s(sum, simd.mul_f64s(simd.splat_f64s(weight), noise));
            frequency *= self.factor;
            weight *= self.ratio;
        }
        vector(sum)
    }
}

#[inline(always)]
fn lanes(v: DVec3) -> f64x4 {
    f64x4(v.x, v.y, v.z, 0.0)
}

#[inline(always)]
fn vector(f64x4(x, y, z, _): f64x4) -> DVec3 {
    DVec3::new(x, y, z)
}

/// Just below one: coordinates above -1e-10 belong to cell 0, as in POV-Ray.
const POV_ALMOST_ONE: f64 = 1.0 - 1e-10;
/// Moves cells of ordinary coordinates into positive numbers, as in POV-Ray.
const POV_OFFSET: f64 = 10_000.0;
/// POV-Ray's cells are 32-bit integers: a coordinate beyond them is in the lowest one, however far from it.
pub(super) const LOWEST_CELL: f64 = i32::MIN as f64;
/// What brings a whole number (below 2^51), moved by the offset, into the lowest bits of a double's mantissa.
const TO_BITS: f64 = ((1_u64 << 52) + (1 << 51)) as f64 + POV_OFFSET;

/// What is needed of a lattice cell and the point in it. Corner k stands on side k & 1 along x, on side k >> 1 & 1
/// along y and on side k >> 2 along z.
pub(super) struct Cell {
    /// Table rows of the corners, modulo 256.
    rows: [u32; 8],
    /// Twice the distances from the lower and from the upper sides along x, y and z; nothing in the fourth place.
    distances: [[f64; 4]; 2],
    /// Half the weights of corners 0 to 3 and of corners 4 to 7: so the values at the corners, of which the noise
    /// takes half, need no product, and factors of two change no bit.
    weights: [[f64; 4]; 2],
}

/// Where coordinates lie between the sides of their cells.
pub(super) struct Sides {
    /// Lattice coordinates of the lower sides, modulo 65,536.
    pub(super) lower: u64x4,
    /// Twice the distances from the lower and from the upper sides.
    pub(super) distances: [f64x4; 2],
    /// Shares of the lower and of the upper sides.
    pub(super) shares: [f64x4; 2],
}

impl Sides {
    #[inline(always)]
    pub(super) fn of<S: Lanes>(simd: S, coordinates: f64x4) -> Self {
        let below = simd.sub_f64s(coordinates, simd.splat_f64s(POV_ALMOST_ONE));
        let positive = simd.greater_than_or_equal_f64s(coordinates, simd.splat_f64s(0.0));
        let whole = simd.truncate(simd.select_f64s(positive, coordinates, below));
        let has_cell = simd.less_than_f64s(simd.abs_f64s(coordinates), simd.splat_f64s(-LOWEST_CELL));
        let whole = simd.select_f64s(has_cell, whole, simd.splat_f64s(LOWEST_CELL));
        let lower = simd.transmute_u64s_f64s(simd.add_f64s(whole, simd.splat_f64s(TO_BITS)));
        let fraction = simd.sub_f64s(coordinates, whole);
        let twice = simd.add_f64s(fraction, fraction);
        let three_less = simd.sub_f64s(simd.splat_f64s(3.0), twice);
        let upper_shares = simd.mul_f64s(simd.mul_f64s(fraction, fraction), three_less);
        let lower_shares = simd.sub_f64s(simd.splat_f64s(1.0), upper_shares);
        let distances = [twice, simd.sub_f64s(twice, simd.splat_f64s(2.0))];
        Self { lower, distances, shares: [lower_shares, upper_shares] }
    }
}

impl Cell {
    #[inline(always)]
    pub(super) fn around<S: Lanes>(simd: S, point: f64x4) -> Self {
        let sides = Sides::of(simd, point);
        Self {
            rows: rows([sides.lower.0, sides.lower.1, sides.lower.2]),
            distances: sides.distances.map(cast),
            weights: weights(simd, sides.shares[0], sides.shares[1]),
        }
    }

    /// The sum over the corners.
    #[inline(always)]
    pub(super) fn sum<S: Lanes>(&self, simd: S) -> f64 {
        let [lower, upper] = &self.distances;
        let x = f64x4(lower[0], upper[0], lower[0], upper[0]);
        let y = f64x4(lower[1], lower[1], upper[1], upper[1]);
        let mut sum = 0.0;
        for (k, z) in [lower[2], upper[2]].into_iter().enumerate() {
            let row = |i: usize| table_row(&NOISE_TABLE, self.rows[4 * k + i], 0);
            let columns = simd.columns([row(0), row(1), row(2), row(3)]);
            let slopes = slopes(simd, &columns, [x, y, simd.splat_f64s(z)]);
            let f64x4(a, b, c, d) = simd.mul_f64s(slopes, cast(self.weights[k]));
            // In this order, for POV-Ray's last bit; so below.
            sum = sum + a + b + c + d;
        }
        sum
    }

    /// The vector noise.
    #[inline(always)]
    pub(super) fn vector_noise<S: Lanes>(&self, simd: S) -> f64x4 {
        let mut sum = simd.splat_f64s(0.0);
        for k in 0..8 {
            let [x, y, z] = [self.distances[k & 1][0], self.distances[k >> 1 & 1][1], self.distances[k >> 2][2]];
            let distances = [simd.splat_f64s(x), simd.splat_f64s(y), simd.splat_f64s(z)];
            let slopes = slopes(simd, table_row(&COLUMNS.0, self.rows[k], 0), distances);
            sum = simd.add_f64s(sum, simd.mul_f64s(slopes, simd.splat_f64s(self.weights[k >> 2][k & 3])));
        }
        sum
    }
}

/// Table rows of corners, from the lattice coordinates of the lower sides, modulo 65,536.
#[inline(always)]
pub(super) fn rows([x, y, z]: [u64; 3]) -> [u32; 8] {
    // Known to be in the permutation, so that no index is checked.
    let index = |c: u64| usize::from(c as u16);
    let (u, v, w) = (index(x.wrapping_add(1)), index(y.wrapping_add(1)), index(z.wrapping_add(1)));
    let (x, y, z) = (index(x), index(y), index(z));
    let (x, u) = (permuted(x), permuted(u));
    let (a, b, c, d) = (permuted(x ^ y), permuted(u ^ y), permuted(x ^ v), permuted(u ^ v));
    let row = |i: usize| permuted(i) as u32;
    [row(a ^ z), row(b ^ z), row(c ^ z), row(d ^ z), row(a ^ w), row(b ^ w), row(c ^ w), row(d ^ w)]
}

/// Half the weights of the corners, from the shares of the lower and of the upper sides.
#[inline(always)]
fn weights<S: Lanes>(simd: S, lower: f64x4, upper: f64x4) -> [[f64; 4]; 2] {
    let x = simd.mul_f64s(f64x4(lower.0, upper.0, lower.0, upper.0), simd.splat_f64s(0.5));
    let xy = simd.mul_f64s(x, f64x4(lower.1, lower.1, upper.1, upper.1));
    [cast(simd.mul_f64s(xy, simd.splat_f64s(lower.2))), cast(simd.mul_f64s(xy, simd.splat_f64s(upper.2)))]
}

/// The values of corners, from the four entries of their rows and twice the distances along x, y and z.
#[inline(always)]
pub(super) fn slopes<S: Lanes>(simd: S, entries: &[f64x4; 4], [x, y, z]: [f64x4; 3]) -> f64x4 {
    let slopes = simd.add_f64s(entries[0], simd.mul_f64s(entries[1], x));
    let slopes = simd.add_f64s(slopes, simd.mul_f64s(entries[2], y));
    simd.add_f64s(slopes, simd.mul_f64s(entries[3], z))
}

/// The four entries of a row, modulo 256, for a component of the vector noise; those of the first are the noise's.
#[inline(always)]
pub(super) fn table_row<T, const N: usize>(table: &[T; N], row: u32, component: usize) -> &[T; 4] {
    const { assert!(N >= 256 + 3) };
    let first = row as usize % 256 + 4 * component;
    table[first..].first_chunk().expect("the table goes on after its last row")
}

/// Aligned as cache lines, so that no entry lies in two.
#[repr(align(64))]
struct Columns([f64x4; 259]);

/// Entry i of the table for the three components of the vector noise: a corner with row r reads entries r to r + 3.
static COLUMNS: Columns = Columns({
    let mut columns = [f64x4(0.0, 0.0, 0.0, 0.0); 259];
    let mut i = 0;
    while i < 259 {
        columns[i] = f64x4(NOISE_TABLE[i], NOISE_TABLE[i + 4], NOISE_TABLE[i + 8], 0.0);
        i += 1;
    }
    columns
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::MersenneTwister;
    use crate::math::noise::{MAX_OCTAVES, lattice_hash};
    use pulp::Scalar256b;

    /// The noise as section 5.2 of the function facts writes it down, component by component.
    fn plain(point: DVec3) -> DVec3 {
        let point = point.to_array();
        let n = point.map(|c| if c >= 0.0 { c.trunc() } else { (c - POV_ALMOST_ONE).trunc() });
        let [fx, fy, fz] = [point[0] - n[0], point[1] - n[1], point[2] - n[2]];
        let share = |f: f64, side: usize| {
            let upper = f * f * (3.0 - 2.0 * f);
            if side == 0 { 1.0 - upper } else { upper }
        };
        let mut sum = [0.0; 3];
        for k in 0..8 {
            let [i, j, l] = [k & 1, k >> 1 & 1, k >> 2];
            let corner = |axis: usize, side: usize| n[axis] as i64 + 10_000 + side as i64;
            let row = lattice_hash(corner(0, i), corner(1, j), corner(2, l)) % 256;
            let [x, y, z] = [fx - i as f64, fy - j as f64, fz - l as f64];
            let weight = share(fx, i) * share(fy, j) * share(fz, l);
            for (component, sum) in sum.iter_mut().enumerate() {
                let t = &NOISE_TABLE[row + 4 * component..];
                *sum += weight * (0.5 * t[0] + t[1] * x + t[2] * y + t[3] * z);
            }
        }
        sum.into()
    }

    const SCALING: Scaling = Scaling { shift: 1.1, factor: 0.45 };

    /// Noises at a point, at `factor` times it and so on, with and without AVX2, have the bits of the plain formula.
    fn check(point: DVec3, factor: f64, count: usize) {
        let frequencies = std::iter::successors(Some(1.0), |f| Some(f * factor)).take(count);
        let points: Vec<_> = frequencies.map(|frequency| point * frequency).collect();
        let expected: Vec<_> = points.iter().map(|p| plain(*p)).collect();
        for (p, expected) in points.iter().zip(&expected) {
            let scaled = ((expected.x + 1.1) * 0.45).clamp(0.0, 1.0);
            assert_eq!(noise(&SCALING, *p), scaled, "{p}");
            let sums = [dispatch(Noise(*p)), Noise(*p).run(Scalar256b)];
            assert!(sums.iter().all(|n| *n == expected.x), "{p}: {sums:?} for {}", expected.x);
            let vectors = [vector_noise(*p), VectorNoise(*p).run(Scalar256b)];
            assert!(vectors.iter().all(|v| v == expected), "{p}: {vectors:?} for {expected}");
        }
        let ratio = f64::from(0.55_f32);
        let weights = std::iter::successors(Some(1.0), |w| Some(w * ratio));
        let sum: DVec3 = expected.iter().zip(weights.clone()).map(|(v, w)| w * *v).sum();
        let absolute: DVec3 = expected.iter().zip(weights).map(|(v, w)| w * v.abs()).sum();
        assert_eq!(vector_sum::<false>(point, factor, count, ratio), sum, "{point}, {factor}");
        assert_eq!(VectorSum::<true> { point, factor, count, ratio }.run(Scalar256b), absolute, "{point}, {factor}");
    }

    #[test]
    fn noises_have_the_bits_of_the_plain_formula() {
        let mut random = MersenneTwister::default();
        let mut next = || 2.0 * random.next_f64() - 1.0;
        for i in 0..4000 {
            let size = 10.0_f64.powi(i % 8 - 2);
            let point = size * DVec3::new(next(), next(), next());
            check(point, 2.0 + next(), 1 + i as usize % MAX_OCTAVES);
        }
        // Whole and nearly whole coordinates, where the cell changes.
        for c in [0.0, -0.0, 1.0, -1.0, -1e-10, -1e-11, 0.5, -4096.0, 1e5] {
            check(DVec3::new(c, 2.0 * c, -c), 2.0, 10);
        }
    }
}
