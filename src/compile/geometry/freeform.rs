//! Shapes that are converted rather than folded: large data, shared by all copies.

use super::builder::Builder;
use super::height_field::{grid_key, height_grid};
use super::implicit;
use super::inherit::Context;
use super::primitive::Folded;
use super::sweep;
use crate::compile::texture::Refusal;
use crate::compiled::geometry::{Blob, BlobPart, Core, HeightField, Mesh, MeshData, MeshTree, Shape as Compiled};
use crate::diag::Diagnostic;
use crate::math::{Bounds, DVec3, Transform};
use crate::scene::{self, BicubicPatch, Object, Shape};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Converts a freeform shape: `None` if it is not one, `Some(None)` if nothing of it shows or
/// there was a message.
pub(super) fn convert(builder: &mut Builder<'_>, object: &Object, inside: &Context) -> Option<Option<Folded>> {
    match &object.shape {
        Shape::Mesh(mesh) => Some(Some(convert_mesh(builder, mesh, inside))),
        Shape::HeightField(field) => Some(convert_height_field(builder, field, object, inside)),
        Shape::Blob(blob) => Some(Some(convert_blob(builder, blob, inside))),
        Shape::BicubicPatch(patch) => Some(Some(convert_patch(patch, inside))),
        Shape::Prism(prism) => Some(sweep::prism(prism).map(|shape| placed(shape, inside.group_from_parent))),
        Shape::Lathe { spline, points, .. } => {
            Some(Some(placed(sweep::lathe(*spline, points), inside.group_from_parent)))
        }
        Shape::Sor { points, open, .. } => Some(Some(placed(sweep::sor(points, *open), inside.group_from_parent))),
        Shape::Text(text) => match super::text::text(text) {
            Ok((shape, upright)) => Some(Some(placed(shape, upright.then(&inside.group_from_parent)))),
            Err(message) => {
                builder.errors.push(Diagnostic::error(object.span, message));
                Some(None)
            }
        },
        Shape::SphereSweep { spline, spheres, tolerance } => {
            Some(Some(placed(sweep::sphere_sweep(*spline, spheres, *tolerance), inside.group_from_parent)))
        }
        Shape::Isosurface(surface) => {
            let shape = implicit::isosurface(builder, surface, object.span);
            Some(of_functions(builder, shape, object, inside))
        }
        Shape::Parametric(surface) => {
            let shape = implicit::parametric(builder, surface);
            Some(of_functions(builder, shape, object, inside))
        }
        Shape::JuliaFractal(julia) => Some(Some(placed(implicit::julia(julia), inside.group_from_parent))),
        Shape::Cylinder { base, cap, .. } | Shape::Cone { base, cap, .. } if base == cap => {
            let message = "degenerate cylinder or cone: both ends are the same point";
            builder.errors.push(Diagnostic::error(object.span, message));
            Some(None)
        }
        _ => None,
    }
}

/// A shape with its transform left as it is.
fn placed(shape: Compiled, place: Transform) -> Folded {
    Folded { shape, group_from_local: (!place.is_identity()).then_some(place), uv_from_group: None }
}

/// A shape made of functions, where all of them can be called.
fn of_functions(
    builder: &mut Builder<'_>,
    shape: Result<Compiled, Refusal>,
    object: &Object,
    inside: &Context,
) -> Option<Folded> {
    let shape = shape.map_err(|refusal| builder.errors.push(refusal.at(object.span).diagnostic()));
    Some(placed(shape.ok()?, inside.group_from_parent))
}

/// A height field, whose grid all that are made alike share.
fn convert_height_field(
    builder: &mut Builder<'_>,
    field: &Arc<scene::HeightField>,
    object: &Object,
    inside: &Context,
) -> Option<Folded> {
    let key = grid_key(field);
    let grid = match builder.height_grids.get(&key) {
        Some(grid) => Arc::clone(grid),
        None => match height_grid(field, builder.functions) {
            Ok(grid) => {
                let grid = Arc::new(grid?);
                builder.height_grids.insert(key, Arc::clone(&grid));
                grid
            }
            Err(refusal) => {
                builder.errors.push(refusal.at(object.span).diagnostic());
                return None;
            }
        },
    };
    let unit = DVec3::new(1.0 / (grid.width - 1) as f64, 1.0 / 65536.0, 1.0 / (grid.depth - 1) as f64);
    let place = Transform::scaling(unit).then(&inside.group_from_parent);
    Some(placed(Compiled::HeightField(HeightField { grid, group_from_grid: Box::new(place) }), place))
}

/// A blob; cylinders come apart into a tube and two half balls.
fn convert_blob(builder: &mut Builder<'_>, blob: &scene::Blob, inside: &Context) -> Folded {
    let mut parts = Vec::new();
    for component in &blob.components {
        let texture = component.texture.as_ref().map(|t| (builder.texture(&t.texture), t.place.transform().inverse()));
        let mut add = |core: Core, place: &Transform| {
            parts.push(BlobPart {
                core,
                radius: component.radius,
                strength: component.strength,
                blob_from_part: place.then(&component.transform),
                texture,
            });
        };
        let [a, b] = component.ends;
        let length = a.distance(b);
        if component.is_cylinder && length > 0.0 {
            let axis = (b - a) / length;
            let (x, y) = axis.any_orthonormal_pair();
            let Ok(place) = Transform::from_columns(x, y, axis, a) else { continue };
            for core in [Core::Axis(length), Core::Start, Core::End(length)] {
                add(core, &place);
            }
        } else {
            add(Core::Point, &Transform::translation(a));
        }
    }
    let mut parts = merged(parts);
    parts.retain(|p| p.radius != 0.0 && p.strength != 0.0);
    placed(Compiled::Blob(Blob::new(parts.into(), blob.threshold)), inside.group_from_parent)
}

/// Parts with one in each place, whose strengths are exact where large ones cancel: in the field their rounding would
/// outweigh what is left. Parts with textures stay, because the strength of each decides how much of it shows.
fn merged(mut parts: Vec<BlobPart>) -> Vec<BlobPart> {
    if parts.iter().all(|p| p.strength >= 0.0) {
        return parts;
    }
    let mut strengths: FxHashMap<[u64; 15], (usize, Vec<f64>)> = FxHashMap::default();
    for (i, part) in parts.iter_mut().enumerate().filter(|(_, part)| part.texture.is_none()) {
        let (core, length) = match part.core {
            Core::Point => (0, 0.0),
            Core::Axis(length) => (1, length),
            Core::Start => (2, 0.0),
            Core::End(length) => (3, length),
        };
        let place = &part.blob_from_part;
        let columns = place.linear().to_cols_array().into_iter().chain(place.origin().to_array());
        let mut numbers = [part.radius, length].into_iter().chain(columns).map(f64::to_bits);
        let key = std::array::from_fn(|k| if k == 0 { core } else { numbers.next().unwrap_or_default() });
        let (_, of_place) = strengths.entry(key).or_insert_with(|| (i, Vec::new()));
        of_place.push(std::mem::take(&mut part.strength));
    }
    #[allow(clippy::iter_over_hash_type)] // each entry concerns a part of its own
    for (first, mut of_place) in strengths.into_values() {
        // What cancels comes together, before anything smaller is added.
        of_place.sort_unstable_by(|a, b| b.abs().total_cmp(&a.abs()));
        parts[first].strength = of_place.iter().sum();
    }
    parts
}

/// A patch as triangles, moved first: its flatness is measured in the world.
///
/// A patch far away stays by the origin, and rays are moved.
fn convert_patch(patch: &BicubicPatch, inside: &Context) -> Folded {
    /// How many times as far away as it is large a patch counts as far: its corners, in single precision, would lose more
    /// than a third of their digits.
    const FAR: f64 = 256.0;
    /// Parts of a patch that flatness has to tell apart.
    const FEWEST_PARTS: f64 = 64.0;
    let place = &inside.group_from_parent;
    let points = patch.points.map(|row| row.map(|p| place.point(p)));
    let b = Bounds::around(points.iter().flatten().copied());
    let far = b.min.abs().max(b.max.abs()).max_element() > FAR * b.size().max_element();
    let origin = if far { points[0][0] } else { DVec3::ZERO };
    let points = if far { points.map(|row| row.map(|p| p - origin)) } else { points };
    // Of a patch that has been made so small that the flatness is a good part of it, that is made smaller, too.
    let m = place.linear();
    let stretch = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length).into_iter().fold(0.0, f64::max);
    let coarse = stretch < 1.0 && patch.flatness * FEWEST_PARTS > b.size().max_element();
    let flatness = if coarse { patch.flatness * stretch } else { patch.flatness };
    let tree = Arc::new(MeshTree::new(super::patch::tessellate(patch, flatness, &points)));
    placed(Compiled::Mesh(Mesh { tree, inside_vector: None }), Transform::translation(origin))
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
