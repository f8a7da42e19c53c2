//! The token interface that block parsers read from.

use super::directives::BlockKind;
use super::value::Value;
use super::{Evaluator, Place};
use crate::diag::{SourceResult, Span};
use crate::syntax::{Keyword, Symbol, Token, TokenKind};

/// All of these run directives and macro calls first and fail with what those fail with.
#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// Makes sure a token is held back and returns its kind.
    ///
    /// Directives and macro calls in front of it run, unless `hold` asks for them to be
    /// delivered as tokens because the value before them has to be completed first.
    #[inline]
    pub(super) fn fill(&mut self, hold: bool) -> SourceResult<TokenKind> {
        if self.ready
            && let Some(token) = &self.ahead
        {
            return Ok(token.kind);
        }
        // Most tokens need no more than being read.
        if self.ahead.is_none()
            && !self.case_wanted
            && let Some(cursor) = self.cursors.last_mut()
            && let Some(token) = cursor.plain_step()
        {
            self.last_span = token.span;
            self.ahead = Some(*token);
            self.ready = true;
            return Ok(token.kind);
        }
        self.fill_slowly(hold)
    }

    fn fill_slowly(&mut self, hold: bool) -> SourceResult<TokenKind> {
        loop {
            if !hold {
                self.run_directives()?;
            }
            let token = match self.ahead.take() {
                Some(token) => token,
                None => self.fetch()?,
            };
            self.ready = false;
            match token.kind {
                TokenKind::Directive(_) | TokenKind::Name(_) if hold => {}
                TokenKind::Directive(directive) => {
                    self.run_directive(directive, token.span)?;
                    continue;
                }
                TokenKind::Name(name) => {
                    if self.scopes.is_macro(name)
                        && let Some(called) = self.macro_named(name)
                    {
                        self.call_macro(&called, token.span)?;
                        continue;
                    }
                    self.ready = true;
                }
                // Without a directive behind it the mark disappears, as in POV-Ray.
                TokenKind::Punct('#') => continue,
                _ => self.ready = true,
            }
            if self.case_wanted && !hold {
                return self.no_case(token);
            }
            self.ahead = Some(token);
            return Ok(token.kind);
        }
    }

    /// A token stands where a `#switch` wants its first `#case`.
    fn no_case(&mut self, token: Token) -> SourceResult<TokenKind> {
        self.ahead = Some(token);
        debug_assert!(matches!(self.open_blocks.last().map(|b| &b.kind), Some(BlockKind::Switch { .. })));
        self.expected("#case or #range after #switch")
    }

    /// The macro of that name.
    pub(super) fn macro_named(&self, name: Symbol) -> Option<std::rc::Rc<super::Macro>> {
        let place = self.scopes.find(name)?;
        match &*place.slot.borrow() {
            Value::Macro(called) if place.path.is_empty() => Some(std::rc::Rc::clone(called)),
            _ => None,
        }
    }

    /// Drops the token held back; what was peeked is thereby taken.
    pub(super) fn take(&mut self) {
        self.ahead = None;
        self.ready = false;
    }

    /// The next token; directives and macros in front of it have run.
    pub fn peek(&mut self) -> SourceResult<&Token> {
        self.fill(false)?;
        let end = Token { kind: TokenKind::End, span: self.last_span };
        Ok(self.ahead.get_or_insert(end))
    }

    /// Takes the next token.
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> SourceResult<Token> {
        let token = *self.peek()?;
        self.take();
        Ok(token)
    }

    /// Where the peeked token stands.
    pub fn span(&mut self) -> Span {
        self.ahead.map_or(self.last_span, |token| token.span)
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
        self.nesting = self.nesting.saturating_sub(1);
        Ok(())
    }

    /// Counts one more level of nesting.
    pub(super) fn deeper(&mut self) -> SourceResult<()> {
        self.nesting += 1;
        if self.nesting > self.options.limits.nesting {
            let (span, limit) = (self.span(), self.options.limits.nesting);
            return self.limit(span, format!("more than {limit} levels of braces and parentheses"), "nesting");
        }
        Ok(())
    }

    /// The levels inside something that is complete, if they are not too many; declarations build them without nesting
    /// any text.
    #[inline]
    pub(super) fn nested(&self, depth: u32, span: Span) -> SourceResult<u32> {
        let limit = self.options.limits.nesting;
        if depth as usize > limit {
            return self.limit(span, format!("more than {limit} levels inside one another"), "nesting");
        }
        Ok(depth)
    }

    /// The value of the peeked identifier, without indices, if it is one; not taken.
    pub fn declared(&mut self) -> SourceResult<Option<Value>> {
        match self.fill(false)? {
            TokenKind::Name(name) => Ok(self.scopes.find(name).and_then(Place::get)),
            _ => Ok(None),
        }
    }

    /// Takes the identifier that comes next, with its indices, if its value fits.
    pub fn take_declared<T>(&mut self, pick: impl Fn(&Value) -> Option<T>) -> SourceResult<Option<T>> {
        let TokenKind::Name(name) = self.fill(false)? else { return Ok(None) };
        let Some(place) = self.scopes.find(name) else { return Ok(None) };
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
                self.scopes.note_use(name);
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
