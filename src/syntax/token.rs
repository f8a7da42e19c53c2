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
    /// One character of punctuation, or the first of `<=`, `>=`, `!=` with [`Self::OrEqual`].
    Punct(char),
    /// `<=`, `>=` or `!=`, by its first character.
    OrEqual(char),
    /// `#` and its word.
    Directive(Directive),
    /// A literal vector with this many components, as one token; the numbers are read from the text.
    Vector(u8),
    /// Literal vectors with commas between them, as one token however many there are.
    VectorList,
}
