//! `whitted render --frames`: an animation, several frames at once where one leaves cores idle.

use super::progress::{Bar, end_on_interrupt, progress_bar};
use super::scene_arguments::SceneArguments;
use super::{ERROR, messages};
use crate::diag::{Diagnostic, SourceMap};
use crate::job::{Animation, Exposure, Job, Keeping, Session, measured_in_order};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What was typed about frames.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Frames {
    /// Render frames A to B, each to a file with its number. A frame that fails is no reason to leave out the others
    #[arg(long, value_name = "A-B", value_parser = range, conflicts_with_all = ["target_error", "time_budget", "rounds"])]
    frames: Option<(u32, u32)>,
    /// Values of `clock` in the first and in the last frame [default: 0,1]
    #[arg(long, value_name = "FROM,TO", value_parser = clocks, requires = "frames")]
    clocks: Option<(f64, f64)>,
    /// Part of the time from frame to frame that the shutter is open: blurs what moves
    #[arg(long, value_name = "PART", value_parser = super::render::positive, requires = "samples", conflicts_with = "layers")]
    shutter: Option<f64>,
    /// Pictures whose mean a frame is while the shutter is open
    #[arg(long, value_name = "N", requires = "shutter", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    samples: Option<u32>,
    /// The last frame is followed by the first: its clock stops one step before TO
    #[arg(long, requires = "frames")]
    cyclic: bool,
}

pub(super) fn range(text: &str) -> Result<(u32, u32), String> {
    let (first, last) = text.split_once('-').ok_or("expected A-B")?;
    let number = |text: &str| text.trim().parse::<u32>().map_err(|_| format!("'{text}' is not a frame's number"));
    let (first, last) = (number(first)?, number(last)?);
    if first <= last { Ok((first, last)) } else { Err("the first frame must not lie behind the last".into()) }
}

pub(super) fn clocks(text: &str) -> Result<(f64, f64), String> {
    let (from, to) = text.split_once(',').ok_or("expected FROM,TO")?;
    let number = |text: &str| match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("'{text}' is not a number")),
    };
    Ok((number(from)?, number(to)?))
}

impl Frames {
    /// The animation that is wanted, if one is.
    pub(super) fn animation(&self) -> Option<Animation> {
        let (initial_frame, final_frame) = self.frames?;
        let (initial_clock, final_clock) = self.clocks.unwrap_or((0.0, 1.0));
        Some(Animation { initial_frame, final_frame, initial_clock, final_clock, cyclic: self.cyclic })
    }
}

impl Frames {
    /// How long each frame of the animation is exposed.
    pub(super) fn exposure(&self, animation: &Animation) -> Exposure {
        match (self.shutter, self.samples) {
            (Some(shutter), Some(samples)) => Exposure { span: shutter * animation.clock_delta(), samples },
            _ => Exposure::default(),
        }
    }
}

/// What there is to say about a frame.
struct Told {
    frame: u32,
    diagnostics: Vec<Diagnostic>,
    sources: SourceMap,
    /// Why there is none.
    failure: Option<String>,
}

/// Renders all frames.
pub(super) fn run(scene: &SceneArguments, job: &Job, animation: &Animation, threads: usize) -> ExitCode {
    end_on_interrupt();
    let session = Session::new(threads);
    let numbers: Vec<u32> = (animation.initial_frame..=animation.final_frame).collect();
    let bar = progress_bar("{bar:40} {pos}/{len} frames  {elapsed_precise} elapsed, {eta_precise} left");
    bar.set_length(numbers.len() as u64);
    let work = |i: usize, _: bool| frame(&session, scene, job, animation, numbers[i]);
    let mut n_failed = 0;
    measured_in_order(numbers.len(), work, |_, told| {
        bar.suspend(|| {
            scene.how.messages.show(&told.diagnostics, &told.sources);
            told.failure.iter().for_each(|why| messages::line(format_args!("error: frame {}: {why}", told.frame)));
        });
        bar.inc(1);
        n_failed += usize::from(told.failure.is_some());
        true
    });
    bar.finish_and_clear();
    if n_failed == 0 {
        return ExitCode::SUCCESS;
    }
    messages::line(format_args!("{n_failed} of {} frames were not made", numbers.len()));
    ExitCode::from(if n_failed == numbers.len() { ERROR } else { 1 })
}

/// Makes one frame, if it is not there already; how many at once keep all cores busy, if it was made.
fn frame(
    session: &Session,
    scene: &SceneArguments,
    job: &Job,
    animation: &Animation,
    frame: u32,
) -> (Told, Option<usize>) {
    let mut job = job.clone();
    animation.show(frame, &mut job.reading);
    for output in &mut job.outputs {
        output.file = numbered(&output.file, frame, animation.digits());
    }
    let told = |diagnostics, sources, failure| Told { frame, diagnostics, sources, failure };
    let ready = match session.compile(&job.scene, &job.reading, &scene.host()) {
        Ok(ready) => ready,
        Err(failed) => return (told(failed.diagnostics, failed.sources, Some("the scene has errors".into())), None),
    };
    if job.keeping == Keeping::Resuming && session.is_made(&job, &ready) == Some(true) {
        return (told(ready.warnings, ready.sources, None), None);
    }
    let bar = Bar { bar: indicatif::ProgressBar::hidden(), stopped: None };
    let developed = if job.exposure.is_a_moment() {
        Ok(session.develop(&job, ready, &bar))
    } else {
        session.expose(&job, &scene.host(), &bar)
    };
    let mut outcome = match developed {
        Ok(outcome) => outcome,
        Err(failed) => return (told(failed.diagnostics, failed.sources, Some("the scene has errors".into())), None),
    };
    let failure = session.write(&mut outcome, &job).err().map(|error| error.to_string());
    let at_once = outcome.at_once(session.threads(), &job);
    (told(outcome.warnings, outcome.sources, failure), Some(at_once))
}

/// With the frame's number between name and extension; standard output takes one frame after the other.
fn numbered(file: &Path, frame: u32, digits: usize) -> PathBuf {
    if file == Path::new("-") {
        return file.into();
    }
    let mut name = file.with_extension("").into_os_string();
    name.push(format!("{frame:0digits$}"));
    if let Some(extension) = file.extension() {
        name.push(".");
        name.push(extension);
    }
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_numbered_between_name_and_extension() {
        assert_eq!(numbered("a/b.c.png".as_ref(), 7, 3), PathBuf::from("a/b.c007.png"));
        assert_eq!(numbered("noext".as_ref(), 12, 1), PathBuf::from("noext12"));
        assert_eq!(numbered("-".as_ref(), 12, 1), PathBuf::from("-"));
    }

    #[test]
    fn ranges_have_a_direction() {
        assert_eq!((range("1-10"), clocks("0.5,-2")), (Ok((1, 10)), Ok((0.5, -2.0))));
        assert!(range("3-2").is_err() && range("3").is_err() && clocks("1").is_err() && clocks("1,inf").is_err());
    }
}
