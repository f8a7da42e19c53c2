//! The lattice noise at four points at once, a point in each lane.
//!
//! Points that are neighbours in a picture mostly lie in one cell of the lattice. Then they share its hashes and its
//! table rows, which are two thirds of the work. Sums keep the order that they have for one point, so that the bits are
//! the same.

use super::lanes::{Lanes, Work, dispatch};
use super::lattice::{Cell, Scaling, Sides, rows, slopes, table_row};
use super::noise_table::NOISE_TABLE;
use super::{DVec3, LANES, Points};
use bytemuck::cast;
use pulp::f64x4;

/// The noises at four points.
pub(super) fn noises(scaling: &'static Scaling, points: &Points) -> [f64; LANES] {
    dispatch(Noises { scaling, points })
}

/// Writes the noises at four points, at `factor` times them and so on, for as many frequencies as there is room for.
pub(super) fn series_noises(scaling: &'static Scaling, points: &Points, factor: f64, noises: &mut [[f64; LANES]]) {
    dispatch(SeriesNoises { scaling, points, factor, noises });
}

/// Writes the noises at one point, at `factor` times it and so on: four frequencies are in the lanes.
pub(super) fn noises_of_one(scaling: &'static Scaling, point: DVec3, factor: f64, noises: &mut [f64]) {
    dispatch(NoisesOfOne { scaling, point, factor, noises });
}

/// The sums of `count` vector noises of rising frequency. The first has weight 1, every other `ratio` times that of the
/// one before.
pub(super) fn vector_sums(points: &Points, factor: f64, count: usize, ratio: f64) -> Points {
    dispatch(VectorSums { points, factor, count, ratio })
}

struct Noises<'a> {
    scaling: &'static Scaling,
    points: &'a Points,
}

impl Work for Noises<'_> {
    type Output = [f64; LANES];

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> [f64; LANES] {
        cast(self.scaling.noises(simd, Cells::around(simd, self.points.lanes()).sums(simd)))
    }
}

struct SeriesNoises<'a> {
    scaling: &'static Scaling,
    points: &'a Points,
    factor: f64,
    noises: &'a mut [[f64; LANES]],
}

impl Work for SeriesNoises<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) {
        let points = self.points.lanes();
        let mut frequency = 1.0;
        for noises in self.noises {
            let cells = Cells::around(simd, scaled(simd, points, simd.splat_f64s(frequency)));
            *noises = cast(self.scaling.noises(simd, cells.sums(simd)));
            frequency *= self.factor;
        }
    }
}

struct NoisesOfOne<'a> {
    scaling: &'static Scaling,
    point: DVec3,
    factor: f64,
    noises: &'a mut [f64],
}

impl Work for NoisesOfOne<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) {
        let DVec3 { x, y, z } = self.point;
        let points = [simd.splat_f64s(x), simd.splat_f64s(y), simd.splat_f64s(z)];
        let mut frequency = 1.0;
        let mut fours = self.noises.chunks_exact_mut(LANES);
        for noises in &mut fours {
            let second = frequency * self.factor;
            let third = second * self.factor;
            let fourth = third * self.factor;
            let cells = Cells::around(simd, scaled(simd, points, f64x4(frequency, second, third, fourth)));
            noises.copy_from_slice(&cast::<_, [f64; LANES]>(self.scaling.noises(simd, cells.sums(simd))));
            frequency = fourth * self.factor;
        }
        for noise in fours.into_remainder() {
            let cell = Cell::around(simd, simd.mul_f64s(f64x4(x, y, z, 0.0), simd.splat_f64s(frequency)));
            *noise = self.scaling.noise(cell.sum(simd));
            frequency *= self.factor;
        }
    }
}

struct VectorSums<'a> {
    points: &'a Points,
    factor: f64,
    count: usize,
    ratio: f64,
}

impl Work for VectorSums<'_> {
    type Output = Points;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> Points {
        let points = self.points.lanes();
        let (mut frequency, mut weight) = (1.0, 1.0);
        let [mut x, mut y, mut z] = [simd.splat_f64s(0.0); 3];
        for _ in 0..self.count {
            let cells = Cells::around(simd, scaled(simd, points, simd.splat_f64s(frequency)));
            let noises = scaled(simd, cells.vector_noises(simd), simd.splat_f64s(weight));
            x = simd.add_f64s(x, noises[0]);
            y = simd.add_f64s(y, noises[1]);
            z = simd.add_f64s(z, noises[2]);
            frequency *= self.factor;
            weight *= self.ratio;
        }
        Points::from_lanes([x, y, z])
    }
}

#[inline(always)]
fn scaled<S: Lanes>(simd: S, [x, y, z]: [f64x4; 3], factor: f64x4) -> [f64x4; 3] {
    [simd.mul_f64s(x, factor), simd.mul_f64s(y, factor), simd.mul_f64s(z, factor)]
}

/// The cells around four points.
struct Cells {
    points: [f64x4; 3],
    sides: [Sides; 3],
}

/// Table rows of the corners of cells.
enum Rows {
    /// Of the one cell of all points.
    One([u32; 8]),
    /// Of each point's cell.
    Each([[u32; 8]; LANES]),
}

impl Cells {
    #[inline(always)]
    fn around<S: Lanes>(simd: S, points: [f64x4; 3]) -> Self {
        let [x, y, z] = points;
        Self { points, sides: [Sides::of(simd, x), Sides::of(simd, y), Sides::of(simd, z)] }
    }

    /// Whether all four points lie in one cell.
    #[inline(always)]
    fn is_one<S: Lanes>(&self, simd: S) -> bool {
        let [x, y, z] = [self.sides[0].lower, self.sides[1].lower, self.sides[2].lower];
        let x = simd.xor_u64s(x, simd.splat_u64s(x.0));
        let y = simd.xor_u64s(y, simd.splat_u64s(y.0));
        let z = simd.xor_u64s(z, simd.splat_u64s(z.0));
        simd.is_zero(simd.or_u64s(simd.or_u64s(x, y), z))
    }

    #[inline(always)]
    fn rows<S: Lanes>(&self, simd: S) -> Rows {
        let [x, y, z] = [self.sides[0].lower, self.sides[1].lower, self.sides[2].lower];
        if self.is_one(simd) {
            Rows::One(rows([x.0, y.0, z.0]))
        } else {
            Rows::Each([rows([x.0, y.0, z.0]), rows([x.1, y.1, z.1]), rows([x.2, y.2, z.2]), rows([x.3, y.3, z.3])])
        }
    }

    /// The sums over the corners.
    #[inline(always)]
    fn sums<S: Lanes>(&self, simd: S) -> f64x4 {
        let zero = simd.splat_f64s(0.0);
        match self.rows(simd) {
            Rows::One(rows) => self.fold(
                simd,
                zero,
                #[inline(always)]
                |sum, corner| corner.add(simd, sum, &everywhere(simd, table_row(&NOISE_TABLE, rows[corner.index], 0))),
            ),
            Rows::Each([a, b, c, d]) => self.fold(
                simd,
                zero,
                #[inline(always)]
                |sum, corner| {
                    let row = [a[corner.index], b[corner.index], c[corner.index], d[corner.index]];
                    let rows = [
                        table_row(&NOISE_TABLE, row[0], 0),
                        table_row(&NOISE_TABLE, row[1], 0),
                        table_row(&NOISE_TABLE, row[2], 0),
                        table_row(&NOISE_TABLE, row[3], 0),
                    ];
                    corner.add(simd, sum, &simd.columns(rows))
                },
            ),
        }
    }

    /// The vector noises, by component.
    #[inline(always)]
    fn vector_noises<S: Lanes>(&self, simd: S) -> [f64x4; 3] {
        let Rows::One(rows) = self.rows(simd) else { return self.vector_noises_of_each(simd) };
        self.fold(
            simd,
            [simd.splat_f64s(0.0); 3],
            #[inline(always)]
            |[x, y, z], corner| {
                let row = rows[corner.index];
                [
                    corner.add(simd, x, &everywhere(simd, table_row(&NOISE_TABLE, row, 0))),
                    corner.add(simd, y, &everywhere(simd, table_row(&NOISE_TABLE, row, 1))),
                    corner.add(simd, z, &everywhere(simd, table_row(&NOISE_TABLE, row, 2))),
                ]
            },
        )
    }

    /// Point by point, with the components in the lanes: nothing is shared, and so no entry has to change its lane.
    #[inline(always)]
    fn vector_noises_of_each<S: Lanes>(&self, simd: S) -> [f64x4; 3] {
        let [x, y, z] = self.points;
        let a = Cell::around(simd, f64x4(x.0, y.0, z.0, 0.0)).vector_noise(simd);
        let b = Cell::around(simd, f64x4(x.1, y.1, z.1, 0.0)).vector_noise(simd);
        let c = Cell::around(simd, f64x4(x.2, y.2, z.2, 0.0)).vector_noise(simd);
        let d = Cell::around(simd, f64x4(x.3, y.3, z.3, 0.0)).vector_noise(simd);
        let [x, y, z, _] = simd.columns([&cast(a), &cast(b), &cast(c), &cast(d)]);
        [x, y, z]
    }

    /// Goes through the corners. Written out, so that each is compiled for its number.
    #[inline(always)]
    fn fold<S: Lanes, T>(&self, simd: S, first: T, next: impl Fn(T, Corner) -> T) -> T {
        let [x, y, _] = &self.sides;
        // Half of them, as for a single point.
        let half = simd.splat_f64s(0.5);
        let [lower, upper] = [simd.mul_f64s(x.shares[0], half), simd.mul_f64s(x.shares[1], half)];
        let weights = [
            simd.mul_f64s(lower, y.shares[0]),
            simd.mul_f64s(upper, y.shares[0]),
            simd.mul_f64s(lower, y.shares[1]),
            simd.mul_f64s(upper, y.shares[1]),
        ];
        let lower = next(first, self.corner(simd, 0, &weights));
        let lower = next(lower, self.corner(simd, 1, &weights));
        let lower = next(lower, self.corner(simd, 2, &weights));
        let lower = next(lower, self.corner(simd, 3, &weights));
        let all = next(lower, self.corner(simd, 4, &weights));
        let all = next(all, self.corner(simd, 5, &weights));
        let all = next(all, self.corner(simd, 6, &weights));
        next(all, self.corner(simd, 7, &weights))
    }

    #[inline(always)]
    fn corner<S: Lanes>(&self, simd: S, k: usize, weights: &[f64x4; 4]) -> Corner {
        let [x, y, z] = &self.sides;
        let distances = [x.distances[k & 1], y.distances[k >> 1 & 1], z.distances[k >> 2]];
        Corner { index: k, distances, weight: simd.mul_f64s(weights[k & 3], z.shares[k >> 2]) }
    }
}

/// A corner as the four points see it.
struct Corner {
    /// As in [`Cell`].
    index: usize,
    /// Twice the distances along x, y and z.
    distances: [f64x4; 3],
    /// Half the weights.
    weight: f64x4,
}

impl Corner {
    /// Adds what table entries are worth here.
    #[inline(always)]
    fn add<S: Lanes>(&self, simd: S, sum: f64x4, entries: &[f64x4; 4]) -> f64x4 {
        simd.add_f64s(sum, simd.mul_f64s(slopes(simd, entries, self.distances), self.weight))
    }
}

/// Each entry in all lanes.
#[inline(always)]
fn everywhere<S: Lanes>(simd: S, [a, b, c, d]: &[f64; 4]) -> [f64x4; 4] {
    [simd.splat_f64s(*a), simd.splat_f64s(*b), simd.splat_f64s(*c), simd.splat_f64s(*d)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::lattice::{noise, vector_sum};
    use crate::math::noise::MAX_OCTAVES;
    use crate::math::{MersenneTwister, each_lane};
    use pulp::Scalar256b;

    static SCALING: Scaling = Scaling { shift: 1.1, factor: 0.45 };

    /// Four points, with and without AVX2, have the bits that each has by itself; and so has a point at many
    /// frequencies.
    fn check(points: &Points, factor: f64) {
        let mut noises = [[[0.0; LANES]; MAX_OCTAVES]; 2];
        let [fast, plain] = &mut noises;
        series_noises(&SCALING, points, factor, fast);
        SeriesNoises { scaling: &SCALING, points, factor, noises: plain }.run(Scalar256b);
        let frequencies: Vec<_> = std::iter::successors(Some(1.0), |f| Some(f * factor)).take(MAX_OCTAVES).collect();
        for (k, frequency) in frequencies.iter().enumerate() {
            let expected = points.map(|p| noise(&SCALING, p * *frequency));
            let scaled = points.map_coordinates(|_, c| c * frequency);
            assert_eq!(super::noises(&SCALING, &scaled), expected, "{scaled:?}");
            assert_eq!(Noises { scaling: &SCALING, points: &scaled }.run(Scalar256b), expected, "{scaled:?}");
            assert_eq!(noises.map(|all| all[k]), [expected; 2], "{points:?} times {frequency}");
        }
        let mut alone = [[0.0; MAX_OCTAVES]; 2];
        let [fast, plain] = &mut alone;
        noises_of_one(&SCALING, points.lane(0), factor, fast);
        NoisesOfOne { scaling: &SCALING, point: points.lane(0), factor, noises: plain }.run(Scalar256b);
        assert_eq!(alone, noises.map(|all| all.map(|lanes| lanes[0])), "{points:?}, {factor}");
        let (count, ratio) = (6, 0.55);
        let expected = Points::from(each_lane(|i| vector_sum::<false>(points.lane(i), factor, count, ratio)));
        assert_eq!(vector_sums(points, factor, count, ratio), expected, "{factor}");
        assert_eq!(VectorSums { points, factor, count, ratio }.run(Scalar256b), expected, "{factor}");
    }

    #[test]
    fn four_points_have_the_bits_of_each() {
        let mut random = MersenneTwister::default();
        let mut next = || 2.0 * random.next_f64() - 1.0;
        for i in 0..2000 {
            let (size, step) = (10.0_f64.powi(i % 5 - 2), 10.0_f64.powi(i % 7 - 5));
            let first = size * DVec3::new(next(), next(), next());
            let side = step * DVec3::new(next(), next(), next());
            check(&Points::from(each_lane(|k| first + k as f64 * side)), 2.0 + next());
        }
        // On both sides of where the cell changes.
        let edges = [0.0, -1e-11, -1e-10, -1e-9].map(|c| DVec3::new(c, 1.0 + c, -1.0 - c));
        check(&edges.into(), 2.0);
    }
}
