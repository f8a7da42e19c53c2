//! Which pieces of an outline a ray may meet, seen along the swept axis.

use crate::math::DVec2;
use crate::math::lanes::{Lanes, Work, dispatch};
use bytemuck::cast;
use pulp::f64x4;

/// The points whose product with a direction lies in an interval.
pub(super) struct Band {
    direction: DVec2,
    low: f64,
    high: f64,
}

impl Band {
    /// Wider than the interval by some slack.
    pub(super) fn new(direction: DVec2, [low, high]: [f64; 2], slack: f64) -> Self {
        Self { direction, low: low - slack, high: high + slack }
    }
}

/// Where the shadow of a ray on the plane of an outline passes over it; errs on the side of more.
pub(super) struct Passage {
    /// On the shadow's line.
    pub(super) across: Band,
    /// Between the shadow's ends.
    pub(super) along: Band,
    /// In the box around it.
    pub(super) hull: [DVec2; 2],
}

/// Four boxes: the lower and upper ends of their sides, in x, then in y.
type Four = [[f64x4; 2]; 2];

/// Boxes around pieces of an outline, four by four; those that fill up the last four are not numbers and meet nothing.
#[derive(Clone, Debug)]
pub(super) struct Boxes(Box<[Four]>);

/// Fours that are looked at together: their boxes are the bits of a number.
const TOGETHER: usize = 16;

impl Boxes {
    /// From lower and upper corners.
    pub(super) fn new(hulls: &[[DVec2; 2]]) -> Self {
        let four = |hulls: &[[DVec2; 2]]| {
            let lane = |end: usize, axis: usize| {
                cast(std::array::from_fn::<f64, 4, _>(|i| hulls.get(i).map_or(f64::NAN, |hull| hull[end][axis])))
            };
            [[lane(0, 0), lane(1, 0)], [lane(0, 1), lane(1, 1)]]
        };
        Self(hulls.chunks(4).map(four).collect())
    }

    /// Visits those of the first `n` in rising order that a passage may meet.
    #[inline]
    pub(super) fn met_by(&self, passage: &Passage, n: usize, mut visit: impl FnMut(usize)) {
        for (chunk, boxes) in self.0[..n.div_ceil(4)].chunks(TOGETHER).enumerate() {
            let mut met = dispatch(Sift { boxes, passage });
            while met != 0 {
                visit(4 * TOGETHER * chunk + met.trailing_zeros() as usize);
                met &= met - 1;
            }
        }
    }
}

/// Tells, by bits, which boxes a passage meets.
struct Sift<'a> {
    boxes: &'a [Four],
    passage: &'a Passage,
}

impl Work for Sift<'_> {
    type Output = u64;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> u64 {
        let Passage { across, along, hull: [low, high] } = self.passage;
        let mut bits = 0;
        for (i, four) in self.boxes.iter().enumerate() {
            let [[min_x, max_x], [min_y, max_y]] = *four;
            let reached = simd.and_m64s(
                simd.greater_than_or_equal_f64s(max_x, simd.splat_f64s(low.x)),
                simd.greater_than_or_equal_f64s(max_y, simd.splat_f64s(low.y)),
            );
            let not_passed = simd.and_m64s(
                simd.less_than_or_equal_f64s(min_x, simd.splat_f64s(high.x)),
                simd.less_than_or_equal_f64s(min_y, simd.splat_f64s(high.y)),
            );
            let mut met = simd.and_m64s(reached, not_passed);
            for band in [across, along] {
                let (x, y) = (simd.splat_f64s(band.direction.x), simd.splat_f64s(band.direction.y));
                // The corners with the least and the greatest product.
                let (i, j) = (usize::from(band.direction.x < 0.0), usize::from(band.direction.y < 0.0));
                let least = simd.add_f64s(simd.mul_f64s(x, four[0][i]), simd.mul_f64s(y, four[1][j]));
                let most = simd.add_f64s(simd.mul_f64s(x, four[0][1 - i]), simd.mul_f64s(y, four[1][1 - j]));
                let within = simd.and_m64s(
                    simd.less_than_or_equal_f64s(least, simd.splat_f64s(band.high)),
                    simd.greater_than_or_equal_f64s(most, simd.splat_f64s(band.low)),
                );
                met = simd.and_m64s(met, within);
            }
            let [a, b, c, d]: [u64; 4] = cast(met);
            bits |= (a & 1 | b & 2 | c & 4 | d & 8) << (4 * i);
        }
        bits
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes of size 1 in a row along x, met by a passage along a direction.
    fn check(n: usize, across: DVec2, at: f64, ends: [f64; 2], expected: &[usize]) {
        let hulls: Vec<_> = (0..n).map(|i| [DVec2::new(i as f64, 0.0), DVec2::new(i as f64 + 1.0, 1.0)]).collect();
        let along = Band::new(DVec2::new(across.y, -across.x), ends, 0.0);
        let everywhere = [DVec2::NEG_INFINITY, DVec2::INFINITY];
        let passage = Passage { across: Band::new(across, [at; 2], 0.0), along, hull: everywhere };
        let mut met = Vec::new();
        Boxes::new(&hulls).met_by(&passage, n, |i| met.push(i));
        assert_eq!(met, expected);
    }

    #[test]
    fn boxes_on_the_way_are_met() {
        const FAR: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
        check(6, DVec2::X, 2.5, FAR, &[2]);
        check(6, DVec2::NEG_X, -5.0, FAR, &[4, 5]);
        check(130, DVec2::X, 128.5, FAR, &[128]);
        check(7, DVec2::Y, 0.5, [2.5, 4.5], &[2, 3, 4]);
        check(7, DVec2::Y, 1.5, FAR, &[]);
        check(5, DVec2::new(1.0, -1.0), 3.0, FAR, &[2, 3, 4]);
    }
}
