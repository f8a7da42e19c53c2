//! Section 8 of the shading facts.

use super::*;

const CLEAR: &str = "pigment{rgbt 1} finish{ambient 0 diffuse 0}";
const BACKDROP: &str = "plane{y,-10 pigment{function{z/20} color_map{[0 rgb 0][1 rgb 1]}} \
    finish{ambient 0 diffuse 0 emission 1}}";

/// Clear objects above a graded backdrop.
fn above(objects: &str, expected: [f32; 3]) {
    check(&format!("{CY} {BACKDROP} {objects}"), expected);
}

fn slab(a: &str, b: &str, ior: &str) -> String {
    format!("box{{<-9,{a},-9>,<9,{b},9> {CLEAR} interior{{ior {ior}}}}}")
}

#[test]
fn surfaces_bend_rays() {
    for (ior, expected) in [("1", 0.500008), ("1.2", 0.364660), ("1.5", 0.267262), ("2.5", 0.147448), (".8", 0.944915)]
    {
        above(&format!("plane{{y,0 {CLEAR} interior{{ior {ior}}}}}"), [expected; 3]);
    }
}

#[test]
fn objects_in_objects() {
    above(&slab("-2", "0", "1.5"), [0.453452; 3]);
    above(&format!("{} {}", slab("-3", "0", "1.5"), slab("-2", "-1", "1.2")), [0.439918; 3]);
    above(&format!("{} {}", slab("-2", "0", "1.5"), slab("-3", "-1", "1.2")), [0.449653; 3]);
    above(&format!("{} {}", slab("-3", "-1", "1.2"), slab("-2", "0", "1.5")), [0.449653; 3]);
}

#[test]
fn the_camera_may_be_inside() {
    let camera = "camera{location <0,1,-1> look_at 0 right x up y angle 1}";
    check_grey(&format!("{camera} {BACKDROP} {}", slab("0", "3", "1.2")), 0.801785);
}

#[test]
fn legacy_keywords() {
    let floor = |more: &str| format!("plane{{y,0 pigment{{rgbt 1}} {more}}}");
    above(&floor("finish{ambient 0 diffuse 0 ior 1.5 refraction .5}"), [0.133623; 3]);
    above(&floor("finish{ambient 0 diffuse 0} interior{ior 1.5 refraction .5}"), [0.267262; 3]);
}

#[test]
fn dispersion_spreads_colours() {
    let floor = |interior: &str, expected: [f32; 3]| {
        above(&format!("plane{{y,0 {CLEAR} interior{{{interior}}}}}"), expected);
    };
    floor("ior 1.5 dispersion 1.1", [0.274113, 0.269993, 0.258625]);
    floor("ior 1.5 dispersion 1.5", [0.306294, 0.279881, 0.236347]);
    floor("ior 2 dispersion .8", [0.176379, 0.185214, 0.200397]);
    floor("ior 1.5 dispersion 1.2 dispersion_samples 2", [0.280613, 0.275074, 0.251652]);
    floor("ior 1.5 dispersion 1.2 dispersion_samples 14", [0.282414, 0.272602, 0.251926]);
    floor("ior 1 dispersion 1.3", [0.579019, 0.524880, 0.443824]);
    floor("dispersion 1.5", [0.500008; 3]);
    let glass = format!("box{{<-9,-2,-9>,<9,0,9> {CLEAR} interior{{ior 1.5 dispersion 1.2}}}}");
    above(&glass, [0.454002, 0.454520, 0.448875]);
}

#[test]
fn light_fades_inside() {
    let filled = |interior: &str, more: &str, expected: [f32; 3]| {
        let glass = format!("box{{<-9,-9,0>,<9,9,2> {CLEAR} interior{{{interior}}}}}");
        check(&format!("{CZ} background{{rgb .8}} {glass} {more}"), expected);
    };
    filled("fade_distance 1 fade_power 1", "", [0.266667; 3]);
    filled("fade_distance 1 fade_power 0", "", [0.4; 3]);
    filled("fade_distance 1 fade_power 2 fade_color <.5,.2,0>", "", [0.480003, 0.287999, 0.160006]);
    filled("fade_distance 1 fade_power 1000 fade_color <.5,.2,0>", "", [0.294301, 0.161517, 0.108263]);
    let inner = format!("box{{<-9,-9,1>,<9,9,1.5> {CLEAR}}}");
    filled("fade_distance 1 fade_power 2", &inner, [0.639994; 3]);
    let lamp = "light_source{<0,0,-9.5> rgb .8}";
    let glass = format!("box{{<-9,-9,-4>,<9,9,-2> {CLEAR} interior{{fade_distance 1 fade_power 2}} no_image}}");
    check_grey(&format!("{CZ} {WALL} {lamp} {glass}"), 0.160006);
}

#[test]
fn interiors_of_solids() {
    let bare = |a: &str, b: &str, more: &str| format!("box{{<-9,{a},-9>,<9,{b},9> {more}}}");
    let glass = "interior{ior 1.5}";
    let (upper, lower) = (bare("-2", "0", ""), bare("-3", "-1", ""));
    above(&format!("union{{{upper} {lower} {CLEAR} {glass}}}"), [0.453452; 3]);
    above(&format!("merge{{{upper} {lower} {CLEAR} {glass}}}"), [0.430182; 3]);
    above(&format!("{} {}", slab("-2", "0", "1.5"), slab("-3", "-1", "1.5")), [0.430182; 3]);
}

#[test]
fn legacy_refraction_counts_in_maps_only() {
    let map = "texture{gradient x texture_map{[0 pigment{rgbt 1} finish{ambient 0 diffuse 0}]\
        [1 pigment{rgbt 1} finish{ambient 0 diffuse 0}]}}";
    above(&format!("plane{{y,0 {map} interior{{ior 1.5 refraction .5}}}}"), [0.133623; 3]);
}

#[test]
fn dispersion_and_total_reflection() {
    let water = "plane{y,0 pigment{rgbf <1,.5,.25,.5>} finish{ambient 0 diffuse 0 reflection .3} \
        interior{ior .5 dispersion 1.1}}";
    check(&format!("{CY} {BG} {water}"), [0.159380, 0.220005, 0.254719]);
}

#[test]
fn fresnel_in_nests() {
    let lamp = "plane{z,-20 pigment{rgb 1} finish{ambient 0 diffuse 0 emission 5}}";
    let mirror = "finish{ambient 0 diffuse 0 reflection{0,1 fresnel}}";
    let glass = |a: u32, b: u32, ior: &str, finish: &str| {
        format!("box{{<-9,-9,{a}>,<9,9,{b}> pigment{{rgbt 1}} {finish} interior{{ior {ior}}}}}")
    };
    let plain = "finish{ambient 0 diffuse 0}";
    let nest = |objects: &str, expected: f32| {
        check_grey(&format!("{CZ} global_settings{{max_trace_level 30}} {lamp} {objects}"), expected);
    };
    nest(&glass(0, 4, "1.5", mirror), 0.4);
    nest(&format!("{} {}", glass(0, 4, "1.5", mirror), glass(2, 8, "2", plain)), 0.302037);
    nest(&format!("{} {}", glass(0, 10, "1.5", plain), glass(2, 4, "2", mirror)), 0.102037);
}

#[test]
fn fading_has_its_limits() {
    let filled = |interior: &str, more: &str, expected: f32| {
        let glass = format!("box{{<-9,-9,0>,<9,9,2> {CLEAR} interior{{{interior}}}}}");
        check_grey(&format!("{CZ} background{{rgb .8}} {glass} {more}"), expected);
    };
    filled("fade_distance 1 fade_power 2", "", 0.160006);
    filled("fade_distance 1 fade_power -1", "", 0.533333);
    filled("fade_distance 3 fade_power 999 fade_color <.5,.2,0>", "", 0.8);
    let opaque = "box{<-9,-9,1>,<9,9,1.5> pigment{rgb 1} finish{ambient .5 diffuse 0}}";
    filled("fade_distance 1 fade_power 2", opaque, 0.500008);
    let around = |more: &str, expected: f32| {
        let glass = format!("box{{<-9,-9,-4>,<9,9,2> {CLEAR} interior{{fade_distance 1 fade_power 2}} {more}}}");
        check_grey(&format!("{CZ} {WALL} light_source{{<0,0,-9.5> rgb .8}} {glass}"), expected);
    };
    around("", 0.047059);
    around("no_image", 0.8);
}
