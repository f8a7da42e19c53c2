//! Patterns, normals, maps and warps, from text to number, against the values that POV-Ray 3.7.0.10 gives.

mod lookups;
mod maps;
mod normals;
mod values;

use whitted::compile::Queries;
use whitted::eval::{self, Evaluated, Memory};

/// Where tables were measured: P1 to P6.
const POINTS: [[f64; 3]; 6] = [
    [0.3, 0.7, -1.2],
    [-1.37, 2.51, 0.68],
    [0.125, -0.25, 0.5],
    [12.9, -7.3, 33.4],
    [-250.75, 1003.3, -87.6],
    [1.0, -2.0, 3.0],
];

/// A text read as a scene, and the numbers that it printed.
fn read(text: &str) -> (Evaluated, Vec<f64>) {
    let host = Memory::new([("a.pov", text)]);
    let read = eval::evaluate("a.pov".as_ref(), &eval::Options::default(), &host, &Queries::default());
    let read = read.unwrap_or_else(|failed| {
        let messages: String = failed.diagnostics.iter().map(|d| d.render(&failed.sources, false)).collect();
        panic!("{text}\n{messages}");
    });
    let printed = host.messages();
    let numbers = printed.split_whitespace().map(|n| n.parse().expect("a number")).collect();
    (read, numbers)
}

/// What `expression` of x, y, z gives at some points after `declarations`, with 15 decimals.
fn printed(declarations: &str, expression: &str, points: &[[f64; 3]]) -> Vec<f64> {
    let at = |[x, y, z]: &[f64; 3]| {
        format!(
            "#declare x_=({x}); #declare y_=({y}); #declare z_=({z}); #debug concat(str({expression},0,15),\" \")\n"
        )
    };
    let calls: String = points.iter().map(at).collect();
    read(&format!("{declarations}\n{calls}")).1
}

/// A pattern's values at some points.
fn values(header: &str, pattern: &str, points: &[[f64; 3]]) -> Vec<f64> {
    printed(&format!("{header}\n#declare F=function{{pattern{{{pattern}}}}}"), "F(x_,y_,z_)", points)
}

/// A pigment's red, green, blue, filter and transmit at a point.
fn color(pigment: &str, point: [f64; 3]) -> Vec<f64> {
    let declaration = format!("#version 3.7; #declare F=function{{pigment{{{pigment}}}}}");
    let component = |name: &str| printed(&declaration, &format!("F(x_,y_,z_).{name}"), &[point])[0];
    ["red", "green", "blue", "filter", "transmit"].map(component).to_vec()
}

/// Compares numbers, all of them.
fn check(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let close = found.iter().zip(expected).all(|(f, e)| (f - e).abs() <= tolerance);
    assert!(close && found.len() == expected.len(), "{what}: {found:?} instead of {expected:?}");
}
