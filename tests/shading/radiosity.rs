//! Light between surfaces.
//!
//! Pictures of 4 x 4 pixels, of which the first counts, as in the radiosity facts.

use crate::{BG, CY, picture};
use std::sync::Arc;
use whitted::render::{KnownLight, Options, Region};

/// A white diffuse floor.
const FLOOR: &str = "plane{y,0 pigment{rgb 1} finish{ambient 0 diffuse 1}}";
/// Inside of a box, where the light is the same everywhere.
const INSIDE: &str = "camera{location 0 look_at z right x up y angle 1}";

/// Half of the last digit of the measured numbers, and single precision on both sides.
const TOLERANCE: f32 = 2.4e-5;

/// The first pixel of a scene with these settings of radiosity.
fn check(settings: &str, scene: &str, expected: [f32; 3]) {
    check_under(&format!("radiosity {{ {settings} }}"), scene, expected);
}

/// The same with whole `global_settings`.
fn check_under(settings: &str, scene: &str, expected: [f32; 3]) {
    let text = format!("global_settings {{ {settings} }} {scene}");
    let options = Options { width: 4, height: 4, ..Options::default() };
    let found = picture(&text, &options).pixel(0, 0);
    let agrees = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < TOLERANCE);
    assert!(agrees, "{text}: {found:?} instead of {expected:?}");
}

/// Three skies, each brighter along one axis.
fn check_axes(settings: &str, scene: &str, expected: [f32; 3]) {
    for (axis, expected) in ["x", "y", "z"].iter().zip(expected) {
        let colors = "color_map { [0 rgb 0] [1 rgb 1] }";
        let sky = format!("sky_sphere {{ pigment {{ function {{ .5+.499*{axis} }} {colors} }} }}");
        check(settings, &format!("{scene} {sky}"), [expected; 3]);
    }
}

#[test]
fn rays_of_samples_go_where_povrays_go() {
    let scene = format!("{CY} {FLOOR}");
    check_axes("", &scene, [0.494408, 0.839704, 0.506203]);
    check_axes("count 5", &scene, [0.486519, 0.861372, 0.507820]);
    check_axes("count 100", &scene, [0.499535, 0.837552, 0.501991]);
    check_axes("count 1600", &scene, [0.499794, 0.833021, 0.500145]);
}

#[test]
fn bumps_turn_samples() {
    let scene = "camera{location <-5,5,0> look_at 0 right x up y angle 1}
        plane{y,0 pigment{rgb 1} normal{gradient x 3 translate .5*x} finish{ambient 0 diffuse 1}}";
    check_axes("normal on count 35", scene, [0.381949, 0.830182, 0.504082]);
}

#[test]
fn settings_weigh_what_is_gathered() {
    check("", &format!("{CY} {FLOOR} {BG}"), [0.2, 0.4, 0.6]);
    check("max_sample .3", &format!("{CY} {FLOOR} {BG}"), [0.099992, 0.2, 0.300008]);
    let albedo = "plane{y,0 pigment{rgb 1} finish{ambient 0 diffuse albedo .5 brilliance 3}} background{rgb .6}";
    check("", &format!("{CY} {albedo}"), [0.300008; 3]);
}

#[test]
fn ambient_light_counts_in_old_scenes_only() {
    let floor = "plane{y,0 pigment{rgb 1} finish{ambient .1 diffuse .5 emission .2}} background{rgb .4}";
    check("", &format!("{CY} {floor}"), [0.4; 3]);
    check("", &format!("#version 3.6; {CY} {floor}"), [0.499992; 3]);
    // Below quality 9 there is no radiosity, and ambient light counts again.
    let options = Options { width: 4, height: 4, quality: 8, ..Options::default() };
    let found = picture(&format!("global_settings {{ radiosity {{}} }} {CY} {floor}"), &options).pixel(0, 0);
    assert!((found[0] - 0.300008).abs() < TOLERANCE, "{found:?}");
}

/// In a closed white box that glows, each bounce adds its share.
#[test]
fn bounces_add_up() {
    let inside = |pigment: &str, finish: &str| {
        format!("{INSIDE} box{{-1,1 hollow pigment{{rgb {pigment}}} finish{{ambient 0 {finish}}}}}")
    };
    let white = inside("1", "diffuse .5 emission .25");
    for (limit, expected) in [(1, 0.375006), (2, 0.437507), (3, 0.468757), (5, 0.492195), (10, 0.496101)] {
        check(&format!("recursion_limit {limit}"), &white, [expected; 3]);
    }
    check("recursion_limit 3 brightness 2", &inside("1", "diffuse .3 emission .25"), [0.543999; 3]);
    let colored = inside("<1,.5,.25>", "diffuse .5 emission .25");
    check("recursion_limit 3", &colored, [0.468757, 0.166018, 0.071412]);
    check("recursion_limit 1 gray_threshold 1", &colored, [0.327504, 0.163745, 0.081880]);
    check("recursion_limit 1", &inside("1", "diffuse .0039 emission .25"), [0.250004; 3]);
    check("recursion_limit 1", &inside("1", "diffuse .0040 emission .25"), [0.250996; 3]);
    check("recursion_limit 2", &inside("1", "diffuse .009 emission .9"), [0.908095; 3]);
}

#[test]
fn levels_of_mirrors_grow_with_bounces() {
    let mirror = format!(
        "{INSIDE} box{{-1,1 hollow pigment{{rgb 1}} finish{{ambient 0 diffuse .5 emission .25 reflection .2}}}}"
    );
    check("recursion_limit 2", &mirror, [0.621500; 3]);
    check("recursion_limit 3", &mirror, [0.679530; 3]);
    check_under("max_trace_level 20 radiosity{recursion_limit 2}", &mirror, [0.625376; 3]);
    check_under("max_trace_level 20 radiosity{recursion_limit 3}", &mirror, [0.697337; 3]);
}

/// A sample meets fog only if it is told to.
#[test]
fn samples_leave_out_fog() {
    let dome = format!(
        "camera{{location <0,1,-1> look_at 0 right x up y angle 1}} {FLOOR}
        sphere{{0,100 hollow pigment{{rgb 1}} finish{{ambient 0 diffuse 0 emission .5}}}}"
    );
    check("", &dome, [0.500008; 3]);
    check("", &format!("{dome} fog{{distance 100 rgb 0}}"), [0.492927; 3]);
    check("media on", &format!("{dome} fog{{distance 100 rgb 0}}"), [0.181338; 3]);
}

/// Objects that are hidden from everything else are met by samples; what `no_radiosity` hides is not.
#[test]
fn samples_see_what_is_not_hidden_from_them() {
    let roof = |flags: &str| {
        format!(
            "{CY} {FLOOR} background{{rgb .2}} plane{{-y,-100 pigment{{rgb 1}} finish{{ambient 0 diffuse 0 emission 1}} {flags}}}"
        )
    };
    // The camera looks down, so that only samples can see the roof.
    check("", &roof("no_image no_shadow no_reflection"), [1.0; 3]);
    check("", &roof("no_radiosity"), [0.2; 3]);
}

/// A room with several blocks of pixels, a few bounces, mirrors, and smoothed edges.
const ROOM: &str = "camera{location <0,1.5,-3.8> look_at <0,1.2,0> right x up y angle 60}
    global_settings{radiosity{count 20 normal on}}
    light_source{<0,2.7,0> rgb .6}
    box{<-2,0,-4>,<2,3,2> hollow pigment{checker rgb .9 rgb <.9,.5,.3>} normal{bumps .2} finish{diffuse .8}}
    sphere{<.8,.5,-.5>,.5 pigment{rgb .8} finish{diffuse .4 reflection .3}}
    box{<-1.4,0,0>,<-.4,1.6,1> pigment{rgb .8} finish{diffuse .8} rotate 10*y}";

fn in_room(threads: usize, region: Option<Region>) -> Vec<[f32; 4]> {
    let antialias = whitted::render::Antialias {
        method: whitted::render::Method::Grid,
        threshold: 0.2,
        depth: 2,
        jitter: 0.0,
        gamma: 2.5,
    };
    let options = Options { width: 80, height: 70, region, antialias: Some(antialias), ..Options::default() };
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {ROOM}");
    crate::picture_by(threads, &text, &options).pixels
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let one = in_room(1, None);
    assert!(one.iter().all(|pixel| pixel[0] > 0.0));
    for threads in [1, 2, 7] {
        assert!(in_room(threads, None) == one, "{threads} threads");
    }
}

#[test]
fn a_part_has_the_pixels_of_the_whole() {
    let whole = in_room(2, None);
    let region = Region { left: 13, top: 20, right: 61, bottom: 50 };
    let part = in_room(3, Some(region));
    for (y, row) in (region.top..region.bottom).zip(part.chunks(region.width())) {
        assert!(row == &whole[80 * y + region.left..80 * y + region.right], "row {y}");
    }
}

/// Directions in a file have a byte a component, so that the light is not quite the same; radiosity facts, section 6.
#[test]
fn light_that_is_handed_on_is_found_again() {
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {ROOM}");
    let plain = Options { width: 80, height: 70, ..Options::default() };
    let first = crate::rendered_by(2, &text, &Options { keeps_light: true, ..plain.clone() });
    let (known, others) = KnownLight::read(first.light.unwrap().text());
    assert!(others.is_empty());
    let handed_on = Options { known_light: Some(Arc::new(known)), ..plain };
    let one = crate::picture_by(1, &text, &handed_on).pixels;
    for threads in [2, 7] {
        assert!(crate::picture_by(threads, &text, &handed_on).pixels == one, "{threads} threads");
    }
    let region = Region { left: 13, top: 20, right: 61, bottom: 50 };
    let part = crate::picture_by(3, &text, &Options { region: Some(region), ..handed_on }).pixels;
    for (y, row) in (region.top..region.bottom).zip(part.chunks(region.width())) {
        assert!(row == &one[80 * y + region.left..80 * y + region.right], "row {y}");
    }
    let pairs = || first.picture.pixels.iter().flatten().zip(one.iter().flatten());
    let rms = (pairs().map(|(a, b)| (a - b).powi(2)).sum::<f32>() / pairs().count() as f32).sqrt();
    assert!(rms < 0.003, "{rms}");
}
