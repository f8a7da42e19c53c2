//! What the user may choose about a picture of a world.

use super::image_layer::ImageLayer;
use super::radiosity::KnownLight;
use std::sync::Arc;
use std::time::Duration;

/// Choices that are not part of the scene.
#[derive(Clone, Debug)]
pub struct Options {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// How edges are smoothed in POV-Ray's ways, if at all.
    pub antialias: Option<Antialias>,
    /// Samples are taken until this is reached; then `antialias` does not count.
    pub target: Option<Target>,
    /// 0 to 9, as POV-Ray's `+Q`.
    pub quality: u8,
    /// The picture gets an alpha channel and the background lets it show.
    pub alpha: bool,
    /// The part of the picture to render; its pixels are those of the whole picture.
    pub region: Option<Region>,
    /// What is written beside the picture.
    pub layers: Vec<ImageLayer>,
    /// Light between surfaces that is known from another picture.
    pub known_light: Option<Arc<KnownLight>>,
    /// What is found of it is wanted after the picture.
    pub keeps_light: bool,
}

/// When a picture is good enough. Whatever comes first ends it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Target {
    /// Root mean square error over pixels and colour channels, linear light, that it is surely below.
    pub error: Option<f64>,
    /// How long it may take.
    pub time: Option<Duration>,
    /// Chooses the samples' places: pictures of different seeds have nothing in common but the scene.
    pub seed: u64,
    /// Rounds that were taken before, by their limits, to get the same picture again.
    pub rounds: Option<Vec<f64>>,
}

/// How edges are smoothed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Antialias {
    /// Which of the two ways.
    pub method: Method,
    /// Difference of neighbours from which a pixel is refined, 0 to 1.
    pub threshold: f64,
    /// Samples along an edge, or levels of subdivision; 1 to 9.
    pub depth: u32,
    /// Amount of jitter, 0 to 1.
    pub jitter: f64,
    /// Of light to this power's inverse differences are taken.
    pub gamma: f32,
}

impl Antialias {
    /// That of POV-Ray.
    pub const GAMMA: f32 = 2.5;

    /// The power of light of which differences are taken: none where gamma says nothing, as in POV-Ray.
    ///
    /// Source: camera and image facts, section 3.
    pub(super) fn exponent(&self) -> f32 {
        /// How near to 1 counts as 1.
        const LINEAR_WITHIN: f32 = 0.01;
        let exponent = 1.0 / self.gamma;
        if self.gamma <= 0.0 || (exponent - 1.0).abs() < LINEAR_WITHIN { 1.0 } else { exponent }
    }
}

/// The two ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Method 1: pixels that differ from a neighbour get a grid of samples.
    Grid,
    /// Method 2: pixels whose corners differ are quartered, again and again.
    Adaptive,
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
    /// Column behind the last.
    pub right: usize,
    /// Row behind the last.
    pub bottom: usize,
}

impl Region {
    /// Pixels across.
    pub fn width(&self) -> usize {
        self.right.saturating_sub(self.left)
    }

    /// Pixels down.
    pub fn height(&self) -> usize {
        self.bottom.saturating_sub(self.top)
    }
}

impl Options {
    /// The part to render: the region within the picture, or all of it.
    pub fn window(&self) -> Region {
        let all = Region { left: 0, top: 0, right: self.width, bottom: self.height };
        self.region.map_or(all, |r| Region {
            left: r.left.min(self.width),
            top: r.top.min(self.height),
            right: r.right.min(self.width),
            bottom: r.bottom.min(self.height),
        })
    }

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

    pub(super) fn indirect_light(&self) -> bool {
        self.quality >= 9
    }

    pub(super) fn atmosphere(&self) -> bool {
        self.quality >= 9
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            width: 320,
            height: 240,
            antialias: None,
            target: None,
            quality: 9,
            alpha: false,
            region: None,
            layers: Vec::new(),
            known_light: None,
            keeps_light: false,
        }
    }
}
