//! Where the scene is found and how its pictures are called.
//!
//! Source: command line facts, section 3.

use super::settings::Settings;
use std::path::{Path, PathBuf};

/// How the scene is called that comes through standard input.
pub(super) const STANDARD_INPUT: &str = "-";

/// Whether a picture's name stands for standard output.
pub(super) fn is_standard_output(name: &str) -> bool {
    name == "-" || name == "stdout"
}

/// The scene's file: as named, then with `.pov` and `.POV`, from here and then from the library.
///
/// # Errors
/// The name itself, if there is no such file.
pub(super) fn scene(name: &Path, library: &[PathBuf]) -> Result<PathBuf, String> {
    if name == Path::new(STANDARD_INPUT) || name == Path::new("/dev/stdin") {
        return Ok(STANDARD_INPUT.into());
    }
    let folders = std::iter::once(Path::new("")).chain(library.iter().map(PathBuf::as_path));
    let endings = ["", ".pov", ".POV"];
    let with = |folder: &Path, ending: &str| {
        let mut path = folder.join(name).into_os_string();
        path.push(ending);
        PathBuf::from(path)
    };
    let mut places = folders.flat_map(|folder| endings.map(|ending| with(folder, ending)));
    places.find(|place| place.is_file()).ok_or_else(|| name.display().to_string())
}

/// The picture's file, with a frame's number of so many digits; `-` for standard output.
pub(super) fn picture(settings: &Settings, frame: Option<(u32, usize)>) -> PathBuf {
    let ending = settings.kind.extension();
    let named = settings.scene.clone().unwrap_or_default();
    let is_stdin = [STANDARD_INPUT, "/dev/stdin"].iter().any(|name| named == Path::new(name));
    let own = if is_stdin { "stdin".into() } else { named.with_extension("") };
    let number = frame.map_or_else(String::new, |(number, digits)| format!("{number:0digits$}"));
    let stem = match settings.output.as_deref() {
        Some(name) if is_standard_output(name) => return "-".into(),
        None => own.to_string_lossy().into_owned(),
        Some(name) => {
            let stem = name.strip_suffix(ending).or_else(|| name.strip_suffix('.')).unwrap_or(name);
            let file = own.file_name().unwrap_or_default().to_string_lossy();
            let lacks_name = (stem.is_empty() || stem.ends_with('/')) && !name.ends_with('.');
            if lacks_name { format!("{stem}{file}") } else { stem.into() }
        }
    };
    format!("{stem}{number}{ending}").into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::FileKind;

    fn check(scene: &str, output: &str, kind: FileKind, frame: Option<(u32, usize)>, expected: &str) {
        let output = (!output.is_empty()).then(|| output.to_owned());
        let settings = Settings { scene: Some(scene.into()), output, kind, ..Settings::default() };
        assert_eq!(picture(&settings, frame), PathBuf::from(expected));
    }

    #[test]
    fn pictures_are_called_as_in_povray() {
        let (png, tga) = (FileKind::Png, FileKind::Tga { packed: false });
        check("sub/t.pov", "", png, None, "sub/t.png");
        check("x.y.pov", "", png, None, "x.y.png");
        check("noext", "", FileKind::Exr, None, "noext.exr");
        for (output, expected) in [("out", "out.png"), ("out.", "out.png"), ("out.png", "out.png")] {
            check("s.pov", output, png, None, expected);
        }
        check("s.pov", "out.PNG", png, None, "out.PNG.png");
        check("s.pov", "out.jpeg", FileKind::Jpeg, None, "out.jpeg.jpg");
        check("s.pov", ".png", png, None, "s.png");
        check("s.pov", "d/.", png, None, "d/.png");
        check("s.pov", ".tga", png, None, ".tga.png");
        check("sub/s.pov", "d/", tga, None, "d/s.tga");
        check("s.pov", "stdout", png, None, "-");
        check("s.pov", "", png, Some((7, 4)), "s0007.png");
        check("s.pov", "f9.png", png, Some((1, 1)), "f91.png");
        check("-", "", png, None, "stdin.png");
    }
}
