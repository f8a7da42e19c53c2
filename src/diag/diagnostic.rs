//! Messages about a scene.

use super::{Span, Topic};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The picture may not be what the author wants.
    Warning,
    /// There will be no picture.
    Error,
}

/// One message with its place, the way there, and what to do about it.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What sort of warning it is; `None` for errors.
    pub topic: Option<Topic>,
    /// Where; `None` for messages about the whole scene.
    pub span: Option<Span>,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// Macro calls and includes that led there, innermost first.
    pub trace: Vec<(Span, String)>,
    /// What might help.
    pub hints: Vec<String>,
}

/// A value, or the messages that say why there is none.
pub type SourceResult<T> = Result<T, Vec<Diagnostic>>;

impl Diagnostic {
    /// An error at a place.
    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            topic: None,
            span: Some(span),
            message: message.into(),
            trace: Vec::new(),
            hints: Vec::new(),
        }
    }

    /// A warning at a place.
    pub fn warning(topic: Topic, span: Span, message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, topic: Some(topic), ..Self::error(span, message) }
    }

    /// Without a place: it concerns the scene as a whole.
    #[must_use]
    pub fn without_place(mut self) -> Self {
        self.span = None;
        self
    }

    /// `error`, or `warning` with its topic in brackets.
    pub(super) fn head(&self) -> String {
        match self.topic {
            Some(topic) => format!("{}[{}]", self.severity.word(), topic.word()),
            None => self.severity.word().to_owned(),
        }
    }

    /// Adds a hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }
}
