//! Messages on standard error.

use crate::diag::{Diagnostic, Severity, SourceMap, Topic};
use crate::eval::Stream;
use clap::ValueEnum;
use std::fmt::Display;
use std::io::{IsTerminal, Write};

/// Writes a line; a closed standard error is no reason to stop.
pub(super) fn line(message: impl Display) {
    let _ = writeln!(std::io::stderr(), "{message}");
}

/// How messages about a scene are shown.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Manner {
    /// Messages for people, or as one JSON object a line for editors
    #[arg(long, value_enum, default_value_t = Format::Text)]
    message_format: Format,
    /// Leave out warnings of a sort, which stands in brackets behind the word `warning`; `all` for all
    #[arg(long, value_name = "SORT", value_parser = topics)]
    no_warn: Vec<Topics>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    Text,
    Json,
}

/// What one `--no-warn` switches off.
type Topics = &'static [Topic];

fn topics(word: &str) -> Result<Topics, String> {
    if word == "all" {
        return Ok(&Topic::ALL);
    }
    let found = Topic::ALL.iter().position(|topic| topic.word() == word);
    let words = || Topic::ALL.map(Topic::word).join(", ");
    found.map(|i| &Topic::ALL[i..=i]).ok_or_else(|| format!("there are {} and all", words()))
}

impl Manner {
    /// Those of the messages that are wanted.
    pub(super) fn wanted(&self, diagnostics: &[Diagnostic]) -> Vec<Diagnostic> {
        let unwanted = |d: &Diagnostic| d.topic.is_some_and(|t| self.no_warn.iter().any(|off| off.contains(&t)));
        diagnostics.iter().filter(|d| !unwanted(d)).cloned().collect()
    }

    /// Shows the messages that are wanted, colourful on a terminal.
    pub(super) fn show(&self, diagnostics: &[Diagnostic], sources: &SourceMap) {
        let color = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
        let wanted = self.wanted(diagnostics);
        if wanted.is_empty() {
            return;
        }
        let sources = sources.restored(|name| std::fs::read(name).ok());
        for diagnostic in wanted {
            let text = match self.message_format {
                Format::Text => diagnostic.render(&sources, color),
                Format::Json => diagnostic.to_json(&sources) + "\n",
            };
            let _ = write!(std::io::stderr(), "{text}");
        }
    }

    /// A line for people, which editors do not get.
    pub(super) fn remark(&self, message: impl Display) {
        if self.message_format == Format::Text {
            line(message);
        }
    }

    /// What is told now and then what takes so long; only on a terminal.
    pub(super) fn observer(&self) -> Option<fn(&str)> {
        let told = self.message_format == Format::Text && std::io::stderr().is_terminal();
        told.then_some(|text| line(text))
    }

    /// What receives the texts of `#debug` and its like.
    pub(super) fn scene_output(&self) -> fn(Stream, &str) {
        match self.message_format {
            Format::Text => |_, text| {
                let _ = write!(std::io::stderr(), "{text}");
            },
            Format::Json => |stream, text| {
                line(serde_json::json!({"stream": format!("{stream:?}").to_lowercase(), "message": text}));
            },
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn topics_have_names() {
        assert_eq!(topics("range"), Ok(&[Topic::Range][..]));
        assert_eq!(topics("all").map(<[Topic]>::len), Ok(Topic::ALL.len()));
        assert!(topics("rnage").is_err());
    }
}
