//! Sections 8 and 14 of the pattern facts: bumps, the spaces in which they lie, and what sees them.
//!
//! A plane is seen from above, lit from one side, at the point (0.3, 0.7, -1.2).

use super::*;

const ABOVE: &str = "camera{orthographic location <0.3,5,-1.2> direction -y up 0.001*z right 0.001*x} \
    light_source{<1,1.5,0.2>*1e7 rgb 1}";
/// White, diffuse.
const F: &str = "pigment{rgb 1} finish{ambient 0 diffuse 0.6} ";
/// Shows its pigment as it is.
const FLAT: &str = "finish{ambient 1 diffuse 0}";
/// A pattern that changes nothing but what stands in it or, in POV-Ray's way, after it.
const STRETCHED: &str = "checker texture{pigment{rgb 1} finish{ambient 0 diffuse 0.6}} texture{pigment{rgb 1} finish{ambient 0 diffuse 0.6}} \
     scale <1,4,1>";

/// Objects seen from above.
fn scene(objects: &str, expected: f32) {
    check_grey(&format!("{ABOVE} {objects}"), expected);
}

/// A plane with a texture.
fn plane(texture: &str, expected: f32) {
    scene(&format!("plane{{y,0.7 texture{{{texture}}}}}"), expected);
}

#[test]
fn bumps_bend_the_light() {
    plane(F, 0.496193);
    for (normal, expected) in [
        ("bumps 0.5", 0.504341),
        ("bumps 0.5 scale <2,0.5,1>", 0.474311),
        ("bumps 0.5 no_bump_scale scale <2,0.5,1>", 0.449943),
        ("onion 0.6", 0.493660),
        ("quilted 0.7 rotate 30*x", 0.394461),
        ("waves 0.7", 0.432731),
        ("checker normal{bumps 0.5} normal{dents 0.9}", 0.504341),
        ("gradient x normal_map{[0.2 bumps 0.3][0.6 quilted 0.7]}", 0.492653),
        ("average normal_map{[1 bumps 0.3][2.5 quilted 0.7]}", 0.473259),
    ] {
        plane(&format!("{F} normal{{{normal}}}"), expected);
    }
    let entries = format!("[0 {F} normal{{bumps 0.5}}][1 {F} normal{{bumps 0.5}}]");
    plane(&format!("bozo texture_map{{{entries}}} scale <2,0.5,1>"), 0.474311);
    plane(&format!("bozo texture_map{{{entries}}} no_bump_scale scale <2,0.5,1>"), 0.826169);
}

#[test]
fn slopes_see_bumps() {
    for (pigment, expected) in [
        ("pigment{slope <1,2,-1>}", 0.804089),
        ("pigment{slope <1,2,-1>} normal{bumps 0.5}", 0.780606),
        ("pigment{aoi}", 1.0),
        ("pigment{aoi} normal{quilted 0.7}", 0.935409),
        ("pigment{slope{<1,2,-1>,0.1,0.8 altitude <0,0.5,0.2>,-3,2}}", 0.940063),
        ("pigment{slope{point_at <3,20,4>}}", 0.906188),
        // Slope cuts what is longer than 1 off, aoi takes the direction alone.
        ("pigment{slope <1,2,-1>} normal{bumps 0.8 no_bump_scale scale <2,0.3,1>}", 0.681849),
        ("pigment{aoi} normal{bumps 0.8 no_bump_scale scale <2,0.3,1>}", 0.916503),
        ("pigment{aoi} normal{bumps 0.8 no_bump_scale scale <1,3,1>}", 0.896330),
    ] {
        plane(&format!("{pigment} {FLAT}"), expected);
    }
    let entry = format!("pigment{{aoi}} normal{{bumps 0.8 scale <2,0.3,1>}} {FLAT}");
    plane(&format!("average texture_map{{[1 {entry}]}} no_bump_scale rotate 30*z scale <1,1.5,1>"), 0.883131);
}

#[test]
fn spaces_of_earlier_textures_stay() {
    let bumpy = format!("{F} normal{{bumps 0.8}}");
    let pair = |low: &str, high: &str| format!("gradient x texture_map{{[0 {low}][1 {high}]}}");
    let mean = |items: &[&str]| format!("average texture_map{{[1 {}]}}", items.join("][1 "));
    // The upper entry comes first; its pattern's space stays for the bumps of the lower one.
    plane(&pair(&bumpy, F), 0.503136);
    plane(&pair(&bumpy, STRETCHED), 0.477119);
    plane(&pair(F, &bumpy), 0.499168);
    plane(&pair(STRETCHED, &bumpy), 0.499168);
    plane(&mean(&[&bumpy, STRETCHED]), 0.501152);
    plane(&mean(&[STRETCHED, &bumpy]), 0.482567);
    plane(&mean(&[STRETCHED, STRETCHED, &bumpy]), 0.420432);
    let tilted = format!("checker texture{{{bumpy}}} texture{{{bumpy}}} rotate 25*x");
    plane(&pair(&tilted, STRETCHED), 0.547768);
    // Spaces within spaces stay together, and the object's own stands outside of all.
    let inner = format!("checker texture{{{F}}} texture{{{F}}} rotate 30*z");
    let nested = format!("checker texture{{{inner}}} texture{{{inner}}} scale <1,4,1>");
    plane(&pair(&bumpy, &nested), 0.410788);
    plane(&mean(&[&nested, &bumpy]), 0.435187);
    let upper = format!("average texture_map{{[1 {STRETCHED}][2 {bumpy}]}} rotate 20*x");
    plane(&mean(&[&upper, &bumpy]), 0.486671);
    let both = mean(&[STRETCHED, &bumpy]);
    scene(&format!("sphere{{0,1 texture{{{both}}} scale <3,0.7,4>}}"), 0.490715);
    // So with tiles and looked-up points, too.
    let tiles = format!("tiles{{texture{{{F}}} tile2 texture{{{F}}}}} scale <1,4,1>");
    plane(&mean(&[&tiles, &bumpy]), 0.482567);
    plane(&mean(&[&format!("uv_mapping {STRETCHED}"), &bumpy]), 0.482567);
    // But slopes take the bumps before they come out of these spaces.
    let sloped = format!("pigment{{slope <1,2,-1>}} {FLAT}");
    plane(&mean(&[STRETCHED, &bumpy, &sloped]), 0.577676);
}

#[test]
fn no_bump_scale_reaches_what_is_inside() {
    let bumps = "normal{bumps 0.5 scale <1,1.5,1>}";
    let (entry, end) = (format!("{F} {bumps}"), "scale <2,0.5,1>");
    plane(&format!("{entry} {end}"), 0.486427);
    for flagged in [
        format!("{entry} {end} no_bump_scale"),
        format!("{entry} no_bump_scale {end}"),
        format!("no_bump_scale {entry} {end}"),
        format!("{F} no_bump_scale {bumps} {end}"),
    ] {
        plane(&flagged, 0.483406);
    }
    // A later normal statement starts from the earlier one.
    plane(&format!("{F} {bumps} no_bump_scale {bumps} {end}"), 0.508492);
    let map = format!("bozo texture_map{{[0 {entry}][1 {entry}]}}");
    plane(&format!("{map} {end}"), 0.486427);
    plane(&format!("{map} {end} no_bump_scale"), 0.952590);
    plane(&format!("no_bump_scale checker texture{{{entry}}} texture{{{entry}}} {end}"), 0.952590);
    plane(&format!("bozo texture_map{{[0 {entry} no_bump_scale][1 {entry} no_bump_scale]}} {end}"), 0.489555);
    let nested = |inner: &str, outer: &str| {
        let blocks = format!("checker texture{{{entry}}} texture{{{entry}}} {inner} scale <1,3,1>");
        format!("average texture_map{{[1 {blocks}]}} {outer} {end}")
    };
    plane(&nested("", "no_bump_scale"), 0.344549);
    plane(&nested("no_bump_scale", ""), 0.506661);
    plane(&nested("no_bump_scale", "no_bump_scale"), 0.344549);
    // Normals in a map likewise; the textures of a material_map stay out of it.
    let inner = format!("[1 bumps 0.5 {end}]");
    for normal in [
        format!("normal{{average normal_map{{{inner}}} no_bump_scale scale <1,3,1>}}"),
        format!("normal{{average normal_map{{{inner}}} scale <1,3,1>}} no_bump_scale"),
        format!("normal{{checker normal{{bumps 0.5 {end}}} normal{{bumps 0.5 {end}}} no_bump_scale scale <1,3,1>}}"),
    ] {
        plane(&format!("{F} {normal}"), 0.512291);
    }
    // Of layers it is the uppermost that is meant.
    let film = format!("pigment{{rgbt 0.5}} finish{{ambient 0 diffuse 0.6}} {bumps}");
    let layers = |texture: &str, expected: f32| {
        scene(&format!("#declare T=texture{{{entry}}}texture{{{film}}} plane{{y,0.7 texture{{{texture}}}}}"), expected);
    };
    layers(&format!("T {end}"), 0.364813);
    layers(&format!("T no_bump_scale {end}"), 0.364065);
    layers(&format!("bozo texture_map{{[0 T][1 T]}} no_bump_scale {end}"), 0.720256);
    // The flag counts as the texture moves with its object.
    scene(
        &format!("sphere{{0,1 texture{{average texture_map{{[1 {entry}]}} no_bump_scale}} scale <3,0.7,4>}}"),
        0.642023,
    );
    scene(&format!("sphere{{0,1 texture{{{entry} no_bump_scale}} scale <3,0.7,4>}}"), 0.479011);
}

#[test]
fn a_texture_may_begin_with_a_transformation() {
    plane(&format!("scale <2,0.5,1> {F} normal{{bumps 0.5 scale <1,1.5,1>}}"), 0.515221);
}

/// A film of clear textures above the plane, with faked caustics.
fn film(texture: &str, expected: [f32; 3]) {
    let film = format!("plane{{y,1.5 texture{{{texture}}} interior{{caustics 0.02}} no_image}}");
    check(&format!("{ABOVE} plane{{y,0.7 texture{{{F}}}}} {film}"), expected);
}

#[test]
fn shadows_keep_spaces_and_bumps_too() {
    let clear = "pigment{rgbf <0.9,0.8,0.7,0.9>}";
    let bumpy = format!("{clear} normal{{bumps 0.8}}");
    let stretched = format!("checker texture{{{clear}}} texture{{{clear}}} scale <1,4,1>");
    let sloped = "pigment{slope <1,2,-1> color_map{[0 rgbf <1,0.3,0.4,0.9>][1 rgbf <0.2,0.8,0.3,0.5>]}}";
    film(&bumpy, [0.714214, 0.634852, 0.555505]);
    let mean = |a: &str, b: &str| format!("average texture_map{{[1 {a}][1 {b}]}}");
    film(&mean(&stretched, &bumpy), [0.669017, 0.594690, 0.520348]);
    film(&mean(&bumpy, &stretched), [0.727443, 0.646616, 0.565789]);
    film(&mean(&bumpy, sloped), [0.640131, 0.475151, 0.412604]);
    let map = |low: &str, high: &str| format!("bozo texture_map{{[0.3 {low}][0.6 {high}]}}");
    film(&map(&stretched, &bumpy), [0.714900, 0.635462, 0.556023]);
    film(&map(&bumpy, &stretched), [0.736980, 0.655085, 0.573205]);
    film(&map(sloped, &bumpy), [0.710414, 0.626658, 0.548150]);
    film(&map(&bumpy, sloped), [0.635615, 0.307607, 0.292729]);
    // In its own layer a pigment comes before the bumps.
    film(&format!("{sloped} normal{{bumps 0.8}}"), [0.610925, 0.288304, 0.275593]);
}

#[test]
fn the_last_part_of_a_blob_comes_first() {
    let blob = |a: &str, b: &str, rest: &str| {
        let parts = format!("sphere{{<-0.5,1,-1.2>,4,1 texture{{{a}}}}} sphere{{<0.9,1,-1>,4,1 texture{{{b}}}}}");
        format!("{ABOVE} blob{{threshold 0.2 {parts} {rest}}}")
    };
    let bumpy = format!("{F} normal{{bumps 0.8}}");
    let sloped = format!("pigment{{slope <1,2,-1>}} {FLAT}");
    check_grey(&blob(&bumpy, &sloped, ""), 0.636728);
    check_grey(&blob(&sloped, &bumpy, ""), 0.612772);
    // Each texture begins with spaces of its own.
    check_grey(&blob(STRETCHED, &bumpy, ""), 0.468849);
    // Clear parts let light through whatever the blob's own texture is.
    let clear = "pigment{rgbf <0.9,0.8,0.7,0.9>}";
    let shade = |a: &str, b: &str, caustics: f32, expected: [f32; 3]| {
        let rest = format!("no_image interior{{caustics {caustics}}}");
        check(&format!("{} plane{{y,0.7 texture{{{F}}}}}", blob(a, b, &rest)), expected);
    };
    shade(clear, clear, 0.0, [0.401907, 0.357256, 0.312604]);
    let sloped = "pigment{slope <1,2,-1> color_map{[0 rgbf <1,0.3,0.4,0.9>][1 rgbf <0.2,0.8,0.3,0.5>]}}";
    let bumpy = format!("{clear} normal{{bumps 0.8}}");
    shade(&bumpy, sloped, 0.02, [0.726497, 0.324819, 0.326604]);
    shade(sloped, &bumpy, 0.02, [0.798169, 0.701595, 0.614755]);
}
