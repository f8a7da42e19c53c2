//! A program's way through a family, from mild to extreme, until it breaks.

use super::catalog::INCLUDES;
use super::family::{Family, Truth};
use crate::imaging::{Picture, read_exr};
use crate::measure::{Caller, Program, Run, Task};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A pixel is off when a channel differs by more: five steps of a display's 256.
pub const VISIBLE: f32 = 0.02;
/// After so many steps in a row that are wrong, it is broken for good.
const GIVE_UP: usize = 2;
/// Below this, starting the program is most of its time.
const MEASURABLE: Duration = Duration::from_millis(100);
/// Below this, what the program always holds is most of its memory.
const WEIGHABLE: f64 = 30e6;

/// What became of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The value of `X`.
    pub x: f64,
    /// Its error, or why there is no picture.
    pub error: Result<f64, String>,
    /// What it cost.
    pub run: Option<Run>,
}

/// All steps of a program in a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// Whose.
    pub program: Program,
    /// Those that were tried, in order.
    pub steps: Vec<Step>,
    /// How many are right before the first that is not.
    pub n_right: usize,
}

/// Who renders, and how.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The program.
    pub program: Program,
    /// How it is called.
    pub caller: Caller,
    /// How long a step may take.
    pub limit: Duration,
    /// Folder for scenes and pictures on their way.
    pub folder: PathBuf,
}

impl Sweep {
    /// The last step that is right, with all before it.
    pub fn last_right(&self) -> Option<&Step> {
        self.steps[..self.n_right].last()
    }

    /// The first that is wrong.
    pub fn first_wrong(&self) -> Option<&Step> {
        self.steps.get(self.n_right)
    }
}

/// A step's picture, what it said and what it cost.
struct Made {
    picture: Picture,
    said: String,
    run: Run,
}

impl Setup {
    /// Renders the steps of a family; at most `most` of them.
    pub fn sweep(&self, family: &Family, most: usize, mut before: impl FnMut(f64)) -> Sweep {
        let mut sweep = Sweep { program: self.program, steps: Vec::new(), n_right: 0 };
        let scene = match self.laid_down(family) {
            Ok(scene) => scene,
            Err(error) => {
                sweep.steps.push(Step { x: family.steps[0], error: Err(error.to_string()), run: None });
                return sweep;
            }
        };
        let mut first = None;
        let mut n_wrong = 0;
        for &x in family.steps.iter().take(most) {
            before(x);
            let (error, run) = match self.make(&scene, (x, family.picture(x)), false) {
                Ok(made) => (self.error(family, &scene, x, &made, &mut first, &sweep.steps), Some(made.run)),
                Err(why) => (Err(why), None),
            };
            let is_right = error.as_ref().is_ok_and(|error| *error <= family.tolerance);
            n_wrong = if is_right { 0 } else { n_wrong + 1 };
            if is_right && sweep.n_right == sweep.steps.len() {
                sweep.n_right += 1;
            }
            sweep.steps.push(Step { x, error, run });
            if n_wrong == GIVE_UP {
                break;
            }
        }
        sweep
    }

    /// The file of a family; one of the catalogue is written, with what it includes.
    fn laid_down(&self, family: &Family) -> std::io::Result<PathBuf> {
        if let Some(file) = &family.file {
            return Ok(file.clone());
        }
        for (name, text) in INCLUDES {
            std::fs::write(self.folder.join(name), text)?;
        }
        let scene = self.folder.join(format!("{}.pov", family.name));
        std::fs::write(&scene, &family.text)?;
        Ok(scene)
    }

    fn make(&self, scene: &Path, (x, size): (f64, [usize; 2]), right: bool) -> Result<Made, String> {
        let picture = self.folder.join("step.exr");
        let mut more = self.declare("X", x);
        if right {
            more.extend(self.declare("Right", 1.0));
        }
        let task = Task { scene, picture: &picture, size, threads: 1 };
        let (run, said) = self.caller.invocation(self.program, task, &more)?.run(self.limit)?;
        let read = read_exr(&picture).map_err(|error| error.to_string());
        // What is left there must not pass for the next one's.
        let _ = std::fs::remove_file(&picture);
        Ok(Made { picture: read?, said, run })
    }

    fn declare(&self, name: &str, value: f64) -> Vec<String> {
        match self.program {
            Program::Whitted => vec!["--declare".into(), format!("{name}={value}")],
            Program::PovRay => vec![format!("Declare={name}={value}")],
        }
    }

    fn error(
        &self,
        family: &Family,
        scene: &Path,
        x: f64,
        made: &Made,
        first: &mut Option<Picture>,
        before: &[Step],
    ) -> Result<f64, String> {
        match family.truth {
            Truth::First => share_off(first.get_or_insert_with(|| made.picture.clone()), &made.picture, VISIBLE),
            Truth::FirstBits => share_off(first.get_or_insert_with(|| made.picture.clone()), &made.picture, 0.0),
            Truth::Partner => {
                share_off(&self.make(scene, (x, family.picture(x)), true)?.picture, &made.picture, VISIBLE)
            }
            Truth::Found => found(&made.said),
            Truth::Cost { time, memory } => Ok(excess(family, x, &made.run, before, time, memory)),
        }
    }
}

/// Share of pixels that are off, those that are no numbers among them.
fn share_off(right: &Picture, picture: &Picture, slack: f32) -> Result<f64, String> {
    if (right.width, right.height) != (picture.width, picture.height) {
        return Err("the pictures have different sizes".into());
    }
    let near = |a: &f32, b: &f32| a == b || ((a - b).abs() <= slack && b.is_finite());
    let is_off = |(a, b): &(&[f32; 4], &[f32; 4])| !a[..3].iter().zip(&b[..3]).all(|(a, b)| near(a, b));
    let n_off = right.pixels.iter().zip(&picture.pixels).filter(is_off).count();
    if right.pixels.iter().all(|pixel| pixel == &right.pixels[0]) {
        return Err("the picture that it is held against shows nothing".into());
    }
    Ok(n_off as f64 / picture.pixels.len() as f64)
}

/// The greatest of the errors that a scene has found.
fn found(said: &str) -> Result<f64, String> {
    let numbers = said.lines().filter_map(|line| line.trim().strip_prefix("found "));
    let errors: Vec<f64> = numbers.map(|number| number.trim().parse().unwrap_or(f64::NAN).abs()).collect();
    match errors.iter().find(|error| error.is_nan()) {
        Some(_) => Err("an error is not a number".into()),
        None => errors.into_iter().reduce(f64::max).ok_or_else(|| "it said nothing".into()),
    }
}

/// By how much the powers with which time and memory grow from the step before exceed those that they should have.
fn excess(family: &Family, x: f64, run: &Run, before: &[Step], time: f64, memory: f64) -> f64 {
    let Some((last, Some(last_run))) = before.last().map(|step| (step.x, &step.run)) else { return 0.0 };
    let growth = (family.size(x) / family.size(last)).ln();
    let seconds = |run: &Run| run.cpu.as_secs_f64();
    let mut excess = 0.0_f64;
    if last_run.cpu >= MEASURABLE {
        excess = excess.max((seconds(run) / seconds(last_run)).ln() / growth - time);
    }
    if last_run.memory as f64 >= WEIGHABLE {
        excess = excess.max((run.memory as f64 / last_run.memory as f64).ln() / growth - memory);
    }
    excess
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_off_when_it_shows_or_they_are_no_numbers() {
        let mut right = Picture::filled(2, 2, [0.5, 0.5, 0.5, 1.0]);
        right.pixels[0] = [0.0, 0.0, 0.0, 1.0];
        let mut picture = right.clone();
        assert_eq!(share_off(&right, &picture, VISIBLE), Ok(0.0));
        picture.pixels[1][2] = 0.53;
        picture.pixels[3][0] = f32::NAN;
        picture.pixels[2][1] = 0.51;
        assert_eq!(share_off(&right, &picture, VISIBLE), Ok(0.5));
        let blank = Picture::filled(2, 2, [0.5, 0.5, 0.5, 1.0]);
        assert!(share_off(&blank, &blank, VISIBLE).unwrap_err().contains("shows nothing"));
    }

    #[test]
    fn the_greatest_error_counts_and_none_is_a_failure() {
        assert_eq!(found("hello\nfound 0.5\n  found -2e-3\n"), Ok(0.5));
        assert!(found("found nan").is_err() && found("all is well").is_err());
    }

    #[test]
    fn powers_are_fitted_where_there_is_something_to_measure() {
        let text = "//! about: a\n//! extremity: 10^X\n//! steps: 1 2\n//! truth: time n^1 memory n^1\n";
        let family = Family::parse("cost", text).unwrap();
        let run = |seconds: f64, megabytes: u64| {
            let cpu = Duration::from_secs_f64(seconds);
            Run { cpu, wall: cpu, memory: megabytes * 1_000_000 }
        };
        let step = |run| [Step { x: 1.0, error: Ok(0.0), run: Some(run) }];
        let excess = |before, now| excess(&family, 2.0, &now, &step(before), 1.0, 1.0);
        assert!((excess(run(1.0, 100), run(100.0, 1000)) - 1.0).abs() < 1e-12);
        assert!((excess(run(1.0, 100), run(10.0, 10_000)) - 1.0).abs() < 1e-12);
        assert_eq!(excess(run(0.01, 10), run(10.0, 1000)), 0.0);
    }
}
