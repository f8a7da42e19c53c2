//! Files by name, kept as long as each scene asks for them again.

use crate::imaging::Encoded;
use crate::syntax::Text;
use rustc_hash::FxHashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What can stand on a shelf.
pub(super) trait Volume {
    /// Whether both are made of the same bytes in the same way.
    fn is_like(&self, other: &Self) -> bool;
    /// How many bytes it is made of.
    fn size(&self) -> usize;
}

impl Volume for Text {
    fn is_like(&self, other: &Self) -> bool {
        self.bytes() == other.bytes()
    }

    fn size(&self) -> usize {
        self.bytes().len()
    }
}

impl Volume for Vec<u8> {
    fn is_like(&self, other: &Self) -> bool {
        self == other
    }

    fn size(&self) -> usize {
        self.len()
    }
}

impl Volume for Encoded {
    fn is_like(&self, other: &Self) -> bool {
        Encoded::is_like(self, other)
    }

    fn size(&self) -> usize {
        self.bytes().len()
    }
}

/// Files by name.
#[derive(Debug)]
pub(super) struct Shelf<T>(Mutex<Standing<T>>);

#[derive(Debug)]
struct Standing<T> {
    /// With whether the scene of now has asked for it.
    files: FxHashMap<PathBuf, (Arc<T>, bool)>,
    /// Bytes that may still be added.
    room: usize,
}

impl<T: Volume> Shelf<T> {
    /// For so many bytes.
    pub(super) fn with_room(room: usize) -> Self {
        Self(Mutex::new(Standing { files: FxHashMap::default(), room }))
    }

    /// A panic of another thread does not matter to plain data.
    fn standing(&self) -> MutexGuard<'_, Standing<T>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What stands there under that name, and true, if it is the same as `file`; else `file`, which takes its place, or
    /// is not kept where there is no room.
    pub(super) fn shared(&self, path: &Path, file: T) -> (Arc<T>, bool) {
        let standing = &mut *self.standing();
        if let Some((known, is_used)) = standing.files.get_mut(path)
            && known.is_like(&file)
        {
            *is_used = true;
            return (Arc::clone(known), true);
        }
        if let Some((old, _)) = standing.files.remove(path) {
            standing.room += old.size();
        }
        let file = Arc::new(file);
        if let Some(room) = standing.room.checked_sub(file.size()) {
            standing.room = room;
            standing.files.insert(path.to_owned(), (Arc::clone(&file), true));
        }
        (file, false)
    }

    /// Another scene begins: what the last one did not need is dropped.
    pub(super) fn begin_scene(&self) {
        let Standing { files, room } = &mut *self.standing();
        files.retain(|_, (file, is_used)| {
            let stays = std::mem::take(is_used);
            *room += if stays { 0 } else { file.size() };
            stays
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Asks for files in order, each with the room that is left behind it and whether it was known.
    fn check(shelf: &Shelf<Vec<u8>>, files: &[(&str, &[u8], usize, bool)]) {
        for (name, bytes, room, expected) in files {
            let (file, is_known) = shelf.shared(name.as_ref(), bytes.to_vec());
            assert_eq!((&file[..], is_known), (*bytes, *expected), "{name}");
            assert_eq!(shelf.standing().room, *room, "{name}");
        }
    }

    #[test]
    fn files_stand_there_while_they_are_asked_for_and_there_is_room() {
        let shelf = Shelf::with_room(9);
        check(&shelf, &[("a", b"12", 7, false), ("a", b"12", 7, true), ("b", b"12", 5, false)]);
        check(&shelf, &[("a", b"21", 5, false), ("a", b"123", 4, false), ("c", b"12345", 4, false)]);
        check(&shelf, &[("c", b"12345", 4, false)]);
        shelf.begin_scene();
        check(&shelf, &[("a", b"123", 4, true)]);
        shelf.begin_scene();
        check(&shelf, &[("b", b"12", 4, false), ("a", b"123", 4, true)]);
    }
}
