//! The files of a scene, standard input among them, and its words.

use super::console::Console;
use super::names::STANDARD_INPUT;
use super::settings::Sort;
use crate::eval::{Disk, Host, Kept, Status, Stream};
use std::io;
use std::path::Path;

/// The file system as a frame sees it.
pub(super) struct SceneHost<'c> {
    pub(super) disk: Disk,
    /// The scene that came through standard input.
    pub(super) piped: Option<&'c [u8]>,
    pub(super) console: &'c Console<'c>,
}

impl SceneHost<'_> {
    fn piped(&self, path: &Path) -> Option<&[u8]> {
        self.piped.filter(|_| path == Path::new(STANDARD_INPUT))
    }
}

impl Host for SceneHost<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.piped(path).map_or_else(|| self.disk.read(path), |bytes| Ok(bytes.to_vec()))
    }

    fn status(&self, path: &Path) -> Status {
        if self.piped(path).is_some() { Status::Readable } else { self.disk.status(path) }
    }

    fn create(&self, path: &Path) -> io::Result<Kept> {
        self.disk.create(path)
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
        self.disk.append(path, bytes)
    }

    /// `#render` and `#statistics` have had no stream of their own since POV-Ray 3.5.
    fn message(&self, _: Stream, text: &str) {
        self.console.say(Sort::Debug, text);
    }

    fn progress(&self, what: &dyn Fn() -> String) {
        self.disk.progress(what);
    }
}
