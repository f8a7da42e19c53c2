//! Pigments and patterns as functions of a point.

use super::pattern::{Context, Pattern};
use super::pigment::Pigment;
use crate::function::{Callable, External};
use crate::math::DVec3;

/// What a function may call beside itself.
#[derive(Clone, Debug)]
pub enum PointFunction {
    /// Red, green, blue, filter and transmit at a point.
    Pigment(Pigment),
    /// One value at a point.
    Pattern(Pattern),
}

impl External for PointFunction {
    fn width(&self) -> usize {
        match self {
            Self::Pigment(_) => 5,
            Self::Pattern(_) => 1,
        }
    }
}

impl Callable for PointFunction {
    fn call(&self, args: &[f64]) -> [f64; 5] {
        let at = |i: usize| args.get(i).copied().unwrap_or(0.0);
        let point = DVec3::new(at(0), at(1), at(2));
        match self {
            Self::Pigment(pigment) => pigment.color_or_clear(point, &Context::default()).to_array(),
            Self::Pattern(pattern) => [pattern.value(point, &Context::default()), 0.0, 0.0, 0.0, 0.0],
        }
    }
}
