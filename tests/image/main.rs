//! What a picture's file offers beyond colours: parts of a picture and layers.

mod exr;
mod layers;
mod memory;
mod observer;
mod region;
mod resume;
mod target;

use whitted::compile::{self, Queries};
use whitted::compiled::World;
use whitted::eval::{self, Memory};
use whitted::imaging::Picture;
use whitted::job::Session;
use whitted::render::{Antialias, Method, Options, Unobserved};

/// Everything that a layer tells apart: mirrors, glass, bumps, fog, a rainbow, own light, copies, several lights.
const SCENE: &str = "
camera { location <0, 2, -6> look_at <0, 0.5, 0> angle 45 right x*4/3 }
light_source { <-5, 7, -6> rgb 0.8 area_light x, y, 2, 2 jitter }
light_source { <5, 9, -3> rgb 0.3 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.8,.7,.6>] [1 rgb <.2,.3,.6>] } } }
fog { distance 30 rgb <.5,.5,.6> }
#declare Ball = sphere { 0, 0.7 pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.3 phong .5 crand 0.1 } }
#declare Glass = box { -0.5, 0.5 pigment { rgbf <1, .9, .9, .9> } finish { reflection { 0, 1 fresnel } }
  interior { ior 1.5 } }
plane { y, -0.8 pigment { checker rgb .8 rgb .3 } }
object { Ball translate -1.6*x }
object { Ball translate <1.6,0,1> }
object { Glass rotate y*30 }
sphere { <0, 1, 0>, 0.4 pigment { rgb <.3, .6, .2> } normal { bumps .4 scale .1 } finish { emission 0.2 } }
";

/// A lens wide enough to blur.
const LENS: &str = "camera { location <0, 2, -6> look_at <0, 0.5, 0> angle 45 right x*4/3
  aperture 0.3 focal_point 0 blur_samples 5 variance 0.001 }";

/// The world of a scene after the common header.
fn world(scene: &str) -> World {
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1.0 }}\n{scene}");
    let host = Memory::new([("a.pov", text.as_str())]);
    let read = eval::evaluate("a.pov".as_ref(), &eval::Options::default(), &host, &Queries::default());
    let read = read.expect("the scene is right");
    compile::compile(&read.scene).expect("the scene is supported").world
}

/// A small picture of a scene.
fn picture(world: &World, options: &Options) -> Picture {
    Session::new(1).picture(world, options, &Unobserved).picture
}

/// Wide enough for several blocks, and not a multiple of them.
fn small(antialias: Option<Antialias>) -> Options {
    Options { width: 75, height: 50, antialias, ..Options::default() }
}

/// No antialiasing, and both ways with jitter.
fn ways() -> [Option<Antialias>; 3] {
    let way = |method| Some(Antialias { method, threshold: 0.1, depth: 2, jitter: 1.0, gamma: Antialias::GAMMA });
    [None, way(Method::Grid), way(Method::Adaptive)]
}
