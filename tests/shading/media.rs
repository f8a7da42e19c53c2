//! Media in objects and in the atmosphere: docs/povray/media.md.

use super::*;
use whitted::render::Region;

const RAMP: &str = "density{function{z} color_map{[0 rgb 0][1 rgb <2,1,.5>]} scale 2}";
const STEPS: &str =
    "density{function{z} color_map{[0 rgb 0][.31 rgb 0][.31 rgb 1][.52 rgb 1][.52 rgb 0][1 rgb 0]} scale 2}";
const X: &str = "emission .3 absorption .7";
const IN_FRONT: &str = "light_source{<0,0,-100> rgb 1}";
const BEHIND: &str = "light_source{<0,0,100> rgb 1}";

/// A clear box of depth 2 with media, each in its own block, in an interior.
fn filled(media: &[&str]) -> String {
    let blocks: String = media.iter().map(|m| format!("media{{{m}}}")).collect();
    format!("box{{<-9,-9,0>,<9,9,2> hollow pigment{{rgbt 1}} finish{{ambient 0 diffuse 0}} interior{{{blocks}}}}}")
}

/// What the box shows, with further objects beside it.
fn check_box(media: &[&str], beside: &str, expected: [f32; 3]) {
    check(&format!("{CZ} {} {beside}", filled(media)), expected);
}

fn check_box_grey(media: &str, beside: &str, expected: f32) {
    check_box(&[media], beside, [expected; 3]);
}

#[test]
fn absorption_and_emission() {
    let sky = "background{rgb <.9,.8,.7>}";
    check_box(&["absorption <.1,.5,1>"], sky, [0.736858, 0.294301, 0.094728]);
    check_box_grey("emission .1", "", 0.2);
    check_box_grey("emission .1 absorption .5", "", 0.137255);
    check_box_grey("emission .1 absorption .5 density{rgb 1} intervals 20", "", 0.126955);
    check_box_grey("emission .1 absorption .5 samples 100", "", 0.127672);
    check_box_grey("emission .1 absorption .5 method 2 samples 10", "", 0.126375);
    check_box_grey("emission .1 absorption 2", "", 0.067247);
    check_box_grey("emission .1 absorption 2 density{rgb 1} intervals 20", "", 0.049912);
    check_box_grey("emission .1 absorption 2 samples 100", "", 0.051041);
    check_box_grey("emission .1 absorption 2 method 2 samples 10", "", 0.048753);
}

#[test]
fn the_backdrop_shows_through_by_the_grey_of_what_is_left() {
    let scene = format!("{CZ} {}", filled(&["absorption <.1,.5,1>"]));
    let found = pixel(&scene, &Options { alpha: true, ..single() });
    assert!((1.0 - found[3] - 0.475273).abs() < TOLERANCE || (found[3] - 0.475273).abs() < TOLERANCE, "{found:?}");
}

#[test]
fn scattering_takes_light_from_all_sides() {
    check_box_grey("scattering{1,.2}", IN_FRONT, 0.291753);
    check_box_grey("scattering{1,.2} intervals 20 samples 20", IN_FRONT, 0.275807);
    check_box_grey("scattering{1,.2}", BEHIND, 0.269520);
    check_box_grey("scattering{1,.2} intervals 20 samples 20", BEHIND, 0.268147);
    let fading = "light_source{<0,0,-12> rgb 1 fade_distance 4 fade_power 2}";
    check_box_grey("scattering{1,.2}", fading, 0.052461);
    check_box_grey("scattering{1,.2} intervals 20 samples 20", fading, 0.048859);
    check_box_grey("scattering{1,.2} method 2 intervals 10 samples 3", fading, 0.048737);
    let within = "light_source{<0,3,1> rgb 1 fade_distance 1 fade_power 2}";
    check_box_grey("scattering{1,.2}", within, 0.066300);
    check_box_grey("scattering{1,.2} intervals 20 samples 20", within, 0.063905);
    check_box_grey("scattering{5,.2 eccentricity .5}", "light_source{<0,5,1> rgb 1}", 0.194217);
    check_box_grey("scattering{5,.2 eccentricity .5} intervals 20 samples 20", "light_source{<0,5,1> rgb 1}", 0.182956);
}

/// Seen against the light, along it, and across.
fn check_phase(kind: &str, expected: [f32; 3]) {
    let lights = [BEHIND, IN_FRONT, "light_source{<0,1000000,1> rgb 1}"];
    for (light, expected) in lights.iter().zip(expected) {
        check_box_grey(&format!("scattering{{{kind} extinction 0}}"), light, expected);
    }
}

#[test]
fn phase_functions() {
    check_phase("1,.05", [0.1, 0.1, 0.1]);
    check_phase("2,.05", [0.576654, 0.057664, 0.059693]);
    check_box_grey("scattering{3,.05 extinction 0}", IN_FRONT, 0.049577);
    check_phase("4,.05", [0.159869, 0.159869, 0.079942]);
    check_phase("5,.05 eccentricity .3", [0.265309, 0.041413, 0.079973]);
    let two = ["scattering{5,.05 eccentricity .3 extinction 0}", "emission .01"];
    check_box(&two, BEHIND, [0.202655; 3]);
}

#[test]
fn some_lights_do_not_light_media() {
    check_box_grey("scattering{1,.2}", "light_source{<0,0,-100> rgb 1 shadowless}", 0.0);
    check_box_grey("scattering{1,.2}", "light_source{<0,0,-100> rgb 1 media_interaction off}", 0.0);
}

#[test]
fn densities_multiply_and_media_add_up() {
    let with = |density: &str| format!("{X} {density}");
    check_box(&[&with(RAMP)], "", [0.336049, 0.205707, 0.114687]);
    check_box(&[&with(&format!("{RAMP} intervals 3 samples 5"))], "", [0.337224, 0.212451, 0.120440]);
    check_box_grey(&format!("emission .5 absorption .7 {STEPS}"), "", 0.230366);
    check_box(&[&with(&format!("{RAMP} {STEPS}"))], "", [0.116777, 0.060441, 0.030762]);
    let second = format!("emission .1 absorption .2 samples 5 {STEPS}");
    check_box(&[&with(RAMP), &second], "", [0.358480, 0.238010, 0.154208]);
    check_box(&[&with(RAMP), &format!("{second} intervals 2")], "", [0.353689, 0.226246, 0.137179]);
}

#[test]
fn a_dark_medium_without_density_is_one_part() {
    check_box_grey(&format!("{X} intervals 4"), "", 0.362020);
    check_box_grey(&format!("{X} intervals 4 density{{rgb 1}}"), "", 0.332403);
    check_box_grey(&format!("{X} intervals 4"), "light_source{<0,5,1> rgb 1}", 0.332403);
    check_box_grey(&format!("{X} intervals 4"), "light_source{<0,5,1> rgb 1 shadowless}", 0.362020);
}

#[test]
fn lit_ranges_get_the_larger_share_of_parts() {
    let spot = "light_source{<0,5,1> rgb 1 spotlight point_at <0,0,1> radius 5 falloff 10}";
    check_box_grey("scattering{1,.2 extinction 0}", spot, 0.302693);
    check_box_grey("scattering{1,.2 extinction 0} intervals 8 ratio .7", spot, 0.275319);
    check_box_grey(&format!("{X} intervals 4"), spot, 0.337819);
    let all = "scattering{1,.2 extinction 0} emission .1 absorption .7 intervals 4";
    let tube = "light_source{<0,5,1> rgb 1 cylinder point_at <0,0,1> radius .2 falloff .3}";
    check_box_grey(all, tube, 0.163989);
    let wide = "light_source{<0,.5,1> rgb 1 spotlight point_at <0,.5,9> radius 70 falloff 85}";
    check_box_grey(all, wide, 0.173892);
    let hard = "light_source{<0,.5,1> rgb 1 spotlight point_at <0,.5,9> radius 70 falloff 40}";
    check_box_grey(all, hard, 0.140169);
}

#[test]
fn method_2_takes_even_samples() {
    check_box(&[&format!("{X} {RAMP} method 2 samples 4")], "", [0.205356, 0.163729, 0.108827]);
}

#[test]
fn the_last_version_without_method_3() {
    let scene = format!("#version 3.1; {CZ} {} #version 3.7;", filled(&["emission .1 absorption .5"]));
    // Ten intervals of one random sample each: this is their mean, not POV-Ray's noise.
    let found = pixel(&scene, &single());
    assert!((found[0] - 0.126424).abs() < 0.05, "{found:?}");
}

/// A wall before which something stands in front of the light.
fn check_shadow(before: &str, light: &str, expected: f32) {
    check_grey(&format!("{CZ} {WALL} {before} light_source{{{light}}}"), expected);
}

/// A box of media in front of the wall, from `low` to `high` along z.
fn container(low: f64, high: f64, flags: &str, media: &str) -> String {
    format!(
        "box{{<-9,-9,{low}>,<9,9,{high}> pigment{{rgbt 1}} finish{{ambient 0 diffuse 0}} {flags} interior{{media{{{media}}}}}}}"
    )
}

#[test]
fn shadows_of_media() {
    let light = "<0,0,-9.5> rgb 1";
    let at = |flags: &str| container(-4.0, -2.0, flags, "absorption .5");
    check_shadow(&at("hollow no_image"), light, 0.367880);
    check_shadow(&at("hollow no_image"), "<0,0,-3> rgb 1", 1.0);
    check_shadow(&at("hollow no_image no_shadow"), light, 1.0);
    check_shadow(&at("no_image"), light, 1.0);
    let around = |flags: &str| container(-4.0, 2.0, flags, "absorption .1");
    check_shadow(&around("hollow"), light, 0.449332);
    check_shadow(&around("hollow no_image"), light, 1.0);
    // Shadow rays halve no steps.
    let steps = STEPS.replace("scale 2", "scale 2 translate -4*z");
    let patterned = container(-4.0, -2.0, "hollow no_image", &format!("absorption .5 {steps}"));
    check_shadow(&patterned, light, 0.800732);
}

#[test]
fn the_last_density_decides_how_shadows_are_sampled() {
    let ramp = "density{function{z} color_map{[0 rgb 0][1 rgb 1]} scale 2 translate -4*z}";
    let last = container(-4.0, -2.0, "hollow no_image", &format!("absorption .5 density{{rgb 1}} {ramp}"));
    let scene = format!("camera{{location <0,0,-1> look_at 0 right x up y angle 1}} {WALL} {last}");
    let found = pixel(&format!("{scene} light_source{{<0,0,-9.5> rgb 1}}"), &single());
    assert!(found[0] > 0.0 && found[0] < 1.0);
}

#[test]
fn media_of_the_atmosphere() {
    let air = "media{absorption .1}";
    let light = "<0,0,-5> rgb 1";
    check_shadow(air, light, 0.367880);
    check_shadow(air, &format!("{light} media_attenuation on"), 0.223133);
    check_shadow(air, &format!("{light} media_attenuation on media_interaction off"), 0.367880);
}

#[test]
fn solid_objects_keep_media_out() {
    let inner = |flags: &str| format!("sphere{{0,1 pigment{{rgbt 1}} finish{{ambient 0 diffuse 0}} {flags}}}");
    let scene = |flags: &str| {
        let outer = container(-4.0, 4.0, "hollow", "absorption .1");
        format!("{CZ} background{{rgb .9}} {outer} {}", inner(flags))
    };
    check_grey(&scene(""), 0.493935);
    check_grey(&scene("hollow"), 0.404395);
}

#[test]
fn media_need_a_surface_behind_them() {
    let around = "plane{-z,0 hollow pigment{rgbt 1} interior{media{absorption .1}} translate -25*z}";
    check(&format!("{CZ} {BG} {around}"), [0.2, 0.4, 0.6]);
    check_box_grey("emission 1e-11", "background{rgb .2}", 0.2);
}

#[test]
fn area_lights_in_media() {
    let light = "light_source{<0,5,1> rgb 1 fade_distance 2 fade_power 2 area_light <.001,0,0>,<0,.001,0>,2,2";
    check_box_grey("scattering{1,.05 extinction 0} samples 2", &format!("{light}}}"), 0.027314);
    check_box_grey("scattering{1,.05 extinction 0} samples 2", &format!("{light} area_illumination}}"), 0.100008);
}

#[test]
fn densities_move_with_their_objects() {
    let moved = |around: &str| around.replace('@', &filled(&[&format!("{X} {RAMP}")]));
    let expected = [0.336049, 0.205707, 0.114687];
    check(&format!("{CZ} {}", moved("union{ @ translate .5*z}")), expected);
    check(&format!("{CZ} {}", moved("#declare A = @ union{ object{A translate .5*z} translate .25*z}")), expected);
}

#[test]
fn quality_below_9_has_no_media() {
    let found = pixel(&format!("{CZ} {}", filled(&["emission .1"])), &Options { quality: 8, ..single() });
    assert_eq!(found[0], 0.0);
}

/// Media of all methods, with random samples and shadows, over several blocks of pixels.
const SMOKE: &str = "#version 3.7; global_settings{assumed_gamma 1} camera{location <0,1,-6> look_at <0,1,0>}
    light_source{<4,6,-3> rgb 1 spotlight point_at <0,1,0> radius 12 falloff 20} plane{y,0 pigment{rgb .8}}
    media{method 2 samples 4 jitter 1 scattering{1,.03}}
    sphere{<-1,1,0>,.9 hollow pigment{rgbt 1} interior{media{method 1 intervals 3 samples 2,8 scattering{5,.9 eccentricity .3}
        density{bozo color_map{[.3 rgb 0][.7 rgb <1,.6,.2>]} scale .3}}}}
    box{<.2,.2,-.7>,<1.6,1.6,.7> hollow pigment{rgbt 1} interior{media{jitter .5 absorption .4 emission <.1,.2,.5> density{wood}}}}";

#[test]
fn neither_threads_nor_parts_show() {
    let options = Options { width: 80, height: 60, ..Options::default() };
    let one = picture_by(1, SMOKE, &options);
    assert!([2, 7, 64].iter().all(|threads| picture_by(*threads, SMOKE, &options).pixels == one.pixels));
    let region = Region { left: 13, top: 20, right: 61, bottom: 50 };
    let part = picture_by(3, SMOKE, &Options { region: Some(region), ..options });
    let same = |(x, y): (usize, usize)| part.pixel(x - region.left, y - region.top) == one.pixel(x, y);
    assert!((region.top..region.bottom).all(|y| (region.left..region.right).all(|x| same((x, y)))));
}
