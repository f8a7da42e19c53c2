//! What lies outside of the evaluator: files and the terminal.

use std::io;
use std::path::Path;

/// Everything from outside; the evaluator itself touches no disk and prints nothing.
pub trait Host: Sync {
    /// The bytes of a file.
    ///
    /// # Errors
    /// When it cannot or may not be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;
    /// Whether there is such a file (and it may be read).
    fn exists(&self, path: &Path) -> bool;
    /// Creates or empties a file, for `#fopen … write`.
    ///
    /// # Errors
    /// When it cannot or may not be written.
    fn create(&self, path: &Path) -> io::Result<()>;
    /// Adds bytes to a file, for `#write`.
    ///
    /// # Errors
    /// When it cannot or may not be written.
    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;
    /// A text of `#debug`, `#render` or `#statistics`.
    fn message(&self, stream: Stream, text: &str);
}

/// Where a message goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Stream {
    Debug,
    Render,
    Statistics,
}
