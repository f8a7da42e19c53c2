//! Light that photons bring.
//!
//! A floor seen from above, whose mean brightness counts, as in the photon facts, section 7.

use crate::{picture, picture_by};
use whitted::render::{Options, Region};

const FLOOR: &str = "plane{y,0 pigment{rgb 1} finish{ambient 0 diffuse 1}}";
const ABOVE: &str = "camera{orthographic location <0,3,0> direction -y right x*2 up z*2}";
/// Light P of the facts, and Q.
const PARALLEL: &str = "light_source{<0,10,0> rgb .5 parallel point_at 0}";
const POINT: &str = "light_source{<0,10,0> rgb .5}";
const CLEAR: &str = "rgbt 1";
const COLORED: &str = "rgbf <1,.5,.25,.6>";

/// By how much means may be off: POV-Ray's search loses some photons and its radius is left to chance, by up to 3 % (photon
/// facts, section 6).
const TOLERANCE: f32 = 0.02;

fn options() -> Options {
    Options { width: 16, height: 16, ..Options::default() }
}

/// A slab of that pigment over the floor, which says so about photons.
fn slab(pigment: &str, photons: &str) -> String {
    format!("box{{<-2,4.9,-2>,<2,5,2> pigment{{{pigment}}} photons{{{photons}}}}}")
}

fn mean(settings: &str, objects: &str) -> [f32; 3] {
    let text = format!("global_settings {{ photons {{ {settings} }} }} {ABOVE} {objects}");
    let found = picture(&text, &options());
    let sum = |channel: usize| found.pixels.iter().map(|pixel| pixel[channel]).sum::<f32>();
    [0, 1, 2].map(|channel| sum(channel) / found.pixels.len() as f32)
}

/// The mean with `settings`, within a share of it.
fn check_within(tolerance: f32, settings: &str, objects: &str, expected: [f32; 3]) {
    let found = mean(settings, objects);
    let agrees = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance * b.max(1e-3));
    assert!(agrees, "{settings} {objects}: {found:?} instead of {expected:?}");
}

fn check(settings: &str, objects: &str, expected: [f32; 3]) {
    check_within(TOLERANCE, settings, objects, expected);
}

/// The same for a slab, the floor, and a light.
fn check_slab(light: &str, pigment: &str, photons: &str, expected: [f32; 3]) {
    check("spacing .04", &format!("{light} {FLOOR} {}", slab(pigment, photons)), expected);
}

const REFRACTS: &str = "target refraction on reflection off";

#[test]
fn clear_targets_leave_light_as_it_was() {
    check_slab(PARALLEL, CLEAR, REFRACTS, [0.49997; 3]);
    check_slab(POINT, CLEAR, REFRACTS, [0.50037; 3]);
    check_slab(PARALLEL, CLEAR, "target 2 refraction on reflection off", [0.50108; 3]);
    check_slab(PARALLEL, CLEAR, "target .5 refraction on reflection off", [0.50032; 3]);
}

#[test]
fn colours_filter_what_photons_carry() {
    check_slab(PARALLEL, COLORED, REFRACTS, [0.17942, 0.04426, 0.01077]);
}

#[test]
fn light_that_no_photon_carries_comes_straight() {
    let direct = [0.18, 0.045, 0.01125];
    check_slab(PARALLEL, COLORED, "target refraction off reflection off", direct);
    check_slab(PARALLEL, COLORED, "target", direct);
    let light = PARALLEL.replace("point_at 0", "point_at 0 photons{refraction off}");
    check_slab(&light, COLORED, REFRACTS, direct);
    let grouped = format!("light_group{{ {PARALLEL} {FLOOR} {} global_lights off }}", slab(COLORED, REFRACTS));
    check("spacing .04", &grouped, direct);
}

#[test]
fn lights_fade_and_have_beams_and_samples() {
    let with = |words: &str| POINT.replace("rgb .5", &format!("rgb .5 {words}"));
    check_slab(&with("fade_distance 5 fade_power 2"), CLEAR, REFRACTS, [0.19866; 3]);
    check_slab(&with("spotlight radius 3 falloff 5 point_at 0"), CLEAR, REFRACTS, [0.21775; 3]);
    let area = with("area_light .1*x, .1*z, 3, 3 photons{area_light}");
    check_slab(&area, CLEAR, REFRACTS, [0.50394; 3]);
}

#[test]
fn levels_end_photons() {
    let of = |level: u32, expected: f32| {
        let objects = format!("{PARALLEL} {FLOOR} {}", slab(CLEAR, REFRACTS));
        check(&format!("spacing .04 max_trace_level {level}"), &objects, [expected; 3]);
    };
    of(1, 0.50001);
    of(2, 0.0);
    of(3, 0.49997);
}

#[test]
fn few_photons_are_gathered_widely_or_not_at_all() {
    let objects = |photons: &str| format!("{PARALLEL} {FLOOR} {}", slab(CLEAR, photons));
    check("spacing .6 gather 5, 20", &objects(REFRACTS), [0.49820; 3]);
    let scarce = objects("target refraction on reflection off collect off");
    // Some photons more than light one point: what radius they suggest is left to chance.
    check_within(0.25, "spacing .4", &scarce, [0.32620; 3]);
    check("spacing .405", &scarce, [0.0; 3]);
}

#[test]
fn layers_filter_one_after_the_other() {
    let layers = format!(
        "{PARALLEL} {FLOOR} box{{<-2,4.9,-2>,<2,5,2> texture{{pigment{{{COLORED}}}}}
        texture{{pigment{{rgbf <.5,.8,.9,.9>}}}} photons{{{REFRACTS}}}}}"
    );
    // As bright as the light that comes straight: POV-Ray filters twice by the first colour (photon facts, section 6).
    check("spacing .04 radius .3", &layers, [0.03645, 0.02333, 0.00739]);
}

#[test]
fn photons_are_left_out_below_quality_9() {
    let text = format!(
        "global_settings {{ photons {{ spacing .1 }} }} {ABOVE} {PARALLEL} {FLOOR} {}",
        slab(COLORED, REFRACTS)
    );
    let plain = picture(&text.replace("photons { spacing .1 }", ""), &Options { quality: 8, ..options() });
    assert!(picture(&text, &Options { quality: 8, ..options() }).pixels == plain.pixels);
}

/// A ball of glass, a mirror and two lights over a floor.
const CAUSTIC: &str = "#version 3.7; global_settings { assumed_gamma 1 photons { spacing .1 jitter .7 } }
    camera { location <0, 4, -6> look_at 0 } light_source { <-4, 6, 0>, 1 } light_source { <4, 6, -2>, rgb <.2, .4, .9> }
    plane { y, 0 pigment { rgb .8 } }
    sphere { y, .8 pigment { rgbt .9 } finish { reflection .1 } interior { ior 1.5 } photons { target refraction on reflection on } }
    box { <1, 0, -1>, <1.2, 1, 1> pigment { rgb .5 } finish { reflection .7 } photons { target reflection on } }";

#[test]
fn no_thread_shows() {
    let options = Options { width: 40, height: 30, ..Options::default() };
    let one = picture_by(1, CAUSTIC, &options);
    assert!([2, 7, 64].iter().all(|threads| picture_by(*threads, CAUSTIC, &options).pixels == one.pixels));
    let region = Region { left: 11, top: 7, right: 29, bottom: 23 };
    let part = picture_by(2, CAUSTIC, &Options { region: Some(region), ..options });
    let same = |(x, y): (usize, usize)| part.pixel(x - region.left, y - region.top) == one.pixel(x, y);
    assert!((region.top..region.bottom).all(|y| (region.left..region.right).all(|x| same((x, y)))));
}

#[test]
fn small_and_large_scenes_are_alike() {
    let scaled = |factor: f64| {
        let objects = format!(
            "{} {FLOOR} {}",
            POINT.replace("<0,10,0>", &format!("<0,{},0>", 10.0 * factor)),
            slab(COLORED, REFRACTS).replace(" pigment", &format!(" scale {factor} pigment"))
        );
        let camera = format!(
            "camera{{orthographic location <0,{0},0> direction -y right x*{1} up z*{1}}}",
            3.0 * factor,
            2.0 * factor
        );
        let settings = format!("global_settings {{ photons {{ spacing {} }} }}", 0.1 * factor);
        picture(&format!("{settings} {camera} {objects}"), &options())
    };
    let (one, large) = (scaled(1.0), scaled(1024.0));
    let near = |a: f32, b: f32| (a - b).abs() <= 0.05 * a.max(0.01);
    // How flat the ball of the search is depends on the unit, as in POV-Ray; on a flat floor nothing else does.
    assert!(one.pixels.iter().zip(&large.pixels).all(|(a, b)| near(a[0], b[0]) && near(a[2], b[2])));
}

#[test]
fn photons_stay_in_media() {
    let seen = "camera{orthographic location <0,1,-5> direction z right x up y}";
    let air = "box{<-1.5,-1,-1>,<1.5,3,1> hollow pigment{rgbt 1} finish{ambient 0 diffuse 0}
        interior{media{scattering{1,.1 extinction 0}}} photons{refraction on}}";
    let of = |media: &str, light: &str, expected: f32| {
        let settings = format!("global_settings {{ photons {{ spacing .05 media {media} }} }}");
        let text = format!("{settings} {seen} {light} {air} {} plane{{-z,-9 pigment{{rgb 0}}}}", slab(CLEAR, REFRACTS));
        let found = picture(&text, &options());
        let mean = found.pixels.iter().map(|pixel| pixel[0]).sum::<f32>() / found.pixels.len() as f32;
        assert!((mean / expected - 1.0).abs() < 0.05, "{media} {light}: {mean} instead of {expected}");
    };
    of("100", PARALLEL, 0.0986);
    of("100, 2", PARALLEL, 0.0979);
    of("100", POINT, 0.1239);
}
