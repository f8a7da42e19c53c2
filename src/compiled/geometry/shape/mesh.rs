//! Triangle meshes: single-precision corners, a hierarchy of their own.

use super::triangle::{TriangleRay, corner_error, locate};
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::TextureId;
use crate::compiled::geometry::bvh::{Box32, Bvh};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv};
use glam::Vec3;
use rayon::prelude::*;
use smallvec::SmallVec;
use std::ops::ControlFlow;
use std::sync::Arc;

/// POV-Ray's threshold, a squared distance: nearly equal normals make a flat face.
const SAME_NORMAL: f64 = 1e-10;

/// Most triangles in a leaf: fewer make more nodes, more make more tests.
const LEAF_SIZE: usize = 4;

/// What a mesh is made of; every index is in range.
#[derive(Clone, Debug, Default)]
pub(crate) struct MeshData {
    /// Corner points.
    pub(crate) vertices: Vec<[f32; 3]>,
    /// Three corners a face.
    pub(crate) faces: Vec<[u32; 3]>,
    /// Unit vertex normals.
    pub(crate) normals: Vec<[f32; 3]>,
    /// Three normals a face; faces beyond the end are flat. `None`: the same as `faces`.
    pub(crate) normal_indices: Option<Vec<[u32; 3]>>,
    /// Surface coordinates.
    pub(crate) uvs: Vec<DVec2>,
    /// Three a face; empty for none.
    pub(crate) uv_indices: Vec<[u32; 3]>,
    /// What `face_textures` refers to.
    pub(crate) textures: Vec<TextureId>,
    /// One texture (three times the same) or three for each face; empty for none.
    pub(crate) face_textures: Vec<Option<[u32; 3]>>,
}

/// A mesh ready for rays, shared by all its copies.
#[derive(Debug)]
pub(crate) struct MeshTree {
    /// Faces in the order of the hierarchy; everything else by original face number.
    data: MeshData,
    /// Original number of each face.
    original: Vec<u32>,
    bvh: Bvh,
    bounds: Bounds,
}

/// A mesh in one place.
#[derive(Clone, Debug)]
pub(crate) struct Mesh {
    pub(crate) tree: Arc<MeshTree>,
    /// Direction of the inside test, in mesh space.
    pub(crate) inside_vector: Option<DVec3>,
}

impl MeshTree {
    /// Sorts the faces into a hierarchy.
    pub(crate) fn new(mut data: MeshData) -> Self {
        let boxes =
            data.faces.par_iter().map(|f| Box32::around_triangle(f.map(|i| Vec3::from(data.vertices[i as usize]))));
        let (bvh, original) = Bvh::build(boxes, LEAF_SIZE);
        let bounds = Bounds::around(data.faces.iter().flatten().map(|i| corner(&data.vertices, *i)));
        if data.normal_indices.is_none() && data.normals.is_empty() {
            data.normal_indices = Some(Vec::new());
        }
        data.faces = original.iter().map(|i| data.faces[*i as usize]).collect();
        Self { data, original, bvh, bounds }
    }

    fn corners(&self, face: usize) -> [DVec3; 3] {
        self.data.faces[face].map(|i| corner(&self.data.vertices, i))
    }

    /// Every crossing of a leaf run with its face.
    #[inline]
    fn walk<B>(
        &self,
        ray: &Ray,
        range: Range,
        mut found: impl FnMut(f64, usize, &mut f64) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let prepared = TriangleRay::new(ray);
        self.bvh.walk(ray, range, |faces, t_max| {
            for face in faces {
                let corners = self.data.faces[face].map(|i| &self.data.vertices[i as usize]);
                if let Some(t) = prepared.crossing(corners)
                    && range.min < t
                    && t < *t_max
                {
                    found(t, face, t_max)?;
                }
            }
            ControlFlow::Continue(())
        })
    }

    /// The vertex normals of a face, where they make it smooth.
    fn smooth_normals(&self, face: usize) -> Option<[DVec3; 3]> {
        let indices = match &self.data.normal_indices {
            None => self.data.faces[face],
            Some(list) => *list.get(self.original[face] as usize)?,
        };
        // Flat faces between smooth ones have indices beyond all normals.
        if indices.iter().any(|i| *i as usize >= self.data.normals.len()) {
            return None;
        }
        let normals = indices.map(|i| corner(&self.data.normals, i));
        let differ = |a: DVec3, b: DVec3| a.distance_squared(b) > SAME_NORMAL;
        (differ(normals[0], normals[1]) || differ(normals[0], normals[2])).then_some(normals)
    }

    /// Textures that faces have instead of the mesh's own.
    pub(crate) fn own_textures(&self) -> &[TextureId] {
        &self.data.textures
    }

    /// Textures of a face with their weights at a point in mesh space; empty where the mesh's own shows.
    pub(crate) fn textures(&self, part: u32, point: DVec3) -> SmallVec<[(TextureId, f32); 3]> {
        let original = self.original[part as usize] as usize;
        let Some(Some(chosen)) = self.data.face_textures.get(original) else { return SmallVec::new() };
        let [a, b, c] = chosen.map(|i| self.data.textures[i as usize]);
        if a == b && b == c {
            return SmallVec::from_iter([(a, 1.0)]);
        }
        let (_, weights) = locate(point, self.corners(part as usize));
        let weights = weights.max(DVec3::ZERO);
        let sum = weights.element_sum();
        [(a, weights.x), (b, weights.y), (c, weights.z)].into_iter().map(|(id, w)| (id, (w / sum) as f32)).collect()
    }
}

fn corner(points: &[[f32; 3]], index: u32) -> DVec3 {
    Vec3::from(points[index as usize]).as_dvec3()
}

impl Primitive for Mesh {
    fn bounds(&self) -> Bounds {
        self.tree.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let _: ControlFlow<()> = self.tree.walk(ray, range, |t, face, _| {
            out.push(ShapeHit { t, part: face as u32 });
            ControlFlow::Continue(())
        });
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let mut best = None;
        let _: ControlFlow<()> = self.tree.walk(ray, range, |t, face, t_max| {
            *t_max = t;
            best = Some(ShapeHit { t, part: face as u32 });
            ControlFlow::Continue(())
        });
        best
    }

    fn occluded(&self, ray: &Ray, range: Range) -> bool {
        self.tree.walk(ray, range, |_, _, _| ControlFlow::Break(())).is_break()
    }

    /// An odd number of faces along the inside vector; without one a mesh has no inside.
    fn contains(&self, p: DVec3) -> bool {
        let Some(direction) = self.inside_vector else { return false };
        let mut inside = false;
        let _: ControlFlow<()> = self.tree.walk(&Ray::new(p, direction), Range::FORWARD, |_, _, _| {
            inside = !inside;
            ControlFlow::Continue(())
        });
        inside
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let (tree, face) = (&self.tree, part as usize);
        let corners = tree.corners(face);
        let (point, weights) = locate(ray.at(t), corners);
        let [a, b, c] = corners;
        let normal = (c - a).cross(b - a);
        let shading_normal =
            tree.smooth_normals(face).map(|[na, nb, nc]| na * weights.x + nb * weights.y + nc * weights.z);
        let uv = tree.data.uv_indices.get(tree.original[face] as usize).map(|indices| {
            let [u, v, w] = indices.map(|i| tree.data.uvs[i as usize]);
            u * weights.x + v * weights.y + w * weights.z
        });
        // A mesh without coordinates has (0, 0) everywhere.
        let uv = Some(uv.unwrap_or(DVec2::ZERO));
        let plain = LocalSurface::plain(point, corner_error(corners), normal);
        LocalSurface { shading_normal, uv: uv.map(Uv::At), ..plain }
    }
}
