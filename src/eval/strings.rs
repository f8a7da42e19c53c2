//! String expressions.

use super::float_functions::int32;
use super::printf::{compact, date_time, fixed};
use super::{Evaluator, Value};
use crate::diag::{SourceResult, Span, Topic};
use crate::syntax::built_in::{BuiltIn, Gives};
use crate::syntax::{Keyword, TokenKind};
use std::rc::Rc;

#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// Whether the next token starts a string.
    pub fn starts_string(&mut self) -> SourceResult<bool> {
        Ok(match self.fill(false)? {
            TokenKind::String => true,
            TokenKind::Keyword(word) => is_string_function(word),
            TokenKind::Name(name) => self.names.stands_for(name, |value| matches!(value, Value::String(_))),
            _ => false,
        })
    }

    /// A string: a literal, an identifier or a function.
    pub fn string(&mut self) -> SourceResult<Rc<str>> {
        match self.fill(false)? {
            TokenKind::String => {
                let span = self.span();
                self.take();
                self.decode(span)
            }
            TokenKind::Keyword(word) if is_string_function(word) => {
                let span = self.span();
                self.take();
                let text = self.string_function(word)?;
                self.within(self.budget.string(text.len()), span)?;
                Ok(text)
            }
            _ => match self.take_declared(|value| match value {
                Value::String(text) => Some(Rc::clone(text)),
                _ => None,
            })? {
                Some(text) => Ok(text),
                None => self.expected("a string"),
            },
        }
    }

    /// A string in which a backslash is itself: the names of files.
    pub fn file_name(&mut self) -> SourceResult<Rc<str>> {
        if self.fill(false)? != TokenKind::String {
            return self.string();
        }
        let span = self.span();
        self.take();
        let raw = self.report.sources.bytes(span);
        Ok(String::from_utf8_lossy(raw.get(1..raw.len().saturating_sub(1)).unwrap_or(&[])).into())
    }

    /// The text of a literal: escapes and the scene's character set.
    pub(super) fn decode(&mut self, span: Span) -> SourceResult<Rc<str>> {
        let quoted = self.report.sources.bytes(span);
        let raw = quoted.get(1..quoted.len().saturating_sub(1)).unwrap_or(&[]);
        if raw.is_ascii() && !raw.contains(&b'\\') {
            return Ok(String::from_utf8_lossy(raw).into());
        }
        let (mut outside, mut characters) = (false, String::with_capacity(raw.len()));
        if self.utf8 {
            // The language's characters have 16 bits.
            characters
                .extend(String::from_utf8_lossy(raw).chars().map(|c| if c > '\u{ffff}' { '\u{fffd}' } else { c }));
        } else if self.version < 350 {
            characters.extend(raw.iter().map(|b| char::from(*b)));
        } else {
            outside = !raw.is_ascii();
            characters.extend(raw.iter().map(|b| if b.is_ascii() { char::from(*b) } else { ' ' }));
        }
        if outside {
            self.warn_here(
                Topic::Files,
                span,
                "characters outside of ASCII become blanks here; write global_settings { charset utf8 } before",
            );
        }
        match unescape(&characters) {
            Ok(text) => Ok(text.into()),
            Err(sequence) => self.error_with_hint(
                span,
                format!("unknown escape sequence '\\{sequence}' in this string"),
                "a backslash is written twice; folders may be separated by '/' on every system",
            ),
        }
    }

    fn string_function(&mut self, word: Keyword) -> SourceResult<Rc<str>> {
        let span = self.feed.last_span();
        self.arguments(|e| match word {
            Keyword::Str => {
                let value = e.float()?;
                e.comma()?;
                let [width, decimals] = e.two_integers()?;
                Ok(fixed(value, width, decimals).into())
            }
            Keyword::Vstr => e.vector_string(),
            Keyword::Concat => {
                let mut text = e.string()?.to_string();
                loop {
                    e.comma()?;
                    if !e.starts_string()? || e.budget.string(text.len()).is_err() {
                        return Ok(text.into());
                    }
                    text.push_str(&e.string()?);
                }
            }
            Keyword::Chr => {
                let code = int32(e.float()?);
                match u32::try_from(code) {
                    Ok(0) => Ok("".into()),
                    Ok(code) if code <= 0xffff => Ok(char::from_u32(code).unwrap_or('\u{fffd}').to_string().into()),
                    _ => e.error(span, format!("chr({code}): codes go from 0 to 65535")),
                }
            }
            Keyword::Substr => e.substring(span),
            Keyword::Strupr => Ok(e.string()?.to_ascii_uppercase().into()),
            Keyword::Strlwr => Ok(e.string()?.to_ascii_lowercase().into()),
            _ => {
                let days = e.float()?;
                let format = if e.accept_punct(',')? { e.string()? } else { "%Y-%m-%d %H:%M:%SZ".into() };
                Ok(date_time(days, &format).into())
            }
        })
    }

    fn two_integers(&mut self) -> SourceResult<[i32; 2]> {
        let first = int32(self.float()?);
        self.comma()?;
        Ok([first, int32(self.float()?)])
    }

    /// `vstr(n, V, separator, width, decimals)`; missing components print as 0.
    fn vector_string(&mut self) -> SourceResult<Rc<str>> {
        let n = int32(self.float()?).clamp(2, 5) as usize;
        self.comma()?;
        let value = self.any_expression()?;
        self.comma()?;
        let separator = self.string()?;
        self.comma()?;
        let [width, decimals] = self.two_integers()?;
        let parts: Vec<String> = value.v[..n].iter().map(|c| fixed(*c, width, decimals)).collect();
        Ok(parts.join(&separator).into())
    }

    /// `substr(s, position, length)`, counted from 1.
    fn substring(&mut self, span: Span) -> SourceResult<Rc<str>> {
        let text = self.string()?;
        self.comma()?;
        let [position, length] = self.two_integers()?;
        let n = text.chars().count() as i64;
        let (first, length) = (i64::from(position) - 1, i64::from(length));
        if first < 0 || length < 0 || first + length > n {
            return self
                .error(span, format!("substr({position}, {length}) reaches outside of a string of {n} characters"));
        }
        Ok(text.chars().skip(first as usize).take(length as usize).collect::<String>().into())
    }

    /// Functions of strings that give a number.
    pub(super) fn string_measure(&mut self, word: Keyword) -> SourceResult<f64> {
        self.arguments(|e| {
            let text = e.string()?;
            Ok(match word {
                Keyword::Strlen => text.chars().count() as f64,
                Keyword::Asc => text.chars().next().map_or(0.0, |c| f64::from(u32::from(c))),
                Keyword::Val => leading_number(&text),
                Keyword::FileExists => f64::from(e.world.has(&text, &e.feed.folders(&e.report.sources))),
                _ => {
                    e.comma()?;
                    let other = e.string()?;
                    let (mut a, mut b) = (text.encode_utf16(), other.encode_utf16());
                    loop {
                        match (a.next(), b.next()) {
                            (None, None) => break 0.0,
                            (x, y) if x == y => {}
                            (x, y) => break f64::from(x.unwrap_or(0)) - f64::from(y.unwrap_or(0)),
                        }
                    }
                }
            })
        })
    }

    /// What `#write` and messages make of a number of any width.
    pub(super) fn written(value: &super::Number) -> String {
        if value.n == 1 {
            return compact(value.v[0], 6);
        }
        let parts: Vec<String> = value.v[..value.n as usize].iter().map(|c| compact(*c, 6)).collect();
        // The trailing blank is POV-Ray's.
        format!("<{}> ", parts.join(","))
    }
}

/// Whether a word is a function that gives a string.
pub(super) fn is_string_function(word: Keyword) -> bool {
    BuiltIn::in_values(word).is_some_and(|built_in| built_in.gives == Gives::String)
}

/// Resolves escape sequences; fails with what follows the backslash of an unknown one.
fn unescape(text: &str) -> Result<String, String> {
    let mut out = String::with_capacity(text.len());
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        match rest.next() {
            Some('a') => out.push('\u{7}'),
            Some('b') => out.push('\u{8}'),
            Some('f') => out.push('\u{c}'),
            Some('n') => out.push('\n'),
            Some('r') => out.push('\r'),
            Some('t') => out.push('\t'),
            Some('v') => out.push('\u{b}'),
            Some(c @ ('\\' | '\'' | '"')) => out.push(c),
            Some('u') => {
                let digits: String = rest.by_ref().take(4).collect();
                match u32::from_str_radix(&digits, 16) {
                    Ok(code) if digits.len() == 4 => out.push(char::from_u32(code).unwrap_or('\u{fffd}')),
                    _ => return Err(format!("u{digits}")),
                }
            }
            other => return Err(other.map_or_else(String::new, String::from)),
        }
    }
    Ok(out)
}

/// The number a string begins with, as C reads it, hexadecimal included; else 0.
fn leading_number(text: &str) -> f64 {
    let text = text.trim_start();
    let (sign, digits) = match text.as_bytes().first() {
        Some(b'-') => (-1.0, &text[1..]),
        Some(b'+') => (1.0, &text[1..]),
        _ => (1.0, text),
    };
    if let Some(hexadecimal) = digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
        let value = hexadecimal.chars().map_while(|c| c.to_digit(16)).fold(0.0, |n, d| n * 16.0 + f64::from(d));
        return sign * value;
    }
    sign * fast_float2::parse_partial::<f64, _>(digits).map_or(0.0, |(value, _)| value)
}
