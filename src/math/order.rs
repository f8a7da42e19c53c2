//! The smaller and the larger of two numbers, neither of them NaN: one instruction each, where `f64::min` and `f64::max`
//! have to ask for NaN.

/// The smaller number.
#[inline(always)]
pub fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The larger number.
#[inline(always)]
pub fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
