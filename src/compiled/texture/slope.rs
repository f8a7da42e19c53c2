//! Slope: which way the surface faces.
//!
//! Source: section 8 of the pattern facts (measured).

use super::Context;
use crate::math::DVec3;

/// What the normal is compared with.
#[derive(Clone, Copy, Debug)]
pub enum SlopeAxis {
    /// A unit vector.
    Direction(DVec3),
    /// The direction to a point of the world.
    Towards(DVec3),
}

/// The slope pattern with its ranges.
#[derive(Clone, Debug)]
pub struct Slope {
    /// What the normal is compared with.
    pub axis: SlopeAxis,
    /// What becomes 0 and 1; equal bounds leave the value.
    pub range: [f64; 2],
    /// Share of the slope, unit axis of the altitude and its range.
    pub altitude: Option<(f64, DVec3, [f64; 2])>,
}

fn rescaled(v: f64, [low, high]: [f64; 2]) -> f64 {
    if high - low == 0.0 { v } else { (v - low) / (high - low) }
}

/// Keeps exactly 1 below 1, as POV-Ray does.
const BELOW_ONE: f64 = 1e-10;

impl Slope {
    /// The value at a point of the pattern's space.
    pub(super) fn value(&self, p: DVec3, context: &Context) -> f64 {
        let axis = match self.axis {
            SlopeAxis::Direction(v) => v,
            SlopeAxis::Towards(q) => (q - context.point).normalize_or_zero(),
        };
        let normal = context.shading_normal();
        if normal == DVec3::ZERO {
            return 0.0; // not on a surface
        }
        let cosine = normal.dot(axis).clamp(-1.0, 1.0);
        let slope = rescaled(0.5 * (1.0 + cosine.asin() * 2.0 / std::f64::consts::PI), self.range);
        let wrapped = |v: f64| if v < 0.0 { 1.0 + v.fract() } else { v.fract() };
        let Some((share, up, range)) = self.altitude else {
            return if slope == 1.0 { 1.0 - BELOW_ONE } else { wrapped(slope) };
        };
        let v = share * slope + (1.0 - share) * rescaled(p.dot(up), range);
        if (1.0..1.0 + BELOW_ONE).contains(&v) { v - BELOW_ONE } else { wrapped(v) }
    }
}
