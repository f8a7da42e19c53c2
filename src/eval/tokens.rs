//! The token interface that block parsers read from.

use super::Evaluator;
use crate::diag::SourceResult;
use crate::syntax::{Keyword, Token, TokenKind};

#[allow(missing_docs, clippy::missing_errors_doc)]
impl Evaluator<'_> {
    fn fill(&mut self) -> SourceResult<()> {
        Ok(())
    }

    /// The next token; directives and macros in front of it have run.
    pub fn peek(&mut self) -> SourceResult<&Token> {
        self.fill()?;
        match &self.ahead {
            Some(token) => Ok(token),
            None => Err(Vec::new()),
        }
    }

    /// Takes the next token.
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> SourceResult<Token> {
        let token = *self.peek()?;
        self.ahead = None;
        Ok(token)
    }

    /// Takes the next token if it is that keyword.
    pub fn accept(&mut self, k: Keyword) -> SourceResult<bool> {
        let found = self.peek()?.kind == TokenKind::Keyword(k);
        if found {
            self.ahead = None;
        }
        Ok(found)
    }

    /// Whether the next token is that character.
    pub fn at_punct(&mut self, c: char) -> SourceResult<bool> {
        Ok(self.peek()?.kind == TokenKind::Punct(c))
    }

    /// Takes the next token if it is that character.
    pub fn accept_punct(&mut self, c: char) -> SourceResult<bool> {
        let found = self.at_punct(c)?;
        if found {
            self.ahead = None;
        }
        Ok(found)
    }

    /// Takes that character, or says what was wanted.
    pub fn expect_punct(&mut self, c: char, what: &str) -> SourceResult<()> {
        if self.accept_punct(c)? { Ok(()) } else { self.expected(&format!("'{c}' {what}")) }
    }

    /// Takes a comma if there is one.
    pub fn comma(&mut self) -> SourceResult<()> {
        self.accept_punct(',').map(|_| ())
    }

    /// Takes the `{` of a block.
    pub fn open(&mut self, what: &str) -> SourceResult<()> {
        self.expect_punct('{', &format!("to open {what}"))
    }

    /// Takes the `}` of a block.
    pub fn close(&mut self, what: &str) -> SourceResult<()> {
        self.expect_punct('}', &format!("to close {what}"))
    }
}
