//! Intervals: numbers of which only bounds are known.
//!
//! Every operation encloses all results that its operands allow, the rounding of both ends
//! included. Bounds of both infinities mean that nothing is known: not even that there is a number.
//!
//! Source: Moore, Kearfott, Cloud, Introduction to Interval Analysis, 2009, chapters 2 and 5.

use crate::math::lesser;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The least.
    pub low: f64,
    /// The greatest.
    pub high: f64,
}

/// Twice the error of one correctly rounded operation, so that widening by it may round, too.
const ROUNDING: f64 = f64::EPSILON;

/// The same for C's mathematical library, whose results are off by one unit in the last place at
/// most, with a unit to spare.
const LIBRARY: f64 = 4.0 * f64::EPSILON;

/// Beyond this, an angle's place in its turn is not looked for.
const LARGEST_ANGLE: f64 = 1e6;

impl Interval {
    /// Nothing is known.
    pub const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// Nothing but zero.
    pub const ZERO: Self = Self::point(0.0);
    /// What a truth value may be.
    pub const EITHER: Self = Self { low: 0.0, high: 1.0 };

    /// One number.
    pub const fn point(v: f64) -> Self {
        Self { low: v, high: v }
    }

    /// From `low` to `high`; whole if these are no numbers or in the wrong order.
    #[inline]
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high { Self { low, high } } else { Self::WHOLE }
    }

    /// Bounds that were rounded once each.
    #[inline]
    fn rounded(low: f64, high: f64, error: f64) -> Self {
        Self::new(low - (low.abs() * error + f64::MIN_POSITIVE), high + (high.abs() * error + f64::MIN_POSITIVE))
    }

    /// Bounds that were added up. Sums do not underflow, so that one of numbers that are not negative stays so.
    #[inline]
    fn sum(low: f64, high: f64) -> Self {
        Self::new(low - low.abs() * ROUNDING, high + high.abs() * ROUNDING)
    }

    /// Around several numbers, each rounded; whole if any is none.
    fn around(values: [f64; 4], error: f64) -> Self {
        if values.iter().any(|v| v.is_nan()) {
            return Self::WHOLE;
        }
        let low = values.into_iter().fold(f64::INFINITY, f64::min);
        Self::rounded(low, values.into_iter().fold(f64::NEG_INFINITY, f64::max), error)
    }

    /// Whether nothing is known.
    #[inline]
    pub fn is_whole(&self) -> bool {
        *self == Self::WHOLE
    }

    /// Whether both ends are numbers.
    #[inline]
    pub fn is_bounded(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// The one number in it, if there is only one.
    pub fn single(&self) -> Option<f64> {
        (self.low == self.high).then_some(self.low)
    }

    /// Whether `v` lies in it.
    #[inline]
    pub fn contains(&self, v: f64) -> bool {
        self.low <= v && v <= self.high
    }

    /// The smallest interval around both.
    #[inline]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The largest magnitude.
    #[inline]
    pub fn magnitude(&self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Its square, which is never negative.
    #[inline]
    pub fn squared(self) -> Self {
        let (a, b) = (self.low * self.low, self.high * self.high);
        if self.contains(0.0) {
            return Self { low: 0.0, ..Self::rounded(0.0, a.max(b), ROUNDING) };
        }
        let widened = Self::rounded(a.min(b), a.max(b), ROUNDING);
        Self { low: widened.low.max(0.0), ..widened }
    }

    /// Its cube.
    #[inline]
    pub fn cubed(self) -> Self {
        let cube = |v: f64| v * v * v;
        Self::rounded(cube(self.low), cube(self.high), 2.0 * ROUNDING)
    }

    /// Magnitudes.
    #[inline]
    pub fn abs(self) -> Self {
        if self.contains(0.0) {
            Self { low: 0.0, high: self.magnitude() }
        } else {
            Self::new(self.low.abs().min(self.high.abs()), self.magnitude())
        }
    }

    /// Under a library function that rises everywhere in the interval.
    pub fn rising(self, f: impl Fn(f64) -> f64) -> Self {
        // What is too large for a number is at least the largest one.
        let (low, high) = (f(self.low), f(self.high));
        let low = if low == f64::INFINITY { f64::MAX } else { low };
        let high = if high == f64::NEG_INFINITY { f64::MIN } else { high };
        Self::rounded(low, high, LIBRARY)
    }

    /// Square roots; whole if there is any of a negative number.
    pub fn sqrt(self) -> Self {
        if self.low < 0.0 {
            return Self::WHOLE;
        }
        let root = Self::rounded(self.low.sqrt(), self.high.sqrt(), ROUNDING);
        Self { low: root.low.max(0.0), ..root }
    }

    /// Cosines.
    pub fn cos(self) -> Self {
        const RANGE: Interval = Interval { low: -1.0, high: 1.0 };
        if self.magnitude() > LARGEST_ANGLE {
            return if self.is_bounded() { RANGE } else { Self::WHOLE };
        }
        // A turning point that rounding moves past an end differs from that end in no digit.
        let turns_at = |angle: f64| ((self.low - angle) / TAU).ceil() * TAU + angle <= self.high;
        let (a, b) = (self.low.cos(), self.high.cos());
        let ends = Self::rounded(a.min(b), a.max(b), LIBRARY);
        Self {
            low: if turns_at(PI) { -1.0 } else { ends.low.max(-1.0) },
            high: if turns_at(0.0) { 1.0 } else { ends.high.min(1.0) },
        }
    }

    /// Sines.
    pub fn sin(self) -> Self {
        (self - Self::point(FRAC_PI_2)).cos()
    }

    /// Tangents; whole across a pole.
    pub fn tan(self) -> Self {
        let cos = self.cos();
        if cos.contains(0.0) || self.high - self.low >= PI { Self::WHOLE } else { self.rising(f64::tan) }
    }

    /// Angles of the points (x, y) with `self` as y; all angles across the cut behind the origin.
    pub fn atan2(self, x: Self) -> Self {
        if self.is_whole() || x.is_whole() {
            return Self::WHOLE;
        }
        if self.crosses_cut(&x) {
            return Self::rounded(-PI, PI, LIBRARY);
        }
        let corner = |y: f64, x: f64| y.atan2(x);
        Self::around(
            [corner(self.low, x.low), corner(self.low, x.high), corner(self.high, x.low), corner(self.high, x.high)],
            LIBRARY,
        )
    }

    /// Whether the points (x, y) with `self` as y may surround the origin or lie on both sides of the cut.
    pub fn crosses_cut(&self, x: &Self) -> bool {
        x.low <= 0.0 && self.contains(0.0)
    }

    /// Powers with an exponent known to be one number.
    pub fn powf(self, exponent: f64) -> Self {
        let whole = exponent == exponent.trunc() && exponent.abs() < 1e9;
        if exponent == 0.0 {
            return Self::point(1.0);
        }
        if self.low < 0.0 && !whole || exponent < 0.0 && self.contains(0.0) {
            return Self::WHOLE;
        }
        let (a, b) = (self.low.powf(exponent), self.high.powf(exponent));
        let ends = Self::rounded(a.min(b), a.max(b), LIBRARY);
        let even = whole && exponent % 2.0 == 0.0;
        let low = if even && self.contains(0.0) { 0.0 } else { ends.low };
        Self { low: if even || self.low >= 0.0 { low.max(0.0) } else { low }, ..ends }
    }

    /// Powers of positive numbers.
    pub fn pow(self, exponent: Self) -> Self {
        if self.low <= 0.0 || !exponent.is_bounded() {
            return Self::WHOLE;
        }
        let at = f64::powf;
        Self::around(
            [
                at(self.low, exponent.low),
                at(self.low, exponent.high),
                at(self.high, exponent.low),
                at(self.high, exponent.high),
            ],
            LIBRARY,
        )
    }

    /// Remainders of a division by one number, with the sign of the dividend.
    pub fn remainder(self, divisor: f64) -> Self {
        let (low, high, size) = (self.low % divisor, self.high % divisor, divisor.abs());
        if self.stays_in_step(low, high, size) {
            return Self::new(low, high);
        }
        let below = if self.low < 0.0 { -size } else { 0.0 };
        Self::new(below, if self.high > 0.0 { size } else { 0.0 })
    }

    /// Whether remainders `low` and `high` of the ends belong to the same quotient.
    pub fn stays_in_step(&self, low: f64, high: f64, size: f64) -> bool {
        low <= high && self.high - self.low < size
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::sum(self.low + o.low, self.high + o.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::sum(self.low - o.high, self.high - o.low)
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        if !self.is_bounded() || !o.is_bounded() {
            return Self::WHOLE;
        }
        // Finite numbers: no product is NaN, and comparisons may choose freely.
        let [a, b, c, d] = [self.low * o.low, self.low * o.high, self.high * o.low, self.high * o.high];
        let (low, high) = (lesser(lesser(a, b), lesser(c, d)), -lesser(lesser(-a, -b), lesser(-c, -d)));
        Self::rounded(low, high, ROUNDING)
    }
}

impl Div for Interval {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        if !self.is_bounded() || !o.is_bounded() || o.contains(0.0) {
            return Self::WHOLE;
        }
        Self::around([self.low / o.low, self.low / o.high, self.high / o.low, self.high / o.high], ROUNDING)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every value of `f` at points between must lie in `enclosed`, and the ends must not be far off.
    fn check(x: Interval, enclosed: Interval, f: impl Fn(f64) -> f64) {
        let values = (0..=1000).map(|i| f(x.low + (x.high - x.low) * f64::from(i) / 1000.0));
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for v in values {
            assert!(enclosed.contains(v), "{v} of {x:?} is not in {enclosed:?}");
            (low, high) = (low.min(v), high.max(v));
        }
        let slack = 0.01 * (high - low) + 1e-12;
        assert!(low - enclosed.low <= slack && enclosed.high - high <= slack, "{enclosed:?} for {low}..{high}");
    }

    #[test]
    fn functions_enclose_all_values_tightly() {
        for (low, high) in [(-1.0, 2.0), (0.5, 0.75), (-7.0, -6.5), (3.0, 3.5), (-0.25, 0.0), (6.0, 6.5)] {
            let x = Interval::new(low, high);
            check(x, x.squared(), |v| v * v);
            check(x, x.abs(), f64::abs);
            check(x, x.cos(), f64::cos);
            check(x, x.sin(), f64::sin);
            check(x, x.powf(3.0), |v| v.powf(3.0));
            check(x, x.powf(4.0), |v| v.powf(4.0));
            check(x, x * Interval::point(-3.0), |v| v * -3.0);
            check(x, x - Interval::point(0.1), |v| v - 0.1);
            check(x, x.remainder(10.0), |v| v % 10.0);
            check(x, x.atan2(Interval::point(1.5)), |v| v.atan2(1.5));
        }
        let positive = Interval::new(0.5, 4.0);
        check(positive, positive.sqrt(), f64::sqrt);
        check(positive, positive.powf(0.7), |v| v.powf(0.7));
        check(positive, positive.pow(Interval::point(-1.3)), |v| v.powf(-1.3));
        check(positive, Interval::point(1.0) / positive, |v| 1.0 / v);
    }

    #[test]
    fn what_has_no_value_everywhere_is_unknown() {
        let x = Interval::new(-1.0, 1.0);
        for unknown in
            [x.sqrt(), x.powf(0.5), x.powf(-1.0), x / x, x + Interval::WHOLE, Interval::ZERO * Interval::WHOLE]
        {
            assert!(unknown.is_whole(), "{unknown:?}");
        }
        assert!(Interval::new(1.0, 2.0).tan().is_whole());
    }
}
