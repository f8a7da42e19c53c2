//! Where the photons of a light go that is to meet a target: in rings about the middle of its box.
//!
//! Source: photon facts, section 3 (measured).

use crate::compiled::light::Light;
use crate::compiled::photons::PhotonTarget;
use crate::math::{DVec3, Ray};
use std::f64::consts::{PI, TAU};

/// POV-Ray's cosine from which on a direction counts as that of the z axis.
const NEAR_Z: f64 = 0.9;

/// POV-Ray's angle below which a ring is a point.
const POINT: f64 = 1e-10;

/// The rings of one light, or of one of its samples, and a target.
#[derive(Clone, Debug)]
pub(in crate::render) struct Rings {
    origin: DVec3,
    /// Unit direction to the middle of the target, or of parallel light.
    axis: DVec3,
    /// Unit, across the axis.
    across: DVec3,
    /// Light runs along the axis from a plane across it.
    parallel: bool,
    /// From ring to ring: an angle, or a length for parallel light.
    pub(in crate::render) step: f64,
    /// Rings reach so far.
    pub(in crate::render) end: f64,
    /// Distance of photons at a distance of one, or at any for parallel light.
    pub(in crate::render) spacing: f64,
}

/// Where in the rings a photon goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct Shot {
    /// Along the radius, as [`Rings::step`].
    pub(in crate::render) theta: f64,
    /// Around the axis.
    pub(in crate::render) phi: f64,
}

impl Rings {
    /// Those of a light that stands at `origin`, or of its sample there; `spacing` is that of photons on the target.
    pub(in crate::render) fn new(light: &Light, origin: DVec3, target: &PhotonTarget, spacing: f64) -> Self {
        let (middle, radius) = (target.bounds.center(), 0.5 * target.bounds.size().length());
        let to = middle - origin;
        let distance = to.length();
        let toward = to.normalize_or(DVec3::Y);
        let axis = if light.parallel { light.axis } else { toward };
        let reference = if (toward.z.abs() - 1.0).abs() < 1.0 - NEAR_Z { DVec3::Y } else { DVec3::Z };
        let across = axis.cross(reference).try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector());
        if light.parallel {
            let origin = middle - to.dot(axis) * axis;
            return Self { origin, axis, across, parallel: true, step: spacing, end: radius, spacing };
        }
        let end = if distance < radius { PI } else { (radius / distance).asin() };
        let spacing = spacing / distance;
        Self { origin, axis, across, parallel: false, step: spacing.atan(), end, spacing }
    }

    /// The photons of a ring, by numbers in 0..1.
    pub(in crate::render) fn ring(&self, theta: f64, jitter: f64, random: &mut impl FnMut() -> f64) -> Vec<Shot> {
        let apart = match theta {
            _ if theta < POINT => TAU,
            _ if self.parallel => self.step / theta,
            _ => self.step / theta.sin(),
        };
        let first = 0.5 * random() * apart - PI;
        let end = first + TAU - 0.5 * apart;
        let mut shots = Vec::new();
        let mut phi = first;
        while phi < end {
            let moved = phi + apart * jitter * (random() - 0.5);
            let theta = theta + self.step * jitter * (random() - 0.5);
            shots.push(Shot { theta, phi: moved });
            phi += apart;
        }
        shots
    }

    /// The ray of a photon.
    pub(in crate::render) fn ray(&self, shot: Shot) -> Ray {
        let (sin, cos) = shot.phi.sin_cos();
        let turned = cos * self.across + sin * self.axis.cross(self.across);
        if self.parallel {
            return Ray::new(self.origin + shot.theta * turned, self.axis);
        }
        let (sin, cos) = shot.theta.sin_cos();
        Ray::new(self.origin, (cos * self.axis - sin * turned).normalize_or(self.axis))
    }
}
