//! What the tables of blocks promise, held against what the blocks do.

use super::described;
use crate::eval::{Memory, NoQueries, Options, evaluate};
use crate::scene::Scene;
use crate::syntax::Keyword;
use crate::syntax::built_in::{BuiltIn, Place, Takes};
use std::collections::BTreeSet;

/// What a scene is, or its first error.
fn read(text: &str) -> Result<Scene, String> {
    let text = format!("#version 3.7; {text}");
    let host = Memory::new([("a.pov", text.as_str())]);
    match evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries) {
        Ok(read) => Ok(read.scene),
        Err(failed) => Err(failed.diagnostics.iter().map(|d| d.message.clone()).next_back().unwrap_or_default()),
    }
}

#[test]
fn every_word_is_described_in_one_line() {
    let mut n_words = 0;
    for block in described() {
        let mut seen = BTreeSet::new();
        assert!(!block.help.is_empty() && !block.help.contains('\n'), "{}", block.name);
        for word in block.words {
            assert!(!word.help.is_empty() && !word.help.contains('\n'), "{} {}", block.name, word.word);
            assert!(seen.insert(word.word), "{} {} stands twice", block.name, word.word);
            n_words += 1;
        }
    }
    assert!(n_words > 400, "{n_words}");
}

/// A block with a default written out is as without it: `before WORD DEFAULT after`, by what `part` shows of the scene.
fn defaults_hold(block: &str, before: &str, after: &str, part: impl Fn(&Scene) -> String) {
    let shown = |item: &str| match read(&format!("{before} {item} {after}")) {
        Ok(scene) => part(&scene),
        Err(message) => panic!("{block} {item}: {message}"),
    };
    let expected = shown("");
    let mut n_held = 0;
    for described in described().filter(|described| described.name == block) {
        for word in described.words.iter().filter(|word| !word.default.is_empty()) {
            assert_eq!(shown(&format!("{} {}", word.word, word.default)), expected, "{block} {}", word.word);
            n_held += 1;
        }
    }
    assert!(n_held > 0, "{block}");
}

#[test]
fn defaults_are_what_holds_without_them() {
    defaults_hold("finish", "sphere { 0, 1 finish {", "} }", |scene| format!("{:?}", scene.objects[0].texture));
    defaults_hold("camera", "camera {", "}", |scene| format!("{:?}", scene.camera));
    defaults_hold("interior", "sphere { 0, 1 interior {", "} }", |scene| format!("{:?}", scene.objects[0].interior));
    defaults_hold("media", "media {", "}", |scene| format!("{:?}", scene.media));
    defaults_hold("scattering", "media { scattering { 5, 1", "} }", |scene| format!("{:?}", scene.media));
    let settings = |scene: &Scene| format!("{:?}", scene.settings);
    defaults_hold("global_settings", "global_settings {", "}", settings);
    for block in ["radiosity", "photons"] {
        defaults_hold(block, &format!("global_settings {{ {block} {{"), "} }", settings);
    }
    defaults_hold("fog", "fog {", "}", |scene| format!("{:?}", scene.fogs));
    defaults_hold("sky_sphere", "sky_sphere { pigment { rgb 1 }", "}", |scene| {
        scene.sky_sphere.as_ref().map_or(String::new(), |sky| format!("{:?}", sky.emission))
    });
}

#[test]
fn defaults_of_shapes_and_textures_are_what_holds_without_them() {
    let shape = |scene: &Scene| format!("{:?}", scene.objects[0].shape);
    defaults_hold("isosurface", "isosurface { function { x }", "}", shape);
    defaults_hold("parametric", "parametric { function { u } function { v } function { 0 } <0, 0>, <1, 1>", "}", shape);
    defaults_hold("julia_fractal", "julia_fractal { <0, 0, 0, 0>", "}", shape);
    defaults_hold("blob", "blob { sphere { 0, 1, 1 }", "}", shape);
    defaults_hold("sphere_sweep", "sphere_sweep { linear_spline 2, 0, 1, x, 1", "}", shape);
    let points = "0 ".repeat(16);
    defaults_hold("bicubic_patch", "bicubic_patch { type 1", &format!("{points} }}"), shape);
    defaults_hold("light_group", "light_group { sphere { 0, 1 }", "}", shape);
    let texture = |scene: &Scene| format!("{:?}", scene.objects[0].texture);
    let warped = |warp: &str| format!("sphere {{ 0, 1 pigment {{ bozo warp {{ {warp}");
    defaults_hold("black_hole", &warped("black_hole 0, 1"), "} } }", texture);
    defaults_hold("repeat", &warped("repeat 2*x"), "} } }", texture);
    defaults_hold("mapping warp", &warped("toroidal"), "} } }", texture);
    defaults_hold("normal", "sphere { 0, 1 normal { bumps", "} }", texture);
}

/// A function of one number or two is the same whoever reads it.
#[test]
fn functions_calculate_as_values_do() {
    let mut n_same = 0;
    for built_in in BuiltIn::all().iter().filter(|built_in| built_in.place == Place::Both) {
        let arguments = match (built_in.word, built_in.takes) {
            (Keyword::Acosh, _) => "(1.75)",
            (_, Takes::Float) => "(0.75)",
            (_, Takes::TwoFloats | Takes::Floats) => "(7.5, 2.25)",
            (_, Takes::Choice) => "(7.5, 2.25, 1, 3)",
            (_, Takes::Number(_) | Takes::State) => "",
            _ => continue,
        };
        let call = format!("{}{arguments}", built_in.word.word());
        let scene = format!("#declare F = function(x) {{ {call} }} #if (F(0) != {call}) #error \"not the same\" #end");
        assert_eq!(read(&scene).err(), None, "{call}");
        n_same += 1;
    }
    assert!(n_same > 25, "{n_same}");
}

/// The hint of a scene's only error.
fn hint(text: &str) -> String {
    let text = format!("#version 3.7; {text}");
    let host = Memory::new([("a.pov", text.as_str())]);
    let failed = evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries).err();
    failed.and_then(|f| f.diagnostics.last().and_then(|d| d.hints.first().cloned())).unwrap_or_default()
}

#[test]
fn a_block_says_what_it_takes() {
    assert_eq!(hint("sphere { 0, 1 finish { phonk 1 } }"), "did you mean 'phong'?");
    assert!(hint("sphere { 0, 1 finish { fong 1 } }").starts_with("finish takes ambient, brilliance"));
    assert_eq!(
        hint("rainbow { radius 3 }"),
        "rainbow takes angle, arc_angle, color_map, direction, distance, falloff_angle, jitter, up, width"
    );
    assert!(hint("fog { width 3 }").starts_with("fog takes alpha, blue, color, colour, distance, filter, fog_alt"));
    assert!(hint("camera { radius 3 }").starts_with("camera takes angle, aperture"));
}
