//! Properties over magnitudes and transforms, with fixed seeds; rates are printed.

use super::compile_object;
use super::tests::{csg, cuboid, moved, object, sphere, v};
use crate::compiled::geometry::{RayKind, Scratch};
use crate::math::{DVec3, Range, Ray, Transform};
use crate::scene::{CsgOperation, Object, Shape};
use std::sync::Arc;

/// A small generator with a fixed seed. Source: Steele, Lea, Flood, Fast Splittable Pseudorandom
/// Number Generators, 2014 (SplitMix64).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let p = DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0;
            if let Some(d) = p.try_normalize()
                && p.length() < 1.0
            {
                return d;
            }
        }
    }
}

/// A similarity of random size between 1e-6 and 1e6, with some uneven stretch and a shift.
fn random_place(random: &mut Random) -> (Transform, f64) {
    let size = 10f64.powf(random.unit() * 12.0 - 6.0);
    let stretch = DVec3::new(random.unit(), random.unit(), random.unit()) + 0.5;
    let turn = random.direction() * 180.0;
    let shift = random.direction() * size * 3.0;
    let place = Transform::scaling(stretch * size).then(&Transform::rotation_deg(turn));
    (place.then(&Transform::translation(shift)), size)
}

/// Sends rays from outside and on from where they land. A convex shape is not met again when
/// the ray leaves outwards; `occluded` agrees with `intersect`; a closed one is left as often as
/// entered. At most `allowed` failures among all rays.
fn check(name: &str, shape: &Object, convex: bool, allowed: u32) {
    let mut random = Random(1);
    let (mut again, mut disagree, mut odd, mut hits) = (0, 0, 0, 0);
    let mut scratch = Scratch::default();
    for _ in 0..100 {
        let (place, size) = random_place(&mut random);
        let geometry = compile_object(&Arc::new(moved(shape.clone(), &place))).unwrap();
        for _ in 0..100 {
            let origin = place.origin() + random.direction() * size * 8.0;
            let target = place.origin() + random.direction() * size * random.unit();
            let ray = Ray::new(origin, (target - origin).normalize());
            let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Refracted, &mut scratch);
            disagree += u32::from(hit.is_some() != geometry.occluded(&ray, Range::FORWARD, 0, &mut scratch));
            let Some(hit) = hit else { continue };
            hits += 1;
            let surface = geometry.surface(&ray, &hit);
            if convex {
                let away = random.direction();
                let away = if away.dot(surface.geometric_normal) < 0.0 { -away } else { away };
                let (next, range) = surface.leave(away);
                again += u32::from(geometry.intersect(&next, range, RayKind::Refracted, &mut scratch).is_some());
            }
            // Through and through: an even number of surfaces on the whole way.
            let (mut count, mut at) = (1, surface);
            for _ in 0..64 {
                let (next, range) = at.leave(ray.direction);
                let Some(hit) = geometry.intersect(&next, range, RayKind::Refracted, &mut scratch) else { break };
                at = geometry.surface(&next, &hit);
                count += 1;
            }
            odd += u32::from(count % 2 == 1);
        }
    }
    println_rates(name, hits, again, disagree, odd);
    assert!(hits > 1000, "{name}: only {hits} hits");
    assert!(
        again + disagree + odd <= allowed,
        "{name}: {hits} hits, {again} met again, {disagree} disagree, {odd} odd"
    );
}

#[allow(clippy::print_stdout)] // the rates are what these tests are for
fn println_rates(name: &str, hits: u32, again: u32, disagree: u32, odd: u32) {
    println!("{name}: {hits} hits, {again} met again, {disagree} disagree with occluded, {odd} odd");
}

#[test]
fn analytic_shapes_at_every_scale() {
    check("sphere", &sphere(DVec3::ZERO, 1.0), true, 0);
    check("box", &cuboid(DVec3::NEG_ONE, DVec3::ONE), true, 0);
    let cylinder = Shape::Cylinder { base: DVec3::NEG_Y, cap: DVec3::Y, radius: 1.0, open: false };
    check("cylinder", &object(cylinder), true, 0);
    let cone = Shape::Cone { base: DVec3::NEG_Y, base_radius: 1.0, cap: DVec3::Y, cap_radius: 0.3, open: false };
    check("cone", &object(cone), true, 0);
    check("torus", &object(Shape::Torus { major: 0.8, minor: 0.3, sturm: false }), false, 0);
    let quadric =
        Shape::Quadric { squares: v(1.0, 2.0, 0.5), products: DVec3::ZERO, linear: DVec3::ZERO, constant: -1.0 };
    check("quadric", &object(quadric), true, 0);
    check("superellipsoid", &object(Shape::Superellipsoid { east_west: 0.7, north_south: 0.5 }), true, 0);
    check("ovus", &object(Shape::Ovus { bottom_radius: 0.8, top_radius: 0.5, sturm: false }), true, 0);
}

#[test]
fn solids_at_every_scale() {
    let dice = csg(CsgOperation::Intersection, [cuboid(DVec3::NEG_ONE, DVec3::ONE), sphere(DVec3::ZERO, 1.3)]);
    check("intersection", &dice, true, 0);
    let hollow = csg(CsgOperation::Difference, [dice, sphere(v(0.3, 0.2, 0.1), 0.9)]);
    check("difference", &hollow, false, 0);
}

#[test]
fn powers_of_two_change_no_bit() {
    let torus = object(Shape::Torus { major: 0.8, minor: 0.3, sturm: false });
    for shape in [sphere(v(0.1, 0.2, 0.3), 0.7), cuboid(DVec3::NEG_ONE, DVec3::ONE), torus] {
        let trace = |k: i32| {
            let factor = 2f64.powi(k);
            let scaled = moved(shape.clone(), &Transform::scaling(DVec3::splat(factor)));
            let geometry = compile_object(&Arc::new(scaled)).unwrap();
            let ray = Ray::new(v(0.9, 0.1, -5.0) * factor, v(-0.1, 0.02, 1.0).normalize());
            let hit = geometry.intersect(&ray, Range::FORWARD, RayKind::Refracted, &mut Scratch::default()).unwrap();
            let surface = geometry.surface(&ray, &hit);
            (surface.point / factor, surface.normal)
        };
        let here = trace(0);
        for k in [-40, -7, 3, 30] {
            assert_eq!(trace(k), here);
        }
    }
}
