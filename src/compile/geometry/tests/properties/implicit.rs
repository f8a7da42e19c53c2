//! Isosurfaces, parametric surfaces and Julia sets.

use super::{Case, Field, check};
use crate::math::DVec4;

#[test]
fn isosurfaces() {
    // Lengths within the function are in units of the magnitude; so is the accuracy.
    let isosurface = |rest: &str| format!("#declare S = SIZE; isosurface {{ {rest} accuracy .000001*S max_trace 10 }}");
    let ball = isosurface("function { sqrt(x*x + y*y + z*z)/S - .9 } max_gradient 1/S contained_by { box { -S, S } }");
    // A hit lies up to the accuracy behind the surface, and slopes are taken over it.
    check(&Case::solid("isosurface", ball).field(|p| p.length() - 0.9));
    let waves =
        isosurface("function { y/S + .2*sin(5*x/S)*cos(4*z/S) } max_gradient 2/S contained_by { sphere { 0, S } }");
    check(&Case::solid("isosurface cut by a sphere", waves));
}

#[test]
fn parametric_surfaces() {
    let text = "#declare S = SIZE; parametric { function { .6*S*cos(u/S)*cos(v/S) } function { .6*S*sin(v/S) }
        function { .6*S*sin(u/S)*cos(v/S) } <0, -1.5*S>, <6.3*S, 1.5*S> contained_by { box { -S, S } }
        accuracy .0001*S max_gradient .6 }";
    let ball: Field = |p| p.length() - 0.6;
    // POV-Ray's search takes the depth from one axis alone: where the ray runs across it, the point lies many
    // times the accuracy in front of the surface, and its normal is that of another place.
    check(&Case::sheet("parametric", text).field(ball).normals_within(1e-2).slow(50).allowed(20_000));
}

#[test]
fn julia_sets() {
    let text = "julia_fractal { <-.083, 0, -.83, -.025> quaternion max_iteration 5 precision 100 }";
    let orbit: Field = |p| {
        let mut q = p.extend(0.0);
        for _ in 0..5 {
            let square = DVec4::new(
                q.x * q.x - q.y * q.y - q.z * q.z - q.w * q.w,
                2.0 * q.x * q.y,
                2.0 * q.x * q.z,
                2.0 * q.x * q.w,
            );
            q = square + DVec4::new(-0.083, 0.0, -0.83, -0.025);
        }
        q.length_squared()
    };
    check(&Case::sheet("julia_fractal quaternion", text).field(orbit).normals_within(1e-2));
    let text = "julia_fractal { <-.162, .163, .56, -.599> hypercomplex max_iteration 5 precision 100 scale .7 }";
    check(&Case::sheet("julia_fractal hypercomplex", text));
}
