//! Errors and warnings with their place and the way there.

use super::Evaluator;
use super::advice::{advice, near_name};
use super::blocks::{Table, with_words};
use super::budget::{Exceeded, Within};
use super::names::Names;
use crate::diag::{Diagnostic, SourceResult, Span, Topic};
use crate::syntax::{Symbol, Token, TokenKind};

#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// An error at a place.
    pub fn error<T>(&self, span: Span, message: impl Into<String>) -> SourceResult<T> {
        Err(vec![self.with_trace(Diagnostic::error(span, message))])
    }

    /// An error with advice.
    pub fn error_with_hint<T>(
        &self,
        span: Span,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> SourceResult<T> {
        Err(vec![self.with_trace(Diagnostic::error(span, message)).hint(hint)])
    }

    /// What stays within the limits, or an error that names the limit.
    #[inline]
    pub(super) fn within<T>(&self, used: Within<T>, span: Span) -> SourceResult<T> {
        used.or_else(|exceeded| self.exceeded(exceeded, span))
    }

    #[cold]
    fn exceeded<T>(&self, Exceeded { limit, message }: Exceeded, span: Span) -> SourceResult<T> {
        self.report.give_up();
        self.error_with_hint(span, message, format!("if that is meant, raise it with --limit {limit}=N"))
    }

    /// Adds the macro calls and includes that led here, innermost first.
    pub(super) fn with_trace(&self, mut diagnostic: Diagnostic) -> Diagnostic {
        diagnostic.trace.extend(self.feed.trail(&self.names.words));
        diagnostic
    }

    /// The place of the token that was just taken, as the calls on the way came to it, if anybody wants to know.
    #[inline]
    pub(super) fn origin(&mut self, span: Span) -> Span {
        if !self.options.origins {
            return span;
        }
        Span { file: self.feed.read_as(&mut self.report.sources), ..span }
    }

    /// A directive that belongs to nothing: what follows would be taken for what it is not.
    pub(super) fn mismatched<T>(&self, span: Span, message: impl Into<String>) -> SourceResult<T> {
        self.report.give_up();
        self.error(span, message)
    }

    /// "expected WHAT, found …" at the peeked token.
    pub fn expected<T>(&mut self, what: &str) -> SourceResult<T> {
        let token = match self.feed.held() {
            Some(token) => *token,
            None => {
                let token = self.fetch()?;
                self.feed.hold(token, false);
                token
            }
        };
        let found = describe(&token, &self.names);
        let error = Diagnostic::error(token.span, format!("expected {what}, found {found}"));
        Err(vec![self.with_trace(match advice(what, &token, &self.names, &self.report.sources) {
            Some(advice) => error.hint(advice),
            None => error,
        })])
    }

    /// The same in a block, whose words are what else could have stood there.
    pub(super) fn expected_in<T>(&mut self, table: &dyn Table, what: &str) -> SourceResult<T> {
        self.expected(what).map_err(|errors| {
            let undeclared = match self.feed.held().map(|token| token.kind) {
                Some(TokenKind::Name(name)) if self.names.find(name).is_none() => Some(&**self.names.words.word(name)),
                _ => None,
            };
            with_words(errors, table, undeclared)
        })
    }

    /// An error for a name that is not declared.
    pub(super) fn undeclared<T>(&self, name: Symbol, span: Span) -> SourceResult<T> {
        let error = Diagnostic::error(span, format!("'{}' is not declared", self.names.words.word(name)));
        Err(vec![self.with_trace(match near_name(name, span, true, &self.names, &self.report.sources) {
            Some(advice) => error.hint(advice),
            None => error,
        })])
    }

    /// A warning at a place.
    pub fn warn(&mut self, topic: Topic, span: Span, message: impl Into<String>) {
        let warning = || {
            let mut warning = Diagnostic::warning(topic, span, message);
            warning.trace = self.feed.trail(&self.names.words);
            warning
        };
        self.report.warn(warning);
    }

    /// A warning that is given once for its topic.
    pub fn warn_once(&mut self, topic: Topic, span: Span, message: impl Into<String>) {
        if self.report.is_new(topic) {
            self.warn(topic, span, message);
        }
    }

    /// A warning that is given once for its topic and place.
    pub(super) fn warn_here(&mut self, topic: Topic, span: Span, message: impl Into<String>) {
        if self.report.is_new_at(topic, span) {
            self.warn(topic, span, message);
        }
    }

    /// Warns at the use of a name that was declared `deprecated`.
    pub(super) fn note_use(&mut self, name: Symbol) {
        let Some(text) = self.names.deprecation(name) else { return };
        let span = self.span();
        self.warn_here(Topic::Outdated, span, &*text);
    }
}

/// What a message calls a token.
fn describe(token: &Token, names: &Names) -> String {
    match token.kind {
        TokenKind::End => "the end of the file".into(),
        TokenKind::Number(_) => "a number".into(),
        TokenKind::Vector | TokenKind::Vectors => "a vector".into(),
        TokenKind::String => "a string".into(),
        TokenKind::Keyword(keyword) => format!("'{}'", keyword.word()),
        TokenKind::Punct(c) => format!("'{c}'"),
        TokenKind::OrEqual(c) => format!("'{c}='"),
        TokenKind::Directive(directive) => format!("#{}", directive.word()),
        TokenKind::Bad(what) => what.message().into(),
        TokenKind::Name(name) => names.describe(name),
    }
}
