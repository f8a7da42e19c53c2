//! Light below surfaces.
//!
//! POV-Ray's numbers and ours are both estimates of one mean, mostly by 30,000 samples.

use crate::{BG, CY, CZ, picture, picture_by, pixel, single};
use whitted::render::{Antialias, ImageLayer, Method, Options, Region};

/// A light that is no brighter than a picture can show.
const LIGHT: &str = "light_source{<0,0,-9> rgb .25}";

/// By how much estimates may differ, in shares of the light: twice what 30,000 depths of single scattering leave, whose
/// weights have about their mean for a standard deviation. Ours are the same in every run.
const NOISE: f32 = 0.012;
/// Half a step of the measured numbers, and single precision.
const ROUNDING: f32 = 2e-5;

/// The first pixel of a picture of one, or, where light is gathered before, the mean of 4 x 4.
fn check(what: &str, settings: &str, scene: &str, expected: [f32; 3]) {
    let size = if settings.contains("radiosity") { 4 } else { 1 };
    let options = Options { width: size, height: size, ..Options::default() };
    let found = picture(&format!("global_settings {{ {settings} }} {scene}"), &options);
    for (channel, expected) in expected.into_iter().enumerate() {
        let mean = found.pixels.iter().map(|pixel| pixel[channel]).sum::<f32>() / found.pixels.len() as f32;
        assert!(
            (mean - expected).abs() <= NOISE * expected + ROUNDING,
            "{what}, channel {channel}: {mean} instead of {expected}"
        );
    }
}

#[test]
fn shapes_and_materials_shine_as_povrays() {
    check(
        "a sphere",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.195682, 0.105013, 0.05568],
    );
    check(
        "one mm a unit",
        "mm_per_unit 1 subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.085267, 0.06659, 0.045014],
    );
    check(
        "no interior",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} }}"
        ),
        [0.203204, 0.108675, 0.057527],
    );
    check(
        "ior 2.5",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 2.5}}}}"
        ),
        [0.133425, 0.072419, 0.03856],
    );
    check(
        "a colour for each channel",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency rgb <1,.3,.1>}}}} interior{{ior 1.3}}}}"
        ),
        [0.179599, 0.105486, 0.055802],
    );
    check(
        "a block",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} box{{<-5,-5,-1>,<5,5,9> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.203082, 0.105745, 0.055802],
    );
    check(
        "a slab thinner than two free paths",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} box{{<-5,-5,-1>,<5,5,-0.98> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.199802, 0.103243, 0.054307],
    );
    check(
        "half a space",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} plane{{-z,-1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.396399, 0.202411, 0.104143],
    );
    check(
        "a disc, which is open",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} disc{{<0,0,-1>,-z,5 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.399741, 0.20412, 0.104982],
    );
    check(
        "a difference",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} difference{{box{{<-5,-5,-1>,<5,5,9>}} sphere{{<0,0,-1.5>,1}} pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.171649, 0.103593, 0.055695],
    );
    check(
        "under water",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,20 hollow pigment{{rgbt 1}} finish{{ambient 0 diffuse 0}} interior{{ior 1.9}}}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8 subsurface{{translucency .5}}}} interior{{ior 2.5}}}}"
        ),
        [0.199634, 0.11313, 0.060319],
    );
    check(
        "seen from within",
        "subsurface{samples 30000,30000}",
        "camera{location 0 look_at z right x up y angle 1} light_source{<0,0,9> rgb .25} sphere{0,1 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .8 subsurface{translucency .5}} interior{ior 1.3}}",
        [0.457649, 0.268971, 0.137575],
    );
}

#[test]
fn lights_of_all_kinds_go_below() {
    check(
        "from the side",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<9,3,-5> rgb .25}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.070405, 0.036805, 0.019287],
    );
    check(
        "from behind",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<0,0,9> rgb 2}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency 5}}}} interior{{ior 1.3}}}}"
        ),
        [0.068772, 0.023713, 0.003571],
    );
    check(
        "two",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} light_source{{<9,3,-5> rgb <.1,.2,.3>}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.223835, 0.134463, 0.078813],
    );
    check(
        "without shadows",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<0,0,-9> rgb .25 shadowless}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency 2}}}} interior{{ior 1.3}}}}"
        ),
        [0.151888, 0.095216, 0.053742],
    );
    check(
        "spot",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<0,0,-9> rgb .25 spotlight point_at 0 radius 1 falloff 8 tightness 0}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.193698, 0.104952, 0.055665],
    );
    check(
        "fading",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<0,0,-9> rgb .25 fade_distance 5 fade_power 2}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.109468, 0.05893, 0.031266],
    );
    check(
        "parallel",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<0,3,-9> rgb .25 parallel point_at 0}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.186618, 0.09955, 0.052674],
    );
    check(
        "area",
        "subsurface{samples 3000,3000}",
        &format!(
            "{CZ} light_source{{<0,0,-9> rgb .25 area_light x*8,y*8,5,5}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.195651, 0.105089, 0.055833],
    );
    check(
        "of a group",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_group{{ {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} }} light_source{{<0,0,-8> rgb .25}}"
        ),
        [0.195682, 0.105013, 0.05568],
    );
    check(
        "in a shadow",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency 5}}}} interior{{ior 1.3}}}} sphere{{<0,0,-3>,.5 no_image pigment{{rgb 1}}}}"
        ),
        [0.015366, 0.009033, 0.003326],
    );
}

#[test]
fn finishes_and_layers_let_light_below() {
    check(
        "bumps do not count",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} box{{<-5,-5,-1>,<5,5,9> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} normal{{gradient x 3 translate .5*x}} interior{{ior 1.3}}}}"
        ),
        [0.203082, 0.105745, 0.055802],
    );
    check(
        "brilliance and albedo do not count",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8 diffuse albedo .8 brilliance 3 subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.195682, 0.105013, 0.05568],
    );
    check(
        "the back side does not count",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} light_source{{<0,0,9> rgb 1}} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8 diffuse .8,.5 subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.00029, 0.0, 0.0],
    );
    check(
        "highlights and own light stay",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8 ambient .1 emission .1 specular .5 subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.520668, 0.330022, 0.230671],
    );
    check(
        "no translucency at all",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency 0}}}} interior{{ior 1.3}}}}"
        ),
        [0.0, 0.0, 0.0],
    );
    check(
        "none in one channel",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency rgb <.5,0,.5>}}}} interior{{ior 1.3}}}}"
        ),
        [0.009918, 0.0, 0.007492],
    );
    check(
        "below a layer",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 texture{{pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}}}} texture{{pigment{{rgbt <1,.5,.25,.5>}} finish{{ambient 0 diffuse .8}}}} interior{{ior 1.3}}}}"
        ),
        [0.197833, 0.10251, 0.052842],
    );
    check(
        "two layers",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 texture{{pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}}}} texture{{pigment{{rgbt <1,.5,.25,.5>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}}}} interior{{ior 1.3}}}}"
        ),
        [0.293523, 0.157534, 0.083513],
    );
    check(
        "an old version",
        "subsurface{samples 30000,30000}",
        &format!(
            "#version 3.5; {CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}}"
        ),
        [0.195682, 0.105013, 0.05568],
    );
}

#[test]
fn what_is_behind_shows_straight_through() {
    check(
        "a slab before a wall",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} box{{<-5,-5,-1>,<5,5,-0.98> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.167224, 0.161273, 0.146548],
    );
    check(
        "at an angle",
        "subsurface{samples 30000,30000}",
        "camera{location <0,9,-10> look_at -z right x up y angle 1} box{<-5,-5,-1>,<5,5,-0.98> pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .8  subsurface{translucency .5}} interior{ior 1.3}} plane{-z,-2 pigment{gradient y scale 4} finish{ambient 1 diffuse 0}}",
        [0.155901, 0.14931, 0.133211],
    );
    check(
        "two slabs",
        "max_trace_level 3 subsurface{samples 30000,30000}",
        &format!(
            "{CZ} box{{<-5,-5,-1>,<5,5,-0.98> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} box{{<-5,-5,0>,<5,5,0.02> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.111849, 0.104036, 0.085908],
    );
    check(
        "three slabs",
        "max_trace_level 9 subsurface{samples 30000,30000}",
        &format!(
            "{CZ} box{{<-5,-5,-1>,<5,5,-0.98> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} box{{<-5,-5,0>,<5,5,0.02> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} box{{<-5,-5,1>,<5,5,1.02> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.0, 0.0, 0.0],
    );
    check(
        "no level left",
        "max_trace_level 1 subsurface{samples 30000,30000}",
        &format!(
            "{CZ} box{{<-5,-5,-1>,<5,5,-0.98> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.0, 0.0, 0.0],
    );
    check(
        "something inside",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency 5}}}} interior{{ior 1.3}}}} sphere{{0,.9 pigment{{rgb 1}} finish{{ambient 1 diffuse 0}}}}"
        ),
        [0.039658, 0.034913, 0.028763],
    );
    check(
        "something inside, no interiors",
        "subsurface{samples 30000,30000}",
        &format!(
            "{CZ} {LIGHT} sphere{{0,1 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency 5}}}} }} sphere{{0,.9 pigment{{rgb 1}} finish{{ambient 1 diffuse 0}}}}"
        ),
        [0.041917, 0.036728, 0.030121],
    );
}

#[test]
fn radiosity_and_light_below_go_together() {
    check(
        "plain",
        "radiosity{count 200} subsurface{samples 2000,1}",
        &format!(
            "{CY} box{{<-5,-5,-5>,<5,0,5> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.2, 0.100008, 0.050004],
    );
    check(
        "below",
        "radiosity{count 200} subsurface{samples 1000,1 radiosity on}",
        &format!(
            "{CY} box{{<-5,-5,-5>,<5,0,5> pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.191923, 0.095967, 0.047978],
    );
    check(
        "below one of two layers",
        "radiosity{count 200} subsurface{samples 1000,1 radiosity on}",
        &format!(
            "{CY} box{{<-5,-5,-5>,<5,0,5> texture{{pigment{{rgb 1}} finish{{ambient 0 diffuse .8}}}} texture{{pigment{{rgbt <1,.5,.25,.5>}} finish{{ambient 0 diffuse .8  subsurface{{translucency .5}}}}}} interior{{ior 1.3}}}} background{{rgb .25}}"
        ),
        [0.191923, 0.095967, 0.047978],
    );
    check(
        "black for samples",
        "radiosity{count 200} subsurface{samples 20,20}",
        &format!(
            "{CY} plane{{y,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 1 emission .3}}}} box{{<-50,5,-50>,<50,15,50> pigment{{rgb 1}} finish{{ambient 0 diffuse .8 subsurface{{translucency .5}}}} interior{{ior 1.3}} no_image}} light_source{{<0,20,0> rgb .25}}"
        ),
        [0.538781, 0.538781, 0.538781],
    );
    check(
        "bounces off it",
        "radiosity{count 200 recursion_limit 3} subsurface{samples 20,20}",
        &format!(
            "{CY} plane{{y,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 1 emission .3}}}} box{{<-50,5,-50>,<50,15,50> pigment{{rgb 1}} finish{{ambient 0 diffuse .8 subsurface{{translucency .5}}}} interior{{ior 1.3}} no_image}}"
        ),
        [0.538796, 0.538796, 0.538796],
    );
    check(
        "bounces in it",
        "radiosity{count 200 recursion_limit 3 subsurface on} subsurface{samples 20,20 radiosity on}",
        &format!(
            "{CY} plane{{y,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 1 emission .3}}}} box{{<-50,5,-50>,<50,15,50> pigment{{rgb 1}} finish{{ambient 0 diffuse .8 subsurface{{translucency .5}}}} interior{{ior 1.3}} no_image}}"
        ),
        [0.522042, 0.522042, 0.522042],
    );
    check(
        "samples do not look below",
        "radiosity{count 200 recursion_limit 3} subsurface{samples 20,20 radiosity on}",
        &format!(
            "{CY} plane{{y,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 1 emission .3}}}} box{{<-50,5,-50>,<50,15,50> pigment{{rgb 1}} finish{{ambient 0 diffuse .8 subsurface{{translucency .5}}}} interior{{ior 1.3}} no_image}}"
        ),
        [0.538796, 0.538796, 0.538796],
    );
}

#[test]
fn other_materials_stay_as_they_are() {
    // Without the block of `global_settings`, and below quality 9, the surface is diffuse.
    let ball = "sphere{0,1 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .8 subsurface{translucency .5}}}";
    let plain = [0.2, 0.1, 0.05];
    let near = |found: [f32; 4]| (0..3).all(|i| (found[i] - plain[i]).abs() < ROUNDING);
    assert!(near(pixel(&format!("{CZ} {LIGHT} {ball}"), &single())));
    let options = Options { quality: 8, ..single() };
    assert!(near(pixel(&format!("global_settings{{subsurface{{}}}} {CZ} {LIGHT} {ball}"), &options)));
    let other = "sphere{0,1 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .8}}";
    assert!(near(pixel(&format!("global_settings{{subsurface{{}}}} {CZ} {LIGHT} {other}"), &single())));
}

#[test]
fn no_samples_give_no_light() {
    let ball = "sphere{0,1 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .8 subsurface{translucency .5}}}";
    let found = pixel(&format!("global_settings{{subsurface{{samples 0,0}}}} {CZ} {LIGHT} {ball}"), &single());
    assert_eq!(found[..3], [0.0; 3]);
}

/// POV-Ray does not end well where a channel of the diffuse colour is 0 or above 1; here it is black, or as white.
#[test]
fn colours_beyond_povrays_are_no_trouble() {
    let ball = |color: &str| {
        let finish = "finish{ambient 0 diffuse 1 subsurface{translucency .5}}";
        let scene = format!("{CZ} {LIGHT} sphere{{0,1 pigment{{rgb {color}}} {finish}}} {BG}");
        pixel(&format!("global_settings{{subsurface{{samples 50,50}}}} {scene}"), &single())
    };
    assert_eq!(ball("0")[..3], [0.0; 3]);
    assert!(ball("<1,.5,0>")[2] == 0.0 && ball("<1,.5,0>")[1] > 0.0);
    assert_eq!(ball("5"), ball("1"));
}

/// Things that shine below their surfaces, in mirrors and behind one another, in several blocks of pixels.
const THINGS: &str = "camera{location <0,1.5,-3.8> look_at <0,.4,0> right x up y angle 60}
    global_settings{subsurface{samples 6,3 radiosity on} radiosity{count 10}}
    light_source{<2,4,-3> rgb .6} light_source{<-2,4,-3> rgb .4 area_light x,z,3,3 jitter}
    plane{y,0 pigment{checker rgb .9 rgb <.9,.5,.3>} finish{diffuse .8 reflection .1}}
    #declare Wax=texture{pigment{rgb <.9,.8,.6>} finish{diffuse .7 subsurface{translucency 2}}}
    sphere{<.8,.5,-.5>,.5 texture{Wax} interior{ior 1.3}}
    box{<-1.4,0,0>,<-.4,1.6,.1> texture{Wax} rotate 10*y}";

fn of_things(threads: usize, region: Option<Region>) -> Vec<[f32; 4]> {
    let antialias = Antialias { method: Method::Grid, threshold: 0.2, depth: 2, jitter: 0.0, gamma: 2.5 };
    let options = Options { width: 80, height: 70, region, antialias: Some(antialias), ..Options::default() };
    picture_by(threads, &format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {THINGS}"), &options).pixels
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let one = of_things(1, None);
    for threads in [2, 7, 64] {
        assert!(of_things(threads, None) == one, "{threads} threads");
    }
}

#[test]
fn a_part_has_the_pixels_of_the_whole() {
    let whole = of_things(2, None);
    let region = Region { left: 13, top: 20, right: 61, bottom: 50 };
    let part = of_things(3, Some(region));
    for (y, row) in (region.top..region.bottom).zip(part.chunks(region.width())) {
        assert!(row == &whole[80 * y + region.left..80 * y + region.right], "row {y}");
    }
}

/// Light from below is a layer of its own, and what direct light leaves.
#[test]
fn light_from_below_is_a_layer() {
    let ball = "sphere{0,1 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .8 subsurface{translucency .5}}}";
    let options = Options { layers: vec![ImageLayer::Subsurface, ImageLayer::Direct], ..single() };
    let found = picture(&format!("global_settings{{subsurface{{}}}} {CZ} {LIGHT} {ball}"), &options);
    for channel in 0..3 {
        assert_eq!(found.layers[0].channels[channel].1[0], found.pixels[0][channel]);
        assert_eq!(found.layers[1].channels[channel].1[0], 0.0);
    }
}
