//! A look at tokens by their number.

use crate::syntax::{Symbol, Token, TokenKind};

/// Tokens in which formulas and what stands around them are looked for.
pub(super) struct Reader<'a> {
    pub(super) tokens: &'a [Token],
    /// The text that they were read from.
    pub(super) text: &'a [u8],
    /// Tells which names stand for macros at the time.
    pub(super) is_macro: &'a dyn Fn(Symbol) -> bool,
}

impl Reader<'_> {
    pub(super) fn kind(&self, at: usize) -> Option<TokenKind> {
        self.tokens.get(at).map(|t| t.kind)
    }

    /// Whether that character stands there.
    pub(super) fn is(&self, at: usize, c: char) -> bool {
        self.kind(at) == Some(TokenKind::Punct(c))
    }
}
