//! What the evaluator pulls: tokens with their places.

use super::{Directive, Keyword, Symbol};
use crate::diag::Span;

/// One token and where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it was read.
    pub span: Span,
}

/// The sorts of token.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TokenKind {
    /// End of the scene.
    End,
    /// An unsigned number.
    Number(f64),
    /// A quoted string; its text is decoded from the span when it is used.
    String,
    /// A reserved word.
    Keyword(Keyword),
    /// Any other word.
    Name(Symbol),
    /// One character of punctuation.
    Punct(char),
    /// `<=`, `>=` or `!=`, by its first character.
    OrEqual(char),
    /// `#` and its word.
    Directive(Directive),
    /// A literal vector of two to five plain numbers; the numbers are read from the text.
    Vector,
    /// Literal vectors with commas between them, as one token however many there are. Cursors
    /// turn it into [`Self::Vector`]s and commas.
    Vectors,
    /// Something malformed.
    Bad(Malformed),
}

/// What may be wrong with a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Malformed {
    Number,
    String,
    LongString,
    LongName,
    Comment,
    DeepComment,
    Character,
}

impl Malformed {
    /// What to tell the author.
    pub fn message(self) -> &'static str {
        match self {
            Self::Number => "a number may have only one decimal point, before its exponent",
            Self::String => "this string is never closed, or has a backslash at the end of a line",
            Self::LongString => "a string may have at most 255 characters; longer ones can be built with concat",
            Self::LongName => "an identifier may have at most 255 characters",
            Self::Comment => "this comment is never closed",
            Self::DeepComment => "comments nest too deeply here",
            Self::Character => "this character has no meaning in a scene file",
        }
    }
}
