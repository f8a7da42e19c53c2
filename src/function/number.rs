//! What the internal functions ask of a number, so that one formula serves values and bounds.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or bounds of one.
pub(super) trait Number:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    fn constant(v: f64) -> Self;
    fn squared(self) -> Self;
    fn cubed(self) -> Self;
    fn sqrt(self) -> Self;
    fn exp(self) -> Self;
    fn sin(self) -> Self;
    fn cos(self) -> Self;
    fn abs(self) -> Self;
    fn powf(self, n: f64) -> Self;
    /// The angle of (x, `self`).
    fn atan2(self, x: Self) -> Self;
    fn min(self, o: Self) -> Self;
    fn max(self, o: Self) -> Self;
    /// With the sign of the dividend.
    fn remainder(self, divisor: f64) -> Self;
    /// Never negative.
    fn positive_remainder(self, divisor: f64) -> Self;
    /// `step` instead where both `self` and `z` are 0.
    fn off_axis(self, z: Self, step: f64) -> Self;
}

impl Number for f64 {
    fn constant(v: f64) -> Self {
        v
    }
    fn squared(self) -> Self {
        self * self
    }
    fn cubed(self) -> Self {
        self * self * self
    }
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn exp(self) -> Self {
        self.exp()
    }
    fn sin(self) -> Self {
        self.sin()
    }
    fn cos(self) -> Self {
        self.cos()
    }
    fn abs(self) -> Self {
        self.abs()
    }
    fn powf(self, n: f64) -> Self {
        self.powf(n)
    }
    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }
    fn min(self, o: Self) -> Self {
        self.min(o)
    }
    fn max(self, o: Self) -> Self {
        self.max(o)
    }
    fn remainder(self, divisor: f64) -> Self {
        self % divisor
    }
    fn positive_remainder(self, divisor: f64) -> Self {
        self.rem_euclid(divisor)
    }
    fn off_axis(self, z: Self, step: f64) -> Self {
        if self == 0.0 && z == 0.0 { step } else { self }
    }
}
