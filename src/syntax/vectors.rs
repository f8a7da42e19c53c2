//! Literal vectors, read straight from the text.
//!
//! A mesh of a million triangles is seventy megabytes of `<x,y,z>,<x,y,z>,…`. These
//! runs are recognised here without the parser, kept as one token, and turned into
//! numbers one vector at a time when they are asked for.

use super::numbers::number;

/// Where the run of vectors that starts at `start` ends; `None` if none starts there.
///
/// Accepts exactly what the rule `vectors` of the grammar accepts.
pub fn run_end(text: &[u8], start: usize) -> Option<usize> {
    let mut end = vector_end(text, start)?;
    loop {
        let comma = skip_blanks(text, end);
        if text.get(comma) != Some(&b',') {
            return Some(end);
        }
        match vector_end(text, skip_blanks(text, comma + 1)) {
            Some(next) => end = next,
            None => return Some(end),
        }
    }
}

/// Reads the vector that starts at `start` of a run: its components, how many there are, and
/// where the next one starts (or the end of the text).
pub fn read_vector(text: &[u8], start: usize) -> ([f64; 5], u8, usize) {
    let (mut components, mut n, mut at) = ([0.0; 5], 0, start + 1);
    loop {
        at = skip_blanks(text, at);
        let Some((value, length)) = number(&text[at..]) else { break };
        if n < 5 {
            components[n] = value;
            n += 1;
        }
        at = skip_blanks(text, at + length) + 1;
        if text.get(at - 1) != Some(&b',') {
            break;
        }
    }
    (components, n as u8, at.min(text.len()))
}

/// One past the `>` of the vector literal at `start`, if one stands there.
fn vector_end(text: &[u8], start: usize) -> Option<usize> {
    if text.get(start) != Some(&b'<') {
        return None;
    }
    let mut at = start + 1;
    for n in 1..=5 {
        at = skip_blanks(text, number_end(text, skip_blanks(text, at))?);
        match text.get(at) {
            Some(b',') => at += 1,
            Some(b'>') if n > 1 && text.get(at + 1) != Some(&b'=') => return Some(at + 1),
            _ => return None,
        }
    }
    None
}

/// One past the signed number at `start`, if one stands there.
fn number_end(text: &[u8], start: usize) -> Option<usize> {
    let mut at = start + usize::from(matches!(text.get(start), Some(b'+' | b'-')));
    let whole = at;
    at = skip_digits(text, at);
    let mut any = at > whole;
    if text.get(at) == Some(&b'.') {
        let fraction = at + 1;
        at = skip_digits(text, fraction);
        any |= at > fraction;
    }
    if !any {
        return None;
    }
    if matches!(text.get(at), Some(b'e' | b'E')) {
        let digits = at + 1 + usize::from(matches!(text.get(at + 1), Some(b'+' | b'-')));
        at = skip_digits(text, digits);
        if at == digits {
            return None;
        }
    }
    Some(at)
}

fn skip_digits(text: &[u8], mut at: usize) -> usize {
    while text.get(at).is_some_and(u8::is_ascii_digit) {
        at += 1;
    }
    at
}

/// Where the blanks that start at `at` end.
#[inline]
pub(super) fn skip_blanks(text: &[u8], mut at: usize) -> usize {
    while matches!(text.get(at), Some(b' ' | b'\n' | b'\t' | b'\r')) {
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, run: Option<&str>) {
        assert_eq!(run_end(text.as_bytes(), 0).map(|end| &text[..end]), run, "{text}");
    }

    #[test]
    fn runs_end_with_their_last_whole_vector() {
        check("<1,2,3>", Some("<1,2,3>"));
        check("<1, -2.5e3 ,\n+.3> , <1,2>,3", Some("<1, -2.5e3 ,\n+.3> , <1,2>"));
        check("<1,2>,<1,2,x>", Some("<1,2>"));
        check("<1,2>=3", None);
        check("<1>", None);
        check("<1,2,3,4,5,6>", None);
        check("<1 -1, 2>", None);
        check("<1,2,>", None);
        check("<1e,2>", None);
    }

    #[test]
    fn vectors_read_as_numbers() {
        let text = b"<1, -2.5e3 ,\n+.3> ,";
        assert_eq!(read_vector(text, 0), ([1.0, -2500.0, 0.3, 0.0, 0.0], 3, 17));
        assert_eq!(read_vector(b"<1,2", 0).1, 2);
    }
}
