//! Everything that a picture depends on.

use super::{Exposure, LightFiles};
use crate::eval;
use crate::imaging::{Encoding, FileKind};
use crate::render;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// One picture of one scene.
#[derive(Clone, Debug, Default)]
pub struct Job {
    /// The scene file.
    pub scene: PathBuf,
    /// How it is read.
    pub reading: eval::Options,
    /// What the picture is like.
    pub rendering: render::Options,
    /// Files that are written, in order.
    pub outputs: Vec<Output>,
    /// When it is taken.
    pub exposure: Exposure,
    /// Whether finished pieces are kept beside the first output while the picture is made.
    pub keeping: Keeping,
    /// How long a picture takes before its pieces are kept.
    pub patience: Duration,
    /// Where light between surfaces comes from and goes to.
    pub light: LightFiles,
}

/// A patience for people: what is made until then is made again as fast, and to keep it would cost small pictures a tenth of
/// their time.
pub const PATIENCE: Duration = Duration::from_millis(500);

/// What becomes of pieces of a picture that is interrupted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keeping {
    /// They are lost.
    #[default]
    Nothing,
    /// They are kept; those of an earlier run are not looked at.
    New,
    /// They are kept, and those of an earlier run of the same picture are taken.
    Resuming,
}

impl Job {
    /// The file that says which picture it is, if anything is to be kept.
    pub(super) fn marked_file(&self) -> Option<&Path> {
        let file = self.outputs.first().map(|output| output.file.as_path())?;
        let is_file = file != Path::new("-") && !file.metadata().is_ok_and(|metadata| !metadata.is_file());
        (self.keeping != Keeping::Nothing && is_file).then_some(file)
    }

    /// The file beside which pieces are kept, if there can be any: pictures with a target or layers have none.
    pub(super) fn kept_beside(&self) -> Option<&Path> {
        let is_plain = self.rendering.target.is_none() && self.rendering.layers.is_empty();
        self.marked_file().filter(|_| is_plain)
    }
}

/// A file that shows the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Its name; `-` is standard output.
    pub file: PathBuf,
    /// Its kind, whatever the name says.
    pub kind: FileKind,
    /// What the format leaves open.
    pub encoding: Encoding,
}
