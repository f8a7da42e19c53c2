//! Shapes given by functions: isosurface, parametric, julia_fractal.

use super::reader::{Reader, misplaced};
use super::shapes::positive;
use super::tree::{Items, Node, Read, Rule, wrong};
use crate::math::{DVec3, DVec4};
use crate::scene::{Container, Isosurface, JuliaFractal, JuliaFunction, Parametric, Shape};
use std::sync::Arc;

impl<'a> Reader<'a> {
    pub(super) fn isosurface(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let function = self.plain_function(items.node()?, &["x", "y", "z"])?;
        let mut surface = Isosurface::new(function, self.options.isosurface_search);
        while let Some(rule) = items.peek().filter(|rule| *rule != Rule::modifiers) {
            let item = items.node()?;
            let mut inner = Items::of(item.clone());
            match rule {
                Rule::container => surface.container = container(inner.node()?)?,
                Rule::evaluate => surface.evaluate = Some([inner.number()?, inner.number()?, inner.number()?]),
                Rule::open => surface.open = true,
                Rule::surface_number => match inner.word()? {
                    "threshold" => surface.threshold = inner.number()?,
                    "accuracy" => surface.accuracy = positive(&mut inner)?,
                    "max_gradient" => surface.max_gradient = positive(&mut inner)?,
                    _ => surface.max_trace = inner.whole_within(1, 10)?,
                },
                _ => return misplaced(&item),
            }
        }
        surface.accuracy *= self.options.overrides.isosurface_accuracy;
        Ok(Shape::Isosurface(Arc::new(surface)))
    }

    pub(super) fn parametric(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let mut function = || self.plain_function(items.node()?, &["u", "v"]);
        let functions = [function()?, function()?, function()?];
        let mut surface = Parametric {
            functions,
            min: items.vector2()?,
            max: items.vector2()?,
            container: Container::Box { min: DVec3::NEG_ONE, max: DVec3::ONE },
            accuracy: 0.001,
            max_gradient: 1.0,
            precompute: None,
        };
        while let Some(rule) = items.peek().filter(|rule| *rule != Rule::modifiers) {
            let item = items.node()?;
            let mut inner = Items::of(item.clone());
            match rule {
                Rule::container => surface.container = container(inner.node()?)?,
                Rule::surface_number => match inner.word()? {
                    "accuracy" => surface.accuracy = positive(&mut inner)?,
                    "max_gradient" => surface.max_gradient = positive(&mut inner)?,
                    _ => return misplaced(&item),
                },
                Rule::precompute => {
                    let depth = inner.whole_within(1, 20)?;
                    let mut axes = [false; 3];
                    for axis in inner {
                        axes[usize::from(axis.as_str().as_bytes()[0] - b'x')] = true;
                    }
                    surface.precompute = Some((depth, axes));
                }
                _ => return misplaced(&item),
            }
        }
        Ok(Shape::Parametric(Arc::new(surface)))
    }
}

fn container(node: Node<'_>) -> Read<Container> {
    let is_sphere = node.as_rule() == Rule::container_sphere;
    let mut items = Items::of(node);
    let first = items.vector()?;
    if is_sphere {
        return Ok(Container::Sphere { center: first, radius: items.number()? });
    }
    let second = items.vector()?;
    Ok(Container::Box { min: first.min(second), max: first.max(second) })
}

pub(super) fn julia_fractal(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let parameter = items.vector4()?;
    let hypercomplex = items.word()? == "hypercomplex";
    let function = julia_function(items.node()?)?;
    if !hypercomplex && !matches!(function, JuliaFunction::Sqr | JuliaFunction::Cube) {
        return wrong(node, "quaternion Julia fractals iterate only sqr and cube; 'hypercomplex' ones take any");
    }
    let max_iteration = items.whole_within(1, 1 << 20)?;
    let precision = items.number()?.max(1.0);
    let (normal, slice_distance) = (items.vector4()?, items.number()?);
    let slice_normal = if (normal.length_squared() - 1.0).abs() <= 8.0 * f64::EPSILON {
        normal
    } else {
        normal.try_normalize().unwrap_or(DVec4::ZERO)
    };
    // POV-Ray's smallest fourth component of a slice.
    if slice_normal.w.abs() < 1e-10 {
        return wrong(node, "the slice's normal needs a fourth component that is not 0");
    }
    Ok(Shape::JuliaFractal(Arc::new(JuliaFractal {
        parameter,
        hypercomplex,
        function,
        max_iteration,
        precision,
        slice_normal,
        slice_distance,
    })))
}

fn julia_function(node: Node<'_>) -> Read<JuliaFunction> {
    use JuliaFunction as F;
    let mut items = Items::of(node);
    if items.peek() == Some(Rule::number) {
        return Ok(F::Pwr(items.number()?, items.number()?));
    }
    Ok(match items.word()? {
        "sqr" => F::Sqr,
        "cube" => F::Cube,
        "exp" => F::Exp,
        "ln" => F::Ln,
        "sin" => F::Sin,
        "asin" => F::Asin,
        "cos" => F::Cos,
        "acos" => F::Acos,
        "tan" => F::Tan,
        "atan" => F::Atan,
        "sinh" => F::Sinh,
        "asinh" => F::Asinh,
        "cosh" => F::Cosh,
        "acosh" => F::Acosh,
        "tanh" => F::Tanh,
        "atanh" => F::Atanh,
        _ => F::Reciprocal,
    })
}
