//! Rays from the faces of meshes.
//!
//! Source: section 1.5 of the camera facts (measured); the quirks of rows are POV-Ray's.

use crate::compiled::camera::Camera;
use crate::compiled::mesh_camera::{MeshCamera, MeshDistribution, MeshFace};
use crate::math::{DVec2, DVec3, Ray};

/// The rays that exist at an image position of a picture of width and height.
pub(in crate::render) fn mesh_rays(
    camera: &Camera,
    mesh: &MeshCamera,
    [x, y]: [f64; 2],
    [width, height]: [usize; 2],
) -> Vec<Ray> {
    let column = (x.max(0.0) as usize).min(width - 1);
    let row = (y.max(0.0) as usize).saturating_sub(1);
    let at_center = |face: MeshFace| ray(camera, face.corners.iter().sum::<DVec3>() / 3.0, face.normal);
    match mesh.distribution {
        MeshDistribution::Parallel(n) => {
            let face = |k: usize| mesh.meshes.get(k)?.face(row * width + column);
            (0..n).filter_map(face).map(at_center).collect()
        }
        MeshDistribution::Sequential => mesh.face(row * width + column).map(at_center).into_iter().collect(),
        MeshDistribution::SideBySide => {
            let share = (width / mesh.meshes.len()).max(1);
            let face = mesh.meshes.get(column / share).and_then(|mesh| mesh.face(row * share + column));
            face.map(at_center).into_iter().collect()
        }
        MeshDistribution::Unwrapped { smooth } => {
            let u = if column == width - 1 { width as f64 - 1.5 } else { x.max(0.0) } / width as f64;
            let down = if y < 1.0 { 0.5 } else { y };
            let uv = DVec2::new(u, 1.0 - down / height as f64);
            let found = mesh.meshes.iter().find_map(|mesh| {
                let mut faces = mesh.faces.iter().enumerate();
                let (i, weights) = faces.find_map(|(i, face)| Some((i, face.weights_at(uv)?)))?;
                Some((mesh.face(i)?, weights))
            });
            found.map(|(face, weights)| ray_on_face(camera, &face, weights, smooth)).into_iter().collect()
        }
    }
}

fn ray_on_face(camera: &Camera, face: &MeshFace, weights: [f64; 3], smooth: bool) -> Ray {
    let mean = |values: [DVec3; 3]| (0..3).map(|i| weights[i] * values[i]).sum::<DVec3>();
    let normal = match face.normals {
        Some(normals) if smooth => mean(normals).normalize_or(face.normal),
        _ => face.normal,
    };
    ray(camera, mean(face.corners), normal)
}

/// The camera's `location.z` moves the origin along the normal, its `direction.z` may turn the ray round.
fn ray(camera: &Camera, point: DVec3, normal: DVec3) -> Ray {
    // POV-Ray's limit of a negative direction.
    let direction = if camera.direction.z < -1e-10 { -normal } else { normal };
    Ray::new(point + camera.location.z * normal, direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_belong_to_a_face() {
        let face = MeshFace {
            corners: [DVec3::ZERO, DVec3::X, DVec3::Y],
            normal: DVec3::NEG_Z,
            uvs: [DVec2::ZERO, DVec2::X, DVec2::Y],
            normals: None,
        };
        assert_eq!(face.weights_at(DVec2::new(0.5, 0.5)), Some([0.0, 0.5, 0.5]));
        assert_eq!(face.weights_at(DVec2::new(0.25, 0.25)), Some([0.5, 0.25, 0.25]));
        assert_eq!(face.weights_at(DVec2::new(0.6, 0.6)), None);
    }
}
