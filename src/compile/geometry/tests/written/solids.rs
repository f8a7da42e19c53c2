//! What is seen of solids: of faces in one place, of parts inside of each other.

use super::appearance::met;
use crate::compile::{Functions, Queries};
use crate::compiled::geometry::{RayKind, Scratch, Shadow};
use crate::eval::{Options, evaluate};
use crate::math::{DVec3, MersenneTwister, Range, Ray};

/// Which of the parts 1, 2, 3 … of a solid a ray along z meets first, told by its texture's number; the default texture
/// has 0.
fn part_seen(solid: &str, expected: u32) {
    let scene = format!(
        "#macro B(I, A, Z) box {{ <-1, -1, A>, <1, 1, Z> pigment {{ rgb I }} }} #end
        #macro P(I, A) plane {{ -z, -A pigment {{ rgb I }} }} #end {solid}"
    );
    let seen = met(&scene, [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], |surface| surface.textures[0].texture.number());
    assert_eq!(seen, expected, "{solid}");
}

/// As POV-Ray 3.7.0.10 shows them.
#[test]
fn of_coincident_faces_of_a_solid_the_last_recorded_is_seen() {
    part_seen("intersection { B(1, 0, 1) B(2, 0, 2) }", 2);
    part_seen("intersection { B(1, 0, 1) B(2, 0, 2) B(3, 0, 3) B(4, 0, 4) }", 4);
    part_seen("intersection { B(1, 0, 1) P(2, 0) }", 2);
    part_seen("difference { B(1, 0, 1) B(2, -1, 0) }", 2);
    part_seen("merge { P(1, 0) P(2, 1) }", 1);
    part_seen("union { B(1, 0, 1) B(2, 0, 2) split_union off }", 2);
    part_seen("union { B(1, 0, 1) B(2, 0, 2) clipped_by { box { -3, 3 } } }", 2);
    // What is around takes the crossings of a part from the end.
    part_seen("intersection { intersection { B(1, 0, 1) B(2, 0, 2) } box { -3, 3 } }", 1);
    part_seen("intersection { B(1, 0, 1) intersection { B(2, 0, 2) B(3, 0, 3) } }", 2);
    part_seen("intersection { union { B(1, 0, 1) B(2, 0, 2) } box { -3, 3 } }", 1);
    part_seen(
        "intersection { intersection { intersection { B(1, 0, 1) B(2, 0, 2) } box { -3, 3 } } box { -4, 4 } }",
        2,
    );
    part_seen("union { union { B(1, 0, 1) B(2, 0, 2) } box { 5, 6 } split_union off }", 2);
    part_seen("union { union { B(1, 0, 1) B(2, 0, 2) } box { 5, 6 } clipped_by { box { -7, 7 } } }", 1);
}

/// A union turned inside out twice has become a merge, in which no part is seen inside of another.
#[test]
fn a_union_turned_twice_is_a_merge() {
    part_seen(
        "difference { B(1, -3, 3) difference { B(2, -4, 4) union { B(3, -1, 1) B(4, 0, 2) } } clipped_by { plane { -z, -.5 } } }",
        4,
    );
    part_seen("intersection { union { B(1, -1, 1) B(2, 0, 2) } clipped_by { plane { -z, -.5 } } }", 1);
    let clipped = "clipped_by { plane { -z, -.5 } }";
    part_seen(&format!("union {{ B(1, -1, 1) B(2, 0, 2) inverse inverse {clipped} }}"), 2);
    part_seen(&format!("union {{ union {{ B(1, -1, 1) B(2, 0, 2) }} inverse {clipped} inverse }}"), 2);
    part_seen(&format!("merge {{ union {{ B(1, -1, 1) B(2, 0, 2) }} inverse inverse {clipped} }}"), 2);
    part_seen(&format!("union {{ union {{ B(1, -1, 1) B(2, 0, 2) inverse inverse }} box {{ 5, 6 }} {clipped} }}"), 2);
}

/// Spheres that overlap much, by middle and radius.
fn spheres(random: &mut impl FnMut() -> f64, n: usize) -> Vec<(DVec3, f64)> {
    (0..n).map(|_| (DVec3::new(random(), random(), random()), 0.4 + 0.3 * random())).collect()
}

/// The parameters at which a line meets a sphere.
fn meetings(ray: &Ray, (middle, radius): (DVec3, f64)) -> Vec<f64> {
    let nearest = (middle - ray.origin).dot(ray.direction);
    let half = radius * radius - (ray.at(nearest) - middle).length_squared();
    if half > 0.0 { vec![nearest - half.sqrt(), nearest + half.sqrt()] } else { Vec::new() }
}

/// With a hierarchy over the parts and without, from outside and from inside: the nearest crossing that no other sphere
/// contains.
#[test]
fn the_skin_of_a_merge_is_found_from_both_sides() {
    let mut twister = MersenneTwister::default();
    let mut random = || 2.0 * twister.next_f64() - 1.0;
    for n in [2, 5, 7, 8, 40] {
        let parts = spheres(&mut random, n);
        let text: String =
            parts.iter().map(|(c, r)| format!("sphere {{ <{}, {}, {}>, {r} }} ", c.x, c.y, c.z)).collect();
        let text = format!("#version 3.7; merge {{ {text} }}");
        let read = evaluate("a.pov".as_ref(), &Options::default(), &super::super::host(&text), &Queries::default());
        let read = read.unwrap_or_else(|failed| panic!("{:?}", failed.diagnostics));
        let geometry =
            crate::compile::geometry::compile(&read.scene, &Functions::default(), crate::omission::Keep::NONE)
                .unwrap()
                .geometry;
        let scratch = &mut Scratch::default();
        for i in 0..2_000 {
            let mut vector = || DVec3::new(random(), random(), random());
            let (origin, target) = (vector() * [1.0, 5.0][i % 2], vector());
            let ray = Ray::new(origin, (target - origin).normalize());
            let is_seen = |t: &f64| {
                let depth = |(c, r): &(DVec3, f64)| r - ray.at(*t).distance(*c);
                *t > 0.0 && parts.iter().all(|part| depth(part) < 1e-9)
            };
            let all = parts.iter().flat_map(|part| meetings(&ray, *part));
            let expected = all.filter(is_seen).min_by(f64::total_cmp);
            let found = geometry.intersect(&ray, Range::FORWARD, RayKind::Camera, scratch).map(|hit| hit.t);
            let same = found.zip(expected).map_or(found == expected, |(a, b)| (a - b).abs() < 1e-9);
            assert!(same, "{n} spheres, {ray:?}: {found:?}, expected {expected:?}");
            let shadow = geometry.shadow(&ray, Range::FORWARD, 0, None, scratch);
            assert_eq!(shadow == Shadow::Blocked, expected.is_some());
        }
    }
}
