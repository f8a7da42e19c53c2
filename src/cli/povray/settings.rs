//! What all arguments and INI files together mean.

use crate::imaging::{Curve, Dither, Encoding, FileKind};
use crate::job::LightFiles;
use crate::render::{Antialias, Method, Options, Region};
use std::path::PathBuf;

/// The options of a run, at first those that hold without any.
///
/// Source: command line facts, section 10.
#[derive(Clone, Debug)]
pub(super) struct Settings {
    pub(super) scene: Option<PathBuf>,
    pub(super) header: Option<PathBuf>,
    pub(super) library: Vec<PathBuf>,
    pub(super) declarations: Vec<(String, f64)>,
    /// In hundredths.
    pub(super) version: Option<u32>,
    pub(super) size: [i64; 2],
    /// Start and end, column and row, as they were given.
    pub(super) start: [Option<f64>; 2],
    pub(super) end: [Option<f64>; 2],
    pub(super) to_file: bool,
    pub(super) kind: FileKind,
    pub(super) bits: i64,
    pub(super) grey: bool,
    pub(super) compression: i64,
    pub(super) output: Option<String>,
    pub(super) alpha: bool,
    pub(super) file_gamma: Curve,
    pub(super) dithers: bool,
    pub(super) dither: Dither,
    pub(super) antialias: bool,
    pub(super) method: i64,
    pub(super) threshold: f64,
    pub(super) depth: i64,
    pub(super) jitter: bool,
    pub(super) jitter_amount: f64,
    pub(super) antialias_gamma: f64,
    pub(super) quality: i64,
    pub(super) clock: Option<f64>,
    pub(super) initial_frame: Option<i64>,
    pub(super) final_frame: Option<i64>,
    pub(super) initial_clock: f64,
    pub(super) final_clock: f64,
    pub(super) cyclic: bool,
    pub(super) subset: [Option<f64>; 2],
    pub(super) step: i64,
    pub(super) continues: bool,
    pub(super) radiosity_file: PathBuf,
    pub(super) radiosity_from_file: bool,
    pub(super) radiosity_to_file: bool,
    pub(super) create_ini: Option<PathBuf>,
    pub(super) streams: [Stream; 6],
    pub(super) appends: bool,
    pub(super) verbose: bool,
    pub(super) threads: i64,
}

/// What becomes of a sort of messages.
#[derive(Clone, Debug)]
pub(super) struct Stream {
    pub(super) console: bool,
    pub(super) file: Option<PathBuf>,
}

/// Sorts of messages, in the order of [`Settings::streams`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    All,
    Debug,
    Fatal,
    Render,
    Statistics,
    Warning,
}

impl Sort {
    /// The file that is written for `on` in the place of a name.
    pub(super) fn default_file(self) -> &'static str {
        ["alltext.out", "debug.out", "fatal.out", "render.out", "stats.out", "warning.out"][self as usize]
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            scene: None,
            header: None,
            library: Vec::new(),
            declarations: Vec::new(),
            version: None,
            size: [800, 600],
            start: [None; 2],
            end: [None; 2],
            to_file: true,
            kind: FileKind::Png,
            bits: 8,
            grey: false,
            compression: 0,
            output: None,
            alpha: false,
            file_gamma: Curve::Srgb,
            dithers: false,
            dither: Dither::FloydSteinberg,
            antialias: false,
            method: 1,
            threshold: 0.3,
            depth: 3,
            jitter: true,
            jitter_amount: 1.0,
            antialias_gamma: f64::from(Antialias::GAMMA),
            quality: 9,
            clock: None,
            initial_frame: None,
            final_frame: None,
            initial_clock: 0.0,
            final_clock: 1.0,
            cyclic: false,
            subset: [None; 2],
            step: 1,
            continues: false,
            radiosity_file: "object.rca".into(),
            radiosity_from_file: false,
            radiosity_to_file: false,
            create_ini: None,
            streams: std::array::from_fn(|_| Stream { console: true, file: None }),
            appends: false,
            verbose: false,
            threads: 0,
        }
    }
}

impl Settings {
    /// What the picture is like, or why it cannot be.
    pub(super) fn rendering(&self) -> Result<Options, String> {
        /// Beyond it a size is a slip, and no memory would hold the picture.
        const LARGEST: i64 = 65_536;
        for (word, size) in ["width", "height"].iter().zip(self.size) {
            if !(1..=LARGEST).contains(&size) {
                return Err(format!("the {word} of the picture must be 1 to {LARGEST}, not {size}"));
            }
        }
        let [width, height] = self.size.map(|n| n as usize);
        Ok(Options {
            width,
            height,
            antialias: self.antialias(),
            quality: self.quality.clamp(0, 9) as u8,
            alpha: self.alpha && self.kind.holds_alpha(),
            region: self.region()?,
            ..Options::default()
        })
    }

    /// Where light between surfaces comes from and goes to.
    pub(super) fn light_files(&self) -> LightFiles {
        let file = |is_wanted: bool| is_wanted.then(|| self.radiosity_file.clone());
        LightFiles { from: file(self.radiosity_from_file), to: file(self.radiosity_to_file) }
    }

    fn antialias(&self) -> Option<Antialias> {
        let method = match self.method {
            ..=0 => return None,
            1 => Method::Grid,
            2.. => Method::Adaptive,
        };
        self.antialias.then(|| Antialias {
            method,
            threshold: self.threshold.clamp(0.0, 1.0),
            depth: self.depth.clamp(1, 9) as u32,
            jitter: if self.jitter { self.jitter_amount.clamp(0.0, 1.0) } else { 0.0 },
            gamma: self.antialias_gamma as f32,
        })
    }

    /// The part of the picture, counted from 0 with the end left out; `None` for all of it.
    ///
    /// Source: command line facts, section 6.
    fn region(&self) -> Result<Option<Region>, String> {
        if self.start == [None; 2] && self.end == [None; 2] {
            return Ok(None);
        }
        let mut sides = [(0, 0); 2];
        for (i, word) in ["column", "row"].into_iter().enumerate() {
            let n = self.size[i] as f64;
            let first =
                self.start[i].map_or(0.0, |v| if (0.0..1.0).contains(&v) { (n * v).floor() } else { v.floor() - 1.0 });
            let end = self.end[i].map_or(n, |v| if (0.0..=1.0).contains(&v) { (n * v).floor() } else { v.floor() });
            if !(0.0..n).contains(&first) {
                return Err(format!("Invalid start {word}."));
            }
            if !(1.0..=n).contains(&end) {
                return Err(format!("Invalid end {word}."));
            }
            if first >= end {
                return Err(format!("The start {word} lies behind the end {word}: there is nothing to render."));
            }
            sides[i] = (first as usize, end as usize);
        }
        let [(left, right), (top, bottom)] = sides;
        Ok(Some(Region { left, top, right, bottom }))
    }

    /// How the picture's file is written.
    pub(super) fn encoding(&self) -> Encoding {
        // Grey PNG files have 16 bits whatever is asked for.
        let bits = if self.is_grey() && self.kind == FileKind::Png { 16 } else { self.bits.clamp(5, 16) as u8 };
        Encoding {
            bits,
            grey: self.is_grey(),
            quality: if (2..=100).contains(&self.compression) {
                self.compression as u8
            } else {
                Encoding::default().quality
            },
            curve: self.file_gamma,
            dither: self.dithers.then_some(self.dither),
            ..Encoding::default()
        }
    }

    fn is_grey(&self) -> bool {
        self.grey && matches!(self.kind, FileKind::Png | FileKind::Ppm)
    }

    /// Whether the picture should be grey in a kind of file that has no grey.
    pub(super) fn asks_for_impossible_grey(&self) -> bool {
        self.to_file && self.grey && !self.is_grey()
    }

    pub(super) fn stream(&self, sort: Sort) -> &Stream {
        &self.streams[sort as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(size: [i64; 2], start: [f64; 2], end: [f64; 2], expected: [usize; 4]) {
        let settings = Settings { size, start: start.map(Some), end: end.map(Some), ..Settings::default() };
        let region = settings.rendering().unwrap().region.unwrap();
        assert_eq!([region.left, region.top, region.right, region.bottom], expected);
    }

    #[test]
    fn parts_are_those_of_povray() {
        // Command line facts, section 6: its probes; columns and rows from 1 there.
        check([10, 8], [0.25, 0.5], [0.75, 1.0], [2, 4, 7, 8]);
        check([10, 8], [2.7, 1.0], [5.9, 8.0], [1, 0, 5, 8]);
        check([10, 8], [0.31, 0.0], [0.69, 3.0], [3, 0, 6, 3]);
        check([8, 6], [0.5, 0.5], [1.0, 1.0], [4, 3, 8, 6]);
    }

    #[test]
    fn parts_lie_within_the_picture() {
        let fails = |start: Option<f64>, end: Option<f64>| {
            let settings = Settings { size: [8, 6], start: [None, start], end: [None, end], ..Settings::default() };
            settings.rendering().is_err()
        };
        assert!(
            fails(Some(7.0), None) && fails(None, Some(7.0)) && fails(None, Some(0.0)) && fails(Some(5.0), Some(3.0))
        );
        assert!(!fails(Some(6.0), None) && !fails(None, Some(6.0)));
    }
}
