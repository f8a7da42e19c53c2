//! Sections 1 to 6 and 12 of the pattern facts: from a point to a value.

use super::*;

/// The digits that were measured.
const DIGITS: f64 = 1e-9;

/// A pattern's values at some points of an axis or of space.
fn at(pattern: &str, points: &[[f64; 3]], expected: &[f64]) {
    check(pattern, &values("#version 3.7;", pattern, points), expected, DIGITS);
}

fn at_one(pattern: &str, point: [f64; 3], expected: f64) {
    at(pattern, &[point], &[expected]);
}

fn on_x(x: f64) -> [f64; 3] {
    [x, 0.0, 0.0]
}

#[test]
fn generators_follow_the_version() {
    for (version, expected) in [("3.7", 0.528537372), ("3.5", 0.528537372), ("3.49", 0.526545177), ("3.1", 0.526545177)]
    {
        let header = format!("#version {version};");
        check(version, &values(&header, "bozo", &POINTS[..1]), &[expected], DIGITS);
    }
    // Repeated ones combine bit by bit.
    at_one("bozo noise_generator 1 noise_generator 2", [0.3, 0.4, 0.5], 0.678075305);
    at_one("bozo noise_generator 3", [0.3, 0.4, 0.5], 0.678075305);
}

#[test]
fn values_come_round_after_a_little_more_than_one() {
    let points = [1.0, 1.000_005, 1.000_01, -1.0, -1000.0].map(on_x);
    let found = values("#version 3.7;", "marble ramp_wave", &points);
    check("marble", &found, &[1.0, 1.000_005, 0.0, 0.0, 0.00999], 1e-7);
    at("gradient x", &[1000.25, -1000.25].map(on_x), &[0.25, 0.76]);
    at("function{x} frequency 0", &[-0.3, 1.75].map(on_x), &[0.7, 0.75]);
    at_one("checker frequency .5", [1.5, 0.2, 0.3], 0.5);
    at(
        "spiral1 1 ramp_wave",
        &[[0.0, -1.0, 0.0], on_x(1.0), [0.0, 1.0, 0.0], on_x(-1.0)],
        &[1.0, 0.24999, 0.49999, 0.74999],
    );
    let around = [[0.0, 0.0, 1.0], on_x(1.0), [0.0, 0.0, -1.0], on_x(-1.0)];
    at("radial", &around, &[0.75, 1.0, 0.24999, 0.5]);
    at_one("marble ramp_wave", on_x(1000.0), 0.99001);
}

#[test]
fn octaves_are_one_to_ten() {
    for (octaves, expected) in [(20, 0.547228049), (10, 0.547228049), (1, 0.633065593), (0, 0.633065593)] {
        at_one(&format!("onion turbulence .5 octaves {octaves}"), [0.3, 0.7, -0.2], expected);
    }
}

#[test]
fn borders_of_blocks_lie_where_povray_puts_them() {
    at("checker", &[0.5, -0.5, 1.0 - 1e-11, 1.0 - 1e-9].map(|x| [x, 0.5, 0.5]), &[0.0, 1.0, 1.0, 0.0]);
    let bricks = [[-0.5, 0.1, 0.1], [0.0, -0.5, 0.0], [0.0; 3], [0.0, 2.5, 0.0], [0.0, 2.499, 0.0]];
    at("brick", &bricks, &[0.0, 0.0, 1.0, 0.0, 1.0]);
    at("object{sphere{0,1}}", &[0.0, 1.0, 1.01].map(on_x), &[1.0, 0.0, 0.0]);
    let cells = [[0.5; 3], [-0.5, 0.5, 0.5], [1.5, 2.5, -3.5]];
    at("cells", &cells, &[0.711818915326, 0.566954875831, 0.451739231590]);
}

#[test]
fn modifiers_act_from_last_to_first() {
    for (pattern, expected) in [
        ("turbulence .3 scale 2 rotate 30", 0.525696712),
        ("scale 2 turbulence .3 rotate 30", 0.525696712),
        ("scale 2 rotate 30 turbulence .3", 0.525696712),
        ("warp{turbulence .3} scale 2", 0.642051682),
        ("turbulence .3 scale 2", 0.642051682),
        ("scale 2 warp{turbulence .3}", 0.687805859),
        ("translate x scale 2", 0.097724920),
        ("scale 2 translate x", 0.777817459),
    ] {
        at_one(&format!("onion {pattern}"), [0.3, 0.7, -1.2], expected);
    }
}

#[test]
fn a_point_passes_warps() {
    let p = [0.3, 0.7, -1.2];
    // The coordinates after a warp, raised so that all are positive, with little weight so that none comes round.
    let moved = |warp: &str, from: [f64; 3], expected: [f64; 3]| {
        for (axis, expected) in ["x", "y", "z"].into_iter().zip(expected) {
            let pattern = format!("function{{{axis}*.01+.5}} frequency 0 warp{{{warp}}}");
            at_one(&pattern, from, expected * 0.01 + 0.5);
        }
    };
    moved("cylindrical", p, [0.788989565, 0.7, 1.236931688]);
    moved("cylindrical orientation y dist_exp 1", p, [0.975926194, -1.236931688, 0.7]);
    moved("spherical", p, [0.788989565, 0.663923532, 1.421267040]);
    moved("spherical orientation y dist_exp 1", p, [1.121364864, -1.421267040, 0.943612633]);
    moved("toroidal", p, [0.788989565, 0.698056625, 0.739010571]);
    moved("toroidal orientation y dist_exp 1", p, [0.583071629, -0.739010571, 0.515871225]);
    moved("black_hole 0,2", p, [0.325119888, 0.758613072, -1.300479552]);
    moved("black_hole 0,2 inverse", p, [0.274880112, 0.641386928, -1.099520448]);
    let far = [1.3, 0.7, -1.2];
    moved("repeat .7*x", far, [0.600000012, 0.7, -1.2]);
    moved("repeat .7*x flip x", far, [0.099999976, 0.7, -1.2]);
    moved("repeat .7*x flip <1,1,0> offset <.1,.2,0>", far, [0.199999976, -0.5, -1.2]);
}
