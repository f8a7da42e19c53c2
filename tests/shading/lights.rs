//! Section 3 of the shading facts.

use super::*;

/// The wall under a light.
fn lit(light: &str, expected: f32) {
    check_grey(&format!("{CZ} {WALL} light_source{{{light}}}"), expected);
}

#[test]
fn point_lights_and_fade() {
    lit("<0,5,-5> rgb .8", 0.565682);
    lit("<0,0,-9.9> rgb .8 fade_distance 5 fade_power 2", 0.325170);
    lit("<0,0,-9.9> rgb .8 fade_distance 5 fade_power 1.5", 0.422599);
    lit("<0,0,-1> rgb .4 fade_distance 5 fade_power 2", 0.769238);
    lit("<0,0,-1> rgb .4 fade_distance 5", 0.4);
    lit("<0,0,-1> rgb .4 fade_power 2", 0.4);
}

#[test]
fn cones_and_tubes() {
    lit("<0,0,-9> rgb .8 spotlight point_at <9*tan(radians(35)),0,0>", 0.632258);
    lit("<0,0,-9> rgb .8 spotlight point_at <9*tan(radians(35)),0,0> tightness 10 radius 20 falloff 50", 0.069581);
    lit("<.9,0,-9> rgb .8 cylinder point_at <.9,0,0>", 0.281605);
    lit("<2,0,-9> rgb .8 cylinder point_at <2,0,0> radius 1 falloff 3 tightness 2", 0.044450);
    lit("<.45,0,-9> rgb .8 cylinder point_at <.45,0,0> scale <2,1,1>", 0.281605);
}

#[test]
fn parallel_and_shadowless_lights() {
    lit("<0,3,1> rgb .8 parallel point_at <0,3,9>", 0.8);
    lit("<0,0,-9> rgb .8 parallel point_at <9,0,0>", 0.565682);
    lit("<0,0,-9> rgb .8 spotlight point_at <100,0,-9> shadowless", 0.8);
    lit("<0,0,-9> rgb .8 shadowless spotlight point_at <100,0,-9>", 0.0);
}

#[test]
fn area_light_shadows() {
    let half = |n: u32, u: f64, expected: f32| {
        let sheet = format!("box{{<{u},-9,-5>,<9,9,-4.9999> no_image}}");
        let light = format!("<0,0,-10> rgb .8 area_light <4,0,0>,<0,4,0>,{n},1");
        check_grey(&format!("{CZ} {WALL} {sheet} light_source{{{light}}}"), expected);
    };
    half(3, -0.5, 0.2);
    half(3, 0.5, 0.6);
    for (u, expected) in [(-0.8, 0.100008), (-0.4, 0.300008), (0.0, 0.4), (0.4, 0.500008), (0.8, 0.700008)] {
        half(6, u, expected);
    }
    let strip = |grid: &str, expected: f32| {
        let light = format!("<0,0,-10> rgb .8 area_light <4,0,0>,<0,4,0>,{grid}");
        let scene = format!("{CZ} {WALL} box{{<-.25,-9,-5.1>,<.25,9,-5> no_image}} light_source{{{light}}}");
        check_grey(&scene, expected);
    };
    strip("5,1", 0.6);
    strip("5,5 adaptive 0", 0.8);
    strip("5,1 adaptive 1", 0.6);
    strip("9,9", 0.500008);
    strip("9,9 adaptive 0", 0.8);
    strip("9,9 adaptive 2", 0.500008);
}

/// Each sample shines along its own direction, and things are in its way up to its own plane.
#[test]
fn parallel_area_light_shadows() {
    let light = "light_source{<0,0,-5> rgb .8 area_light <4,0,0>,<0,4,0>,3,1 parallel point_at <0,0,-4>}";
    let behind_the_plane = "sphere{<4.025,0,-2.0125>,.2}";
    check_grey(&format!("{CZ} {WALL} {light} {behind_the_plane}"), 0.8);
    check_grey(&format!("{CZ} {WALL} {light} sphere{{<3.13,0,-1.565>,.2}}"), 0.6);
    check_grey(&format!("{CZ} {WALL} {light} {behind_the_plane} sphere{{<-3.13,0,-1.565>,.2}}"), 0.6);
}

#[test]
fn area_light_illumination() {
    lit("<0,1,-3> rgb .8 area_light <4,0,0>,<0,3,2>,5,3 area_illumination", 0.636500);
    lit("<0,1,-3> rgb .8 area_light <4,0,0>,<0,3,2>,5,3 area_illumination fade_distance 2 fade_power 2", 0.286091);
    lit("<0,1,-3> rgb .8 area_light <4,0,0>,<0,3,2>,5,3 fade_distance 2 fade_power 2", 0.433677);
    lit("<0,1,-3> rgb .8 area_light <4,0,0>,<0,3,2>,5,4 circular area_illumination", 0.670085);
    lit("<0,1,-3> rgb .8 area_light <4,0,0>,<0,3,2>,5,5 circular orient area_illumination", 0.672602);
    lit(
        "<0,0,-4> rgb .8 spotlight point_at 0 radius 10 falloff 40 area_light <4,0,0>,<0,1,0>,3,1 area_illumination",
        0.566705,
    );
    lit("<0,0,-4> rgb .8 parallel point_at 0 area_light <4,0,0>,<0,1,0>,3,1 area_illumination", 0.743694);
}

#[test]
fn samples_behind_the_surface_give_no_light() {
    let grid = |n: u32, m: u32| format!("<.01,0,-1.03> rgb .8 area_light <0,0,4>,<0,2,0>,{n},{m} area_illumination");
    lit("<0,0,-1> rgb .8 area_light <0,0,3>,<0,2,0>,2,1 area_illumination", 0.4);
    lit("<0,0,-1> rgb .8 area_light <0,0,3>,<0,2,0>,6,3 area_illumination", 0.513695);
    lit(&grid(5, 1), 0.631785);
    lit(&grid(3, 3), 0.474144);
    // Through a thin box they are in its shadow, too, and the mean shadow weakens all.
    let slab = "box{<-9,-9,0>,<9,9,.1> pigment{rgb 1} finish{ambient 0 diffuse 1}}";
    check_grey(&format!("{CZ} {slab} light_source{{{}}}", grid(5, 3)), 0.426383);
    // Without an area the word lights both sides.
    lit("<0,0,1> rgb .8 area_illumination", 0.8);
}

#[test]
fn light_through_a_window_object() {
    let window = "<0,0,-9.5> rgb .8 projected_through{disc{<0,0,-5>,z,1}}";
    for (q, expected) in [("-2", 0.0), ("-7", 0.8), ("-4.9995", 0.8)] {
        let blocker = format!("disc{{<0,0,{q}>,z,.5 no_image}}");
        check_grey(&format!("{CZ} {WALL} {blocker} light_source{{{window}}}"), expected);
    }
}

#[test]
fn light_groups() {
    let group = |more: &str| {
        format!("{CZ} light_source{{<0,0,-5> rgb .3}} light_group{{light_source{{<0,0,-5> rgb .4}} {WALL} {more}}}")
    };
    check_grey(&group(""), 0.4);
    check_grey(&group("global_lights on"), 0.700008);
}

#[test]
fn adaptive_samples_stop_at_small_differences() {
    for (brightness, expected) in [(".033", 0.016495), (".034", 0.021256)] {
        let sheet = "box{<.4,-9,-5>,<9,9,-4.9999> no_image}";
        let light = format!("<0,0,-10> rgb {brightness} area_light <4,0,0>,<0,4,0>,5,5 adaptive 0");
        check_grey(&format!("{CZ} {WALL} {sheet} light_source{{{light}}}"), expected);
    }
}

#[test]
fn light_groups_in_light_groups() {
    let nest = |outer: &str, inner: &str| {
        format!(
            "{CZ} light_source{{<0,0,-5> rgb .1}} light_group{{light_source{{<0,0,-5> rgb .4}} \
             light_group{{light_source{{<0,0,-5> rgb .2}} {WALL} {inner}}} {outer}}}"
        )
    };
    check_grey(&nest("", ""), 0.2);
    check_grey(&nest("", "global_lights on"), 0.2);
    check_grey(&nest("global_lights on", ""), 0.300008);
}
