//! Everything that a picture depends on.

use crate::eval;
use crate::imaging::{Encoding, FileKind};
use crate::render;
use std::path::PathBuf;

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
