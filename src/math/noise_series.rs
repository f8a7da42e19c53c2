//! One point's lattice noise at several frequencies at once, in SIMD lanes: the work behind turbulence.
//!
//! Cells are found for four frequencies together, one a lane. The scalar noise then keeps a frequency
//! a lane; the vector noise takes its frequencies in turn, with its three components in the lanes, for which the
//! table is so ordered that a corner is four loads and no shuffle. Every value has the bits that
//! [`noise`](super::noise::noise) and [`vector_noise`](super::noise::vector_noise) give: sums keep their order and
//! nothing is fused, whatever the processor.

use super::DVec3;
use super::noise::{MAX_OCTAVES, POV_ALMOST_ONE, POV_OFFSET, permuted};
use super::noise_table::NOISE_TABLE;
use bytemuck::cast_ref;
use pulp::{Scalar256b, Simd, f64x4, m64x4, u64x4};

/// Four doubles at once, as the processor has them.
trait Lanes: Simd<f64s = f64x4, u64s = u64x4, m64s = m64x4> {
    /// Rounds towards zero.
    fn truncate(self, v: f64x4) -> f64x4;
}

impl Lanes for Scalar256b {
    #[inline(always)]
    fn truncate(self, f64x4(a, b, c, d): f64x4) -> f64x4 {
        // From 2^52 on every number is whole. Calls of the C library are what this saves.
        let truncate = |v: f64| if v.abs() < (1_u64 << 52) as f64 { v as i64 as f64 } else { v };
        f64x4(truncate(a), truncate(b), truncate(c), truncate(d))
    }
}

#[cfg(target_arch = "x86_64")]
impl Lanes for pulp::x86::V3 {
    #[inline(always)]
    fn truncate(self, v: f64x4) -> f64x4 {
        self.truncate_f64x4(v)
    }
}

/// Work on lanes, whatever they are.
trait Work {
    fn run<S: Lanes>(self, simd: S);
}

/// Does the work with AVX2 where the processor has it.
fn dispatch<W: Work>(work: W) {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return simd.vectorize(
            #[inline(always)]
            || work.run(simd),
        );
    }
    work.run(Scalar256b);
}

/// A point at the frequencies `first`, `first * factor`, `first * factor * factor` …
#[derive(Clone, Copy, Debug)]
pub(super) struct Series {
    /// The point at frequency 1.
    pub(super) point: DVec3,
    /// The lowest frequency.
    pub(super) first: f64,
    /// From one frequency to the next; products round one after the other.
    pub(super) factor: f64,
}

/// Room for the noises of a series: whole groups of four, of which the last may be wanted in part.
pub(super) const ROOM: usize = MAX_OCTAVES.next_multiple_of(4);

impl Series {
    /// The lattice's noises, unscaled, at `count` frequencies; what stands beyond them means nothing.
    pub(super) fn noises(self, count: usize) -> [f64; ROOM] {
        let mut noises = [0.0; ROOM];
        dispatch(Noises { series: self, count, noises: &mut noises });
        noises
    }

    /// Writes vector noises at as many frequencies as there is room for.
    pub(super) fn vector_noises(self, noises: &mut [DVec3]) {
        dispatch(VectorNoises { series: self, noises });
    }

    /// The cells of the next four frequencies.
    #[inline(always)]
    fn next_four<S: Lanes>(&mut self, simd: S) -> Cells {
        let second = self.first * self.factor;
        let third = second * self.factor;
        let fourth = third * self.factor;
        let four = f64x4(self.first, second, third, fourth);
        self.first = fourth * self.factor;
        let [x, y, z] = [self.point.x, self.point.y, self.point.z];
        Cells::around(
            simd,
            [
                simd.mul_f64s(simd.splat_f64s(x), four),
                simd.mul_f64s(simd.splat_f64s(y), four),
                simd.mul_f64s(simd.splat_f64s(z), four),
            ],
        )
    }
}

struct Noises<'a> {
    series: Series,
    count: usize,
    noises: &'a mut [f64; ROOM],
}

impl Work for Noises<'_> {
    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) {
        let Self { mut series, count, noises } = self;
        for (four, done) in noises.chunks_exact_mut(4).zip((0..count).step_by(4)) {
            let cells = series.next_four(simd);
            let wanted = count - done;
            let first = cells.rows(0);
            // Rows of lanes that nobody wants need not be found.
            let second = if wanted > 1 { cells.rows(1) } else { first };
            let [third, fourth] = if wanted > 2 { [cells.rows(2), cells.rows(3)] } else { [first; 2] };
            four.copy_from_slice(&bytemuck::cast::<f64x4, [f64; 4]>(
                cells.noises(simd, &[first, second, third, fourth]),
            ));
        }
    }
}

struct VectorNoises<'a> {
    series: Series,
    noises: &'a mut [DVec3],
}

impl Work for VectorNoises<'_> {
    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) {
        let Self { mut series, noises } = self;
        for four in noises.chunks_mut(4) {
            let cells = series.next_four(simd);
            let mut next = cells.rows(0);
            for (lane, noise) in four.iter_mut().enumerate() {
                // The next lane's table rows are under way while this one's noise is added up.
                let rows = std::mem::replace(&mut next, cells.rows(lane + 1));
                let f64x4(x, y, z, _) = cells.vector_noise(simd, lane, &rows);
                *noise = DVec3::new(x, y, z);
            }
        }
    }
}

/// Four lattice cells and the points in them, one a lane. Corner k stands on side k & 1 along x, on side k >> 1 & 1
/// along y and on side k >> 2 along z.
struct Cells {
    /// Lattice coordinates of the lower corners; bits from the twelfth on are to be ignored.
    lower: [u64x4; 3],
    /// Twice the distances from the lower and the upper sides along x, y and z.
    distances: [[f64x4; 2]; 3],
    /// Half the weights of the corners.
    weights: [f64x4; 8],
}

/// What brings the whole number n (below 2^51) into the lowest bits of a double's mantissa, and POV-Ray's offset.
const TO_BITS: f64 = ((1_u64 << 52) + (1 << 51)) as f64 + POV_OFFSET as f64;

impl Cells {
    #[inline(always)]
    fn around<S: Lanes>(simd: S, point: [f64x4; 3]) -> Self {
        let mut lower = [simd.splat_u64s(0); 3];
        let mut distances = [[simd.splat_f64s(0.0); 2]; 3];
        let mut shares = distances;
        for axis in 0..3 {
            let c = point[axis];
            let below = simd.sub_f64s(c, simd.splat_f64s(POV_ALMOST_ONE));
            let positive = simd.greater_than_or_equal_f64s(c, simd.splat_f64s(0.0));
            let whole = simd.truncate(simd.select_f64s(positive, c, below));
            let f = simd.sub_f64s(c, whole);
            lower[axis] = simd.transmute_u64s_f64s(simd.add_f64s(whole, simd.splat_f64s(TO_BITS)));
            let twice = simd.add_f64s(f, f);
            let upper = simd.mul_f64s(simd.mul_f64s(f, f), simd.sub_f64s(simd.splat_f64s(3.0), twice));
            shares[axis] = [simd.sub_f64s(simd.splat_f64s(1.0), upper), upper];
            distances[axis] = [twice, simd.sub_f64s(twice, simd.splat_f64s(2.0))];
        }
        // Halves and doubles as in the single noise's cell.
        let [x, y, z] = shares;
        let x = x.map(
            #[inline(always)]
            |share| simd.mul_f64s(share, simd.splat_f64s(0.5)),
        );
        let xy = [
            simd.mul_f64s(x[0], y[0]),
            simd.mul_f64s(x[1], y[0]),
            simd.mul_f64s(x[0], y[1]),
            simd.mul_f64s(x[1], y[1]),
        ];
        let mut weights = [simd.splat_f64s(0.0); 8];
        for k in 0..4 {
            weights[k] = simd.mul_f64s(xy[k], z[0]);
            weights[k + 4] = simd.mul_f64s(xy[k], z[1]);
        }
        Self { lower, distances, weights }
    }

    /// Table rows of the corners of a lane's cell.
    #[inline(always)]
    fn rows(&self, lane: usize) -> [usize; 8] {
        let [x, y, z] = [&self.lower[0], &self.lower[1], &self.lower[2]].map(
            #[inline(always)]
            |lanes| cast_ref::<u64x4, [u64; 4]>(lanes)[lane & 3] as usize,
        );
        let (x0, x1) = (permuted(x), permuted(x + 1));
        let (a, b, c, d) = (permuted(x0 ^ y), permuted(x1 ^ y), permuted(x0 ^ (y + 1)), permuted(x1 ^ (y + 1)));
        let row = |z: usize| permuted(z) % 256;
        let w = z + 1;
        [row(a ^ z), row(b ^ z), row(c ^ z), row(d ^ z), row(a ^ w), row(b ^ w), row(c ^ w), row(d ^ w)]
    }

    /// The unscaled noises of all lanes.
    #[inline(always)]
    fn noises<S: Lanes>(&self, simd: S, rows: &[[usize; 8]; 4]) -> f64x4 {
        let sum = self.noises_at::<S, 0>(simd, rows);
        let sum = simd.add_f64s(sum, self.noises_at::<S, 1>(simd, rows));
        let sum = simd.add_f64s(sum, self.noises_at::<S, 2>(simd, rows));
        let sum = simd.add_f64s(sum, self.noises_at::<S, 3>(simd, rows));
        let sum = simd.add_f64s(sum, self.noises_at::<S, 4>(simd, rows));
        let sum = simd.add_f64s(sum, self.noises_at::<S, 5>(simd, rows));
        let sum = simd.add_f64s(sum, self.noises_at::<S, 6>(simd, rows));
        simd.add_f64s(sum, self.noises_at::<S, 7>(simd, rows))
    }

    /// What corner `K` has in the noises of all lanes.
    #[inline(always)]
    fn noises_at<S: Lanes, const K: usize>(&self, simd: S, rows: &[[usize; 8]; 4]) -> f64x4 {
        let rows = [rows[0][K], rows[1][K], rows[2][K], rows[3][K]];
        let [x, y, z] = [self.distances[0][K & 1], self.distances[1][K >> 1 & 1], self.distances[2][K >> 2]];
        let slopes = simd.add_f64s(table_column(rows, 0), simd.mul_f64s(table_column(rows, 1), x));
        let slopes = simd.add_f64s(slopes, simd.mul_f64s(table_column(rows, 2), y));
        let slopes = simd.add_f64s(slopes, simd.mul_f64s(table_column(rows, 3), z));
        simd.mul_f64s(slopes, self.weights[K])
    }

    /// The vector noise of a lane.
    #[inline(always)]
    fn vector_noise<S: Lanes>(&self, simd: S, lane: usize, rows: &[usize; 8]) -> f64x4 {
        let sum = self.vector_noise_at::<S, 0>(simd, lane, rows);
        let sum = simd.add_f64s(sum, self.vector_noise_at::<S, 1>(simd, lane, rows));
        let sum = simd.add_f64s(sum, self.vector_noise_at::<S, 2>(simd, lane, rows));
        let sum = simd.add_f64s(sum, self.vector_noise_at::<S, 3>(simd, lane, rows));
        let sum = simd.add_f64s(sum, self.vector_noise_at::<S, 4>(simd, lane, rows));
        let sum = simd.add_f64s(sum, self.vector_noise_at::<S, 5>(simd, lane, rows));
        let sum = simd.add_f64s(sum, self.vector_noise_at::<S, 6>(simd, lane, rows));
        simd.add_f64s(sum, self.vector_noise_at::<S, 7>(simd, lane, rows))
    }

    /// What corner `K` has in the vector noise of a lane.
    #[inline(always)]
    fn vector_noise_at<S: Lanes, const K: usize>(&self, simd: S, lane: usize, rows: &[usize; 8]) -> f64x4 {
        let columns = &COLUMNS.0[rows[K]..rows[K] + 4];
        let [x, y, z] = [&self.distances[0][K & 1], &self.distances[1][K >> 1 & 1], &self.distances[2][K >> 2]];
        let slopes = simd.add_f64s(columns[0], simd.mul_f64s(columns[1], of_lane(simd, x, lane)));
        let slopes = simd.add_f64s(slopes, simd.mul_f64s(columns[2], of_lane(simd, y, lane)));
        let slopes = simd.add_f64s(slopes, simd.mul_f64s(columns[3], of_lane(simd, z, lane)));
        simd.mul_f64s(slopes, of_lane(simd, &self.weights[K], lane))
    }
}

/// One lane's value in all lanes.
#[inline(always)]
fn of_lane<S: Lanes>(simd: S, lanes: &f64x4, lane: usize) -> f64x4 {
    simd.splat_f64s(cast_ref::<f64x4, [f64; 4]>(lanes)[lane & 3])
}

/// Entry `i` of four table rows.
#[inline(always)]
fn table_column(rows: [usize; 4], i: usize) -> f64x4 {
    // The remainder, which changes nothing, spares the bounds checks.
    f64x4(
        NOISE_TABLE[rows[0] % 256 + i],
        NOISE_TABLE[rows[1] % 256 + i],
        NOISE_TABLE[rows[2] % 256 + i],
        NOISE_TABLE[rows[3] % 256 + i],
    )
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
    use super::super::noise::{NoiseGenerator, noise, vector_noise};
    use super::*;
    use crate::math::MersenneTwister;

    /// Every frequency of a series has the bits of the single noise, with and without AVX2.
    fn check(series: Series, count: usize) {
        let (mut noises, mut vectors, mut plain_vectors) = ([0.0; ROOM], [DVec3::ZERO; 10], [DVec3::ZERO; 10]);
        Noises { series, count, noises: &mut noises }.run(Scalar256b);
        VectorNoises { series, noises: &mut plain_vectors[..count] }.run(Scalar256b);
        series.vector_noises(&mut vectors[..count]);
        assert!(vectors == plain_vectors && series.noises(count)[..count] == noises[..count], "{series:?}");
        let frequencies = std::iter::successors(Some(series.first), |f| Some(f * series.factor));
        for (i, f) in frequencies.take(count).enumerate() {
            let original = noise(NoiseGenerator::Original, series.point * f);
            assert!((noises[i] + 0.5).clamp(0.0, 1.0) == original, "{series:?}");
            assert!(vectors[i] == vector_noise(series.point * f), "{series:?}");
        }
    }

    #[test]
    fn series_have_the_bits_of_single_noises() {
        let mut random = MersenneTwister::default();
        let mut next = || 2.0 * random.next_f64() - 1.0;
        for i in 0..4000 {
            let size = 10.0_f64.powi(i % 8 - 2);
            let point = size * DVec3::new(next(), next(), next());
            check(Series { point, first: 1.0, factor: 2.0 + next() }, 1 + i as usize % MAX_OCTAVES);
        }
        // Whole and nearly whole coordinates, where the cell changes.
        for c in [0.0, -0.0, 1.0, -1.0, -1e-10, -1e-11, 0.5, -4096.0, 1e5] {
            check(Series { point: DVec3::new(c, 2.0 * c, -c), first: 4.0, factor: 2.0 }, 10);
        }
    }
}
