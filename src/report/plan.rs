//! What a report is to be about.

use super::census::Census;
use super::ladder::Program;
use super::measure::Invocation;
use std::ffi::OsString;
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

/// A program and what it is told with every scene: where to look for files, and what to declare.
#[derive(Clone, Debug)]
pub struct Caller {
    /// The program.
    pub program: PathBuf,
    /// Arguments.
    pub arguments: Vec<OsString>,
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
        let scene = std::path::absolute(scene).map_err(|error| format!("{}: {error}", scene.display()))?;
        let folder = scene.parent().unwrap_or(Path::new(".")).to_owned();
        let [width, height] = self.size;
        let caller = match program {
            Program::Whitted => &self.whitted,
            Program::PovRay => self.povray.as_ref().ok_or("POV-Ray does not race")?,
        };
        let mut arguments: Vec<OsString> = Vec::new();
        match program {
            Program::Whitted => {
                arguments.extend(["render".into(), scene.into_os_string(), "--output".into(), picture.into()]);
                // POV-Ray has no choice but half precision; ours is not rounded, so that small errors can be seen.
                let size = format!("--float --width {width} --height {height} --threads {}", self.threads);
                arguments.extend(size.split(' ').map(OsString::from));
            }
            Program::PovRay => {
                arguments.extend([prefixed("+I", &scene), prefixed("+O", picture)]);
                // EXR is linear light; no window, no pause.
                let size = format!("+FE +W{width} +H{height} +WT{} -D -P", self.threads);
                arguments.extend(size.split(' ').map(OsString::from));
            }
        }
        arguments.extend(caller.arguments.iter().cloned());
        arguments.extend(rung.iter().map(OsString::from));
        Ok(Invocation { program: caller.program.clone(), arguments, folder })
    }
}

fn prefixed(flag: &str, path: &Path) -> OsString {
    let mut argument = OsString::from(flag);
    argument.push(path);
    argument
}
