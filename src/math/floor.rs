//! Rounding without a call of the C library, which it is where the build may not count on SSE4.1.

/// Adding this and taking it away again rounds to a whole number, up to 2^51.
pub(super) const TO_WHOLE: f64 = ((1_u64 << 52) + (1 << 51)) as f64;

/// The largest whole number not above `v`; infinities and NaN stay.
#[inline]
pub fn floor(v: f64) -> f64 {
    let size = v.abs();
    // From 2^52 on every number is whole.
    let near = if size < (1_u64 << 51) as f64 {
        round_to_even(v)
    } else if size < (1_u64 << 52) as f64 {
        v as i64 as f64
    } else {
        v
    };
    near - if near > v { 1.0 } else { 0.0 }
}

/// The same for numbers below 2^51, without asking whether they are: beyond, the result is off by a few units in the last
/// place of `v`, as whole numbers go.
#[inline(always)]
pub fn floor_small(v: f64) -> f64 {
    let near = round_to_even(v);
    near - if near > v { 1.0 } else { 0.0 }
}

/// The nearest whole number, for numbers below 2^51; halves go to the even one.
#[inline]
pub fn round_to_even(v: f64) -> f64 {
    (v + TO_WHOLE) - TO_WHOLE
}

/// The nearest whole number; halves go away from zero.
#[inline]
pub fn round(v: f64) -> f64 {
    let size = v.abs();
    let below = floor(size);
    (if size - below >= 0.5 { below + 1.0 } else { below }).copysign(v)
}

/// What a number is above the next whole one below it.
#[inline]
pub fn fraction(v: f64) -> f64 {
    v - floor(v)
}

/// The remainder of a whole number (below 2^50, or it is not exact) by `n`, from 0 up to `n`.
#[inline]
pub fn modulo(whole: f64, n: f64) -> f64 {
    whole - n * floor(whole / n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_as_the_library_does() {
        let up = |v: f64| [v.next_down(), v, v.next_up()];
        let sizes = (-60..64).map(|e| 2.0_f64.powi(e));
        let numbers = sizes.flat_map(|s| [s, 1.5 * s, 0.3 * s, 7.0 * s]).chain([0.0, 0.5, f64::INFINITY]).flat_map(up);
        for v in numbers.flat_map(|v| [v, -v]) {
            assert_eq!(floor(v), v.floor(), "{v:e}");
            assert!(v.abs() >= 2.0_f64.powi(51) || floor_small(v) == v.floor(), "{v:e}");
            assert_eq!(round(v), v.round(), "{v:e}");
        }
        assert!(floor(f64::NAN).is_nan());
    }

    #[test]
    fn remainders_are_those_of_whole_numbers() {
        for whole in (-20..20).chain([1 << 49, -(1 << 49) - 1]).map(|i: i64| i as f64) {
            assert!([2.0, 3.0, 6.0].iter().all(|n| modulo(whole, *n) == whole.rem_euclid(*n)), "{whole}");
        }
    }
}
