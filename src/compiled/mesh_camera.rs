//! Cameras whose rays start on the faces of meshes.

use crate::math::{DVec2, DVec3, Transform};
use std::sync::Arc;

/// `mesh_camera`: a face, or a place on a face, for each pixel.
#[derive(Debug)]
pub struct MeshCamera {
    /// How pixels are handed out to faces.
    pub distribution: MeshDistribution,
    /// Longest distance that the first ray sees; infinite where none was given.
    pub max_distance: f64,
    /// The meshes.
    pub meshes: Vec<CameraMesh>,
}

/// A mesh in its place; copies of one mesh share its faces.
#[derive(Debug)]
pub struct CameraMesh {
    /// Faces in the mesh's own space, normals of any length.
    pub faces: Arc<[MeshFace]>,
    /// Where it stands.
    pub world_from_local: Transform,
}

impl CameraMesh {
    /// A face in world space, with unit normals.
    pub fn face(&self, i: usize) -> Option<MeshFace> {
        let face = self.faces.get(i)?;
        let place = &self.world_from_local;
        Some(MeshFace {
            corners: face.corners.map(|p| place.point(p)),
            normal: place.normal(face.normal).normalize_or(DVec3::Z),
            uvs: face.uvs,
            normals: face.normals.map(|three| three.map(|n| place.normal(n).normalize_or_zero())),
        })
    }
}

impl MeshCamera {
    /// A face of all meshes, counted one mesh after the other.
    pub fn face(&self, mut i: usize) -> Option<MeshFace> {
        for mesh in &self.meshes {
            if i < mesh.faces.len() {
                return mesh.face(i);
            }
            i -= mesh.faces.len();
        }
        None
    }
}

/// The four distributions of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshDistribution {
    /// 0: the same face of so many meshes; their light is averaged.
    Parallel(usize),
    /// 1: the faces of all meshes one after the other.
    Sequential,
    /// 2: meshes side by side.
    SideBySide,
    /// 3: by uv coordinates; with interpolated normals if so.
    Unwrapped {
        /// Whether directions follow the vertex normals.
        smooth: bool,
    },
}

/// One face.
#[derive(Debug)]
pub struct MeshFace {
    /// Where its corners are.
    pub corners: [DVec3; 3],
    /// Face normal.
    pub normal: DVec3,
    /// Surface coordinates of its corners.
    pub uvs: [DVec2; 3],
    /// Normals at its corners, where it has some.
    pub normals: Option<[DVec3; 3]>,
}

impl MeshFace {
    /// Weights of the corners at surface coordinates, if those lie on the face; edges count.
    pub fn weights_at(&self, uv: DVec2) -> Option<[f64; 3]> {
        let [a, b, c] = self.uvs;
        let area = (b - a).perp_dot(c - a);
        let weights = [(b - uv).perp_dot(c - uv), (c - uv).perp_dot(a - uv), (a - uv).perp_dot(b - uv)];
        let weights = weights.map(|w| w / area);
        (area != 0.0 && weights.iter().all(|w| *w >= 0.0)).then_some(weights)
    }
}
