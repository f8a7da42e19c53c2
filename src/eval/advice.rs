//! Hints for the mistakes that people make.

use super::Value;
use super::colors::is_color_word;
use super::float_functions::starts_expression;
use super::names::Names;
use super::standard_includes::{advice_on_texture, declared_in};
use super::strings::is_string_function;
use crate::diag::{SourceMap, Span, completed, nearest};
use crate::syntax::built_in::BuiltIn;
use crate::syntax::{Directive, Keyword, Keyword as K, Symbol, Token, TokenKind};

/// What was found instead of what was expected.
enum Found<'a> {
    /// An identifier that holds a value of this kind.
    Value(&'static str, &'a str),
    Keyword(Keyword),
    Sign(char),
    Number,
    String,
    Other,
}

/// What may help when `expected` was expected and `token` was found.
pub(super) fn advice(expected: &str, token: &Token, names: &Names, sources: &SourceMap) -> Option<String> {
    let found = match token.kind {
        TokenKind::Name(name) => match names.find(name).and_then(|p| p.with(|v| v.map(Value::kind))) {
            Some(kind) => Found::Value(kind, names.words.word(name)),
            None if sources.bytes(token.span).starts_with(b"#") => {
                let words = Keyword::ALL.iter().filter(|k| Directive::from_keyword(**k).is_some());
                let near = nearest(names.words.word(name), words.map(|k| k.word()));
                return Some(match near {
                    Some(near) => format!("did you mean '#{near}'?"),
                    None => "'#' begins a directive such as #declare; a comment begins with //".to_owned(),
                });
            }
            None => return near_name(name, token.span, false, names, sources),
        },
        TokenKind::Keyword(keyword) => Found::Keyword(keyword),
        TokenKind::Punct(c) | TokenKind::OrEqual(c) => Found::Sign(c),
        TokenKind::Number(_) => Found::Number,
        TokenKind::String => Found::String,
        _ => Found::Other,
    };
    let closing = expected.strip_prefix("'}' to close ");
    match closing {
        Some(block) => in_block(block, &found),
        None => elsewhere(expected, &found),
    }
}

/// Where a name comes from, or "did you mean …?"; `in_value` where a number, a string or a declared thing was wanted.
pub(super) fn near_name(
    name: Symbol,
    span: Span,
    in_value: bool,
    names: &Names,
    sources: &SourceMap,
) -> Option<String> {
    let word = &**names.words.word(name);
    let meant = |near: &str| format!("did you mean '{near}'?");
    let declared = || names.declared().map(|s| &**names.words.word(s));
    if let Some(same) = declared().find(|known| known.eq_ignore_ascii_case(word)) {
        return Some(meant(same));
    }
    let next = next_byte(span, sources);
    let lower = word.to_ascii_lowercase();
    let same_word = Keyword::from_word(&lower).filter(|_| lower != word);
    let lower_case = |k: Keyword| format!("{} The words of the language are in lower case", meant(k.word()));
    if let Some(object) = same_word.filter(|k| starts_object(*k) && next == Some(b'{')) {
        return Some(lower_case(object));
    }
    if let Some(file) = declared_in(word) {
        return Some(format!("it is declared in a standard file: #include \"{file}\""));
    }
    if let Some(advice) = advice_on_texture(word) {
        return Some(advice);
    }
    let fits = |keyword: &Keyword| !in_value || fits_in_value(*keyword, next);
    if let Some(keyword) = same_word.filter(fits) {
        return Some(lower_case(keyword));
    }
    if word == "return" {
        return Some("a macro ends with its value, without a word before it".to_owned());
    }
    let words = Keyword::ALL.iter().filter(|k| fits(k)).map(|k| k.word());
    let near = nearest(word, declared()).or_else(|| completed(word, words.clone())).or_else(|| nearest(word, words));
    match near {
        None if in_value && next != Some(b'{') => Some(format!("declare it before: #declare {word} = …;")),
        near => near.map(meant),
    }
}

/// The first byte behind a token that is no blank, if it is near.
fn next_byte(span: Span, sources: &SourceMap) -> Option<u8> {
    const NEAR: u32 = 80;
    let byte = |i: u32| sources.bytes(Span { start: span.end + i, end: span.end + i + 1, ..span }).first();
    (0..NEAR).map_while(byte).find(|b| !b.is_ascii_whitespace()).copied()
}

/// Whether a word can stand where a value is wanted, with that character behind it.
fn fits_in_value(word: Keyword, next: Option<u8>) -> bool {
    match next {
        Some(b'(') => starts_expression(word) || is_string_function(word),
        Some(b'{') => true,
        _ => is_constant(word) || is_color_word(word),
    }
}

fn is_constant(word: Keyword) -> bool {
    BuiltIn::in_values(word).is_some_and(BuiltIn::is_constant)
}

const POWER: &str = "the power is pow(A, B)";

/// A block was expected to end.
fn in_block(block: &str, found: &Found<'_>) -> Option<String> {
    Some(match *found {
        Found::Value("texture", name) if block == "pigment" => {
            format!("a texture holds a pigment, not the other way round: use 'texture {{ {name} }}' in the object")
        }
        Found::Value(kind @ ("texture" | "pigment" | "normal" | "finish" | "interior" | "material"), name) => {
            format!("a declared {kind} is used as '{kind} {{ {name} }}'")
        }
        Found::Keyword(word) if Directive::from_keyword(word).is_some() => format!("write #{}", word.word()),
        Found::Keyword(word) if block == "camera" && is_camera_type(word) => {
            "the camera's type must be the first word of the block".into()
        }
        Found::Keyword(Keyword::Finish | Keyword::Normal | Keyword::Texture) if block == "pigment" => {
            "the '}' of the pigment is missing before it".into()
        }
        Found::Keyword(word) if starts_object(word) => match block {
            "union" | "merge" | "intersection" | "difference" => {
                "the parts of a CSG object stand before its pigment and other modifiers; or is a '}' missing?".into()
            }
            _ => format!("is the '}}' of the {block} missing before it?"),
        },
        Found::Sign(',') if block == "pigment" => {
            "a colour's components stand in angle brackets: rgb <1, 0.5, 0>".into()
        }
        Found::Sign(',') => "no ',' belongs here; a vector stands in angle brackets: translate <1, 2, 3>".into(),
        Found::Sign('^') => POWER.into(),
        Found::Keyword(K::Color | K::Colour | K::Rgb | K::Rgbf | K::Rgbt | K::Rgbft) => {
            "a colour stands in a pigment: pigment { rgb <1, 0, 0> }".into()
        }
        Found::Keyword(K::X | K::Y | K::Z) => "is a '*' missing before it, as in 30 * x?".into(),
        Found::Number | Found::Sign('<') => {
            "is a ',' or an operator missing before it, or a word such as scale?".into()
        }
        _ => return None,
    })
}

/// Anything but the end of a block was expected.
fn elsewhere(expected: &str, found: &Found<'_>) -> Option<String> {
    let hint = match found {
        Found::Sign('}') if expected.contains("an object, a block") => "there is a '}' too many, here or before",
        Found::Sign(';') if expected.contains("an object, a block") => {
            "blocks end with '}' alone; a ';' belongs behind numbers, colours and strings that are declared"
        }
        Found::Sign('+') if expected.contains("an object, a block") => {
            "strings are joined by concat(A, B); a variable grows by #declare I = I + 1;"
        }
        Found::Value("float" | "vector" | "colour", _) if expected.contains("an object, a block") => {
            "a variable is changed by a directive: #declare I = I + 1;"
        }
        Found::Sign('%') => "the remainder of a division is mod(A, B)",
        Found::Sign('^') => POWER,
        Found::Sign('&' | '|') if expected.starts_with("a number") => "a single '&' means and, a single '|' or",
        Found::Sign('.') if expected.starts_with("'=' in the declaration") => {
            "a component cannot be set alone: #declare V = <5, V.y, V.z>;"
        }
        Found::Sign('}') if expected == "a colour" => "a colour is missing before it, such as rgb <1, 1, 1>",
        Found::Keyword(_) | Found::Sign('}' | '{') if expected.starts_with("')' behind") => {
            "is a ')' missing before it?"
        }
        Found::Sign('<' | '>' | '=' | '!') if expected.starts_with("';'") => {
            "a comparison in a declaration must stand in parentheses: (A > 2)"
        }
        Found::Sign(',') if expected.starts_with("')' to close") => "vectors stand in angle brackets: <1, 2, 3>",
        Found::Sign(',') if expected.starts_with("'>'") => "a vector has two to five components",
        Found::Number if expected.starts_with("')' behind the arguments") => "arguments are separated by commas",
        _ if expected.starts_with("'(' before the condition") => "conditions stand in parentheses: #while (I < 5)",
        Found::Sign('=') if expected.starts_with("a number, a vector") => {
            "a single '=' compares; a loop is written #for (I, 0, 4), a declaration #declare I = 0;"
        }
        Found::Number if expected == "a string" => "str(NUMBER, 0, -1) makes a string of a number",
        Found::String if expected.contains("number") => "val(STRING) makes a number of a string",
        Found::Keyword(_) | Found::Sign('}') if expected.starts_with("a number, a vector") => {
            "a value is missing before it; a ',' is needed where the next value begins with a sign"
        }
        _ if expected.starts_with("';' behind the value") => "what is declared before it must end with ';'",
        _ => return None,
    };
    Some(hint.to_owned())
}

fn is_camera_type(word: Keyword) -> bool {
    matches!(
        word,
        K::Perspective | K::Orthographic | K::Fisheye | K::UltraWideAngle | K::Omnimax | K::Panoramic | K::Spherical
    )
}

fn starts_object(word: Keyword) -> bool {
    super::blocks::is_object_keyword(word) || matches!(word, Keyword::Camera | Keyword::GlobalSettings)
}
