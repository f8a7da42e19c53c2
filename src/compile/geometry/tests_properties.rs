//! Properties over magnitudes and transforms, with fixed seeds; rates are printed.

use super::compile_object;
use super::tests::{csg, cuboid, moved, object, sphere, v};
use crate::compiled::geometry::{Geometry, RayKind, Scratch, Surface};
use crate::math::{DVec2, DVec3, Range, Ray, Transform};
use crate::scene::{Blob, BlobComponent, CsgOperation, Mesh, Object, Prism, Shape, SweepSpline};
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

/// Rays for each shape; `WHITTED_PROPERTY_RAYS=1000000 cargo test --release properties -- --nocapture`
/// for the long run.
fn n_rays() -> u32 {
    std::env::var("WHITTED_PROPERTY_RAYS").ok().and_then(|n| n.parse().ok()).unwrap_or(10_000)
}

/// Rays sent from each random place.
const RAYS_A_PLACE: u32 = 100;

/// A field that is negative inside, in the shape's own space.
type Field = fn(DVec3) -> f64;

/// What is checked of a shape.
struct Case {
    name: &'static str,
    shape: Object,
    /// Not met again by rays that leave outward.
    convex: bool,
    /// For its normals.
    field: Option<Field>,
    /// Failures in a million rays that are allowed.
    allowed: u32,
}

impl Case {
    fn new(name: &'static str, shape: Shape) -> Self {
        Self::solid(name, object(shape))
    }

    fn solid(name: &'static str, shape: Object) -> Self {
        Self { name, shape, convex: false, field: None, allowed: 1 }
    }

    fn convex(self) -> Self {
        Self { convex: true, ..self }
    }

    /// Roots of polynomials that are eliminants of two equations: less certain next to their ends.
    fn freeform(self) -> Self {
        Self { allowed: 200, ..self }
    }

    fn field(self, field: Field) -> Self {
        Self { field: Some(field), ..self }
    }
}

/// How often what went wrong.
#[derive(Default)]
struct Failures {
    hits: u32,
    /// A ray met the point that it left.
    again: u32,
    /// `occluded` did not agree with `intersect`.
    disagree: u32,
    /// A closed surface was met an odd number of times.
    odd: u32,
    /// The ray was outside after an odd number of surfaces, or inside after an even one.
    alternate: u32,
    /// A normal did not agree with the field's differences.
    normal: u32,
}

impl Failures {
    fn all(&self) -> u32 {
        self.again + self.disagree + self.odd + self.alternate + self.normal
    }
}

/// Sends rays from outside and on from where they land, and counts what goes wrong.
fn check(case: &Case) {
    let mut random = Random(1);
    let mut failures = Failures::default();
    for _ in 0..n_rays().div_ceil(RAYS_A_PLACE) {
        let (place, size) = random_place(&mut random);
        let geometry = compile_object(&Arc::new(moved(case.shape.clone(), &place))).unwrap();
        for _ in 0..RAYS_A_PLACE {
            let origin = place.origin() + random.direction() * size * 8.0;
            let target = place.origin() + random.direction() * size * random.unit();
            let ray = Ray::new(origin, (target - origin).normalize());
            follow(case, &geometry, &place, &ray, &mut random, &mut failures);
        }
    }
    print_rates(case.name, &failures);
    assert!(failures.hits > n_rays() / 10, "{}: only {} hits", case.name, failures.hits);
    let allowed = u64::from(n_rays()) * u64::from(case.allowed) / 1_000_000;
    assert!(u64::from(failures.all()) <= allowed, "{}", case.name);
}

/// One ray, and those that leave its hits.
fn follow(case: &Case, geometry: &Geometry, place: &Transform, ray: &Ray, random: &mut Random, f: &mut Failures) {
    let mut scratch = Scratch::default();
    let mut nearest = |ray: &Ray, range: Range| geometry.intersect(ray, range, RayKind::Refracted, &mut scratch);
    let hit = nearest(ray, Range::FORWARD);
    f.disagree += u32::from(hit.is_some() != geometry.occluded(ray, Range::FORWARD, &mut Scratch::default()));
    let Some(hit) = hit else { return };
    f.hits += 1;
    let first = geometry.surface(ray, &hit);
    let away = random.direction();
    let away = if away.dot(first.geometric_normal) < 0.0 { -away } else { away };
    let (next, range) = first.leave(away);
    if let Some(hit) = nearest(&next, range) {
        // Even a shape with hollows is not met within the error of the point that was left.
        let again = case.convex || hit.t < 2.0 * first.point_error;
        f.again += u32::from(again);
    }
    if let Some(field) = case.field {
        f.normal += u32::from(!agrees(field, place, &first));
    }
    // Through and through: an even number of surfaces on the whole way, in and out by turns.
    let (mut count, mut at) = (1, first);
    for _ in 0..64 {
        let (next, range) = at.leave(ray.direction);
        let Some(hit) = nearest(&next, range) else { break };
        let there = geometry.surface(&next, &hit);
        // Not between surfaces that lie within each other's error.
        let apart = hit.t > 16.0 * at.point_error.max(there.point_error);
        let inside = geometry.contains(0.5 * at.point + 0.5 * there.point);
        f.alternate += u32::from(apart && inside != (count % 2 == 1));
        at = there;
        count += 1;
    }
    f.odd += u32::from(count % 2 == 1);
}

/// Whether the normal is the field's gradient, by differences in the shape's own space, except next to
/// edges: where differences on both sides are not the same.
fn agrees(field: Field, place: &Transform, surface: &Surface<'_>) -> bool {
    // Third derivatives are of order one: the error is of order step^2, and rounding / step below that.
    const STEP: f64 = 1e-5;
    // A thousand times the step, for the curvature of small radii.
    const SMOOTH: f64 = 1e-2;
    let p = place.inverse_point(surface.point);
    let [ahead, behind] = [STEP, -STEP]
        .map(|step| DVec3::from([0, 1, 2].map(|axis| (field(p + DVec3::AXES[axis] * step) - field(p)) / step)));
    if (ahead - behind).length() > SMOOTH * ahead.length() {
        return true;
    }
    let expected = place.normal(0.5 * (ahead + behind)).normalize();
    (expected - surface.geometric_normal).length() < 1e-4
}

#[allow(clippy::print_stdout)] // the rates are what these tests are for
fn print_rates(name: &str, f: &Failures) {
    println!(
        "{name:16} {:8} hits: {} met again, {} occluded otherwise, {} odd, {} out of turn, {} normals",
        f.hits, f.again, f.disagree, f.odd, f.alternate, f.normal
    );
}

fn length(x: f64, y: f64) -> f64 {
    x.hypot(y)
}

#[test]
fn round_shapes_at_every_scale() {
    check(&Case::solid("sphere", sphere(DVec3::ZERO, 1.0)).convex().field(|p| p.length() - 1.0));
    let cylinder = Shape::Cylinder { base: DVec3::NEG_Y, cap: DVec3::Y, radius: 1.0, open: false };
    check(&Case::new("cylinder", cylinder).convex().field(|p| (length(p.x, p.z) - 1.0).max(p.y.abs() - 1.0)));
    let cone = Shape::Cone { base: DVec3::NEG_Y, base_radius: 1.0, cap: DVec3::Y, cap_radius: 0.3, open: false };
    let cone_field: Field = |p| (length(p.x, p.z) - 0.65 + 0.35 * p.y).max(p.y.abs() - 1.0);
    check(&Case::new("cone", cone).convex().field(cone_field));
    let quadric =
        Shape::Quadric { squares: v(1.0, 2.0, 0.5), products: DVec3::ZERO, linear: DVec3::ZERO, constant: -1.0 };
    let quadric_field: Field = |p| p.x * p.x + 2.0 * p.y * p.y + 0.5 * p.z * p.z - 1.0;
    check(&Case::new("quadric", quadric).convex().field(quadric_field));
    check(&Case::new("ovus", Shape::Ovus { bottom_radius: 0.8, top_radius: 0.5, sturm: false }).convex());
}

#[test]
fn flat_shapes_at_every_scale() {
    let field: Field = |p| p.abs().max_element() - 1.0;
    check(&Case::solid("box", cuboid(DVec3::NEG_ONE, DVec3::ONE)).convex().field(field));
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]].map(DVec2::from);
    let prism = Prism {
        spline: SweepSpline::Linear,
        conic: false,
        heights: [-1.0, 1.0],
        points: corners.into(),
        open: false,
        sturm: false,
    };
    check(&Case::new("prism", Shape::Prism(Arc::new(prism))));
}

#[test]
fn quartics_at_every_scale() {
    let torus: Field = |p| length(length(p.x, p.z) - 0.8, p.y) - 0.3;
    check(&Case::new("torus", Shape::Torus { major: 0.8, minor: 0.3, sturm: false }).field(torus));
    let mut coefficients = [0.0; 35];
    for (i, c) in [(0, 1.0), (20, 1.0), (34, -0.5)] {
        coefficients[i] = c;
    }
    coefficients[30] = 1.0;
    let quartic = Shape::Polynomial { order: 4, coefficients: coefficients.into(), sturm: false };
    check(&Case::new("quartic", quartic).convex());
    let superellipsoid: Field = |p| {
        let round = p.x.abs().powf(2.0 / 0.7) + p.y.abs().powf(2.0 / 0.7);
        (round.powf(0.7 / 0.5) + p.z.abs().powf(2.0 / 0.5)).powf(0.25) - 1.0
    };
    let shape = Shape::Superellipsoid { east_west: 0.7, north_south: 0.5 };
    check(&Case::new("superellipsoid", shape).convex().field(superellipsoid));
}

#[test]
fn turned_and_swept_shapes_at_every_scale() {
    let profile = [[0.0, -1.0], [0.9, -0.5], [0.4, 0.2], [0.6, 0.7], [0.0, 1.0]].map(DVec2::from);
    let lathe = Shape::Lathe { spline: SweepSpline::Linear, points: profile.into(), sturm: false };
    check(&Case::new("lathe", lathe).freeform());
    let profile = [[0.5, -1.5], [0.6, -1.0], [0.9, 0.0], [0.3, 1.0], [0.2, 1.5]].map(DVec2::from);
    check(&Case::new("sor", Shape::Sor { points: profile.into(), open: false, sturm: false }).freeform());
    let spheres = [(v(-0.8, 0.0, 0.0), 0.4), (v(0.0, 0.5, 0.2), 0.25), (v(0.8, -0.2, 0.0), 0.35)];
    let sweep = Shape::SphereSweep { spline: SweepSpline::Linear, spheres: spheres.into(), tolerance: 1e-6 };
    check(&Case::new("sphere_sweep", sweep).freeform());
    let part = |center: DVec3| BlobComponent {
        ends: [center; 2],
        is_cylinder: false,
        radius: 1.0,
        strength: 1.0,
        transform: Transform::IDENTITY,
        texture: None,
    };
    let blob = Blob { threshold: 0.4, components: vec![part(DVec3::X * 0.4), part(DVec3::X * -0.4)], sturm: false };
    check(&Case::new("blob", Shape::Blob(Arc::new(blob))).freeform());
}

#[test]
fn meshes_at_every_scale() {
    // A cube of twelve triangles.
    let vertices = (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 })).collect();
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = sides.iter().flat_map(|[a, b, c, d]| [[*a, *c, *b], [*a, *d, *c]]).collect();
    let mesh = Mesh { vertices, faces, inside_vector: Some(v(0.1, 0.9, 0.2)), ..Mesh::default() };
    check(&Case::new("mesh", Shape::Mesh(Arc::new(mesh))).convex());
}

#[test]
fn solids_at_every_scale() {
    let dice = csg(CsgOperation::Intersection, [cuboid(DVec3::NEG_ONE, DVec3::ONE), sphere(DVec3::ZERO, 1.3)]);
    check(&Case::solid("intersection", dice.clone()).convex());
    let hollow = csg(CsgOperation::Difference, [dice, sphere(v(0.3, 0.2, 0.1), 0.9)]);
    check(&Case::solid("difference", hollow));
    let pair = csg(CsgOperation::Merge, [sphere(DVec3::X * 0.5, 0.8), sphere(DVec3::X * -0.5, 0.8)]);
    check(&Case::solid("merge", pair));
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
