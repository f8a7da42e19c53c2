//! Where messages go: POV-Ray's streams, each to standard error, to a file, or to both.
//!
//! Source: command line facts, section 7.

use super::settings::{Settings, Sort};
use crate::diag::{Diagnostic, Severity, SourceMap};
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// The streams of a run.
#[derive(Debug)]
pub(super) struct Streams {
    consoles: [bool; 6],
    files: [Option<Mutex<File>>; 6],
}

impl Streams {
    /// Creates the files beside the scene, or opens them to add something.
    ///
    /// # Errors
    /// Of a file that cannot be written, with its name.
    pub(super) fn open(settings: &Settings, folder: &Path) -> Result<Self, String> {
        let mut files = [const { None }; 6];
        for (file, stream) in files.iter_mut().zip(&settings.streams) {
            let Some(name) = &stream.file else { continue };
            let mut options = OpenOptions::new();
            let options = if settings.appends { options.append(true) } else { options.truncate(true).write(true) };
            let opened =
                options.create(true).open(folder.join(name)).map_err(|e| format!("{}: {e}", name.display()))?;
            *file = Some(Mutex::new(opened));
        }
        let all = settings.stream(Sort::All).console;
        let consoles = std::array::from_fn(|i| all && settings.streams[i].console);
        Ok(Self { consoles, files })
    }

    fn tell(&self, Said { sort, console, file }: &Said) {
        if sort.is_none_or(|sort| self.consoles[sort as usize]) {
            // A closed standard error is no reason to stop.
            let _ = io::stderr().write_all(console.as_bytes());
        }
        let Some(sort) = sort else { return };
        for stream in [*sort, Sort::All] {
            if let Some(open) = &self.files[stream as usize] {
                let _ = open.lock().unwrap_or_else(PoisonError::into_inner).write_all(file.as_bytes());
            }
        }
    }
}

/// Something that was said.
#[derive(Debug)]
struct Said {
    /// `None` for what is never silenced and stands in no file.
    sort: Option<Sort>,
    console: String,
    file: String,
}

/// Tells what a frame has to say, at once or when it is the frame's turn.
#[derive(Debug)]
pub(super) struct Console<'s> {
    streams: &'s Streams,
    kept: Option<Mutex<Vec<Said>>>,
}

impl<'s> Console<'s> {
    /// That keeps what is said until it is [told](Self::tell_all), or does not.
    pub(super) fn new(streams: &'s Streams, keeps: bool) -> Self {
        Self { streams, kept: keeps.then(Mutex::default) }
    }

    /// Whether all is told at once.
    pub(super) fn is_live(&self) -> bool {
        self.kept.is_none()
    }

    fn tell(&self, said: Said) {
        match &self.kept {
            Some(kept) => kept.lock().unwrap_or_else(PoisonError::into_inner).push(said),
            None => self.streams.tell(&said),
        }
    }

    /// Tells what was kept, in order.
    pub(super) fn tell_all(self) {
        let kept = self.kept.map(|kept| kept.into_inner().unwrap_or_else(PoisonError::into_inner));
        kept.iter().flatten().for_each(|said| self.streams.tell(said));
    }

    /// What nobody can silence.
    pub(super) fn plain(&self, text: impl Into<String>) {
        self.tell(Said { sort: None, console: text.into(), file: String::new() });
    }

    /// The same on the console and in files.
    pub(super) fn say(&self, sort: Sort, text: impl Into<String>) {
        let console = text.into();
        self.tell(Said { sort: Some(sort), file: console.clone(), console });
    }

    /// Messages about the scene, errors with their line and a mark below the place.
    pub(super) fn show(&self, diagnostics: &[Diagnostic], sources: &SourceMap) {
        let sources = sources.restored(|name| std::fs::read(name).ok());
        for diagnostic in diagnostics {
            let (sort, word) = match diagnostic.severity {
                Severity::Error => (Sort::Fatal, "Parse Error"),
                Severity::Warning => (Sort::Warning, "Parse Warning"),
            };
            let mut console = format!("{}{word}: {}\n", place(diagnostic, &sources), diagnostic.message);
            if sort == Sort::Fatal {
                console += &diagnostic.render(&sources, false);
            }
            let file = format!("{}{word}: {}\n", context(diagnostic, &sources), diagnostic.message);
            self.tell(Said { sort: Some(sort), console, file });
        }
    }
}

/// `File 'a.pov' line 3: `, as callers look for it.
fn place(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let Some(span) = diagnostic.span else { return String::new() };
    let name = sources.file(span.file).map_or("", |file| &file.name);
    format!("File '{name}' line {}: ", sources.line_column(span).line)
}

/// Lines up to the place, as they stand in the files of streams: of errors five, of warnings none.
fn context(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    const LINES: usize = 5;
    let Some((span, file)) = diagnostic.span.and_then(|span| Some((span, sources.file(span.file)?))) else {
        return String::new();
    };
    let line = sources.line_column(span).line;
    let head = format!("File: {}  Line: {line}\n", file.name);
    if diagnostic.severity == Severity::Warning {
        return head;
    }
    let text = String::from_utf8_lossy(&file.text);
    let lines: String =
        text.lines().take(line).skip(line.saturating_sub(LINES)).map(|line| format!("{line}\n")).collect();
    format!("{head}File Context ({LINES} lines):\n{lines}")
}
