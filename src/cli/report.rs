//! `whitted report`: error against run time, as a page.

use super::fail;
use super::progress::progress_bar;
use super::render::{duration, size};
use super::scene_arguments::{Reading, days_since_2000};
use crate::eval::date_time;
use crate::imaging::read_exr;
use crate::job::Session;
use crate::measure::{Caller, Watcher};
use crate::report::{self, Census, Plan, Subject};
use indicatif::{HumanDuration, ProgressBar};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// Pixels across and down where nobody says: large enough for edges to be few, small enough for an afternoon.
const DEFAULT_SIZE: [usize; 2] = [640, 480];

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// POV-Ray scene files
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Folder for report.html, report.csv and report.json
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    /// Picture against which errors are measured, for one scene. Without it, one far finer than all others is made
    #[arg(long, value_name = "FILE.exr")]
    reference: Option<PathBuf>,
    /// Another program that makes the same pictures, in turn
    #[arg(long, value_enum, value_name = "PROGRAM")]
    against: Option<Rival>,
    /// Where POV-Ray is
    #[arg(long, value_name = "PROGRAM", default_value = "povray")]
    povray: PathBuf,
    /// How often each picture is made
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=1000))]
    runs: u16,
    /// Worker threads of each program, 0 for one for each core
    #[arg(long, short, default_value_t = 1)]
    threads: usize,
    /// How long a picture may take before it is given up: 30s, 5m, 1.5h
    #[arg(long, value_name = "TIME", default_value = "10m", value_parser = duration)]
    timeout: Duration,
    /// Pixels across [default: those of the reference, or 640]
    #[arg(long, short = 'W', value_parser = size, requires = "height")]
    width: Option<usize>,
    /// Pixels down [default: those of the reference, or 480]
    #[arg(long, short = 'H', value_parser = size, requires = "width")]
    height: Option<usize>,
    #[command(flatten)]
    how: Reading,
}

/// Programs that may race.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(super) enum Rival {
    Povray,
}

/// Measures everything and writes the page.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    if arguments.reference.is_some() && arguments.scenes.len() > 1 {
        return fail("--reference is for one scene");
    }
    let plan = match plan(arguments) {
        Ok(plan) => plan,
        Err(why) => return fail(why),
    };
    let bar = Bar(progress_bar("{bar:40} {percent:>3} %  {prefix}\n{wide_msg}"));
    let made = report::make(plan, &bar);
    bar.0.finish_and_clear();
    let report = match made {
        Ok(report) => report,
        Err(why) => return fail(why),
    };
    if let Err(error) = report::write(&report, &arguments.output) {
        return fail(error);
    }
    arguments.how.messages.remark(format_args!("wrote {}", arguments.output.join("report.html").display()));
    ExitCode::SUCCESS
}

fn plan(arguments: &Arguments) -> Result<Plan, String> {
    let size = match (arguments.width.zip(arguments.height), &arguments.reference) {
        (Some((width, height)), _) => [width, height],
        (None, Some(file)) => {
            read_exr(file).map(|picture| [picture.width, picture.height]).map_err(|e| e.to_string())?
        }
        (None, None) => DEFAULT_SIZE,
    };
    let threads = match arguments.threads {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    let own = std::env::current_exe().map_err(|error| format!("this program does not find itself: {error}"))?;
    let how = &arguments.how;
    let typed: Vec<String> = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    Ok(Plan {
        subjects: arguments.scenes.iter().map(|scene| subject(scene, how, size)).collect(),
        size,
        threads,
        runs: usize::from(arguments.runs),
        limit: arguments.timeout,
        reference: arguments.reference.clone(),
        whitted: Caller { program: own, arguments: how.arguments() },
        povray: arguments
            .against
            .map(|Rival::Povray| Caller { program: arguments.povray.clone(), arguments: how.povray_arguments() }),
        origin: [date_time(days_since_2000(), "%Y-%m-%d %H:%M UTC"), format!("whitted {}", typed.join(" "))],
    })
}

/// Reads a scene once, to see what there is in it; what is wrong with it is shown and stands in the report.
fn subject(scene: &Path, how: &Reading, [width, height]: [usize; 2]) -> Subject {
    let session = Session::new(0);
    let census = match session.compile(scene, &how.options(scene, width, height), &how.host(scene)) {
        Ok(ready) => {
            how.messages.show(&ready.warnings, &ready.sources);
            Ok(Census::of(&ready.world))
        }
        Err(failed) => {
            how.messages.show(&failed.diagnostics, &failed.sources);
            let error = failed.diagnostics.iter().find(|d| d.severity == crate::diag::Severity::Error);
            Err(error.map_or_else(|| "it cannot be read".into(), |error| error.message.clone()))
        }
    };
    Subject { scene: scene.to_owned(), census }
}

/// Shows how far the report has come.
pub(super) struct Bar(pub(super) ProgressBar);

/// Steps of the bar: work has no whole unit.
const STEPS: f64 = 1000.0;

impl Watcher for Bar {
    fn begins(&self, what: &str) {
        self.0.set_message(what.to_owned());
        self.0.tick();
    }

    fn advanced(&self, done: f64, of: f64) {
        self.0.set_length(STEPS as u64);
        self.0.set_position((STEPS * done / of) as u64);
        // The rate so far tells more than that of the last steps: rungs differ, rounds do not.
        let left = self.0.elapsed().mul_f64((of - done) / done.max(1e-9));
        self.0.set_prefix(format!("{} left", HumanDuration(left)));
    }
}
