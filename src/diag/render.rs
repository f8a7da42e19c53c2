//! Messages as people and editors read them.

use super::{Diagnostic, Severity, SourceMap, Span, Topic};
use ariadne::{CharSet, Color, Config, IndexType, Label, Report, ReportKind, Source};
use serde_json::json;

/// Lines that stand in for the text above a place.
const MAX_EMPTY_LINES: usize = 1 << 20;

impl Severity {
    /// `error` or `warning`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

impl Diagnostic {
    /// The message with its source line and a mark below the place, for a terminal.
    ///
    /// Of a long line only the part around the place is shown.
    pub fn render(&self, sources: &SourceMap, color: bool) -> String {
        let Some(span) = self.span.filter(|span| !sources.is_released(*span)) else {
            let hints: String = self.hints.iter().map(|h| format!("  help: {h}\n")).collect();
            let file = self.span.and_then(|span| sources.file(span.file));
            let place = file.map_or_else(String::new, |file| format!(" (in {})", file.name));
            return format!("{}: {}{place}\n{hints}", self.head(), self.message);
        };
        let (shown, place) = (sources.excerpt(span), sources.line_column(span));
        let ink = match self.severity {
            _ if !color => Color::Primary,
            Severity::Warning => Color::Yellow,
            Severity::Error => Color::Red,
        };
        let head = self.head();
        let kind = ReportKind::Custom(&head, ink);
        let config = Config::default()
            .with_color(color)
            .with_char_set(if color { CharSet::Unicode } else { CharSet::Ascii })
            .with_index_type(IndexType::Char);
        let name = sources.file(span.file).map_or_else(String::new, |f| f.name.clone());
        // The margin numbers lines from the start of the text it is given, so empty lines stand
        // in for the ones above; not for millions of them, whose numbers only the head shows.
        let above = if place.line <= MAX_EMPTY_LINES { place.line - 1 } else { 0 };
        let marked = above + shown.start..above + shown.end;
        let mut report = Report::build(kind, (name.clone(), marked.clone()))
            .with_config(config)
            .with_message(&self.message)
            .with_label(Label::new((name.clone(), marked)).with_color(ink));
        for hint in &self.hints {
            report.add_help(hint);
        }
        if shown.cut {
            report.add_note("the beginning of the long line is left out");
        }
        for (span, what) in &self.trace {
            report.add_note(format!("{what} at {}", describe(sources, *span)));
        }
        let source = Source::from("\n".repeat(above) + &shown.text).with_display_line_offset(place.line - 1 - above);
        let mut out = Vec::new();
        let written = report.finish().write((name, source), &mut out);
        match written {
            Ok(()) => {
                // The head counts columns from the start of the text that is shown.
                let text = String::from_utf8_lossy(&out);
                let (wrong, right) = (format!(":{}:{} ", place.line, shown.start + 1), place.column);
                let text = text.replacen(&wrong, &format!(":{}:{right} ", place.line), 1);
                if color { text } else { without_color(&text) }
            }
            Err(_) => format!("{}: {}: {}\n", describe(sources, span), self.head(), self.message),
        }
    }

    /// The message as one JSON object on one line.
    pub fn to_json(&self, sources: &SourceMap) -> String {
        let place = |span: Span| {
            let at = sources.line_column(span);
            let file = sources.file(span.file).map_or("", |f| &f.name);
            json!({"file": file, "line": at.line, "column": at.column, "start": span.start, "end": span.end})
        };
        let trace: Vec<_> =
            self.trace.iter().map(|(span, what)| json!({"message": what, "place": place(*span)})).collect();
        json!({
            "severity": self.severity.word(),
            "topic": self.topic.map(Topic::word),
            "message": self.message,
            "place": self.span.map(place),
            "trace": trace,
            "hints": self.hints,
        })
        .to_string()
    }
}

/// Drops escape sequences, which come even for a report without colour, and blanks at line ends.
fn without_color(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for line in text.lines() {
        let mut parts = line.split('\u{1b}');
        let mut clean = parts.next().unwrap_or("").to_owned();
        parts.for_each(|part| clean += part.split_once('m').map_or(part, |(_, rest)| rest));
        plain += clean.trim_end();
        plain.push('\n');
    }
    plain
}

/// `file:line:column`.
fn describe(sources: &SourceMap, span: Span) -> String {
    let at = sources.line_column(span);
    format!("{}:{}:{}", sources.file(span.file).map_or("?", |f| &f.name), at.line, at.column)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    fn example() -> (SourceMap, Diagnostic) {
        let mut sources = SourceMap::default();
        let file = sources.add("a.pov", Arc::new(b"// one\nspere { 0 1 }\n".to_vec()));
        let span = Span { file, start: 7, end: 12 };
        let mut wrong = Diagnostic::error(span, "unknown name 'spere'").hint("did you mean 'sphere'?");
        wrong.trace.push((Span { file, start: 0, end: 6 }, "in macro 'M', called".into()));
        (sources, wrong)
    }

    #[test]
    fn text_shows_place_line_hint_and_trail() {
        let (sources, wrong) = example();
        let text = wrong.render(&sources, false);
        for part in ["error: unknown name 'spere'", "a.pov:2:1", " 2 | spere { 0 1 }", "sphere", "a.pov:1:1"] {
            assert!(text.contains(part), "{part} in\n{text}");
        }
        assert!(!text.contains('\u{1b}'));
    }

    #[test]
    fn json_is_one_line() {
        let (sources, wrong) = example();
        let text = wrong.to_json(&sources);
        assert!(!text.contains('\n'));
        assert!(text.contains(r#""line":2"#), "{text}");
    }
}
