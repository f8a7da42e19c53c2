//! Boxes around what is inside, or outside, of a primitive.

use crate::compiled::geometry::{PLANE_BOUNDARY, Primitive, Shape as Compiled};
use crate::math::{Bounds, DVec3};

/// Around everything outside a finite inverted primitive.
pub(super) fn gap(primitive: &Primitive) -> Bounds {
    let hole = inner(primitive);
    if !primitive.inverse || !hole.is_finite() {
        return Bounds::INFINITE;
    }
    // Inside tests have thresholds of their own; a hundredth is far beyond them and costs little.
    let margin = hole.size() * 0.01;
    Bounds { min: hole.min - margin, max: hole.max + margin }
}

/// Around everything inside a primitive.
pub(super) fn extent(primitive: &Primitive) -> Bounds {
    if primitive.inverse { Bounds::INFINITE } else { inner(primitive) }
}

/// Around everything inside a primitive, were it not inverted.
fn inner(primitive: &Primitive) -> Bounds {
    match &primitive.shape {
        Compiled::Plane(plane) => {
            // A plane along the axes bounds a half space.
            let mut b = Bounds::INFINITE;
            for axis in 0..3 {
                if plane.normal.abs() == DVec3::AXES[axis] {
                    let side = if plane.normal[axis] > 0.0 { &mut b.max } else { &mut b.min };
                    let slack = PLANE_BOUNDARY + plane.distance.abs() * crate::math::gamma(32);
                    side[axis] = plane.distance * plane.normal[axis] + slack * plane.normal[axis];
                }
            }
            b
        }
        Compiled::Disc(_)
        | Compiled::Triangle(_)
        | Compiled::SmoothTriangle(_)
        | Compiled::Polygon(_)
        | Compiled::Parametric(_) => Bounds::INFINITE,
        // A height field is solid below its box, too.
        Compiled::HeightField(_) => below(primitive),
        Compiled::Mesh(mesh) if mesh.inside_vector.is_none() => Bounds::INFINITE,
        _ => primitive.bounds(),
    }
}

/// Around everything at and below a primitive's box along its own y axis; a box only where that axis
/// stays a coordinate axis.
fn below(primitive: &Primitive) -> Bounds {
    let mut b = primitive.bounds();
    let down = primitive.group_from_local.as_ref().map_or(DVec3::NEG_Y, |place| place.vector(DVec3::NEG_Y));
    let axis = down.abs().max_position();
    if down.abs().element_sum() != down[axis].abs() {
        return Bounds::INFINITE;
    }
    if down[axis] < 0.0 {
        b.min[axis] = f64::NEG_INFINITY;
    } else {
        b.max[axis] = f64::INFINITY;
    }
    b
}
