//! One scene on all its ladders.

use super::ladder::{self, Against, Ladder, METHOD_1, Rung};
use super::plan::{Plan, Subject};
use super::rays::Rays;
use super::reference::{self, Reference};
use crate::imaging::{Difference, Picture, compare, encode_png, heatmap, read_exr, read_exr_figures};
use crate::measure::{Program, Progress, Run};
use std::path::Path;

/// All that was measured of a scene.
#[derive(Clone, Debug)]
pub struct Bench {
    /// Its file.
    pub scene: String,
    /// What errors are against, or why there is nothing.
    pub reference: Result<ShownReference, String>,
    /// Ladder by ladder.
    pub climbs: Vec<Climb>,
    /// RMSE between both programs' pictures where they sample every pixel at the same places: what no sampling mends.
    pub apart: Option<f64>,
}

/// A reference that was used.
#[derive(Clone, Debug)]
pub struct ShownReference {
    /// Where it comes from, in words.
    pub origin: String,
    /// Its own RMSE, where that is known.
    pub error: Option<f64>,
    /// As PNG.
    pub picture: Vec<u8>,
}

/// A ladder with what each of its rungs came to.
#[derive(Clone, Debug)]
pub struct Climb {
    /// The ladder.
    pub ladder: Ladder,
    /// Figures for each rung, or why there are none.
    pub results: Vec<Result<Figures, String>>,
}

/// What a rung came to.
#[derive(Clone, Debug)]
pub struct Figures {
    /// Each run.
    pub runs: Vec<Run>,
    /// Rays of the first run; all runs make the same picture.
    pub rays: Option<Rays>,
    /// From the reference, or the ladder's finest.
    pub difference: Difference,
    /// The RMSE that the program itself thinks it has.
    pub estimate: Option<f64>,
    /// What it looks like, where it is shown.
    pub images: Option<Images>,
}

/// Pictures of a page, as PNG.
#[derive(Clone, Debug)]
pub struct Images {
    /// The rung's picture.
    pub picture: Vec<u8>,
    /// Where it is wrong.
    pub heatmap: Vec<u8>,
}

/// Least and greatest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Seconds.
    pub min: f64,
    /// Seconds.
    pub max: f64,
}

impl Figures {
    /// CPU time over the runs.
    pub fn cpu(&self) -> Spread {
        spread(self.runs.iter().map(|run| run.cpu.as_secs_f64()))
    }

    /// Time on the clock over the runs.
    pub fn wall(&self) -> Spread {
        spread(self.runs.iter().map(|run| run.wall.as_secs_f64()))
    }
}

fn spread(times: impl Iterator<Item = f64>) -> Spread {
    times.fold(Spread { min: f64::INFINITY, max: 0.0 }, |s, t| Spread { min: s.min.min(t), max: s.max.max(t) })
}

/// How much there is to do for a scene, in the unit of [`Rung::weight`].
pub(super) fn weight(plan: &Plan, subject: &Subject) -> f64 {
    let Ok(census) = &subject.census else { return 0.0 };
    let reference = if plan.reference.is_some() { 0.0 } else { reference::WEIGHTS.iter().sum() };
    let ladders = ladder::all(census, plan.povray.is_some());
    reference + ladders.iter().map(|ladder| ladder_weight(ladder, plan.runs)).sum::<f64>()
}

fn ladder_weight(ladder: &Ladder, runs: usize) -> f64 {
    let rungs: f64 = ladder.rungs.iter().map(|rung| rung.weight).sum();
    let finest = if let Against::Finest(finest) = &ladder.against { finest.weight } else { 0.0 };
    finest + runs as f64 * rungs
}

/// Climbs all ladders of a scene; `folder` is for pictures on their way.
pub(super) fn bench(plan: &Plan, subject: &Subject, folder: &Path, progress: &Progress<'_>) -> Bench {
    let errand = Errand { plan, scene: &subject.scene, folder, progress };
    let fails = |why: String| {
        progress.add(weight(plan, subject));
        Bench { scene: subject.scene.display().to_string(), reference: Err(why), climbs: Vec::new(), apart: None }
    };
    let census = match &subject.census {
        Ok(census) => census,
        Err(why) => return fails(why.clone()),
    };
    let shown = |reference: Reference| {
        let picture = encode_png(&reference.picture).map_err(|error| error.to_string())?;
        Ok((ShownReference { origin: reference.origin, error: reference.error, picture }, reference.picture))
    };
    let (reference, picture) = match errand.reference().and_then(shown) {
        Ok(both) => both,
        Err(why) => return fails(format!("there is no reference: {why}")),
    };
    let (climbs, apart) = errand.climb(ladder::all(census, plan.povray.is_some()), &picture);
    Bench { scene: subject.scene.display().to_string(), reference: Ok(reference), climbs, apart }
}

/// Renderings of one scene.
struct Errand<'p> {
    plan: &'p Plan,
    scene: &'p Path,
    folder: &'p Path,
    progress: &'p Progress<'p>,
}

/// What one run brings back.
struct Rendering {
    run: Run,
    picture: Picture,
    rays: Option<Rays>,
    estimate: Option<f64>,
}

impl Errand<'_> {
    fn reference(&self) -> Result<Reference, String> {
        if let Some(file) = &self.plan.reference {
            return Reference::given(file);
        }
        let mut weights = reference::WEIGHTS.into_iter();
        Reference::made(|arguments| {
            self.progress.begins(&format!("{}: reference", self.scene.display()));
            let rendering =
                self.render(Program::Whitted, &arguments.iter().map(ToString::to_string).collect::<Vec<_>>());
            self.progress.add(weights.next().unwrap_or(0.0));
            Ok(rendering?.picture)
        })
    }

    fn render(&self, program: Program, arguments: &[String]) -> Result<Rendering, String> {
        let file = self.folder.join("picture.exr");
        // A program that writes nothing must not be judged by the picture before.
        let _ = std::fs::remove_file(&file);
        let (run, said) = self.plan.invocation(program, self.scene, arguments, &file)?.run(self.plan.limit)?;
        let picture = read_exr(&file).map_err(|error| error.to_string())?;
        let figures = read_exr_figures(&file).map_err(|error| error.to_string())?;
        let rays = match program {
            Program::Whitted => Rays::from_header(&figures),
            Program::PovRay => Rays::from_statistics(&said),
        };
        let estimate = figures.iter().find(|(name, _)| name == "whitted:errorEstimate").map(|(_, value)| *value);
        Ok(Rendering { run, picture, rays, estimate })
    }

    /// All rungs once, then all again: what the machine does beside it falls on all alike.
    fn climb(&self, ladders: Vec<Ladder>, reference: &Picture) -> (Vec<Climb>, Option<f64>) {
        let mut alike = Vec::new();
        let finest: Vec<Result<Option<Picture>, String>> = ladders.iter().map(|ladder| self.finest(ladder)).collect();
        let mut results: Vec<Vec<Option<Result<Figures, String>>>> =
            ladders.iter().map(|ladder| ladder.rungs.iter().map(|_| None).collect()).collect();
        for round in 1..=self.plan.runs {
            for (l, r) in turns(&ladders) {
                let (ladder, rung) = (&ladders[l], &ladders[l].rungs[r]);
                let is_shown = ladder.against == Against::Reference && is_shown(r, ladder.rungs.len());
                let against = match &finest[l] {
                    Ok(finest) => Ok(finest.as_ref().unwrap_or(reference)),
                    Err(why) => Err(why.as_str()),
                };
                self.say(ladder, rung, round);
                let result = &mut results[l][r];
                match (result.as_mut(), against) {
                    (None, Ok(against)) => {
                        let first = self.first(ladder.program, rung, against, is_shown);
                        *result = Some(first.map(|(figures, picture)| {
                            let is_last = r + 1 == ladder.rungs.len();
                            alike.extend((ladder.name == METHOD_1 && is_last).then_some(picture));
                            figures
                        }));
                    }
                    (None, Err(why)) => *result = Some(Err(format!("the finest rung: {why}"))),
                    (Some(Ok(figures)), _) => match self.render(ladder.program, &rung.arguments) {
                        Ok(again) => figures.runs.push(again.run),
                        Err(why) => *result = Some(Err(format!("in round {round}: {why}"))),
                    },
                    (Some(Err(_)), _) => {}
                }
                self.progress.add(rung.weight);
            }
        }
        let climbed = |(ladder, results): (Ladder, Vec<Option<Result<Figures, String>>>)| Climb {
            ladder,
            results: results.into_iter().map(|result| result.unwrap_or_else(|| Err("was not run".into()))).collect(),
        };
        let apart = if let [ours, theirs] = &alike[..] { compare(ours, theirs).ok() } else { None };
        (ladders.into_iter().zip(results).map(climbed).collect(), apart.map(|difference| difference.rmse))
    }

    fn say(&self, ladder: &Ladder, rung: &Rung, round: usize) {
        let (scene, program) = (self.scene.display(), ladder.program.name());
        let (runs, name, label) = (self.plan.runs, &ladder.name, &rung.label);
        self.progress.begins(&format!("{scene}, round {round} of {runs}: {program}, {name}, {label}"));
    }

    /// The picture that a ladder of a limit is held against.
    fn finest(&self, ladder: &Ladder) -> Result<Option<Picture>, String> {
        let Against::Finest(finest) = &ladder.against else { return Ok(None) };
        self.progress.begins(&format!("{}: {}, finest", self.scene.display(), ladder.name));
        let rendering = self.render(ladder.program, &finest.arguments);
        self.progress.add(finest.weight);
        Ok(Some(rendering?.picture))
    }

    fn first(
        &self,
        program: Program,
        rung: &Rung,
        against: &Picture,
        is_shown: bool,
    ) -> Result<(Figures, Picture), String> {
        let Rendering { run, picture, rays, estimate } = self.render(program, &rung.arguments)?;
        let difference = compare(against, &picture).map_err(|error| error.to_string())?;
        let images = || -> Result<Images, crate::imaging::ImageError> {
            Ok(Images { picture: encode_png(&picture)?, heatmap: encode_png(&heatmap(against, &picture)?)? })
        };
        let images = is_shown.then(images).transpose().map_err(|error| error.to_string())?;
        Ok((Figures { runs: vec![run], rays, difference, estimate, images }, picture))
    }
}

/// Ladder and rung, coarse ones first, so that like rungs of both programs follow one another.
fn turns(ladders: &[Ladder]) -> Vec<(usize, usize)> {
    let longest = ladders.iter().map(|ladder| ladder.rungs.len()).max().unwrap_or(0);
    let at = |r: usize| (0..ladders.len()).filter(move |&l| r < ladders[l].rungs.len()).map(move |l| (l, r));
    (0..longest).flat_map(at).collect()
}

/// Coarsest, finest and one between: all of them would make a page too large to open.
fn is_shown(rung: usize, of: usize) -> bool {
    [0, of / 2, of - 1].contains(&rung)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::census::Census;

    #[test]
    fn programs_take_turns() {
        let ladders = ladder::all(&Census::default(), true);
        let programs: Vec<Program> = turns(&ladders)[7..12].iter().map(|(l, _)| ladders[*l].program).collect();
        let (ours, theirs) = (Program::Whitted, Program::PovRay);
        assert_eq!(programs, [ours, ours, ours, theirs, theirs]);
        let all: usize = ladders.iter().map(|ladder| ladder.rungs.len()).sum();
        assert_eq!(turns(&ladders).len(), all);
    }

    #[test]
    fn a_few_rungs_are_shown() {
        assert_eq!((0..7).filter(|r| is_shown(*r, 7)).collect::<Vec<_>>(), [0, 3, 6]);
        assert!(is_shown(0, 1));
    }
}
