//! The outside as a scene sees it: files that are looked for in folders, read once, opened and written.
//!
//! Everything goes through [`Host`]; nothing here knows of tokens that stand around a file's name, or of messages.

use super::data_file::DataFile;
use super::standard_includes::{advice_on_file, standard_include, standard_include_names};
use super::{Host, Kept, Status, Stream};
use crate::diag::nearest;
use crate::imaging::Encoded;
use crate::scene::ImageFormat;
use crate::syntax::Text;
use rustc_hash::FxHashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reaches what lies outside for a scene.
pub(super) struct World<'h> {
    host: &'h dyn Host,
    /// Folders that are searched after the working directory, in order.
    folders: &'h [PathBuf],
    /// By their numbers.
    open: Vec<Option<OpenFile>>,
    /// Files that were read as a whole, so that each is read once for all statements that name it; what the scene
    /// writes may change them.
    pictures: FxHashMap<(PathBuf, ImageFormat), Arc<Encoded>>,
    fonts: FxHashMap<PathBuf, Arc<Vec<u8>>>,
}

/// A file that a scene opened.
#[derive(Debug)]
pub(super) enum OpenFile {
    /// For reading.
    Reading(Box<DataFile>),
    /// For writing.
    Writing(PathBuf),
}

/// Why there is no text to include.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Missing {
    /// It was found, but cannot be read; why.
    Unreadable(String),
    /// There is none of that name; what may help.
    Unknown(String),
}

/// What to say of a file that was found.
pub(super) fn unreadable(path: &Path, problem: &io::Error) -> String {
    format!("cannot read {}: {problem}", path.display())
}

impl<'h> World<'h> {
    /// What a host gives, with folders to look for files in.
    pub(super) fn new(host: &'h dyn Host, folders: &'h [PathBuf]) -> Self {
        Self { host, folders, open: Vec::new(), pictures: FxHashMap::default(), fonts: FxHashMap::default() }
    }

    /// Looks for a file: the name with each extension in turn (none given: the name itself), each
    /// in the working directory, then in the include folders in order.
    ///
    /// As a last resort, which POV-Ray does not have, in the folders `beside`, those of the files that name it, so that a
    /// scene can be rendered from anywhere. Of files that may not be read the first is found where there is no other,
    /// so that reading it says why.
    pub(super) fn find(&self, name: &str, extensions: &[&str], beside: &[PathBuf]) -> Option<PathBuf> {
        let extensions = if extensions.is_empty() { &[""] } else { extensions };
        let candidates: Vec<PathBuf> = extensions.iter().map(|e| PathBuf::from(format!("{name}{e}"))).collect();
        let within = |candidate: &PathBuf, folders: &[PathBuf]| -> Vec<PathBuf> {
            if candidate.is_absolute() { Vec::new() } else { folders.iter().map(|f| f.join(candidate)).collect() }
        };
        let usual = candidates
            .iter()
            .flat_map(|candidate| std::iter::once(candidate.clone()).chain(within(candidate, self.folders)));
        let beside = candidates.iter().flat_map(|candidate| within(candidate, beside));
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
    pub(super) fn has(&self, name: &str, beside: &[PathBuf]) -> bool {
        self.find(name, &[], beside).is_some_and(|path| self.host.status(&path) == Status::Readable)
    }

    /// The bytes of a file that was found, or what to say.
    pub(super) fn bytes(&self, path: &Path) -> Result<Vec<u8>, String> {
        self.host.read(path).map_err(|problem| unreadable(path, &problem))
    }

    /// The file that `#include` names, or what comes with this program under that name.
    pub(super) fn include(&self, name: &str, beside: &[PathBuf]) -> Result<(PathBuf, Vec<u8>), Missing> {
        let extensions: &[&str] = if name.ends_with(".inc") || name.ends_with(".INC") {
            &["", ".inc", ".INC"]
        } else {
            &[".inc", ".INC", ""]
        };
        if let Some(path) = self.find(name, extensions, beside) {
            let text = self.bytes(&path).map_err(Missing::Unreadable)?;
            return Ok((path, text));
        }
        let mut names = extensions.iter().map(|extension| format!("{name}{extension}"));
        if let Some((name, text)) = names.find_map(|name| standard_include(&name).map(|text| (name, text))) {
            return Ok((PathBuf::from(format!("{name} (embedded)")), text.into()));
        }
        let near = || nearest(name, standard_include_names()).map(|near| format!("did you mean '{near}'?"));
        let hint = advice_on_file(name)
            .or_else(near)
            .unwrap_or_else(|| "folders to look in can be given with --include DIR".into());
        Err(Missing::Unknown(hint))
    }

    /// A scene or include file that was read, or the same one as it was read before.
    pub(super) fn text(&self, path: &Path, bytes: Vec<u8>) -> Arc<Text> {
        self.host.text(path, Text::new(bytes))
    }

    /// A picture that was found, or what to say.
    pub(super) fn picture(&mut self, path: PathBuf, format: ImageFormat) -> Result<Arc<Encoded>, String> {
        let key = (path, format);
        if let Some(known) = self.pictures.get(&key) {
            return Ok(Arc::clone(known));
        }
        let bytes = self.bytes(&key.0)?;
        let file = self.host.picture(Encoded::new(key.0.clone(), format.decoder(), bytes));
        self.pictures.insert(key, Arc::clone(&file));
        Ok(file)
    }

    /// A font that was found.
    pub(super) fn font(&mut self, path: &Path) -> io::Result<Arc<Vec<u8>>> {
        if let Some(known) = self.fonts.get(path) {
            return Ok(Arc::clone(known));
        }
        let font = self.host.font(path, self.host.read(path)?);
        self.fonts.insert(path.to_owned(), Arc::clone(&font));
        Ok(font)
    }

    /// Creates a file, or goes on with one.
    pub(super) fn create(&mut self, path: &Path, append: bool) -> io::Result<Kept> {
        self.forget();
        if append { self.host.append(path, &[]) } else { self.host.create(path) }
    }

    /// Adds bytes to a file.
    pub(super) fn append(&mut self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
        self.forget();
        self.host.append(path, bytes)
    }

    /// What is written may be what was read.
    fn forget(&mut self) {
        self.pictures.clear();
        self.fonts.clear();
    }

    /// Keeps an open file; its number.
    pub(super) fn keep(&mut self, file: OpenFile) -> usize {
        let number = self.open.iter().position(Option::is_none).unwrap_or(self.open.len());
        if number == self.open.len() {
            self.open.push(None);
        }
        self.open[number] = Some(file);
        number
    }

    /// An open file.
    pub(super) fn opened(&mut self, number: usize) -> Option<&mut OpenFile> {
        self.open.get_mut(number)?.as_mut()
    }

    /// Closes a file.
    pub(super) fn close(&mut self, number: usize) {
        if let Some(file) = self.open.get_mut(number) {
            *file = None;
        }
    }

    /// A text of `#debug`, `#render` or `#statistics`.
    pub(super) fn say(&self, stream: Stream, text: &str) {
        self.host.message(stream, text);
    }

    /// Lets the host know, if it asks, what a scene is at.
    pub(super) fn progress(&self, what: &dyn Fn() -> String) {
        self.host.progress(what);
    }
}

#[cfg(test)]
mod tests {
    use super::{Missing, OpenFile, World};
    use crate::eval::{Memory, Stream};
    use std::path::{Path, PathBuf};

    fn folders(names: &[&str]) -> Vec<PathBuf> {
        names.iter().map(PathBuf::from).collect()
    }

    #[test]
    fn files_are_found_in_order() {
        let host = Memory::new([("a.inc", "1"), ("lib/a.inc", "2"), ("lib/b.inc", "3"), ("scenes/c.inc", "4")]);
        let (library, beside) = (folders(&["lib"]), folders(&["scenes"]));
        let world = World::new(&host, &library);
        let find = |name, extensions: &[&str]| world.find(name, extensions, &beside);
        assert_eq!(find("a.inc", &[]), Some("a.inc".into()));
        assert_eq!(find("b", &["", ".inc"]), Some("lib/b.inc".into()));
        assert_eq!(find("c.inc", &[]), Some("scenes/c.inc".into()));
        assert!(find("d.inc", &[]).is_none() && !world.has("d.inc", &beside) && world.has("c.inc", &beside));
        assert!(world.find("c.inc", &[], &[]).is_none());
    }

    #[test]
    fn includes_come_from_files_or_with_the_program() {
        let host = Memory::new([("own.inc", "text"), ("colors.inc", "mine")]);
        let world = World::new(&host, &[]);
        assert_eq!(world.include("own", &[]), Ok(("own.inc".into(), b"text".to_vec())));
        assert_eq!(world.include("colors.inc", &[]), Ok(("colors.inc".into(), b"mine".to_vec())));
        assert!(world.include("shapes.inc", &[]).is_ok_and(|(path, _)| path == Path::new("shapes.inc (embedded)")));
        let hint = Missing::Unknown("did you mean 'textures.inc'?".into());
        assert_eq!(world.include("texturs.inc", &[]), Err(hint));
    }

    #[test]
    fn what_is_written_is_read_anew() {
        let host = Memory::new([("a.ttf", "old")]);
        let mut world = World::new(&host, &[]);
        let path = Path::new("a.ttf");
        let font = |world: &mut World<'_>| world.font(path).map(|bytes| bytes.to_vec()).unwrap_or_default();
        assert_eq!(font(&mut world), b"old");
        assert!(world.create(path, false).is_ok() && world.append(path, b"new").is_ok());
        assert_eq!(font(&mut world), b"new");
        assert_eq!(world.bytes(Path::new("b")), Err("cannot read b: entity not found".into()));
    }

    #[test]
    fn numbers_of_closed_files_are_given_again() {
        let host = Memory::default();
        let mut world = World::new(&host, &[]);
        let write = |name: &str| OpenFile::Writing(name.into());
        assert_eq!((world.keep(write("a")), world.keep(write("b"))), (0, 1));
        world.close(0);
        assert!(world.opened(0).is_none() && world.opened(1).is_some() && world.opened(9).is_none());
        assert_eq!(world.keep(write("c")), 0);
        world.say(Stream::Debug, "done");
        assert_eq!(host.messages(), "done");
    }
}
