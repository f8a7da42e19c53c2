//! Hints for the mistakes that people make.

use super::{Evaluator, Value};
use crate::diag::nearest;
use crate::syntax::{Directive, Keyword, Keyword as K, Token, TokenKind};

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

impl Evaluator<'_> {
    /// What may help when `expected` was expected and `token` was found.
    pub(super) fn advice(&self, expected: &str, token: &Token) -> Option<String> {
        let found = match token.kind {
            TokenKind::Name(name) => match self.scopes.find(name).and_then(|p| p.with(|v| v.map(Value::kind))) {
                Some(kind) => Found::Value(kind, self.names.word(name)),
                None if self.sources.bytes(token.span).starts_with(b"#") => {
                    let words = Keyword::ALL.iter().filter(|k| Directive::from_keyword(**k).is_some());
                    let near = nearest(self.names.word(name), words.map(|k| k.word()));
                    return near.map(|near| format!("did you mean '#{near}'?"));
                }
                None => return self.near_name(name),
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
}

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
        Found::Sign(',') => "no ',' belongs here".into(),
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
        Found::Sign('<' | '>' | '=' | '!') if expected.starts_with("';'") => {
            "a comparison in a declaration must stand in parentheses: (A > 2)"
        }
        Found::Sign(',') if expected.starts_with("')' to close") => "vectors stand in angle brackets: <1, 2, 3>",
        Found::Sign(',') if expected.starts_with("'>'") => "a vector has two to five components",
        Found::Number if expected.starts_with("')' behind the arguments") => "arguments are separated by commas",
        _ if expected.starts_with("'(' before the condition") => "conditions stand in parentheses: #while (I < 5)",
        Found::Sign('=') if expected.starts_with("a number, a vector") => {
            "a loop is written #for (I, 0, 4), a declaration #declare I = 0;"
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
