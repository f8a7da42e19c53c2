//! What a ray meets where it meets nothing, and on its way.

use super::{Pigment, Turbulence};
use crate::diag::Span;
use crate::math::{Color, DVec3, Rgb, Transform};
use std::sync::Arc;

/// `background`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Background {
    /// As written.
    pub color: Color,
    /// It stood where a version below 3.7 was in force: its filter and transmit do not count, and a picture with
    /// alpha does not show it.
    pub legacy: bool,
}

/// `sky_sphere`: pigments on an infinite sphere, last on top.
#[derive(Clone, Debug)]
pub struct SkySphere {
    /// The word of its block.
    pub span: Span,
    /// Layers, lowest first.
    pub pigments: Vec<Arc<Pigment>>,
    /// Colour factor.
    pub emission: Rgb,
    /// Transformations after the pigments.
    pub transform: Transform,
}

/// `fog`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Fog {
    /// The word of its block.
    pub span: Span,
    /// Type 2: density falls off with height.
    pub ground: bool,
    pub distance: f64,
    pub color: Color,
    pub offset: f64,
    pub alt: f64,
    /// Unit vector.
    pub up: DVec3,
    pub turbulence: Option<Turbulence>,
    pub turb_depth: f64,
}

impl Fog {
    /// Fog of which nothing is said.
    pub fn new(span: Span) -> Self {
        Self {
            span,
            ground: false,
            distance: 0.0,
            color: Color::BLACK,
            offset: 0.0,
            alt: 0.0,
            up: DVec3::Y,
            turbulence: None,
            turb_depth: 0.5,
        }
    }
}

/// `rainbow`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Rainbow {
    /// The word of its block.
    pub span: Span,
    pub direction: DVec3,
    /// Unit, perpendicular to `direction`.
    pub up: DVec3,
    pub angle_deg: f64,
    pub width_deg: f64,
    pub distance: f64,
    pub jitter: f64,
    pub arc_angle_deg: Option<f64>,
    pub falloff_angle_deg: Option<f64>,
    /// The band's colours over 0..1.
    pub pigment: Arc<Pigment>,
}

impl Rainbow {
    /// A rainbow of which nothing is said.
    pub fn new(span: Span) -> Self {
        Self {
            span,
            direction: DVec3::ZERO,
            up: DVec3::Y,
            angle_deg: 0.0,
            width_deg: 0.0,
            distance: 1e7, // POV-Ray's default
            jitter: 0.0,
            arc_angle_deg: None,
            falloff_angle_deg: None,
            pigment: Arc::new(Pigment::solid(Color { transmit: 1.0, ..Color::BLACK })),
        }
    }
}
