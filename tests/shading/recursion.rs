//! Section 7 of the shading facts.

use super::*;

const CLEAR: &str = "pigment{rgbt 1} finish{ambient 0 diffuse 0}";

#[test]
fn straight_rays_keep_their_level() {
    let sheets: String = (1..=10).map(|i| format!("disc{{<0,0,{i}>,z,1 {CLEAR}}}")).collect();
    let limit = |m: u32| format!("{CZ} {BG} global_settings{{max_trace_level {m}}} {sheets}");
    check_grey(&limit(1), 0.0);
    check(&limit(2), [0.2, 0.4, 0.6]);
}

#[test]
fn mirrors_end_at_the_limit() {
    let mirror = "pigment{rgb 1} finish{ambient 0 diffuse 0 emission .1 reflection 1}";
    for m in [1, 2, 5, 9] {
        let scene =
            format!("{CZ} global_settings{{max_trace_level {m}}} plane{{-z,-1 {mirror}}} plane{{z,-20 {mirror}}}");
        check_grey(&scene, m as f32 * 0.1);
    }
}

#[test]
fn rays_that_count_little_are_dropped() {
    let bright = "plane{z,-20 pigment{rgb 1} finish{ambient 0 diffuse 0 emission 100}}";
    for (r, expected) in [(".0038", 0.0), (".004", 0.4)] {
        let wall = format!("plane{{-z,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 0 reflection {r}}}}}");
        check_within(&format!("{CZ} {wall} {bright}"), [expected; 3], 3e-5);
    }
}

#[test]
fn glass_spheres() {
    let glass = "sphere{0,1 pigment{rgbf <.9,1,.8,.9>} \
        finish{ambient 0 diffuse 0 reflection{0,1 fresnel} conserve_energy} interior{ior 1.5}}";
    let expected = [
        ("0", [0.601968, 0.653086, 0.375814]),
        (".6", [0.602991, 0.653483, 0.377005]),
        (".9", [0.625040, 0.664500, 0.400885]),
        (".97", [0.666316, 0.679927, 0.449622]),
    ];
    for (x, expected) in expected {
        let camera = format!("camera{{orthographic location <{x},0,-10> direction z right x*.0001 up y*.0001}}");
        check(&format!("{camera} background{{rgb <.9,.8,.7>}} {glass}"), expected);
    }
}

#[test]
fn total_reflection() {
    let water = "plane{y,0 pigment{rgbt .5} finish{ambient 0 diffuse 0 reflection .3} interior{ior .5}}";
    check(&format!("{CY} {BG} {water}"), [0.2, 0.4, 0.6]);
    let nearly_opaque = "plane{y,0 pigment{rgbt .003} finish{ambient 0 diffuse 0 reflection .3} interior{ior .5}}";
    check(&format!("{CY} {BG} {nearly_opaque}"), [0.059998, 0.119997, 0.179995]);
}

#[test]
fn bumps_bend_reflections_and_refractions() {
    let camera = "camera{location <-5,5,0> look_at 0 right z up y angle 1}";
    let mirror = "plane{-x,-10 inverse pigment{function{(y+40)/80}} finish{ambient 0 diffuse 0 emission 1}}";
    for (a, expected) in [(".3", 0.555612), ("1", 0.624994)] {
        let floor = format!(
            "plane{{y,0 pigment{{rgb 0}} normal{{function{{x}} {a}}} finish{{ambient 0 diffuse 0 reflection 1}}}}"
        );
        check_within(&format!("{camera} {mirror} {floor}"), [expected; 3], 1e-4);
    }
    let below = "plane{y,-10 pigment{function{(x+40)/80}} finish{ambient 0 diffuse 0 emission 1}}";
    for (a, ior, expected) in [(".3", "1.5", 0.514168), (".3", "1.05", 0.587411), ("1", "1.05", 0.727672)] {
        let floor = format!("plane{{y,0 {CLEAR} normal{{function{{x}} {a}}} interior{{ior {ior}}}}}");
        check_within(&format!("{camera} {below} {floor}"), [expected; 3], 1e-4);
    }
}

#[test]
fn sheets_that_let_little_through_end_rays() {
    let behind = |pigment: &str, emission: u32, expected: [f32; 3]| {
        let sheet = format!("plane{{-z,0 pigment{{{pigment}}} finish{{ambient 0 diffuse 0}}}}");
        let lamp = format!("plane{{z,20 pigment{{rgb 1}} finish{{ambient 0 diffuse 0 emission {emission}}}}}");
        check_within(&format!("{CZ} {sheet} {lamp}"), expected, 3e-5);
    };
    behind("rgbt <1,1,1,.0039>", 100, [0.0; 3]);
    behind("rgbt <1,1,1,.0040>", 100, [0.4; 3]);
    behind("rgbf <0,0,1,.03>", 30, [0.0; 3]);
    behind("rgbf <0,0,1,.036>", 25, [0.0, 0.0, 0.900008]);
}

#[test]
fn the_most_that_may_be_mirrored_counts() {
    let bright = "plane{z,-20 pigment{rgb 1} finish{ambient 0 diffuse 0 emission 100}}";
    for (fresnel, expected) in [("", 0.100008), ("fresnel", 0.0)] {
        let wall =
            format!("plane{{-z,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 0 reflection{{.001,.9 {fresnel}}}}}}}");
        check_within(&format!("{CZ} {wall} {bright}"), [expected; 3], 3e-5);
    }
}

#[test]
fn bumps_change_how_much_is_mirrored() {
    let camera = "camera{location <-5,5,0> look_at 0 right z up y angle 1} background{rgb .5}";
    for (a, plain, fresnel) in [(".3", 0.408820, 0.185382), ("1", 0.513863, 0.500008)] {
        let floor = |more: &str| {
            let finish = format!("finish{{ambient 0 diffuse 0 reflection{{0,1 {more}}}}}");
            format!("{camera} plane{{y,0 pigment{{rgb 0}} normal{{function{{x}} {a}}} {finish} interior{{ior 1.5}}}}")
        };
        check_within(&floor(""), [plain; 3], 1e-4);
        check_within(&floor("fresnel"), [fresnel; 3], 1e-4);
    }
}

#[test]
fn bends_and_mirrors_add_levels() {
    let limit = |m: u32| format!("{CZ} {BG} global_settings{{max_trace_level {m}}}");
    let glass = format!("box{{<-9,-9,0>,<9,9,2> {CLEAR} interior{{ior 1.5}}}}");
    let mirror = "plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse 0 reflection 1}}";
    let behind_the_camera = format!("disc{{<0,0,-12>,z,1 {CLEAR}}}");
    for (m, expected) in [(2, [0.0; 3]), (3, [0.2, 0.4, 0.6])] {
        check(&format!("{} {glass}", limit(m)), expected);
        check(&format!("{} {mirror} {behind_the_camera}", limit(m)), expected);
    }
}
