//! A family of scenes: one file in POV-Ray's language that grows more extreme with a number.
//!
//! The file says about itself, in comments at its top, what it is about, how far it goes and what the truth is:
//!
//! ```text
//! //! about: the whole scene is 10^X times as large
//! //! extremity: 10^X
//! //! steps: 0 to 300 by 20
//! //! truth: the first step
//! ```
//!
//! `X` is declared by whoever renders the file.

use std::fmt;
use std::path::{Path, PathBuf};

/// What a family is.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// The file's name without its ending.
    pub name: String,
    /// What grows, in words.
    pub about: String,
    /// How extreme a step is.
    pub extremity: Extremity,
    /// Values of `X`, mild ones first.
    pub steps: Vec<f64>,
    /// What each step is held against.
    pub truth: Truth,
    /// The greatest error with which a step is right.
    pub tolerance: f64,
    /// Why a program does not go further, where that has a good reason.
    pub note: Option<String>,
    /// Its picture has as many pixels as the step says.
    pub pixels_grow: bool,
    /// The whole text.
    pub text: String,
    /// Where the text is, if it is not of the catalogue.
    pub file: Option<PathBuf>,
}

/// How `X` is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extremity {
    /// As it is.
    Plain,
    /// As a power of this base.
    Power(f64),
}

/// What a step is held against; says what its error is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    /// The picture of the first step: the share of pixels that are off by more than [`VISIBLE`](super::sweep::VISIBLE).
    First,
    /// The picture of the first step to the last bit: the share of pixels that are not the same.
    FirstBits,
    /// The picture of the same step with `Right` declared: the same.
    Partner,
    /// What the scene works out itself and writes as `found E` with `#debug`: the greatest of them.
    Found,
    /// CPU time over that of the step before grows with this power of `X`'s growth, and so does memory: by how much the
    /// power of either is greater.
    Cost {
        /// Power of time.
        time: f64,
        /// Power of memory.
        memory: f64,
    },
}

/// Why a file is no family.
#[derive(Clone, Debug, PartialEq)]
pub struct BadFamily {
    /// The file's name.
    name: String,
    why: String,
}

impl fmt::Display for BadFamily {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is no family of scenes: {}", self.name, self.why)
    }
}

impl std::error::Error for BadFamily {}

/// Share of pixels that may be off by the rounding of edges.
const EDGES: f64 = 0.005;
/// More are a slip of the pen.
const MOST_STEPS: f64 = 1e4;
/// What a fitted power may be off by: caches fill up, and clocks are coarse.
const POWER_SLACK: f64 = 0.25;

impl Family {
    /// Reads what a file says about itself.
    ///
    /// # Errors
    /// When a line is missing or makes no sense.
    pub fn parse(name: &str, text: &str) -> Result<Self, BadFamily> {
        let fails = |why: String| BadFamily { name: name.to_owned(), why };
        let said = |key: &str| {
            let mut lines = text.lines().filter_map(|line| line.strip_prefix("//! ")?.split_once(": "));
            lines.find(|(word, _)| *word == key).map(|(_, value)| value.trim())
        };
        let needed = |key: &str| said(key).ok_or_else(|| fails(format!("it has no line '//! {key}: ...'")));
        let extremity = match said("extremity").unwrap_or("X") {
            "X" => Extremity::Plain,
            power => {
                let base = power.strip_suffix("^X").and_then(|base| base.parse().ok());
                Extremity::Power(base.ok_or_else(|| fails(format!("'{power}' is neither X nor a power like 10^X")))?)
            }
        };
        let truth = needed("truth")?;
        let (truth, usual) = parse_truth(truth).ok_or_else(|| fails(format!("'{truth}' is no truth")))?;
        let tolerance = said("tolerance").map(|number| number.parse().map_err(|_| number));
        let tolerance = tolerance.unwrap_or(Ok(usual)).map_err(|number| fails(format!("'{number}' is no number")))?;
        let steps = needed("steps")?;
        Ok(Self {
            name: name.to_owned(),
            about: needed("about")?.to_owned(),
            extremity,
            steps: parse_steps(steps).ok_or_else(|| fails(format!("'{steps}' are no steps")))?,
            truth,
            tolerance,
            note: said("note").map(str::to_owned),
            pixels_grow: said("picture") == Some("of so many pixels"),
            text: text.to_owned(),
            file: None,
        })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read or is no family.
    pub fn read(file: &Path) -> Result<Self, BadFamily> {
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match std::fs::read_to_string(file) {
            Ok(text) => Ok(Self { file: Some(file.to_owned()), ..Self::parse(&name, &text)? }),
            Err(error) => Err(BadFamily { name, why: error.to_string() }),
        }
    }

    /// What stands for a step in tables: `10^-3`.
    pub fn shown(&self, x: f64) -> String {
        match self.extremity {
            Extremity::Plain => format!("{x}"),
            Extremity::Power(base) => format!("{base}^{x}"),
        }
    }

    /// Pixels across and down of a step's picture.
    pub fn picture(&self, x: f64) -> [usize; 2] {
        /// Enough for a fault to be among them, few enough for many steps.
        const USUAL: [usize; 2] = [160, 120];
        if !self.pixels_grow {
            return USUAL;
        }
        let height = (self.size(x) * 0.75).sqrt().max(1.0);
        [(height / 0.75) as usize, height as usize]
    }

    /// How extreme a step is, as a number for plots; infinite where it is beyond all numbers.
    pub fn size(&self, x: f64) -> f64 {
        match self.extremity {
            Extremity::Plain => x,
            Extremity::Power(base) => base.powf(x),
        }
    }
}

/// The truth with the tolerance that is usual for it.
fn parse_truth(text: &str) -> Option<(Truth, f64)> {
    let words: Vec<&str> = text.split_whitespace().collect();
    match words[..] {
        ["the", "first", "step"] => Some((Truth::First, EDGES)),
        ["the", "first", "step", "to", "the", "last", "bit"] => Some((Truth::FirstBits, 0.0)),
        ["the", "picture", "with", "Right", "declared"] => Some((Truth::Partner, EDGES)),
        ["what", "it", "finds"] => Some((Truth::Found, 0.0)),
        ["time", time, "memory", memory] => {
            let power = |word: &str| word.strip_prefix("n^")?.parse().ok();
            Some((Truth::Cost { time: power(time)?, memory: power(memory)? }, POWER_SLACK))
        }
        _ => None,
    }
}

/// Numbers and ranges like `0 to 300 by 20`, one after the other.
fn parse_steps(text: &str) -> Option<Vec<f64>> {
    let mut words = text.split([' ', ',']).filter(|word| !word.is_empty()).peekable();
    let mut steps = Vec::new();
    while let Some(word) = words.next() {
        let from: f64 = word.parse().ok()?;
        if words.next_if_eq(&"to").is_none() {
            steps.push(from);
            continue;
        }
        let to: f64 = words.next()?.parse().ok()?;
        let by: f64 = words.next_if_eq(&"by").and_then(|_| words.next())?.parse().ok()?;
        let n = ((to - from) / by).round();
        if !(0.0..MOST_STEPS).contains(&n) {
            return None;
        }
        steps.extend((0..=n as u32).map(|k| from + f64::from(k) * by));
    }
    (!steps.is_empty() && steps.iter().all(|x| x.is_finite())).then_some(steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "//! about: more and more\n//! extremity: 10^X\n//! steps: 0, 2 to 6 by 2, 9\n\
        //! truth: the first step\nsphere { 0, X }\n";

    #[test]
    fn a_file_says_what_it_is() {
        let family = Family::parse("more", TEXT).unwrap();
        assert_eq!(family.steps, [0.0, 2.0, 4.0, 6.0, 9.0]);
        assert_eq!((family.truth, family.tolerance), (Truth::First, EDGES));
        assert_eq!((family.shown(-3.0).as_str(), family.size(2.0)), ("10^-3", 100.0));
    }

    #[test]
    fn truths_are_words() {
        let truth = |line: &str| parse_truth(line).map(|(truth, _)| truth);
        assert_eq!(truth("what it finds"), Some(Truth::Found));
        assert_eq!(truth("time n^1 memory n^0.5"), Some(Truth::Cost { time: 1.0, memory: 0.5 }));
        assert_eq!(truth("time n^1 memory much"), None);
    }

    #[test]
    fn what_is_missing_is_named() {
        for (line, why) in [("about", "no line '//! about"), ("steps", "no line '//! steps"), ("truth", "'//! truth")] {
            let text: String = TEXT.lines().filter(|l| !l.contains(line)).map(|l| format!("{l}\n")).collect();
            let bad = Family::parse("more", &text).unwrap_err().to_string();
            assert!(bad.starts_with("more is no family") && bad.contains(why), "{bad}");
        }
        let bad = Family::parse("more", &TEXT.replace("by 2", "by 0")).unwrap_err().to_string();
        assert!(bad.contains("are no steps"), "{bad}");
    }
}
