//! `#include`, and files that a scene names.

use super::Evaluator;
use super::feed::{Cursor, Role};
use super::world::Missing;
use crate::diag::{SourceResult, Span};
use crate::syntax::Position;
use std::path::{Path, PathBuf};

impl Evaluator<'_> {
    /// `#include S`: the text of the file comes next.
    pub(super) fn include(&mut self, span: Span) -> SourceResult<()> {
        if !self.starts_string()? {
            self.report.give_up();
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
        let (path, text) = match self.world.include(name, &self.feed.folders(&self.report.sources)) {
            Ok(found) => found,
            Err(missing) => {
                self.report.give_up();
                return match missing {
                    Missing::Unreadable(message) => self.error(span, message),
                    Missing::Unknown(hint) => {
                        self.error_with_hint(span, format!("cannot find the include file '{name}'"), hint)
                    }
                };
            }
        };
        let entered = self.budget.enter_include();
        self.within(entered, span)?;
        let source = self.take_in(&path, text)?;
        self.names.push();
        let mut cursor = Cursor::new(source, (Position::default(), None), Role::Include);
        cursor.blocks = self.open_blocks.len();
        cursor.call = span;
        self.feed.push(cursor);
        Ok(())
    }

    /// Looks for a file, in the folders of the files being read, too.
    pub(super) fn find_file(&self, name: &str, extensions: &[&str]) -> Option<PathBuf> {
        self.world.find(name, extensions, &self.feed.folders(&self.report.sources))
    }

    /// The bytes of a file that was found.
    pub(super) fn bytes_of(&self, path: &Path, span: Span) -> SourceResult<Vec<u8>> {
        self.world.bytes(path).or_else(|message| self.error(span, message))
    }
}
