//! Probe values of the shape facts in POV-Ray's language: what a scene learns about its own objects.

use super::host;
use crate::compile::Queries;
use crate::compiled::geometry::{RayKind, Scratch};
use crate::eval::{Options, evaluate};
use crate::math::{DVec3, Range, Ray};

/// POV-Ray printed nine decimals; some values went through single precision on the way.
const DIGITS: f64 = 2e-9;

/// What a scene prints, as numbers.
fn printed(text: &str) -> Vec<f64> {
    let text = format!("#version 3.7; {text}");
    let host = host(&text);
    let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default());
    read.unwrap_or_else(|failed| panic!("{:?}\n{text}", failed.diagnostics));
    host.messages().split_whitespace().map(|n| n.parse().unwrap_or(f64::NAN)).collect()
}

fn same(found: &[f64], expected: &[f64], digits: f64) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= digits * b.abs().max(1.0))
}

/// `trace(object, ray)` gives this point, and this normal where one is given; no hit is a normal of zero.
fn traced(object: &str, ray: &str, point: [f64; 3], normal: Option<[f64; 3]>) {
    let found = printed(&format!(
        "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, {ray}, N);
        #debug vstr(3, P, \" \", 0, 15) #debug \" \" #debug vstr(3, N, \" \", 0, 15)"
    ));
    let normals = normal.is_none_or(|n| same(&found[3..], &n, DIGITS));
    assert!(same(&found[..3], &point, DIGITS) && normals, "{object}, {ray}: {found:?}, expected {point:?} {normal:?}");
}

/// The ray meets nothing.
fn missed(object: &str, ray: &str) {
    traced(object, ray, [0.0; 3], Some([0.0; 3]));
}

/// Along z a hit has this z, and this normal.
fn depth(object: &str, ray: &str, z: f64, normal: Option<[f64; 3]>) {
    let found = printed(&format!(
        "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, {ray}, z, N);
        #debug str(P.z, 0, 15) #debug \" \" #debug vstr(3, N, \" \", 0, 15)"
    ));
    let normals = match normal {
        Some(n) => same(&found[1..], &n, DIGITS),
        None => found[1..] != [0.0; 3],
    };
    assert!(same(&found[..1], &[z], DIGITS) && normals, "{object}, {ray}: {found:?}, expected {z} {normal:?}");
}

/// `inside(object, point)` for each point.
fn within(object: &str, points: &[(&str, f64)]) {
    for (point, expected) in points {
        let found = printed(&format!("#declare O = {object} #debug str(inside(O, {point}), 0, 0)"));
        assert_eq!(found, [*expected], "{object}, {point}");
    }
}

/// The numbers that a scene prints.
fn prints(text: &str, expected: &[f64], digits: f64) {
    let found = printed(text);
    assert!(same(&found, expected, digits), "{text}: {found:?}, expected {expected:?}");
}

/// Corners of `min_extent` and `max_extent`, in single precision.
fn extent(object: &str, min: [f64; 3], max: [f64; 3]) {
    let text = format!(
        "#declare O = {object} #debug vstr(3, min_extent(O), \" \", 0, 12) #debug \" \"
        #debug vstr(3, max_extent(O), \" \", 0, 12)"
    );
    prints(&text, &[min, max].concat(), 1e-6);
}

#[test]
fn nearest_hits_of_trace() {
    depth("sphere { 0, 1 }", "<0, 0, -1.00005>", 1.0, None);
    depth("sphere { 0, 1 }", "<0, 0, -1.00015>", -1.0, None);
    depth("sphere { 0, 1.01e-5 }", "-5*z", -1.01e-5, None);
    depth("sphere { 0, 1 scale <1, 2, 1>*1e-5 }", "-5*z", -1e-5, None);
    depth("sphere { 0, 1 }", "-9.9e6*z", -1.0, None);
    depth("box { 0, 1 }", "<0, .5, -5>", 0.0, None);
    depth("intersection { box { 0, 1 } box { -5, 5 } }", "<1e-9, .5, -5>", 0.0, None);
    // POV-Ray loses this one: 0 times infinity in its test of the box.
    depth("intersection { box { 0, 1 } box { -5, 5 } }", "<0, .5, -5>", 0.0, None);
    depth("box { -1, 1 }", "-1.9e10*z", -1.0, None);
    depth("superellipsoid { <.5, .5> scale 1e3 }", "-1000.15*z", -1000.0, None);
    depth("torus { 2, .5 rotate 90*x }", "<2, 0, -5>", -0.5, None);
}

#[test]
fn round_shapes() {
    within("sphere { 0, 1 inverse }", &[("x", 0.0), ("1.01*x", 1.0)]);
    within(
        "ovus { 1, .5 }",
        &[("-y", 0.0), ("-.99*y", 1.0), ("1.49*y", 1.0), ("<.9, .5, 0>", 1.0), ("<.91, .5, 0>", 0.0)],
    );
    within("cone { 0, 2, 4*y, 1 }", &[("<1.5, 2, 0>", 0.0), ("<1.49, 2, 0>", 1.0), ("0", 0.0)]);
    within("cylinder { 0, y, 1 }", &[("x", 0.0), (".5*y", 1.0), ("y", 0.0)]);
    within("cylinder { 0, y, 1 open }", &[("x", 1.0), ("y", 1.0)]);
    within("disc { y, y, 2, .5 }", &[("0", 1.0), ("10*x", 1.0), ("2*y", 0.0)]);
    // Spindles hold the points of both regions.
    within("torus { .5, 1 }", &[("0", 1.0), ("<0, .8, 0>", 1.0), ("<0, .9, 0>", 0.0), ("1.5*x", 1.0)]);
    // Radii of opposite sign make two cones.
    traced("cone { 0, 1, 2*y, -1 }", "<-5, .5, 0>, x", [-0.5, 0.5, 0.0], None);
    traced("cone { 0, 1, 2*y, -1 }", "<-5, 1.5, 0>, x", [-0.5, 1.5, 0.0], None);
    traced("cylinder { 0, y, -1 }", "<-5, .5, 0>, x", [-1.0, 0.5, 0.0], Some([-1.0, 0.0, 0.0]));
    traced("torus { 2, .5 }", "<-5, .1, 0>, x", [-2.489_897_949, 0.1, 0.0], Some([-0.979_795_897, 0.2, 0.0]));
    traced("torus { 2, .5 sturm }", "<-5, .1, 0>, x", [-2.489_897_949, 0.1, 0.0], None);
    extent("ovus { 1, .5 }", [-1.007_843_256, -1.0, -1.007_843_256], [1.007_843_256, 1.5, 1.007_843_256]);
    extent("ovus { 1, 1.5 }", [-1.547_631_264, -1.0, -1.547_631_264], [1.547_631_264, 2.5, 1.547_631_264]);
    // Too large a top leaves only its sphere.
    depth("ovus { 1, 2.5 }", "<0, 1, -5>", -2.5, None);
}

#[test]
fn planes_by_grazing_rays() {
    // POV-Ray gives up at a slope of 1e-10, and at a distance of 1e7.
    traced("plane { y, 0 }", "<0, 1, 0>, <1, -.9e-10, 0>", [1.0 / 0.9e-10, 0.0, 0.0], Some([0.0, 1.0, 0.0]));
    within("plane { y, 0 inverse }", &[("0", 1.0), ("y", 1.0), ("-y", 0.0)]);
    within("plane { <0, 2, 0>, 3 }", &[("3*y", 1.0), ("3.1*y", 0.0)]);
}

#[test]
fn polynomials() {
    let quartic = "polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(0, 0, 0): -1 }";
    for distance in ["5", "1e3", "1e4", "1e5"] {
        depth(quartic, &format!("<.3, .2, -{distance}>"), -0.997_566_129, None);
    }
    // POV-Ray drops coefficients below 1e-10, and misses a single linear term and fourfold roots.
    let faint = "polynomial { 4, xyz(4, 0, 0): 1e-11, xyz(0, 4, 0): 1e-11, xyz(0, 0, 4): 1e-11, xyz(0, 0, 0): -1e-11 }";
    depth(faint, "<.3, .2, -5>", -0.997_566_129, None);
    depth("polynomial { 3, xyz(0, 0, 1): 1, xyz(0, 0, 0): -1 }", "-5*z", 1.0, Some([0.0, 0.0, 1.0]));
    depth("polynomial { 2, xyz(0, 0, 1): 1, xyz(0, 0, 0): -1 }", "-5*z", 1.0, Some([0.0, 0.0, 1.0]));
    depth("poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> }", "-5*z", -1.0, Some([0.0, 0.0, -1.0]));
    depth("cubic { <0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,0, 1,0,0,-8> }", "-5*z", 2.0, Some([0.0, 0.0, 1.0]));
    within("quadric { 1, 0, 0, -1 inverse }", &[("x", 0.0), ("0", 0.0), ("2*x", 1.0)]);
}

#[test]
fn superellipsoids() {
    depth(
        "superellipsoid { <.5, .25> }",
        "<.3, .2, -5>",
        -0.999_988_238,
        Some([0.000_261_922, 0.000_077_606, -0.999_999_963]),
    );
    let star = "superellipsoid { <2, 2> }";
    let side = 1.0 / 3f64.sqrt();
    depth(star, "<.3, .2, -5>", -0.5, Some([side, side, -side]));
    within(star, &[("<.1, .1, .1>", 1.0), ("<.4, .4, .4>", 0.0)]);
}

#[test]
fn triangles() {
    traced("triangle { 0, 2*x, 2*z }", "<.5, 5, .5>, -y", [0.5, 0.0, 0.5], Some([0.0, 1.0, 0.0]));
    traced("triangle { 0, 2*x, 2*z translate 0 }", "<.5, 5, .5>, -y", [0.5, 0.0, 0.5], Some([0.0, 1.0, 0.0]));
    traced("triangle { 0, 2*z, 2*x }", "<.5, 5, .5>, -y", [0.5, 0.0, 0.5], Some([0.0, -1.0, 0.0]));
    traced("triangle { 0, 2*z, 2*x translate y }", "<.5, 5, .5>, -y", [0.5, 1.0, 0.5], Some([0.0, 1.0, 0.0]));
    let smooth = |change: &str| format!("smooth_triangle {{ 0, -1, 2*x, <1, 0, -1>, 2*y, <0, 1, -1> {change} }}");
    depth(&smooth(""), "<.5, .5, -5>", 0.0, Some([-0.169_174_539, -0.169_174_539, -0.970_958_264]));
    depth(&smooth("scale <2, 1, 1>"), "<1, .5, -5>", 0.0, Some([-0.072_933_498, -0.208_121_457, -0.975_380_010]));
    // A normal at right angles to the face makes it vanish; in a mesh it counts.
    missed("smooth_triangle { 0, -z, x, <1, 0, .1>, y, <0, 1, -1> }", "<.25, .25, -3>, z");
}

#[test]
fn bounding_boxes() {
    extent("sphere { 0, 1 rotate 45*z }", [-1.0; 3], [1.0; 3]);
    // POV-Ray's box of a sphere in a `transform` holds its turned cube.
    extent("sphere { 0, 1 transform { rotate 45*z } }", [-1.0; 3], [1.0; 3]);
    let pair = [2.121_320_248, 2.121_320_248, 1.0];
    extent("union { sphere { x, 1 } sphere { -x, 1 } rotate 45*z }", pair.map(|v: f64| -v), pair);
    let pair = [1.707_106_829, 1.707_106_829, 1.0];
    extent("union { sphere { x, 1 rotate 45*z } sphere { -x, 1 rotate 45*z } }", pair.map(|v: f64| -v), pair);
    // POV-Ray's boxes of the next ones are wrong, and cut their surfaces away.
    traced(
        "intersection { quadric { <1, -1, 1>, 0, 0, -9 } box { <-50, -1, -50>, <50, 1, 50> } }",
        "<2.9, 9, 0>, -y",
        [2.9, 1.0, 0.0],
        None,
    );
    traced(
        "intersection { plane { y, 3 transform { rotate 90*z } } box { -10, 10 } }",
        "<7, 99, 0>, -y",
        [7.0, 10.0, 0.0],
        None,
    );
    depth("cylinder { <1e5 + .3, 0, 0>, <1e5 + .3, 1, 0>, .003 }", "<1e5 + .3, .5, -5>", -0.003, None);
}

#[test]
fn solids() {
    within(
        "difference { sphere { 0, 2 } difference { sphere { 0, 1 } sphere { 0, .5 } } }",
        &[("0", 1.0), (".7*z", 0.0), ("1.5*z", 1.0)],
    );
    // What coincides: boxes hold their boundary, spheres do not.
    let both = |word: &str, a: &str| format!("{word} {{ {a} {a} }}");
    missed(&both("intersection", "sphere { 0, 1 }"), "-5*z, z");
    depth(&both("intersection", "box { -1, 1 }"), "-5*z", -1.0, None);
    missed(&both("merge", "box { -1, 1 }"), "-5*z, z");
    depth(&both("merge", "sphere { 0, 1 }"), "-5*z", -1.0, None);
    missed(&both("difference", "sphere { 0, 1 }"), "-5*z, z");
    depth(&both("difference", "box { -1, 1 }"), "-5*z", -1.0, Some([0.0, 0.0, 1.0]));
    // A sheet has no inside: only it is left of what it is taken from.
    let cut = "difference { box { -1, 1 } triangle { <-.5, -.5, 0>, <.5, -.5, 0>, <0, .5, 0> } }";
    depth(cut, "-5*z", 0.0, None);
    missed(cut, "<.9, .9, -5>, z");
    // Clips are not turned with what they clip.
    within("sphere { 0, 1 clipped_by { plane { y, 0 } } inverse }", &[("-2*y", 1.0), ("2*y", 0.0), ("0", 0.0)]);
    within("union { sphere { 0, 1 } sphere { 3*x, 1 } inverse }", &[("1.5*x", 1.0), ("3*x", 0.0), ("0", 0.0)]);
    within("intersection { box { -1, 1 } box { 0, 2 } inverse }", &[(".5", 0.0), ("1.5", 1.0), ("-.5", 1.0)]);
}

/// The number of the object that a ray along z meets in a whole scene.
fn first_object(scene: &str) -> u32 {
    let text = format!("#version 3.7; {scene}");
    let read = evaluate("a.pov".as_ref(), &Options::default(), &host(&text), &Queries::default());
    let read = read.unwrap_or_else(|failed| panic!("{:?}\n{text}", failed.diagnostics));
    let geometry = crate::compile::geometry::compile(&read.scene).unwrap().geometry;
    let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
    let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Camera, &mut Scratch::default()).unwrap();
    geometry.surface(&ray, &hit).object.0
}

#[test]
fn of_coincident_objects_the_first_box_wins() {
    let (cube, wall, light) = ("box { <-1, -1, 0>, 1 }", "plane { -z, 0 }", "light_source { -9*z, 1 }");
    let deep = "union { box { <-1, -1, 0>, 1 } box { <3, -1, -2>, <4, 1, 1> } split_union off }";
    assert_eq!(first_object(&format!("{cube} {cube} {light}")), 0);
    assert_eq!(first_object(&format!("{wall} {wall} {light}")), 0);
    // What is infinite comes first, then what begins nearer.
    assert_eq!(first_object(&format!("{cube} {wall} {light}")), 1);
    assert_eq!(first_object(&format!("{wall} {cube} {light}")), 0);
    assert_eq!(first_object(&format!("{cube} {deep} sphere {{ 9*x, 1 }}")), 1);
    assert_eq!(first_object(&format!("{deep} {cube} sphere {{ 9*x, 1 }}")), 0);
    // Many of them, in whatever order the hierarchy holds them.
    let others: String = (0..20).map(|i| format!("{cube} sphere {{ <{i}, 5, 0>, 1 }} ")).collect();
    assert_eq!(first_object(&format!("sphere {{ 9*x, 1 }} {others} {light}")), 1);
}

#[test]
fn meshes() {
    depth("mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } }", "<.25, .25, -3>", 0.0, Some([0.0, 0.0, -1.0]));
    depth("mesh { triangle { <0,0,0>, <0,1,0>, <1,0,0> } }", "<.25, .25, -3>", 0.0, Some([0.0, 0.0, 1.0]));
    let one = "smooth_triangle { <0,0,0>, <0,0,-1>, <1,0,0>, <1,0,-1>, <0,1,0>, <0,1,-1>";
    // Normals in single precision: POV-Ray's differ in the eighth digit.
    let slopes = |object: &str, ray: &str, normal: [f64; 3]| {
        let text = format!(
            "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, {ray}, N); #debug vstr(3, N, \" \", 0, 12)"
        );
        prints(&text, &normal, 1e-7);
    };
    slopes(&format!("mesh {{ {one} }} }}"), "<.5, .25, -3>, z", [0.404_182_407, 0.202_091_222, -0.892_073_831]);
    let even = "smooth_triangle { <0,0,0>, <1,0,-1>, <1,0,0>, <1,0,-1>, <0,1,0>, <1,0,-1> }";
    let half = std::f64::consts::FRAC_1_SQRT_2;
    depth(&format!("mesh {{ {even} }}"), "<.25, .25, -3>", 0.0, Some([0.0, 0.0, -1.0]));
    depth(even, "<.25, .25, -3>", 0.0, Some([half, 0.0, -half]));
    let steep = "smooth_triangle { <0,0,0>, <0,0,-1>, <1,0,0>, <1,0,.1>, <0,1,0>, <0,1,-1> }";
    missed(steep, "<.25, .25, -3>, z");
    slopes(&format!("mesh {{ {steep} }}"), "<.25, .25, -3>, z", [0.345_597_059, 0.245_592_878, -0.905_674_782]);
    let slope = |object: &str, x: f64| {
        let text = format!(
            "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, <.25, .25, -9>, z, N); #debug str(N.x, 0, 12)"
        );
        prints(&text, &[x], 1e-7);
    };
    slope(&format!("{one} scale <1, 1, 3> }}"), 0.321_083_921);
    // Under a matrix POV-Ray keeps the lengths of the normals of a single triangle: 0.4667.
    slope(&format!("{one} matrix <1, 0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0> }}"), 0.321_083_921);
    slope(&format!("mesh {{ {one} }} scale <1, 1, 3> }}"), 0.466_739_029);
    // The inside vector stays in world space.
    let sheet = |turn: &str| format!("mesh {{ triangle {{ <-5,-5,1>, <5,-5,1>, <0,9,1> }} inside_vector z {turn} }}");
    within(&sheet(""), &[("0", 1.0)]);
    for turn in ["rotate 90*x", "rotate 180*x", "scale <1, 1, -1>"] {
        within(&sheet(turn), &[("0", 0.0)]);
    }
    let quads = |rest: &str| {
        let quad = |z: i32| {
            format!(
                "triangle {{ <-4,-4,{z}>, <4,-4,{z}>, <4,4,{z}> }} triangle {{ <-4,-4,{z}>, <4,4,{z}>, <-4,4,{z}> }}"
            )
        };
        format!("intersection {{ mesh {{ {} {} {rest} }} box {{ <-5,-5,.5>, <5,5,9> }} }}", quad(0), quad(1))
    };
    depth(&quads("hierarchy off"), "<.2, .1, -5>", 1.0, None);
    depth(&quads("inside_vector z"), "<.2, .1, -5>", 0.5, None);
}

#[test]
fn height_fields() {
    let field = |rest: &str| format!("height_field {{ function {rest} }}");
    traced(
        &field("5, 5 { x*.5 }"),
        "<.1, 5, .3>, -y",
        [0.1, 0.049_993_896, 0.3],
        Some([-0.447_169_921, 0.894_449_027, 0.0]),
    );
    traced(&field("5, 5 { x*.5 }"), "<.9, 5, .3>, -y", [0.9, 0.449_984_741, 0.3], None);
    traced(
        &field("5, 5 { y*.5 }"),
        "<.3, 5, .1>, -y",
        [0.3, 0.449_984_741, 0.1],
        Some([0.0, 0.894_427_191, 0.447_213_595]),
    );
    traced(&field("5, 5 { y*.5 }"), "<.3, 5, .9>, -y", [0.3, 0.049_993_896, 0.9], None);
    for (value, height) in [("1.5", 0.499_969_482), ("-.25", 0.750_015_259), ("1", 0.999_984_741)] {
        traced(&field(&format!("5, 5 {{ {value} }}")), "<.3, 5, .4>, -y", [0.3, height, 0.4], None);
    }
    let smooth = [-0.152_215_737, 0.967_733_365, 0.200_804_641];
    traced(&field("4, 4 { x*y*.5 } smooth"), "<.4, 5, .7>, -y", [0.4, 0.061_099_243, 0.7], Some(smooth));
    let flat = [-0.162_227_284, 0.973_333_998, 0.162_182_728];
    traced(&field("4, 4 { x*y*.5 }"), "<.4, 5, .7>, -y", [0.4, 0.061_099_243, 0.7], Some(flat));
    let pool = field("9, 9 { .25 + .5*x } water_level .5");
    missed(&pool, "<.49, 5, .3>, -y");
    traced(&pool, "<.51, 5, .3>, -y", [0.51, 0.504_984_741, 0.3], None);
    let points = [
        ("<.1, .45, .3>", 1.0),
        ("<.1, -3, .3>", 1.0),
        ("<.9, .8, .3>", 0.0),
        ("<1, .2, .3>", 0.0),
        ("<0, .2, .3>", 1.0),
    ];
    within(&pool, &points);
}

#[test]
fn blobs() {
    let one = "blob { threshold .5 sphere { 0, 2, 1 } }";
    depth(one, "-5*z", -1.082_392_200, None);
    let two = "blob { threshold .5 sphere { 0, 2, 1 } sphere { <1, 0, 0>, 2, 1 } }";
    depth(two, "-5*z", -1.250_403_266, Some([-0.284_377_795, 0.0, -0.958_712_298]));
    let egg = "blob { threshold .5 sphere { 0, 1, 1 scale <1, 1, 2> translate x } }";
    depth(egg, "<1.2, .3, -5>", -0.807_200_641, Some([0.484_042_607, 0.726_063_910, -0.488_399_378]));
    extent("blob { threshold .5 sphere { 0, 2, 1 } sphere { -z, 1, -1 } }", [-2.0; 3], [2.0; 3]);
    let hollow = "blob { threshold -.1 sphere { 0, 1, -1 } }";
    within(hollow, &[("0", 0.0), ("3*x", 1.0)]);
}

#[test]
fn patches() {
    let row = |i: i32| {
        let point = |j: i32| format!("<{j}, {i}, {}>", if (1..3).contains(&i) && (1..3).contains(&j) { 2 } else { 0 });
        [0, 1, 2, 3].map(point).join(", ")
    };
    let points = [0, 1, 2, 3].map(row).join(", ");
    let patch = |rest: &str, change: &str| format!("bicubic_patch {{ type 0 {rest} {points} {change} }}");
    let probes: [(&str, f64, [f64; 3]); 6] = [
        ("u_steps 0 v_steps 0", 0.0, [0.0, 0.0, -1.0]),
        ("u_steps 1 v_steps 1", 0.525, [0.244_157_911, 0.0, -0.969_735_487]),
        ("u_steps 2 v_steps 2", 0.689_062_5, [0.551_627_395, 0.211_711_977, -0.806_774_601]),
        ("u_steps 4 v_steps 4 flatness .3", 0.689_062_5, [0.551_627_395, 0.211_711_977, -0.806_774_601]),
        ("u_steps 3 v_steps 0", 0.0, [0.592_265_783, 0.0, -0.805_742_665]),
        ("u_steps 0 v_steps 3", 0.0, [0.0, 0.243_856_896, -0.969_811_226]),
    ];
    for (steps, z, [x, y, nz]) in probes {
        let text = format!(
            "#declare N = <0, 0, 0>; #declare O = {} #declare P = trace(O, <.7, 1.1, -5>, z, N); #debug vstr(4, <N.x, N.y, N.z, P.z>, \" \", 0, 12)",
            patch(steps, "")
        );
        // Corners and normals in single precision.
        prints(&text, &[x, y, nz, z], 1e-6);
    }
    let moved = patch("u_steps 4 v_steps 4", "scale <1, 2, 3> rotate 30*z");
    let text = format!(
        "#declare N = <0, 0, 0>; #declare O = {moved} #declare P = trace(O, <-1, 2, -5>, z, N); #debug vstr(4, <N.x, N.y, N.z, P.z>, \" \", 0, 12)"
    );
    prints(&text, &[0.825_141_067, 0.504_826_176, -0.253_560_153, 0.529_879_995], 1e-6);
}

#[test]
fn prisms() {
    let square = "0, 1, 5, <0,0>, <1,0>, <1,1>, <0,1>, <0,0>";
    traced(&format!("prism {{ {square} }}"), "<.5, -5, .5>, y", [0.5, 0.0, 0.5], Some([0.0, 1.0, 0.0]));
    depth(&format!("prism {{ {square} }}"), "<.5, .5, -5>", 0.0, Some([0.0, 0.0, -1.0]));
    depth("prism { 0, 1, 5, <0,0>, <0,1>, <1,1>, <1,0>, <0,0> }", "<.5, .5, -5>", 0.0, Some([0.0, 0.0, 1.0]));
    within(&format!("prism {{ {square} }}"), &[("<.5, 0, .5>", 1.0), ("<.5, 1, .5>", 0.0)]);
    within(&format!("prism {{ {square} open }}"), &[("<.5, .5, .5>", 1.0)]);
    let quadratic = "prism { quadratic_spline 0, 1, 6, <1,-1>, <0,0>, <1,0>, <1,1>, <0,1>, <0,0> }";
    depth(quadratic, "<.4, .5, -5>", 0.116_227_766, Some([-0.104_145_854, 0.0, -0.994_562_035]));
    traced(quadratic, "<5, .5, .3>, -x", [1.121_954_446, 0.5, 0.3], None);
    let cubic = "prism { cubic_spline 0, 1, 7, <0,1>, <0,0>, <1,0>, <1,1>, <0,1>, <0,0>, <1,0> }";
    traced(cubic, "<5, .5, .3>, -x", [1.111_634_473, 0.5, 0.3], None);
    extent(cubic, [-0.125, 0.0, -0.125], [1.125, 1.0, 1.125]);
    let bezier = "prism { bezier_spline 0, 1, 8, <0,0>, <.3,-.4>, <.7,-.4>, <1,0>, <1,0>, <.7,.4>, <.3,.4>, <0,0> }";
    depth(bezier, "<.4, .5, -5>", -0.289_077_808, Some([0.214_121_221, 0.0, 0.976_807_096]));
    extent(bezier, [0.0, 0.0, -0.4], [1.0, 1.0, 0.4]);
    let conic = "prism { conic_sweep .5, 1, 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> }";
    let half = std::f64::consts::FRAC_1_SQRT_2;
    depth(conic, "<.6, .75, -5>", -0.75, Some([0.0, -half, -half]));
    // POV-Ray does not see sloped sides along y, and goes on to the cap.
    traced(conic, "<.6, -5, .1>, y", [0.6, 0.6, 0.1], None);
}

#[test]
fn lathes_and_sors() {
    let linear = "lathe { linear_spline 3, <1,0>, <2,1>, <1,2> }";
    let half = std::f64::consts::FRAC_1_SQRT_2;
    traced(
        "lathe { linear_spline 3, <1,2>, <2,1>, <1,0> }",
        "<5, .5, 0>, -x",
        [1.5, 0.5, 0.0],
        Some([-half, half, 0.0]),
    );
    // At the height of a point POV-Ray counts twice.
    within(linear, &[("<1.2, .5, 0>", 1.0), ("<.5, .5, 0>", 0.0), ("<1.2, 1, 0>", 1.0)]);
    traced("lathe { linear_spline 2, <-1,0>, <1,1> }", "<5, .25, -.1>, -x", [0.489_897_949, 0.25, -0.1], None);
    for (slope, x) in [("1e-5", 1.496_697_975), ("0", 1.496_662_955)] {
        let text = format!(
            "#declare O = {linear} #declare P = trace(O, <5, .5, .1>, <-1, {slope}, 0>); #debug str(P.x, 0, 12)"
        );
        // POV-Ray's own are good to seven digits.
        prints(&text, &[x], 1e-7);
    }
    // POV-Ray divides by the small slope, and hits elsewhere.
    let text =
        format!("#declare O = {linear} #declare P = trace(O, <5, .5, .1>, <-1, 1e-6, 0>); #debug str(P.x, 0, 12)");
    prints(&text, &[1.496_666_457], 1e-8);
    within("sor { 5, <1,-1>, <1,0>, <2,1>, <1,2>, <1,3> }", &[("0", 1.0), ("2*y", 1.0)]);
    // POV-Ray has no base of a radius below 0.01.
    for radius in ["0.009", "0.011"] {
        let text = format!(
            "#declare O = sor {{ 4, <0,-1>, <{radius},0>, <1,1>, <1,2> }} #declare P = trace(O, <.001, -5, .002>, y); #debug str(P.y, 0, 12)"
        );
        prints(&text, &[0.0], DIGITS);
    }
}

#[test]
fn sphere_sweeps() {
    let linear = "sphere_sweep { linear_spline 2, <0,0,0>, 1, <4,0,0>, .5 }";
    depth(linear, "<2, 0, -5>", -0.755_928_946, Some([0.125, 0.0, -0.992_156_742]));
    extent("sphere_sweep { linear_spline 2, <0,0,0>, 1, <4,0,0>, .5 }", [-1.0, -1.0, -1.0], [4.5, 1.0, 1.0]);
}

#[test]
fn implicit_shapes() {
    let sine = "julia_fractal { <-.2, .4, -.4, .3> hypercomplex sin max_iteration 6 }";
    within(sine, &[("<-1.1, 1, .8>", 1.0), ("<.8, -1.5, -.2>", 0.0), ("<.7, -.8, 1.3>", 1.0)]);
}

#[test]
fn text() {
    let text = |letters: &str, depth: &str| format!("text {{ ttf \"oA.ttf\" \"{letters}\" {depth}, 0 }}");
    let width = |letters: &str| {
        let text = format!("#declare O = {} #debug str(max_extent(O).x, 0, 9)", text(letters, ".5"));
        printed(&text)[0]
    };
    // The first letter stands at 0; then advances, bearings, and a closer pair. All is turned a little.
    for (letters, x) in [("o", 0.6), ("oo", 1.3), ("A", 0.56), ("Ao", 1.13), ("oA", 1.23), ("o?o", 1.8)] {
        assert!((width(letters) - x).abs() < 2e-5, "{letters}: {}", width(letters));
    }
    let point = |object: &str, ray: &str| {
        printed(&format!(
            "#declare N = <0, 0, 0>; #declare O = {object} #declare P = trace(O, {ray}, N); #debug vstr(3, P, \" \", 0, 9) #debug \" \" #debug vstr(3, N, \" \", 0, 9)"
        ))
    };
    let near = |found: &[f64], expected: [f64; 6]| {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 5e-5), "{found:?}, expected {expected:?}");
    };
    // Caps look outward; sides of a letter inward, holes outward.
    near(&point(&text("o", ".5"), "<.08, .3, -5>, z"), [0.08, 0.3, 0.0, 0.0, 0.0, -1.0]);
    near(&point(&text("o", ".5"), "<.08, .3, 5>, -z"), [0.08, 0.3, 0.5, 0.0, 0.0, 1.0]);
    near(&point(&text("o", ".5"), "<-5, .3, .25>, x"), [0.0, 0.3, 0.25, 1.0, 0.0, 0.0]);
    near(&point(&text("o", ".5"), "<.3, .3, .25>, x"), [0.45, 0.3, 0.25, 1.0, 0.0, 0.0]);
    near(&point(&text("o", ".5"), "<.3, .3, -5>, z"), [0.0; 6]);
    within(&text("o", ".5"), &[("<.08, .3, .25>", 1.0), ("<.3, .3, .25>", 0.0), ("<.08, .3, -.01>", 0.0)]);
    // Two caps and nothing between them.
    near(&point(&text("o", "-.5"), "<.08, .3, -5>, z"), [0.08, 0.3, -0.5, 0.0, 0.0, -1.0]);
    near(&point(&text("o", "-.5"), "<-5, .3, -.25>, x"), [0.0; 6]);
    within(&text("o", "-.5"), &[("<.08, .3, -.25>", 0.0)]);
    near(&point(&text("o", "0"), "<.08, .3, -5>, z"), [0.08, 0.3, 0.0, 0.0, 0.0, 1.0]);
}
