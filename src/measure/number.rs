//! Numbers as people read them.

/// Three digits: `0.0123`, `12.3`, `1.23·10⁻⁵`.
pub(crate) fn figure(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let exponent = value.abs().log10().floor() as i32;
    if (-5..=5).contains(&exponent) {
        format!("{value:.*}", (2 - exponent).max(0) as usize)
    } else {
        format!("{value:.2e}")
    }
}

/// Seconds with what a clock can tell.
pub(crate) fn seconds(value: f64) -> String {
    if value < 9.995 { format!("{value:.3} s") } else { format!("{value:.1} s") }
}

/// By how much the greatest is above the least.
pub(crate) fn spread(least: f64, greatest: f64) -> String {
    format!("+{:.0} %", 100.0 * (greatest / least.max(1e-9) - 1.0))
}

/// Three digits with a letter for thousands, millions, milliards.
pub(crate) fn count(n: u64) -> String {
    let steps = [(1e9, "G"), (1e6, "M"), (1e3, "k")];
    match steps.into_iter().find(|(step, _)| n as f64 >= *step) {
        Some((step, letter)) => format!("{} {letter}", figure(n as f64 / step)),
        None => n.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits() {
        let texts = [0.012345, 12.345, 123_456.0, 1.2345e-7, 0.0].map(figure);
        assert_eq!(texts, ["0.0123", "12.3", "123456", "1.23e-7", "0"]);
    }

    #[test]
    fn times_and_counts() {
        assert_eq!([seconds(0.01234), seconds(12.345)], ["0.012 s", "12.3 s"]);
        assert_eq!(spread(2.0, 2.5), "+25 %");
        assert_eq!([count(7), count(1234), count(123_456_789)], ["7", "1.23 k", "123 M"]);
    }
}
