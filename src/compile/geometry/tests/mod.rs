//! Shapes against probe values (docs/povray), and against properties that hold of every shape.

mod analytic;
mod font;
mod freeform;
mod implicit;
mod properties;
mod written;

use super::compile_object;
use crate::compile::Queries;
use crate::compiled::geometry::{RayKind, Scratch};
use crate::diag::Span;
use crate::eval::{Host, Memory, Options, evaluate};
use crate::math::{DVec3, Range, Ray, Transform};
use crate::scene::{CsgOperation, Object, Shape};
use std::sync::Arc;

/// Shorthand for a point.
fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// A bare object.
fn object(shape: Shape) -> Object {
    Object::new(shape, Span::default())
}

/// An object moved.
fn moved(mut o: Object, t: &Transform) -> Object {
    o.apply(t);
    o
}

/// A CSG object.
fn csg(operation: CsgOperation, children: impl IntoIterator<Item = Object>) -> Object {
    object(Shape::Csg { operation, children: children.into_iter().map(Arc::new).collect() })
}

fn sphere(center: DVec3, radius: f64) -> Object {
    object(Shape::Sphere { center, radius })
}

fn cuboid(corner1: DVec3, corner2: DVec3) -> Object {
    object(Shape::Box { corner1, corner2 })
}

/// What a ray finds: the hit point and the raw normal.
fn trace(o: &Object, origin: DVec3, direction: DVec3) -> Option<(DVec3, DVec3)> {
    let geometry = compile_object(&Arc::new(o.clone())).unwrap();
    let ray = Ray::new(origin, direction.normalize());
    let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Refracted, &mut Scratch::default())?;
    let surface = geometry.surface(&ray, &hit);
    Some((surface.point, surface.normal))
}

/// Traces and compares the hit point and, where given, the normal, to the digits POV-Ray prints.
fn check(o: &Object, origin: DVec3, direction: DVec3, expected: Option<(DVec3, Option<DVec3>)>) {
    let found = trace(o, origin, direction);
    let close = |a: DVec3, b: DVec3| (a - b).abs().max_element() < 2e-9 * b.abs().max_element().max(1.0);
    let agrees = match (found, expected) {
        (Some((p, n)), Some((point, normal))) => close(p, point) && normal.is_none_or(|m| close(n, m)),
        (None, None) => true,
        _ => false,
    };
    assert!(agrees, "{found:?}, expected {expected:?}");
}

/// Whether a point is inside.
fn inside(o: &Object, point: DVec3) -> bool {
    compile_object(&Arc::new(o.clone())).unwrap().contains(point)
}

/// A scene, and a font of two letters, `oA.ttf`.
fn host(scene: &str) -> Memory {
    let host = Memory::new([("a.pov", scene)]);
    let made = host.append("oA.ttf".as_ref(), &font::font());
    assert!(made.is_ok());
    host
}

/// The last object of a scene in POV-Ray's language.
fn written(text: &str) -> Object {
    let text = format!("#version 3.7; {text}");
    let host = host(&text);
    let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default());
    let read = read.unwrap_or_else(|failed| panic!("{:?}\n{text}", failed.diagnostics));
    read.scene.objects.last().cloned().unwrap_or_else(|| panic!("no object: {text}"))
}
