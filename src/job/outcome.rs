//! What a session gives back.

use crate::compile::geometry::Watched;
use crate::compiled::World;
use crate::diag::{Diagnostic, SourceMap};
use crate::imaging::{Metadata, Picture};
use crate::omission::Ledger;
use crate::render::{Progress, Statistics};
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
}
