//! Free-form shapes and text.

use super::*;

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
    // A part keeps its digits, however small it is beside the blob.
    for size in ["1", ".01", ".001", ".0001", ".00001"] {
        let text = format!(
            "#declare R = {size}; #declare N = <0, 0, 0>;
            #declare O = blob {{ sphere {{ <-8, 3, 0>, .5, 2 }} sphere {{ <8, 0, 0>, R, 2 }} }}
            #declare P = trace(O, <-20, .1*R, 0>, x, N);
            #debug str((P.x - 8)/R, 0, 12) #debug \" \" #debug vstr(2, N, \" \", 0, 12)"
        );
        prints(&text, &[-0.531_877_071, -0.982_780_680, 0.184_775_907], 1e-9);
    }
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
    // The core of a Bézier curve is measured by its control points.
    let curved =
        "lathe { bezier_spline 8, <.445,.323>, <.092,-.618>, <.914,.278>, <.393,-.577>, <.393,-.577>, <.973,.043>,
        <.566,-.495>, <.892,.967> }";
    within(curved, &[("<-.174, .816, .169>", 1.0), ("<.05, .816, .05>", 0.0)]);
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
    // A flat curve seen square to its plane.
    let flat =
        "sphere_sweep { cubic_spline 5, <-1.5,-3,0>, .6, <-1,0,0>, .6, <0,.5,0>, .6, <1,0,0>, .6, <1.5,-3,0>, .6 }";
    for (from, expected) in [
        ("<.3, .2, -5>", [-0.518_071_803, -0.023_931_394, -0.503_861_286, -0.863_453_006]),
        ("<-.9, .35, -5>", [-0.591_603_589, -0.123_495_060, 0.111_987_378, -0.986_005_982]),
        ("<1.4, -.1, -5>", [-0.435_889_894, 0.666_666_667, -0.166_666_667, -0.726_483_157]),
    ] {
        let text = format!(
            "#declare N = <0, 0, 0>; #declare O = {flat} #declare P = trace(O, {from}, z, N);
            #debug str(P.z, 0, 12) #debug \" \" #debug vstr(3, N, \" \", 0, 12)"
        );
        // POV-Ray knows the sphere from a double root: to half the digits.
        prints(&text, &expected, 1e-7);
    }
    // Two crossings of every ray: from the one it leaves, a ray meets nothing.
    for (x, y) in [(0.3, 0.2), (-0.9, 0.35), (0.0, 1.05), (1.4, -0.1), (0.62, -0.3), (-0.31, 0.47), (0.999, 0.013)] {
        let text = format!(
            "#declare N = <0, 0, 0>; #declare O = {flat} #declare P = trace(O, <{x}, {y}, -5>, z, N);
            #declare P = trace(O, P + 1e-9*z, z, N); #declare Q = trace(O, P + 1e-9*z, z, N);
            #debug str((P.z > .1), 0, 0) #debug \" \" #debug str(vlength(N), 0, 0)"
        );
        prints(&text, &[1.0, 0.0], 0.0);
    }
}

#[test]
fn parametric_surfaces() {
    let sheet = |container: &str| {
        format!(
            "parametric {{ function {{ u }} function {{ .05*sin(9*u) }} function {{ v }} <-2, -2>, <2, 2>
            contained_by {{ {container} }} accuracy .01 }}"
        )
    };
    // In both, nothing is found within four accuracies of where the search starts: in a box, of the ray's origin.
    for container in ["box { -3, 3 }", "sphere { 0, 3 }"] {
        let sheet = sheet(container);
        traced(&sheet, "<.1, 2, -.3>, -y", [0.1, 0.040_379_310_995, -0.3], None);
        traced(&sheet, "<.1, .1, -.3>, -y", [0.1, 0.040_379_310_995, -0.3], None);
        missed(&sheet, "<.1, .02, -.3>, -y");
    }
    missed(&sheet("box { -3, 3 }"), "<.1, .06, -.3>, -y");
    traced(&sheet("sphere { 0, 3 }"), "<.1, .06, -.3>, -y", [0.1, 0.040_379_310_995, -0.3], None);
}

#[test]
fn implicit_shapes() {
    let sine = "julia_fractal { <-.2, .4, -.4, .3> hypercomplex sin max_iteration 6 }";
    within(sine, &[("<-1.1, 1, .8>", 1.0), ("<.8, -1.5, -.2>", 0.0), ("<.7, -.8, 1.3>", 1.0)]);
}

/// Where the orbit of a hit escapes, its normal has to do with what the ray looked at before.
#[test]
fn normals_of_hypercomplex_sets() {
    let probes = [
        ("<.3, .5, -.2, .1> sin max_iteration 3", "<-.52, -1.3, -6>", [-0.546_945, 0.789_378, 0.435_056, 0.433_139]),
        (
            "<0.48, 0.48, 0.09, -0.58> exp max_iteration 6",
            "<-0.26, 1.32, -6>",
            [0.631_669, 0.925_247, 0.268_562, 0.267_942],
        ),
        (
            "<-0.18, -0.36, 0.04, 0.38> exp max_iteration 3",
            "<1.09, -1.35, -6>",
            [-3.554_081, -0.948_430, -0.224_143, 0.224_143],
        ),
        (
            "<0.38, -0.19, 0.42, -0.57> ln max_iteration 3 slice <.1,-.2,.4,.9>,-.05",
            "<-0.05, 0.59, -6>",
            [-3.605_932, -0.796_906, -0.283_646, -0.533_372],
        ),
        (
            "<0.27, -0.5, -0.49, 0.4> sin max_iteration 4",
            "<-0.43, 0.24, -6>",
            [-0.651_328, -0.885_197, 0.328_783, 0.329_132],
        ),
        (
            "<0.54, -0.14, 0.06, 0.1> asin max_iteration 6 slice <0,.2,.3,1>,.1",
            "<1.43, 0.56, -6>",
            [-3.543_440, -0.157_894, 0.941_933, -0.296_364],
        ),
        (
            "<-0.22, 0.34, -0.11, 0.41> asin max_iteration 6",
            "<-1.43, -0.13, -6>",
            [-3.733_390, -0.022_494, -0.462_901, -0.886_125],
        ),
        (
            "<-0.46, 0.5, 0.11, 0.37> cos max_iteration 4 slice <0,.2,.3,1>,.1",
            "<1.44, 1.33, -6>",
            [-0.386_761, -0.102_995, -0.714_315, 0.692_204],
        ),
        (
            "<0.02, -0.3, 0.41, -0.53> acos max_iteration 3 slice <0,.2,.3,1>,.1",
            "<-0.88, -0.84, -6>",
            [-3.610_512, -0.733_757, -0.236_060, -0.637_084],
        ),
        (
            "<-0.57, 0.54, -0.6, 0.58> tan max_iteration 4 slice <0,.2,.3,1>,.1",
            "<1.44, 0.86, -6>",
            [-3.531_363, -0.949_376, 0.263_400, 0.171_192],
        ),
        (
            "<-0.59, -0.26, 0.55, -0.52> atan max_iteration 4 slice <0,.2,.3,1>,.1",
            "<0.18, -0.98, -6>",
            [-3.623_913, 0.580_544, -0.139_799, 0.802_138],
        ),
        (
            "<-0.03, 0.04, 0.45, 0.58> sinh max_iteration 6 slice <.1,-.2,.4,.9>,-.05",
            "<-0.18, 0.35, -6>",
            [-3.180_590, 0.041_826, -0.647_464, -0.760_948],
        ),
        (
            "<-0.24, -0.26, 0.17, 0.29> sinh max_iteration 3",
            "<1.48, -1.3, -6>",
            [-2.381_321, 0.877_359, -0.440_444, -0.190_395],
        ),
        (
            "<0.03, -0.36, -0.24, 0.48> asinh max_iteration 3 slice <.1,-.2,.4,.9>,-.05",
            "<-0.44, 0.81, -6>",
            [-3.492_339, -0.323_432, 0.664_783, 0.673_391],
        ),
        (
            "<0.08, -0.14, -0.47, 0.06> cosh max_iteration 4 slice <.1,-.2,.4,.9>,-.05",
            "<-0.04, 0.12, -6>",
            [-2.697_999, -0.315_540, 0.691_976, -0.649_310],
        ),
        (
            "<-0.6, -0.26, 0.24, -0.4> acosh max_iteration 3 slice <0,.2,.3,1>,.1",
            "<1.41, -1.2, -6>",
            [-3.295_687, -0.049_219, 0.892_787, -0.447_782],
        ),
        (
            "<0.3, -0.35, -0.48, -0.29> tanh max_iteration 4 slice <0,.2,.3,1>,.1",
            "<-0.07, -0.89, -6>",
            [-3.649_102, 0.945_635, 0.225_948, 0.233_925],
        ),
        (
            "<0.49, -0.28, -0.25, 0.53> atanh max_iteration 3 slice <0,.2,.3,1>,.1",
            "<1.27, -0.57, -6>",
            [-3.549_960, -0.433_123, -0.392_006, 0.811_625],
        ),
        (
            "<0.2, -0.44, 0.27, 0.36> reciprocal max_iteration 6 slice <0,.2,.3,1>,.1",
            "<0.92, -0.78, -6>",
            [-3.572_846, -0.653_226, 0.524_103, 0.546_454],
        ),
        (
            "<-0.31, 0.25, 0.16, -0.53> reciprocal max_iteration 6",
            "<-0.14, 0.51, -6>",
            [-1.092_539, -0.723_229, -0.606_406, 0.330_472],
        ),
        (
            "<-0.12, -0.57, 0.18, 0.33> pwr(1.5,.2) max_iteration 3 slice <0,.2,.3,1>,.1",
            "<-0.24, -0.41, -6>",
            [-0.471_687, 0.905_427, 0.301_841, 0.298_486],
        ),
    ];
    for (set, from, expected) in probes {
        let set = set.replacen("> ", "> hypercomplex ", 1);
        let text = format!(
            "#declare N = <0, 0, 0>; #declare O = julia_fractal {{ {set} }} #declare P = trace(O, {from}, z, N);
            #debug str(P.z, 0, 9) #debug \" \" #debug vstr(3, N, \" \", 0, 9)"
        );
        prints(&text, &expected, 2e-6);
    }
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
