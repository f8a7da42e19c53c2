//! Error against run time, ours and POV-Ray's, for anybody's scene.
//!
//! A [`Plan`] names scenes; each has [ladders](ladder) of ways to make its picture, coarse to fine. [`make`] climbs them:
//! every rung is a child process of its own, several times, in turn, and its picture is held against a
//! [reference](reference::Reference) far finer than any rung. [`write()`] lays it down as a page that can be read by itself,
//! and as tables for programs.
//!
//! Errors are root mean squares over all pixels and the three channels of the differences of unclamped linear light, as
//! `whitted compare` gives them.

mod bench;
mod census;
mod front;
mod page;
mod plan;
mod rays;
mod standing;
mod table;

pub mod ladder;
pub mod reference;

pub use bench::{Bench, Climb, Figures, Images, ShownReference, Spread};
pub use census::Census;
pub use plan::{Plan, Subject};
pub use rays::Rays;

use crate::imaging::{ImageError, write_whole};
use crate::measure::{Machine, Progress, Watcher, povray_version};
use std::path::Path;

/// What errors are, in words.
const ERROR_SPACE: &str = "root mean square over all pixels and the channels red, green and blue of differences of linear \
    light (Rec. 709 primaries, referred to the scene, not clamped)";

/// All that was measured, with what it was measured on.
#[derive(Clone, Debug)]
pub struct Report {
    /// What was asked for.
    pub plan: Plan,
    /// Versions of the programs.
    pub programs: Vec<String>,
    /// Where it was measured.
    pub machine: Machine,
    /// Scene by scene.
    pub benches: Vec<Bench>,
}

/// Measures everything; a rung that fails is a gap with its reason.
///
/// # Errors
/// When there is no folder for pictures on their way, or POV-Ray is to race and is not there.
pub fn make(plan: Plan, watcher: &dyn Watcher) -> Result<Report, String> {
    let mut programs = vec![format!("whitted {}", env!("CARGO_PKG_VERSION"))];
    if let Some(povray) = &plan.povray {
        programs.push(povray_version(&povray.program)?);
    }
    let machine = Machine::here();
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let all = plan.subjects.iter().map(|subject| bench::weight(&plan, subject)).sum();
    let progress = Progress::new(watcher, all);
    let benches = plan.subjects.iter().map(|subject| bench::bench(&plan, subject, folder.path(), &progress)).collect();
    Ok(Report { plan, programs, machine, benches })
}

/// Writes `report.html`, `report.csv` and `report.json` into a folder, which is made if need be.
///
/// # Errors
/// When one cannot be written.
pub fn write(report: &Report, folder: &Path) -> Result<(), ImageError> {
    std::fs::create_dir_all(folder).map_err(|error| ImageError::Io(folder.to_owned(), error))?;
    write_whole(&folder.join("report.csv"), table::csv(report).as_bytes())?;
    write_whole(&folder.join("report.json"), table::json(report).as_bytes())?;
    write_whole(&folder.join("report.html"), page::html(report).as_bytes())
}
