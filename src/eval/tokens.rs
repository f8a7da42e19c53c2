//! The token interface that block parsers read from.

use super::Evaluator;
use super::value::Value;
use crate::diag::{SourceResult, Span};
use crate::syntax::{Keyword, Token, TokenKind};

/// All of these run directives and macro calls first and fail with what those fail with.
#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// Makes sure a token is held back and returns its kind.
    ///
    /// Directives and macro calls in front of it run, unless `hold` asks for them to be
    /// delivered as tokens because the value before them has to be completed first.
    #[inline]
    pub(super) fn fill(&mut self, hold: bool) -> SourceResult<TokenKind> {
        if let Some(kind) = self.feed.ready() {
            return Ok(kind);
        }
        // Most tokens need no more than being read.
        if !self.case_wanted
            && let Some(kind) = self.feed.hold_plain()
        {
            return Ok(kind);
        }
        self.fill_slowly(hold)
    }

    fn fill_slowly(&mut self, hold: bool) -> SourceResult<TokenKind> {
        loop {
            if !hold {
                self.run_directives()?;
            }
            let token = match self.feed.release() {
                Some(token) => token,
                None => self.fetch()?,
            };
            let ready = match token.kind {
                TokenKind::Directive(_) | TokenKind::Name(_) if hold => false,
                TokenKind::Directive(directive) => {
                    self.run_directive(directive, token.span)?;
                    continue;
                }
                TokenKind::Name(name) => {
                    if self.names.is_macro(name)
                        && let Some(called) = self.names.macro_named(name)
                    {
                        self.call_macro(&called, token.span)?;
                        continue;
                    }
                    true
                }
                // Without a directive behind it the mark disappears, as in POV-Ray.
                TokenKind::Punct('#') => continue,
                _ => true,
            };
            self.feed.hold(token, ready);
            if self.case_wanted && !hold {
                return self.expected("#case or #range after #switch");
            }
            return Ok(token.kind);
        }
    }

    /// The next token before directives and macros are looked at; files and macros that end are left.
    #[inline]
    pub(super) fn fetch(&mut self) -> SourceResult<Token> {
        loop {
            if let Some(token) = self.feed.fetch(&mut self.names.words) {
                return match token.kind {
                    TokenKind::Bad(what) => self.error(token.span, what.message()),
                    _ => Ok(token),
                };
            }
            self.leave_cursor()?;
        }
    }

    /// Drops the token held back; what was peeked is thereby taken.
    pub(super) fn take(&mut self) {
        self.feed.release();
    }

    /// The next token; directives and macros in front of it have run.
    pub fn peek(&mut self) -> SourceResult<Token> {
        let kind = self.fill(false)?;
        Ok(Token { kind, span: self.feed.span() })
    }

    /// Takes the next token.
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> SourceResult<Token> {
        let token = self.peek()?;
        self.take();
        Ok(token)
    }

    /// Where the peeked token stands.
    pub fn span(&self) -> Span {
        self.feed.span()
    }

    /// The next token if it is a reserved word.
    pub fn keyword(&mut self) -> SourceResult<Option<Keyword>> {
        match self.fill(false)? {
            TokenKind::Keyword(keyword) => Ok(Some(keyword)),
            _ => Ok(None),
        }
    }

    /// Takes the next token if it is that reserved word.
    pub fn accept(&mut self, keyword: Keyword) -> SourceResult<bool> {
        let found = self.fill(false)? == TokenKind::Keyword(keyword);
        if found {
            self.take();
        }
        Ok(found)
    }

    /// Takes that reserved word, or says that it is wanted.
    pub fn expect(&mut self, keyword: Keyword) -> SourceResult<()> {
        if self.accept(keyword)? { Ok(()) } else { self.expected(&format!("'{}'", keyword.word())) }
    }

    /// Whether the next token is that character.
    pub fn at_punct(&mut self, c: char) -> SourceResult<bool> {
        Ok(self.fill(false)? == TokenKind::Punct(c))
    }

    /// Takes the next token if it is that character.
    pub fn accept_punct(&mut self, c: char) -> SourceResult<bool> {
        let found = self.at_punct(c)?;
        if found {
            self.take();
        }
        Ok(found)
    }

    /// Takes that character, or says what it was wanted for.
    pub fn expect_punct(&mut self, c: char, what: impl std::fmt::Display) -> SourceResult<()> {
        if self.accept_punct(c)? { Ok(()) } else { self.expected(&format!("'{c}' {what}")) }
    }

    /// Takes a comma if there is one.
    pub fn comma(&mut self) -> SourceResult<()> {
        self.accept_punct(',').map(|_| ())
    }

    /// Takes the `{` of a block; every one must be followed by a [`close`](Self::close).
    pub fn open(&mut self, what: &str) -> SourceResult<()> {
        self.expect_punct('{', format_args!("to open {what}"))?;
        self.deeper()
    }

    /// Takes the `}` of a block.
    pub fn close(&mut self, what: &str) -> SourceResult<()> {
        self.expect_punct('}', format_args!("to close {what}"))?;
        self.budget.shallower();
        Ok(())
    }

    /// Counts one more level of nesting.
    pub(super) fn deeper(&mut self) -> SourceResult<()> {
        let deeper = self.budget.deeper();
        self.within(deeper, self.feed.span())
    }

    /// The value of the peeked identifier, without indices, if it is one; not taken.
    pub fn declared(&mut self) -> SourceResult<Option<Value>> {
        match self.fill(false)? {
            TokenKind::Name(name) => Ok(self.names.get(name)),
            _ => Ok(None),
        }
    }

    /// Takes the identifier that comes next, with its indices, if its value fits.
    pub fn take_declared<T>(&mut self, pick: impl Fn(&Value) -> Option<T>) -> SourceResult<Option<T>> {
        let TokenKind::Name(name) = self.fill(false)? else { return Ok(None) };
        let Some(place) = self.names.find(name) else { return Ok(None) };
        let picked = place.with(|value| match value {
            Some(Value::Array(array)) => {
                pick(value?).map(Some).or_else(|| array.sample().and_then(&pick).map(|_| None))
            }
            Some(value) => pick(value).map(Some),
            None => None,
        });
        match picked {
            None => Ok(None),
            Some(Some(value)) => {
                self.names.note_use(name);
                self.note_use(name);
                self.take();
                Ok(Some(value))
            }
            Some(None) => {
                let span = self.span();
                let place = self.place()?;
                let (unset, value) = place.with(|value| (value.is_none(), value.and_then(&pick)));
                match value {
                    Some(value) => Ok(Some(value)),
                    None if unset => self.error(span, "this array element was never set"),
                    None => self.error(span, "this array element is of another type"),
                }
            }
        }
    }
}
