//! Pictures that are sampled until their error is small: what they say of themselves holds.

use super::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use whitted::render::{End, FinishedBlock, ImageLayer, Observer, Progress, Rendered, Target};

const SIZE: [usize; 2] = [48, 36];

/// Scenes of one kind of difficulty each: an edge, a curve, a pattern that gets finer and finer, noise, soft shadow,
/// a lens, thin things that most samples miss, light above white.
const SCENES: [&str; 8] = [
    "camera { orthographic location -5*z right 4*x up 3*y direction z } background { rgb .1 }
     box { <-9,-9,0>, <.2,9,1> rotate 35*z pigment { rgb <1,.8,.3> } finish { emission 1 ambient 0 diffuse 0 } }",
    "camera { orthographic location -5*z right 4*x up 3*y direction z }
     sphere { 0, 1.2 pigment { rgb <.9,.5,.2> } finish { emission 1 ambient 0 diffuse 0 } }",
    "camera { location y right x*4/3 look_at <0,.7,5> }
     plane { y, 0 pigment { checker rgb 0 rgb 1 scale .3 } finish { emission 1 ambient 0 diffuse 0 } }",
    "camera { location -5*z right x*4/3 }
     plane { z, 0 pigment { bozo color_map { [.4 rgb .1] [.6 rgb <1,.8,.6>] } scale .08 }
       finish { emission 1 ambient 0 diffuse 0 } }",
    "camera { location <0,3,-6> right x*4/3 look_at 0 } light_source { <3,6,-2> rgb 1 area_light 2*x, 2*z, 3, 3 jitter }
     plane { y, -1 pigment { rgb .8 } } box { -.7, .7 pigment { rgb <.3,.5,.9> } rotate 30*y }",
    "camera { location <0,1,-6> right x*4/3 look_at 0 aperture .4 focal_point 0 blur_samples 9 }
     light_source { <3,6,-5> rgb 1 } sphere { 0, 1 pigment { rgb <.9,.4,.3> } } sphere { <1,0,4>, 1 pigment { rgb 1 } }
     plane { y, -1 pigment { checker rgb .2 rgb .9 } }",
    "camera { orthographic location -5*z right 4*x up 3*y direction z }
     union { #for (I, -8, 8) cylinder { <I/4,-3,0>, <I/4+.3,3,0>, .006 } #end pigment { rgb 1 }
       finish { emission 1 ambient 0 diffuse 0 } }",
    "camera { location <0,1,-5> right x*4/3 look_at 0 } light_source { <4,6,-5> rgb 3 }
     sphere { 0, 1 pigment { rgb .2 } finish { specular 2 roughness .002 reflection .4 } }
     plane { y, -1 pigment { hexagon rgb .8 rgb .3 rgb .1 scale .4 } }",
];

fn rendered(world: &World, target: Target, threads: usize) -> Rendered {
    let [width, height] = SIZE;
    let options = Options { width, height, target: Some(target), ..Options::default() };
    Session::new(threads).picture(world, &options, &Unobserved)
}

fn progress(rendered: &Rendered) -> &Progress {
    rendered.progress.as_ref().expect("a picture with a target says how it came about")
}

fn rmse(a: &[[f32; 4]], b: &[[f32; 4]]) -> f64 {
    let squares = a.iter().zip(b).flat_map(|(a, b)| (0..3).map(|c| f64::from(a[c] - b[c]).powi(2)));
    (squares.sum::<f64>() / (3 * a.len()) as f64).sqrt()
}

/// What the picture would be with endless samples: another seed, and an error far below that of the others.
fn truth(world: &World, error: f64) -> Vec<[f32; 4]> {
    let rendered = rendered(world, Target { error: Some(error), seed: 1 << 40, ..Target::default() }, 0);
    rendered.picture.pixels
}

/// The share of pictures whose error is at most their target, and the mean of true over estimated squared error.
fn hits(estimate: impl Fn(&Progress) -> f64) -> (f64, f64) {
    const TARGET: f64 = 0.02;
    let (mut n, mut hits, mut ratio) = (0.0, 0.0, 0.0);
    for scene in SCENES {
        let world = world(scene);
        let truth = truth(&world, TARGET / 8.0);
        for seed in 0..12 {
            let rendered = rendered(&world, Target { error: Some(TARGET), seed, ..Target::default() }, 0);
            let progress = progress(&rendered);
            assert_eq!(progress.end, End::Reached);
            let error = rmse(&rendered.picture.pixels, &truth);
            n += 1.0;
            hits += f64::from(u8::from(error <= TARGET));
            ratio += (error / estimate(progress)).powi(2);
        }
    }
    (hits / n, ratio / n)
}

#[test]
fn targets_are_reached_and_estimates_are_right() {
    // Of 96 pictures that each miss with a chance of one in twenty, 12 or more do once in two thousand times.
    let (hits, ratio) = hits(|progress| progress.accuracy.rmse());
    assert!(hits > 1.0 - 12.0 / 96.0, "{hits} of all pictures reach their target");
    assert!((0.7..1.4).contains(&ratio), "true over estimated squared error: {ratio}");
}

#[test]
fn an_estimate_of_half_the_error_would_be_found_out() {
    let (_, ratio) = hits(|progress| 0.5 * progress.accuracy.rmse());
    assert!(!(0.7..1.4).contains(&ratio), "true over estimated squared error: {ratio}");
}

#[test]
fn rounds_give_the_same_bits_again_on_any_number_of_threads() {
    let world = world(SCENE);
    let target = Target { error: Some(0.02), seed: 5, ..Target::default() };
    let first = rendered(&world, target, 1);
    let rounds = progress(&first).recipe();
    let limits: Vec<f64> = rounds.split(',').map(|limit| limit.parse().expect("a number")).collect();
    assert!(!limits.is_empty());
    let again = Target { rounds: Some(limits), seed: 5, ..Target::default() };
    for threads in [1, 3] {
        let second = rendered(&world, again.clone(), threads);
        assert_eq!((first.picture == second.picture, progress(&second).recipe()), (true, rounds.clone()));
    }
}

#[test]
fn layers_say_where_samples_went() {
    let world = world(SCENES[0]);
    let rendered = rendered(&world, Target { error: Some(0.01), ..Target::default() }, 1);
    let layer = |name: &str| {
        let layer = rendered.picture.layers.iter().find(|layer| layer.name == name).expect("a layer");
        layer.channels[0].1.clone()
    };
    let (error, samples) = (layer("error"), layer("samples"));
    assert_eq!(samples.iter().map(|n| *n as u64).sum::<u64>(), progress(&rendered).samples);
    // The flat parts of this picture need nothing, its edge does.
    let (most, least) = (samples.iter().copied().fold(0.0, f32::max), samples.iter().copied().fold(f32::MAX, f32::min));
    assert!(most >= 16.0 && least == 2.0, "{least} to {most} samples");
    let mean = error.iter().map(|e| f64::from(*e).powi(2)).sum::<f64>() / error.len() as f64;
    let ratio = mean.sqrt() / progress(&rendered).accuracy.rmse();
    assert!((0.7..1.4).contains(&ratio), "{ratio}");
}

#[test]
fn time_that_is_over_ends_it_with_a_whole_picture() {
    let target = Target { error: Some(1e-9), time: Some(std::time::Duration::ZERO), ..Target::default() };
    let rendered = rendered(&world(SCENES[3]), target, 1);
    assert!(rendered.complete && progress(&rendered).end == End::Time);
}

/// Wants no more after some blocks.
struct Impatient(AtomicUsize);

impl Observer for Impatient {
    fn finished(&self, _: &FinishedBlock) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }

    fn wants_blocks(&self) -> bool {
        true
    }

    fn cancels(&self) -> bool {
        // The picture has four blocks.
        self.0.load(Ordering::Relaxed) >= 6
    }
}

#[test]
fn who_stops_it_after_the_first_round_has_a_picture() {
    let [width, height] = SIZE;
    let target = Some(Target { error: Some(1e-3), ..Target::default() });
    let options = Options { width, height, target, ..Options::default() };
    let impatient = Impatient(AtomicUsize::new(0));
    let rendered = Session::new(1).picture(&world(SCENES[4]), &options, &impatient);
    let progress = progress(&rendered);
    assert!(rendered.complete && progress.end == End::Cancelled && progress.accuracy.rmse() > 1e-3, "{progress:?}");
}

#[test]
fn layers_of_surfaces_come_with_a_target_too() {
    let [width, height] = SIZE;
    let target = Some(Target { error: Some(0.05), ..Target::default() });
    let options = Options { width, height, target, layers: ImageLayer::ALL.to_vec(), ..Options::default() };
    let with = Session::new(1).picture(&world(SCENE), &options, &Unobserved);
    let without = Session::new(1).picture(&world(SCENE), &Options { layers: Vec::new(), ..options }, &Unobserved);
    assert_eq!(with.picture.pixels, without.picture.pixels);
    let names: Vec<&str> = with.picture.layers.iter().map(|layer| layer.name.as_str()).collect();
    let count = |name: &str| names.iter().filter(|known| **known == name).count();
    assert_eq!((count("samples"), count("error"), count("N")), (1, 1, 1), "{names:?}");
}
