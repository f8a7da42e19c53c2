//! Numbers and dates as text, as the C library formats them.

/// `%width.decimalsf`: zero padded for a negative width, six decimals for negative `decimals`.
///
/// Switches to the compact form where more than 254 characters would result.
/// Source: language facts, section 7 (`str`).
pub(super) fn fixed(value: f64, width: i32, decimals: i32) -> String {
    /// Longest result that POV-Ray formats with all its digits.
    const LONGEST: usize = 254;
    /// No string may grow without bound through its width.
    const WIDEST: usize = 10_000;
    let decimals = usize::try_from(decimals).unwrap_or(6).min(WIDEST);
    let size = (width.unsigned_abs() as usize).min(WIDEST);
    let text = if value.is_finite() { format!("{value:.decimals$}") } else { special(value) };
    if text.len().max(size) > LONGEST {
        return compact(value, 6);
    }
    if width < 0 && value.is_finite() {
        let (sign, digits) = text.strip_prefix('-').map_or(("", &*text), |digits| ("-", digits));
        let zeros = size.saturating_sub(text.len());
        return format!("{sign}{}{digits}", "0".repeat(zeros));
    }
    format!("{text:>size$}")
}

/// `%.{precision}g`: as few characters as needed for that many significant digits.
pub(super) fn compact(value: f64, precision: usize) -> String {
    if !value.is_finite() {
        return special(value);
    }
    let scientific = format!("{value:.*e}", precision.max(1) - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let shorten = |digits: &str| match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits.to_owned(),
    };
    if exponent < -4 || exponent >= precision as i32 {
        let sign = if exponent < 0 { '-' } else { '+' };
        return format!("{}e{sign}{:02}", shorten(mantissa), exponent.abs());
    }
    let decimals = usize::try_from(precision as i32 - 1 - exponent).unwrap_or(0);
    shorten(&format!("{value:.decimals$}"))
}

fn special(value: f64) -> String {
    let word = if value.is_nan() { "nan" } else { "inf" };
    if value.is_sign_negative() { format!("-{word}") } else { word.to_owned() }
}

/// `strftime` for a time in days since 2000-01-01 UTC; letters it does not know stay as they are.
pub fn date_time(days: f64, format: &str) -> String {
    const WEEKDAYS: [&str; 7] = ["Saturday", "Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday"];
    const MONTHS: [&str; 12] = [
        "January",
        "February",
        "March",
        "April",
        "May",
        "June",
        "July",
        "August",
        "September",
        "October",
        "November",
        "December",
    ];
    let seconds = (days * 86_400.0).round() as i64;
    let (day, second) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
    let (year, month, date) = civil(day);
    let (hour, minute, second) = (second / 3600, second / 60 % 60, second % 60);
    let weekday = WEEKDAYS[day.rem_euclid(7) as usize];
    let month_name = MONTHS[(month - 1) as usize];
    let day_of_year = day - day_number(year, 1, 1) + 1;
    let mut out = String::new();
    let mut rest = format.chars();
    while let Some(c) = rest.next() {
        if c != '%' {
            out.push(c);
            continue;
        }
        out += &match rest.next() {
            Some('Y') => year.to_string(),
            Some('y') => format!("{:02}", year.rem_euclid(100)),
            Some('m') => format!("{month:02}"),
            Some('d') => format!("{date:02}"),
            Some('e') => format!("{date:2}"),
            Some('H') => format!("{hour:02}"),
            Some('I') => format!("{:02}", (hour + 11) % 12 + 1),
            Some('M') => format!("{minute:02}"),
            Some('S') => format!("{second:02}"),
            Some('p') => (if hour < 12 { "AM" } else { "PM" }).to_owned(),
            Some('j') => format!("{day_of_year:03}"),
            Some('A') => weekday.to_owned(),
            Some('a') => weekday[..3].to_owned(),
            Some('B') => month_name.to_owned(),
            Some('b' | 'h') => month_name[..3].to_owned(),
            Some('D' | 'x') => format!("{month:02}/{date:02}/{:02}", year.rem_euclid(100)),
            Some('F') => format!("{year}-{month:02}-{date:02}"),
            Some('T' | 'X') => format!("{hour:02}:{minute:02}:{second:02}"),
            Some('R') => format!("{hour:02}:{minute:02}"),
            Some('c') => {
                format!("{} {} {date:2} {hour:02}:{minute:02}:{second:02} {year}", &weekday[..3], &month_name[..3])
            }
            Some('Z') => "UTC".to_owned(),
            Some('z') => "+0000".to_owned(),
            Some('n') => "\n".to_owned(),
            Some('t') => "\t".to_owned(),
            Some('%') => "%".to_owned(),
            Some(other) => format!("%{other}"),
            None => "%".to_owned(),
        };
    }
    out
}

/// Days from 2000-01-01 to a date. Source: the era method of the proleptic Gregorian calendar,
/// in which years start with March.
fn day_number(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    // 730425 days lie between 0000-03-01 and 2000-01-01.
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + of_year - 730_425
}

/// Year, month and day of a day number.
fn civil(number: i64) -> (i64, i64, i64) {
    // A year has 365.2425 days, so this is at most one off.
    let mut year = 2000 + (number as f64 / 365.2425).floor() as i64;
    while day_number(year, 1, 1) > number {
        year -= 1;
    }
    while day_number(year + 1, 1, 1) <= number {
        year += 1;
    }
    let month = (1..=12).rev().find(|m| day_number(year, *m, 1) <= number).unwrap_or(1);
    (year, month, number - day_number(year, month, 1) + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(got: &str, expected: &str) {
        assert_eq!(got, expected);
    }

    #[test]
    fn numbers_look_as_in_c() {
        check(&fixed(-7.24159, -8, 2), "-0007.24");
        check(&fixed(2.5, 0, 0), "2");
        check(&fixed(3.5, 6, 1), "   3.5");
        check(&fixed(1.0 / 3.0, 0, -1), "0.333333");
        check(&fixed(1e251, 0, 2), "1e+251");
        check(&fixed(f64::INFINITY, -5, 2), "  inf");
        check(&compact(123_456_789.0, 6), "1.23457e+08");
        check(&compact(1e-7, 6), "1e-07");
        check(&compact(1.0 / 3.0, 6), "0.333333");
        check(&compact(-0.0, 6), "-0");
        check(&compact(100_000.0, 6), "100000");
        check(&compact(0.0001, 6), "0.0001");
    }

    #[test]
    fn dates() {
        check(&date_time(0.0, "%Y-%m-%d %H:%M:%SZ"), "2000-01-01 00:00:00Z");
        check(&date_time(59.5, "%F %T %A %j %p"), "2000-02-29 12:00:00 Tuesday 060 PM");
        check(&date_time(366.0, "%d %b %y%%"), "01 Jan 01%");
        check(&date_time(-1.0, "%F"), "1999-12-31");
    }
}
