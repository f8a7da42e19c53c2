//! Section 4 of the shading facts.

use super::*;

/// The wall under a light with a tilted disc between; textures of the disc as given.
fn behind(texture: &str, expected: [f32; 3]) {
    let disc = format!("disc{{<0,2.5,-2.5>,<0,1,-1>,1 {texture}}}");
    check(&format!("{CZ} {WALL} light_source{{<0,5,-5> rgb .8}} {disc}"), expected);
}

#[test]
fn transparent_things_filter_light() {
    behind("pigment{rgbf <1,.5,.25,.6>}", [0.339406, 0.169711, 0.084855]);
    behind("pigment{rgbt <1,.5,.25,.6>}", [0.339406; 3]);
    behind("pigment{rgbft <1,.5,.25,.6,.3>}", [0.509117, 0.339406, 0.254551]);
    behind("pigment{rgbft <1,.5,.25,.6,.7>}", [0.735393, 0.565682, 0.480827]);
    behind(
        "pigment{rgbf <1,.5,.25,.6>} finish{reflection .9 conserve_energy diffuse .2}",
        [0.339406, 0.169711, 0.084855],
    );
    behind("texture{pigment{rgbf <1,.5,.25,.6>}} texture{pigment{rgbt <.2,.3,.4,.7>}}", [0.237583, 0.118791, 0.059403]);
}

#[test]
fn blends_of_textures_filter_light() {
    let map = "texture{gradient x translate -.5*x texture_map{[0 pigment{rgbf <1,.5,.25,.6>}][1 pigment{rgbt <.2,.3,.4,.7>}]}}";
    behind(map, [0.367697, 0.282841, 0.240421]);
    let average = "texture{average texture_map{[1 pigment{rgbf <1,.5,.25,.6>}][3 pigment{rgbt <.2,.3,.4,.7>}]}}";
    behind(average, [0.381842, 0.339406, 0.318196]);
}

#[test]
fn both_faces_of_a_box_filter() {
    for interior in ["", "interior{ior 2}"] {
        let glass =
            format!("box{{-.5,.5 rotate 45*x translate <0,2.5,-2.5> pigment{{rgbf <1,.5,.25,.6>}} {interior}}}");
        check(&format!("{CZ} {WALL} light_source{{<0,5,-5> rgb .8}} {glass}"), [0.203647, 0.050904, 0.012726]);
    }
}

#[test]
fn the_side_of_a_sheet_decides() {
    let textures = "texture{pigment{rgbt .5}} interior_texture{pigment{rgbt .9}}";
    behind(textures, [0.509117; 3]);
    let flipped = format!("disc{{<0,2.5,-2.5>,<0,-1,1>,1 {textures}}}");
    check_grey(&format!("{CZ} {WALL} light_source{{<0,5,-5> rgb .8}} {flipped}"), 0.282841);
}

#[test]
fn faked_caustics() {
    let sheet = |interior: &str, expected: f32| {
        let disc = format!("disc{{<0,0,-2.5>,<0,1,-1>,1 pigment{{rgbt <1,1,1,.3>}} {interior} no_image}}");
        check_grey(&format!("{CZ} {WALL} light_source{{<0,0,-5> rgb .8}} {disc}"), expected);
    };
    sheet("interior{caustics .1}", 0.290455);
    sheet("interior{caustics 1}", 0.239994);
    sheet("finish{caustics 1}", 0.409705);
}
