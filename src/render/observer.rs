//! Who watches a picture come into being.

/// What a picture is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
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

    /// Whether to stop; asked before each block.
    fn cancels(&self) -> bool {
        false
    }
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
