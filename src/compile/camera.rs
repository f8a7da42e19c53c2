//! Cameras: angles in radians, lens and bumps compiled.

use super::texture::{Refusal, TextureCompiler};
use crate::compiled::camera::{Camera, FocalBlur, Projection};
use crate::compiled::mesh_camera::{CameraMesh, MeshCamera, MeshDistribution, MeshFace};
use crate::math::DVec3;
use crate::scene::{self, CameraKind, Mesh, Shape};
use rustc_hash::FxHashMap;
use std::sync::Arc;

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
        CameraKind::Mesh(mesh) => Projection::Mesh(Box::new(mesh_camera(mesh)?)),
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

fn mesh_camera(camera: &scene::MeshCamera) -> Result<MeshCamera, Refusal> {
    let distribution = match camera.distribution {
        0 => MeshDistribution::Parallel(camera.rays_per_pixel as usize),
        1 => MeshDistribution::Sequential,
        2 => MeshDistribution::SideBySide,
        _ => MeshDistribution::Unwrapped { smooth: camera.smooth },
    };
    // POV-Ray's limit below which no distance counts as given.
    let max_distance = if camera.max_distance >= 1e-10 { camera.max_distance } else { f64::INFINITY };
    let mut known: FxHashMap<*const Mesh, Arc<[MeshFace]>> = FxHashMap::default();
    let mut meshes = Vec::with_capacity(camera.meshes.len());
    for object in &camera.meshes {
        let Shape::Mesh(mesh) = &object.shape else {
            return Err("a mesh_camera takes meshes only".into());
        };
        let faces = Arc::clone(known.entry(Arc::as_ptr(mesh)).or_insert_with(|| mesh_faces(mesh)));
        meshes.push(CameraMesh { faces, world_from_local: object.place.transform() });
    }
    Ok(MeshCamera { distribution, max_distance, meshes })
}

/// The faces of a mesh in its own space.
fn mesh_faces(mesh: &Mesh) -> Arc<[MeshFace]> {
    let vector = |v: [f32; 3]| DVec3::from(v.map(f64::from));
    let face = |(i, face): (usize, &[u32; 3])| {
        let corners = face.map(|v| vector(mesh.vertices[v as usize]));
        let uv = |index: u32| mesh.uvs.get(index as usize).copied().unwrap_or_default();
        let normals = mesh.normal_indices.get(i).and_then(|indices| {
            let [a, b, c] = indices.map(|index| mesh.normals.get(index as usize).copied().map(vector));
            Some([a?, b?, c?])
        });
        MeshFace {
            corners,
            normal: (corners[2] - corners[0]).cross(corners[1] - corners[0]),
            uvs: mesh.uv_indices.get(i).map_or_else(Default::default, |three| three.map(uv)),
            normals,
        }
    };
    mesh.faces.iter().enumerate().map(face).collect()
}
