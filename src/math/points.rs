//! Four points at once, for work in SIMD lanes.

use super::DVec3;
use bytemuck::cast;
use pulp::f64x4;

/// How many points are worked on at once.
pub const LANES: usize = 4;

/// What a function makes of each lane. Written out: `array::map` and `array::from_fn` are not always inlined, and hand
/// everything over by memory then.
#[inline(always)]
pub fn each_lane<T>(value: impl Fn(usize) -> T) -> [T; LANES] {
    [value(0), value(1), value(2), value(3)]
}

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

    /// By axis, those of all four points.
    #[inline(always)]
    pub fn coordinates(&self) -> [[f64; LANES]; 3] {
        self.coordinates
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

    /// What a function of an axis makes of each coordinate along it.
    #[inline(always)]
    #[must_use]
    pub fn map_coordinates(&self, value: impl Fn(usize, f64) -> f64) -> Self {
        let along = |axis: usize| each_lane(|i| value(axis, self.coordinates[axis][i]));
        Self { coordinates: [along(0), along(1), along(2)] }
    }

    /// The points moved by `factor` times some vectors.
    #[inline(always)]
    #[must_use]
    pub fn moved(&self, factor: DVec3, by: &Self) -> Self {
        let along = |axis: usize| each_lane(|i| self.coordinates[axis][i] + factor[axis] * by.coordinates[axis][i]);
        Self { coordinates: [along(0), along(1), along(2)] }
    }

    /// As lanes, by axis.
    #[inline(always)]
    pub(crate) fn lanes(&self) -> [f64x4; 3] {
        let [x, y, z] = self.coordinates;
        [cast(x), cast(y), cast(z)]
    }

    /// From lanes, by axis.
    #[inline(always)]
    pub(crate) fn from_lanes([x, y, z]: [f64x4; 3]) -> Self {
        Self { coordinates: [cast(x), cast(y), cast(z)] }
    }
}

impl From<[DVec3; LANES]> for Points {
    #[inline(always)]
    fn from([a, b, c, d]: [DVec3; LANES]) -> Self {
        Self { coordinates: [[a.x, b.x, c.x, d.x], [a.y, b.y, c.y, d.y], [a.z, b.z, c.z, d.z]] }
    }
}
