//! The families that come with the program: all files in the folder beside this one.

use super::family::{BadFamily, Family};
use std::path::Path;

macro_rules! families {
    ($($name:literal)*) => {
        /// Name and text of each.
        const FAMILIES: &[(&str, &str)] = &[$(($name, include_str!(concat!("families/", $name, ".pov")))),*];
    };
}

/// Files that families include.
pub(super) const INCLUDES: &[(&str, &str)] = &[("zoo.inc", include_str!("families/zoo.inc"))];

families! {
    "blob-cancelling"
    "bounded-far"
    "camera-on-surface"
    "cancellation"
    "coincident-faces"
    "colours"
    "cost-arrays"
    "cost-blob"
    "cost-csg-chain"
    "cost-csg-depth"
    "cost-difference"
    "cost-height-field"
    "cost-instances"
    "cost-intersection"
    "cost-layers"
    "cost-lights"
    "cost-long-triangles"
    "cost-loop"
    "cost-macros"
    "cost-merge"
    "cost-objects"
    "cost-panes"
    "cost-pixels"
    "cost-same-place"
    "cost-strings"
    "cost-triangles"
    "cost-union"
    "critical-angle"
    "csg-depth"
    "degenerate-points"
    "double-roots"
    "finish-exponents"
    "grazing-rays"
    "grazing-view"
    "high-orders"
    "isosurface-flat"
    "isosurface-steep"
    "isosurface-thin"
    "julia-fine"
    "lights"
    "loop-length"
    "low-light"
    "macro-depth"
    "mesh-slivers"
    "mirrors-nested"
    "offset"
    "parallel-mirrors"
    "planet-and-ant"
    "refraction-strong"
    "refraction-weak"
    "rotations"
    "rotations-nested"
    "scale-by-two"
    "scale-down"
    "scale-up"
    "shadows-at-home"
    "stretch-and-back"
    "superellipsoid-hollow"
    "superellipsoid-sharp"
    "thin-torus"
    "torus-from-afar"
    "touching-media"
    "touching-spheres"
}

/// All families, by name.
pub fn catalog() -> impl Iterator<Item = Family> {
    FAMILIES.iter().map(|(name, text)| Family::parse(name, text).expect("the catalogue is under test"))
}

/// A family of the catalogue, else all whose names begin so, or a file.
///
/// # Errors
/// When there is none, or the file is no family.
pub fn named(name: &str) -> Result<Vec<Family>, String> {
    if Path::new(name).extension().is_some() {
        return Ok(vec![Family::read(Path::new(name)).map_err(|bad: BadFamily| bad.to_string())?]);
    }
    if let Some(family) = catalog().find(|family| family.name == name) {
        return Ok(vec![family]);
    }
    let found: Vec<Family> = catalog().filter(|family| family.name.starts_with(name)).collect();
    if found.is_empty() {
        let all: Vec<&str> = FAMILIES.iter().map(|(name, _)| *name).collect();
        return Err(format!("there is no family '{name}', only {}", all.join(", ")));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_a_family() {
        for (name, text) in FAMILIES {
            assert!(text.is_ascii(), "{name}");
            Family::parse(name, text).unwrap_or_else(|bad| panic!("{bad}"));
        }
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/stability/families");
        assert_eq!(std::fs::read_dir(folder).unwrap().count(), FAMILIES.len() + INCLUDES.len());
    }

    #[test]
    fn families_go_by_the_beginning_of_their_names() {
        let found = named("scale").unwrap();
        assert!(found.len() > 1 && found.iter().all(|family| family.name.starts_with("scale")));
        assert_eq!(named("rotations").unwrap().len(), 1);
        assert!(named("no-such").unwrap_err().contains("only "));
        assert!(named("no/such.pov").is_err());
    }
}
