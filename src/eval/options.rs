//! What a caller may choose.

use crate::scene::{IsosurfaceSearch, Settings};
use std::path::PathBuf;

/// How to read a scene.
#[derive(Clone, Debug)]
pub struct Options {
    /// Folders that are searched for files after the working directory, in order.
    pub include_dirs: Vec<PathBuf>,
    /// Language version in hundredths before the first `#version` (`+MV`).
    pub version: Option<u32>,
    /// Floats declared before the scene is read (`Declare=NAME=VALUE`).
    pub declarations: Vec<(String, f64)>,
    /// `clock`.
    pub clock: f64,
    /// `clock_on`: whether this is a frame of an animation.
    pub animated: bool,
    /// `initial_frame`, `final_frame`, `frame_number`, `initial_clock`, `final_clock`, `clock_delta`.
    pub animation: [f64; 6],
    /// `image_width`.
    pub image_width: u32,
    /// `image_height`.
    pub image_height: u32,
    /// What `now` and `datetime` take for the present, in days since 2000-01-01 UTC.
    pub now: f64,
    /// How isosurfaces are looked for.
    pub isosurface_search: IsosurfaceSearch,
    /// Bounds on what a scene may use up.
    pub limits: Limits,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            include_dirs: Vec::new(),
            version: None,
            declarations: Vec::new(),
            clock: 0.0,
            animated: false,
            animation: [0.0; 6],
            image_width: 320,
            image_height: 240,
            now: 0.0,
            isosurface_search: IsosurfaceSearch::default(),
            limits: Limits::default(),
        }
    }
}

/// Bounds on what a scene may use up; POV-Ray's own are 31 and about 98 for the first two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Include files open at the same time.
    pub include_depth: usize,
    /// Macro calls running at the same time.
    pub macro_depth: usize,
    /// Braces, parentheses and directives inside one another.
    pub nesting: usize,
    /// Turns of loops and macro calls, all together.
    pub steps: u64,
    /// Objects that are written out, those within others included; copies of declared ones cost little.
    pub objects: usize,
    /// Objects and parts of solids to build, with those copies that have to be written out.
    pub parts: u64,
    /// Elements of an array.
    pub array_elements: usize,
    /// Bytes of a string.
    pub string_bytes: usize,
}

impl Limits {
    /// Their names, as messages and the command line call them.
    pub const NAMES: [&str; 8] =
        ["include_depth", "macro_depth", "nesting", "steps", "objects", "parts", "array_elements", "string_bytes"];

    /// Sets a limit by its name; false for a name that does not exist.
    pub fn set(&mut self, name: &str, value: u64) -> bool {
        let count = usize::try_from(value).unwrap_or(usize::MAX);
        match name {
            "include_depth" => self.include_depth = count,
            "macro_depth" => self.macro_depth = count,
            "nesting" => self.nesting = count,
            "steps" => self.steps = value,
            "objects" => self.objects = count,
            "parts" => self.parts = value,
            "array_elements" => self.array_elements = count,
            "string_bytes" => self.string_bytes = count,
            _ => return false,
        }
        true
    }
}

impl Limits {
    /// For scenes of strangers: what fits into a few seconds and a small memory.
    pub fn strict() -> Self {
        Self {
            include_depth: 64,
            macro_depth: 1000,
            nesting: 500,
            steps: 10_000_000,
            objects: 1_000_000,
            parts: 2_000_000,
            array_elements: 20_000_000,
            string_bytes: 1 << 24,
        }
    }
}

impl Default for Limits {
    /// A hundred times and more of what honest scenes are known to need, so that only what would never end ends.
    fn default() -> Self {
        Self {
            include_depth: 1000,
            macro_depth: 100_000,
            nesting: 50_000,
            steps: 100_000_000_000,
            objects: 200_000_000,
            parts: Settings::default().max_parts,
            array_elements: 500_000_000,
            string_bytes: 1 << 28,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Limits;

    #[test]
    fn every_limit_can_be_set_by_name() {
        let changed = Limits::NAMES.map(|name| {
            let mut limits = Limits::default();
            assert!(limits.set(name, 3), "{name}");
            limits
        });
        for (i, limits) in changed.iter().enumerate() {
            assert!(*limits != Limits::default() && !changed[..i].contains(limits), "{}", Limits::NAMES[i]);
        }
        assert!(!Limits::default().set("stepps", 3));
    }
}
