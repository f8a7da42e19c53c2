//! Where the programs stand to one another on a scene.

use super::bench::{Bench, Figures};
use super::front::{Point, cost_of, front};
use super::ladder::Against;
use crate::measure::Program;

/// A ladder and a rung of it, as indices.
pub(super) type Place = (usize, usize);

impl Bench {
    /// Rungs of a program that are held against the scene's reference, with what they came to.
    pub(super) fn rungs_of(&self, program: Program) -> Vec<(Place, &Figures)> {
        let mut rungs = Vec::new();
        for (l, climb) in self.climbs.iter().enumerate() {
            if climb.ladder.program == program && climb.ladder.against == Against::Reference {
                let figures = climb.results.iter().enumerate();
                rungs.extend(figures.filter_map(|(r, result)| Some(((l, r), result.as_ref().ok()?))));
            }
        }
        rungs
    }

    /// For each program that raced, its rungs that no other of its rungs beats, cheap to dear.
    pub(super) fn fronts(&self) -> Vec<(Program, Vec<Place>)> {
        let of = |program| {
            let rungs = self.rungs_of(program);
            let places = front(&points(&rungs)).into_iter().map(|i| rungs[i].0).collect::<Vec<_>>();
            (!places.is_empty()).then_some((program, places))
        };
        [Program::Whitted, Program::PovRay].into_iter().filter_map(of).collect()
    }

    /// What each rung of POV-Ray's front costs in CPU time over what its error costs here; those errors that no rung
    /// here reaches are left out.
    pub(super) fn ratios(&self) -> Vec<f64> {
        let (ours, theirs) = (points(&self.rungs_of(Program::Whitted)), points(&self.rungs_of(Program::PovRay)));
        let ratio = |i: usize| Some(theirs[i].cost / cost_of(&ours, theirs[i].error)?);
        front(&theirs).into_iter().filter_map(ratio).collect()
    }

    /// The same at the least error that POV-Ray reached.
    pub(super) fn ratio_at_finest(&self) -> Option<f64> {
        let (ours, theirs) = (points(&self.rungs_of(Program::Whitted)), points(&self.rungs_of(Program::PovRay)));
        let finest = theirs[*front(&theirs).last()?];
        Some(finest.cost / cost_of(&ours, finest.error)?)
    }
}

fn points(rungs: &[(Place, &Figures)]) -> Vec<Point> {
    rungs.iter().map(|(_, figures)| Point { cost: figures.cpu().min, error: figures.difference.rmse }).collect()
}
