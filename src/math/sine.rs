//! Sines of four angles at a time.

use super::floor::TO_WHOLE;
use super::lanes::{Lanes, Work, dispatch};
use bytemuck::cast;
use pulp::f64x4;
use std::f64::consts::{FRAC_1_PI, PI};

/// Pi in three parts. The first has 33 bits and the second 20, so that their products with whole numbers below 2^20
/// are exact; the third is what the double constant lacks.
const PI_PARTS: [f64; 3] = {
    let first = f64::from_bits(PI.to_bits() & (u64::MAX << 20));
    [first, PI - first, 1.224_646_799_147_353_2e-16]
};

/// Larger angles go to the C library, one by one.
const LIMIT: f64 = (1 << 20) as f64 * 3.0;

/// Coefficients of the sine's Taylor series over the angle, by the square of the angle. The first term that is left out
/// is 1.2e-18 at a right angle.
const SERIES: [f64; 11] = {
    let mut series = [1.0; 11];
    let mut i = 1;
    while i < series.len() {
        series[i] = -series[i - 1] / ((2 * i) * (2 * i + 1)) as f64;
        i += 1;
    }
    series
};

/// The sines of angles, with errors below 4e-16: about four roundings of numbers up to 1, found by trial.
#[inline(always)]
pub(crate) fn sines<S: Lanes>(simd: S, angles: f64x4) -> f64x4 {
    if simd.reduce_max_f64s(simd.abs_f64s(angles)) > LIMIT {
        let f64x4(a, b, c, d) = angles;
        return f64x4(a.sin(), b.sin(), c.sin(), d.sin());
    }
    let halves = rounded(simd, simd.mul_f64s(angles, simd.splat_f64s(FRAC_1_PI)));
    // Exact but for the last part (Cody and Waite 1980, Software Manual for the Elementary Functions).
    let rest = simd.sub_f64s(angles, simd.mul_f64s(halves, simd.splat_f64s(PI_PARTS[0])));
    let rest = simd.sub_f64s(rest, simd.mul_f64s(halves, simd.splat_f64s(PI_PARTS[1])));
    let rest = simd.sub_f64s(rest, simd.mul_f64s(halves, simd.splat_f64s(PI_PARTS[2])));
    let square = simd.mul_f64s(rest, rest);
    let sine = simd.add_f64s(rest, simd.mul_f64s(simd.mul_f64s(rest, square), tail(simd, square)));
    // 1 after an odd number of half turns, 0 after an even one.
    let pairs = rounded(simd, simd.mul_f64s(halves, simd.splat_f64s(0.5)));
    let odd = simd.abs_f64s(simd.sub_f64s(halves, simd.add_f64s(pairs, pairs)));
    simd.mul_f64s(sine, simd.sub_f64s(simd.splat_f64s(1.0), simd.add_f64s(odd, odd)))
}

/// The sines of four angles, as [`sines`].
pub(crate) fn sines_of(angles: [f64; 4]) -> [f64; 4] {
    dispatch(Sines(angles))
}

struct Sines([f64; 4]);

impl Work for Sines {
    type Output = [f64; 4];

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> [f64; 4] {
        cast(sines(simd, cast(self.0)))
    }
}

/// The series from its second term on; not one term after the other, which takes three times as long.
#[inline(always)]
fn tail<S: Lanes>(simd: S, z: f64x4) -> f64x4 {
    let z2 = simd.mul_f64s(z, z);
    let z4 = simd.mul_f64s(z2, z2);
    let low = simd.add_f64s(two_terms(simd, 1, z), simd.mul_f64s(two_terms(simd, 3, z), z2));
    let middle = simd.add_f64s(two_terms(simd, 5, z), simd.mul_f64s(two_terms(simd, 7, z), z2));
    let high = two_terms(simd, 9, z);
    simd.add_f64s(low, simd.mul_f64s(simd.add_f64s(middle, simd.mul_f64s(high, z4)), z4))
}

#[inline(always)]
fn two_terms<S: Lanes>(simd: S, first: usize, z: f64x4) -> f64x4 {
    simd.add_f64s(simd.splat_f64s(SERIES[first]), simd.mul_f64s(simd.splat_f64s(SERIES[first + 1]), z))
}

#[inline(always)]
fn rounded<S: Lanes>(simd: S, v: f64x4) -> f64x4 {
    simd.sub_f64s(simd.add_f64s(v, simd.splat_f64s(TO_WHOLE)), simd.splat_f64s(TO_WHOLE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar256b;

    /// As the sines promise.
    const ERROR: f64 = 4e-16;

    #[test]
    fn sines_are_those_of_the_library_on_every_processor() {
        for i in -20_000..20_000 {
            let a = f64::from(i);
            let angles = [0.013 * a, 0.5 * PI * a, 27.1 * a, 173.3 * a];
            let found = sines_of(angles);
            assert_eq!(found, Sines(angles).run(Scalar256b), "{angles:?}");
            for (angle, sine) in angles.into_iter().zip(found) {
                assert!((sine - angle.sin()).abs() < ERROR, "{sine} instead of {} at {angle}", angle.sin());
            }
        }
    }
}
