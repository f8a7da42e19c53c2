//! Probe values of the freeform facts, sections 3 to 10.

use super::{check, inside, moved, object, v};
use crate::diag::Span;
use crate::function::{Binary, FunctionBody, ProgramBuilder};
use crate::math::{DVec2, DVec3, Transform};
use crate::scene::{
    BicubicPatch, Blob, BlobComponent, Function, Gamma, HeightField, Image, ImageSource, Object, Prism, Shape,
    SweepSpline,
};
use std::sync::Arc;

fn flat(points: &[[f64; 2]]) -> Vec<DVec2> {
    points.iter().map(|p| DVec2::from(*p)).collect()
}

fn prism(spline: SweepSpline, conic: bool, heights: [f64; 2], points: &[[f64; 2]]) -> Object {
    object(Shape::Prism(Arc::new(Prism { spline, conic, heights, points: flat(points), open: false, sturm: false })))
}

#[test]
fn prisms() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
    let p = prism(SweepSpline::Linear, false, [0.0, 1.0], &square);
    check(&p, v(0.5, -5.0, 0.5), DVec3::Y, Some((v(0.5, 0.0, 0.5), Some(DVec3::Y))));
    check(&p, v(0.5, 0.5, -5.0), DVec3::Z, Some((v(0.5, 0.5, 0.0), Some(DVec3::NEG_Z))));
    assert!(inside(&p, v(0.5, 0.0, 0.5)));
    let diamond = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
    // POV-Ray loses this ray: corners at its own z count twice there.
    let d = prism(SweepSpline::Linear, false, [0.0, 1.0], &diamond);
    check(&d, v(0.1, 5.0, 0.0), DVec3::NEG_Y, Some((v(0.1, 1.0, 0.0), Some(DVec3::Y))));
    let quadratic = [[1.0, -1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
    let q = prism(SweepSpline::Quadratic, false, [0.0, 1.0], &quadratic);
    let normal = v(-0.104_145_854, 0.0, -0.994_562_035);
    check(&q, v(0.4, 0.5, -5.0), DVec3::Z, Some((v(0.4, 0.5, 0.116_227_766), Some(normal))));
    check(&q, v(5.0, 0.5, 0.3), DVec3::NEG_X, Some((v(1.121_954_446, 0.5, 0.3), None)));
    let cubic = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    let c = prism(SweepSpline::Cubic, false, [0.0, 1.0], &cubic);
    check(&c, v(0.4, 0.5, -5.0), DVec3::Z, Some((v(0.4, 0.5, -0.121_766_632), None)));
    let bezier = [[0.0, 0.0], [0.3, -0.4], [0.7, -0.4], [1.0, 0.0], [1.0, 0.0], [0.7, 0.4], [0.3, 0.4], [0.0, 0.0]];
    let b = prism(SweepSpline::Bezier, false, [0.0, 1.0], &bezier);
    let normal = v(0.214_121_221, 0.0, 0.976_807_096);
    check(&b, v(0.4, 0.5, -5.0), DVec3::Z, Some((v(0.4, 0.5, -0.289_077_808), Some(normal))));
    let pyramid = prism(
        SweepSpline::Linear,
        true,
        [0.5, 1.0],
        &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]],
    );
    let half = std::f64::consts::FRAC_1_SQRT_2;
    check(&pyramid, v(0.6, 0.75, -5.0), DVec3::Z, Some((v(0.6, 0.75, -0.75), Some(v(0.0, -half, -half)))));
}

#[test]
fn lathes_and_sors() {
    let lathe = |spline, p: &[[f64; 2]]| object(Shape::Lathe { spline, points: flat(p).into(), sturm: false });
    let l = lathe(SweepSpline::Linear, &[[1.0, 0.0], [2.0, 1.0], [1.0, 2.0]]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    check(&l, v(5.0, 0.5, 0.0), DVec3::NEG_X, Some((v(1.5, 0.5, 0.0), Some(v(half, -half, 0.0)))));
    assert!(inside(&l, v(1.2, 0.5, 0.0)) && !inside(&l, v(0.5, 0.5, 0.0)));
    let q = lathe(SweepSpline::Quadratic, &[[0.0, -1.0], [1.0, 0.0], [2.0, 1.0], [1.0, 2.0]]);
    let normal = v(0.705_951_377, half, 0.040_406_102);
    check(&q, v(5.0, 1.5, 0.1), DVec3::NEG_X, Some((v(1.747_140_521, 1.5, 0.1), Some(normal))));
    let c = lathe(SweepSpline::Cubic, &[[0.0, -1.0], [1.0, 0.0], [2.0, 1.0], [1.0, 2.0], [1.0, 3.0]]);
    let normal = v(0.623_511_071, -0.780_868_809, 0.038_442_772);
    check(&c, v(5.0, 0.5, 0.1), DVec3::NEG_X, Some((v(1.621_920_158, 0.5, 0.1), Some(normal))));
    let b = lathe(SweepSpline::Bezier, &[[1.0, 0.0], [2.0, 0.5], [2.0, 1.5], [1.0, 2.0]]);
    let normal = v(0.937_056_256, -0.344_763_004, 0.055_353_810);
    check(&b, v(5.0, 0.7, 0.1), DVec3::NEG_X, Some((v(1.692_848_712, 0.7, 0.1), Some(normal))));
    let points = flat(&[[1.0, -1.0], [1.0, 0.0], [2.0, 1.0], [1.0, 2.0], [1.0, 3.0]]);
    let sor = |open| object(Shape::Sor { points: points.clone().into(), open, sturm: false });
    let normal = v(0.605_156_543, -0.795_226_459, 0.037_422_422);
    check(&sor(false), v(5.0, 0.5, 0.1), DVec3::NEG_X, Some((v(1.617_096_163, 0.5, 0.1), Some(normal))));
    check(&sor(false), v(0.1, 5.0, 0.2), DVec3::NEG_Y, Some((v(0.1, 2.0, 0.2), Some(DVec3::Y))));
    check(&sor(true), v(0.1, 5.0, 0.2), DVec3::NEG_Y, None);
    assert!(inside(&sor(true), DVec3::splat(0.1)));
}

#[test]
fn blobs() {
    let part = |ends: [DVec3; 2], is_cylinder, radius, strength, transform| BlobComponent {
        ends,
        is_cylinder,
        radius,
        strength,
        transform,
        texture: None,
    };
    let still = Transform::IDENTITY;
    let ball = |c: DVec3, r, s| part([c, c], false, r, s, still);
    let blob = |components| object(Shape::Blob(Arc::new(Blob { threshold: 0.5, components, sturm: false })));
    let from = v(0.0, 0.0, -5.0);
    let one = blob(vec![ball(DVec3::ZERO, 2.0, 1.0)]);
    check(&one, from, DVec3::Z, Some((v(0.0, 0.0, -1.082_392_200), Some(DVec3::NEG_Z))));
    let less = blob(vec![ball(DVec3::ZERO, 2.0, 1.0), ball(DVec3::NEG_Z, 1.0, -1.0)]);
    check(&less, from, DVec3::Z, Some((v(0.0, 0.0, -0.406_238_155), None)));
    let rod = blob(vec![part([DVec3::ZERO, 2.0 * DVec3::Y], true, 1.0, 1.0, still)]);
    let normal = v(0.184_775_907, 0.982_780_680, 0.0);
    check(&rod, v(0.1, 5.0, 0.0), DVec3::NEG_Y, Some((v(0.1, 2.531_877_071, 0.0), Some(normal))));
    let long = Transform::scaling(v(1.0, 1.0, 2.0)).then(&Transform::translation(DVec3::X));
    let egg = blob(vec![part([DVec3::ZERO; 2], false, 1.0, 1.0, long)]);
    check(&egg, v(1.2, 0.3, -5.0), DVec3::Z, Some((v(1.2, 0.3, -0.807_200_641), None)));
    assert!(inside(&one, DVec3::ZERO) && !inside(&one, v(1.5, 0.0, 0.0)));
}

#[test]
fn patches() {
    let row = |i: usize| {
        std::array::from_fn(|j| {
            let raised = (1..3).contains(&i) && (1..3).contains(&j);
            v(j as f64, i as f64, if raised { 2.0 } else { 0.0 })
        })
    };
    let patch = |u_steps, v_steps| {
        let uv_corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let points = std::array::from_fn(row);
        object(Shape::BicubicPatch(Arc::new(BicubicPatch { points, uv_corners, flatness: 0.0, u_steps, v_steps })))
    };
    let probe = |u, v_steps, z: f64| {
        let (point, _) = super::trace(&patch(u, v_steps), v(0.7, 1.1, -5.0), DVec3::Z).unwrap();
        // Single-precision corners.
        assert!((point.z - z).abs() < 1e-6, "{point} for {z}");
    };
    probe(0, 0, 0.0);
    probe(1, 1, 0.525);
    probe(2, 2, 0.689_062_5);
    probe(5, 5, 0.746_452_332);
}

/// x half, as a height function.
fn half_x() -> Function {
    let mut b = ProgramBuilder::default();
    let (x, half) = (b.argument(0), b.constant(0.5));
    let result = b.binary(Binary::Mul, x, half);
    Function { n_parameters: 3, body: FunctionBody::Program(b.finish(result)) }
}

#[test]
fn height_fields() {
    let function = Arc::new(half_x());
    let source = ImageSource::Function { width: 5, height: 5, function };
    let image =
        Image { span: Span::default(), source, gamma: None, premultiplied: None, mode: Gamma::None, legacy: true };
    let field = object(Shape::HeightField(Arc::new(HeightField { image, water_level: 0.0, smooth: false })));
    let normal = v(-0.447_169_921, 0.894_427_047, 0.0);
    let close = |x: f64, y: f64| {
        let (point, n) = super::trace(&field, v(x, 5.0, 0.3), DVec3::NEG_Y).unwrap();
        assert!((point.y - y).abs() < 1e-8 && (n.x - normal.x).abs() < 1e-3, "{point} {n}");
    };
    close(0.1, 0.049_993_896);
    close(0.9, 0.449_984_741);
    assert!(inside(&field, v(0.5, 0.1, 0.5)) && !inside(&field, v(0.5, 0.4, 0.5)));
    let tall = moved(field, &Transform::scaling(v(2.0, 3.0, 1.0)));
    assert!(inside(&tall, v(1.0, 0.3, 0.5)));
}

#[test]
fn sphere_sweeps() {
    let sweep = |spline, spheres: &[(DVec3, f64)], tolerance| {
        object(Shape::SphereSweep { spline, spheres: spheres.into(), tolerance })
    };
    let capsule = sweep(SweepSpline::Linear, &[(DVec3::ZERO, 1.0), (0.5 * DVec3::X, 1.0)], 1e-6);
    // POV-Ray calls the first two outside.
    assert!(inside(&capsule, v(0.25, 0.0, 0.0)) && inside(&capsule, v(0.25, 0.9, 0.0)));
    assert!(inside(&capsule, v(0.25, 0.99, 0.0)) && inside(&capsule, v(-0.9, 0.0, 0.0)));
    assert!(!inside(&capsule, v(0.25, 1.01, 0.0)));
    let cone = sweep(SweepSpline::Linear, &[(DVec3::ZERO, 1.0), (4.0 * DVec3::X, 0.5)], 1e-6);
    let normal = v(0.125, 0.0, -0.992_156_742);
    check(&cone, v(2.0, 0.0, -5.0), DVec3::Z, Some((v(2.0, 0.0, -0.755_928_946), Some(normal))));
    check(&cone, v(9.0, 0.0, 0.0), DVec3::NEG_X, Some((v(4.5, 0.0, 0.0), None)));
    let five = [
        (DVec3::ZERO, 0.5),
        (v(1.0, 1.0, 0.0), 0.3),
        (v(2.0, 0.0, 1.0), 0.5),
        (v(3.0, 1.0, 0.0), 0.2),
        (v(4.0, 0.0, 0.0), 0.5),
    ];
    let b = sweep(SweepSpline::B, &five, 1e-6);
    check(&b, v(1.5, 0.5, -5.0), DVec3::Z, Some((v(1.5, 0.5, 0.034_518_024), None)));
    let normal = v(-0.490_707_171, 0.316_109_050, -0.811_961_539);
    check(&b, v(2.3, 0.6, -5.0), DVec3::Z, Some((v(2.3, 0.6, 0.205_542_666), Some(normal))));
    check(&b, v(2.3, 5.0, 0.5), DVec3::NEG_Y, Some((v(2.3, 0.804_140_483, 0.5), None)));
    let cubic = sweep(SweepSpline::Cubic, &five, 1e-6);
    check(&cubic, v(1.5, 0.5, -5.0), DVec3::Z, Some((v(1.5, 0.5, 0.093_784_236), None)));
    let normal = v(-0.719_476_517, 0.140_403_512, -0.680_176_738);
    check(&cubic, v(2.3, 0.6, -5.0), DVec3::Z, Some((v(2.3, 0.6, 0.289_583_486), Some(normal))));
    check(&cubic, v(2.3, 5.0, 0.5), DVec3::NEG_Y, Some((v(2.3, 0.781_612_252, 0.5), None)));
    let arch = [v(0.0, -10.0, 0.0), DVec3::ZERO, DVec3::X, v(1.0, -10.0, 0.0)].map(|c| (c, 0.1));
    let arch = sweep(SweepSpline::Cubic, &arch, 1e-6);
    check(&arch, v(0.5, 5.0, 0.0), DVec3::NEG_Y, Some((v(0.5, 1.35, 0.0), None)));
    // Seen from its own plane; POV-Ray cuts it off above y = 0.2.
    check(&arch, v(0.5, 1.25, -5.0), DVec3::Z, Some((v(0.5, 1.25, -0.1), None)));
    let tolerant = sweep(SweepSpline::Linear, &[(DVec3::ZERO, 1.0), (4.0 * DVec3::X, 1.0)], 0.5);
    check(&tolerant, v(2.0, 0.0, -1.4), DVec3::Z, Some((v(2.0, 0.0, 1.0), None)));
    check(&tolerant, v(2.0, 0.0, -1.6), DVec3::Z, Some((v(2.0, 0.0, -1.0), None)));
}
