//! Where the include files of an installed POV-Ray may be.

use std::path::{Path, PathBuf};

/// The named folders, then `$POVINC`, then those of an installed POV-Ray that exist; only the named ones with
/// `embedded`, so that the include files of this program are found.
pub(super) fn search_path(named: &[PathBuf], embedded: bool) -> Vec<PathBuf> {
    let mut folders = named.to_vec();
    if embedded {
        return folders;
    }
    if let Some(list) = std::env::var_os("POVINC") {
        folders.extend(std::env::split_paths(&list));
    }
    folders.extend(installed().into_iter().filter(|folder| folder.is_dir()));
    folders
}

fn installed() -> Vec<PathBuf> {
    let mut folders = Vec::new();
    for root in ["/usr/share", "/usr/local/share", "/opt/local/share", "/opt/homebrew/share"] {
        folders.extend(["povray-3.7", "povray-3.8", "povray"].map(|name| Path::new(root).join(name).join("include")));
    }
    // Windows installs for one user below the documents and for all below the programs.
    let windows = [("USERPROFILE", "Documents/POV-Ray"), ("ProgramFiles", "POV-Ray")];
    for (variable, below) in windows {
        if let Some(root) = std::env::var_os(variable) {
            folders.extend(["v3.7", "v3.8"].map(|v| Path::new(&root).join(below).join(v).join("include")));
        }
    }
    if let Some(home) = std::env::var_os("HOME") {
        folders.push(Path::new(&home).join("Library/Application Support/POV-Ray/include"));
    }
    folders
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_folders_come_first() {
        let named = [PathBuf::from("/nowhere/at/all")];
        assert_eq!(search_path(&named, false)[0], named[0]);
        assert_eq!(search_path(&named, true), named);
    }
}
