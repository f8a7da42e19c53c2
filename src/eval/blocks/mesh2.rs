//! `mesh2 { … }`: lists of points, then of faces, then of what belongs to the faces' corners.

use super::mesh::{ZERO_NORMALS, inside_vector, unit_normal};
use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::math::DVec3;
use crate::scene::{Mesh, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// A mesh while its lists come.
struct Draft {
    mesh: Mesh,
    zero_normals: bool,
}

pub(super) static MESH2: Block<()> = Block::<()>::new("mesh2", "many triangles, by the numbers of their corners", &[])
    .with(&[&POINTS, &FACES, &CORNERS, &MODIFIERS]);

static POINTS: Block<Draft> = Block::new(
    "points of a mesh2",
    "what is numbered, from 0",
    &[
        Item::new(
            K::VertexVectors,
            Takes::Other("{ N, <POINT>, … }", |e, draft, _| {
                let points = e.counted_vectors("vertex_vectors")?;
                draft.mesh.vertices = points.into_iter().map(|p| p.as_vec3().to_array()).collect();
                Ok(())
            }),
            "",
            "corners of faces",
        ),
        Item::new(K::NormalVectors, Takes::Other("{ N, <NORMAL>, … }", normal_vectors), "", "normals of corners"),
        Item::new(
            K::UvVectors,
            Takes::Other("{ N, <U, V>, … }", |e, draft, _| {
                e.open("uv_vectors")?;
                draft.mesh.uvs = e.counted_points()?;
                e.comma()?;
                e.close("uv_vectors")
            }),
            "",
            "coordinates of corners, for uv_mapping",
        ),
        Item::new(
            K::TextureList,
            Takes::Other("{ N, TEXTURE, … }", |e, draft, _| e.mesh2_textures(&mut draft.mesh)),
            "",
            "textures of corners",
        ),
    ],
);

static FACES: Block<Draft> = Block::new(
    "faces of a mesh2",
    "which corners belong together",
    &[Item::new(
        K::FaceIndices,
        Takes::Other("{ N, <A, B, C> [, TEXTURE [, TEXTURE, TEXTURE]], … }", |e, draft, _| {
            e.mesh2_faces(&mut draft.mesh)
        }),
        "",
        "numbers of the corners of each face, and of its textures",
    )],
);

static CORNERS: Block<Draft> = Block::new(
    "corners of a mesh2",
    "what belongs to the corners of its faces",
    &[
        Item::new(K::UvIndices, Takes::Other("{ N, <A, B, C>, … }", uv_indices), "", "numbers of uv_vectors"),
        Item::new(
            K::NormalIndices,
            Takes::Other("{ N, <A, B, C>, … }", normal_indices),
            "",
            "numbers of normal_vectors, if they are others than those of the corners",
        ),
        Item::new(
            K::InsideVector,
            Takes::Other("VECTOR", |e, draft, _| {
                draft.mesh.inside_vector = inside_vector(e.vector()?);
                Ok(())
            }),
            "",
            "makes it a solid: what rays this way cross an odd number of times is inside",
        ),
    ],
);

impl Evaluator<'_> {
    /// Index lists, after `mesh2 {`.
    pub(super) fn mesh2(&mut self, span: Span) -> SourceResult<Shape> {
        let mut draft = Draft { mesh: Mesh { is_mesh2: true, ..Mesh::default() }, zero_normals: false };
        self.comma()?;
        self.items_of(&POINTS, &mut draft)?;
        if draft.zero_normals {
            self.warn(Topic::Geometry, span, ZERO_NORMALS);
        }
        if draft.mesh.vertices.is_empty() {
            return self.error(span, "a mesh2 needs vertex_vectors before its face_indices");
        }
        if !self.item_of(&FACES, &mut draft)? {
            return self.expected("'face_indices'");
        }
        self.comma()?;
        self.items_of(&CORNERS, &mut draft)?;
        self.complete_indices(&mut draft.mesh, span)?;
        Ok(Shape::Mesh(Arc::new(draft.mesh)))
    }

    /// `{ n, <…>, … }` after a word.
    fn counted_vectors(&mut self, what: &str) -> SourceResult<Vec<DVec3>> {
        self.open(what)?;
        let n = self.integer()?.max(0) as usize;
        self.comma()?;
        let list = self.vector_list(n)?;
        self.comma()?;
        self.close(what)?;
        Ok(list)
    }

    fn mesh2_textures(&mut self, mesh: &mut Mesh) -> SourceResult<()> {
        self.open("texture_list")?;
        let n = self.integer()?;
        self.comma()?;
        for _ in 0..n {
            if !self.accept(K::Texture)? {
                return self.expected("a texture");
            }
            mesh.textures.push(self.texture_block()?);
            self.comma()?;
        }
        self.close("texture_list")
    }

    fn mesh2_faces(&mut self, mesh: &mut Mesh) -> SourceResult<()> {
        self.open("face_indices")?;
        let span = self.span();
        let n = self.integer()?;
        if n < 1 {
            return self.error(span, "a mesh2 needs at least one face");
        }
        self.comma()?;
        if mesh.textures.is_empty() {
            let faces = self.vector_list(n as usize)?;
            mesh.faces = self.indices(faces, mesh.vertices.len(), "vertex", span)?;
            self.comma()?;
        } else {
            self.textured_faces(mesh, n as usize, span)?;
        }
        self.close("face_indices")
    }

    fn textured_faces(&mut self, mesh: &mut Mesh, n: usize, span: Span) -> SourceResult<()> {
        let mut faces = Vec::new();
        for _ in 0..n {
            faces.push(self.vector()?);
            self.comma()?;
            let mut textures = Vec::new();
            while textures.len() < 3 && !self.at_vector()? && self.starts_expression()? {
                let span = self.span();
                let index = self.integer()?;
                if index < 0 || index as usize >= mesh.textures.len() {
                    let most = mesh.textures.len() - 1;
                    return self.error(span, format!("there is no texture {index}; they are numbered 0 to {most}"));
                }
                textures.push(index as u32);
                self.comma()?;
            }
            mesh.face_textures.push(match textures[..] {
                [] => None,
                [a] => Some([a; 3]),
                [a, b, c] => Some([a, b, c]),
                _ => return self.error(span, "a face takes one or three texture indices"),
            });
        }
        mesh.faces = self.indices(faces, mesh.vertices.len(), "vertex", span)?;
        Ok(())
    }

    /// Truncates to whole numbers and checks the range.
    fn indices(&mut self, list: Vec<DVec3>, n: usize, what: &str, span: Span) -> SourceResult<Vec<[u32; 3]>> {
        let index = |v: f64| (v > -1.0 && v < n as f64).then_some(v as u32);
        let convert = |v: DVec3| Some([index(v.x)?, index(v.y)?, index(v.z)?]);
        match list.iter().map(|v| convert(*v)).collect() {
            Some(indices) => Ok(indices),
            None => {
                let bad = list.iter().position(|v| convert(*v).is_none()).unwrap_or(0);
                let v = list[bad];
                self.error(
                    span,
                    format!(
                        "<{},{},{}> (entry {bad}) is no {what} index; there are {n}, numbered from 0",
                        v.x, v.y, v.z
                    ),
                )
            }
        }
    }

    /// Lists of numbers that are left out are those of the corners.
    fn complete_indices(&mut self, mesh: &mut Mesh, span: Span) -> SourceResult<()> {
        let n_faces = mesh.faces.len();
        if mesh.uv_indices.is_empty() && !mesh.uvs.is_empty() {
            if mesh.uvs.len() == mesh.vertices.len() {
                mesh.uv_indices = mesh.faces.clone();
            } else if mesh.uvs.len() == 1 {
                mesh.uv_indices = vec![[0; 3]; n_faces];
            } else {
                return self.error(span, "this mesh2 needs uv_indices: it has not as many uv_vectors as vertices");
            }
        }
        if mesh.normal_indices.is_empty() && !mesh.normals.is_empty() {
            if mesh.normals.len() != mesh.vertices.len() {
                return self.error(span, "this mesh2 needs normal_indices: it has not as many normals as vertices");
            }
            mesh.normal_indices = mesh.faces.clone();
        }
        Ok(())
    }
}

fn normal_vectors(e: &mut Evaluator<'_>, draft: &mut Draft, _: Word) -> SourceResult<()> {
    let normals = e.counted_vectors("normal_vectors")?;
    let unit = |n| {
        let (normal, zero) = unit_normal(n);
        draft.zero_normals |= zero;
        normal.as_vec3().to_array()
    };
    draft.mesh.normals = normals.into_iter().map(unit).collect();
    Ok(())
}

fn uv_indices(e: &mut Evaluator<'_>, draft: &mut Draft, at: Word) -> SourceResult<()> {
    let (mesh, list) = (&mut draft.mesh, e.counted_vectors("uv_indices")?);
    let n_faces = mesh.faces.len();
    if list.len() != n_faces {
        return e.error(at.span, format!("{} uv indices do not fit {n_faces} faces", list.len()));
    }
    mesh.uv_indices = e.indices(list, mesh.uvs.len(), "uv", at.span)?;
    Ok(())
}

fn normal_indices(e: &mut Evaluator<'_>, draft: &mut Draft, at: Word) -> SourceResult<()> {
    let (mesh, list) = (&mut draft.mesh, e.counted_vectors("normal_indices")?);
    let n_faces = mesh.faces.len();
    if list.len() > n_faces {
        return e.error(at.span, format!("{} normal indices are more than {n_faces} faces", list.len()));
    }
    mesh.normal_indices = e.indices(list, mesh.normals.len(), "normal", at.span)?;
    Ok(())
}
