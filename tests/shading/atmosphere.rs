//! Section 6 of the camera and image facts.

use super::*;

/// A plane at distance 4 behind fog; the facts give four decimals.
fn foggy(fog: &str, expected: [f32; 3]) {
    let camera = "camera{location <0,0,-4> look_at 0 right x up y angle 1}";
    let wall = "plane{z,0 inverse pigment{rgb <.2,.4,.8>} finish{ambient 1 diffuse 0}}";
    check_within(&format!("{camera} {wall} {fog}"), expected, 6e-5);
}

#[test]
fn fog_adds_and_filters() {
    foggy("fog{distance 10 rgb .5}", [0.2989, 0.4330, 0.7011]);
    foggy("fog{distance 10 rgbf<.5,.25,.75,.6>}", [0.2587, 0.2299, 0.7031]);
    foggy("fog{distance 10 rgbt<.5,.5,.5,.8>}", [0.26, 0.42, 0.74]);
    foggy("fog{distance 10 rgb <1,0,0>} fog{distance 20 rgb <0,0,1>}", [0.4394, 0.2195, 0.6203]);
    foggy("fog{distance -10 rgb .5}", [0.0525, 0.3508, 0.9475]);
}

#[test]
fn skies_are_layered() {
    let sky = "background{rgb <.9,.6,.3>} sky_sphere{pigment{rgbft<.5,.25,.75,.3,.2>} \
        pigment{rgbft<.4,.8,.2,.1,.35>} emission rgb <.5,1,.7>}";
    check_within(&format!("{CZ} {sky}"), [0.2816, 0.5647, 0.2213], 6e-5);
    let gradient = "camera{location 0 look_at <-1,0,3> right x up y angle 1} \
        sky_sphere{pigment{gradient x translate -.5*x}}";
    check_within(gradient, [0.18378; 3], 6e-5);
}

#[test]
fn patterns_of_the_surface_are_zero_in_the_sky() {
    for pattern in ["aoi", "slope y", "slope { y altitude x }", "slope { point_at <2,3,-1> }"] {
        let map = "color_map { [0 rgb <.2,.4,.6>] [1 rgb 1] }";
        check(&format!("{CZ} sky_sphere {{ pigment {{ {pattern} {map} }} }}"), [0.2, 0.4, 0.6]);
    }
}

#[test]
fn alpha_shows_the_backdrop() {
    let see = |background: &str, expected: [f32; 4]| {
        let found = pixel(&format!("{CZ} background{{{background}}}"), &Options { alpha: true, ..single() });
        assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-3), "{found:?} instead of {expected:?}");
    };
    see("rgbt<.5,.25,1,.5>", [0.25, 0.125, 0.5, 0.5]);
    see("rgbf<.5,.25,1,.6>", [0.2, 0.1, 0.4, 0.754]);
}

#[test]
fn dispersed_light_hides_the_backdrop() {
    let alpha = |interior: &str| {
        let scene = format!("{CZ} sphere {{ 0, 1 pigment {{ rgbt 1 }} interior {{ {interior} }} }}");
        pixel(&scene, &Options { alpha: true, ..single() })[3]
    };
    assert_eq!([alpha("ior 1.3"), alpha("ior 1.3 dispersion 1.1")], [0.0, 1.0]);
}

#[test]
fn fog_weakens_lights_that_say_so() {
    let fog = "fog{distance 10 rgb <0,0,1>}";
    let lit = |more: &str, light: &str, expected: f32| {
        let light = format!("light_source{{<0,0,-5> rgb .8 {light}}}");
        let found = pixel(&format!("{CZ} {WALL} {more} {light}"), &single())[0];
        assert!((found - expected).abs() <= TOLERANCE, "{found} instead of {expected} for {more} {light}");
    };
    let on = "media_attenuation on";
    lit(fog, on, 0.178500);
    lit(fog, "", 0.294301);
    lit(fog, "media_attenuation on media_interaction off", 0.294301);
    lit(fog, "media_attenuation on shadowless", 0.294301);
    lit(fog, "media_attenuation on parallel point_at 0", 0.178500);
    lit("fog{distance 10 rgbf <.5,.2,1,.6>}", on, 0.403525);
    lit("fog{distance 10 rgbt <.5,.2,1,.9>}", on, 0.697993);
    // Inside a solid object there is no fog.
    let sheet = "disc{<0,0,-2>,z,1 pigment{rgbt .5} no_image";
    let slab = "box{<-1,-1,-3>,<1,1,-2> pigment{rgbt 1} no_image";
    lit(&format!("{fog} {sheet}}}"), on, 0.120485);
    lit(&format!("{fog} {sheet} hollow}}"), on, 0.089250);
    lit(&format!("{fog} {slab}}}"), on, 0.197284);
    lit(&format!("{fog} {slab} hollow}}"), on, 0.178500);
}
