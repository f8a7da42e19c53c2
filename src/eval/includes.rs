//! `#include`, and where files are looked for.

use super::Evaluator;
use super::cursor::{Cursor, Role};
use super::standard_includes::{advice_on_file, standard_include, standard_include_names};
use crate::diag::{SourceResult, Span, nearest};
use crate::syntax::Position;
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
        let extensions: &[&str] = if name.ends_with(".inc") || name.ends_with(".INC") {
            &["", ".inc", ".INC"]
        } else {
            &[".inc", ".INC", ""]
        };
        let (path, text) = self.include_text(&name, extensions, span)?;
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
            return match self.host.read(&path) {
                Ok(text) => Ok((path, text)),
                Err(error) => {
                    self.given_up.set(true);
                    self.error(span, format!("cannot read {}: {error}", path.display()))
                }
            };
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
    /// scene can be rendered from anywhere.
    pub fn find_file(&mut self, name: &str, extensions: &[&str]) -> Option<PathBuf> {
        let extensions = if extensions.is_empty() { &[""] } else { extensions };
        let candidates: Vec<PathBuf> = extensions.iter().map(|e| PathBuf::from(format!("{name}{e}"))).collect();
        for candidate in &candidates {
            if self.host.exists(candidate) {
                return Some(candidate.clone());
            }
            if candidate.is_absolute() {
                continue;
            }
            for folder in &self.options.include_dirs {
                let path = folder.join(candidate);
                if self.host.exists(&path) {
                    return Some(path);
                }
            }
        }
        let beside: Vec<PathBuf> = self.open_folders();
        let relative = candidates.iter().filter(|c| !c.is_absolute());
        relative.flat_map(|c| beside.iter().map(move |folder| folder.join(c))).find(|path| self.host.exists(path))
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
