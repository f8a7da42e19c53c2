//! Patterns: a value for each point of space, and how the point is moved first.

use super::{Function, Image, ImageMapping, Object, Pigment};
use crate::diag::Span;
use crate::math::{DVec3, Transform};
use std::path::PathBuf;
use std::sync::Arc;

/// A pattern with its modifiers.
#[derive(Clone, Debug, Default)]
pub struct Pattern {
    /// The formula.
    pub kind: PatternKind,
    /// Wave applied to the value.
    pub wave: Wave,
    /// Multiplies the value; 0 switches frequency and phase off.
    pub frequency: f32,
    /// Added to the value.
    pub phase: f32,
    /// Own noise generator (1 to 3), if any.
    pub noise_generator: Option<u8>,
    /// Classic `turbulence`, which acts last, in the innermost space.
    pub turbulence: Option<Turbulence>,
    /// Warps and transformations in written order; a lookup passes them last to first.
    pub warps: Vec<Warp>,
}

/// The value's shape over one period.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub enum Wave {
    #[default]
    Ramp,
    Triangle,
    Sine,
    Scallop,
    Cubic,
    Poly(f32),
}

/// Noise displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turbulence {
    /// Displacement per axis.
    pub amount: DVec3,
    /// Number of octaves, 1 to 10.
    pub octaves: u32,
    /// Weight from octave to octave.
    pub omega: f32,
    /// Frequency from octave to octave.
    pub lambda: f32,
}

impl Default for Turbulence {
    fn default() -> Self {
        Self { amount: DVec3::ZERO, octaves: 6, omega: 0.5, lambda: 2.0 }
    }
}

/// A step on the way of a lookup point.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum Warp {
    Transform(Transform),
    Turbulence(Turbulence),
    Repeat { axis: usize, width: f32, offset: DVec3, flip: DVec3 },
    BlackHole(BlackHole),
    Cylindrical { orientation: DVec3, dist_exp: f64 },
    Spherical { orientation: DVec3, dist_exp: f64 },
    Toroidal { orientation: DVec3, dist_exp: f64, major_radius: f64 },
    Planar { orientation: DVec3, distance: f64 },
    Cubic,
}

/// `warp { black_hole … }`.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct BlackHole {
    pub center: DVec3,
    pub radius: f64,
    pub strength: f64,
    pub falloff: f64,
    pub inverse: bool,
    pub kind: i32,
    pub repeat: Option<DVec3>,
    pub turbulence: Option<DVec3>,
}

/// Escape colouring of fractal patterns: type and factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FractalColoring {
    /// `exterior`/`interior` type.
    pub kind: u32,
    /// Its factor.
    pub factor: f64,
}

/// The formulas.
#[derive(Clone, Debug, Default)]
#[allow(missing_docs)]
pub enum PatternKind {
    /// No pattern: carries only warps (image maps, facets) or stands for a plain colour.
    #[default]
    None,
    Agate {
        turbulence: f32,
    },
    Aoi,
    Average,
    Boxed,
    Bozo,
    Spotted,
    Bumps,
    Brick {
        size: DVec3,
        mortar: f32,
    },
    Cells,
    Checker,
    Crackle {
        form: DVec3,
        metric: f64,
        offset: f64,
        solid: bool,
    },
    Cubic,
    Cylindrical,
    DensityFile {
        /// The file name.
        span: Span,
        path: PathBuf,
        interpolation: u8,
        data: Arc<[u8]>,
    },
    Dents,
    Function(Arc<Function>),
    Gradient(DVec3),
    Granite,
    Hexagon,
    /// `image_pattern`.
    Image(Arc<(Image, ImageMapping)>),
    Julia {
        c: [f64; 2],
        iterations: u32,
        exponent: u32,
        exterior: FractalColoring,
        interior: FractalColoring,
    },
    Leopard,
    Magnet {
        kind: u32,
        c: Option<[f64; 2]>,
        iterations: u32,
        exterior: FractalColoring,
        interior: FractalColoring,
    },
    Mandel {
        iterations: u32,
        exponent: u32,
        exterior: FractalColoring,
        interior: FractalColoring,
    },
    Marble,
    /// `material_map`: the value is a texture index.
    Material(Arc<(Image, ImageMapping)>),
    Object(Arc<Object>),
    Onion,
    Pavement {
        /// The word.
        span: Span,
        sides: u32,
        tiles: u32,
        pattern: u32,
        interior: u32,
        exterior: u32,
        form: u32,
    },
    Pigment(Arc<Pigment>),
    Planar,
    Quilted {
        control0: f32,
        control1: f32,
    },
    Radial,
    Ripples,
    Slope {
        direction: SlopeDirection,
        low: f64,
        high: f64,
        altitude: Option<(DVec3, f64, f64)>,
    },
    Spherical,
    Spiral1(i32),
    Spiral2(i32),
    Square,
    Tiling(u32),
    Triangular,
    /// `uv_mapping` before a pigment or normal, which is the first entry of a map and looked up at (u, v, 0).
    Uv,
    Waves,
    Wood,
    Wrinkles,
}

/// What a slope is measured against; a vector of zero only beside an altitude that is none.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub enum SlopeDirection {
    Vector(DVec3),
    PointAt(DVec3),
}

impl Pattern {
    /// The pattern with the defaults that its keyword sets (section 2 of the pattern facts).
    pub fn new(kind: PatternKind) -> Self {
        let wave = kind.own_wave().unwrap_or(Wave::Ramp);
        Self { frequency: if kind.has_no_frequency() { 0.0 } else { 1.0 }, wave, kind, ..Self::default() }
    }

    /// Whether there is anything beside the formula, or what a formula before this one set.
    pub fn is_modified(&self) -> bool {
        let moved = !self.warps.is_empty() || self.turbulence.is_some() || self.noise_generator.is_some();
        moved || self.frequency != 1.0 || self.phase != 0.0 || self.wave != Wave::Ramp
    }

    /// Levels of objects and pigments inside one another.
    pub fn depth(&self) -> u32 {
        match &self.kind {
            PatternKind::Object(object) => object.depth + 1,
            PatternKind::Pigment(pigment) => pigment.depth + 1,
            _ => 0,
        }
    }

    /// Applies a transformation written after everything so far.
    ///
    /// Successive transformations become one; identities vanish.
    pub fn apply(&mut self, transform: &Transform) {
        if let Some(Warp::Transform(last)) = self.warps.last_mut() {
            *last = last.then(transform);
        } else if !transform.is_identity() {
            self.add(Warp::Transform(*transform));
        }
    }

    /// Adds a step. Most patterns have one, and room for more would take most of their memory.
    pub fn add(&mut self, warp: Warp) {
        self.warps.reserve_exact(1);
        self.warps.push(warp);
    }
}

impl PatternKind {
    /// The wave that the keyword sets, if it sets one.
    pub fn own_wave(&self) -> Option<Wave> {
        matches!(self, Self::Marble | Self::Wood | Self::Spiral1(_) | Self::Spiral2(_)).then_some(Wave::Triangle)
    }

    /// Whether the keyword sets frequency 0, so that its value is taken as it is.
    pub fn has_no_frequency(&self) -> bool {
        matches!(
            self,
            Self::Checker
                | Self::Object(_)
                | Self::Brick { .. }
                | Self::Hexagon
                | Self::Square
                | Self::Triangular
                | Self::Cubic
                | Self::Quilted { .. }
                | Self::Image(_)
                | Self::Material(_)
        )
    }

    /// How many items a block pattern chooses from; `None` for continuous patterns.
    pub fn n_blocks(&self) -> Option<usize> {
        match self {
            Self::Checker | Self::Object(_) | Self::Brick { .. } => Some(2),
            Self::Hexagon => Some(3),
            Self::Square => Some(4),
            Self::Triangular | Self::Cubic => Some(6),
            _ => None,
        }
    }
}
