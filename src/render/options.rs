//! What the user may choose about a picture of a world.

use super::Antialias;

/// Choices that are not part of the scene.
#[derive(Clone, Debug)]
pub struct Options {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// How edges are smoothed, if at all.
    pub antialias: Option<Antialias>,
    /// 0 to 9, as POV-Ray's `+Q`.
    pub quality: u8,
    /// The picture gets an alpha channel and the background lets it show.
    pub alpha: bool,
    /// Worker threads; 0 for one for each core.
    pub threads: usize,
}

impl Options {
    /// Quick colours instead of pigments.
    pub(super) fn quick_colors(&self) -> bool {
        self.quality <= 5
    }

    /// Only pigments, no light at all.
    pub(super) fn flat(&self) -> bool {
        self.quality <= 1
    }

    pub(super) fn shadows(&self) -> bool {
        self.quality >= 4
    }

    pub(super) fn area_lights(&self) -> bool {
        self.quality >= 5
    }

    pub(super) fn refraction(&self) -> bool {
        self.quality >= 6
    }

    pub(super) fn reflection_and_normals(&self) -> bool {
        self.quality >= 8
    }

    pub(super) fn atmosphere(&self) -> bool {
        self.quality >= 9
    }
}

impl Default for Options {
    fn default() -> Self {
        Self { width: 320, height: 240, antialias: None, quality: 9, alpha: false, threads: 0 }
    }
}
