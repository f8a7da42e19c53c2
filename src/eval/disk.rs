//! The host that scenes run on outside of tests: the file system, with bounds.

use super::{Host, Stream};
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// Files on disk. A scene is a program from a stranger: it reads only below certain folders
/// and writes only where it was allowed to.
#[derive(Debug)]
pub struct Disk {
    readable: Vec<PathBuf>,
    /// Folders that the user named: links in them were put there on purpose and are followed anywhere.
    trusted: Vec<PathBuf>,
    writable: Vec<PathBuf>,
    /// Receives the texts of `#debug` and its relatives.
    message: fn(Stream, &str),
}

impl Disk {
    /// Reading below the scene's folder, the working directory and `folders` (the include
    /// paths and what else the user named); writing below `writable`.
    pub fn new(scene: &Path, folders: &[PathBuf], writable: &[PathBuf], message: fn(Stream, &str)) -> Self {
        let beside = scene.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let real = |p: &Path| fs::canonicalize(p).ok();
        let mut readable: Vec<PathBuf> = [beside, Path::new(".")].into_iter().filter_map(real).collect();
        readable.extend(folders.iter().filter_map(|p| real(p)));
        let writable: Vec<PathBuf> = writable.iter().filter_map(|p| real(p)).collect();
        readable.extend(writable.iter().cloned());
        let trusted = folders.iter().filter_map(|p| real(p)).collect();
        Self { readable, trusted, writable, message }
    }

    /// Where a file to be read lies, if scenes may read there.
    fn source(&self, path: &Path) -> io::Result<PathBuf> {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if self.trusted.contains(&fs::canonicalize(folder)?) {
            return Ok(path.to_owned());
        }
        Self::permitted(path, &self.readable)
    }

    /// The real path, links followed, if it lies below one of the folders.
    fn permitted(path: &Path, folders: &[PathBuf]) -> io::Result<PathBuf> {
        let real = fs::canonicalize(path)?;
        if folders.iter().any(|folder| real.starts_with(folder)) {
            return Ok(real);
        }
        Err(io::Error::new(io::ErrorKind::PermissionDenied, "it lies outside of the folders a scene may use"))
    }

    /// Where a file to be written lies, if scenes may write there; its folder must exist.
    fn target(&self, path: &Path) -> io::Result<PathBuf> {
        let denied = || io::Error::new(io::ErrorKind::PermissionDenied, "scenes may not write here");
        if fs::symlink_metadata(path).is_ok() {
            return Self::permitted(path, &self.writable).map_err(|_| denied());
        }
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let name = path.file_name().ok_or_else(denied)?;
        Ok(Self::permitted(folder, &self.writable).map_err(|_| denied())?.join(name))
    }
}

impl Host for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        fs::read(self.source(path)?)
    }

    fn exists(&self, path: &Path) -> bool {
        path.is_file()
    }

    fn create(&self, path: &Path) -> io::Result<()> {
        fs::write(self.target(path)?, [])
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let mut file = fs::OpenOptions::new().append(true).create(true).open(self.target(path)?)?;
        file.write_all(bytes)
    }

    fn message(&self, stream: Stream, text: &str) {
        (self.message)(stream, text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_stay_in_their_folders() -> io::Result<()> {
        let (home, other) = (tempfile::tempdir()?, tempfile::tempdir()?);
        fs::write(home.path().join("a.pov"), "a")?;
        fs::write(other.path().join("secret"), "s")?;
        let disk = Disk::new(&home.path().join("a.pov"), &[], &[], |_, _| {});
        assert_eq!(disk.read(&home.path().join("a.pov"))?, b"a");
        assert!(disk.read(&other.path().join("secret")).is_err());
        let around = home.path().join("..").join(other.path().file_name().unwrap_or_default()).join("secret");
        assert!(disk.exists(&around) && disk.read(&around).is_err());
        assert!(disk.create(&home.path().join("new")).is_err());
        let disk = Disk::new(&home.path().join("a.pov"), &[], &[other.path().into()], |_, _| {});
        disk.create(&other.path().join("new"))?;
        disk.append(&other.path().join("new"), b"xy")?;
        assert_eq!(fs::read(other.path().join("new"))?, b"xy");
        Ok(())
    }
}
