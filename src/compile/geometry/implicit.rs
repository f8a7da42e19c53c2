//! Shapes given by functions: isosurface, parametric, julia_fractal.

use super::builder::Builder;
use super::watch::Watched;
use crate::compile::texture::Refusal;
use crate::compiled::geometry::{Container, Isosurface, Julia, JuliaFunction, Parametric, Shape as Compiled};
use crate::diag::Span;
use crate::function::Translate as _;
use crate::math::Bounds;
use crate::scene;
use std::sync::Arc;

/// POV-Ray's container, its corners sorted.
pub(super) fn container(container: scene::Container) -> Container {
    match container {
        scene::Container::Box { min, max } => Container::Box(Bounds::from_corners(min, max)),
        scene::Container::Sphere { center, radius } => Container::Sphere { center, radius },
    }
}

/// An isosurface; what its searches find out is watched under its first place.
///
/// # Errors
/// What is wrong with its function.
pub(super) fn isosurface(
    builder: &mut Builder<'_>,
    surface: &Arc<scene::Isosurface>,
    span: Span,
) -> Result<Compiled, Refusal> {
    let function = builder.functions.function(&surface.function)?;
    let guaranteed = surface.search == scene::IsosurfaceSearch::Guaranteed && surface.function.is_enclosable();
    let watch = || Watched {
        span,
        notes: Arc::default(),
        max_gradient: surface.max_gradient,
        believes: !guaranteed,
        adapts: surface.evaluate.is_some(),
    };
    let id = *builder.watched_ids.entry(Arc::as_ptr(surface)).or_insert_with(|| {
        builder.watched.push(watch());
        builder.watched.len() - 1
    });
    Ok(Compiled::Isosurface(Box::new(Isosurface {
        function,
        container: container(surface.container),
        threshold: surface.threshold,
        accuracy: surface.accuracy,
        max_gradient: surface.max_gradient,
        evaluate: surface.evaluate,
        max_trace: surface.max_trace,
        open: surface.open,
        guaranteed,
        notes: Arc::clone(&builder.watched[id].notes),
    })))
}

/// A parametric surface. POV-Ray's `precompute` only saves it time.
///
/// # Errors
/// What is wrong with one of its functions.
pub(super) fn parametric(builder: &Builder<'_>, surface: &scene::Parametric) -> Result<Compiled, Refusal> {
    let [x, y, z] = surface.functions.each_ref().map(|function| builder.functions.function(function));
    Ok(Compiled::Parametric(Box::new(Parametric {
        functions: [x?, y?, z?],
        min: surface.min,
        max: surface.max,
        container: container(surface.container),
        accuracy: surface.accuracy,
        max_gradient: surface.max_gradient,
    })))
}

/// A Julia set, its slice solved for the fourth coordinate.
pub(super) fn julia(julia: &scene::JuliaFractal) -> Compiled {
    use scene::JuliaFunction as F;
    let function = match julia.function {
        F::Sqr => JuliaFunction::Sqr,
        F::Cube => JuliaFunction::Cube,
        F::Exp => JuliaFunction::Exp,
        F::Ln => JuliaFunction::Ln,
        F::Sin => JuliaFunction::Sin,
        F::Asin => JuliaFunction::Asin,
        F::Cos => JuliaFunction::Cos,
        F::Acos => JuliaFunction::Acos,
        F::Tan => JuliaFunction::Tan,
        F::Atan => JuliaFunction::Atan,
        F::Sinh => JuliaFunction::Sinh,
        F::Asinh => JuliaFunction::Asinh,
        F::Cosh => JuliaFunction::Cosh,
        F::Acosh => JuliaFunction::Acosh,
        F::Tanh => JuliaFunction::Tanh,
        F::Atanh => JuliaFunction::Atanh,
        F::Reciprocal => JuliaFunction::Reciprocal,
        F::Pwr(a, b) => JuliaFunction::Pwr(a, b),
    };
    let normal = julia.slice_normal;
    Compiled::Julia(Box::new(Julia {
        parameter: julia.parameter,
        hypercomplex: julia.hypercomplex,
        radius: Julia::radius_of(julia.parameter, julia.hypercomplex),
        function,
        n_iterations: julia.max_iteration.max(1) as usize,
        smallest_step: 1.0 / julia.precision.max(1.0),
        slice: normal.truncate() / -normal.w,
        slice_offset: julia.slice_distance / normal.w,
    }))
}
