//! Shapes with flat sides, and solids made of others.

use super::{Case, Field, Random, check, compile_object, length, written};
use crate::compiled::geometry::{Geometry, NodeId, RayKind, Scratch};
use crate::math::{DVec3, Range, Ray};
use std::sync::Arc;

#[test]
fn flat_shapes() {
    let cube: Field = |p| p.abs().max_element() - 1.0;
    check(&Case::solid("box", "box { -1, 1 }").convex().field(cube));
    check(&Case::endless("plane", "plane { y, .2 }").convex().field(|p| p.y - 0.2));
    check(&Case::sheet("disc", "disc { 0, z, 1 }").convex().field(|p| p.z));
    check(&Case::sheet("disc with a hole", "disc { 0, z, 1, .3 }").convex().field(|p| p.z));
    check(
        &Case::sheet("polygon", "polygon { 5, <-1, -1>, <1, -1>, <1.2, 1>, <-1, .9>, <-1, -1> }")
            .convex()
            .field(|p| p.z),
    );
    let frame = "polygon { 10, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <-.4, -.4>, <.4, -.4>, <.4, .4>, <-.4, .4>, <-.4, -.4> }";
    check(&Case::sheet("polygon with a hole", frame).convex().field(|p| p.z));
    let slope: Field = |p| p.z - 0.2 * p.x;
    check(&Case::sheet("triangle", "triangle { <-1, -1, -.2>, <1, -1, .2>, <0, 1, 0> }").convex().field(slope));
    let smooth = "smooth_triangle { <-1, -1, -.2>, <-.3, 0, -1>, <1, -1, .2>, <.3, 0, -1>, <0, 1, 0>, <0, .3, -1> }";
    check(&Case::sheet("smooth_triangle", smooth).convex().field(slope));
}

#[test]
fn constructed_solids() {
    let dice = "box { -1, 1 } sphere { 0, 1.3 }";
    let field: Field = |p| (p.abs().max_element() - 1.0).max(p.length() - 1.3);
    check(&Case::solid("intersection", format!("intersection {{ {dice} }}")).convex().field(field));
    let field: Field =
        |p| (p.abs().max_element() - 1.0).max(p.length() - 1.3).max(0.9 - (p - super::v(0.3, 0.2, 0.1)).length());
    let hollow = format!("difference {{ intersection {{ {dice} }} sphere {{ <.3, .2, .1>, .9 }} }}");
    check(&Case::solid("difference", hollow).field(field));
    let field: Field = |p| (p.with_x(p.x.abs() - 0.5)).length() - 0.8;
    check(&Case::solid("merge", "merge { sphere { .5*x, .8 } sphere { -.5*x, .8 } }").field(field));
    let drilled = "difference { merge { torus { .7, .3 } cylinder { -.4*y, .4*y, .5 } } cone { -y, .4, y, .1 } }";
    let field: Field = |p| {
        let body = (length(length(p.x, p.z) - 0.7, p.y) - 0.3).min((length(p.x, p.z) - 0.5).max(p.y.abs() - 0.4));
        body.max(0.25 - 0.15 * p.y - length(p.x, p.z))
    };
    check(&Case::solid("difference of a merge", drilled).field(field));
    let clipped = "sphere { 0, 1 clipped_by { plane { y, .3 } } }";
    check(&Case::sheet("clipped sphere", clipped).field(|p| p.length() - 1.0));
}

/// Solids of random convex parts, coincident faces among them: stretches and inside tests find the same hits.
#[test]
fn stretches_say_what_inside_tests_say() {
    let mut random = Random(7);
    let (mut n_hits, mut n_solids) = (0, 0);
    for _ in 0..400 {
        let part = |random: &mut Random| {
            let (a, b) = (random.direction(), random.direction() * (0.4 + random.unit()));
            let shape = match (random.unit() * 6.0) as u32 {
                0 => format!("sphere {{ <{}, {}, {}>, {} }}", 0.4 * b.x, 0.4 * b.y, 0.4 * b.z, 0.4 + random.unit()),
                1 => "box { -.8, .8 }".to_owned(),
                2 => format!("cylinder {{ -y, y, {} }}", 0.3 + random.unit()),
                3 => format!("cone {{ -y, {}, y, {} }}", random.unit(), random.unit()),
                4 => format!("quadric {{ <1, 0, {}>, 0, 0, -{} }}", 0.5 + random.unit(), random.unit()),
                _ => format!("plane {{ <{}, {}, {}>, {} }}", a.x, a.y, a.z, random.unit()),
            };
            // Some stay where others are.
            let turn = if random.unit() < 0.5 { a * 180.0 } else { DVec3::ZERO };
            format!("object {{ {shape} rotate <{}, {}, {}> }} ", turn.x, turn.y, turn.z)
        };
        let operation = if random.unit() < 0.5 { "difference" } else { "intersection" };
        let parts: String = (0..2 + (random.unit() * 3.0) as usize).map(|_| part(&mut random)).collect();
        let solid = Arc::new(written(&format!("{operation} {{ {parts} pigment {{ rgb 1 }} }}")));
        let [by_stretches, mut by_points] = [(); 2].map(|()| compile_object(&solid).unwrap());
        for id in by_points.nodes.handles_from(NodeId::default()).collect::<Vec<_>>() {
            n_solids += usize::from(!by_points.nodes[id].convex_parts.is_empty());
            by_points.nodes[id].convex_parts = Box::default();
        }
        for _ in 0..100 {
            let (origin, target) = (random.direction() * random.unit() * 4.0, random.direction() * random.unit());
            let ray = Ray::new(origin, (target - origin).normalize());
            let hit = |geometry: &Geometry| {
                let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Camera, &mut Scratch::default());
                hit.map(|hit| (hit.t, hit.primitive, hit.part))
            };
            let found = hit(&by_stretches);
            assert_eq!(found, hit(&by_points), "{operation} {{ {parts} }} {ray:?}");
            n_hits += usize::from(found.is_some());
        }
    }
    assert!(n_solids > 200 && n_hits > 5_000, "{n_solids} {n_hits}");
}
