//! Section 14 of the pattern facts: normals by themselves.

use super::*;
use whitted::compile;
use whitted::compiled::texture::{Context, Frame};
use whitted::math::DVec3;

/// The normal that a statement makes of (0, 1, 0) at a point.
fn bent(statement: &str, points: &[[f64; 3]]) -> Vec<DVec3> {
    let scene = read(&format!("#version 3.7; plane {{ y, 0 normal {{ {statement} }} }}")).0.scene;
    let compiled = compile::compile(&scene).unwrap_or_else(|_| panic!("{statement}"));
    let layer = compiled.world.textures.iter().filter_map(|t| t.top_layer()).find(|l| l.normal.is_some());
    let normal = layer.and_then(|l| l.normal.as_ref()).expect("a normal");
    let at = |p: &[f64; 3]| normal.perturb(DVec3::Y, DVec3::from(*p), &Frame::default(), &Context::default()).normal;
    points.iter().map(at).collect()
}

#[test]
fn normals_are_those_of_povray() {
    for row in include_str!("normals.txt").lines().filter(|line| !line.starts_with('#')) {
        let mut cells = row.split(" | ");
        let statement = cells.next().expect("a normal statement");
        let found = bent(statement, &POINTS[..4]);
        for (i, cell) in cells.enumerate() {
            let expected: Vec<f64> = cell.split(' ').map(|n| n.parse().expect("a component")).collect();
            check(&format!("{statement} at P{}", i + 1), &found[i].to_array(), &expected, 2e-5);
        }
    }
}
