//! What a caller may choose.

use crate::omission::Keep;
use crate::scene::{IsosurfaceSearch, Settings};
use std::path::PathBuf;

/// How to read a scene.
#[derive(Clone, Debug)]
pub struct Options {
    /// Folders that are searched for files after the working directory, in order.
    pub include_dirs: Vec<PathBuf>,
    /// An include file that is read before the scene (`+HI`).
    pub header: Option<PathBuf>,
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
    /// What holds instead of what the scene says.
    pub overrides: Overrides,
    /// Whether spans of objects tell which calls [led](crate::diag::SourceMap::visits) there.
    pub origins: bool,
    /// What is not left out although the picture does not need it.
    pub keep: Keep,
    /// Bounds on what a scene may use up.
    pub limits: Limits,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            include_dirs: Vec::new(),
            header: None,
            version: None,
            declarations: Vec::new(),
            clock: 0.0,
            animated: false,
            animation: [0.0; 6],
            image_width: 320,
            image_height: 240,
            now: 0.0,
            isosurface_search: IsosurfaceSearch::default(),
            overrides: Overrides::default(),
            origins: false,
            keep: Keep::NONE,
            limits: Limits::default(),
        }
    }
}

/// What a caller sets in a scene's place, to see what the scene's own choice costs and spoils.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overrides {
    /// `max_trace_level` of `global_settings`.
    pub max_trace_level: Option<u32>,
    /// `adc_bailout` of `global_settings`.
    pub adc_bailout: Option<f64>,
    /// Factor of the samples along each axis of area lights; an axis of one sample stays as it is.
    pub area_light_grid: f64,
    /// Factor of the `accuracy` of isosurfaces.
    pub isosurface_accuracy: f64,
}

impl Overrides {
    /// Their names, as the command line calls them.
    pub const NAMES: [&str; 4] = ["max_trace_level", "adc_bailout", "area_light_grid", "isosurface_accuracy"];

    /// Sets one by its name; false for a name that does not exist and for a value that makes no sense there.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        let positive = value.is_finite() && value > 0.0;
        match name {
            "max_trace_level" if (1.0..=256.0).contains(&value) => self.max_trace_level = Some(value as u32),
            "adc_bailout" if value.is_finite() && value >= 0.0 => self.adc_bailout = Some(value),
            "area_light_grid" if positive => self.area_light_grid = value,
            "isosurface_accuracy" if positive => self.isosurface_accuracy = value,
            _ => return false,
        }
        true
    }

    /// Samples of an area light along an axis; a row stays a row.
    pub(crate) fn area_samples(&self, given: u32) -> u32 {
        if given < 2 { given } else { (f64::from(given) * self.area_light_grid).round().clamp(2.0, 4096.0) as u32 }
    }
}

impl Default for Overrides {
    fn default() -> Self {
        Self { max_trace_level: None, adc_bailout: None, area_light_grid: 1.0, isosurface_accuracy: 1.0 }
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
    use super::{Limits, Overrides};

    #[test]
    fn every_override_can_be_set_by_name() {
        let changed = Overrides::NAMES.map(|name| {
            let mut overrides = Overrides::default();
            assert!(overrides.set(name, 3.0) && !overrides.set(name, f64::NAN), "{name}");
            overrides
        });
        for (i, overrides) in changed.iter().enumerate() {
            assert!(*overrides != Overrides::default() && !changed[..i].contains(overrides), "{}", Overrides::NAMES[i]);
        }
        assert!(!Overrides::default().set("max_trace", 3.0) && !Overrides::default().set("max_trace_level", 0.0));
    }

    #[test]
    fn grids_keep_their_dimensions() {
        let with = |area_light_grid| Overrides { area_light_grid, ..Overrides::default() };
        assert_eq!([1, 2, 5].map(|n| with(2.0).area_samples(n)), [1, 4, 10]);
        assert_eq!([1, 2, 5].map(|n| with(0.2).area_samples(n)), [1, 2, 2]);
        assert_eq!([1, 2, 5].map(|n| with(1.0).area_samples(n)), [1, 2, 5]);
    }

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
