//! What a session gives back.

use super::Job;
use super::identity::Digest;
use super::state::{Earlier, State};
use crate::compile::geometry::Watched;
use crate::compiled::World;
use crate::diag::{Diagnostic, SourceMap};
use crate::imaging::{Curve, Metadata, Picture};
use crate::omission::Ledger;
use crate::render::{BLOCK, KnownLight, Options, Progress, Statistics};
use std::path::Path;
use std::time::{Duration, Instant};

/// How long each stage took, in order.
#[derive(Clone, Debug, Default)]
pub struct Timings(pub Vec<(&'static str, Duration)>);

impl Timings {
    /// Runs a stage and notes its time.
    pub fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        self.0.push((stage, start.elapsed()));
        result
    }

    /// The time of all stages so far.
    pub fn total(&self) -> Duration {
        self.0.iter().map(|(_, time)| *time).sum()
    }

    /// How many such pictures at once keep so many threads busy, as far as those can be told apart from their blocks.
    ///
    /// Reading and writing take one thread, compiling and rendering as many as there are blocks.
    fn at_once(&self, threads: usize, options: &Options) -> usize {
        let window = options.window();
        let blocks = window.width().div_ceil(BLOCK) * window.height().div_ceil(BLOCK);
        let shared = (self.of("compile") + self.of("render")).as_secs_f64();
        let alone = self.total().as_secs_f64() - shared;
        let busy = alone + shared * threads.min(blocks) as f64;
        ((threads as f64 * self.total().as_secs_f64() / busy).ceil() as usize).clamp(1, threads)
    }

    /// The time of a stage.
    pub fn of(&self, stage: &str) -> Duration {
        self.0.iter().filter(|(name, _)| *name == stage).map(|(_, time)| *time).sum()
    }
}

/// A finished picture with all that was found out on the way.
#[derive(Debug)]
pub struct Outcome {
    /// The picture, linear light.
    pub picture: Picture,
    /// What its file should say.
    pub metadata: Metadata,
    /// Whether files show the scene's values as they are, by the sRGB curve, whatever their encoding says.
    pub display_values: bool,
    /// The curve of the values in which colours were added and multiplied.
    pub working: Curve,
    /// False if the observer stopped it before every pixel was there.
    pub complete: bool,
    /// How a picture with a target came about.
    pub progress: Option<Progress>,
    /// Everything worth mentioning.
    pub warnings: Vec<Diagnostic>,
    /// The files that were read, to show the warnings; large ones must be [restored](SourceMap::restored).
    pub sources: SourceMap,
    /// Time of each stage.
    pub timings: Timings,
    /// What the scene has, and what it does without.
    pub explanation: Explanation,
    /// What an earlier run had left.
    pub earlier: Earlier,
    /// Light between surfaces, if it is to be written and the scene has any.
    pub(super) light: Option<KnownLight>,
    /// Pieces of the picture, until it is in its file.
    pub(super) state: Option<State>,
}

impl Outcome {
    /// How many pictures of this job's kind at once keep so many threads busy; those for standard output come in order, and
    /// so do those that hand light on.
    pub fn at_once(&self, threads: usize, job: &Job) -> usize {
        let is_piped = job.outputs.iter().any(|output| output.file == Path::new("-"));
        if is_piped || job.light.hand_on() { 1 } else { self.timings.at_once(threads, &job.rendering) }
    }
}

/// What a scene has, and what it does without.
#[derive(Clone, Debug, Default)]
pub struct Explanation {
    /// How much there is of what.
    pub found: Vec<(&'static str, usize)>,
    /// What it does not need.
    pub ledger: Ledger,
    /// Rays that were sent, and those that were not.
    pub rays: Statistics,
}

/// A scene that is ready to be rendered.
#[derive(Debug)]
pub struct Ready {
    /// What rays meet.
    pub world: World,
    /// What may have something to say after rendering.
    pub watched: Vec<Watched>,
    /// What the scene does not need.
    pub ledger: Ledger,
    /// Everything worth mentioning.
    pub warnings: Vec<Diagnostic>,
    /// The files that were read, to show the warnings; large ones must be [restored](SourceMap::restored).
    pub sources: SourceMap,
    /// Time of each stage.
    pub timings: Timings,
    /// Of all files that were read.
    pub(super) digest: Digest,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_made_at_once_where_cores_are_idle() {
        let check = |read: u64, render: u64, [width, height]: [usize; 2], expected: usize| {
            let times = [("read", read), ("render", render)];
            let timings = Timings(times.map(|(stage, time)| (stage, Duration::from_millis(time))).into());
            assert_eq!(timings.at_once(8, &Options { width, height, ..Options::default() }), expected);
        };
        check(0, 100, [800, 600], 1);
        check(100, 0, [800, 600], 8);
        check(100, 100, [800, 600], 2);
        check(0, 100, [32, 32], 8);
        check(0, 0, [32, 32], 1);
    }
}
