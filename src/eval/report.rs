//! What is said about a scene: warnings, each as often as it helps, and the errors behind which reading went on.

use crate::diag::{Diagnostic, FileId, SourceMap, Span, Topic};
use crate::syntax::Symbol;
use rustc_hash::FxHashSet;
use std::cell::Cell;
use std::sync::Arc;

/// A loop must not fill memory with warnings.
const MAX_WARNINGS: usize = 1000;

/// More errors than this are more than anyone mends at a time.
const MAX_ERRORS: usize = 10;

/// Keeps what is to be said, with the texts to show it in.
#[derive(Debug, Default)]
pub(super) struct Report {
    /// The files that were read.
    pub(super) sources: SourceMap,
    warnings: Vec<Diagnostic>,
    /// Errors behind which reading went on.
    errors: Vec<Diagnostic>,
    /// What was warned about already, as a whole or at a place.
    warned: FxHashSet<(Topic, u64)>,
    /// Names that an error kept from being declared.
    undeclared: FxHashSet<Symbol>,
    /// Whether an error leaves nothing to go on with.
    hopeless: Cell<bool>,
}

impl Report {
    /// Registers the text of a file.
    pub(super) fn add(&mut self, name: String, text: &Arc<Vec<u8>>) -> FileId {
        self.sources.add(name, Arc::clone(text))
    }

    /// Keeps a warning, which is made only if there is room for it.
    pub(super) fn warn(&mut self, warning: impl FnOnce() -> Diagnostic) {
        if self.warnings.len() < MAX_WARNINGS {
            self.warnings.push(warning());
        }
    }

    /// Keeps a warning about the scene as a whole.
    pub(super) fn remark(&mut self, topic: Topic, message: impl Into<String>) {
        self.warnings.push(Diagnostic::warning(topic, Span::default(), message).without_place());
    }

    /// Whether this is the first time that a topic is asked for.
    pub(super) fn is_new(&mut self, topic: Topic) -> bool {
        self.warned.insert((topic, 0))
    }

    /// Whether this is the first time that a topic is asked for at a place.
    pub(super) fn is_new_at(&mut self, topic: Topic, span: Span) -> bool {
        self.warned.insert((topic, (u64::from(span.file.0) << 32) + u64::from(span.start) + 1))
    }

    /// Nothing is left to go on with behind the error that comes.
    pub(super) fn give_up(&self) {
        self.hopeless.set(true);
    }

    /// Keeps the errors of a statement, if they do not only follow from one that was told; `named` is the word at their
    /// place.
    pub(super) fn fail(&mut self, errors: Vec<Diagnostic>, named: Option<Symbol>) {
        let span = errors.first().and_then(|e| e.span);
        let told = span.is_some() && self.errors.iter().any(|e| e.span == span);
        if !told && named.is_none_or(|name| !self.undeclared.contains(&name)) {
            self.errors.extend(errors);
        }
    }

    /// Names that the statement which failed would have declared.
    pub(super) fn miss(&mut self, names: impl IntoIterator<Item = Symbol>) {
        self.undeclared.extend(names);
    }

    /// Whether reading goes on behind an error.
    pub(super) fn goes_on(&self) -> bool {
        !self.hopeless.get() && self.errors.len() < MAX_ERRORS
    }

    /// The errors that were kept, taken out; empty for a scene that can be rendered.
    pub(super) fn take_errors(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.errors)
    }

    /// All that was said without being an error, and the files to show it in.
    pub(super) fn into_warnings(self) -> (Vec<Diagnostic>, SourceMap) {
        (self.warnings, self.sources)
    }

    /// A place as `file:line`.
    pub(super) fn place(&self, span: Span) -> String {
        let name = self.sources.file(span.file).map_or("", |file| &file.name);
        format!("{name}:{}", self.sources.line_column(span).line)
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_ERRORS, MAX_WARNINGS, Report};
    use crate::diag::{Diagnostic, Span, Topic};
    use crate::syntax::Symbol;
    use std::sync::Arc;

    fn at(start: u32) -> Span {
        Span { start, end: start + 1, ..Span::default() }
    }

    fn wrong(start: u32) -> Vec<Diagnostic> {
        vec![Diagnostic::error(at(start), "wrong")]
    }

    #[test]
    fn a_topic_is_new_once_and_once_at_each_place() {
        let mut report = Report::default();
        assert!(report.is_new(Topic::Range) && !report.is_new(Topic::Range) && report.is_new(Topic::Version));
        assert!(report.is_new_at(Topic::Range, at(0)) && !report.is_new_at(Topic::Range, at(0)));
        assert!(report.is_new_at(Topic::Range, at(1)));
    }

    #[test]
    fn a_loop_does_not_fill_memory_with_warnings() {
        let (mut report, mut n_made) = (Report::default(), 0);
        for i in 0..2 * MAX_WARNINGS as u32 {
            report.warn(|| {
                n_made += 1;
                Diagnostic::warning(Topic::Range, at(i), "odd")
            });
        }
        report.remark(Topic::Geometry, "nothing is in it");
        let (warnings, _) = report.into_warnings();
        assert_eq!((n_made, warnings.len()), (MAX_WARNINGS, MAX_WARNINGS + 1));
    }

    #[test]
    fn errors_that_follow_from_others_are_not_told() {
        let mut report = Report::default();
        report.fail(wrong(0), None);
        report.miss([Symbol(7)]);
        report.fail(wrong(5), Some(Symbol(7)));
        report.fail(wrong(0), Some(Symbol(8)));
        report.fail(wrong(9), Some(Symbol(8)));
        let told: Vec<_> = report.take_errors().into_iter().filter_map(|e| e.span).map(|s| s.start).collect();
        assert_eq!(told, [0, 9]);
    }

    #[test]
    fn reading_ends_behind_many_errors_and_behind_hopeless_ones() {
        let mut report = Report::default();
        for i in 0..MAX_ERRORS as u32 {
            assert!(report.goes_on());
            report.fail(wrong(i), None);
        }
        assert!(!report.goes_on());
        let hopeless = Report::default();
        hopeless.give_up();
        assert!(!hopeless.goes_on());
    }

    #[test]
    fn places_are_told_by_their_line() {
        let mut report = Report::default();
        let file = report.add("a.pov".into(), &Arc::new(b"one\ntwo".to_vec()));
        assert_eq!(report.place(Span { file, start: 4, end: 7 }), "a.pov:2");
    }
}
