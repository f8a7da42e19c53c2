//! What stands behind a key or a switch, by POV-Ray's rules for numbers and words.
//!
//! Source: command line facts, section 1.

/// What a key takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Takes {
    /// On or off.
    Bool,
    /// A whole number; a decimal part is cut off.
    Whole,
    /// A number.
    Real,
    /// A number, or the word `sRGB`.
    Gamma,
    /// A word.
    Word,
    /// The name of a file or folder.
    Name,
}

/// A value as it was understood.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Bool(bool),
    Whole(i64),
    Real(f64),
    Text(String),
}

impl Takes {
    /// Understands a text, or says what was expected.
    pub(super) fn value(self, text: &str) -> Result<Value, &'static str> {
        match self {
            Self::Bool => Ok(Value::Bool(is_on(text))),
            Self::Whole => whole(text).map(Value::Whole).ok_or("expected a whole number"),
            Self::Real => real(text).map(Value::Real).ok_or("expected a number"),
            Self::Gamma if text.eq_ignore_ascii_case("srgb") => Ok(Value::Text("sRGB".into())),
            Self::Gamma => real(text).map(Value::Real).ok_or("expected a number or sRGB"),
            Self::Word | Self::Name if text.is_empty() => Err("expected a name"),
            Self::Word | Self::Name => Ok(Value::Text(text.into())),
        }
    }
}

impl Value {
    pub(super) fn on(&self) -> bool {
        matches!(self, Self::Bool(true))
    }

    pub(super) fn whole(&self) -> i64 {
        if let Self::Whole(number) = *self { number } else { 0 }
    }

    pub(super) fn real(&self) -> f64 {
        match *self {
            Self::Real(number) => number,
            Self::Whole(number) => number as f64,
            _ => 0.0,
        }
    }

    pub(super) fn text(&self) -> &str {
        if let Self::Text(text) = self { text } else { "" }
    }

    /// As Create_Ini writes it.
    pub(super) fn written(&self, takes: Takes) -> String {
        match self {
            Self::Bool(on) => if *on { "On" } else { "Off" }.into(),
            Self::Whole(number) => number.to_string(),
            Self::Real(number) => number.to_string(),
            Self::Text(text) if takes == Takes::Name => format!("\"{text}\""),
            Self::Text(text) => text.clone(),
        }
    }
}

/// Every word but these is off.
fn is_on(text: &str) -> bool {
    ["on", "true", "yes", "1"].iter().any(|word| text.eq_ignore_ascii_case(word))
}

/// A whole number at the start of a text; what follows it is dropped.
fn whole(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    let number: i64 = digits[..end].parse().ok()?;
    Some(if text.starts_with('-') { -number } else { number })
}

/// A number at the start of a text, as C reads it; what follows it is dropped.
pub(super) fn real(text: &str) -> Option<f64> {
    let (number, _) = fast_float2::parse_partial::<f64, _>(text.strip_prefix('+').unwrap_or(text)).ok()?;
    number.is_finite().then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_lose_what_follows() {
        let probes = [("8", Some(8)), ("3.7", Some(3)), ("1.6e2", Some(1)), ("8x6", Some(8)), ("-8x", Some(-8))];
        for (text, expected) in probes.into_iter().chain([("+8", Some(8)), ("8,6", Some(8)), ("abc", None), ("", None)])
        {
            assert_eq!(whole(text), expected, "{text}");
        }
    }

    #[test]
    fn numbers_lose_what_follows() {
        let probes =
            [("0.3x", Some(0.3)), (".5", Some(0.5)), ("-0.5", Some(-0.5)), ("5e-1", Some(0.5)), ("1x", Some(1.0))];
        for (text, expected) in probes.into_iter().chain([("abc", None), ("", None), ("inf", None), ("nan", None)]) {
            assert_eq!(real(text), expected, "{text}");
        }
    }

    #[test]
    fn few_words_are_on() {
        for (text, expected) in
            [("on", true), ("TRUE", true), ("yes", true), ("1", true), ("maybe", false), ("", false)]
        {
            assert_eq!(is_on(text), expected, "{text}");
        }
    }
}
