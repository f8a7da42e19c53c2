//! `mesh { … }`, and what it has in common with `mesh2`.

use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::{DVec2, DVec3};
use crate::scene::{Mesh, MeshBuilder, Shape, Texture};
use crate::syntax::Keyword as K;
use crate::syntax::TokenKind;
use std::sync::Arc;

/// Below this in every component a normal counts as zero, as in POV-Ray.
const POV_ZERO_NORMAL: f64 = 1e-10;

/// A warning about such normals.
pub(super) const ZERO_NORMALS: &str = "some normals of this mesh are zero and become <1,0,0>";

/// A mesh while triangles come one by one.
#[derive(Default)]
pub(super) struct Draft {
    builder: MeshBuilder,
    zero_normals: bool,
    inside: Option<DVec3>,
}

pub(super) static MESH: Block<Draft> = Block::<Draft>::new(
    "mesh",
    "many triangles as one object",
    &[
        Item::new(
            K::Triangle,
            Takes::Other(
                "{ <A>, <B>, <C> [uv_vectors 3 <U, V>] [texture { NAME } | texture_list { 3 NAMES }] }",
                triangle,
            ),
            "",
            "a triangle",
        ),
        Item::new(
            K::SmoothTriangle,
            Takes::Other("{ <A>, <NORMAL>, <B>, <NORMAL>, <C>, <NORMAL> … }", smooth_triangle),
            "",
            "a triangle that is lit as if it were bent",
        ),
        Item::since(
            350,
            K::InsideVector,
            Takes::Other("VECTOR", |e, draft, _| {
                draft.inside = inside_vector(e.vector()?);
                Ok(())
            }),
            "",
            "makes it a solid: what rays this way cross an odd number of times is inside",
        ),
    ],
)
.with(&[&MODIFIERS]);

fn triangle(e: &mut Evaluator<'_>, draft: &mut Draft, _: Word) -> SourceResult<()> {
    e.open("triangle")?;
    let vertices = e.three_vectors()?;
    e.mesh_face(&mut draft.builder, vertices, None)
}

fn smooth_triangle(e: &mut Evaluator<'_>, draft: &mut Draft, _: Word) -> SourceResult<()> {
    e.open("smooth_triangle")?;
    let (mut vertices, mut normals) = ([DVec3::ZERO; 3], [DVec3::ZERO; 3]);
    for i in 0..3 {
        vertices[i] = e.vector()?;
        e.comma()?;
        let (normal, zero) = unit_normal(e.vector()?);
        normals[i] = normal;
        draft.zero_normals |= zero;
        e.comma()?;
    }
    e.mesh_face(&mut draft.builder, vertices, Some(normals))
}

impl Evaluator<'_> {
    /// Triangles one by one, after `mesh {`.
    pub(super) fn mesh(&mut self, span: Span) -> SourceResult<Shape> {
        let mut draft = Draft::default();
        self.comma()?;
        self.items_of(&MESH, &mut draft)?;
        let Draft { builder, zero_normals, inside } = draft;
        if zero_normals {
            self.warn(Topic::Geometry, span, ZERO_NORMALS);
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

    /// Whether the next token opens a vector.
    pub(super) fn at_vector(&mut self) -> SourceResult<bool> {
        Ok(matches!(self.peek()?.kind, TokenKind::Vector | TokenKind::Vectors | TokenKind::Punct('<')))
    }
}

/// The unit normal, and whether it was zero and replaced by x.
pub(super) fn unit_normal(n: DVec3) -> (DVec3, bool) {
    if n.abs().max_element() < POV_ZERO_NORMAL { (DVec3::X, true) } else { (n.normalize_or(DVec3::X), false) }
}

pub(super) fn inside_vector(v: DVec3) -> Option<DVec3> {
    (v.abs().max_element() >= POV_ZERO_NORMAL).then(|| v.normalize_or(DVec3::X))
}
