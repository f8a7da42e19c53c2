//! Errors and warnings with their place and the way there.

use super::Evaluator;
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

    /// A limit was met; `name` is the field of [`super::Limits`].
    pub(super) fn limit<T>(&self, span: Span, message: String, name: &str) -> SourceResult<T> {
        self.given_up.set(true);
        self.error_with_hint(span, message, format!("if that is meant, raise it with --limit {name}=N"))
    }

    /// A directive that belongs to nothing: what follows would be taken for what it is not.
    pub(super) fn mismatched<T>(&self, span: Span, message: impl Into<String>) -> SourceResult<T> {
        self.given_up.set(true);
        self.error(span, message)
    }

    /// "expected WHAT, found …" at the peeked token.
    pub fn expected<T>(&mut self, what: &str) -> SourceResult<T> {
        let token = match self.ahead {
            Some(token) => token,
            None => self.fetch()?,
        };
        self.ahead = Some(token);
        let found = self.describe(&token);
        let error = Diagnostic::error(token.span, format!("expected {what}, found {found}"));
        Err(vec![self.with_trace(match self.advice(what, &token) {
            Some(advice) => error.hint(advice),
            None => error,
        })])
    }

    /// What a message calls a token.
    fn describe(&self, token: &Token) -> String {
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
            TokenKind::Name(name) => match self.scopes.find(name).map(|p| p.with(|v| v.map(super::Value::kind))) {
                Some(Some(kind)) => format!("the {kind} '{}'", self.names.word(name)),
                Some(None) => format!("the unset '{}'", self.names.word(name)),
                None => format!("the undeclared name '{}'", self.names.word(name)),
            },
        }
    }

    /// An error for a name that is not declared.
    pub(super) fn undeclared<T>(&self, name: Symbol, span: Span) -> SourceResult<T> {
        let error = Diagnostic::error(span, format!("'{}' is not declared", self.names.word(name)));
        Err(vec![self.with_trace(match self.near_name(name, span, true) {
            Some(advice) => error.hint(advice),
            None => error,
        })])
    }

    /// A warning at a place.
    pub fn warn(&mut self, topic: Topic, span: Span, message: impl Into<String>) {
        /// A loop must not fill memory with warnings.
        const MAX_WARNINGS: usize = 1000;
        if self.warnings.len() < MAX_WARNINGS {
            let warning = self.with_trace(Diagnostic::warning(topic, span, message));
            self.warnings.push(warning);
        }
    }

    /// A warning about the scene as a whole.
    pub(super) fn remark(&mut self, topic: Topic, message: impl Into<String>) {
        self.warnings.push(Diagnostic::warning(topic, Span::default(), message).without_place());
    }

    /// A warning that is given once for its topic.
    pub fn warn_once(&mut self, topic: Topic, span: Span, message: impl Into<String>) {
        if self.warned.insert((topic, 0)) {
            self.warn(topic, span, message);
        }
    }

    /// A warning that is given once for its topic and place.
    pub(super) fn warn_here(&mut self, topic: Topic, span: Span, message: impl Into<String>) {
        if self.warned.insert((topic, (u64::from(span.file.0) << 32) + u64::from(span.start) + 1)) {
            self.warn(topic, span, message);
        }
    }

    /// Warns at the use of a name that was declared `deprecated`.
    pub(super) fn note_use(&mut self, name: Symbol) {
        if self.scopes.deprecated.is_empty() {
            return;
        }
        let Some((once, text)) = self.scopes.deprecated.get(&name).cloned() else { return };
        if once {
            self.scopes.deprecated.remove(&name);
        }
        let span = self.span();
        self.warn_here(Topic::Outdated, span, &*text);
    }
}
