//! Shapes with curved surfaces that have a formula.

use super::{Case, Field, check, length};
use crate::math::DVec3;

#[test]
fn spheres_and_cones() {
    check(&Case::solid("sphere", "sphere { 0, 1 }").convex().field(|p| p.length() - 1.0));
    let cylinder: Field = |p| (length(p.x, p.z) - 1.0).max(p.y.abs() - 1.0);
    check(&Case::solid("cylinder", "cylinder { -y, y, 1 }").convex().field(cylinder));
    let tube: Field = |p| length(p.x, p.z) - 1.0;
    check(&Case::sheet("cylinder open", "cylinder { -y, y, 1 open }").field(tube));
    let cone: Field = |p| (length(p.x, p.z) - 0.65 + 0.35 * p.y).max(p.y.abs() - 1.0);
    check(&Case::solid("cone", "cone { -y, 1, y, .3 }").convex().field(cone));
    let funnel: Field = |p| length(p.x, p.z) - 0.65 + 0.35 * p.y;
    check(&Case::sheet("cone open", "cone { -y, 1, y, .3 open }").field(funnel));
    let hourglass: Field = |p| (length(p.x, p.z) - p.y.abs()).max(p.y.abs() - 1.0);
    check(&Case::solid("cone hourglass", "cone { -y, 1, y, -1 }").field(hourglass));
}

#[test]
fn quadrics() {
    let ellipsoid: Field = |p| p.x * p.x + 2.0 * p.y * p.y + 0.5 * p.z * p.z - 1.0;
    check(&Case::solid("quadric ellipsoid", "quadric { <1, 2, .5>, 0, 0, -1 }").convex().field(ellipsoid));
    let saddle: Field = |p| p.x * p.x - p.z * p.z + 0.5 * p.x * p.y - p.y + 0.2;
    check(&Case::endless("quadric saddle", "quadric { <1, 0, -1>, <.5, 0, 0>, <0, -1, 0>, .2 }").field(saddle));
    let waist: Field = |p| p.x * p.x - p.y * p.y + p.z * p.z - 0.2;
    check(&Case::endless("quadric hyperboloid", "quadric { <1, -1, 1>, 0, 0, -.2 }").field(waist));
}

#[test]
fn tori_and_eggs() {
    let torus: Field = |p| length(length(p.x, p.z) - 0.8, p.y) - 0.3;
    check(&Case::solid("torus", "torus { .8, .3 }").field(torus));
    let thin: Field = |p| length(length(p.x, p.z) - 0.8, p.y) - 0.06;
    check(&Case::solid("torus thin", "torus { .8, .06 }").field(thin));
    let egg: Field = |p| {
        // Source: shape facts, section 4.2, for the radii .8 and .5.
        let (b, t): (f64, f64) = (0.8, 0.5);
        let v = 2.0 * t - b - t * t / (2.0 * b);
        let h = (b * b - v * v).sqrt();
        let (low, high) = (-v, b + (b - v) * t / (2.0 * b - t));
        match p.y {
            y if y <= low => p.length() - b,
            y if y >= high => p.distance(DVec3::Y * b) - t,
            y => length(length(p.x, p.z) + h, y - v) - 2.0 * b,
        }
    };
    check(&Case::solid("ovus", "ovus { .8, .5 }").convex().field(egg));
    check(&Case::solid("ovus top heavy", "ovus { .5, .7 }").convex());
}

#[test]
fn polynomials() {
    let cubic: Field = |p| p.x.powi(3) + p.y.powi(3) + p.z.powi(3) - 0.3;
    let text = "polynomial { 3, xyz(3, 0, 0): 1, xyz(0, 3, 0): 1, xyz(0, 0, 3): 1, xyz(0, 0, 0): -.3 }";
    check(&Case::endless("cubic", text).field(cubic));
    let quartic: Field = |p| p.x.powi(4) + p.y.powi(4) + p.z * p.z - 0.5;
    let text = "polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 2): 1, xyz(0, 0, 0): -.5 }";
    check(&Case::solid("quartic", text).convex().field(quartic));
    let sextic: Field = |p| p.x.powi(6) + p.y.powi(6) + p.z.powi(6) - 0.5;
    let text = "polynomial { 6, xyz(6, 0, 0): 1, xyz(0, 6, 0): 1, xyz(0, 0, 6): 1, xyz(0, 0, 0): -.5 }";
    check(&Case::solid("poly of order 6", text).convex().field(sextic));
}

#[test]
fn superellipsoids() {
    let pillow: Field = |p| {
        let round = p.x.abs().powf(2.0 / 0.7) + p.y.abs().powf(2.0 / 0.7);
        (round.powf(0.7 / 0.5) + p.z.abs().powf(2.0 / 0.5)).powf(0.25) - 1.0
    };
    check(&Case::solid("superellipsoid", "superellipsoid { <.7, .5> }").convex().field(pillow));
    check(&Case::solid("superellipsoid sharp", "superellipsoid { <.2, .1> }").convex());
    check(&Case::solid("superellipsoid star", "superellipsoid { <1.6, 1.4> }"));
}
