//! Who watches a picture come into being, and keeps what is finished.

use super::statistics::Statistics;

/// What a picture is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Photons are shot.
    Photons,
    /// Light between surfaces is gathered.
    Radiosity,
    /// Pixels.
    Picture,
}

/// Told how a picture comes along; called from any thread.
pub trait Observer: Sync {
    /// What comes next.
    fn entered(&self, _stage: Stage) {}

    /// So much of the work is done; what is behind grows and may be told late.
    fn advanced(&self, _done: usize, _of: usize) {}

    /// A part of the picture is finished.
    fn finished(&self, _block: &FinishedBlock) {}

    /// Whether finished parts are wanted.
    fn wants_blocks(&self) -> bool {
        false
    }

    /// Whether finished pieces are wanted, to go on from there should the work be interrupted.
    fn keeps(&self) -> bool {
        false
    }

    /// A piece of the work is finished. Pictures with a target or layers have none.
    fn keep(&self, _piece: Piece) {}

    /// A piece that was kept in an earlier run over the same world with the same options.
    fn kept(&self, _place: Place) -> Option<Piece> {
        None
    }

    /// Whether to stop; asked before each block.
    fn cancels(&self) -> bool {
        false
    }
}

/// Which piece of the work: pieces of the same place are the same in every run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// 0 for samples that all pixels need, 1 for pixels whose edges are smoothed.
    pub stage: u32,
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
}

/// A finished piece of the work, to the bit.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Which one.
    pub place: Place,
    /// Colours and transparency as the renderer has them, row by row.
    pub samples: Vec<[f32; 4]>,
    /// What it took.
    pub statistics: Statistics,
}

/// A finished part of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct FinishedBlock {
    /// First column in the whole picture.
    pub x: usize,
    /// First row.
    pub y: usize,
    /// Pixels across.
    pub width: usize,
    /// Linear light and alpha, row by row.
    pub pixels: Vec<[f32; 4]>,
}

/// Nobody watches.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unobserved;

impl Observer for Unobserved {}
