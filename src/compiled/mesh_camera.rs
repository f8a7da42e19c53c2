//! Cameras whose rays start on the faces of meshes.

use crate::math::{DVec2, DVec3};

/// `mesh_camera`: a face, or a place on a face, for each pixel.
#[derive(Debug)]
pub struct MeshCamera {
    /// How pixels are handed out to faces.
    pub distribution: MeshDistribution,
    /// Longest distance that the first ray sees; infinite where none was given.
    pub max_distance: f64,
    /// The faces of each mesh, in world space.
    pub meshes: Vec<Vec<MeshFace>>,
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
    /// Unit face normal.
    pub normal: DVec3,
    /// Surface coordinates of its corners.
    pub uvs: [DVec2; 3],
    /// Unit normals at its corners, where it has some.
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
