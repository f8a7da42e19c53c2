//! The size of a scene: shapes whose numbers are all multiplied, and rays with them.

use super::{Random, compile_object, v, written};
use crate::compiled::geometry::{Geometry, RayKind, Scratch};
use crate::math::{DVec3, Range, Ray};
use std::sync::Arc;

/// Shapes about as large as the unit sphere where S is 1. Those that have no lengths of their own are scaled.
const SHAPES: &[&str] = &[
    "sphere { <.3, .2, .1>*S, S }",
    "sphere { <.3, .2, .1>, 1 scale <1, .7, 1.2> rotate <20, 30, 40> scale S }",
    "box { -S, S*.8 }",
    "box { -S, S*.8 rotate <20, 30, 40> }",
    "cylinder { -S*y, S*y, S*.8 }",
    "cylinder { <-.9, -.5, .3>*S, S*y, S*.8 open }",
    "cone { -S*y, S, S*y, S*.3 }",
    "cone { -S*y, S, S*y, 0 }",
    "torus { S*.8, S*.3 }",
    "torus { S*.3, S*.8 }",
    "torus { S*.7, S*.02 rotate 50*x }",
    "ovus { S*.8, S*.5 }",
    "disc { 0, <1, 3, 1>, S, S*.3 }",
    "quadric { <1, 2, 1>, <0, .3, 0>, <0, .2, 0>*S, -S*S }",
    "superellipsoid { <.5, .4> scale S }",
    "poly { 4, <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> scale S }",
    "polynomial { 20, xyz(20,0,0): 1, xyz(0,20,0): 1, xyz(0,0,20): 1, xyz(0,0,0): -1 scale S }",
    "polygon { 5, <-1, -1>*S, <1, -1>*S, <1, 1>*S, <-.5, .7>*S, <-1, -1>*S rotate <20, 30, 40> }",
    "triangle { <-1, -1, 0>*S, <1, -1, .5>*S, <.3, 1, 0>*S }",
    "mesh { triangle { <-1, -1, 0>*S, <1, -1, .5>*S, <.3, 1, 0>*S } triangle { <-1, -1, 0>*S, <1, -1, .5>*S, <0, 0, -1>*S } }",
    "blob { threshold .5 sphere { <.4, 0, 0>*S, S, 1 } sphere { -<.4, .1, 0>*S, S, 1 } }",
    "blob { threshold .5 cylinder { -S*.6*y, S*.6*y, S*.8, 1 } sphere { <.4, 0, 0>*S, S, 1 } }",
    "prism { linear_spline -S*.3, S*.3, 5, <-1, -1>*S, <1, -1>*S, <.6, 1>*S, <-.5, .7>*S, <-1, -1>*S }",
    "prism { quadratic_spline -S*.3, S*.3, 6, <-1, .4>*S, <-1, -1>*S, <1, -1>*S, <1, .6>*S, <-.6, .7>*S, <-1, -1>*S }",
    "prism { cubic_spline -S*.3, S*.3, 7, <-1, .4>*S, <-1, -1>*S, <1, -1>*S, <1, .6>*S, <-1, .4>*S, <-1, -1>*S, <1, -1>*S }",
    "prism { bezier_spline -S*.3, S*.3, 8, <-1, 0>*S, <-1, 1>*S, <1, 1>*S, <1, 0>*S, <1, 0>*S, <1, -1>*S, <-1, -1>*S, <-1, 0>*S }",
    "lathe { linear_spline 5, <0, -1>*S, <.9, -.5>*S, <.4, .2>*S, <.6, .7>*S, <0, 1>*S }",
    "lathe { quadratic_spline 6, <.5, -1>*S, <0, -1>*S, <.9, -.5>*S, <.4, .2>*S, <.6, .7>*S, <0, 1>*S }",
    "lathe { cubic_spline 7, <.5, -1>*S, <0, -1>*S, <.9, -.5>*S, <.4, .2>*S, <.6, .7>*S, <0, 1>*S, <-.5, 1>*S }",
    "lathe { bezier_spline 4, <0, -1>*S, <.7, -1>*S, <1, -.5>*S, <.4, .1>*S }",
    "sor { 5, <.5, -1.5>*S, <.6, -1>*S, <.9, 0>*S, <.3, 1>*S, <.2, 1.5>*S }",
    "sphere_sweep { linear_spline 3, <-.8, 0, 0>*S, .4*S, <0, .5, .2>*S, .25*S, <.8, -.2, 0>*S, .35*S }",
    "sphere_sweep { b_spline 4, <-1.5, 0, 0>*S, .3*S, <-.7, .5, 0>*S, .25*S, <0, -.3, .4>*S, .4*S, <.7, .5, 0>*S, .2*S }",
    "sphere_sweep { cubic_spline 4, <-1.5, 0, 0>*S, .3*S, <-.7, .5, 0>*S, .25*S, <0, -.3, .4>*S, .4*S, <.7, .5, 0>*S, .2*S }",
    "height_field { function 17, 17 { .5 + .3*sin(5*x)*cos(4*y) } translate -.5 scale 2*S }",
    "bicubic_patch { type 1 flatness .001*S u_steps 3 v_steps 3
        <-1, -.5, -1>*S, <-.3, 0, -1>*S, <.3, 0, -1>*S, <1, .4, -1>*S, <-1, .3, -.3>*S, <-.3, 1, -.3>*S, <.3, 1, -.3>*S,
        <1, 0, -.3>*S, <-1, .3, .3>*S, <-.3, 1, .3>*S, <.3, 1.5, .3>*S, <1, 0, .3>*S, <-1, -.5, 1>*S, <-.3, 0, 1>*S,
        <.3, .2, 1>*S, <1, .3, 1>*S }",
    "text { ttf \"oA.ttf\" \"oA\" .3, 0 translate <-.6, -.3, -.15> scale S }",
    "intersection { sphere { <.3, .2, .1>*S, S } box { -S, S*.8 } }",
    "difference { box { -S, S*.8 } cone { -S*1.1*y, S, S*y, 0 } }",
    "julia_fractal { <-.083, 0, -.83, -.025> quaternion sqr max_iteration 8 precision 20 scale S }",
    "isosurface { function { x*x + y*y + z*z - S*S } contained_by { box { -S*1.1, S*1.1 } } max_gradient 4*S accuracy .0001*S }",
];

/// A shape of some size.
fn sized(shape: &str, size: f64) -> Geometry {
    let object = written(&format!("#declare S = {size:e}; {shape}"));
    compile_object(&Arc::new(object)).unwrap_or_else(|e| panic!("{shape}: {e:?}"))
}

/// Where a ray that would meet the unit sphere meets what is of another size, in its units, and the normal there.
fn met(geometry: &Geometry, size: f64, origin: DVec3, target: DVec3) -> Option<(DVec3, DVec3)> {
    let ray = Ray::new(origin * size, (target - origin).normalize());
    let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Refracted, &mut Scratch::default())?;
    let surface = geometry.surface(&ray, &hit);
    Some((surface.point / size, surface.normal))
}

/// Rays for each shape.
fn rays() -> impl Iterator<Item = [DVec3; 2]> {
    let mut random = Random(7);
    (0..200).map(move |_| [random.direction() * 4.0, random.direction() * random.unit()])
}

#[test]
fn powers_of_two_change_no_bit() {
    for shape in SHAPES {
        let here = sized(shape, 1.0);
        let mut n_met = 0;
        for k in [-40, -7, 3, 30] {
            let size = 2f64.powi(k);
            let there = sized(shape, size);
            for [origin, target] in rays() {
                let found = met(&there, size, origin, target);
                assert_eq!(found, met(&here, 1.0, origin, target), "{shape} at 2^{k}");
                n_met += u32::from(found.is_some());
            }
        }
        assert!(n_met > 10, "{shape}: only {n_met} hits");
    }
}

/// From 10^-12, where rays from as near as this have all their digits, to 10^12.
#[test]
fn no_size_changes_a_shape() {
    /// Rays of a shape that may pass by its edge on the other side, or meet a set without a smooth surface elsewhere.
    const FEW: u32 = 4;
    for shape in SHAPES {
        let here = sized(shape, 1.0);
        for size in [1e-12, 1e-9, 1e-5, 1e4, 1e8, 1e12] {
            let there = sized(shape, size);
            let same = |[origin, target]: [DVec3; 2]| match (
                met(&there, size, origin, target),
                met(&here, 1.0, origin, target),
            ) {
                (Some((p, n)), Some((point, normal))) => p.distance(point) < 1e-6 && n.distance(normal) < 1e-4,
                (found, expected) => found.is_none() && expected.is_none(),
            };
            let n_other = rays().filter(|ray| !same(*ray)).count() as u32;
            assert!(n_other <= FEW, "{shape} at {size:e}: {n_other} rays");
        }
    }
    assert!(met(&sized(SHAPES[0], 1.0), 1.0, v(0.0, 0.0, -5.0), DVec3::ZERO).is_some());
}
