//! Where objects were written, as comments.

use super::writer::Writer;
use crate::diag::{FileId, SourceMap, Span, Way};
use rustc_hash::FxHashMap;

/// Tells of places in sources.
pub(super) struct Origins<'a> {
    sources: &'a SourceMap,
    /// Where the lines of each file start: a scene may ask for a million places.
    lines: FxHashMap<FileId, Vec<usize>>,
}

impl<'a> Origins<'a> {
    pub(super) fn new(sources: &'a SourceMap) -> Self {
        Self { sources, lines: FxHashMap::default() }
    }

    /// File and line, and the calls on the way from the scene; nothing for what was written nowhere.
    ///
    /// A recursion is told once, with how often it went round.
    fn of(&mut self, span: Span) -> Option<String> {
        self.sources.file(span.file).filter(|_| span.end > span.start)?;
        let sources = self.sources;
        let mut steps: Vec<(String, usize)> = Vec::new();
        let mut text = self.place(span);
        for visit in sources.visits(span) {
            let way = match visit.by {
                Way::Call => {
                    text += " in ";
                    text += &String::from_utf8_lossy(sources.bytes(visit.from));
                    "called at "
                }
                Way::Include => "included at ",
            };
            push_step(&mut steps, text);
            text = way.to_owned() + &self.place(visit.from);
        }
        push_step(&mut steps, text);
        let told = steps.into_iter().map(|(step, n)| if n > 1 { format!("{step} ({n} times)") } else { step });
        Some(told.collect::<Vec<_>>().join(", "))
    }

    fn place(&mut self, span: Span) -> String {
        let id = self.sources.unvisited(span.file);
        let Some(file) = self.sources.file(id) else { return String::new() };
        let lines = self.lines.entry(id).or_insert_with(|| file.line_starts().collect());
        let line = lines.partition_point(|start| *start <= span.start as usize);
        format!("{}:{line}", file.name.replace(['\n', '\r'], " "))
    }
}

/// Adds a step, or counts it if it is the last one again.
fn push_step(steps: &mut Vec<(String, usize)>, step: String) {
    match steps.last_mut() {
        Some((last, n)) if *last == step => *n += 1,
        _ => steps.push((step, 1)),
    }
}

impl Writer<'_> {
    /// Where something was written, on request.
    pub(super) fn origin(&mut self, span: Span) {
        if self.counting {
            return;
        }
        if let Some(told) = self.origins.as_mut().and_then(|origins| origins.of(span)) {
            self.line(format_args!("// {told}"));
        }
    }
}
