//! Numbers that read back to the same bits, as short as they can be.

use crate::math::{Color, DVec2, DVec3, DVec4, Rgb};
use std::fmt::Write as _;

/// Adds a double: the shortest decimals that name it and no other.
///
/// What is infinite is written as a number too large for a double, which every reader takes for infinity. POV-Ray's
/// numbers know no NaN and neither does the language, so none comes here.
pub(super) fn push_f64(out: &mut String, value: f64) {
    // Writing to a string cannot fail.
    let _ = match value.abs() {
        _ if value.is_nan() => write!(out, "0"),
        f64::INFINITY => write!(out, "{}1e999", if value < 0.0 { "-" } else { "" }),
        0.0 | 1e-5..1e16 => write!(out, "{value}"),
        _ => write!(out, "{value:e}"),
    };
}

/// Adds a float: the shortest decimals that become it when they are read as a double and rounded.
pub(super) fn push_f32(out: &mut String, value: f32) {
    let start = out.len();
    let plain = value == 0.0 || (1e-5..1e16).contains(&value.abs());
    let _ = if plain { write!(out, "{value}") } else { write!(out, "{value:e}") };
    // Decimals that lie between two floats may be rounded the other way on their way through a double.
    if out[start..].parse::<f64>().is_ok_and(|read| (read as f32).to_bits() != value.to_bits()) || !value.is_finite() {
        out.truncate(start);
        push_f64(out, f64::from(value));
    }
}

/// A double as text.
pub(super) fn double(value: f64) -> String {
    let mut out = String::new();
    push_f64(&mut out, value);
    out
}

/// A float as text.
pub(super) fn float(value: f32) -> String {
    let mut out = String::new();
    push_f32(&mut out, value);
    out
}

/// Numbers in angle brackets.
pub(super) fn push_vector(out: &mut String, components: &[f64]) {
    push_list(out, components, push_f64);
}

/// Floats in angle brackets.
pub(super) fn push_floats(out: &mut String, components: &[f32]) {
    push_list(out, components, push_f32);
}

fn push_list<T: Copy>(out: &mut String, components: &[T], push: fn(&mut String, T)) {
    for (i, component) in components.iter().enumerate() {
        out.push_str(if i == 0 { "<" } else { ", " });
        push(out, *component);
    }
    out.push('>');
}

fn bracketed(components: &[f64]) -> String {
    let mut out = String::new();
    push_vector(&mut out, components);
    out
}

/// `<x, y, z>`.
pub(super) fn vector(v: DVec3) -> String {
    bracketed(&v.to_array())
}

/// `<x, y>`.
pub(super) fn vector2(v: DVec2) -> String {
    bracketed(&v.to_array())
}

/// `<x, y, z, w>`.
pub(super) fn vector4(v: DVec4) -> String {
    bracketed(&v.to_array())
}

/// Numbers of any count in angle brackets.
pub(super) fn numbers(list: &[f64]) -> String {
    bracketed(list)
}

/// `rgb <red, green, blue>`.
pub(super) fn rgb(color: Rgb) -> String {
    let mut out = "rgb ".to_owned();
    push_floats(&mut out, &color.to_array());
    out
}

/// A colour with as many components as it takes.
pub(super) fn color(color: Color) -> String {
    let is_nothing = |v: f32| v.to_bits() == 0;
    if is_nothing(color.filter) && is_nothing(color.transmit) {
        return rgb(color.rgb);
    }
    let mut out = "rgbft ".to_owned();
    let [red, green, blue] = color.rgb.to_array();
    push_floats(&mut out, &[red, green, blue, color.filter, color.transmit]);
    out
}

/// A string literal: everything beyond ASCII as an escape, so that no character set decides what it says.
pub(super) fn quoted(utf16: &[u16]) -> String {
    let mut out = "\"".to_owned();
    for &unit in utf16 {
        match u8::try_from(unit) {
            Ok(byte @ (b'"' | b'\\')) => {
                out.push('\\');
                out.push(char::from(byte));
            }
            Ok(byte @ b' '..=b'~') => out.push(char::from(byte)),
            _ => drop(write!(out, "\\u{unit:04X}")),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_to_the_same_bits() {
        for value in [0.0, -0.0, 1.0, 0.1, -1e300, 5e-324, f64::MAX, 1.0 / 3.0, 1e16, 123_456_789.125, f64::INFINITY] {
            let text = double(value);
            assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(value.to_bits()), "{text}");
        }
        assert_eq!([double(5.0), double(-0.0), double(1e-7), double(2.5e20)], ["5", "-0", "1e-7", "2.5e20"]);
    }

    #[test]
    fn floats_read_back_through_doubles() {
        let mut bits = 1_u32;
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            let value = f32::from_bits(bits);
            if value.is_finite() {
                let text = float(value);
                assert_eq!(text.parse::<f64>().map(|v| (v as f32).to_bits()), Ok(bits), "{text}");
            }
        }
        assert_eq!([float(0.1), float(1e-20)], ["0.1", "1e-20"]);
    }

    #[test]
    fn strings_are_plain_ascii() {
        let text: Vec<u16> = "a \"\\ ü\n".encode_utf16().collect();
        assert_eq!(quoted(&text), r#""a \"\\ \u00FC\u000A""#);
    }
}
