//! Rays against boxes in double precision.

use crate::math::{Bounds, DVec3, Range, Ray, gamma};

/// A ray prepared for boxes.
pub(super) struct SlabRay<'a> {
    pub(super) ray: &'a Ray,
    /// Reciprocals of the direction.
    inverse: DVec3,
}

impl<'a> SlabRay<'a> {
    pub(super) fn new(ray: &'a Ray) -> Self {
        Self { ray, inverse: ray.direction.recip() }
    }

    /// The part of a range that may be inside a box; errs on the side of more.
    pub(super) fn within(&self, b: &Bounds, range: Range) -> Range {
        if b.min.x == f64::NEG_INFINITY && *b == Bounds::INFINITE {
            return range;
        }
        let (mut low, mut high) = (range.min, range.max);
        for axis in 0..3 {
            let (o, inverse) = (self.ray.origin[axis], self.inverse[axis]);
            // Rounding of a point on the ray and of what follows here.
            let min = b.min[axis] - gamma(16) * (b.min[axis].abs() + o.abs());
            let max = b.max[axis] + gamma(16) * (b.max[axis].abs() + o.abs());
            if inverse.is_finite() {
                let (near, far) = if inverse < 0.0 { (max, min) } else { (min, max) };
                let (enter, leave) = ((near - o) * inverse, (far - o) * inverse);
                // NaN, from infinite bounds, leaves the interval as it is.
                low = if enter > low { enter } else { low };
                high = if leave < high { leave } else { high };
            } else if o < min || o > max {
                return Range::EMPTY;
            }
        }
        Range { min: low, max: high }
    }

    /// Whether the ray may meet a box within a range; errs on the side of yes.
    pub(super) fn may_meet(&self, b: &Bounds, range: Range) -> bool {
        !self.within(b, range).is_empty()
    }
}
