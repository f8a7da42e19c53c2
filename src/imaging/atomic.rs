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
    let folder = folder_of(path);
    let prefix = format!("{}{}-", left_by_others(path), std::process::id());
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix);
    // Temporary files are private by default; a picture should get the permissions of any new file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder).map_err(fail)?;
    // Past the wrapper, whose errors name the file that nobody knows.
    file.as_file_mut().write_all(bytes).map_err(fail)?;
    file.persist(path).map_err(|e| fail(e.error))?;
    Ok(())
}

/// Finds out whether a file could be written, without touching it.
///
/// # Errors
/// [`ImageError::Io`] naming `path`, as [`write_whole`] would have it.
pub fn check_writable(path: &Path) -> Result<(), ImageError> {
    if path == Path::new("-") || path.metadata().is_ok_and(|m| !m.is_file() && !m.is_dir()) {
        return Ok(());
    }
    let tried = if path.is_dir() {
        Err(std::io::ErrorKind::IsADirectory.into())
    } else {
        tempfile::tempfile_in(folder_of(path)).map(drop)
    };
    tried.map_err(|error| ImageError::Io(path.to_owned(), error))
}

/// How the names begin under which a file is written before it is whole; the number of the process follows.
fn left_by_others(path: &Path) -> String {
    format!(".{}.whitted-", path.file_name().unwrap_or_default().to_string_lossy())
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Removes what programs have left behind that were killed while they wrote this file.
///
/// Only where it can be told that they are gone: on Linux.
pub fn sweep(path: &Path) {
    let prefix = left_by_others(path);
    for entry in std::fs::read_dir(folder_of(path)).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let process = name.to_str().and_then(|name| name.strip_prefix(&prefix)?.split('-').next()?.parse::<u32>().ok());
        let is_gone =
            |process: u32| Path::new("/proc/self").exists() && !Path::new(&format!("/proc/{process}")).exists();
        if process.is_some_and(is_gone) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
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

    #[test]
    #[cfg(target_os = "linux")]
    fn what_the_dead_have_left_is_swept_away() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str| folder.path().join(name);
        let own = format!(".a.png.whitted-{}-x", std::process::id());
        // Linux numbers processes up to 2^22.
        for name in [".a.png.whitted-4194305-x", &own, ".b.png.whitted-4194305-x", "a.png"] {
            std::fs::write(file(name), "").unwrap();
        }
        sweep(&file("a.png"));
        assert!(!file(".a.png.whitted-4194305-x").exists());
        assert!([own.as_str(), ".b.png.whitted-4194305-x", "a.png"].iter().all(|name| file(name).exists()));
    }
}
