//! Cameras, with all steps of section 1.3 of the camera facts already applied.

use super::{Normal, Object, Pigment};
use crate::diag::Span;
use crate::math::{DVec2, DVec3};
use std::sync::Arc;

/// A camera ready to shoot rays: look_at, angle and transformations are worked in.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Camera {
    /// The word of its block, or an empty place if there was none.
    pub span: Span,
    pub kind: CameraKind,
    pub location: DVec3,
    pub direction: DVec3,
    pub up: DVec3,
    pub right: DVec3,
    /// Degrees; the default of the type where none was given.
    pub angle_deg: f64,
    /// Vertical angle of the spherical camera.
    pub vertical_angle_deg: f64,
    pub normal: Option<Arc<Normal>>,
    pub focal_blur: Option<FocalBlur>,
}

/// Projections.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum CameraKind {
    Perspective,
    Orthographic,
    Fisheye,
    UltraWideAngle,
    Omnimax,
    Panoramic,
    /// Type 1 to 4.
    Cylinder(u8),
    Spherical,
    Mesh(Arc<MeshCamera>),
}

/// `mesh_camera`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct MeshCamera {
    pub rays_per_pixel: u32,
    pub distribution: u8,
    pub max_distance: f64,
    pub meshes: Vec<Arc<Object>>,
    pub smooth: bool,
}

/// Depth of field.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct FocalBlur {
    /// Diameter of the lens.
    pub aperture: f64,
    pub min_samples: u32,
    pub max_samples: u32,
    pub confidence: f64,
    pub variance: f64,
    /// Distance of the plane in focus.
    pub focal_distance: f64,
    pub bokeh: Option<Arc<Pigment>>,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            span: Span::default(),
            kind: CameraKind::Perspective,
            location: DVec3::ZERO,
            direction: DVec3::Z,
            up: DVec3::Y,
            right: DVec3::new(1.33, 0.0, 0.0),
            angle_deg: 90.0,
            vertical_angle_deg: 180.0,
            normal: None,
            focal_blur: None,
        }
    }
}

/// Position in the image plane: s to the right, t up, both in (-1/2, 1/2).
pub type ImagePlane = DVec2;
