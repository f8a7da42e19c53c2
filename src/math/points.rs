//! Four points at once, for work in SIMD lanes.

use super::DVec3;
use pulp::f64x4;

/// How many points are worked on at once.
pub const LANES: usize = 4;

/// What a function makes of each lane. Written out: `array::map` and `array::from_fn` are not always inlined, and hand
/// everything over by memory then.
#[inline(always)]
pub fn each_lane<T>(value: impl Fn(usize) -> T) -> [T; LANES] {
    [value(0), value(1), value(2), value(3)]
}

/// Four points. Their coordinates stand in pairs: plain code works on pairs, and lanes are read pair by pair, so that
/// what the one has just written is at hand for the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Points {
    /// Of points 0 and 1 and of points 2 and 3.
    pairs: [Pair; 2],
}

/// Two points, by axis.
type Pair = [[f64; 2]; 3];

impl Points {
    /// The point in one lane.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> DVec3 {
        let [x, y, z] = &self.pairs[i / 2];
        DVec3::new(x[i % 2], y[i % 2], z[i % 2])
    }

    /// What a function makes of each point.
    #[inline(always)]
    pub fn map<T: Copy + Default>(&self, value: impl Fn(DVec3) -> T) -> [T; LANES] {
        let mut values = [T::default(); LANES];
        for (i, slot) in values.iter_mut().enumerate() {
            *slot = value(self.lane(i));
        }
        values
    }

    /// The coordinates of all four points along an axis.
    #[inline(always)]
    pub fn along(&self, axis: usize) -> [f64; LANES] {
        let [[a, b], [c, d]] = [self.pairs[0][axis], self.pairs[1][axis]];
        [a, b, c, d]
    }

    /// What a function of an axis makes of each coordinate along it.
    #[inline(always)]
    #[must_use]
    pub fn map_coordinates(&self, value: impl Fn(usize, f64) -> f64) -> Self {
        let both = |[a, b]: [f64; 2], axis: usize| [value(axis, a), value(axis, b)];
        let of = |[x, y, z]: Pair| [both(x, 0), both(y, 1), both(z, 2)];
        Self { pairs: [of(self.pairs[0]), of(self.pairs[1])] }
    }

    /// The points moved by `factor` times some vectors.
    #[inline(always)]
    #[must_use]
    pub fn moved(&self, factor: DVec3, by: &Self) -> Self {
        let both = |p: [f64; 2], v: [f64; 2], factor: f64| [p[0] + factor * v[0], p[1] + factor * v[1]];
        let of =
            |p: Pair, v: Pair| [both(p[0], v[0], factor.x), both(p[1], v[1], factor.y), both(p[2], v[2], factor.z)];
        Self { pairs: [of(self.pairs[0], by.pairs[0]), of(self.pairs[1], by.pairs[1])] }
    }

    /// As lanes, by axis.
    #[inline(always)]
    pub(crate) fn lanes(&self) -> [f64x4; 3] {
        let lanes = |[a, b, c, d]: [f64; LANES]| f64x4(a, b, c, d);
        [lanes(self.along(0)), lanes(self.along(1)), lanes(self.along(2))]
    }

    /// From lanes, by axis.
    #[inline(always)]
    pub(crate) fn from_lanes([x, y, z]: [f64x4; 3]) -> Self {
        Self { pairs: [[[x.0, x.1], [y.0, y.1], [z.0, z.1]], [[x.2, x.3], [y.2, y.3], [z.2, z.3]]] }
    }
}

impl From<[DVec3; LANES]> for Points {
    #[inline(always)]
    fn from([a, b, c, d]: [DVec3; LANES]) -> Self {
        let pair = |a: DVec3, b: DVec3| [[a.x, b.x], [a.y, b.y], [a.z, b.z]];
        Self { pairs: [pair(a, b), pair(c, d)] }
    }
}
