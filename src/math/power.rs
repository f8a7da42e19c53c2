//! Powers as scenes ask for them: mostly with whole exponents, which are products.

/// Largest whole exponent of a product. Its error is as many roundings, here 5e-13 of the value: far below what a colour
/// shows, for which these powers are.
const MOST_FACTORS: u32 = 1 << 12;

/// `base` raised to `exponent`, as [`f64::powf`] has it, but for rounding; quick for whole exponents and their halves.
///
/// ```
/// use whitted::math::power;
/// assert_eq!(power(3.0, 4.0), 81.0);
/// assert_eq!(power(4.0, 2.5), 32.0);
/// ```
#[inline]
pub fn power(base: f64, exponent: f64) -> f64 {
    // What is no number of factors becomes another number.
    let n = exponent as u32;
    if f64::from(n) == exponent && n <= MOST_FACTORS {
        return product(base, n);
    }
    if f64::from(n) + 0.5 == exponent && n <= MOST_FACTORS {
        return product(base, n) * base.sqrt();
    }
    base.powf(exponent)
}

/// So many factors, by squaring.
#[inline]
fn product(base: f64, mut n: u32) -> f64 {
    let (mut square, mut product) = (base, 1.0);
    loop {
        if n & 1 == 1 {
            product *= square;
        }
        n >>= 1;
        if n == 0 {
            return product;
        }
        square *= square;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The power is that of the C library but for as many roundings as it has factors.
    fn check(base: f64, exponent: f64) {
        let (found, expected) = (power(base, exponent), base.powf(exponent));
        let off = (found - expected).abs();
        assert!(found == expected || off <= exponent * f64::EPSILON * expected.abs(), "{base}^{exponent} is {found}");
    }

    #[test]
    fn powers_are_those_of_the_c_library() {
        for i in 0..=200 {
            let base = f64::from(i) / 64.0;
            [0.0, 1.0, 2.0, 3.0, 17.0, 40.0, 250.0, 4096.0, 0.5, 1.5, 2.5, 100.5].iter().for_each(|p| check(base, *p));
            [0.3, 1e-9, 5000.0, 1e300, 2.0f64.next_up()].iter().for_each(|p| check(base, *p));
        }
        assert_eq!(power(0.0, -1.0), f64::INFINITY);
        assert_eq!(power(2.0, -2.0), 0.25);
        assert!(power(-1.0, 0.5).is_nan() && power(0.5, f64::NAN).is_nan());
    }
}
