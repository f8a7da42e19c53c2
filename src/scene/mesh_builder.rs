//! A mesh of triangles that come one by one.

use super::{Mesh, Texture};
use crate::math::{DVec2, DVec3};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Marks a face without normals of its own among faces that have some.
pub const FLAT_FACE: [u32; 3] = [u32::MAX; 3];

/// A mesh under construction: equal points, normals and textures are stored once.
#[derive(Debug, Default)]
pub struct MeshBuilder {
    mesh: Mesh,
    points: FxHashMap<[u32; 3], u32>,
    normals: FxHashMap<[u32; 3], u32>,
    uvs: FxHashMap<[u64; 2], u32>,
    textures: FxHashMap<usize, u32>,
    any_normal: bool,
    any_uv: bool,
    any_texture: bool,
}

impl MeshBuilder {
    fn point(&mut self, p: DVec3) -> u32 {
        let p = p.as_vec3().to_array();
        let next = self.mesh.vertices.len() as u32;
        let index = *self.points.entry(p.map(f32::to_bits)).or_insert(next);
        if index == next {
            self.mesh.vertices.push(p);
        }
        index
    }

    fn normal(&mut self, n: [f32; 3]) -> u32 {
        let next = self.mesh.normals.len() as u32;
        let index = *self.normals.entry(n.map(f32::to_bits)).or_insert(next);
        if index == next {
            self.mesh.normals.push(n);
        }
        index
    }

    fn uv(&mut self, uv: DVec2) -> u32 {
        let next = self.mesh.uvs.len() as u32;
        let index = *self.uvs.entry(uv.to_array().map(f64::to_bits)).or_insert(next);
        if index == next {
            self.mesh.uvs.push(uv);
        }
        index
    }

    fn texture(&mut self, texture: Arc<Texture>) -> u32 {
        let next = self.mesh.textures.len() as u32;
        let index = *self.textures.entry(Arc::as_ptr(&texture) as usize).or_insert(next);
        if index == next {
            self.mesh.textures.push(texture);
        }
        index
    }

    /// Adds a triangle: its corners, and the unit normals, uv coordinates and textures there, as far as it has some. One
    /// without area is dropped silently, as in POV-Ray.
    pub fn face(
        &mut self,
        v: [DVec3; 3],
        normals: Option<[[f32; 3]; 3]>,
        uvs: Option<[DVec2; 3]>,
        textures: Option<[Arc<Texture>; 3]>,
    ) {
        // What is dropped may still be the first to name a texture.
        let textures = textures.map(|three| three.map(|texture| self.texture(texture)));
        if (v[1] - v[0]).cross(v[2] - v[0]) == DVec3::ZERO {
            return;
        }
        let face = v.map(|p| self.point(p));
        self.mesh.faces.push(face);
        self.any_normal |= normals.is_some();
        let normal_indices = normals.map_or(FLAT_FACE, |n| n.map(|n| self.normal(n)));
        self.mesh.normal_indices.push(normal_indices);
        self.any_uv |= uvs.is_some();
        let uv_indices = uvs.unwrap_or_default().map(|uv| self.uv(uv));
        self.mesh.uv_indices.push(uv_indices);
        self.any_texture |= textures.is_some();
        self.mesh.face_textures.push(textures);
    }

    /// The mesh.
    pub fn finish(mut self) -> Mesh {
        if !self.any_uv {
            self.mesh.uv_indices = Vec::new();
            self.mesh.uvs = Vec::new();
        }
        if !self.any_texture {
            self.mesh.face_textures = Vec::new();
        }
        if !self.any_normal {
            self.mesh.normal_indices = Vec::new();
        }
        self.mesh
    }
}
