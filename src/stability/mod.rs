//! How far scenes can be driven before a picture breaks: ours, and POV-Ray's of the same scene.
//!
//! A [`Family`] is one scene that grows more extreme with a number; a [`Sweep`] is a program's way through it. [`make`]
//! sweeps families, [`write()`] lays down the table as text, page, CSV and JSON.
//!
//! Errors are what a family's truth says they are: mostly the share of pixels that are off by more than [`VISIBLE`] from
//! the picture of the same scene at ordinary size, by the same program. So nothing is asked here of how alike the programs
//! are, only of how well each one keeps to itself.

mod catalog;
mod family;
mod page;
mod sweep;
mod table;

pub use catalog::{catalog, named};
pub use family::{BadFamily, Extremity, Family, Truth};
pub use sweep::{Setup, Step, Sweep, VISIBLE};

use crate::imaging::{ImageError, write_whole};
use crate::measure::{Caller, Machine, Program, Progress, Watcher, povray_version};
use std::path::Path;
use std::time::Duration;

/// What is to be done.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Which families, in order.
    pub families: Vec<Family>,
    /// This program.
    pub whitted: Caller,
    /// POV-Ray, if it is to show how far it goes.
    pub povray: Option<Caller>,
    /// How long a step may take.
    pub limit: Duration,
    /// When, and by which command line, in words.
    pub origin: [String; 2],
}

/// All that was found.
#[derive(Clone, Debug)]
pub struct Findings {
    /// What was asked for.
    pub plan: Plan,
    /// Versions of the programs.
    pub programs: Vec<String>,
    /// Where it was measured.
    pub machine: Machine,
    /// Of each family, the sweep of each program, ours first.
    pub sweeps: Vec<Vec<Sweep>>,
}

/// Sweeps all families.
///
/// # Errors
/// When there is no folder for pictures on their way, or POV-Ray is asked for and not there.
pub fn make(plan: Plan, watcher: &dyn Watcher) -> Result<Findings, String> {
    let mut programs = vec![format!("whitted {}", env!("CARGO_PKG_VERSION"))];
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let setup = |program, caller: &Caller| Setup {
        program,
        caller: caller.clone(),
        limit: plan.limit,
        folder: folder.path().to_owned(),
    };
    let mut setups = vec![setup(Program::Whitted, &plan.whitted)];
    if let Some(povray) = &plan.povray {
        programs.push(povray_version(&povray.program)?);
        setups.push(setup(Program::PovRay, povray));
    }
    let machine = Machine::here();
    let steps: usize = plan.families.iter().map(|family| family.steps.len() * setups.len()).sum();
    let progress = Progress::new(watcher, steps as f64);
    let mut sweeps = Vec::new();
    for family in &plan.families {
        let sweep = |setup: &Setup| {
            let mut n_begun = 0;
            let sweep = setup.sweep(family, usize::MAX, |x| {
                progress.add(if n_begun > 0 { 1.0 } else { 0.0 });
                n_begun += 1;
                progress.begins(&format!("{}: {}, {}", family.name, setup.program.name(), family.shown(x)));
            });
            progress.add((family.steps.len() - n_begun.max(1) + 1) as f64);
            sweep
        };
        sweeps.push(setups.iter().map(sweep).collect());
    }
    Ok(Findings { plan, programs, machine, sweeps })
}

/// Writes `stability.md`, `stability.html`, `stability.csv` and `stability.json` into a folder, which is made if need be.
///
/// # Errors
/// When one cannot be written.
pub fn write(findings: &Findings, folder: &Path) -> Result<(), ImageError> {
    std::fs::create_dir_all(folder).map_err(|error| ImageError::Io(folder.to_owned(), error))?;
    write_whole(&folder.join("stability.md"), table::markdown(findings).as_bytes())?;
    write_whole(&folder.join("stability.csv"), table::csv(findings).as_bytes())?;
    write_whole(&folder.join("stability.json"), table::json(findings).as_bytes())?;
    write_whole(&folder.join("stability.html"), page::html(findings).as_bytes())
}

/// The table for a terminal.
pub fn text(findings: &Findings) -> String {
    table::text(findings)
}
