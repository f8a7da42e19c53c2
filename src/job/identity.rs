//! What makes a picture, as a number: two runs with the same one make the same picture.

use super::Job;
use crate::eval::{self, Host, Kept, Status, Stream};
use crate::imaging::Encoded;
use crate::syntax::Text;
use rustc_hash::FxHasher;
use std::fmt;
use std::hash::Hasher as _;
use std::io;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// A hash of all that a picture depends on: the bytes of all files that its scene has read, how they are read and
/// rendered, and the version of this program. The present, which `now` and `datetime` tell, is left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Identity(u128);

impl fmt::Display for Identity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

impl Identity {
    /// As eight and eight bytes, lowest first.
    pub(super) fn bytes(self) -> [u8; 16] {
        self.0.to_le_bytes()
    }

    /// Of a job whose scene has read such files.
    pub(super) fn new(job: &Job, digest: &Digest) -> Self {
        let reading = eval::Options { now: 0.0, ..job.reading.clone() };
        let files: Vec<_> = job.outputs.iter().map(|output| (output.kind, output.encoding)).collect();
        let said =
            format!("{} {reading:?} {:?} {:?} {files:?}", env!("CARGO_PKG_VERSION"), job.rendering, job.exposure);
        let mut digest = *digest;
        digest.add(said.as_bytes());
        let [low, high] = digest.0.map(u128::from);
        Self(high << 64 | low)
    }
}

/// Two numbers that all bytes so far have had a hand in.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Digest([u64; 2]);

impl Digest {
    /// One pass over the bytes: files may be large.
    fn add(&mut self, bytes: &[u8]) {
        /// Tells the two apart; any numbers do.
        const SEEDS: [u64; 2] = [0x9e37_79b9_7f4a_7c15, 0xc2b2_ae3d_27d4_eb4f];
        let mut hasher = FxHasher::default();
        hasher.write(bytes);
        let (whole, length) = (hasher.finish(), bytes.len());
        for (hash, seed) in self.0.iter_mut().zip(SEEDS) {
            let mut hasher = FxHasher::default();
            hasher.write_u64(*hash ^ seed);
            hasher.write_u64(whole);
            hasher.write_usize(length);
            *hash = hasher.finish();
        }
    }
}

/// A host that takes note of all that is read.
pub(super) struct Noting<'h> {
    host: &'h dyn Host,
    digest: Mutex<Digest>,
}

impl<'h> Noting<'h> {
    pub(super) fn new(host: &'h dyn Host) -> Self {
        Self { host, digest: Mutex::default() }
    }

    pub(super) fn digest(&self) -> Digest {
        *self.digest.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Host for Noting<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let bytes = self.host.read(path)?;
        self.digest.lock().unwrap_or_else(PoisonError::into_inner).add(&bytes);
        Ok(bytes)
    }

    fn status(&self, path: &Path) -> Status {
        self.host.status(path)
    }

    fn create(&self, path: &Path) -> io::Result<Kept> {
        self.host.create(path)
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
        self.host.append(path, bytes)
    }

    fn text(&self, path: &Path, text: Text) -> Arc<Text> {
        self.host.text(path, text)
    }

    fn font(&self, path: &Path, bytes: Vec<u8>) -> Arc<Vec<u8>> {
        self.host.font(path, bytes)
    }

    fn picture(&self, file: Encoded) -> Arc<Encoded> {
        self.host.picture(file)
    }

    fn message(&self, stream: Stream, text: &str) {
        self.host.message(stream, text);
    }

    fn progress(&self, what: &dyn Fn() -> String) {
        self.host.progress(what);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eval::Memory;

    #[test]
    fn whatever_makes_a_picture_makes_its_identity() {
        let identity = |text: &str, job: &Job| {
            let memory = Memory::new([("a.pov", text)]);
            let noting = Noting::new(&memory);
            noting.read("a.pov".as_ref()).unwrap();
            Identity::new(job, &noting.digest())
        };
        let job = Job::default();
        let mut later = job.clone();
        later.reading.now = 9000.5;
        let mut others = [job.clone(), job.clone(), job.clone()];
        others[0].reading.clock = 0.5;
        others[1].rendering.quality = 8;
        others[2].rendering.width = 321;
        let known = identity("sphere {}", &job);
        assert_eq!((known, known.to_string().len()), (identity("sphere {}", &later), 32));
        assert!(known != identity("sphere { }", &job));
        assert!(others.iter().all(|other| identity("sphere {}", other) != known));
    }
}
