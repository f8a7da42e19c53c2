//! Pass 4, `fold_transforms`: shapes become canonical primitives, with their transform folded in
//! where that loses nothing.

use super::POV_TINY;
use crate::compiled::geometry::{
    Cone, Cuboid, Disc, Ovus, Plane, Polygon, Polynomial, Quadric, Shape as Compiled, SmoothTriangle, Sphere,
    Superellipsoid, Torus, Triangle,
};
use crate::math::{DVec3, MAX_DEGREE, Transform, gamma, unit};
use crate::scene::Shape;
use std::sync::Arc;

/// A primitive and what is left of its transform.
pub(super) struct Folded {
    pub(super) shape: Compiled,
    pub(super) group_from_local: Option<Transform>,
    pub(super) uv_from_group: Option<Transform>,
}

impl Folded {
    /// Nothing left to do for a ray.
    fn whole(shape: Compiled) -> Option<Self> {
        Some(Self { shape, group_from_local: None, uv_from_group: None })
    }

    /// Rays go through `place` first.
    fn placed(shape: Compiled, place: Transform) -> Option<Self> {
        let group_from_local = (!place.is_identity()).then_some(place);
        Some(Self { shape, group_from_local, uv_from_group: None })
    }
}

/// Folds `place` into a quadric-like or flat shape; `None` if nothing of it can be seen.
///
/// `inverse` is taken away where the shape itself absorbs it.
pub(super) fn fold(shape: &Shape, place: Transform, inverse: &mut bool) -> Option<Folded> {
    match shape {
        Shape::Sphere { center, radius } => fold_sphere(*center, *radius, place),
        Shape::Box { corner1, corner2 } => {
            let (min, max) = (corner1.min(*corner2), corner1.max(*corner2));
            if keeps_axes(&place) {
                let (min, max) = (place.point(min), place.point(max));
                return Folded::whole(Compiled::Cuboid(Cuboid { min, max }));
            }
            Folded::placed(Compiled::Cuboid(Cuboid { min, max }), place)
        }
        Shape::Plane { normal, distance } => {
            let mut plane = fold_plane(*normal, *distance, &place)?;
            if std::mem::take(inverse) {
                plane = Plane { normal: -plane.normal, distance: -plane.distance };
            }
            Folded::whole(Compiled::Plane(plane))
        }
        Shape::Disc { center, normal, radius, hole_radius } => {
            let frame = frame(normal.try_normalize()?, 1.0, 1.0, *center)?;
            let disc = Disc { hole_squared: hole_radius * hole_radius, radius_squared: radius * radius };
            Folded::placed(Compiled::Disc(disc), frame.then(&place))
        }
        Shape::Cylinder { base, cap, radius, open } => {
            fold_cone((*base, radius.abs()), (*cap, radius.abs()), *open, &place)
        }
        Shape::Cone { base, base_radius, cap, cap_radius, open } => {
            fold_cone((*base, *base_radius), (*cap, *cap_radius), *open, &place)
        }
        Shape::Torus { major, minor, .. } => {
            if *minor <= 0.0 {
                return None;
            }
            if *major == 0.0 {
                return fold_sphere(DVec3::ZERO, *minor, place);
            }
            Folded::placed(Compiled::Torus(Torus { major: *major, minor: *minor }), place)
        }
        Shape::Ovus { bottom_radius, top_radius, .. } => {
            if *top_radius >= 2.0 * bottom_radius {
                return fold_sphere(DVec3::Y * *bottom_radius, *top_radius, place);
            }
            Folded::placed(Compiled::Ovus(Box::new(Ovus::new(*bottom_radius, *top_radius))), place)
        }
        Shape::Quadric { squares, products, linear, constant } => {
            let quadric = Quadric::new(*squares, *products, *linear, *constant, *inverse);
            let empty = [squares, products, linear].iter().all(|v| **v == DVec3::ZERO);
            if empty { None } else { Folded::placed(Compiled::Quadric(Box::new(quadric)), place) }
        }
        Shape::Polynomial { order, coefficients, .. } => {
            let order = *order as usize;
            if order > MAX_DEGREE || coefficients.iter().all(|c| *c == 0.0) {
                return None;
            }
            let coefficients = Arc::clone(coefficients);
            Folded::placed(Compiled::Polynomial(Polynomial { order, coefficients }), place)
        }
        Shape::Superellipsoid { east_west, north_south } => {
            // Zero stands for its limit: a power that is as sharp as any.
            let sharpest = |e: f64| if e == 0.0 { 1e-3 } else { e };
            let (east_west, north_south) = (sharpest(*east_west), sharpest(*north_south));
            Folded::placed(Compiled::Superellipsoid(Superellipsoid { east_west, north_south }), place)
        }
        Shape::Polygon { points } => fold_polygon(points, &place),
        Shape::Triangle { vertices } => {
            let (triangle, _) = fold_triangle(*vertices, [DVec3::ZERO; 3], &place)?;
            Folded::whole(Compiled::Triangle(Box::new(triangle)))
        }
        Shape::SmoothTriangle(smooth) => {
            let (flat, normals) = fold_triangle(smooth.vertices, smooth.normals, &place)?;
            // POV-Ray shows such a triangle only if all corners see the same side.
            let sides = normals.map(|n| n.dot(flat.normal));
            let agree = sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0);
            agree.then_some(())?;
            Folded::whole(Compiled::SmoothTriangle(Box::new(SmoothTriangle { flat, normals })))
        }
        _ => None,
    }
}

/// A sphere stays one under a similarity.
fn fold_sphere(center: DVec3, radius: f64, place: Transform) -> Option<Folded> {
    if radius == 0.0 {
        return None;
    }
    let m = place.linear();
    let squares = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length_squared);
    let slack = gamma(64) * squares[0];
    let similar = (squares[0] - squares[1]).abs() <= slack
        && (squares[0] - squares[2]).abs() <= slack
        && [m.x_axis.dot(m.y_axis), m.y_axis.dot(m.z_axis), m.z_axis.dot(m.x_axis)].iter().all(|d| d.abs() <= slack);
    if !similar {
        return Folded::placed(Compiled::Sphere(Sphere { center, radius }), place);
    }
    // The length of an axis along a coordinate axis is exact, which keeps plain scaling exact.
    let scale = if m.x_axis.y == 0.0 && m.x_axis.z == 0.0 { m.x_axis.x.abs() } else { squares[0].sqrt() };
    let turned = !keeps_axes(&place);
    let sphere = Sphere { center: place.point(center), radius: radius * scale };
    let uv_from_group = turned.then(|| place.inverse().then(&Transform::translation(-center)));
    Some(Folded { shape: Compiled::Sphere(sphere), group_from_local: None, uv_from_group })
}

/// Whether a transform only moves and stretches along the axes, without mirroring.
fn keeps_axes(place: &Transform) -> bool {
    let m = place.linear();
    let aligned = |v: DVec3, axis: usize| (0..3).all(|i| if i == axis { v[i] > 0.0 } else { v[i] == 0.0 });
    aligned(m.x_axis, 0) && aligned(m.y_axis, 1) && aligned(m.z_axis, 2)
}

/// A plane is a plane under every transform.
fn fold_plane(normal: DVec3, distance: f64, place: &Transform) -> Option<Plane> {
    let normal = unit(normal)?;
    if place.is_identity() {
        return Some(Plane { normal, distance });
    }
    let moved = unit(place.normal(normal))?;
    Some(Plane { normal: moved, distance: moved.dot(place.point(normal * distance)) })
}

/// Takes the z axis to `axis * length`, with a circle of `radius` across, from `origin`.
fn frame(axis: DVec3, length: f64, radius: f64, origin: DVec3) -> Option<Transform> {
    // POV-Ray turns z onto the axis about a horizontal line; this is that rotation.
    let (x, y) = if axis.z > -0.999_999 {
        let a = 1.0 / (1.0 + axis.z);
        let b = -axis.x * axis.y * a;
        (DVec3::new(1.0 - axis.x * axis.x * a, b, -axis.x), DVec3::new(b, 1.0 - axis.y * axis.y * a, -axis.y))
    } else {
        let x = axis.any_orthonormal_vector();
        (x, axis.cross(x))
    };
    Transform::from_columns(x * radius, y * radius, axis * length, origin).ok()
}

/// Cylinders and cones, from two ends with radii.
fn fold_cone(base: (DVec3, f64), cap: (DVec3, f64), open: bool, place: &Transform) -> Option<Folded> {
    let ((big, wide), (small, narrow)) = if base.1 < cap.1 { (cap, base) } else { (base, cap) };
    let length = big.distance(small);
    let axis = ((big - small) / length).try_normalize()?;
    // POV-Ray's thresholds for "as good as a cylinder", which are its own where the big radius is 1.
    let difference = (wide - narrow) / wide;
    let straight = difference.abs() < POV_TINY || difference * difference < POV_TINY;
    let (radius, taper, origin, height) = if straight || wide <= 0.0 {
        let radius = if difference.abs() < POV_TINY { base.1.abs() } else { wide.abs() };
        (radius, None, small, length)
    } else {
        let height = wide * length / (wide - narrow);
        (wide, Some(narrow / wide), big - axis * height, height)
    };
    if radius == 0.0 {
        return None;
    }
    // Cylinders count from their cap, cones from their apex.
    let frame = match taper {
        None => frame(((base.0 - cap.0) / length).try_normalize()?, length, radius, cap.0)?,
        Some(_) => frame(axis, height, radius, origin)?,
    };
    Folded::placed(Compiled::Cone(Cone { taper, open }), frame.then(place))
}

/// A polygon in its own plane: outlines close where a point repeats their first.
fn fold_polygon(points: &[DVec3], place: &Transform) -> Option<Folded> {
    let first = *points.first()?;
    // POV-Ray's thresholds, also for points off the plane, which make the whole invisible, but in units of the polygon's
    // reach; room for rounding is added, without which large turned polygons vanish there.
    let reach = points.iter().map(|p| (*p - first).abs().max_element()).fold(0.0, f64::max);
    let edges_from_first = || points.iter().map(|p| (*p - first) / reach);
    let u = edges_from_first().find(|u| u.length_squared() > POV_TINY)?;
    let apart = |v: &DVec3| v.length_squared() > POV_TINY && u.cross(*v).length_squared() > POV_TINY;
    let v = edges_from_first().find(apart)?;
    let normal = u.cross(v).try_normalize()?;
    let x = u.try_normalize()?;
    let frame = Transform::from_columns(x, normal.cross(x), normal, first).ok()?;
    let size = points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let mut edges = Vec::new();
    let mut outline: Vec<DVec3> = Vec::new();
    let mut close = |outline: &mut Vec<DVec3>| {
        for (i, a) in outline.iter().enumerate() {
            let b = outline[(i + 1) % outline.len()];
            edges.push([frame.inverse_point(*a).truncate(), frame.inverse_point(b).truncate()]);
        }
        outline.clear();
    };
    for p in points {
        if (*p - first).dot(normal).abs() > POV_TINY * reach + gamma(64) * size {
            return None;
        }
        match outline.first() {
            Some(start) if (*p - *start).abs().max_element() < POV_TINY * reach => close(&mut outline),
            _ => outline.push(*p),
        }
    }
    close(&mut outline);
    Folded::placed(Compiled::Polygon(Polygon { edges: edges.into() }), frame.then(place))
}

/// Corners and normals in the group's space, with POV-Ray's raw normal.
///
/// POV-Ray exchanges two corners when the normal's largest component points along +x, -y or +z;
/// it notices only when the triangle is moved (shape facts, section 7.1).
fn fold_triangle([a, b, c]: [DVec3; 3], normals: [DVec3; 3], place: &Transform) -> Option<(Triangle, [DVec3; 3])> {
    let [na, nb, nc] = normals.map(DVec3::normalize_or_zero);
    let raw = |[a, b, c]: [DVec3; 3]| (a - b).cross(c - b);
    let normal = raw([a, b, c]);
    if normal == DVec3::ZERO || !normal.is_finite() {
        return None;
    }
    if place.is_identity() {
        return Some((Triangle { vertices: [a, b, c], normal }, [na, nb, nc]));
    }
    let largest = normal.abs().max_position();
    let exchanged = if largest == 1 { normal.y < 0.0 } else { normal[largest] > 0.0 };
    let (vertices, normals) = if exchanged { ([b, a, c], [nb, na, nc]) } else { ([a, b, c], [na, nb, nc]) };
    let vertices = vertices.map(|v| place.point(v));
    let normal = raw(vertices);
    (normal != DVec3::ZERO && normal.is_finite())
        .then(|| (Triangle { vertices, normal }, normals.map(|n| place.normal(n).normalize_or_zero())))
}
