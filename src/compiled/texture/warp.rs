//! Steps on the way of a lookup point into a pattern.

use crate::math::{DVec3, Transform};

/// One step, ready to apply to a point.
#[derive(Clone, Debug)]
pub enum Warp {
    /// Carries the point from the containing space inwards: `pattern_from_outer`.
    Affine(Transform),
    /// Repeats a slab along an axis.
    Repeat {
        /// 0 to 2.
        axis: usize,
        /// Width of the slab; may be negative.
        width: f32,
        /// Shift for each repetition.
        offset: DVec3,
        /// Axes that every other slab mirrors.
        flip: [bool; 3],
    },
}

impl Warp {
    /// Carries a point one step inwards.
    pub fn apply(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Affine(pattern_from_outer) => pattern_from_outer.point(p),
            Self::Repeat { axis, width, offset, flip } => repeat(p, *axis, *width, *offset, *flip),
        }
    }
}

fn repeat(mut p: DVec3, axis: usize, width: f32, offset: DVec3, flip: [bool; 3]) -> DVec3 {
    let n = (p[axis] / f64::from(width)).floor();
    // POV-Ray's product is in single precision.
    p[axis] -= f64::from(n as f32 * width);
    if n.rem_euclid(2.0) == 1.0 {
        for i in 0..3 {
            p[i] = if flip[i] { -p[i] } else { p[i] };
        }
        if flip[axis] {
            p[axis] += f64::from(width);
        }
    }
    p + n * offset
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(offset: DVec3, flip: [bool; 3], expected: [f64; 3]) {
        let warp = Warp::Repeat { axis: 0, width: 0.7, offset, flip };
        let found = warp.apply(DVec3::new(1.3, 0.7, -1.2));
        assert!((found - DVec3::from(expected)).abs().max_element() < 1e-8, "{found}");
    }

    #[test]
    fn repeat_is_that_of_povray() {
        check(DVec3::ZERO, [false; 3], [0.600000012, 0.7, -1.2]);
        check(DVec3::ZERO, [true, false, false], [0.099999976, 0.7, -1.2]);
        check(DVec3::new(0.1, 0.2, 0.0), [true, true, false], [0.199999976, -0.5, -1.2]);
    }
}
