//! Cameras: angles in radians, lens and bumps compiled.

use super::texture::{Refusal, TextureCompiler};
use crate::compiled::camera::{Camera, FocalBlur, Projection};
use crate::scene::{self, CameraKind};

pub(super) fn camera(camera: &scene::Camera, textures: &mut TextureCompiler<'_>) -> Result<Camera, Refusal> {
    let angle = camera.angle_deg.to_radians();
    let projection = match &camera.kind {
        CameraKind::Perspective => Projection::Perspective,
        CameraKind::Orthographic => Projection::Orthographic,
        CameraKind::Fisheye => Projection::Fisheye { angle },
        CameraKind::UltraWideAngle => Projection::UltraWideAngle { angle },
        CameraKind::Omnimax => Projection::Omnimax,
        CameraKind::Panoramic => Projection::Panoramic,
        CameraKind::Cylinder(kind) => Projection::Cylinder { angle, kind: *kind },
        CameraKind::Spherical => {
            Projection::Spherical { horizontal: angle, vertical: camera.vertical_angle_deg.to_radians() }
        }
        CameraKind::Mesh(_) => return Err("`mesh_camera` is not supported yet".into()),
    };
    let normal = camera.normal.as_ref().map(|n| textures.normal(n)).transpose()?;
    let blur = camera.focal_blur.as_ref().filter(|b| b.aperture != 0.0 && b.max_samples > 0);
    let blur = blur.map(|b| focal_blur(b, textures)).transpose()?;
    let (location, direction) = (camera.location, camera.direction);
    Ok(Camera { projection, location, direction, up: camera.up, right: camera.right, normal, blur })
}

fn focal_blur(blur: &scene::FocalBlur, textures: &mut TextureCompiler<'_>) -> Result<FocalBlur, Refusal> {
    Ok(FocalBlur {
        aperture: blur.aperture,
        min_samples: blur.min_samples as usize,
        max_samples: blur.max_samples as usize,
        confidence: blur.confidence,
        variance: blur.variance,
        focal_distance: blur.focal_distance,
        bokeh: blur.bokeh.as_ref().map(|p| textures.pigment(p)).transpose()?,
    })
}
