//! The boxes that `min_extent` and `max_extent` tell: POV-Ray's, loose where its are loose.
//!
//! Scenes place things by these numbers, so they have to be the same. Rays never meet these boxes:
//! a hierarchy has tight ones of its own. Source: shape facts, section 9.

use super::compile_object;
use super::implicit::container;
use super::primitive::fold;
use super::text::glyph_boxes;
use crate::compiled::geometry::Shape as Compiled;
use crate::math::{Bounds, DVec2, DVec3, Transform};
use crate::scene::{Blob, CsgOperation, Object, Shape, SweepSpline};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// A box longer than this counts as infinite.
const LONGEST: f64 = 1e6;

/// Half the thickness of a disc, and the room around a flat polygon.
const FLAT: f64 = 0.001;

/// Half the size of a superellipsoid.
const SUPERELLIPSOID: f64 = 1.0001;

/// The box of an object in the space around it.
pub(crate) fn extent(object: &Object) -> Bounds {
    extent_with(object, &mut Known::new(single))
}

/// Boxes of objects that many others may refer to, by address, and how boxes are kept.
struct Known {
    extents: FxHashMap<*const Object, Bounds>,
    kept: fn(&Bounds) -> Bounds,
}

impl Known {
    fn new(kept: fn(&Bounds) -> Bounds) -> Self {
        Self { extents: FxHashMap::default(), kept }
    }

    fn kept(&self, bounds: &Bounds) -> Bounds {
        (self.kept)(bounds)
    }
}

fn shared_extent(object: &Arc<Object>, known: &mut Known) -> Bounds {
    if let Some(extent) = known.extents.get(&Arc::as_ptr(object)) {
        return *extent;
    }
    let extent = roomy(|| extent_with(object, known));
    known.extents.insert(Arc::as_ptr(object), extent);
    extent
}

fn extent_with(object: &Object, known: &mut Known) -> Bounds {
    let own = match &object.shape {
        Shape::Csg { operation, children } => moved(&combined(*operation, children, known), &object.place.transform()),
        Shape::LightGroup { children, .. } => {
            children.iter().fold(Bounds::EMPTY, |sum, child| sum.union(&shared_extent(child, known)))
        }
        shape => leaf(shape, &object.place.transform(), object, known),
    };
    let own = known.kept(&own);
    [&object.rare.bounded_by, &object.rare.clipped_by].into_iter().fold(own, |own, limits| {
        let limits = limits.iter().filter(|o| !o.flags.inverse);
        let common = limits.fold(Bounds::INFINITE, |sum, o| sum.intersection(&as_limit(o, false, known)));
        if volume(&common) < volume(&own) { known.kept(&common) } else { own }
    })
}

/// The box to which `bounded_by` cuts down that of a primitive, if it does: rays that miss it miss the
/// primitive, whatever reaches out of it.
pub(super) fn shrunken(object: &Object) -> Option<Bounds> {
    if object.rare.bounded_by.is_empty() || matches!(object.shape, Shape::Csg { .. }) {
        return None;
    }
    let limits = object.rare.bounded_by.iter().filter(|o| !o.flags.inverse);
    // As exact as any shape: far from the origin a box in single precision may be beside what it bounds.
    let known = &mut Known::new(|bounds| *bounds);
    let common = limits.fold(Bounds::INFINITE, |sum, o| sum.intersection(&as_limit(o, false, known)));
    let own = leaf(&object.shape, &object.place.transform(), object, known);
    (volume(&common) < volume(&own)).then_some(common)
}

/// As POV-Ray stores it: a corner and lengths, in single precision.
fn single(b: &Bounds) -> Bounds {
    let size = b.size();
    if !b.is_finite() || size.max_element() > LONGEST {
        return Bounds::INFINITE;
    }
    let corner = b.min.as_vec3();
    Bounds { min: corner.as_dvec3(), max: (corner + size.as_vec3()).as_dvec3() }
}

fn volume(b: &Bounds) -> f64 {
    if b.is_finite() { b.size().element_product() } else { f64::INFINITY }
}

/// Around the moved corners; a box that is turned inside out stays so where nothing moves it.
fn moved(local: &Bounds, place: &Transform) -> Bounds {
    if place.is_identity() { *local } else { place.bounds(local) }
}

fn combined(operation: CsgOperation, children: &[Arc<Object>], known: &mut Known) -> Bounds {
    let common = match operation {
        CsgOperation::Union | CsgOperation::Merge => {
            children.iter().fold(Bounds::EMPTY, |sum, child| sum.union(&shared_extent(child, known)))
        }
        CsgOperation::Intersection | CsgOperation::Difference => {
            let cut = |i: usize| operation == CsgOperation::Difference && i > 0;
            // A height field is solid below its box, but only where it is a child itself does POV-Ray think of that.
            let bounded = children.iter().enumerate().filter(|(_, c)| !matches!(c.shape, Shape::HeightField(_)));
            let limits = bounded.map(|(i, child)| as_limit(child, cut(i), known));
            limits.fold(Bounds::INFINITE, |sum, b| sum.intersection(&b))
        }
    };
    if common.is_empty() { Bounds::INFINITE } else { known.kept(&common) }
}

/// What an object leaves of an intersection's box: its own, or half of space for a plane along the
/// axes. Nothing is known of what is inverted; a plane absorbs that.
fn as_limit(object: &Arc<Object>, cut: bool, known: &mut Known) -> Bounds {
    let mut inverse = object.flags.inverse != cut;
    if matches!(object.shape, Shape::Plane { .. }) && object.rare.clipped_by.is_empty() {
        let folded = fold(&object.shape, object.place.transform(), &mut inverse);
        let Some(Compiled::Plane(plane)) = folded.map(|f| f.shape) else { return Bounds::INFINITE };
        return half_space(plane.normal, plane.distance);
    }
    if inverse { Bounds::INFINITE } else { shared_extent(object, known) }
}

fn half_space(normal: DVec3, distance: f64) -> Bounds {
    let mut b = Bounds::INFINITE;
    for axis in 0..3 {
        if normal.abs() == DVec3::AXES[axis] {
            let side = if normal[axis] > 0.0 { &mut b.max } else { &mut b.min };
            side[axis] = distance * normal[axis];
        }
    }
    b
}

/// A primitive's box.
fn leaf(shape: &Shape, place: &Transform, object: &Object, known: &mut Known) -> Bounds {
    match shape {
        Shape::Plane { .. } | Shape::Polynomial { .. } | Shape::LightSource(_) => Bounds::INFINITE,
        Shape::LightGroup { children, .. } => {
            children.iter().fold(Bounds::EMPTY, |sum, child| sum.union(&extent(child)))
        }
        Shape::Sphere { center, radius } if place.is_identity() => {
            Bounds { min: *center - *radius, max: *center + *radius }
        }
        Shape::Disc { radius, .. } => compiled(object, |_| {
            Some(Bounds { min: DVec3::new(-radius, -radius, -FLAT), max: DVec3::new(*radius, *radius, FLAT) })
        }),
        Shape::Superellipsoid { .. } => {
            moved(&Bounds::from_corners(DVec3::splat(-SUPERELLIPSOID), DVec3::splat(SUPERELLIPSOID)), place)
        }
        Shape::Polygon { points } => moved(&thickened(Bounds::around(points.iter().copied())), place),
        Shape::Triangle { vertices } => Bounds::around(vertices.map(|v| place.point(v))),
        Shape::SmoothTriangle(smooth) => Bounds::around(smooth.vertices.map(|v| place.point(v))),
        Shape::Mesh(mesh) => {
            moved(&Bounds::around(mesh.vertices.iter().map(|v| glam::Vec3::from(*v).as_dvec3())), place)
        }
        Shape::BicubicPatch(patch) => Bounds::around(patch.points.iter().flatten().map(|p| place.point(*p))),
        Shape::Blob(blob) => moved(&blob_box(blob), place),
        Shape::SphereSweep { spline, spheres, .. } => moved(&sweep_box(*spline, spheres), place),
        Shape::Prism(prism) if prism.spline == SweepSpline::Bezier => {
            let [low, high] = prism.heights;
            let ends = prism.points.iter().flat_map(|p| {
                [low, high].map(|h| {
                    let scale = if prism.conic { h } else { 1.0 };
                    DVec3::new(p.x * scale, h, p.y * scale)
                })
            });
            moved(&Bounds::around(ends), place)
        }
        Shape::Lathe { spline: SweepSpline::Bezier, points, .. } => moved(&lathe_box(points), place),
        Shape::Text(text) => {
            let glyphs = glyph_boxes(text).unwrap_or_default();
            let line = glyphs.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b));
            if line.is_empty() { Bounds::INFINITE } else { moved(&known.kept(&line), place) }
        }
        Shape::Isosurface(surface) => moved(&container(surface.container).bounds(), place),
        Shape::Parametric(surface) => moved(&container(surface.container).bounds(), place),
        Shape::Quadric { .. } if !keeps_directions(place) => Bounds::INFINITE,
        _ => compiled(object, |_| None),
    }
}

/// Whether axes stay along axes.
fn keeps_directions(place: &Transform) -> bool {
    let m = place.linear();
    [m.x_axis, m.y_axis, m.z_axis].iter().all(|v| v.abs().element_sum() == v.abs().max_element())
}

/// From the compiled shape's own box, or another one, moved with it.
fn compiled(object: &Object, other: impl Fn(&Compiled) -> Option<Bounds>) -> Bounds {
    let bare = Object { place: object.place.clone(), ..Object::new(object.shape.clone(), object.span) };
    let Ok(geometry) = compile_object(&Arc::new(bare)) else { return Bounds::INFINITE };
    let Some(primitive) = geometry.primitives.iter().next() else { return Bounds::EMPTY };
    let local = other(&primitive.shape).unwrap_or_else(|| primitive.local_bounds());
    primitive.group_from_local.as_ref().map_or(local, |place| moved(&local, place))
}

/// A flat side gets room on both sides.
fn thickened(b: Bounds) -> Bounds {
    let room = DVec3::from(b.size().to_array().map(|side| if side < FLAT { FLAT } else { 0.0 }));
    Bounds { min: b.min - room, max: b.max + room }
}

/// Around the components that add to the field; a cylinder's tube is a cube with all its length
/// around it, as wide as its longest side once it is moved.
fn blob_box(blob: &Blob) -> Bounds {
    let cube = |center: DVec3, half: f64| Bounds { min: center - half, max: center + half };
    let mut sum = Bounds::EMPTY;
    for part in blob.components.iter().filter(|part| part.strength > 0.0) {
        let [a, b] = part.ends;
        let mut add = |center: DVec3, half: f64| {
            let plain = part.transform.is_identity() && !part.is_cylinder;
            let size = moved(&cube(DVec3::ZERO, half), &part.transform).max - part.transform.origin();
            let half = if plain { half } else { size.max_element() };
            sum = sum.union(&cube(part.transform.point(center), half));
        };
        add(a, part.radius);
        if part.is_cylinder {
            add(b, part.radius);
            add(0.5 * (a + b), part.radius.hypot(0.5 * a.distance(b)));
        }
    }
    sum
}

/// Around the control spheres; twice as far for curves that overshoot.
fn sweep_box(spline: SweepSpline, spheres: &[(DVec3, f64)]) -> Bounds {
    let factor = if spline == SweepSpline::Cubic { 2.0 } else { 1.0 };
    spheres.iter().fold(Bounds::EMPTY, |sum, (center, radius)| {
        sum.union(&Bounds { min: *center - radius * factor, max: *center + radius * factor })
    })
}

/// Around the control points, turned about y.
fn lathe_box(points: &[DVec2]) -> Bounds {
    let widest = points.iter().map(|p| p.x.abs()).fold(0.0, f64::max);
    let around = points.iter().flat_map(|p| [DVec3::new(-widest, p.y, -widest), DVec3::new(widest, p.y, widest)]);
    Bounds::around(around)
}

#[cfg(test)]
mod tests {
    use crate::compile::Queries;
    use crate::eval::{Memory, Options, evaluate};

    /// What POV-Ray 3.7.0.10 prints for the extents of an object; to 6 digits, for its chains of
    /// single-precision boxes.
    fn check(object: &str, min: [f64; 3], max: [f64; 3]) {
        let text = format!(
            "#version 3.7; #declare O = {object} #debug vstr(3, min_extent(O), \" \", 0, 12) #debug \" \"
            #debug vstr(3, max_extent(O), \" \", 0, 12)"
        );
        let host = Memory::new([("a.pov", text.as_str())]);
        assert!(evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).is_ok(), "{text}");
        let messages = host.messages();
        let numbers: Vec<f64> = messages.split(' ').map(|n| n.parse().unwrap()).collect();
        for (found, expected) in numbers.iter().zip(min.iter().chain(&max)) {
            assert!((found - expected).abs() <= 1e-6 * expected.abs().max(1.0), "{object}: {messages}");
        }
    }

    #[test]
    fn primitives_have_povrays_boxes() {
        let all = [1e10; 3];
        check("plane { y, 1 }", all.map(|v| -v), all);
        check("sphere { 0, -1 }", [1.0; 3], [-1.0; 3]);
        check("sphere { 0, 1 scale <1, 2, 1> rotate 90 * z }", [-2.0, -1.0, -1.0], [2.0, 1.0, 1.0]);
        check(
            "torus { 1, .25 rotate 30 * x translate x }",
            [-0.25, -0.841506362, -1.207531810],
            [2.25, 0.841506362, 1.207531810],
        );
        check("cylinder { 0, <3, 4, 0>, 1 }", [-1.12, -0.839999974, -1.4], [4.119999886, 4.839999676, 1.4]);
        check("superellipsoid { <.5, .5> scale 2 }", [-2.0002; 3], [2.0002; 3]);
        let disc = [2.000707150, 2.000707150, 2.828427076];
        check("disc { 0, <1, 1, 0>, 2, 1 }", disc.map(|v| -v), disc);
        let quadric = [-1.618034005, -0.790569425, -0.645497203];
        check("quadric { <1, 2, 3>, 0, <1, 0, 0>, -1 }", quadric, [0.618034005, 0.790569425, 0.645497203]);
        check("polygon { 5, 0, x, x + y, y, 0 rotate 30 * z }", [-0.5, 0.0, -0.001], [0.866025448, 1.366025448, 0.001]);
        check(
            "mesh { triangle { 0, x, y + z } rotate 45 * z }",
            [-0.707106769, 0.0, 0.0],
            [0.707106769, 1.414213538, 1.0],
        );
    }

    #[test]
    fn freeform_shapes_have_povrays_boxes() {
        check(
            "sor { 6, <1, -1>, <1, 0>, <2, .5>, <2, 1>, <1, 2>, <1, 3> }",
            [-2.102558851, 0.0, -2.102558851],
            [2.102558851, 2.0, 2.102558851],
        );
        check(
            "sphere_sweep { cubic_spline 4, <0, 0, 0>, 1, <1, 0, 0>, .5, <2, 1, 0>, .5, <3, 0, 0>, 1 }",
            [-2.0; 3],
            [5.0, 2.0, 2.0],
        );
        check(
            "blob { threshold .5 sphere { 0, 1, 1 scale <1, 1, 2> translate x } sphere { y, 1, -1 } }",
            [-1.0, -2.0, -2.0],
            [3.0, 2.0, 2.0],
        );
        check(
            "blob { cylinder { 0, 2 * y, 1, 1 } }",
            [-1.414213538, -1.0, -1.414213538],
            [1.414213538, 3.0, 1.414213538],
        );
        check(
            "height_field { function 5, 5 { x * .5 } water_level .2 scale 2 }",
            [0.0, 0.399999976, 0.0],
            [2.0, 0.999969542, 2.0],
        );
    }

    #[test]
    fn solids_have_povrays_boxes() {
        let all = [1e10; 3];
        check("intersection { box { -1, 1 } sphere { x, 1 } }", [0.0, -1.0, -1.0], [1.0; 3]);
        check("difference { box { -1, 1 } sphere { x, 1 } }", [-1.0; 3], [1.0; 3]);
        check("intersection { sphere { 0, 1 } plane { y, .5 } }", [-1.0; 3], [1.0, 0.5, 1.0]);
        check("intersection { box { -1, 0 } box { 1, 2 } }", all.map(|v| -v), all);
        check("union { sphere { 0, 1 } plane { y, 0 } }", all.map(|v| -v), all);
        check("merge { sphere { 0, 1 } sphere { x, 1 } }", [-1.0; 3], [2.0, 1.0, 1.0]);
        check("sphere { 0, 1 bounded_by { box { -.5, .5 } } }", [-0.5; 3], [0.5; 3]);
        check("sphere { 0, 1 clipped_by { box { -.5, 2 } } }", [-1.0; 3], [1.0; 3]);
        check("plane { y, 0 clipped_by { box { -1, 1 } } }", [-1.0; 3], [1.0; 3]);
        let field = "height_field { function 5, 5 { x * .5 } water_level .2 scale 2 }";
        let (low, high) = ([0.0, 0.399999976, 0.0], [2.0, 0.999969542, 2.0]);
        check(&format!("intersection {{ {field} box {{ -1, 1 }} }}"), [-1.0; 3], [1.0; 3]);
        check(&format!("difference {{ {field} box {{ -1, 1 }} }}"), all.map(|v| -v), all);
        check(&format!("difference {{ union {{ object {{ {field} }} }} box {{ -1, 1 }} }}"), low, high);
        check(&format!("box {{ -9, 9 clipped_by {{ {field} }} }}"), low, high);
    }
}
