//! The host that scenes run on outside of tests: the file system, with bounds.

use super::{Host, Kept, Status, Stream};
use rustc_hash::FxHashMap;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// What a scene may reach. A scene is a program from a stranger: it gets no more than is said here.
#[derive(Clone, Debug, Default)]
pub struct Reach {
    /// The scene's file. What lies below its folder may be read.
    pub scene: PathBuf,
    /// Folders that are searched for files; what lies below them may be read.
    pub include: Vec<PathBuf>,
    /// More folders whose files may be read.
    pub read: Vec<PathBuf>,
    /// Folders in which files may be written, and read.
    pub write: Vec<PathBuf>,
    /// The user's own folder: what lies below it may be read, but for what has a name that begins with a dot, where
    /// programs keep their secrets.
    pub home: Option<PathBuf>,
    /// The user trusts the scene with no more than its own folder and those that were named.
    pub untrusted: bool,
}

/// Files on disk, as far as a scene may reach; what it may not write stays in memory, for it to read again.
#[derive(Debug)]
pub struct Disk {
    /// Folders that the user named, and the scene itself: readable throughout.
    named: Vec<PathBuf>,
    /// Folders that nobody named: hidden names of the home folder are left out.
    implied: Vec<PathBuf>,
    home: Option<PathBuf>,
    writable: Vec<PathBuf>,
    written: Mutex<Written>,
    /// Receives the texts of `#debug` and its relatives.
    message: fn(Stream, &str),
    /// Is told what takes so long, and when it was last.
    observer: Option<fn(&str)>,
    told: Mutex<Instant>,
}

/// How often an observer is told anything.
const PATIENCE: Duration = Duration::from_secs(4);

/// What the scene has written.
#[derive(Debug, Default)]
struct Written {
    /// What the scene's names stand for, once it has opened them.
    targets: FxHashMap<PathBuf, Target>,
    /// Files in memory, by the place where they would lie.
    memory: FxHashMap<PathBuf, Vec<u8>>,
}

/// Where bytes go.
#[derive(Clone, Debug)]
enum Target {
    Disk(PathBuf),
    Memory(PathBuf),
}

/// Where systems keep their fonts: they stand in for those of POV-Ray, which on some systems are links to them.
pub(super) const FONT_FOLDERS: [&str; 5] = [
    "/usr/share/fonts/truetype",
    "/usr/share/fonts",
    "/usr/local/share/fonts",
    "/System/Library/Fonts",
    "C:/Windows/Fonts",
];

impl Disk {
    /// With these bounds; folders that do not exist count for nothing.
    pub fn new(reach: &Reach, message: fn(Stream, &str)) -> Self {
        let real = |p: &Path| fs::canonicalize(p).ok();
        let all = |folders: &[PathBuf]| folders.iter().filter_map(|p| real(p)).collect::<Vec<_>>();
        let writable = all(&reach.write);
        let mut named = all(&reach.include);
        named.extend(all(&reach.read));
        named.extend(writable.iter().cloned());
        named.extend(FONT_FOLDERS.iter().filter_map(|p| real(p.as_ref())));
        named.extend(real(&reach.scene));
        // Where everything is someone's home, it says nothing.
        let home = reach.home.as_deref().and_then(real).filter(|home| home.parent().is_some());
        let mut implied: Vec<PathBuf> = real(folder_of(&reach.scene)).into_iter().collect();
        if !reach.untrusted {
            implied.extend(real(Path::new(".")));
            implied.extend(home.clone());
        }
        Self {
            named,
            implied,
            home,
            writable,
            written: Mutex::default(),
            message,
            observer: None,
            told: Mutex::new(Instant::now()),
        }
    }

    /// With somebody who is told every few seconds what takes so long.
    #[must_use]
    pub fn observed(self, observer: Option<fn(&str)>) -> Self {
        Self { observer, ..self }
    }

    /// Whether a real path, links followed, may be read.
    fn may_read(&self, real: &Path) -> bool {
        let inner = |folder: &PathBuf| self.home.as_ref().is_some_and(|h| folder != h && folder.starts_with(h));
        let hidden = self.is_hidden(real);
        self.named.iter().any(|folder| real.starts_with(folder))
            || self.implied.iter().any(|folder| real.starts_with(folder) && (!hidden || inner(folder)))
    }

    /// Whether a name on the way from the home folder begins with a dot.
    fn is_hidden(&self, real: &Path) -> bool {
        let below = self.home.as_ref().and_then(|home| real.strip_prefix(home).ok());
        let dotted = |name: Component<'_>| name.as_os_str().as_encoded_bytes().starts_with(b".");
        below.is_some_and(|below| below.components().any(dotted))
    }

    /// The real path of a file to be read, if scenes may read there.
    fn source(&self, path: &Path) -> io::Result<PathBuf> {
        let real = fs::canonicalize(path)?;
        if self.may_read(&real) {
            return Ok(real);
        }
        let folder = folder_of(&real).display();
        let message = format!("scenes may not read there; --allow-read {folder} lets them");
        Err(io::Error::new(io::ErrorKind::PermissionDenied, message))
    }

    /// Where a file to be written lies, and whether scenes may write there; its folder must exist then.
    fn target(&self, path: &Path) -> Target {
        let real = place_of(path);
        // A link that leads nowhere would be followed on writing, wherever that is.
        let dangles = fs::read_link(path).is_ok() && fs::canonicalize(path).is_err();
        let allowed = !dangles && self.writable.iter().any(|folder| real.starts_with(folder));
        if allowed { Target::Disk(real) } else { Target::Memory(real) }
    }

    /// A panic of another thread does not matter to plain data.
    fn written(&self) -> MutexGuard<'_, Written> {
        self.written.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What the scene wrote under that name, if that stays in memory.
    fn remembered<T>(&self, path: &Path, with: impl FnOnce(&Vec<u8>) -> T) -> Option<T> {
        let written = self.written();
        if written.memory.is_empty() {
            return None;
        }
        written.memory.get(&place_of(path)).map(with)
    }
}

/// The folder of a file.
fn folder_of(file: &Path) -> &Path {
    file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The real path of a file that need not exist.
fn place_of(path: &Path) -> PathBuf {
    let beside = || Some(fs::canonicalize(folder_of(path)).ok()?.join(path.file_name()?));
    let named = || std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    fs::canonicalize(path).ok().or_else(beside).unwrap_or_else(named)
}

impl Host for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.remembered(path, Vec::clone) {
            Some(bytes) => Ok(bytes),
            None => fs::read(self.source(path)?),
        }
    }

    fn status(&self, path: &Path) -> Status {
        if self.remembered(path, |_| ()).is_some() {
            return Status::Readable;
        }
        match fs::canonicalize(path) {
            Ok(real) if !real.is_file() => Status::Absent,
            Ok(real) if self.may_read(&real) => Status::Readable,
            Ok(_) => Status::Refused,
            Err(_) => Status::Absent,
        }
    }

    fn create(&self, path: &Path) -> io::Result<Kept> {
        let target = self.target(path);
        let kept = match &target {
            Target::Disk(real) => {
                fs::write(real, [])?;
                Kept::OnDisk
            }
            Target::Memory(place) => {
                self.written().memory.insert(place.clone(), Vec::new());
                Kept::InMemory
            }
        };
        self.written().targets.insert(path.to_owned(), target);
        Ok(kept)
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
        let known = self.written().targets.get(path).cloned();
        let target = known.unwrap_or_else(|| self.target(path));
        match &target {
            Target::Disk(real) => {
                fs::OpenOptions::new().append(true).create(true).open(real)?.write_all(bytes)?;
                self.written().targets.insert(path.to_owned(), target);
                Ok(Kept::OnDisk)
            }
            Target::Memory(place) => {
                // What is added to stands on the disk as yet.
                let known = self.written().memory.contains_key(place);
                let before = if known { Vec::new() } else { self.read(path).unwrap_or_default() };
                let mut written = self.written();
                written.memory.entry(place.clone()).or_insert(before).extend_from_slice(bytes);
                if !written.targets.contains_key(path) {
                    written.targets.insert(path.to_owned(), target);
                }
                Ok(Kept::InMemory)
            }
        }
    }

    fn message(&self, stream: Stream, text: &str) {
        (self.message)(stream, text);
    }

    fn progress(&self, what: &dyn Fn() -> String) {
        let Some(observer) = self.observer else { return };
        let mut told = self.told.lock().unwrap_or_else(PoisonError::into_inner);
        if told.elapsed() >= PATIENCE {
            *told = Instant::now();
            observer(&what());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A home folder with a scene in `home/work/scene.pov`, and a folder beside it.
    fn folders() -> io::Result<tempfile::TempDir> {
        let root = tempfile::tempdir()?;
        for file in ["home/work/scene.pov", "home/work/.own", "home/lib.inc", "home/.secret/key", "other/file", "inc/a"]
        {
            let path = root.path().join(file);
            fs::create_dir_all(folder_of(&path))?;
            fs::write(path, file)?;
        }
        Ok(root)
    }

    fn reach(root: &Path) -> Reach {
        let scene = root.join("home/work/scene.pov");
        Reach { scene, include: vec![root.join("inc")], home: Some(root.join("home")), ..Reach::default() }
    }

    /// Whether a file may be read; what is refused names the option that would allow it.
    fn check(root: &Path, reach: &Reach, file: &str, expected: bool) {
        let (disk, path) = (Disk::new(reach, |_, _| {}), root.join(file));
        let wanted = if expected { Status::Readable } else { Status::Refused };
        assert_eq!(disk.status(&path), wanted, "{file} {reach:?}");
        match disk.read(&path) {
            Ok(_) => assert!(expected, "{file} was read"),
            Err(error) => assert!(!expected && error.to_string().contains("--allow-read /"), "{file}: {error}"),
        }
    }

    #[test]
    fn scenes_read_below_their_folders() -> io::Result<()> {
        let root = folders()?;
        let root = root.path();
        let usual = reach(root);
        let untrusted = Reach { untrusted: true, ..usual.clone() };
        let named = Reach { read: vec![root.join("other"), root.join("home/.secret")], ..usual.clone() };
        for reach in [&usual, &untrusted, &named] {
            for file in ["home/work/scene.pov", "home/work/.own", "inc/a", "other/../inc/a"] {
                check(root, reach, file, true);
            }
            check(root, reach, "home/lib.inc", !reach.untrusted);
            check(root, reach, "home/work/../lib.inc", !reach.untrusted);
            for file in ["other/file", "home/work/../../other/file", "home/.secret/key"] {
                check(root, reach, file, !reach.read.is_empty());
            }
            assert_eq!(Disk::new(reach, |_, _| {}).status(&root.join("home/none")), Status::Absent);
            assert_eq!(Disk::new(reach, |_, _| {}).status(&root.join("home/work")), Status::Absent);
        }
        // Whoever works in the home folder itself does not open what is hidden there.
        let at_home = Reach { scene: root.join("home/lib.inc"), ..usual.clone() };
        check(root, &at_home, "home/.secret/key", false);
        check(root, &Reach { untrusted: true, ..at_home }, "home/.secret/key", false);
        Ok(())
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_first() -> io::Result<()> {
        use std::os::unix::fs::symlink;
        let root = folders()?;
        let root = root.path();
        for (to, from) in [
            ("other/file", "home/work/out"),
            ("home/.secret", "home/work/folder"),
            ("home/lib.inc", "inc/in"),
            ("home/work/scene.pov", "other/scene.pov"),
        ] {
            symlink(root.join(to), root.join(from))?;
        }
        let reach = reach(root);
        check(root, &reach, "home/work/out", false);
        check(root, &reach, "home/work/folder/key", false);
        check(root, &reach, "inc/in", true);
        check(root, &Reach { untrusted: true, ..reach.clone() }, "inc/in", false);
        // The scene itself is what the user named, wherever it lies.
        let link = Reach { scene: root.join("other/scene.pov"), home: None, ..reach };
        check(root, &link, "other/scene.pov", true);
        // A link to nowhere does not lead writing out of a folder.
        symlink(root.join("other/new"), root.join("home/work/new"))?;
        let disk = Disk::new(&Reach { write: vec![root.join("home/work")], ..link }, |_, _| {});
        for name in ["home/work/new", "home/work/out"] {
            assert_eq!(disk.create(&root.join(name))?, Kept::InMemory, "{name}");
        }
        assert!(!root.join("other/new").exists());
        assert_eq!(fs::read(root.join("other/file"))?, b"other/file");
        Ok(())
    }

    /// What a scene wrote is what it reads, under whatever name, on the disk and in memory.
    #[test]
    fn scenes_read_what_they_wrote() -> io::Result<()> {
        let root = folders()?;
        let root = root.path();
        for (write, kept) in [(vec![], Kept::InMemory), (vec![root.join("home")], Kept::OnDisk)] {
            let disk = Disk::new(&Reach { write, ..reach(root) }, |_, _| {});
            let (name, other) = (root.join("home/lib.inc"), root.join("home/work/../lib.inc"));
            assert_eq!(disk.append(&name, b"+")?, kept);
            assert_eq!(disk.read(&other)?, b"home/lib.inc+");
            assert_eq!(disk.create(&other)?, kept);
            assert_eq!(disk.append(&other, b"new")?, kept);
            assert_eq!(disk.read(&name)?, b"new");
            assert_eq!(fs::read(&name)? == b"new", kept == Kept::OnDisk);
            fs::write(&name, "home/lib.inc")?;
        }
        let disk = Disk::new(&reach(root), |_, _| {});
        assert_eq!(disk.create(&root.join("nowhere/new"))?, Kept::InMemory);
        assert_eq!(disk.status(&root.join("nowhere/new")), Status::Readable);
        Ok(())
    }
}
