//! Probe values of the function facts, sections 9 to 11.

use super::{check, inside, moved, object, v};
use crate::compile::geometry::compile_object;
use crate::compiled::geometry::{RayKind, Scratch, Shadow};
use crate::function::{Binary as B, FunctionBody, ProgramBuilder, Slot, Unary as U};
use crate::math::{DVec2, DVec3, DVec4, Range, Ray, Transform};
use crate::scene::{
    Container, Function, Isosurface, IsosurfaceSearch, JuliaFractal, JuliaFunction, Object, Parametric, PointFunction,
    Shape,
};
use std::sync::Arc;

/// A function of x, y and z.
fn function(body: impl Fn(&mut ProgramBuilder<PointFunction>, [Slot; 3]) -> Slot) -> Arc<Function> {
    let mut b = ProgramBuilder::default();
    let xyz = [0, 1, 2].map(|i| b.argument(i));
    let result = body(&mut b, xyz);
    Arc::new(Function { n_parameters: 3, body: FunctionBody::Program(b.finish(result)) })
}

/// sqrt(x*x + y*y + z*z) - .7
fn ball() -> Arc<Function> {
    function(|b, xyz| {
        let [x, y, z] = xyz.map(|s| b.binary(B::Mul, s, s));
        let xy = b.binary(B::Add, x, y);
        let sum = b.binary(B::Add, xy, z);
        let length = b.unary(U::Sqrt, sum);
        let radius = b.constant(0.7);
        b.binary(B::Sub, length, radius)
    })
}

fn isosurface(function: Arc<Function>, change: impl Fn(&mut Isosurface)) -> Object {
    let mut surface = Isosurface::new(function, IsosurfaceSearch::PovRay);
    change(&mut surface);
    object(Shape::Isosurface(Arc::new(surface)))
}

#[test]
fn isosurfaces() {
    let from = v(0.1, 0.2, -3.0);
    let at = |z: f64, n: DVec3| Some((v(0.1, 0.2, z), Some(n)));
    let plain = isosurface(ball(), |_| ());
    let normal = v(0.143_571_768_371_276_27, 0.286_400_017_908_294_4, -0.947_292_023_121_070_3);
    check(&plain, from, DVec3::Z, at(-0.663_085_937_5, normal));
    check(&plain, v(0.1, 0.2, 0.0), DVec3::Z, Some((v(0.1, 0.2, 0.663_798_828_125), None)));
    let rough = isosurface(ball(), |s| s.accuracy = 0.1);
    let normal = v(0.216_730_480_190_780_78, 0.357_398_046_444_254_1, -0.908_457_228_530_169);
    check(&rough, from, DVec3::Z, at(-0.625, normal));
    let small = Container::Box { min: DVec3::splat(-0.5), max: DVec3::splat(0.5) };
    check(&isosurface(ball(), |s| s.container = small), from, DVec3::Z, at(-0.5, DVec3::NEG_Z));
    let open = isosurface(ball(), |s| (s.container, s.open) = (small, true));
    check(&open, from, DVec3::Z, None);
    check(&open, v(0.45, 0.45, -3.0), DVec3::Z, Some((v(0.45, 0.45, -0.291_015_625), None)));
    let round = Container::Sphere { center: v(0.3, 0.0, 0.0), radius: 0.8 };
    let place = Transform::scaling(v(2.0, 1.0, 0.5)).then(&Transform::rotation_deg(30.0 * DVec3::X));
    let egg = moved(isosurface(ball(), |s| s.container = round), &place);
    check(&egg, from, DVec3::Z, Some((v(0.1, 0.2, -0.287_005_003_564_273_5), None)));
}

#[test]
fn wavy_isosurfaces_and_insides() {
    let wavy = |max_gradient| {
        let body = function(|b, xyz| {
            let ten = b.constant(10.0);
            let angle = b.binary(B::Mul, xyz[0], ten);
            let sine = b.unary(U::Sin, angle);
            let tenth = b.constant(0.1);
            let wave = b.binary(B::Mul, sine, tenth);
            let [x, y, z] = xyz.map(|s| b.binary(B::Mul, s, s));
            let two = b.constant(2.0);
            let y = b.binary(B::Mul, y, two);
            let terms = [y, z, b.constant(-0.5), wave];
            terms.into_iter().fold(x, |sum, term| b.binary(B::Add, sum, term))
        });
        isosurface(body, |s| s.max_gradient = max_gradient)
    };
    check(&wavy(4.0), v(0.1, 0.2, -3.0), DVec3::Z, Some((v(0.1, 0.2, -0.570_312_5), None)));
    let half = isosurface(function(|_, xyz| xyz[0]), |s| s.threshold = 0.25);
    assert!(inside(&half, v(0.25, 0.0, 0.0)) && !inside(&half, v(0.250_000_1, 0.0, 0.0)));
    assert!(inside(&half, v(-1.0, 1.0, 1.0)) && !inside(&half, v(-1.0001, 1.0, 1.0)));
}

fn julia(c: [f64; 4], change: impl Fn(&mut JuliaFractal)) -> Object {
    let mut julia = JuliaFractal {
        parameter: DVec4::from(c),
        hypercomplex: false,
        function: JuliaFunction::Sqr,
        max_iteration: 8,
        precision: 20.0,
        slice_normal: DVec4::W,
        slice_distance: 0.0,
    };
    change(&mut julia);
    object(Shape::JuliaFractal(Arc::new(julia)))
}

#[test]
fn julia_sets() {
    let from = v(0.1, 0.2, -3.0);
    let quaternion = julia([-0.083, 0.0, -0.83, -0.025], |j| j.precision = 15.0);
    let normal = v(0.854_707_628_308_638_8, 0.141_787_631_672_131_35, -0.499_370_741_649_758_6);
    check(&quaternion, from, DVec3::Z, Some((v(0.1, 0.2, -0.341_339_583_216_304_2), Some(normal))));
    let pair = julia([-0.162, 0.163, 0.56, -0.599], |j| (j.hypercomplex, j.precision) = (true, 50.0));
    let normal = v(-0.567_009_423_512_173_1, 0.582_355_403_276_966_9, -0.582_548_279_477_774);
    check(&pair, from, DVec3::Z, Some((v(0.1, 0.2, -0.675_828_278_593_951_8), Some(normal))));
    let sine = julia([-0.2, 0.4, -0.4, 0.3], |j| {
        (j.hypercomplex, j.function, j.max_iteration) = (true, JuliaFunction::Sin, 6);
    });
    assert!(inside(&sine, v(-1.1, 1.0, 0.8)) && inside(&sine, v(0.7, -0.8, 1.3)));
    assert!(!inside(&sine, v(0.8, -1.5, -0.2)));
}

#[test]
fn parametric_surfaces() {
    let parametric = |functions, min: [f64; 2], max: [f64; 2]| {
        object(Shape::Parametric(Arc::new(Parametric {
            functions,
            min: DVec2::from(min),
            max: DVec2::from(max),
            container: Container::Box { min: DVec3::NEG_ONE, max: DVec3::ONE },
            accuracy: 0.001,
            max_gradient: 1.0,
            precompute: None,
        })))
    };
    let scaled = |b: &mut ProgramBuilder<PointFunction>, factor: Slot, of: Slot| {
        let size = b.constant(0.6);
        let product = b.binary(B::Mul, size, factor);
        b.binary(B::Mul, product, of)
    };
    let ball = [
        function(|b, [u, v, _]| {
            let (s, t) = (b.unary(U::Cos, u), b.unary(U::Cos, v));
            scaled(b, s, t)
        }),
        function(|b, [_, v, _]| {
            let (one, s) = (b.constant(1.0), b.unary(U::Sin, v));
            scaled(b, one, s)
        }),
        function(|b, [u, v, _]| {
            let (s, t) = (b.unary(U::Sin, u), b.unary(U::Cos, v));
            scaled(b, s, t)
        }),
    ];
    let from = v(0.1, 0.2, -3.0);
    let normal = v(-0.167_284_179_757_106_5, -0.334_501_427_752_934_8, 0.927_429_133_699_105_7);
    let found = Some((v(0.1, 0.2, -0.558_246_134_052_902_1), Some(normal)));
    check(&parametric(ball, [0.0, -1.5], [6.3, 1.5]), from, DVec3::Z, found);
    let sheet = [function(|_, [u, _, _]| u), function(|_, [_, v, _]| v), function(|b, _| b.constant(0.0))];
    let sheet = parametric(sheet, [-0.5, -0.5], [0.5, 0.5]);
    check(&sheet, from, DVec3::Z, Some((v(0.1, 0.2, -0.001_976_562_499_999_89), None)));
}

/// |f| 50 - 0.001 for a ball: a shell of a thickness of 4e-5, in which the slope is 50.
fn thin_shell() -> Arc<Function> {
    let ball = ball();
    function(|b, xyz| {
        let distance = b.call(&ball, xyz.into_iter().collect(), 0);
        let (size, fifty, least) = (b.unary(U::Abs, distance), b.constant(50.0), b.constant(0.001));
        let steep = b.binary(B::Mul, size, fifty);
        b.binary(B::Sub, steep, least)
    })
}

/// How many of a thousand parallel rays through the middle of the ball meet its shell.
fn met(search: IsosurfaceSearch) -> usize {
    let shell = isosurface(thin_shell(), |s| (s.max_gradient, s.accuracy, s.search) = (0.1, 0.01, search));
    let geometry = compile_object(&Arc::new(shell)).unwrap();
    let meets = |i: &usize| {
        // Within 0.69 of the axis, where the shell's radius is 0.7, in a spiral.
        let (radius, angle) = (0.69 * *i as f64 / 1000.0, *i as f64 * 2.4);
        let ray = Ray::new(v(radius * angle.cos(), radius * angle.sin(), -3.0), DVec3::Z);
        geometry.shadow(&ray, Range::FORWARD, 0, None, &mut Scratch::default()) == Shadow::Blocked
    };
    (0..1000).filter(meets).count()
}

#[test]
fn no_ray_misses_a_thin_sheet_whatever_max_gradient_says() {
    assert_eq!(met(IsosurfaceSearch::Guaranteed), 1000);
    assert_eq!(met(IsosurfaceSearch::PovRay), 0);
}

/// With a true bound of the slope both searches end on the same point.
#[test]
fn certainty_moves_no_hit() {
    let both = [IsosurfaceSearch::Guaranteed, IsosurfaceSearch::PovRay].map(|search| {
        let surface = isosurface(ball(), |s| (s.search, s.max_trace) = (search, 2));
        compile_object(&Arc::new(surface)).unwrap()
    });
    let mut hits = 0;
    for i in 0..1000 {
        let at = |k: f64| (f64::from(i) * k).sin();
        let origin = v(at(1.3), at(2.7), at(3.1)) * 3.0;
        let ray = Ray::new(origin, (v(at(5.3), at(7.1), at(4.9)) * 0.8 - origin).normalize());
        let [a, b] = both
            .each_ref()
            .map(|g| g.intersect(&ray, Range::FORWARD, RayKind::Refracted, &mut Scratch::default()).map(|hit| hit.t));
        assert_eq!(a, b, "{ray:?}");
        hits += usize::from(a.is_some());
    }
    assert!(hits > 200, "{hits}");
}
