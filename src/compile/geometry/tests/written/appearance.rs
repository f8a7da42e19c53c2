//! What is known of the place that a ray meets: which object, its coordinates, its textures.

use super::super::host;
use super::same;
use crate::compile::{Functions, Queries};
use crate::compiled::geometry::{RayKind, Scratch, Surface};
use crate::eval::{Options, evaluate};
use crate::math::{DVec2, DVec3, Range, Ray};

/// What a ray meets first in a whole scene.
pub(super) fn met<T>(scene: &str, origin: [f64; 3], direction: [f64; 3], of: impl Fn(&Surface) -> T) -> T {
    let text = format!("#version 3.7; {scene}");
    let read = evaluate("a.pov".as_ref(), &Options::default(), &host(&text), &Queries::default());
    let read = read.unwrap_or_else(|failed| panic!("{:?}\n{text}", failed.diagnostics));
    let geometry = crate::compile::geometry::compile(&read.scene, &Functions::default(), crate::omission::Keep::NONE)
        .unwrap()
        .geometry;
    let ray = Ray::new(DVec3::from(origin), DVec3::from(direction).normalize());
    let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Camera, &mut Scratch::default());
    of(&geometry.surface(&ray, &hit.unwrap_or_else(|| panic!("nothing hit: {scene}"))))
}

/// The number of the object that a ray along z meets.
fn first_object(scene: &str) -> u32 {
    met(scene, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], |surface| surface.object.number())
}

/// Surface coordinates, to the digits that were measured: freeform facts, section 11.
fn coordinates(object: &str, origin: [f64; 3], direction: [f64; 3], expected: [f64; 2]) {
    let found = met(object, origin, direction, |surface| surface.uv.get());
    assert!(found.distance(DVec2::from(expected)) < 1e-3, "{object}: {found}, expected {expected:?}");
}

#[test]
fn surface_coordinates() {
    let (px, mx, pz) = ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let (mz, py, my) = ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]);
    let ball = "sphere { 0, 1 }";
    coordinates(ball, [9.0, 0.0, 0.0], mx, [0.0, 0.5]);
    coordinates(ball, [0.0, 0.0, 9.0], mz, [0.25, 0.5]);
    coordinates(ball, [-9.0, 0.0, 0.0], px, [0.5, 0.5]);
    coordinates(ball, [0.0, 0.0, -9.0], pz, [0.75, 0.5]);
    coordinates(ball, [3.0, 5.0, 4.0], [-3.0, -5.0, -4.0], [0.148, 0.75]);
    // Turned with the sphere, even where that leaves it a sphere.
    coordinates("sphere { 0, 1 rotate 90*y }", [0.0, 0.0, -9.0], pz, [0.0, 0.5]);
    let cube = "box { 0, 1 }";
    coordinates(cube, [0.25, 0.5, -9.0], pz, [0.9375, 0.5]);
    coordinates(cube, [0.25, -9.0, 0.75], py, [0.3125, 0.25]);
    coordinates(cube, [-9.0, 0.25, 0.5], px, [0.125, 0.4167]);
    coordinates(cube, [9.0, 0.25, 0.5], mx, [0.625, 0.4167]);
    coordinates(cube, [0.25, 9.0, 0.75], my, [0.3125, 0.75]);
    coordinates(cube, [0.25, 0.5, 9.0], mz, [0.3125, 0.5]);
    let ring = "torus { 2, .5 }";
    coordinates(ring, [9.0, 0.0, 0.0], mx, [0.5, 0.5]);
    coordinates(ring, [0.0, 0.0, 9.0], mz, [0.25, 0.5]);
    coordinates(ring, [2.0, 9.0, 0.0], my, [0.5, 0.75]);
    coordinates("ovus { 1, .5 }", [9.0, 0.0, 0.0], mx, [0.0, 0.422]);
    let lathe = "lathe { linear_spline 3, <1,0>, <2,1>, <1,2> }";
    coordinates(lathe, [0.3, 0.5, -5.0], pz, [0.782, 0.25]);
    coordinates(lathe, [0.3, 1.75, -5.0], pz, [0.7886, 0.875]);
    let sor = "sor { 5, <1,-1>, <1,0>, <2,1>, <1,2>, <1,3> }";
    coordinates(sor, [0.3, 9.0, 0.4], my, [0.1476, 1.5]);
    coordinates(sor, [0.3, -9.0, 0.4], py, [0.1476, -0.5]);
    // All others take the place in the world.
    coordinates("plane { z, 0 scale 3 translate x }", [0.25, 0.75, -9.0], pz, [0.25, 0.75]);
    coordinates("cylinder { -y, y, 1 rotate 20*y }", [0.25, 0.75, -9.0], pz, [0.25, 0.75]);
}

#[test]
fn coordinates_of_faces() {
    let z = [0.0, 0.0, 1.0];
    let square = |uv: &str| {
        format!(
            "mesh2 {{ vertex_vectors {{ 4, <0,0,0>, <1,0,0>, <0,1,0>, <1,1,0> }} uv_vectors {{ {uv} }}
            face_indices {{ 2, <0,1,2>, <1,3,2> }} }}"
        )
    };
    coordinates(&square("4, <0,0>, <.5,0>, <0,.25>, <.5,.25>"), [0.25, 0.75, -9.0], z, [0.125, 0.1875]);
    coordinates(&square("1, <.3,.2>"), [0.25, 0.75, -9.0], z, [0.3, 0.2]);
    coordinates("mesh { triangle { 0, x, y } }", [0.25, 0.25, -9.0], z, [0.0, 0.0]);
    let rows = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| format!("<{j}, {i}, 0>")).join(", ")).join(", ");
    coordinates(&format!("bicubic_patch {{ type 0 {rows} }}"), [0.5, 2.5, -9.0], z, [0.1667, 0.8333]);
}

#[test]
fn shares_of_textures() {
    let colors = "#declare R = texture { pigment { rgb x } } #declare G = texture { pigment { rgb y } }
        #declare B = texture { pigment { rgb z } }";
    let shares = |object: &str, [x, y]: [f64; 2]| {
        met(&format!("{colors} {object}"), [x, y, -9.0], [0.0, 0.0, 1.0], |surface| {
            surface.textures.iter().map(|t| f64::from(t.weight)).collect::<Vec<_>>()
        })
    };
    let mixed = "mesh { triangle { 0, x, y texture_list { R, G, B } } }";
    assert!(same(&shares(mixed, [0.375, 0.375]), &[0.25, 0.375, 0.375], 1e-6));
    // POV-Ray gives each a third here, below its smallest triangle.
    let small = "mesh { triangle { 0, .001*x, .001*y texture_list { R, G, B } } }";
    assert!(same(&shares(small, [0.375e-3, 0.375e-3]), &[0.25, 0.375, 0.375], 1e-6));
    let blob = "blob { threshold .5 sphere { 0, 2, 1 texture { R } } sphere { x, 2, 1 texture { G } }
        sphere { <.5, .5, -1.2>, 1.5, -.3 texture { B } } }";
    // The last part comes first.
    assert!(same(&shares(blob, [-0.25, 0.75]), &[0.1593, 0.1532, 0.6875], 1e-4), "{:?}", shares(blob, [-0.25, 0.75]));
}

/// Shape facts, section 13.
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
