//! What lies outside of the evaluator: files and the terminal.

use crate::diag::Diagnostic;
use crate::function::Caller;
use crate::imaging::Encoded;
use crate::math::{Bounds, DVec3, Ray};
use crate::scene::{GeometryQueries, Object, PointFunction};
use crate::syntax::Text;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Everything from outside; the evaluator itself touches no disk and prints nothing.
pub trait Host {
    /// The bytes of a file.
    ///
    /// # Errors
    /// When it cannot or may not be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;
    /// Whether there is such a file, and whether it may be read.
    fn status(&self, path: &Path) -> Status;
    /// Creates or empties a file, for `#fopen … write`. From then on [`read`](Self::read) gives what was written,
    /// wherever that is kept.
    ///
    /// # Errors
    /// When it cannot be written.
    fn create(&self, path: &Path) -> io::Result<Kept>;
    /// Adds bytes to a file, for `#write` and `#fopen … append`; what the file holds already stays.
    ///
    /// # Errors
    /// When it cannot be written.
    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept>;
    /// A scene or include file that was [read](Self::read) there, or the same one as it was read before: then its tokens
    /// may be known already.
    fn text(&self, _path: &Path, text: Text) -> Arc<Text> {
        Arc::new(text)
    }
    /// A font file that was [read](Self::read) there, or the same one as it was read before.
    fn font(&self, _path: &Path, bytes: Vec<u8>) -> Arc<Vec<u8>> {
        Arc::new(bytes)
    }
    /// A picture that was [read](Self::read), or the same one as it was read before: then it is decoded already.
    fn picture(&self, file: Encoded) -> Arc<Encoded> {
        Arc::new(file)
    }
    /// A text of `#debug`, `#render` or `#statistics`.
    fn message(&self, stream: Stream, text: &str);
    /// Asked for now and then while a scene runs: `what` says what it is at.
    fn progress(&self, _what: &dyn Fn() -> String) {}
}

/// Whether there is a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// None, or something that is no file.
    Absent,
    /// There is, and it may be read.
    Readable,
    /// There is, but it may not be read; trying to says why.
    Refused,
}

/// Where something is kept that a scene has written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// In a file that outlives the scene.
    OnDisk,
    /// Only for the scene itself, which may not write there.
    InMemory,
}

/// Where a message goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Stream {
    Debug,
    Render,
    Statistics,
}

/// Files in memory, for tests; messages are kept.
#[derive(Debug, Default)]
pub struct Memory {
    files: Mutex<BTreeMap<PathBuf, Vec<u8>>>,
    messages: Mutex<String>,
}

impl Memory {
    /// Holding these files.
    pub fn new<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let files = files.into_iter().map(|(name, text)| (name.into(), text.as_bytes().to_vec())).collect();
        Self { files: Mutex::new(files), messages: Mutex::default() }
    }

    /// With one more file, which need not be text.
    #[must_use]
    pub fn with(self, name: &str, bytes: Vec<u8>) -> Self {
        lock(&self.files).insert(name.into(), bytes);
        self
    }

    /// Everything that was said so far.
    pub fn messages(&self) -> String {
        lock(&self.messages).clone()
    }

    /// The bytes of a file.
    pub fn file(&self, name: &str) -> Option<Vec<u8>> {
        lock(&self.files).get(Path::new(name)).cloned()
    }
}

/// A panic of another thread does not matter to plain data.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Host for Memory {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        lock(&self.files).get(path).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn status(&self, path: &Path) -> Status {
        if lock(&self.files).contains_key(path) { Status::Readable } else { Status::Absent }
    }

    fn create(&self, path: &Path) -> io::Result<Kept> {
        lock(&self.files).insert(path.into(), Vec::new());
        Ok(Kept::OnDisk)
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
        lock(&self.files).entry(path.into()).or_default().extend_from_slice(bytes);
        Ok(Kept::OnDisk)
    }

    fn message(&self, _: Stream, text: &str) {
        lock(&self.messages).push_str(text);
    }
}

/// Answers for scenes that ask nothing about their objects: nothing is hit, nothing is inside.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoQueries;

impl GeometryQueries for NoQueries {
    fn trace(&self, _: &Arc<Object>, _: &Ray) -> Option<(DVec3, DVec3)> {
        None
    }

    fn inside(&self, _: &Arc<Object>, _: DVec3) -> Option<bool> {
        Some(false)
    }

    fn extent(&self, _: &Arc<Object>) -> Bounds {
        Bounds::from_corners(DVec3::ZERO, DVec3::ZERO)
    }

    fn check(&self, _: &Arc<PointFunction>) -> Result<(), Diagnostic> {
        Ok(())
    }
}

impl Caller<PointFunction> for NoQueries {
    fn call(&self, _: &Arc<PointFunction>, _: &[f64]) -> [f64; 5] {
        [0.0; 5]
    }
}
