//! Parameters of shapes given by functions: isosurface, parametric, julia_fractal.

use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::math::{DVec3, DVec4};
use crate::scene::{Container, Function, Isosurface, JuliaFractal, JuliaFunction as F, Parametric, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// POV-Ray's largest `max_trace`.
const MAX_TRACE: i64 = 10;

pub(super) static ISOSURFACE: Block<Isosurface> = Block::<Isosurface>::new(
    "isosurface",
    "where a function is below a threshold",
    &[
        Item::new(
            K::ContainedBy,
            Takes::Other("{ SPHERE | BOX }", |e, surface, _| {
                surface.container = e.container()?;
                Ok(())
            }),
            "{ box { -1, 1 } }",
            "where it is looked for; it is cut there",
        ),
        Item::new(
            K::Threshold,
            Takes::Float(|surface| &mut surface.threshold),
            "0",
            "the function has this value on the surface",
        ),
        Item::new(
            K::Accuracy,
            Takes::Other("FLOAT", |e, surface, _| {
                surface.accuracy = e.positive_or("accuracy", 0.001)?;
                Ok(())
            }),
            "0.001",
            "how exactly it is found",
        ),
        Item::new(
            K::MaxGradient,
            Takes::Other("FLOAT", |e, surface, _| {
                surface.max_gradient = e.positive_or("max_gradient", 1.1)?;
                Ok(())
            }),
            "1.1",
            "how fast the function changes at most, where that cannot be found out",
        ),
        Item::new(
            K::Evaluate,
            Takes::Other("FLOAT, FLOAT, FLOAT", |e, surface, _| {
                let mut p = [0.0; 3];
                for (i, value) in p.iter_mut().enumerate() {
                    if i > 0 {
                        e.comma()?;
                    }
                    *value = e.float()?;
                }
                surface.evaluate = Some(p);
                Ok(())
            }),
            "",
            "max_gradient is found on the way, from the first of these on",
        ),
        Item::new(
            K::MaxTrace,
            Takes::Other("INTEGER", |e, surface, at| {
                let n = e.integer()?;
                if !(1..=MAX_TRACE).contains(&n) {
                    e.warn(Topic::Range, at.span, format!("max_trace lies between 1 and {MAX_TRACE}"));
                }
                surface.max_trace = n.clamp(1, MAX_TRACE) as u32;
                Ok(())
            }),
            "1",
            "how many crossings of a ray are looked for, in solids",
        ),
        Item::new(
            K::AllIntersections,
            Takes::Nothing(|surface| surface.max_trace = MAX_TRACE as u32),
            "",
            "all crossings of a ray are looked for",
        ),
        Item::new(K::Open, Takes::Nothing(|surface| surface.open = true), "", "its container does not close it"),
    ],
)
.with(&[&MODIFIERS]);

pub(super) static PARAMETRIC: Block<Parametric> = Block::<Parametric>::new(
    "parametric",
    "a surface by three functions of u and v",
    &[
        Item::new(
            K::ContainedBy,
            Takes::Other("{ SPHERE | BOX }", |e, surface, _| {
                surface.container = e.container()?;
                Ok(())
            }),
            "{ box { -1, 1 } }",
            "where it is looked for; it is cut there",
        ),
        Item::new(
            K::Accuracy,
            Takes::Other("FLOAT", |e, surface, _| {
                surface.accuracy = e.positive_or("accuracy", 0.001)?;
                Ok(())
            }),
            "0.001",
            "how exactly it is found",
        ),
        Item::new(
            K::MaxGradient,
            Takes::Other("FLOAT", |e, surface, _| {
                surface.max_gradient = e.positive_or("max_gradient", 1.0)?;
                Ok(())
            }),
            "1",
            "how fast its functions change at most",
        ),
        Item::new(
            K::Precompute,
            Takes::Other("DEPTH, [x], [y], [z]", |e, surface, at| {
                surface.precompute = Some(e.precompute(at)?);
                Ok(())
            }),
            "",
            "bounds of its functions are kept, halved as often as this",
        ),
    ],
)
.with(&[&MODIFIERS]);

/// What contains a surface of functions.
pub(super) static CONTAINER: Block<Container> = Block::new(
    "contained_by",
    "where a surface of functions is looked for",
    &[
        Item::new(
            K::Sphere,
            Takes::Whole("{ <CENTRE>, RADIUS }", |e, _| {
                e.open("sphere")?;
                let center = e.vector()?;
                e.comma()?;
                let radius = e.float()?;
                e.close("sphere")?;
                Ok(Container::Sphere { center, radius })
            }),
            "",
            "a ball",
        ),
        Item::new(
            K::Box,
            Takes::Whole("{ <CORNER>, <CORNER> }", |e, _| {
                e.open("box")?;
                let a = e.vector()?;
                e.comma()?;
                let b = e.vector()?;
                e.close("box")?;
                Ok(Container::Box { min: a.min(b), max: a.max(b) })
            }),
            "",
            "a box along the axes",
        ),
    ],
);

/// A function that the fractal iterates.
const fn iterates(word: K, set: fn(&mut JuliaFractal), help: &'static str) -> Item<JuliaFractal> {
    Item::new(word, Takes::Nothing(set), "", help)
}

pub(super) static JULIA_FRACTAL: Block<JuliaFractal> = Block::<JuliaFractal>::new(
    "julia_fractal",
    "a fractal of four dimensions, cut",
    &[
        Item::new(K::Quaternion, Takes::Nothing(|j| j.hypercomplex = false), "", "numbers are quaternions"),
        Item::new(K::Hypercomplex, Takes::Nothing(|j| j.hypercomplex = true), "", "numbers are hypercomplex"),
        Item::new(
            K::MaxIteration,
            Takes::Other("INTEGER", |e, j, _| {
                j.max_iteration = e.integer()?.clamp(1, 1 << 20) as u32;
                Ok(())
            }),
            "20",
            "how often its function is applied",
        ),
        Item::new(
            K::Precision,
            Takes::Other("FLOAT", |e, j, _| {
                j.precision = e.float()?.max(1.0);
                Ok(())
            }),
            "20",
            "how exactly its surface is found",
        ),
        Item::new(
            K::Slice,
            Takes::Other("<4 FLOATS>, FLOAT", slice),
            "<0, 0, 0, 1>, 0",
            "how it is cut: normal, distance",
        ),
        iterates(K::Sqr, |j| j.function = F::Sqr, "iterates the square, as without any"),
        iterates(K::Cube, |j| j.function = F::Cube, "iterates the cube"),
        iterates(K::Exp, |j| j.function = F::Exp, "iterates exp; like all below only with hypercomplex"),
        iterates(K::Reciprocal, |j| j.function = F::Reciprocal, "iterates 1/x"),
        iterates(K::Ln, |j| j.function = F::Ln, "iterates ln"),
        iterates(K::Sin, |j| j.function = F::Sin, "iterates sin"),
        iterates(K::Asin, |j| j.function = F::Asin, "iterates asin"),
        iterates(K::Sinh, |j| j.function = F::Sinh, "iterates sinh"),
        iterates(K::Asinh, |j| j.function = F::Asinh, "iterates asinh"),
        iterates(K::Cos, |j| j.function = F::Cos, "iterates cos"),
        iterates(K::Acos, |j| j.function = F::Acos, "iterates acos"),
        iterates(K::Cosh, |j| j.function = F::Cosh, "iterates cosh"),
        iterates(K::Acosh, |j| j.function = F::Acosh, "iterates acosh"),
        iterates(K::Tan, |j| j.function = F::Tan, "iterates tan"),
        iterates(K::Atan, |j| j.function = F::Atan, "iterates atan"),
        iterates(K::Tanh, |j| j.function = F::Tanh, "iterates tanh"),
        iterates(K::Atanh, |j| j.function = F::Atanh, "iterates atanh"),
        Item::new(
            K::Pwr,
            Takes::Other("(FLOAT, FLOAT)", |e, j, _| {
                e.expect_punct('(', "before the arguments")?;
                let a = e.float()?;
                e.comma()?;
                let b = e.float()?;
                e.expect_punct(')', "to close it")?;
                j.function = F::Pwr(a, b);
                Ok(())
            }),
            "",
            "iterates the power of this complex number",
        ),
    ],
)
.with(&[&MODIFIERS]);

impl Evaluator<'_> {
    pub(super) fn isosurface(&mut self) -> SourceResult<Shape> {
        if !self.accept(K::Function)? {
            return self.expected("'function'");
        }
        let function = self.plain_function()?;
        let mut surface = Isosurface::new(function, self.options.isosurface_search);
        self.items_of(&ISOSURFACE, &mut surface)?;
        surface.accuracy *= self.options.overrides.isosurface_accuracy;
        Ok(Shape::Isosurface(Arc::new(surface)))
    }

    fn positive_or(&mut self, what: &str, default: f64) -> SourceResult<f64> {
        let span = self.span();
        let value = self.float()?;
        if value > 0.0 {
            return Ok(value);
        }
        self.warn(Topic::Range, span, format!("{what} must be above 0; {default} is used"));
        Ok(default)
    }

    /// `{ sphere | box }` after `contained_by`.
    fn container(&mut self) -> SourceResult<Container> {
        self.open("contained_by")?;
        let mut container = Container::Box { min: DVec3::splat(-1.0), max: DVec3::ONE };
        if !self.item_of(&CONTAINER, &mut container)? {
            return self.expected("a sphere or a box");
        }
        self.close("contained_by")?;
        Ok(container)
    }

    pub(super) fn parametric(&mut self) -> SourceResult<Shape> {
        let functions = [self.uv_function()?, self.uv_function()?, self.uv_function()?];
        let a = self.vector2()?;
        self.comma()?;
        let b = self.vector2()?;
        let mut surface = Parametric {
            functions,
            min: a.min(b),
            max: a.max(b),
            container: Container::Box { min: DVec3::splat(-1.0), max: DVec3::ONE },
            accuracy: 0.001,
            max_gradient: 1.0,
            precompute: None,
        };
        self.comma()?;
        self.items_of(&PARAMETRIC, &mut surface)?;
        Ok(Shape::Parametric(Arc::new(surface)))
    }

    fn uv_function(&mut self) -> SourceResult<Arc<Function>> {
        if !self.accept(K::Function)? {
            return self.expected("'function'");
        }
        self.open("function")?;
        let function = self.plain_function_items(&["u", "v"])?;
        self.close("function")?;
        self.comma()?;
        Ok(function)
    }

    fn precompute(&mut self, at: Word) -> SourceResult<(u32, [bool; 3])> {
        let depth = self.integer()?;
        if !(1..=20).contains(&depth) {
            return self.error(at.span, "the depth of precompute lies between 1 and 20");
        }
        let mut axes = [false; 3];
        for (axis, keyword) in [K::X, K::Y, K::Z].into_iter().enumerate() {
            self.comma()?;
            axes[axis] = self.accept(keyword)?;
        }
        Ok((depth as u32, axes))
    }

    pub(super) fn julia_fractal(&mut self) -> SourceResult<Shape> {
        let mut julia = JuliaFractal {
            parameter: self.vector4()?,
            hypercomplex: false,
            function: F::Sqr,
            max_iteration: 20,
            precision: 20.0,
            slice_normal: DVec4::W,
            slice_distance: 0.0,
        };
        let span = self.span();
        self.items_of(&JULIA_FRACTAL, &mut julia)?;
        if !julia.hypercomplex && !matches!(julia.function, F::Sqr | F::Cube) {
            return self.error(span, "quaternion Julia fractals iterate only sqr and cube; add 'hypercomplex'");
        }
        Ok(Shape::JuliaFractal(Arc::new(julia)))
    }
}

fn slice(e: &mut Evaluator<'_>, julia: &mut JuliaFractal, at: Word) -> SourceResult<()> {
    let normal = e.vector4()?;
    e.comma()?;
    julia.slice_distance = e.float()?;
    match normal.try_normalize() {
        // POV-Ray's smallest fourth component of a slice
        Some(n) if n.w.abs() >= 1e-10 => julia.slice_normal = n,
        _ => return e.error(at.span, "the slice's normal needs a fourth component that is not 0"),
    }
    Ok(())
}
