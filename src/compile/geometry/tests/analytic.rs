//! Probe values of analytic shapes and of solids: what `trace` and `inside` give in POV-Ray (shape facts, sections 2 to
//! 11).

use super::*;
use crate::compile::Functions;
use crate::omission::Keep;

/// An object turned inside out.
fn inverse(mut o: Object) -> Object {
    o.flags.inverse = !o.flags.inverse;
    o.flags.turned = true;
    o
}

fn cylinder(base: DVec3, cap: DVec3, radius: f64, open: bool) -> Object {
    object(Shape::Cylinder { base, cap, radius, open })
}

fn cone(base: DVec3, base_radius: f64, cap: DVec3, cap_radius: f64, open: bool) -> Object {
    object(Shape::Cone { base, base_radius, cap, cap_radius, open })
}

fn torus(major: f64, minor: f64) -> Object {
    object(Shape::Torus { major, minor, sturm: false })
}

fn triangle(a: DVec3, b: DVec3, c: DVec3) -> Object {
    object(Shape::Triangle { vertices: [a, b, c] })
}

#[test]
fn spheres() {
    let s = sphere(DVec3::ZERO, 1.0);
    check(&s, v(0.0, 0.0, -5.0), DVec3::Z, Some((v(0.0, 0.0, -1.0), Some(DVec3::NEG_Z))));
    check(&inverse(s.clone()), v(0.0, 0.0, -5.0), DVec3::Z, Some((v(0.0, 0.0, -1.0), Some(DVec3::Z))));
    check(&sphere(DVec3::ZERO, -1.0), v(0.0, 0.0, -5.0), DVec3::Z, Some((v(0.0, 0.0, -1.0), Some(DVec3::Z))));
    check(&s, v(0.0, 1.5, -5.0), DVec3::Z, None);
    // Smaller than POV-Ray can see.
    check(&sphere(DVec3::ZERO, 1e-6), v(0.0, 0.0, -5.0), DVec3::Z, Some((v(0.0, 0.0, -1e-6), None)));
    assert!(!inside(&s, DVec3::X) && inside(&s, v(0.99, 0.0, 0.0)));
    let egg = moved(s, &Transform::scaling(v(1.0, 2.0, 1.0)));
    check(&egg, v(0.0, 5.0, 0.0), DVec3::NEG_Y, Some((v(0.0, 2.0, 0.0), Some(DVec3::Y))));
}

#[test]
fn boxes() {
    let b = cuboid(DVec3::splat(-1.0), DVec3::ONE);
    check(&b, v(3.0, 3.0, 0.0), v(-1.0, -1.0, 0.0), Some((v(1.0, 1.0, 0.0), Some(DVec3::X))));
    check(&b, v(2.0, 3.0, 0.0), v(-1.0, -2.0, 0.0), Some((v(1.0, 1.0, 0.0), Some(DVec3::Y))));
    check(&b, v(3.0, 3.0, 3.0), DVec3::NEG_ONE, Some((DVec3::ONE, Some(DVec3::X))));
    check(&cuboid(DVec3::ZERO, DVec3::ONE), v(0.0, 0.5, -5.0), DVec3::Z, Some((v(0.0, 0.5, 0.0), None)));
    assert!(inside(&b, DVec3::X) && !inside(&inverse(b), DVec3::X));
}

#[test]
fn cones_and_cylinders() {
    let c = cone(DVec3::ZERO, 2.0, 4.0 * DVec3::Y, 1.0, false);
    let normal = v(-0.970_142_500, 0.242_535_625, 0.0);
    check(&c, v(-10.0, 2.0, 0.0), DVec3::X, Some((v(-1.5, 2.0, 0.0), Some(normal))));
    check(&c, v(0.5, 10.0, 0.5), DVec3::NEG_Y, Some((v(0.5, 4.0, 0.5), Some(DVec3::Y))));
    assert!(
        !inside(&c, v(1.5, 2.0, 0.0)) && inside(&cone(DVec3::ZERO, 2.0, 4.0 * DVec3::Y, 1.0, true), v(1.5, 2.0, 0.0))
    );
    let slim = |end| cone(DVec3::ZERO, 1.0, DVec3::Y, end, false);
    check(&slim(1.0 - 0.9e-5), v(-5.0, 0.999, 0.0), DVec3::X, Some((v(-1.0, 0.999, 0.0), None)));
    check(&slim(1.0 - 1.1e-5), v(-5.0, 0.999, 0.0), DVec3::X, Some((v(-0.999_989_011, 0.999, 0.0), None)));
    let rod = cylinder(DVec3::ZERO, v(3.0, 4.0, 0.0), 1.0, false);
    check(&rod, v(-3.0, -4.0, 0.0), v(3.0, 4.0, 0.0), Some((DVec3::ZERO, Some(v(-0.6, -0.8, 0.0)))));
    // Far from the origin, where single-precision boxes would lose it.
    let far = cylinder(v(1e5 + 0.3, 0.0, 0.0), v(1e5 + 0.3, 1.0, 0.0), 0.003, false);
    check(&far, v(1e5 + 0.3, 0.5, -5.0), DVec3::Z, Some((v(1e5 + 0.3, 0.5, -0.003), None)));
}

#[test]
fn tori() {
    let normal = v(-0.979_795_897, 0.2, 0.0);
    check(&torus(2.0, 0.5), v(-5.0, 0.1, 0.0), DVec3::X, Some((v(-2.489_897_949, 0.1, 0.0), Some(normal))));
    check(&torus(2e-3, 0.5e-3), v(-5.0, 0.0, 0.0), DVec3::X, Some((v(-0.0025, 0.0, 0.0), None)));
    check(&torus(0.0, 1.0), v(-5.0, 0.1, 0.0), DVec3::X, Some((v(-0.994_987_437, 0.1, 0.0), None)));
    check(&torus(2.0, 0.5), v(0.0, 5.0, 0.0), DVec3::NEG_Y, None);
    assert!(inside(&torus(0.5, 1.0), DVec3::ZERO));
}

#[test]
fn planes_and_discs() {
    let p = |n, d| object(Shape::Plane { normal: n, distance: d });
    check(&p(2.0 * DVec3::Y, 3.0), v(0.0, 10.0, 0.0), DVec3::NEG_Y, Some((3.0 * DVec3::Y, Some(DVec3::Y))));
    let mirrored = moved(p(DVec3::Y, 3.0), &Transform::scaling(v(1.0, -1.0, 1.0)));
    check(&mirrored, v(0.0, 10.0, 0.0), DVec3::NEG_Y, Some((-3.0 * DVec3::Y, Some(DVec3::NEG_Y))));
    check(&inverse(p(DVec3::Y, 3.0)), v(0.0, 10.0, 0.0), DVec3::NEG_Y, Some((3.0 * DVec3::Y, Some(DVec3::NEG_Y))));
    assert!(inside(&p(DVec3::Y, 0.1), v(0.3, 0.1, 7.0)) && inside(&inverse(p(DVec3::Y, 0.1)), v(0.3, 0.1, 7.0)));
    let disc = object(Shape::Disc { center: DVec3::Y, normal: DVec3::Y, radius: 2.0, hole_radius: 0.5 });
    check(&disc, v(1.0, 5.0, 0.0), DVec3::NEG_Y, Some((v(1.0, 1.0, 0.0), Some(DVec3::Y))));
    check(&disc, v(0.1, 5.0, 0.0), DVec3::NEG_Y, None);
    assert!(inside(&disc, DVec3::ZERO) && !inside(&disc, 2.0 * DVec3::Y));
}

#[test]
fn triangles_turn_their_normal_when_moved() {
    let t = triangle(DVec3::ZERO, 2.0 * DVec3::Y, 2.0 * DVec3::X);
    let from = v(0.5, 0.5, -5.0);
    check(&t, from, DVec3::Z, Some((v(0.5, 0.5, 0.0), Some(DVec3::Z))));
    let t = moved(t, &Transform::translation(v(0.0, 0.0, 1.0)));
    check(&t, from, DVec3::Z, Some((v(0.5, 0.5, 1.0), Some(DVec3::NEG_Z))));
    let smooth = object(Shape::SmoothTriangle(Box::new(crate::scene::SmoothTriangle {
        vertices: [DVec3::ZERO, 2.0 * DVec3::X, 2.0 * DVec3::Y],
        normals: [DVec3::NEG_ONE.normalize(), v(1.0, 0.0, -1.0).normalize(), v(0.0, 1.0, -1.0).normalize()],
    })));
    let normal = v(-0.169_174_539, -0.169_174_539, -0.970_958_264);
    check(&smooth, from, DVec3::Z, Some((v(0.5, 0.5, 0.0), Some(normal))));
}

#[test]
fn solids() {
    use CsgOperation::{Difference, Intersection, Merge, Union};
    let big = || cuboid(DVec3::splat(-1.0), DVec3::ONE);
    let cut = csg(Difference, [big(), cuboid(v(-0.5, -2.0, -0.5), v(0.5, 1.0, 0.5))]);
    check(&cut, v(0.0, 5.0, 0.0), DVec3::NEG_Y, Some((DVec3::Y, Some(DVec3::NEG_Y))));
    let drilled = |open| csg(Difference, [big(), cylinder(-2.0 * DVec3::Y, DVec3::Y, 0.5, open)]);
    check(&drilled(true), v(0.0, 5.0, 0.0), DVec3::NEG_Y, None);
    check(&drilled(false), v(0.0, 5.0, 0.0), DVec3::NEG_Y, Some((DVec3::Y, None)));
    let shell = csg(Difference, [sphere(DVec3::ZERO, 1.0), sphere(DVec3::ZERO, 0.5)]);
    let nested = csg(Difference, [sphere(DVec3::ZERO, 2.0), shell.clone()]);
    assert!(inside(&nested, DVec3::ZERO) && !inside(&nested, 0.7 * DVec3::Z) && inside(&nested, 1.5 * DVec3::Z));
    check(&nested, DVec3::ZERO, DVec3::Z, Some((0.5 * DVec3::Z, None)));
    check(&nested, 0.6 * DVec3::Z, DVec3::Z, Some((DVec3::Z, None)));
    let pair = || [sphere(v(-0.5, 0.0, 0.0), 1.0), sphere(v(0.5, 0.0, 0.0), 1.0)];
    check(&csg(Union, pair()), v(-0.4, 0.0, 0.0), DVec3::X, Some((v(0.5, 0.0, 0.0), None)));
    check(&csg(Merge, pair()), v(-0.4, 0.0, 0.0), DVec3::X, Some((v(1.5, 0.0, 0.0), None)));
    check(&csg(Intersection, pair()), v(-5.0, 0.0, 0.0), DVec3::X, Some((v(-0.5, 0.0, 0.0), Some(DVec3::NEG_X))));
    // Turned inside out twice is the same; once, normals turn.
    let turned = inverse(csg(Intersection, pair()));
    check(&turned, v(-5.0, 0.0, 0.0), DVec3::X, Some((v(-0.5, 0.0, 0.0), Some(DVec3::X))));
    assert!(inside(&turned, 5.0 * DVec3::X) && !inside(&turned, DVec3::ZERO));
}

#[test]
fn eggs() {
    let ovus = |b, t| object(Shape::Ovus { bottom_radius: b, top_radius: t, sturm: false });
    let from = v(-5.0, 0.5, 0.0);
    let normal = v(-0.949_917_760, 0.3125, 0.0);
    check(&ovus(1.0, 0.5), from, DVec3::X, Some((v(-0.907_678_778, 0.5, 0.0), Some(normal))));
    check(&ovus(1.0, 1.5), from, DVec3::X, Some((v(-1.417_191_316, 0.5, 0.0), None)));
    check(&ovus(1.0, 1.0), from, DVec3::X, Some((v(-1.133_974_596, 0.5, 0.0), None)));
}

#[test]
fn polynomials() {
    // x⁴ + y⁴ + z⁴ = 1 and x⁶ + y⁶ + z⁶ = 1, by the place of their four coefficients.
    let poly = |order: u32, pure: [usize; 4], n: usize| {
        let mut coefficients = vec![0.0; n];
        for (place, value) in pure.into_iter().zip([1.0, 1.0, 1.0, -1.0]) {
            coefficients[place] = value;
        }
        object(Shape::Polynomial { order, coefficients: coefficients.into(), sturm: false })
    };
    let quartic = poly(4, [0, 20, 30, 34], 35);
    for distance in [5.0, 1e3, 1e4, 1e5] {
        let hit = v(0.3, 0.2, -0.997_566_129);
        check(&quartic, v(0.3, 0.2, -distance), DVec3::Z, Some((hit, None)));
    }
    let sextic = poly(6, [0, 56, 77, 83], 84);
    check(&sextic, v(0.3, 0.2, -5.0), DVec3::Z, Some((v(0.3, 0.2, -0.999_867_790), None)));
    assert!(inside(&quartic, v(0.99, 0.0, 0.0)) && !inside(&quartic, v(1.01, 0.0, 0.0)));
    let ball = |o: Object| inverse(o);
    let quadric =
        object(Shape::Quadric { squares: DVec3::ONE, products: DVec3::ZERO, linear: DVec3::ZERO, constant: -1.0 });
    let normal = v(0.0, 0.5, -0.866_025_404);
    let hit = v(0.0, 0.5, -0.866_025_404);
    check(&quadric, v(0.0, 0.5, -5.0), DVec3::Z, Some((hit, Some(normal))));
    check(&ball(quadric.clone()), v(0.0, 0.5, -5.0), DVec3::Z, Some((hit, Some(normal))));
    assert!(inside(&quadric, DVec3::X) && !inside(&ball(quadric), DVec3::ZERO));
}

#[test]
fn superellipsoids() {
    let s = |e, n| object(Shape::Superellipsoid { east_west: e, north_south: n });
    let normal = v(0.000_261_922, 0.000_077_606, -0.999_999_963);
    check(&s(0.5, 0.25), v(0.3, 0.2, -5.0), DVec3::Z, Some((v(0.3, 0.2, -0.999_988_238), Some(normal))));
    check(&s(0.5, 0.25), DVec3::splat(5.0), DVec3::NEG_ONE, Some((DVec3::splat(0.817_765_434), None)));
    let far = moved(s(0.5, 0.25), &Transform::scaling(DVec3::splat(1e3)));
    check(&far, v(0.0, 0.0, -1000.05), DVec3::Z, Some((v(0.0, 0.0, -1000.0), None)));
}

#[test]
fn polygons() {
    let square = |side: f64, off: f64| {
        let points = [v(0.0, 0.0, 0.0), v(side, 0.0, 0.0), v(side, side, 0.0), v(0.0, side, off), v(0.0, 0.0, 0.0)];
        object(Shape::Polygon { points: points.into() })
    };
    check(&square(1.0, 0.0), v(0.5, 0.5, -5.0), DVec3::Z, Some((v(0.5, 0.5, 0.0), Some(DVec3::Z))));
    check(&square(1.0, 0.0), v(1.5, 0.5, -5.0), DVec3::Z, None);
    check(&square(4e-3, 0.0), v(1e-3, 1e-3, -5.0), DVec3::Z, Some((v(1e-3, 1e-3, 0.0), None)));
    // POV-Ray loses polygons of less than about 0.003.
    check(&square(2e-3, 0.0), v(1e-3, 1e-3, -5.0), DVec3::Z, Some((v(1e-3, 1e-3, 0.0), None)));
    check(&square(1.0, 1e-9), v(0.5, 0.5, -5.0), DVec3::Z, None);
}

#[test]
fn clips_keep_surfaces_open() {
    let mut half = sphere(DVec3::ZERO, 1.0);
    half.rare.clipped_by.push(Arc::new(object(Shape::Plane { normal: DVec3::Z, distance: 0.0 })));
    check(&half, v(0.0, 0.0, 5.0), DVec3::NEG_Z, Some((DVec3::NEG_Z, Some(DVec3::NEG_Z))));
    let half = moved(half, &Transform::rotation_deg(v(0.0, 180.0, 0.0)));
    check(&half, v(0.0, 0.0, 5.0), DVec3::NEG_Z, Some((DVec3::Z, Some(DVec3::Z))));
    assert!(inside(&half, 0.5 * DVec3::Z) && !inside(&half, -0.5 * DVec3::Z));
}

#[test]
fn objects_nest_deeply() {
    let mut o = sphere(DVec3::ZERO, 1.0);
    for _ in 0..1000 {
        o = csg(CsgOperation::Union, [o, sphere(DVec3::X, 1.0)]);
    }
    assert!(inside(&o, 0.5 * DVec3::X) && !inside(&o, -2.0 * DVec3::X));
}

#[test]
fn what_stood_in_the_way_last_changes_no_answer() {
    // A shared group that reaches to infinity, in two places.
    let spheres = (0..6).map(|i| sphere(v(3.0 * f64::from(i), 0.0, 0.0), 1.0));
    let floor = object(Shape::Plane { normal: DVec3::Y, distance: -100.0 });
    let thing = csg(CsgOperation::Union, spheres.chain([floor]));
    let copies = [-50.0, 50.0].map(|x| moved(thing.clone(), &Transform::translation(v(x, 0.0, 0.0))));
    let default = Arc::default();
    let objects: Vec<_> = copies.iter().map(|o| (o, &default)).collect();
    let settings = crate::scene::Settings::default();
    let geometry = crate::compile::geometry::build(&objects, true, &settings, (&Functions::default(), Keep::NONE))
        .unwrap()
        .geometry;
    assert_eq!(geometry.instances.len(), 2);
    let mut scratch = Scratch::default();
    // From above onto the copies and beside them, by turns.
    for x in [-50.0, 0.0, 53.0, 3.0, -47.0, 100.0] {
        let ray = Ray::new(v(x, 10.0, 0.0), DVec3::NEG_Y);
        let range = Range { max: 50.0, ..Range::FORWARD };
        let fresh = geometry.shadow(&ray, range, 0, None, &mut Scratch::default());
        assert_eq!(geometry.shadow(&ray, range, 0, None, &mut scratch), fresh, "at x = {x}");
    }
}

#[test]
fn rays_along_the_axis_meet_a_cone() {
    let slope = Some(v(1.0, 1.0, 0.0).normalize());
    check(
        &cone(DVec3::ZERO, 1.0, DVec3::Y, 0.0, false),
        v(0.5, 5.0, 0.0),
        DVec3::NEG_Y,
        Some((v(0.5, 0.5, 0.0), slope)),
    );
    check(&cylinder(DVec3::ZERO, DVec3::Y, 1.0, true), v(0.5, 5.0, 0.0), DVec3::NEG_Y, None);
}
