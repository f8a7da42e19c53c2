//! Decimal numbers to floats.

/// Powers of ten that a float holds exactly, as far as they are needed here.
const POWERS: [f64; 16] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

/// The number at the start of a text, with its sign, and how many bytes it takes; the nearest float, too large is
/// infinite.
#[inline]
pub(crate) fn number(text: &[u8]) -> Option<(f64, usize)> {
    let sign = usize::from(matches!(text.first(), Some(b'+' | b'-')));
    let (value, length) = match short(&text[sign..]) {
        Some(short) => short,
        None => fast_float2::parse_partial::<f64, _>(&text[sign..]).ok()?,
    };
    Some((if text[0] == b'-' { -value } else { value }, sign + length))
}

/// A number of at most fifteen digits without an exponent, as most are: both the digits and the power of ten are
/// exact, so that their quotient is rounded once. Source: Clinger, How to Read Floating Point Numbers Accurately, 1990.
#[inline]
fn short(text: &[u8]) -> Option<(f64, usize)> {
    let (mut digits, mut point) = (0_u64, None);
    let mut length = 0;
    loop {
        match text.get(length) {
            Some(digit @ b'0'..=b'9') => digits = digits.wrapping_mul(10).wrapping_add(u64::from(digit - b'0')),
            Some(b'.') if point.is_none() => point = Some(length),
            Some(b'e' | b'E') => return None,
            _ => break,
        }
        length += 1;
    }
    let fraction = point.map_or(0, |point| length - point - 1);
    let n_digits = length - usize::from(point.is_some());
    (1..=15).contains(&n_digits).then(|| (digits as f64 / POWERS[fraction], length))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expected: Option<(f64, usize)>) {
        let bits = |(value, length): (f64, usize)| (value.to_bits(), length);
        assert_eq!(number(text.as_bytes()).map(bits), expected.map(bits), "{text}");
    }

    #[test]
    fn numbers_end_where_they_end() {
        check("1.2.3", Some((1.2, 3)));
        check("-.5,", Some((-0.5, 3)));
        check("+7", Some((7.0, 2)));
        check("-0>", Some((-0.0, 2)));
        check("5.", Some((5.0, 2)));
        check("1e3x", Some((1000.0, 3)));
        check("123456789012345678901234567890", Some((1.234_567_890_123_456_8e29, 30)));
        check("1e400", Some((f64::INFINITY, 5)));
        for nothing in ["", "-", ".", "x", "+."] {
            check(nothing, None);
        }
    }

    #[test]
    fn short_numbers_are_the_nearest_floats() {
        // Digits from a linear congruential generator, the point at every place.
        let mut state = 1_u64;
        for n_digits in 1..=15_u32 {
            for _ in 0..200 {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let digits = format!("{:0width$}", (state >> 8) % 10_u64.pow(n_digits), width = n_digits as usize);
                for point in 0..=digits.len() {
                    let text = format!("{}.{}", &digits[..point], &digits[point..]);
                    check(&text, text.parse().ok().map(|value| (value, text.len())));
                }
            }
        }
    }
}
