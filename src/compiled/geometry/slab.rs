//! Rays against boxes in double precision.

use crate::math::{Bounds, DVec3, Range, Ray, gamma};

/// What a coordinate of a point on a ray may be off by, as a part of the larger of what goes into it.
const ROUNDING: f64 = gamma(32);

/// A ray prepared for boxes.
pub(super) struct SlabRay<'a> {
    pub(super) ray: &'a Ray,
    /// Reciprocals of the direction.
    inverse: DVec3,
    /// The origin, moved up by its rounding to where lower planes are compared with it, and down for upper ones.
    above: DVec3,
    below: DVec3,
}

impl<'a> SlabRay<'a> {
    pub(super) fn new(ray: &'a Ray) -> Self {
        let rounding = ROUNDING * ray.origin.abs();
        Self { ray, inverse: ray.direction.recip(), above: ray.origin + rounding, below: ray.origin - rounding }
    }

    /// The part of a range that may be inside a box; errs on the side of more.
    pub(super) fn within(&self, b: &Bounds, range: Range) -> Range {
        if b.min.x == f64::NEG_INFINITY && *b == Bounds::INFINITE {
            return range;
        }
        let (lower, upper) = ((b.min - self.above) * self.inverse, (b.max - self.below) * self.inverse);
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let goes_down = self.inverse[axis] < 0.0;
            let enter = if goes_down { upper[axis] } else { lower[axis] };
            let leave = if goes_down { lower[axis] } else { upper[axis] };
            // NaN, of a ray within a side of the box, leaves the interval as it is.
            low = if enter > low { enter } else { low };
            high = if leave < high { leave } else { high };
        }
        // Along an axis beside the box.
        if low == f64::INFINITY || high == f64::NEG_INFINITY {
            return Range::EMPTY;
        }
        // What planes far from the origin are off by is a part of the way to them.
        low *= 1.0 - ROUNDING.copysign(low);
        high *= 1.0 + ROUNDING.copysign(high);
        Range {
            min: if low > range.min { low } else { range.min },
            max: if high < range.max { high } else { range.max },
        }
    }

    /// Whether the ray may meet a box within a range; errs on the side of yes.
    pub(super) fn may_meet(&self, b: &Bounds, range: Range) -> bool {
        !self.within(b, range).is_empty()
    }
}
