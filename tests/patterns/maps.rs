//! Sections 11 and 13 of the pattern facts: from a value to a colour, and where statements start from.

use super::*;

/// Single precision of colours, and the six digits that were measured.
const COLORS: f64 = 6e-7;

/// A pigment's components at a point of the x axis, as many as are given.
fn on_x(pigment: &str, x: f64, expected: &[f64]) {
    at(pigment, [x, 0.0, 0.0], expected);
}

fn at(pigment: &str, point: [f64; 3], expected: &[f64]) {
    check(&format!("{pigment} at {point:?}"), &color(pigment, point)[..expected.len()], expected, COLORS);
}

/// Entries of a colour map along x.
fn entries(map: &str, x: f64, expected: &[f64]) {
    on_x(&format!("function{{x}} frequency 0 color_map{{{map}}}"), x, expected);
}

#[test]
fn entries_blend_between_neighbours() {
    let doubled = "[0 rgb 0][.4 rgb .1][.4 rgb .2][.4 rgb .3][1 rgb 1]";
    entries(doubled, 0.4, &[0.1]);
    entries(doubled, 0.4000001, &[0.3000001]);
    entries(doubled, 0.7, &[0.65]);
    entries("[0 rgb 0][.5 rgb .1][.5 rgb .2]", 0.5, &[0.2]);
    let unsorted = "[.8 rgb .8][.4 rgb .4][1 rgb 1]";
    entries(unsorted, 0.5, &[0.8]);
    entries(unsorted, 0.85, &[0.85]);
    entries("[0.2 rgb <1,0,0>][.6 rgbft <0,1,0,.5,.25>]", 0.3, &[0.75, 0.25, 0.0, 0.125, 0.0625]);
    // The old form: both ends of a stretch in one entry.
    entries("[0.2 0.6 color rgb 0 color rgb 1]", 0.3, &[0.25]);
}

#[test]
fn items_are_looked_up_at_the_warped_point() {
    let average = "average pigment_map{[1 rgb <1,0,0> transmit .5][3 gradient x]}";
    on_x(average, 0.4, &[0.55, 0.3, 0.3, 0.0, 0.125]);
    at("gradient x pigment_map{[0 gradient y scale 2][1 gradient y]} scale 4", [1.0, 0.8, 0.0], &[0.125]);
    let turbulent = |pattern: &str| format!("{pattern} turbulence .5 pigment_map{{[0 gradient x][1 gradient x]}}");
    at(&turbulent("bozo"), [0.3, 0.7, -0.2], &[0.157443]);
    at(&turbulent("marble"), [0.3, 0.7, -0.2], &[0.3]);
}

/// A declared or default appearance, then a pigment of a plane; the colour that the plane shows at (x, 0.1, 0.1).
fn shown(declarations: &str, texture: &str, x: f64, expected: [f32; 3]) {
    let scene = read(&format!(
        "#version 3.7; global_settings{{assumed_gamma 1}} {declarations}
        camera{{orthographic location <{x},.1,-1> direction z up .0001*y right .0001*x}}
        plane{{z,.1 {texture} finish{{ambient 1 diffuse 0}}}}"
    ));
    let compiled = whitted::compile::compile(&scene.0.scene).expect("a scene");
    let options = whitted::render::Options { width: 1, height: 1, ..Default::default() };
    let found = whitted::job::Session::new(1)
        .picture(&compiled.world, &options, &whitted::render::Unobserved)
        .picture
        .pixel(0, 0);
    // The last of 16 bits, and where a value of 1 comes round.
    let close = expected.iter().zip(found).all(|(e, f)| (e - f).abs() < 1.6e-5);
    assert!(close, "{declarations} {texture} at {x}: {found:?} instead of {expected:?}");
}

#[test]
fn statements_start_from_what_is_there() {
    shown("#default{pigment{gradient x scale 4}}", "pigment{gradient x}", 0.5, [0.125; 3]);
    shown("", "texture{pigment{bozo scale 3} pigment{gradient x}}", 0.5, [0.16667; 3]);
    shown("#declare Q=pigment{checker}", "pigment{Q gradient x}", 1.3, [0.0, 0.3, 0.7]);
    shown("#declare M=pigment{marble}", "pigment{M gradient x}", 0.3, [0.6; 3]);

    // Entries stay when the pattern changes: those of block patterns at 0, 1, 2 and so on, weights as positions.
    for (declared, texture, x, expected) in [
        ("checker rgb <1,0,0> rgb <.2,.4,.6>", "gradient x", 1.3, [0.76, 0.12, 0.18]),
        ("checker rgb <1,0,0>", "gradient x", 1.3, [0.7, 0.3, 0.0]),
        ("checker pigment{rgb <1,.2,0>} pigment{rgb <0,.3,.5>}", "gradient x", 1.3, [0.7, 0.23, 0.15]),
        ("checker pigment{rgb <1,.2,0>} pigment{rgb <0,.3,.5>}", "average", 0.3, [0.0, 0.3, 0.5]),
        ("hexagon rgb .1 rgb .2 rgb .3", "gradient x scale 4", 0.5, [0.1125; 3]),
        ("brick", "gradient x", 0.3, [0.53, 0.395, 0.395]),
        ("average pigment_map{[.3 rgb <1,.2,0>][1 rgb <0,.3,.5>]}", "gradient x", 0.6, [0.571429, 0.242857, 0.214286]),
        ("gradient x pigment_map{[.3 rgb <1,.2,0>][1 rgb <0,.3,.5>]}", "average", 0.1, [0.230769, 0.276923, 0.384615]),
        ("checker", "frequency .5", 1.3, [0.0, 0.5, 0.5]),
        ("image_map{function 1,1{.5}}", "gradient x", 0.3, [0.3; 3]),
        // A block pattern begins with its own colours.
        ("hexagon rgb .1 rgb .2 rgb .3", "checker", 1.3, [0.0, 1.0, 0.0]),
        ("checker pigment{rgb <1,.2,0>} pigment{rgb <0,.3,.5>}", "checker", 1.3, [0.0, 1.0, 0.0]),
        ("gradient x color_map{[0 rgb <1,.2,0>][1 rgb <0,.3,.5>]}", "hexagon", 2.5, [0.0, 0.0, 1.0]),
        ("checker rgb <1,.2,0> rgb .5", "checker rgb <.3,.8,0>", 1.3, [0.0, 1.0, 0.0]),
    ] {
        shown(&format!("#declare Q=pigment{{{declared}}}"), &format!("pigment{{Q {texture}}}"), x, expected);
    }
}
