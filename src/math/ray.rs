//! Rays and the parameter range in which a hit counts.

use super::DVec3;

/// A half line `origin + t * direction`.
///
/// The direction is a unit vector where the camera or a bounce makes the ray.
/// Transforming a ray does not normalise it again, so `t` is the same number in
/// every space of the scene graph and means world distance.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where `t == 0`.
    pub origin: DVec3,
    /// Displacement per unit of `t`.
    pub direction: DVec3,
}

impl Ray {
    /// A ray as given; the direction is not normalised.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction }
    }

    /// The point at parameter `t`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// Open interval `min < t < max` of ray parameters.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// Excluded lower end.
    pub min: f64,
    /// Excluded upper end.
    pub max: f64,
}

impl Range {
    /// Everything in front of the origin.
    pub const FORWARD: Self = Self { min: 0.0, max: f64::INFINITY };
    /// The whole line.
    pub const LINE: Self = Self { min: f64::NEG_INFINITY, max: f64::INFINITY };
    /// Nothing at all.
    pub const EMPTY: Self = Self { min: f64::INFINITY, max: f64::NEG_INFINITY };

    /// Whether the ends are in the wrong order; an interval between neighbours may still hold nothing.
    pub fn is_empty(&self) -> bool {
        self.min > self.max
    }

    /// The part in which `start + t * speed` is not below `low` and not above `high`.
    pub fn between(&self, [low, high]: [f64; 2], start: f64, speed: f64) -> Self {
        if speed == 0.0 {
            return if start < low || start > high { Self::EMPTY } else { *self };
        }
        let (a, b) = ((low - start) / speed, (high - start) / speed);
        Self { min: self.min.max(a.min(b)), max: self.max.min(a.max(b)) }
    }

    /// Whether `t` lies strictly inside; false for NaN.
    pub fn contains(&self, t: f64) -> bool {
        self.min < t && t < self.max
    }
}
