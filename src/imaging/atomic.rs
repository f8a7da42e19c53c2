//! Files that appear whole or not at all.

use super::ImageError;
use std::io::Write;
use std::path::Path;
use std::sync::{PoisonError, RwLock, RwLockWriteGuard};

/// Held by all who write, and alone by whoever wants to end the program.
static WRITING: RwLock<()> = RwLock::new(());

/// Waits until every file that is being written is whole, and lets no more be written while the result lives.
///
/// For the end of the program: a file that is half written would stay behind under another name.
pub fn pause_writing() -> RwLockWriteGuard<'static, ()> {
    WRITING.write().unwrap_or_else(PoisonError::into_inner)
}

/// Writes `bytes` to `path`, or to standard output for `-`.
///
/// A file is written beside its target under another name and then moved there, so an
/// interrupted run leaves neither half a file nor a damaged old one.
///
/// # Errors
/// [`ImageError::Io`] naming `path`.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), ImageError> {
    let fail = |error| ImageError::Io(path.to_owned(), error);
    let _whole = WRITING.read().unwrap_or_else(PoisonError::into_inner);
    if path == Path::new("-") {
        let mut out = std::io::stdout().lock();
        return out.write_all(bytes).and_then(|()| out.flush()).map_err(fail);
    }
    // Devices such as /dev/null cannot be replaced by a file.
    if path.metadata().is_ok_and(|m| !m.is_file() && !m.is_dir()) {
        return std::fs::write(path, bytes).map_err(fail);
    }
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".whitted-");
    // Temporary files are private by default; a picture should get the permissions of any new file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder).map_err(fail)?;
    file.write_all(bytes).and_then(|()| file.flush()).map_err(fail)?;
    file.persist(path).map_err(|e| fail(e.error))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_or_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.bin");
        write_whole(&path, b"one").unwrap();
        write_whole(&path, b"two").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"two");
        assert!(write_whole(&folder.path().join("missing/b.bin"), b"x").is_err());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary file is left");
    }
}
