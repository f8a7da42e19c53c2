//! Four points at once, for work in SIMD lanes.

use super::DVec3;
use bytemuck::cast;
use pulp::f64x4;

/// How many points are worked on at once.
pub const LANES: usize = 4;

/// Four points, a coordinate of all four side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Points {
    /// By axis.
    coordinates: [[f64; LANES]; 3],
}

impl Points {
    /// The point in one lane.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> DVec3 {
        let [x, y, z] = &self.coordinates;
        DVec3::new(x[i], y[i], z[i])
    }

    /// What a function makes of each point.
    #[inline(always)]
    pub fn map<T>(&self, value: impl Fn(DVec3) -> T) -> [T; LANES] {
        std::array::from_fn(|i| value(self.lane(i)))
    }

    /// What a function of an axis makes of each coordinate along it.
    #[inline(always)]
    #[must_use]
    pub fn map_coordinates(&self, value: impl Fn(usize, f64) -> f64) -> Self {
        let along = |axis: usize| std::array::from_fn(|i| value(axis, self.coordinates[axis][i]));
        Self { coordinates: [along(0), along(1), along(2)] }
    }

    /// The points moved by `factor` times some vectors.
    #[inline(always)]
    #[must_use]
    pub fn moved(&self, factor: DVec3, by: &Self) -> Self {
        let along = |axis: usize| {
            std::array::from_fn(|i| self.coordinates[axis][i] + factor[axis] * by.coordinates[axis][i])
        };
        Self { coordinates: [along(0), along(1), along(2)] }
    }

    /// As lanes, by axis.
    #[inline(always)]
    pub(crate) fn lanes(&self) -> [f64x4; 3] {
        self.coordinates.map(cast)
    }

    /// From lanes, by axis.
    #[inline(always)]
    pub(crate) fn from_lanes(lanes: [f64x4; 3]) -> Self {
        Self { coordinates: lanes.map(cast) }
    }
}

impl From<[DVec3; LANES]> for Points {
    #[inline(always)]
    fn from(points: [DVec3; LANES]) -> Self {
        Self { coordinates: std::array::from_fn(|axis| points.map(|p| p[axis])) }
    }
}
