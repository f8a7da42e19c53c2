//! Section 5 of the shading facts.

use super::*;

/// An orange wall under a light at 45 degrees.
fn orange(finish: &str, expected: [f32; 3]) {
    let wall = format!("plane{{-z,0 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse 0 {finish}}}}}");
    check(&format!("{CZ} {wall} light_source{{<0,5,-5> rgb .8}}"), expected);
}

/// An orange floor without light of its own, seen at 45 degrees.
fn mirror(finish: &str, more: &str, expected: [f32; 3]) {
    let floor = format!("plane{{y,0 pigment{{rgb <1,.5,.25>}} finish{{ambient 0 diffuse 0 {finish}}} {more}}}");
    check(&format!("{CY} {BG} {floor}"), expected);
}

#[test]
fn diffuse_light() {
    orange("diffuse .7", [0.395987, 0.197986, 0.099001]);
    orange("diffuse .7 brilliance 2", [0.280003, 0.140001, 0.070001]);
    orange("diffuse .7 brilliance .5", [0.470909, 0.235455, 0.117727]);
    orange("diffuse .7 brilliance 0", [0.560006, 0.280003, 0.140001]);
    orange("diffuse albedo .7 brilliance 3", [0.395987, 0.197986, 0.099001]);
}

#[test]
fn crand_is_even_noise() {
    // Each pixel's diffuse share is 1 - 0.4 ξ with ξ uniform in 0..1, for each light anew.
    let scene = |lights: u32| {
        let light = format!("light_source{{<0,0,-1e6> rgb {}}}", 0.8 / f64::from(lights));
        let wall = "plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse 1 crand .4}}";
        format!("{CZ} {wall} {}", light.repeat(lights as usize))
    };
    for lights in [1, 4] {
        let n = 64;
        let picture = picture(&scene(lights), &Options { width: n, height: n, ..single() });
        let values: Vec<f64> = picture.pixels.iter().map(|p| f64::from(p[0])).collect();
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let deviation = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count).sqrt();
        let expected = 0.8 * 0.4 / 12f64.sqrt() / f64::from(lights).sqrt();
        // Five standard errors of the mean; the deviation itself has one of at most 1.1 %.
        assert!((mean - 0.64).abs() < 5.0 * expected / count.sqrt(), "{mean}");
        assert!((deviation / expected - 1.0).abs() < 0.055, "{deviation} instead of {expected}");
        let rows = values.chunks(n).flat_map(|row| row.windows(2));
        let neighbours = rows.map(|w| (w[0] - mean) * (w[1] - mean)).sum::<f64>() / count / expected.powi(2);
        assert!(neighbours.abs() < 5.0 / count.sqrt(), "neighbours correlate by {neighbours}");
    }
}

#[test]
fn own_light() {
    let wall = |light: &str, finish: &str, pigment: &str| {
        format!("{CZ} {light} plane{{-z,0 pigment{{{pigment}}} finish{{ambient 0 diffuse 0 {finish}}}}}")
    };
    let dim = "global_settings{ambient_light rgb <.5,2,3>}";
    let orange = "rgb <1,.5,.25>";
    check(&wall(dim, "ambient rgb <.1,.2,.4>", orange), [0.050004, 0.2, 0.300008]);
    check(&wall(dim, "emission rgb <.1,.2,.4>", orange), [0.100008, 0.100008, 0.100008]);
    let lamp = "light_source{<0,5,-5> rgb .8}";
    for pigment in ["rgbt <1,.5,.25,.4>", "rgbf <1,.5,.25,.4>"] {
        check(&wall(lamp, "diffuse .7 ambient .2 emission .1", pigment), [0.417594, 0.208789, 0.104402]);
    }
}

#[test]
fn highlights() {
    orange("phong .9 phong_size 3", [0.254551; 3]);
    orange("phong albedo .3 phong_size 3", [0.169711; 3]);
    orange("phong .9 phong_size 3 metallic", [0.254551, 0.130617, 0.068650]);
    orange("specular .5", [0.082109; 3]);
    orange("specular .5 roughness .1", [0.181216; 3]);
    orange("specular albedo .5 roughness .1", [0.276143; 3]);
    orange("specular .5 roughness .1 metallic", [0.181216, 0.092988, 0.048875]);
    orange("diffuse .5 specular .3 roughness .1", [0.391577, 0.250156, 0.179446]);
}

#[test]
fn thin_films() {
    orange("diffuse .7 irid{.3 thickness .5}", [0.418708, 0.160540, 0.104234]);
    orange("ambient .2 diffuse .5 irid{.3 thickness .5}", [0.499077, 0.214679, 0.124453]);
    mirror("reflection .8 irid{.3 thickness .5}", "", [0.207904, 0.258885, 0.338048]);
}

#[test]
fn both_sides() {
    let wall = "plane{-z,0 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse .7,.4}}";
    check(&format!("{CZ} {wall} light_source{{<0,5,5> rgb .8}}"), [0.226276, 0.113130, 0.056565]);
    let wall = "plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse .1 specular .5 roughness .1} double_illuminate}";
    check_grey(&format!("{CZ} {wall} light_source{{<0,5,.1> rgb .8}}"), 0.012894);
}

#[test]
fn reflections() {
    mirror("reflection{.2,.8}", "", [0.075151, 0.150301, 0.225437]);
    mirror("reflection{.2,.8 falloff 3}", "", [0.043015, 0.086030, 0.129046]);
    mirror("reflection{0,1 fresnel}", "interior{ior 1.5}", [0.010040, 0.020096, 0.030137]);
    mirror("reflection{1 fresnel}", "interior{ior 1.5}", [0.010040, 0.020096, 0.030137]);
    mirror("reflection{.1,.9 fresnel}", "", [0.020005, 0.039994, 0.059998]);
    mirror("reflection{1 fresnel} reflection{.1,.9}", "interior{ior 1.5}", [0.028031, 0.056077, 0.084108]);
    mirror("reflection{.8 metallic}", "", [0.160006, 0.164202, 0.129458]);
    mirror("reflection .8 reflection_exponent 2", "", [0.357778, 0.505959, 0.619684]);
    mirror("reflection -.5 emission .5", "", [0.500008, 0.250004, 0.125002]);
}

#[test]
fn energy_is_conserved_where_asked() {
    let sheet = |finish: &str, expected: [f32; 3]| {
        let floor = format!("plane{{y,0 pigment{{rgbt <1,.5,.25,.3>}} finish{{ambient 0 diffuse 0 {finish}}}}}");
        check(&format!("{CY} {BG} {floor}"), expected);
    };
    sheet("reflection .5", [0.160006, 0.319997, 0.480003]);
    sheet("reflection .5 conserve_energy", [0.130007, 0.259998, 0.390005]);
    sheet("reflection rgb <.5,.2,0> conserve_energy", [0.130007, 0.175998, 0.179995]);
}

#[test]
fn little_is_mirrored_head_on() {
    let wall =
        "plane{-z,0 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse 0 reflection{0,1 fresnel}} interior{ior 1.5}}";
    check(&format!("{CZ} {BG} {wall}"), [0.007996, 0.016007, 0.024002]);
}

#[test]
fn opacity_depends_on_the_version() {
    let wall = "plane{-z,0 pigment{rgbf <.5,.25,.125,.4>} finish{diffuse .7 ambient .2}}";
    for (version, expected) in [("3.7", 0.178790), ("3.6", 0.238392)] {
        let scene = format!("#version {version}; {CZ} light_source{{<0,5,-5> rgb .8}} {wall}");
        let found = pixel(&scene, &single())[0];
        assert!((found - expected).abs() <= TOLERANCE, "{found} instead of {expected} in version {version}");
    }
}
