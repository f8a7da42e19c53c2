//! Finished pieces of a picture on disk, to go on from should the work be interrupted.
//!
//! The file begins with a word and the picture's identity. Behind that pieces follow in any order, each with a checksum;
//! one that is cut off or damaged, and what stands behind it, counts for nothing. Numbers have their lowest byte first.

use super::Identity;
use crate::render::{Observer, Piece, Place, Statistics};
use rustc_hash::{FxHashMap, FxHasher};
use std::fs::{File, OpenOptions};
use std::hash::Hasher as _;
use std::io::{self, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

const WORD: &[u8; 16] = b"whitted state 1\n";
/// Stage, column, row, number of samples.
const HEAD: usize = 4 * 4;
const COUNTS: usize = 6 * 8;
const SAMPLE: usize = 4 * 4;
const CHECKSUM: usize = 8;

/// The pieces of one picture.
#[derive(Debug)]
pub(super) struct State {
    path: PathBuf,
    known: FxHashMap<Place, Piece>,
    since: Instant,
    /// How long after that pieces begin to be kept.
    patience: Duration,
    journal: Mutex<Journal>,
}

/// What is written piece by piece.
#[derive(Debug)]
struct Journal {
    /// Bytes of the file that stay.
    valid: u64,
    /// Not written as yet.
    waiting: Vec<u8>,
    file: Option<File>,
    /// Nothing more is written: what cannot be kept is made again.
    failed: bool,
}

/// The state file of a picture.
pub(super) fn state_file(picture: &Path) -> PathBuf {
    let mut name = picture.as_os_str().to_owned();
    name.push(".whitted-state");
    name.into()
}

/// What is known of a picture from an earlier run.
#[derive(Debug, PartialEq)]
pub enum Earlier {
    /// No file, or nothing in it.
    Nothing,
    /// A file of another picture.
    Other,
    /// So many pieces.
    Pieces(usize),
}

impl State {
    /// Takes what an earlier run of the same picture has left if that is wanted; nothing is written before the first piece
    /// that is made after the patience.
    pub(super) fn open(path: PathBuf, identity: Identity, resumes: bool, patience: Duration) -> (Self, Earlier) {
        let head = [WORD, &identity.bytes()[..]].concat();
        let bytes = if resumes { std::fs::read(&path).unwrap_or_default() } else { Vec::new() };
        let (known, valid, earlier) = match bytes.strip_prefix(&head[..]) {
            Some(rest) => {
                let (known, length) = pieces(rest);
                let earlier = Earlier::Pieces(known.len());
                (known, head.len() + length, earlier)
            }
            None if bytes.is_empty() => (FxHashMap::default(), 0, Earlier::Nothing),
            None => (FxHashMap::default(), 0, Earlier::Other),
        };
        let waiting = if valid > 0 { Vec::new() } else { head };
        let journal = Journal { valid: valid as u64, waiting, file: None, failed: false };
        (Self { path, known, since: Instant::now(), patience, journal: Mutex::new(journal) }, earlier)
    }

    /// A panic of another thread does not matter to plain data.
    fn journal(&self) -> MutexGuard<'_, Journal> {
        self.journal.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The picture is in its file: nothing stays.
    pub(super) fn discard(&self) {
        self.journal().file = None;
        let _ = std::fs::remove_file(&self.path);
    }

    /// Whether the picture has taken so long that its pieces are worth more than what it costs to keep them.
    fn keeps(&self) -> bool {
        self.since.elapsed() >= self.patience
    }

    fn known(&self, place: Place) -> Option<Piece> {
        self.known.get(&place).cloned()
    }

    fn keep(&self, piece: &Piece) {
        let journal = &mut *self.journal();
        append(&mut journal.waiting, piece);
        journal.write(&self.path);
    }
}

impl Journal {
    /// Adds what waits to the file in one piece; after an error, nothing more.
    fn write(&mut self, path: &Path) {
        self.failed = self.failed || self.try_write(path).is_err();
        self.waiting.clear();
    }

    fn try_write(&mut self, path: &Path) -> io::Result<()> {
        let file = match &mut self.file {
            Some(file) => file,
            none => {
                let mut file = OpenOptions::new().write(true).create(true).truncate(false).open(path)?;
                file.set_len(self.valid)?;
                file.seek(SeekFrom::End(0))?;
                none.insert(file)
            }
        };
        file.write_all(&self.waiting)
    }
}

/// As the file has it.
fn append(bytes: &mut Vec<u8>, piece: &Piece) {
    let start = bytes.len();
    let Place { stage, x, y } = piece.place;
    for number in [stage, x, y, piece.samples.len() as u32] {
        bytes.extend(number.to_le_bytes());
    }
    piece.statistics.counts().iter().for_each(|count| bytes.extend(count.to_le_bytes()));
    piece.samples.iter().flatten().for_each(|value| bytes.extend(value.to_le_bytes()));
    let sum = checksum(&bytes[start..]);
    bytes.extend(sum.to_le_bytes());
}

fn checksum(bytes: &[u8]) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write(bytes);
    hasher.finish()
}

/// All whole pieces up to the first that is not, and how many bytes they take up.
fn pieces(bytes: &[u8]) -> (FxHashMap<Place, Piece>, usize) {
    let (mut found, mut left) = (FxHashMap::default(), bytes);
    while let Some((piece, rest)) = first_piece(left) {
        found.insert(piece.place, piece);
        left = rest;
    }
    (found, bytes.len() - left.len())
}

fn first_piece(bytes: &[u8]) -> Option<(Piece, &[u8])> {
    let word = |at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    let n_samples = word(12)? as usize;
    let length = HEAD + COUNTS + n_samples.checked_mul(SAMPLE)?;
    let (body, rest) = (bytes.get(..length)?, bytes.get(length + CHECKSUM..)?);
    let sum = u64::from_le_bytes(bytes[length..length + CHECKSUM].try_into().ok()?);
    if sum != checksum(body) {
        return None;
    }
    let (counts, samples) = body[HEAD..].split_at(COUNTS);
    let mut numbers = counts.chunks_exact(8).map(|chunk| u64::from_le_bytes(chunk.try_into().unwrap_or_default()));
    let counts = std::array::from_fn(|_| numbers.next().unwrap_or_default());
    let value = |chunk: &[u8]| f32::from_le_bytes(chunk.try_into().unwrap_or_default());
    let sample = |chunk: &[u8]| std::array::from_fn(|i| value(&chunk[4 * i..4 * i + 4]));
    let piece = Piece {
        place: Place { stage: word(0)?, x: word(4)?, y: word(8)? },
        samples: samples.chunks_exact(SAMPLE).map(sample).collect(),
        statistics: Statistics::from_counts(counts),
    };
    Some((piece, rest))
}

/// An observer whose picture is kept piece by piece.
pub(super) struct Keeping<'s> {
    pub(super) observer: &'s dyn Observer,
    pub(super) state: &'s State,
}

impl Observer for Keeping<'_> {
    fn advanced(&self, done: usize, of: usize) {
        self.observer.advanced(done, of);
    }

    fn finished(&self, block: &crate::render::FinishedBlock) {
        self.observer.finished(block);
    }

    fn wants_blocks(&self) -> bool {
        self.observer.wants_blocks()
    }

    fn keeps(&self) -> bool {
        self.state.keeps()
    }

    fn keep(&self, piece: Piece) {
        self.state.keep(&piece);
    }

    fn kept(&self, place: Place) -> Option<Piece> {
        self.state.known(place)
    }

    fn cancels(&self) -> bool {
        self.observer.cancels()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(x: u32) -> Piece {
        let samples = vec![[x as f32, 0.25, f32::INFINITY, -0.0]; 5];
        let statistics = Statistics { camera_rays: u64::from(x), shadow_rays: 7, ..Statistics::default() };
        Piece { place: Place { stage: 1, x, y: 2 }, samples, statistics }
    }

    /// What is known after the end of a file is changed.
    fn check(change: impl Fn(&mut Vec<u8>), identity: u8, expected: &Earlier) {
        let folder = tempfile::tempdir().unwrap();
        let path = state_file(&folder.path().join("a.png"));
        let known = Identity::default();
        let (state, earlier) = State::open(path.clone(), known, true, Duration::ZERO);
        assert_eq!(earlier, Earlier::Nothing);
        (0..3).for_each(|x| state.keep(&piece(x)));
        let mut bytes = std::fs::read(&path).unwrap();
        bytes[16] ^= identity;
        change(&mut bytes);
        std::fs::write(&path, bytes).unwrap();
        let (state, earlier) = State::open(path.clone(), known, true, Duration::ZERO);
        assert_eq!(earlier, *expected);
        if let Earlier::Pieces(n) = expected {
            let found = (0..3).filter(|x| state.known(piece(*x).place) == Some(piece(*x))).count();
            assert_eq!(found, *n);
        }
        state.discard();
        assert!(!path.exists());
    }

    #[test]
    fn whole_pieces_come_back_and_others_do_not() {
        check(|_| {}, 0, &Earlier::Pieces(3));
        check(|bytes| bytes.truncate(bytes.len() - 1), 0, &Earlier::Pieces(2));
        check(|bytes| bytes.truncate(33), 0, &Earlier::Pieces(0));
        check(|bytes| bytes.truncate(20), 0, &Earlier::Other);
        check(|bytes| bytes.clear(), 0, &Earlier::Nothing);
        check(|bytes| bytes.extend([0xff; 70]), 0, &Earlier::Pieces(3));
        check(|bytes| *bytes.last_mut().unwrap() ^= 1, 0, &Earlier::Pieces(2));
        check(|bytes| bytes[60] ^= 1, 0, &Earlier::Pieces(0));
        check(|_| {}, 1, &Earlier::Other);
    }
}
