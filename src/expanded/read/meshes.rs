//! Meshes, whose lists are scanned by hand.

use super::reader::{Reader, Value};
use super::scan::Scanner;
use super::shapes::unit_kept;
use super::tree::{Items, Node, Read, Rule, wrong};
use crate::math::{DVec2, DVec3};
use crate::scene::{Mesh, MeshBuilder, Shape, Texture};
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// `mesh`: triangles one by one.
    pub(super) fn mesh(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let mut builder = MeshBuilder::default();
        while let Some(face) = items.optional(Rule::face) {
            self.face(face, &mut builder)?;
        }
        let mut mesh = builder.finish();
        mesh.inside_vector = inside_vector(items)?;
        Ok(Shape::Mesh(Arc::new(mesh)))
    }

    fn face(&mut self, node: Node<'a>, builder: &mut MeshBuilder) -> Read<()> {
        let mut items = Items::of(node);
        let smooth = items.word()? == "smooth_triangle";
        let corners = items.node()?;
        let mut scanner = Scanner::new(&corners);
        let (mut vertices, mut normals) = ([DVec3::ZERO; 3], [[0.0; 3]; 3]);
        for i in 0..3 {
            vertices[i] = DVec3::from(scanner.components::<3>()?);
            scanner.accept(b',');
            if smooth {
                normals[i] = unit_normal(scanner.components()?);
                scanner.accept(b',');
            }
        }
        if !scanner.is_at_end() {
            return scanner.expected("the end of the triangle's corners");
        }
        let uvs = match items.optional(Rule::face_uvs) {
            Some(uvs) => Some(face_uvs(uvs)?),
            None => None,
        };
        let mut textures = None;
        if let Some(names) = items.optional(Rule::face_texture) {
            let three: Vec<Arc<Texture>> =
                names.into_inner().map(|name| self.known_texture(&name)).collect::<Read<_>>()?;
            textures = Some(match &three[..] {
                [a, b, c] => [a.clone(), b.clone(), c.clone()],
                rest => [rest[0].clone(), rest[0].clone(), rest[0].clone()],
            });
        }
        builder.face(vertices, smooth.then_some(normals), uvs, textures);
        Ok(())
    }

    /// The texture that a name stands for.
    pub(super) fn known_texture(&mut self, name: &Node<'_>) -> Read<Arc<Texture>> {
        self.known(name, "texture", |v| if let Value::Texture(t) = v { Some(Arc::clone(t)) } else { None })
    }

    /// `mesh2`: lists of points and of indices.
    pub(super) fn mesh2(&mut self, node: &Node<'a>, items: &mut Items<'a>) -> Read<Shape> {
        let mut mesh = Mesh { is_mesh2: true, ..Mesh::default() };
        let single = |v: [f64; 3]| v.map(|v| v as f32);
        mesh.vertices = list_of(items.node()?)?.list(single)?;
        if let Some(list) = items.optional(Rule::normal_vectors) {
            mesh.normals = list_of(list)?.list(unit_normal)?;
        }
        if let Some(list) = items.optional(Rule::uv_vectors) {
            mesh.uvs = list_of(list)?.list(DVec2::from)?;
        }
        if let Some(list) = items.optional(Rule::texture_list) {
            self.texture_list(list, &mut mesh)?;
        }
        let faces = list_of(items.node()?)?;
        if mesh.textures.is_empty() {
            let mut faces = faces;
            mesh.faces = faces.indices(mesh.vertices.len(), "vertices")?;
        } else {
            textured_faces(faces, &mut mesh)?;
        }
        if mesh.faces.is_empty() {
            return wrong(node, "a mesh2 needs at least one face");
        }
        let n_faces = mesh.faces.len();
        if let Some(list) = items.optional(Rule::uv_indices) {
            mesh.uv_indices = list_of(list)?.indices(mesh.uvs.len(), "uv_vectors")?;
        }
        if let Some(list) = items.optional(Rule::normal_indices) {
            mesh.normal_indices = list_of(list)?.indices(mesh.normals.len(), "normals")?;
        }
        let fits = |n: usize, needed: bool| n == n_faces || (n == 0 && !needed);
        if !fits(mesh.uv_indices.len(), !mesh.uvs.is_empty()) {
            return wrong(node, format!("{} uv_indices do not fit {n_faces} faces", mesh.uv_indices.len()));
        }
        if mesh.normal_indices.len() > n_faces || (mesh.normal_indices.is_empty() && !mesh.normals.is_empty()) {
            return wrong(node, format!("{} normal_indices do not fit {n_faces} faces", mesh.normal_indices.len()));
        }
        mesh.inside_vector = inside_vector(items)?;
        Ok(Shape::Mesh(Arc::new(mesh)))
    }

    fn texture_list(&mut self, node: Node<'a>, mesh: &mut Mesh) -> Read<()> {
        let mut items = Items::of(node.clone());
        let n = items.whole()? as usize;
        for texture in items {
            mesh.textures.push(self.texture(texture)?);
        }
        if mesh.textures.len() != n {
            return wrong(&node, format!("{n} textures are announced, {} are there", mesh.textures.len()));
        }
        Ok(())
    }
}

/// The list in a block.
fn list_of<'a>(node: Node<'a>) -> Read<Scanner<'a>> {
    Ok(Scanner::new(&Items::of(node).node()?))
}

/// Faces with one or three textures, where they have some.
fn textured_faces(mut scanner: Scanner<'_>, mesh: &mut Mesh) -> Read<()> {
    let n = scanner.count()?;
    for _ in 0..n {
        mesh.faces.push(scanner.three_indices(mesh.vertices.len(), "vertices")?);
        let mut textures: Vec<u32> = Vec::new();
        while scanner.accept(b',') && !scanner.is_at_vector() {
            let index = scanner.number()?;
            if !(index >= 0.0 && index < mesh.textures.len() as f64 && textures.len() < 3) {
                return scanner.expected(&format!("one or three textures, numbered 0 to {}", mesh.textures.len() - 1));
            }
            textures.push(index as u32);
        }
        mesh.face_textures.push(match textures[..] {
            [] => None,
            [a] => Some([a; 3]),
            [a, b, c] => Some([a, b, c]),
            _ => return scanner.expected("one or three textures of a face"),
        });
    }
    if scanner.is_at_end() { Ok(()) } else { scanner.expected("the end of the list: it has as many faces as it says") }
}

fn face_uvs(node: Node<'_>) -> Read<[DVec2; 3]> {
    let list = Items::of(node).node()?;
    let mut scanner = Scanner::new(&list);
    let mut corners = [DVec2::ZERO; 3];
    for corner in &mut corners {
        *corner = DVec2::from(scanner.components::<2>()?);
        scanner.accept(b',');
    }
    Ok(corners)
}

/// A normal of length 1, where it is not so already up to the rounding of single precision; x for none.
fn unit_normal(n: [f64; 3]) -> [f32; 3] {
    /// What rounding three components to single precision leaves of a difference to 1, squared.
    const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;
    let n = DVec3::from(n);
    let is_unit = (n.length_squared() - 1.0).abs() <= ROUNDING;
    let unit = if is_unit { n } else { n.normalize_or(DVec3::X) };
    unit.as_vec3().to_array()
}

fn inside_vector(items: &mut Items<'_>) -> Read<Option<DVec3>> {
    match items.optional(Rule::inside_vector) {
        Some(node) => Ok(unit_kept(Items::of(node).vector()?)),
        None => Ok(None),
    }
}
