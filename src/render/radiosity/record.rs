//! Light known at one place, and how well it says what another place gets.
//!
//! Source: radiosity facts, section 5 (measured).

use crate::math::{DVec3, Rgb};

/// POV-Ray's distance within which two points are the same.
const SAME_POINT: f64 = 1e-6;

/// How far in front of a point, as a cosine, a record may lie and still count in full, and not at all.
const IN_FRONT: [f64; 2] = [0.0, -0.05];

/// POV-Ray's weight from which on a record counts.
const LEAST_WEIGHT: f64 = 0.001;

/// The light that falls on a place from everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct Record {
    /// World space.
    pub(in crate::render) point: DVec3,
    /// Unit, on the lit side.
    pub(in crate::render) normal: DVec3,
    /// Harmonic mean distance of what is seen from here.
    pub(in crate::render) mean_distance: f32,
    /// Distance of the nearest of it.
    pub(in crate::render) nearest: f32,
    /// Unit direction of that; 0 if nothing is seen at all.
    pub(in crate::render) toward_nearest: DVec3,
    /// Mean light over the cosine-weighted half space.
    pub(in crate::render) light: Rgb,
    /// How much it counts: less where light of further bounces was known badly.
    pub(in crate::render) quality: f32,
}

/// A place that asks for light.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Question {
    /// World space.
    pub(in crate::render) point: DVec3,
    /// Unit, on the lit side.
    pub(in crate::render) normal: DVec3,
    /// Largest error that is let pass.
    pub(in crate::render) error: f64,
    /// Records count by a smooth curve instead of a straight line.
    pub(in crate::render) is_smooth: bool,
}

/// Light from several records.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::render) struct Blend {
    light: Rgb,
    weight: f64,
}

impl Blend {
    /// Takes in light by weight.
    pub(in crate::render) fn add(&mut self, light: Rgb, weight: f64) {
        self.light += light * weight as f32;
        self.weight += weight;
    }

    /// Sum of all weights.
    pub(in crate::render) fn weight(&self) -> f64 {
        self.weight
    }

    /// Weighted mean; black if there is nothing.
    pub(in crate::render) fn mean(&self) -> Rgb {
        if self.weight > 0.0 { self.light / self.weight as f32 } else { Rgb::ZERO }
    }
}

impl Question {
    /// Whether a record with that mean distance is near enough to say anything.
    #[inline]
    pub(in crate::render) fn is_within(&self, point: DVec3, mean_distance: f32) -> bool {
        (self.point - point).length_squared() < (f64::from(mean_distance) * self.error).powi(2)
    }
}

impl Record {
    /// How much the record says about another place; `None` for nothing.
    #[inline]
    pub(in crate::render) fn weight(&self, asked: &Question) -> Option<f64> {
        let shift = asked.point - self.point;
        if !asked.is_within(self.point, self.mean_distance) {
            return None;
        }
        let mean = f64::from(self.mean_distance);
        let distance = shift.length();
        let is_apart = distance > SAME_POINT;
        let mut reach = mean;
        if is_apart {
            let toward = self.toward_nearest.dot(shift) / distance;
            if toward > 0.0 {
                reach = toward * f64::from(self.nearest) + (1.0 - toward) * mean;
            }
        }
        let error = distance / reach + 2.0 * (1.0 - asked.normal.dot(self.normal)).abs().sqrt();
        if distance >= reach * asked.error || error >= asked.error {
            return None;
        }
        let ahead = match is_apart {
            true => shift.dot((asked.normal + self.normal).normalize_or(asked.normal)) / distance,
            false => 1.0,
        };
        if ahead <= IN_FRONT[1] {
            return None;
        }
        let share = error / asked.error;
        let mut weight = match asked.is_smooth {
            true if share < 0.5 => 1.0 - 2.0 * share * share,
            true => 2.0 * (1.0 - share).powi(2),
            false => 1.0 - share,
        };
        if ahead <= IN_FRONT[0] {
            weight *= 1.0 - ahead / IN_FRONT[1];
        }
        (weight > LEAST_WEIGHT).then_some(weight * f64::from(self.quality))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RECORD: Record = Record {
        point: DVec3::ZERO,
        normal: DVec3::Y,
        mean_distance: 1.0,
        nearest: 0.5,
        toward_nearest: DVec3::X,
        light: Rgb::ONE,
        quality: 0.5,
    };

    fn check(point: [f64; 3], normal: DVec3, is_smooth: bool, expected: Option<f64>) {
        let asked = Question { point: DVec3::from(point), normal, error: 0.5, is_smooth };
        let found = RECORD.weight(&asked);
        let agrees = match (found, expected) {
            (Some(a), Some(b)) => (a - b).abs() < 1e-9,
            (a, b) => a == b,
        };
        assert!(agrees, "{point:?}: {found:?} instead of {expected:?}");
    }

    #[test]
    fn a_record_counts_nearby_on_the_same_side() {
        check([0.0; 3], DVec3::Y, false, Some(0.5));
        check([-0.25, 0.0, 0.0], DVec3::Y, false, Some(0.25));
        check([-0.1, 0.0, 0.0], DVec3::Y, true, Some(0.5 * (1.0 - 2.0 * 0.04)));
        check([0.1, 0.0, 0.0], DVec3::Y, true, Some(0.5 * (1.0 - 2.0 * 0.16)));
        // Half way to what is nearest.
        check([0.25, 0.0, 0.0], DVec3::Y, false, None);
        check([-0.6, 0.0, 0.0], DVec3::Y, false, None);
        check([0.0; 3], DVec3::X, false, None);
        check([-0.2, -0.1, 0.0], DVec3::Y, false, None);
    }
}
