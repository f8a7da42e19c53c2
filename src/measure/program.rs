//! The programs that make pictures: this one, and POV-Ray.

use super::process::Invocation;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Who makes a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// This program.
    Whitted,
    /// An installed POV-Ray.
    PovRay,
}

impl Program {
    /// As people call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Whitted => "whitted",
            Self::PovRay => "POV-Ray",
        }
    }
}

/// A program and what it is told with every scene: where to look for files, and what to declare.
#[derive(Clone, Debug)]
pub struct Caller {
    /// The program.
    pub program: PathBuf,
    /// Arguments.
    pub arguments: Vec<OsString>,
}

/// A picture to be made, whoever makes it.
#[derive(Clone, Copy, Debug)]
pub struct Task<'a> {
    /// The scene's file.
    pub scene: &'a Path,
    /// Where the picture goes, as EXR.
    pub picture: &'a Path,
    /// Pixels across and down.
    pub size: [usize; 2],
    /// Worker threads, at least 1.
    pub threads: usize,
}

impl Caller {
    /// The program at work on a scene, in the scene's folder; `more` goes to its command line.
    ///
    /// # Errors
    /// Where the scene's full name cannot be found out.
    pub(crate) fn invocation(&self, program: Program, task: Task<'_>, more: &[String]) -> Result<Invocation, String> {
        let Task { scene, picture, size: [width, height], threads } = task;
        let scene = std::path::absolute(scene).map_err(|error| format!("{}: {error}", scene.display()))?;
        let folder = scene.parent().unwrap_or(Path::new(".")).to_owned();
        let mut arguments: Vec<OsString> = Vec::new();
        match program {
            Program::Whitted => {
                arguments.extend(["render".into(), scene.into_os_string(), "--output".into(), picture.into()]);
                // POV-Ray has no choice but half precision; ours is not rounded, so that small errors can be seen.
                let size = format!("--float --width {width} --height {height} --threads {threads}");
                arguments.extend(size.split(' ').map(OsString::from));
            }
            Program::PovRay => {
                arguments.extend([prefixed("+I", &scene), prefixed("+O", picture)]);
                // EXR is linear light; no window, no pause.
                let size = format!("+FE +W{width} +H{height} +WT{threads} -D -P");
                arguments.extend(size.split(' ').map(OsString::from));
            }
        }
        arguments.extend(self.arguments.iter().cloned());
        arguments.extend(more.iter().map(OsString::from));
        Ok(Invocation { program: self.program.clone(), arguments, folder })
    }
}

fn prefixed(flag: &str, path: &Path) -> OsString {
    let mut argument = OsString::from(flag);
    argument.push(path);
    argument
}
