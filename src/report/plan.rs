//! What a report is to be about.

use super::census::Census;
use crate::measure::{Caller, Invocation, Program, Task};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Everything that a report depends on.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The scenes, in order.
    pub subjects: Vec<Subject>,
    /// Pixels across and down.
    pub size: [usize; 2],
    /// Worker threads of each program, at least 1.
    pub threads: usize,
    /// How often each rung is measured.
    pub runs: usize,
    /// How long one run may take.
    pub limit: Duration,
    /// The reference, where it is not to be made; for one scene.
    pub reference: Option<PathBuf>,
    /// This program.
    pub whitted: Caller,
    /// POV-Ray, if it races.
    pub povray: Option<Caller>,
    /// When, and by which command line, in words.
    pub origin: [String; 2],
}

/// A scene and what was found out about it.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The file, as it was named.
    pub scene: PathBuf,
    /// What there is in it, or why it cannot be rendered.
    pub census: Result<Census, String>,
}

impl Plan {
    /// A program at work on a scene, in the scene's folder.
    ///
    /// # Errors
    /// Where the scene's full name cannot be found out, or the program does not race.
    pub(super) fn invocation(
        &self,
        program: Program,
        scene: &Path,
        rung: &[String],
        picture: &Path,
    ) -> Result<Invocation, String> {
        let caller = match program {
            Program::Whitted => &self.whitted,
            Program::PovRay => self.povray.as_ref().ok_or("POV-Ray does not race")?,
        };
        caller.invocation(program, Task { scene, picture, size: self.size, threads: self.threads }, rung)
    }
}
