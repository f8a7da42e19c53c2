//! Shapes that are converted rather than folded: large data, shared by all copies.

use super::builder::Builder;
use super::looks::Context;
use super::primitive::Folded;
use crate::compiled::geometry::{Mesh, MeshData, MeshTree, Shape as Compiled};
use crate::diag::Diagnostic;
use crate::scene::{self, Object, Shape};
use std::sync::Arc;

/// Converts a freeform shape: `None` if it is not one, `Some(None)` if nothing of it shows or
/// there was a message.
pub(super) fn convert(builder: &mut Builder<'_>, object: &Object, inside: &Context) -> Option<Option<Folded>> {
    let unsupported = match &object.shape {
        Shape::Mesh(mesh) => return Some(Some(convert_mesh(builder, mesh, inside))),
        Shape::HeightField(_) => "height_field",
        Shape::Blob(_) => "blob",
        Shape::BicubicPatch(_) => "bicubic_patch",
        Shape::Prism(_) => "prism",
        Shape::Lathe { .. } => "lathe",
        Shape::Sor { .. } => "sor",
        Shape::SphereSweep { .. } => "sphere_sweep",
        Shape::Text(_) => "text",
        Shape::Isosurface(_) => "isosurface",
        Shape::Parametric(_) => "parametric",
        Shape::JuliaFractal(_) => "julia_fractal",
        Shape::Cylinder { base, cap, .. } | Shape::Cone { base, cap, .. } if base.distance(*cap) < 1e-10 => {
            let message = "degenerate cylinder or cone: both ends are the same point";
            builder.errors.push(Diagnostic::error(object.span, message));
            return Some(None);
        }
        _ => return None,
    };
    builder.errors.push(Diagnostic::error(object.span, format!("`{unsupported}` is not supported yet")));
    Some(None)
}

/// A mesh, whose hierarchy all its copies share.
fn convert_mesh(builder: &mut Builder<'_>, mesh: &Arc<scene::Mesh>, inside: &Context) -> Folded {
    let tree = match builder.meshes.get(&Arc::as_ptr(mesh)) {
        Some(tree) => Arc::clone(tree),
        None => {
            let textures = mesh.textures.iter().map(|t| builder.texture(t)).collect();
            let same = mesh.normal_indices == mesh.faces;
            let tree = Arc::new(MeshTree::new(MeshData {
                vertices: mesh.vertices.clone(),
                faces: mesh.faces.clone(),
                normals: mesh.normals.clone(),
                normal_indices: (!same).then(|| mesh.normal_indices.clone()),
                uvs: mesh.uvs.clone(),
                uv_indices: mesh.uv_indices.clone(),
                textures,
                face_textures: mesh.face_textures.clone(),
            }));
            builder.meshes.insert(Arc::as_ptr(mesh), Arc::clone(&tree));
            tree
        }
    };
    let place = inside.group_from_parent;
    // POV-Ray takes the vector in world space; a shared group stands for the world here.
    let inside_vector = mesh.inside_vector.map(|v| place.inverse_vector(v));
    Folded {
        shape: Compiled::Mesh(Mesh { tree, inside_vector }),
        group_from_local: (!place.is_identity()).then_some(place),
        uv_from_group: None,
    }
}
