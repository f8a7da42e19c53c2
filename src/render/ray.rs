//! A ray on its way and what comes back.

use crate::compiled::geometry::{InteriorKey, RayKind};
use crate::math::{Range, Ray, Rgb};
use smallvec::SmallVec;

/// An object that a ray is inside of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inside {
    /// Which interior.
    pub(super) key: InteriorKey,
    /// Fog goes on inside.
    pub(super) hollow: bool,
    /// Index of refraction, with legacy finishes worked in.
    pub(super) ior: f64,
    /// Ratio of indices between violet and red.
    pub(super) dispersion: f64,
}

/// The objects that a ray is inside of, in the order of entering.
pub(super) type Interiors = SmallVec<[Inside; 4]>;

/// A ray with its history.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// Unit direction.
    pub(super) ray: Ray,
    /// Where hits count.
    pub(super) range: Range,
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
}

/// Light along a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Radiance {
    /// Linear or not, as the scene's working values are.
    pub rgb: Rgb,
    /// What part of a backdrop behind everything would be seen.
    pub transparency: f32,
}

/// Counts of what was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Camera rays.
    pub camera_rays: u64,
    /// Rays through surfaces.
    pub transmitted_rays: u64,
    /// Mirrored rays.
    pub reflected_rays: u64,
    /// Rays towards lights, each piece between transparent surfaces.
    pub shadow_rays: u64,
}

impl Radiance {
    /// What a refused ray gives.
    pub(super) const BLACK: Self = Self { rgb: Rgb::ZERO, transparency: 0.0 };
    /// What a picture shows where the camera sends no ray.
    pub(super) const CLEAR: Self = Self { rgb: Rgb::ZERO, transparency: 1.0 };
}

impl Statistics {
    /// All rays.
    pub fn rays(&self) -> u64 {
        self.camera_rays + self.transmitted_rays + self.reflected_rays + self.shadow_rays
    }

    /// Sums of both.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            camera_rays: self.camera_rays + other.camera_rays,
            transmitted_rays: self.transmitted_rays + other.transmitted_rays,
            reflected_rays: self.reflected_rays + other.reflected_rays,
            shadow_rays: self.shadow_rays + other.shadow_rays,
        }
    }
}
