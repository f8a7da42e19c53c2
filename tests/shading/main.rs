//! Scenes of one pixel, from text to light, against the numbers that POV-Ray 3.7 gives.
//!
//! Every number is read from a linear 16-bit picture by POV-Ray 3.7.0.10 and is good to 8e-6.

mod atmosphere;
mod bumps;
mod finishes;
mod interiors;
mod layers;
mod lights;
mod media;
mod photons;
mod radiosity;
mod recursion;
mod shadows;
mod subsurface;

use whitted::compile::{self, Queries};
use whitted::eval::{self, Memory};
use whitted::imaging::Picture;
use whitted::job::Session;
use whitted::render::{Options, Rendered, Unobserved};

/// Camera on the z axis, looking along it.
const CZ: &str = "camera{location <0,0,-10> look_at 0 right x up y angle 1}";
/// Camera above, looking down at 45 degrees.
const CY: &str = "camera{location <0,5,-5> look_at 0 right x up y angle 1}";
/// A white diffuse wall that faces the camera.
const WALL: &str = "plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse 1}}";
/// A bluish background.
const BG: &str = "background{rgb <.2,.4,.6>}";

/// Half of the last digit of the measured numbers, and single precision on our side.
const TOLERANCE: f32 = 1.6e-5;

/// The pixel of a scene after the common header.
fn pixel(scene: &str, options: &Options) -> [f32; 4] {
    picture(scene, options).pixel(0, 0)
}

/// The picture of a scene after the common header.
fn picture(scene: &str, options: &Options) -> Picture {
    picture_by(1, &format!("#version 3.7; global_settings {{ assumed_gamma 1.0 }}\n{scene}"), options)
}

/// The picture of a whole text by so many threads.
fn picture_by(threads: usize, text: &str, options: &Options) -> Picture {
    rendered_by(threads, text, options).picture
}

/// The same with all that comes with it.
fn rendered_by(threads: usize, text: &str, options: &Options) -> Rendered {
    let host = Memory::new([("a.pov", text)]);
    let read = eval::evaluate("a.pov".as_ref(), &eval::Options::default(), &host, &Queries::default());
    let read = read.unwrap_or_else(|f| panic!("{text}\n{}", messages(&f.diagnostics, &f.sources)));
    let compiled = compile::compile(&read.scene);
    let compiled = compiled.unwrap_or_else(|e| panic!("{text}\n{}", messages(&e, &read.sources)));
    Session::new(threads).picture(&compiled.world, options, &Unobserved)
}

fn messages(diagnostics: &[whitted::diag::Diagnostic], sources: &whitted::diag::SourceMap) -> String {
    diagnostics.iter().map(|d| d.render(sources, false)).collect()
}

/// One pixel, one thread, all effects.
fn single() -> Options {
    Options { width: 1, height: 1, ..Options::default() }
}

/// Renders a scene and compares its colour.
fn check(scene: &str, expected: [f32; 3]) {
    check_within(scene, expected, TOLERANCE);
}

/// The same with a tolerance of its own.
fn check_within(scene: &str, expected: [f32; 3], tolerance: f32) {
    let found = pixel(scene, &single());
    let worst = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f32::max);
    assert!(worst <= tolerance, "{found:?} instead of {expected:?} for\n{scene}");
}

/// A grey result.
fn check_grey(scene: &str, expected: f32) {
    check(scene, [expected; 3]);
}
