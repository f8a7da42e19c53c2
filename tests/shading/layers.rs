//! Section 6 of the shading facts.

use super::*;

const BOTTOM: &str = "texture{pigment{rgb <1,.5,.25>} finish{ambient .3 diffuse 0}}";
const TOP: &str = "texture{pigment{rgbft <.2,.9,.5,.6,.1>} finish{ambient .5 diffuse 0}}";

#[test]
fn layers_filter_what_is_below() {
    let wall = |textures: &str, expected: [f32; 3]| {
        check(&format!("{CZ} {BG} plane{{-z,0 {textures}}}"), expected);
    };
    wall(&format!("{BOTTOM} {TOP}"), [0.095995, 0.231006, 0.104997]);
    let third = "texture{pigment{rgbt .5} finish{ambient .2 diffuse 0}}";
    wall(&format!("{BOTTOM} {TOP} {third}"), [0.097993, 0.165499, 0.102495]);
    let clear = "texture{pigment{rgbf <1,.5,.25,.5>} finish{ambient .3 diffuse 0}}";
    wall(&format!("{clear} {TOP}"), [0.084993, 0.246998, 0.119997]);
}

#[test]
fn reflections_of_layers_add_up() {
    let floor = |textures: &str, expected: [f32; 3]| {
        check(&format!("{CY} {BG} plane{{y,0 {textures}}}"), expected);
    };
    let bottom = "texture{pigment{rgb <1,.5,.25>} finish{ambient .3 diffuse 0 reflection .25}}";
    let top = "texture{pigment{rgbft <.2,.9,.5,.6,.1>} finish{ambient .5 diffuse 0 reflection .5}}";
    floor(&format!("{bottom} {top}"), [0.246006, 0.530999, 0.555001]);
    let varnish = "texture{pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection .4 conserve_energy}}";
    floor(&format!("{BOTTOM} {varnish}"), [0.259998, 0.250004, 0.284993]);
}

#[test]
fn uv_mapping_starts_from_the_default_pigment() {
    let seen = |pigments: &str, expected: f32| {
        check_grey(&format!("#default{{finish{{ambient 1 diffuse 0}}}} {CZ} sphere{{0,1 {pigments}}}"), expected);
    };
    seen("pigment{rgb .8} pigment{uv_mapping}", 0.0);
    seen("pigment{checker rgb .3 rgb .3} pigment{uv_mapping scale 2}", 0.0);
    seen("pigment{uv_mapping rgb .6}", 0.6);
    let declared = "#declare P = pigment{rgb .7} #default{finish{ambient 1 diffuse 0}}";
    check_grey(&format!("{declared} {CZ} sphere{{0,1 pigment{{uv_mapping P}}}}"), 0.7);
    check_grey(&format!("{declared} {CZ} sphere{{0,1 pigment{{P uv_mapping}}}}"), 0.0);
    check_grey(
        &format!(
            "#default{{pigment{{rgb .6}} finish{{ambient 1 diffuse 0}}}} {CZ} sphere{{0,1 pigment{{uv_mapping}}}}"
        ),
        0.6,
    );
}

#[test]
fn layers_end_where_nothing_shows() {
    for (q, expected) in [(".003", 0.299107), (".0045", 0.748653)] {
        let below = "texture{pigment{rgb 1} finish{ambient 100 diffuse 0}}";
        let above = format!("texture{{pigment{{rgbt <.3,.3,.3,{q}>}} finish{{ambient 1 diffuse 0}}}}");
        check_grey(&format!("{CZ} plane{{-z,0 {below} {above}}}"), expected);
    }
}

#[test]
fn texture_maps_mix_results_and_colour_maps_mix_colours() {
    let lamp = "light_source{<0,5,-5> rgb .8}";
    let map = "texture{gradient x translate -.25*x texture_map{\
        [0 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse 1 brilliance 3}]\
        [1 pigment{rgbt <.2,.9,.5,.6>} finish{ambient .1 diffuse .2 specular .3 roughness .1}]}}";
    check(&format!("{CZ} {BG} {lamp} plane{{-z,0 {map}}}"), [0.273579, 0.212436, 0.180880]);
    let colors = "pigment{gradient x translate -.25*x color_map{[0 rgb <1,.5,.25>][1 rgbt <.2,.9,.5,.6>]}} \
        finish{ambient .3 diffuse 0}";
    check(&format!("{CZ} {BG} {lamp} plane{{-z,0 {colors}}}"), [0.233997, 0.213001, 0.169680]);
}

#[test]
fn the_inside_may_look_different() {
    let textures = "texture{pigment{rgb 1} finish{ambient .1 diffuse 0}} \
        interior_texture{pigment{rgb 1} finish{ambient .7 diffuse 0}}";
    check_grey(&format!("{CZ} plane{{z,0 {textures}}}"), 0.700008);
    check_grey(&format!("{CZ} plane{{z,0 {textures} inverse}}"), 0.100008);
}

#[test]
fn the_last_bumps_stay_for_slopes() {
    let plain = "finish{ambient 1 diffuse 0}";
    let bumps = "normal{gradient z 1 translate .3*z}";
    let bumped = format!("pigment{{rgb 0}} {bumps} {plain}");
    let sloped = format!("pigment{{slope{{y}} color_map{{[0 rgb 0][1 rgb 1]}}}} {plain}");
    let floor = |textures: &str, expected: f32| check_grey(&format!("{CY} plane{{y,0 {textures}}}"), expected);
    let map =
        |low: &str, high: &str| format!("texture{{gradient x translate -.5*x texture_map{{[0 {low}][1 {high}]}}}}");
    // The upper entry of a map is worked out first.
    floor(&map(&bumped, &sloped), 0.5);
    floor(&map(&sloped, &bumped), 0.478904);
    let mean = |a: &str, b: &str, c: &str| format!("texture{{average texture_map{{[1 {a}][1 {b}][1 {c}]}}}}");
    floor(&mean(&bumped, &sloped, &sloped), 0.638544);
    floor(&mean(&sloped, &bumped, &sloped), 0.652598);
    let film = format!("texture{{pigment{{rgbt 1}} {bumps} finish{{ambient 0 diffuse 0}}}}");
    floor(&format!("texture{{{sloped}}} {film}"), 0.957809);
    floor(&format!("{film} texture{{{sloped}}}"), 1.0);
}

/// Section 13 of the pattern facts: up to version 3.1, what upper layers filter they let through as it is.
#[test]
fn upper_layers_of_old_scenes_do_not_filter() {
    const BELOW: &str = "texture{pigment{rgb <0,1,.5>} finish{ambient 1 diffuse 0}}";
    let above = |pigment: &str| format!("texture{{pigment{{{pigment}}} finish{{ambient 1 diffuse 0}}}}");
    let film = &above("rgbf <1,0,.25,.5>");
    let (filtered, unfiltered) = ([0.500008, 0.0, 0.187503], [0.500008, 0.500008, 0.375006]);
    let wall = |text: &str, expected: [f32; 3]| check(&format!("{CZ} {text}"), expected);
    wall(&format!("#version 3.11; plane{{-z,0 {BELOW} {film}}}"), filtered);
    for version in ["3.1", "3.0"] {
        wall(&format!("#version {version}; plane{{-z,0 {BELOW} {film}}}"), unfiltered);
    }
    let clear = "background{rgb <.2,.7,.4>}";
    let below = above("rgbf <0.5,1,.5,.6>");
    wall(&format!("#version 3.1; {clear} plane{{-z,0 {below} {film}}}"), [0.629999, 0.409995, 0.284993]);
    wall(&format!("#version 3.1; {clear} plane{{-z,0 {film}}}"), [0.600000, 0.000000, 0.175006]);
    // All entries of maps, but not what a pattern takes its values from.
    for (pigment, expected) in [
        (
            "gradient x translate -.25*x color_map{[0 rgbf <1,0,.25,.5>][1 rgbft <.2,.9,.5,.6,.1>]}",
            [0.360006, 0.651255, 0.415625],
        ),
        (
            "gradient x translate -.25*x pigment_map{[0 gradient y translate -.3*y \
                color_map{[0 rgbf <1,0,.25,.5>][1 rgbf <.3,.6,.9,.8>]}][1 rgbft <.2,.9,.5,.6,.1>]}",
            [0.245762, 0.755200, 0.484215],
        ),
        ("checker rgbf <1,0,.25,.5> rgbf <.3,.6,.9,.8> translate .1", [0.059998, 0.919997, 0.579995]),
        ("average pigment_map{[1 rgbf <1,0,.25,.5>][2 rgbf <.3,.6,.9,.8>]}", [0.160006, 0.820005, 0.555001]),
        ("pigment_pattern{rgbf <1,0,.25,.5>} color_map{[0 rgb 0][1 rgbf 1]}", [0.219547, 0.545052, 0.382300]),
    ] {
        wall(&format!("#version 3.1; plane{{-z,0 {BELOW} {}}}", above(pigment)), expected);
    }
    // What a pigment block leaves of an upper layer stays so; colours that it writes filter.
    for (pigment, changed, expected) in [
        ("rgbf <1,0,.25,.5>", "scale 2", unfiltered),
        ("gradient z color_map{[0 rgbf <1,0,.25,.5>][1 rgbf <1,0,.25,.5>]}", "onion", unfiltered),
        ("gradient z pigment_map{[0 rgbf <1,0,.25,.5>][1 rgbf <1,0,.25,.5>]}", "scale 2", unfiltered),
        ("checker pigment{rgbf <1,0,.25,.5>} pigment{rgbf <1,0,.25,.5>}", "scale 2", unfiltered),
        ("gradient z", "onion color_map{[0 rgbf <1,0,.25,.5>][1 rgbf <1,0,.25,.5>]}", filtered),
    ] {
        wall(&format!("#version 3.1; plane{{-z,0 {BELOW} {} pigment{{{changed}}}}}", above(pigment)), expected);
    }
    // The version counts where a texture comes to lie over another, or is declared or used with its layers.
    let declared = format!("#declare T={BELOW} {film} #version 3.1;");
    wall(&format!("#version 3.1; #declare T={film} #version 3.7; plane{{-z,0 {BELOW} texture{{T}}}}"), filtered);
    wall(&format!("#declare T={film} #version 3.1; plane{{-z,0 {BELOW} texture{{T}}}}"), unfiltered);
    wall(&format!("{declared} plane{{-z,0 texture{{T}}}}"), unfiltered);
    wall(&format!("{declared} #declare U=texture{{T}} #version 3.7; plane{{-z,0 texture{{U}}}}"), unfiltered);
    wall(&format!("{declared} plane{{-z,0 texture{{average texture_map{{[1 T]}}}}}}"), filtered);
    wall(&format!("#declare M=material{{{BELOW} {film}}} #version 3.1; plane{{-z,0 material{{M}}}}"), unfiltered);
    let object = format!("#declare O=plane{{-z,0 {BELOW} {film}}} #version 3.1;");
    wall(&format!("{object} object{{O}}"), filtered);
    let more = above("rgbf <.3,.6,.9,.8>");
    wall(&format!("{object} object{{O {more}}}"), [0.459998, 0.119997, 0.330007]);
    // A later pigment of the object has its own say.
    let late = "pigment{rgbf <.3,.6,.9,.8>}";
    wall(&format!("#version 3.1; plane{{-z,0 {BELOW} {film} {late}}}"), [0.084001, 0.648005, 0.611994]);
    wall(&format!("{declared} plane{{-z,0 texture{{T {late}}}}}"), [0.059998, 0.919997, 0.579995]);
}
