//! Shapes with flat sides, and solids made of others.

use super::{Case, Field, check, length};

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
