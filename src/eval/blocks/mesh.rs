//! `mesh { … }` and `mesh2 { … }`.

use crate::diag::{SourceResult, Span, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::{DVec2, DVec3};
use crate::scene::{Mesh, MeshBuilder, Shape, Texture};
use crate::syntax::Keyword as K;
use crate::syntax::TokenKind;
use std::sync::Arc;

/// Below this in every component a normal counts as zero, as in POV-Ray.
const POV_ZERO_NORMAL: f64 = 1e-10;

impl Evaluator<'_> {
    /// Triangles one by one, after `mesh {`.
    pub(super) fn mesh(&mut self, span: Span) -> SourceResult<Shape> {
        let mut builder = MeshBuilder::default();
        let (mut zero_normals, mut inside) = (false, None);
        loop {
            self.comma()?;
            match self.keyword()? {
                Some(K::Triangle) => {
                    self.next()?;
                    self.open("triangle")?;
                    let vertices = self.three_vectors()?;
                    self.mesh_face(&mut builder, vertices, None)?;
                }
                Some(K::SmoothTriangle) => {
                    self.next()?;
                    self.open("smooth_triangle")?;
                    let (mut vertices, mut normals) = ([DVec3::ZERO; 3], [DVec3::ZERO; 3]);
                    for i in 0..3 {
                        vertices[i] = self.vector()?;
                        self.comma()?;
                        let (normal, zero) = unit_normal(self.vector()?);
                        normals[i] = normal;
                        zero_normals |= zero;
                        self.comma()?;
                    }
                    self.mesh_face(&mut builder, vertices, Some(normals))?;
                }
                Some(K::InsideVector) => {
                    self.next()?;
                    inside = inside_vector(self.vector()?);
                }
                _ => break,
            }
        }
        if zero_normals {
            self.warn(Topic::Geometry, span, "some normals of this mesh are zero and become <1,0,0>");
        }
        let mesh = Mesh { inside_vector: inside, ..builder.finish() };
        if mesh.faces.is_empty() {
            return self.error(span, "a mesh needs at least one triangle that has an area");
        }
        Ok(Shape::Mesh(Arc::new(mesh)))
    }

    /// What follows a triangle's points, with its closing brace.
    fn mesh_face(&mut self, builder: &mut MeshBuilder, v: [DVec3; 3], normals: Option<[DVec3; 3]>) -> SourceResult<()> {
        let mut uvs = None;
        let mut textures = None;
        self.comma()?;
        if self.accept(K::UvVectors)? {
            let mut corners = [DVec2::ZERO; 3];
            for uv in &mut corners {
                *uv = self.vector2()?;
                self.comma()?;
            }
            uvs = Some(corners);
        }
        if self.accept(K::Texture)? {
            self.open("texture")?;
            let texture = self.mesh_texture()?;
            self.close("texture")?;
            textures = Some([texture.clone(), texture.clone(), texture]);
        } else if self.accept(K::TextureList)? {
            self.open("texture_list")?;
            let mut next = || {
                let texture = self.mesh_texture()?;
                self.comma()?;
                Ok::<_, Vec<crate::diag::Diagnostic>>(texture)
            };
            let three = [next()?, next()?, next()?];
            self.close("texture_list")?;
            textures = Some(three);
        }
        self.close("triangle")?;
        let single = |n: [DVec3; 3]| n.map(|n| n.as_vec3().to_array());
        builder.face(v, normals.map(single), uvs, textures);
        Ok(())
    }

    fn mesh_texture(&mut self) -> SourceResult<Arc<Texture>> {
        let pick = |v: &Value| if let Value::Texture(t) = v { Some(t.clone()) } else { None };
        match self.take_declared(pick)? {
            Some(texture) => Ok(texture),
            None => self.expected("the identifier of a declared texture"),
        }
    }

    /// Index lists, after `mesh2 {`.
    pub(super) fn mesh2(&mut self, span: Span) -> SourceResult<Shape> {
        let mut mesh = Mesh { is_mesh2: true, ..Mesh::default() };
        let mut zero_normals = false;
        loop {
            self.comma()?;
            match self.keyword()? {
                Some(K::VertexVectors) => {
                    let points = self.counted_vectors("vertex_vectors")?;
                    mesh.vertices = points.into_iter().map(|p| p.as_vec3().to_array()).collect();
                }
                Some(K::NormalVectors) => {
                    let normals = self.counted_vectors("normal_vectors")?;
                    mesh.normals = normals
                        .into_iter()
                        .map(|n| {
                            let (normal, zero) = unit_normal(n);
                            zero_normals |= zero;
                            normal.as_vec3().to_array()
                        })
                        .collect();
                }
                Some(K::UvVectors) => {
                    self.next()?;
                    self.open("uv_vectors")?;
                    mesh.uvs = self.counted_points()?;
                    self.comma()?;
                    self.close("uv_vectors")?;
                }
                Some(K::TextureList) => {
                    self.next()?;
                    self.mesh2_textures(&mut mesh)?;
                }
                _ => break,
            }
        }
        if zero_normals {
            self.warn(Topic::Geometry, span, "some normals of this mesh are zero and become <1,0,0>");
        }
        if mesh.vertices.is_empty() {
            return self.error(span, "a mesh2 needs vertex_vectors before its face_indices");
        }
        self.mesh2_faces(&mut mesh)?;
        self.mesh2_indices(&mut mesh, span)?;
        Ok(Shape::Mesh(Arc::new(mesh)))
    }

    /// `KEYWORD { n, <…>, … }`.
    fn counted_vectors(&mut self, what: &str) -> SourceResult<Vec<DVec3>> {
        self.next()?;
        self.open(what)?;
        let n = self.integer()?.max(0) as usize;
        self.comma()?;
        let list = self.vector_list(n)?;
        self.comma()?;
        self.close(what)?;
        Ok(list)
    }

    /// Whether the next token opens a vector.
    pub(super) fn at_vector(&mut self) -> SourceResult<bool> {
        Ok(matches!(self.peek()?.kind, TokenKind::Vector | TokenKind::Vectors | TokenKind::Punct('<')))
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
        if !self.accept(K::FaceIndices)? {
            return self.expected("'face_indices'");
        }
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

    fn mesh2_indices(&mut self, mesh: &mut Mesh, span: Span) -> SourceResult<()> {
        let n_faces = mesh.faces.len();
        loop {
            self.comma()?;
            let span = self.span();
            match self.keyword()? {
                Some(K::UvIndices) => {
                    let list = self.counted_vectors("uv_indices")?;
                    if list.len() != n_faces {
                        return self.error(span, format!("{} uv indices do not fit {n_faces} faces", list.len()));
                    }
                    mesh.uv_indices = self.indices(list, mesh.uvs.len(), "uv", span)?;
                }
                Some(K::NormalIndices) => {
                    let list = self.counted_vectors("normal_indices")?;
                    if list.len() > n_faces {
                        return self
                            .error(span, format!("{} normal indices are more than {n_faces} faces", list.len()));
                    }
                    mesh.normal_indices = self.indices(list, mesh.normals.len(), "normal", span)?;
                }
                Some(K::InsideVector) => {
                    self.next()?;
                    mesh.inside_vector = inside_vector(self.vector()?);
                }
                _ => break,
            }
        }
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

/// The unit normal, and whether it was zero and replaced by x.
fn unit_normal(n: DVec3) -> (DVec3, bool) {
    if n.abs().max_element() < POV_ZERO_NORMAL { (DVec3::X, true) } else { (n.normalize_or(DVec3::X), false) }
}

fn inside_vector(v: DVec3) -> Option<DVec3> {
    (v.abs().max_element() >= POV_ZERO_NORMAL).then(|| v.normalize_or(DVec3::X))
}
