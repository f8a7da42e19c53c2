//! Messages on standard error.

use crate::diag::{Diagnostic, Severity, SourceMap};
use crate::eval::Stream;
use std::fmt::Display;
use std::io::{IsTerminal, Write};

/// Writes a line; a closed standard error is no reason to stop.
pub(super) fn line(message: impl Display) {
    let _ = writeln!(std::io::stderr(), "{message}");
}

/// Draws all messages, colourful on a terminal.
pub(super) fn show(diagnostics: &[Diagnostic], sources: &SourceMap) {
    let color = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    for diagnostic in diagnostics {
        let _ = write!(std::io::stderr(), "{}", diagnostic.render(sources, color));
    }
}

/// "2 errors and 1 warning", or nothing.
pub(super) fn count(diagnostics: &[Diagnostic]) -> Option<String> {
    let of = |severity: Severity| diagnostics.iter().filter(|d| d.severity == severity).count();
    let words = |n: usize, word: &str| match n {
        0 => None,
        1 => Some(format!("1 {word}")),
        n => Some(format!("{n} {word}s")),
    };
    match (words(of(Severity::Error), "error"), words(of(Severity::Warning), "warning")) {
        (Some(errors), Some(warnings)) => Some(format!("{errors} and {warnings}")),
        (one, other) => one.or(other),
    }
}

/// What the scene itself says with `#debug` and its like.
pub(super) fn from_scene(_stream: Stream, text: &str) {
    let _ = write!(std::io::stderr(), "{text}");
}
