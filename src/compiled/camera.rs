//! The camera with everything that does not depend on the pixel worked out.

use super::mesh_camera::MeshCamera;
use super::texture::{Normal, Pigment};
use crate::math::DVec3;

/// A camera; vectors are those of section 1 of the camera facts, in world space.
#[derive(Debug)]
pub struct Camera {
    /// How image positions become rays.
    pub projection: Projection,
    /// Where rays start.
    pub location: DVec3,
    /// To the middle of the picture; its length matters.
    pub direction: DVec3,
    /// Height of the picture.
    pub up: DVec3,
    /// Width of the picture.
    pub right: DVec3,
    /// Bends the rays.
    pub normal: Option<Normal>,
    /// Depth of field.
    pub blur: Option<FocalBlur>,
}

/// Projections; angles in radians.
#[derive(Debug)]
#[allow(missing_docs)]
pub enum Projection {
    Perspective,
    Orthographic,
    Fisheye {
        angle: f64,
    },
    UltraWideAngle {
        angle: f64,
    },
    Omnimax,
    Panoramic,
    /// Type 1 to 4.
    Cylinder {
        angle: f64,
        kind: u8,
    },
    Spherical {
        horizontal: f64,
        vertical: f64,
    },
    /// Rays start on faces instead of at the location.
    Mesh(Box<MeshCamera>),
}

/// Depth of field.
#[derive(Debug)]
pub struct FocalBlur {
    /// Diameter of the lens.
    pub aperture: f64,
    /// Samples that are always taken.
    pub min_samples: usize,
    /// Samples that are never exceeded.
    pub max_samples: usize,
    /// Confidence of the estimate that stops sampling.
    pub confidence: f64,
    /// Variance at which sampling stops.
    pub variance: f64,
    /// Distance of the plane in focus.
    pub focal_distance: f64,
    /// Shape and tint of the lens.
    pub bokeh: Option<Pigment>,
}

impl Projection {
    /// Whether all rays start at one place.
    pub fn has_one_center(&self) -> bool {
        !matches!(self, Self::Orthographic | Self::Cylinder { kind: 3 | 4, .. } | Self::Mesh(_))
    }

    /// The language's name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Perspective => "perspective",
            Self::Orthographic => "orthographic",
            Self::Fisheye { .. } => "fisheye",
            Self::UltraWideAngle { .. } => "ultra_wide_angle",
            Self::Omnimax => "omnimax",
            Self::Panoramic => "panoramic",
            Self::Cylinder { .. } => "cylinder",
            Self::Spherical { .. } => "spherical",
            Self::Mesh(_) => "mesh_camera",
        }
    }
}
