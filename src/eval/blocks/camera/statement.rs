//! What a camera block says, and the frame that it adds up to.

use super::VERSION_OF_UNORDERED_CAMERAS;
use crate::diag::Span;
use crate::math::{DVec3, Transform};
use crate::scene::{Camera, CameraKind, FocalBlur, Normal, Pigment};
use std::sync::Arc;

/// What a camera block says, before it is worked into a frame.
#[derive(Clone, Debug)]
pub struct CameraStatement {
    /// The word of its block.
    pub(super) span: Span,
    pub(super) kind: CameraKind,
    pub(super) location: DVec3,
    pub(super) direction: DVec3,
    pub(super) up: DVec3,
    pub(super) right: DVec3,
    pub(super) sky: DVec3,
    pub(super) look_at: Option<DVec3>,
    pub(super) angle_deg: Option<f64>,
    pub(super) vertical_angle_deg: Option<f64>,
    /// `up` or `right` was written: orthographic cameras then keep their size.
    pub(super) has_frame: bool,
    pub(super) aperture: f64,
    pub(super) blur_samples: [u32; 2],
    pub(super) confidence: f64,
    pub(super) variance: f64,
    pub(super) focal_point: Option<DVec3>,
    pub(super) bokeh: Option<Arc<Pigment>>,
    pub(super) normal: Option<Arc<Normal>>,
    pub(super) transform: Transform,
}

impl Default for CameraStatement {
    fn default() -> Self {
        Self {
            span: Span::default(),
            kind: CameraKind::Perspective,
            location: DVec3::ZERO,
            direction: DVec3::Z,
            up: DVec3::Y,
            right: DVec3::new(1.33, 0.0, 0.0),
            sky: DVec3::Y,
            look_at: None,
            angle_deg: None,
            vertical_angle_deg: None,
            has_frame: false,
            aperture: 0.0,
            blur_samples: [0, 0],
            confidence: 0.9,
            variance: 1e-4,
            focal_point: None,
            bokeh: None,
            normal: None,
            transform: Transform::IDENTITY,
        }
    }
}

impl CameraStatement {
    /// Turns the frame to face the target; lengths and handedness stay.
    pub(super) fn face(&mut self, target: DVec3) {
        let forward = (target - self.location).normalize_or(DVec3::Z);
        let handedness = if self.up.cross(self.direction).dot(self.right) > 0.0 { 1.0 } else { -1.0 };
        let side = match self.sky.cross(forward).try_normalize() {
            Some(side) => side,
            None => self.right.normalize_or(DVec3::X), // looking along the sky: keep the written right
        };
        self.direction = self.direction.length() * forward;
        self.up = self.up.length() * forward.cross(side);
        self.right = handedness * self.right.length() * side;
    }

    /// Makes the horizontal field of view `angle_deg` wide by the length of `direction`.
    pub(super) fn set_angle(&mut self, angle_deg: f64) {
        let half = (angle_deg / 2.0).to_radians();
        self.direction = self.direction.normalize_or(DVec3::Z) * (self.right.length() / (2.0 * half.tan()));
    }

    pub(super) fn uses_flat_angle(&self) -> bool {
        matches!(self.kind, CameraKind::Perspective | CameraKind::Orthographic)
    }

    /// Works statements in, in the order of section 1.3 of the camera facts.
    ///
    /// With `ordered` (old scenes) angle, look_at and transformations have acted already.
    fn finish(mut self, ordered: bool) -> Camera {
        let flat = self.uses_flat_angle();
        if !ordered {
            if let Some(angle) = self.angle_deg.filter(|a| flat && *a > 0.0) {
                self.set_angle(angle);
            }
            if let Some(target) = self.look_at {
                self.face(target);
            }
            let rescaled = !self.has_frame || self.angle_deg.is_some();
            if matches!(self.kind, CameraKind::Orthographic) && rescaled {
                let target = self.look_at.unwrap_or(DVec3::Z);
                let scale = (target - self.location).length() / self.direction.length();
                self.right *= scale;
                self.up *= scale;
            }
        }
        let focal_distance = match self.focal_point {
            Some(point) => (point - self.location).length(),
            None if (flat && self.angle_deg.is_some()) || self.look_at.is_some() => self.direction.length(),
            None => 1.0,
        };
        let blurred = self.aperture != 0.0 && self.blur_samples[1] > 0;
        let focal_blur = blurred.then_some(FocalBlur {
            aperture: self.aperture,
            min_samples: self.blur_samples[0],
            max_samples: self.blur_samples[1],
            confidence: self.confidence,
            variance: self.variance,
            focal_distance,
            bokeh: self.bokeh,
        });
        let t = &self.transform;
        let angle_deg = self.angle_deg.unwrap_or(if matches!(self.kind, CameraKind::Spherical) { 360.0 } else { 90.0 });
        let half_if_given = if self.angle_deg.is_some() { angle_deg / 2.0 } else { 180.0 };
        Camera {
            span: self.span,
            location: t.point(self.location),
            direction: t.vector(self.direction),
            up: t.vector(self.up),
            right: t.vector(self.right),
            angle_deg,
            vertical_angle_deg: self.vertical_angle_deg.unwrap_or(half_if_given),
            normal: self.normal,
            focal_blur,
            kind: self.kind,
        }
    }

    /// The camera of a scene.
    pub(in crate::eval::blocks) fn into_camera(self, version: u32) -> Camera {
        self.finish(version < VERSION_OF_UNORDERED_CAMERAS)
    }
}
