//! The standard include files that come with this program.
//!
//! The text is ours; names, values and meaning are those of POV-Ray 3.7. They are the last place where `#include`
//! looks, so the files of an installed POV-Ray win.

macro_rules! embedded {
    ($($name:literal)*) => {
        /// Name and text of each file.
        const FILES: &[(&str, &str)] = &[$(($name, include_str!(concat!("../include/", $name)))),*];
    };
}

embedded! {
    "arrays.inc" "colors.inc" "consts.inc" "finish.inc" "functions.inc" "glass.inc" "golds.inc" "math.inc"
    "metals.inc" "rand.inc" "shapes.inc" "stdinc.inc" "strings.inc" "textures.inc" "transforms.inc"
}

/// The text of a standard include file.
pub fn standard_include(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

/// The names of all embedded include files.
pub fn standard_include_names() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name)
}

/// The standard include file that declares a name, found by its text.
pub(super) fn declared_in(name: &str) -> Option<&'static str> {
    let declares = |line: &str| {
        let rest = line.strip_prefix("#declare ").or_else(|| line.strip_prefix("#macro "));
        let rest = rest.and_then(|rest| rest.strip_prefix(name));
        rest.is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_'))
    };
    FILES.iter().find(|(_, text)| text.lines().any(declares)).map(|(file, _)| *file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::Queries;
    use crate::eval::{Memory, Options, evaluate};

    #[test]
    fn each_can_be_included_alone() {
        for name in standard_include_names() {
            let host = Memory::new([("a.pov", format!("#version 3.7;\n#include \"{name}\"\n").as_str())]);
            match evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()) {
                Ok(read) => assert!(read.warnings.is_empty(), "{name}: {:?}", read.warnings),
                Err(failed) => {
                    let shown = failed.diagnostics.iter().map(|d| d.render(&failed.sources, false));
                    panic!("{}", shown.collect::<String>());
                }
            }
        }
    }

    #[test]
    fn names_lead_to_their_files() {
        assert_eq!(declared_in("White"), Some("colors.inc"));
        assert_eq!(declared_in("Whit"), None);
        assert_eq!(declared_in("Reorient_Trans"), Some("transforms.inc"));
    }

    #[test]
    fn a_file_of_the_same_name_wins() {
        let scene = "#version 3.7; #include \"colors\" #debug str(Red, 0, 0)";
        let host = Memory::new([("a.pov", scene), ("colors.inc", "#declare Red = 7;")]);
        assert!(evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).is_ok());
        assert_eq!(host.messages(), "7");
    }

    #[test]
    fn every_file_in_the_folder_is_embedded() -> std::io::Result<()> {
        for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/include"))? {
            let name = entry?.file_name().to_string_lossy().into_owned();
            assert!(!name.ends_with(".inc") || standard_include(&name).is_some(), "{name}");
        }
        Ok(())
    }
}
