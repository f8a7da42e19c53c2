//! Probe values of the shape facts and of the freeform facts in POV-Ray's language: what a scene learns about its own
//! objects.

mod analytic;
mod appearance;
mod freeform;
mod solids;

use super::host;
use crate::compile::Queries;
use crate::eval::{Options, evaluate};

/// POV-Ray printed nine decimals; some values went through single precision on the way.
const DIGITS: f64 = 2e-9;

/// What a scene prints, as numbers.
fn printed(text: &str) -> Vec<f64> {
    let text = format!("#version 3.7; {text}");
    let host = host(&text);
    let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default());
    read.unwrap_or_else(|failed| panic!("{:?}\n{text}", failed.diagnostics));
    host.messages().split_whitespace().map(|n| n.parse().unwrap_or(f64::NAN)).collect()
}

fn same(found: &[f64], expected: &[f64], digits: f64) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= digits * b.abs().max(1.0))
}

/// `trace(object, ray)` gives this point, and this normal where one is given; no hit is a normal of zero.
fn traced(object: &str, ray: &str, point: [f64; 3], normal: Option<[f64; 3]>) {
    let found = printed(&format!(
        "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, {ray}, N);
        #debug vstr(3, P, \" \", 0, 15) #debug \" \" #debug vstr(3, N, \" \", 0, 15)"
    ));
    let normals = normal.is_none_or(|n| same(&found[3..], &n, DIGITS));
    assert!(same(&found[..3], &point, DIGITS) && normals, "{object}, {ray}: {found:?}, expected {point:?} {normal:?}");
}

/// The ray meets nothing.
fn missed(object: &str, ray: &str) {
    traced(object, ray, [0.0; 3], Some([0.0; 3]));
}

/// Along z a hit has this z, and this normal.
fn depth(object: &str, ray: &str, z: f64, normal: Option<[f64; 3]>) {
    let found = printed(&format!(
        "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, {ray}, z, N);
        #debug str(P.z, 0, 15) #debug \" \" #debug vstr(3, N, \" \", 0, 15)"
    ));
    let normals = match normal {
        Some(n) => same(&found[1..], &n, DIGITS),
        None => found[1..] != [0.0; 3],
    };
    assert!(same(&found[..1], &[z], DIGITS) && normals, "{object}, {ray}: {found:?}, expected {z} {normal:?}");
}

/// `inside(object, point)` for each point.
fn within(object: &str, points: &[(&str, f64)]) {
    for (point, expected) in points {
        let found = printed(&format!("#declare O = {object} #debug str(inside(O, {point}), 0, 0)"));
        assert_eq!(found, [*expected], "{object}, {point}");
    }
}

/// The numbers that a scene prints.
fn prints(text: &str, expected: &[f64], digits: f64) {
    let found = printed(text);
    assert!(same(&found, expected, digits), "{text}: {found:?}, expected {expected:?}");
}

/// Corners of `min_extent` and `max_extent`, in single precision.
fn extent(object: &str, min: [f64; 3], max: [f64; 3]) {
    let text = format!(
        "#declare O = {object} #debug vstr(3, min_extent(O), \" \", 0, 12) #debug \" \"
        #debug vstr(3, max_extent(O), \" \", 0, 12)"
    );
    prints(&text, &[min, max].concat(), 1e-6);
}
