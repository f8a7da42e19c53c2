//! Properties over magnitudes and transforms, with fixed seeds; rates are printed.

mod freeform;
mod implicit;
mod round;
mod size;
mod solids;
mod swept;

use super::{compile_object, moved, v, written};
use crate::compiled::geometry::{Geometry, RayKind, Scratch, Shadow, Surface};
use crate::math::{DVec3, Range, Ray, Transform};
use crate::scene::Object;
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

/// How a shape divides space.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Finite: a ray that starts outside ends there.
    Solid,
    /// With an inside that may reach to infinity.
    Endless,
    /// With an inside that is open at its sides.
    Open,
    /// Without an inside.
    Sheet,
}

/// What is checked of a shape.
struct Case {
    name: &'static str,
    /// In POV-Ray's language, about as large as the unit sphere. `SIZE` stands for the magnitude in shapes
    /// whose accuracy is an absolute length; others are scaled.
    text: String,
    kind: Kind,
    /// Not met again by rays that leave outward.
    convex: bool,
    /// For its normals.
    field: Option<Field>,
    /// Length of the difference between normals that is still agreement: rounding of the differences, or
    /// what the shape's own approximation costs.
    normal_tolerance: f64,
    /// Failures in a million rays that are allowed.
    allowed: u32,
    /// Only one of so many rays is sent.
    one_of: u32,
}

impl Case {
    fn new(name: &'static str, kind: Kind, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { name, text, kind, convex: false, field: None, normal_tolerance: 1e-4, allowed: 0, one_of: 1 }
    }

    fn solid(name: &'static str, text: impl Into<String>) -> Self {
        Self::new(name, Kind::Solid, text)
    }

    fn endless(name: &'static str, text: impl Into<String>) -> Self {
        Self::new(name, Kind::Endless, text)
    }

    fn open(name: &'static str, text: impl Into<String>) -> Self {
        Self::new(name, Kind::Open, text)
    }

    fn sheet(name: &'static str, text: impl Into<String>) -> Self {
        Self::new(name, Kind::Sheet, text)
    }

    fn convex(self) -> Self {
        Self { convex: true, ..self }
    }

    /// Fails in so many of a million rays, for the reason that stands beside the case.
    fn allowed(self, allowed: u32) -> Self {
        Self { allowed, ..self }
    }

    fn field(self, field: Field) -> Self {
        Self { field: Some(field), ..self }
    }

    fn normals_within(self, normal_tolerance: f64) -> Self {
        Self { normal_tolerance, ..self }
    }

    /// One ray takes as long as so many of others.
    fn slow(self, one_of: u32) -> Self {
        Self { one_of, ..self }
    }

    /// The shape in a place.
    fn placed(&self, unit: &Object, place: &Transform, size: f64) -> Geometry {
        let object = if self.text.contains(SIZE) {
            let of_size = written(&self.text.replace(SIZE, &format!("{size:e}")));
            moved(of_size, &Transform::scaling(DVec3::splat(1.0 / size)).then(place))
        } else {
            moved(unit.clone(), place)
        };
        compile_object(&Arc::new(object)).unwrap_or_else(|e| panic!("{}: {e:?}", self.name))
    }
}

/// What the magnitude replaces.
const SIZE: &str = "SIZE";

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
    let unit = written(&case.text.replace(SIZE, "1"));
    let n_places = (n_rays() / case.one_of).div_ceil(RAYS_A_PLACE);
    let n_rays = n_places * RAYS_A_PLACE;
    for _ in 0..n_places {
        let (place, size) = random_place(&mut random);
        let geometry = case.placed(&unit, &place, size);
        for _ in 0..RAYS_A_PLACE {
            let origin = place.origin() + random.direction() * size * 8.0;
            let target = place.origin() + random.direction() * size * random.unit();
            let ray = Ray::new(origin, (target - origin).normalize());
            follow(case, &geometry, &place, &ray, &mut random, &mut failures);
        }
    }
    print_rates(case.name, n_rays, &failures);
    assert!(failures.hits > n_rays / 10, "{}: only {} hits", case.name, failures.hits);
    let allowed = u64::from(n_rays) * u64::from(case.allowed) / 1_000_000;
    assert!(u64::from(failures.all()) <= allowed, "{}", case.name);
}

/// One ray, and those that leave its hits.
fn follow(case: &Case, geometry: &Geometry, place: &Transform, ray: &Ray, random: &mut Random, f: &mut Failures) {
    let mut scratch = Scratch::default();
    let mut nearest = |ray: &Ray, range: Range| geometry.intersect(ray, range, RayKind::Refracted, &mut scratch);
    let hit = nearest(ray, Range::FORWARD);
    f.disagree += u32::from(
        hit.is_some() != (geometry.shadow(ray, Range::FORWARD, 0, None, &mut Scratch::default()) == Shadow::Blocked),
    );
    let Some(hit) = hit else { return };
    f.hits += 1;
    let first = geometry.surface(ray, &hit);
    let away = random.direction();
    // Back to the side from which the ray came.
    let facing = first.geometric_normal.dot(ray.direction);
    let away = if away.dot(first.geometric_normal) * facing > 0.0 { -away } else { away };
    let (next, range) = first.leave(away);
    if let Some(hit) = nearest(&next, range) {
        // Even a shape with hollows is not met within the error of the point that was left.
        let again = case.convex || hit.t < 2.0 * first.point_error;
        f.again += u32::from(again);
    }
    if let Some(field) = case.field {
        f.normal += u32::from(!agrees(field, case.normal_tolerance, place, &first));
    }
    if case.kind != Kind::Sheet {
        through(case, geometry, ray, first, f);
    }
}

/// On through all surfaces: in and out by turns, and out at the end.
fn through(case: &Case, geometry: &Geometry, ray: &Ray, first: Surface, f: &mut Failures) {
    let mut scratch = Scratch::default();
    let leaves = first.geometric_normal.dot(ray.direction) > 0.0;
    let mut inside = if case.kind == Kind::Open { leaves } else { geometry.contains(ray.origin) };
    let mut at = first;
    // Far more surfaces than any of the shapes has on a line.
    for _ in 0..64 {
        inside = !inside;
        let (next, range) = at.leave(ray.direction);
        let Some(hit) = geometry.intersect(&next, range, RayKind::Refracted, &mut scratch) else { break };
        let there = geometry.surface(&next, &hit);
        // Not between surfaces that lie within each other's error.
        let apart = hit.t > 16.0 * at.point_error.max(there.point_error);
        f.alternate += u32::from(apart && inside != geometry.contains(0.5 * at.point + 0.5 * there.point));
        at = there;
    }
    f.odd += u32::from(case.kind == Kind::Solid && inside);
}

/// Whether the normal is the field's gradient, by differences in the shape's own space, except next to
/// edges: where differences on both sides are not the same.
fn agrees(field: Field, tolerance: f64, place: &Transform, surface: &Surface) -> bool {
    // Third derivatives are of order one: the error is of order step^2, and rounding / step below that.
    const STEP: f64 = 1e-5;
    // A thousand times the step, for the curvature of small radii.
    const SMOOTH: f64 = 1e-2;
    let p = place.inverse_point(surface.point);
    let [ahead, behind] = [STEP, -STEP]
        .map(|step| DVec3::from([0, 1, 2].map(|axis| (field(p + DVec3::AXES[axis] * step) - field(p)) / step)));
    // An edge just within the step bends the differences by as much as they differ.
    let bend = (ahead - behind).length() / ahead.length();
    if bend > SMOOTH {
        return true;
    }
    let expected = place.normal(0.5 * (ahead + behind)).normalize();
    // Sheets have no outside; which way they face is their own affair.
    let turned = if expected.dot(surface.geometric_normal) < 0.0 { -1.0 } else { 1.0 };
    (expected * turned - surface.geometric_normal).length() < tolerance + bend
}

#[allow(clippy::print_stdout)] // the rates are what these tests are for
fn print_rates(name: &str, n_rays: u32, f: &Failures) {
    println!(
        "| {name} | {n_rays} | {} | {} | {} | {} | {} | {} |",
        f.hits, f.again, f.disagree, f.odd, f.alternate, f.normal
    );
}

fn length(x: f64, y: f64) -> f64 {
    x.hypot(y)
}
