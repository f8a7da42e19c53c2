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

/// Include files of POV-Ray 3.7 that are not embedded.
const OTHER_FILES: [&str; 24] = [
    "chars",
    "debug",
    "glass_old",
    "ior",
    "logo",
    "makegrass",
    "meshmaker",
    "rad_def",
    "screen",
    "shapes2",
    "shapes3",
    "shapes_old",
    "shapesq",
    "skies",
    "stage1",
    "stars",
    "stdcam",
    "stoneold",
    "stones",
    "stones1",
    "stones2",
    "sunpos",
    "woodmaps",
    "woods",
];

/// Names in POV-Ray's `textures.inc` that the embedded one lacks.
const OTHER_TEXTURES: [&str; 23] = [
    "Brass_Valley",
    "Cork",
    "DMFDarkOak",
    "DMFLightOak",
    "DMFWood6",
    "EMBWood1",
    "FBM_Clouds",
    "Gold_Nugget",
    "Hex_Tiles_Ptrn",
    "Irregular_Bricks_Ptrn",
    "Lightning1",
    "Lightning2",
    "Peel",
    "PinkAlabaster",
    "Rosewood",
    "Rust",
    "Rusty_Iron",
    "Sandalwood",
    "Shadow_Clouds",
    "Star_Ptrn",
    "Starfield",
    "Tiles_Ptrn",
    "Yellow_Pine",
];

/// How to come by what is not embedded.
const INSTALL: &str = "install those of POV-Ray (package povray-includes) or give their folder with --include DIR";

/// What to do about an include file that POV-Ray has and this program has not.
pub(super) fn advice_on_file(name: &str) -> Option<String> {
    let stem = name.strip_suffix(".inc").unwrap_or(name);
    OTHER_FILES.contains(&stem).then(|| format!("'{stem}.inc' is not among the embedded include files; {INSTALL}"))
}

/// What to do about a name that POV-Ray's `textures.inc` declares and the embedded one does not.
pub(super) fn advice_on_texture(name: &str) -> Option<String> {
    OTHER_TEXTURES
        .contains(&name)
        .then(|| format!("'{name}' is in POV-Ray's textures.inc, but not in the embedded one; {INSTALL}"))
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
            let settings = "#version 3.7; global_settings { assumed_gamma 1 } light_source { 0, 1 }";
            let host = Memory::new([("a.pov", format!("{settings}\n#include \"{name}\"\n").as_str())]);
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
    fn what_is_not_embedded_is_known() {
        for name in OTHER_TEXTURES {
            assert_eq!(declared_in(name), None, "{name} is embedded now");
        }
        for name in OTHER_FILES {
            assert!(standard_include(&format!("{name}.inc")).is_none(), "{name} is embedded now");
        }
        assert!(advice_on_file("woods.inc").is_some() && advice_on_file("wood.inc").is_none());
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
