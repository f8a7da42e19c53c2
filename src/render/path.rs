//! A ray on its way.

use super::medium::Interiors;
use super::random::Random;
use crate::compiled::geometry::RayKind;
use crate::math::{Range, Ray};

/// A ray with its history.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// World space, unit direction.
    pub(super) ray: Ray,
    /// Where hits count.
    pub(super) range: Range,
    /// How many diffuse surfaces lie between it and the camera: 0 for all but sample rays of radiosity and what they
    /// become.
    pub(super) bounce: u32,
    /// How many objects it went straight through whose light comes from below their surfaces.
    pub(super) below: u8,
    /// Which objects it sees.
    pub(super) kind: RayKind,
    /// 1 for camera rays, one more for each bend or reflection.
    pub(super) level: u32,
    /// How much of the pixel it makes up.
    pub(super) weight: f32,
    /// Objects it is inside of.
    pub(super) interiors: Interiors,
    /// Wavelength in nm after a dispersing surface.
    pub(super) wavelength: Option<f64>,
    /// Random choices at its end.
    pub(super) random: Random,
}
