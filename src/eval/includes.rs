//! `#include`, and where files are looked for.

use super::cursor::{Cursor, Role};
use super::standard_includes::{advice_on_file, standard_include, standard_include_names};
use super::{Evaluator, Status};
use crate::diag::{SourceResult, Span, nearest};
use crate::syntax::Position;
use std::io;
use std::path::{Path, PathBuf};

impl Evaluator<'_> {
    /// `#include S`: the text of the file comes next.
    pub(super) fn include(&mut self, span: Span) -> SourceResult<()> {
        if !self.starts_string()? {
            self.given_up.set(true);
            let at = self.span();
            return self.error_with_hint(
                at,
                "expected the name of an include file",
                "it stands in quotes: #include \"colors.inc\"",
            );
        }
        let name = self.file_name()?;
        self.open_include(&name, span)
    }

    /// The text of an include file comes next; `span` is what asks for it.
    pub(super) fn open_include(&mut self, name: &str, span: Span) -> SourceResult<()> {
        let extensions: &[&str] = if name.ends_with(".inc") || name.ends_with(".INC") {
            &["", ".inc", ".INC"]
        } else {
            &[".inc", ".INC", ""]
        };
        let (path, text) = self.include_text(name, extensions, span)?;
        self.include_depth += 1;
        let limit = self.options.limits.include_depth;
        if self.include_depth > limit {
            return self.limit(span, format!("more than {limit} include files inside one another"), "include_depth");
        }
        let source = self.take_in(&path, text)?;
        self.scopes.push();
        let mut cursor = Cursor::new(source, (Position::default(), None), Role::Include);
        cursor.blocks = self.open_blocks.len();
        cursor.call = span;
        self.cursors.push(cursor);
        Ok(())
    }

    /// The file that `#include` names, or what comes with this program under that name.
    fn include_text(&mut self, name: &str, extensions: &[&str], span: Span) -> SourceResult<(PathBuf, Vec<u8>)> {
        if let Some(path) = self.find_file(name, extensions) {
            let text = self.bytes_of(&path, span);
            self.given_up.set(self.given_up.get() || text.is_err());
            return Ok((path, text?));
        }
        let mut names = extensions.iter().map(|extension| format!("{name}{extension}"));
        if let Some((name, text)) = names.find_map(|name| standard_include(&name).map(|text| (name, text))) {
            return Ok((PathBuf::from(format!("{name} (embedded)")), text.into()));
        }
        self.given_up.set(true);
        let near = || nearest(name, standard_include_names()).map(|near| format!("did you mean '{near}'?"));
        let hint = advice_on_file(name)
            .or_else(near)
            .unwrap_or_else(|| "folders to look in can be given with --include DIR".into());
        self.error_with_hint(span, format!("cannot find the include file '{name}'"), hint)
    }

    /// Looks for a file: the name with each extension in turn (none given: the name itself), each
    /// in the working directory, then in the include folders in order.
    ///
    /// As a last resort, which POV-Ray does not have, beside the file that names it, so that a
    /// scene can be rendered from anywhere. Of files that may not be read the first is found where there is no other,
    /// so that reading it says why.
    pub fn find_file(&mut self, name: &str, extensions: &[&str]) -> Option<PathBuf> {
        let extensions = if extensions.is_empty() { &[""] } else { extensions };
        let candidates: Vec<PathBuf> = extensions.iter().map(|e| PathBuf::from(format!("{name}{e}"))).collect();
        let within = |candidate: &PathBuf, folders: &[PathBuf]| -> Vec<PathBuf> {
            if candidate.is_absolute() { Vec::new() } else { folders.iter().map(|f| f.join(candidate)).collect() }
        };
        let usual = candidates.iter().flat_map(|candidate| {
            std::iter::once(candidate.clone()).chain(within(candidate, &self.options.include_dirs))
        });
        let beside = self.open_folders();
        let beside = candidates.iter().flat_map(|candidate| within(candidate, &beside));
        let mut refused = None;
        for path in usual.chain(beside) {
            match self.host.status(&path) {
                Status::Readable => return Some(path),
                Status::Refused => refused = refused.or(Some(path)),
                Status::Absent => {}
            }
        }
        refused
    }

    /// Whether there is a file that may be read.
    pub(super) fn has_file(&mut self, name: &str) -> bool {
        self.find_file(name, &[]).is_some_and(|path| self.host.status(&path) == Status::Readable)
    }

    /// The bytes of a file that was found.
    pub(super) fn bytes_of(&self, path: &Path, span: Span) -> SourceResult<Vec<u8>> {
        self.host.read(path).or_else(|problem| self.cannot_read(path, &problem, span))
    }

    /// What to say of a file that was found.
    pub(super) fn cannot_read<T>(&self, path: &Path, problem: &io::Error, span: Span) -> SourceResult<T> {
        self.error(span, format!("cannot read {}: {problem}", path.display()))
    }

    /// Folders of the files being read, innermost first, down to the scene's own.
    fn open_folders(&self) -> Vec<PathBuf> {
        let mut folders: Vec<PathBuf> = Vec::new();
        for cursor in self.cursors.iter().rev() {
            let file = self.sources.file(cursor.source.file);
            if let Some(folder) = file.and_then(|f| Path::new(&f.name).parent())
                && !folders.iter().any(|f| f == folder)
            {
                folders.push(folder.to_owned());
            }
        }
        folders
    }
}
