//! Parameters of shapes given by functions: isosurface, parametric, julia_fractal.

use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::math::{DVec3, DVec4};
use crate::scene::{Container, Function, Isosurface, JuliaFractal, JuliaFunction, Parametric, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// POV-Ray's largest `max_trace`.
const MAX_TRACE: i64 = 10;

impl Evaluator<'_> {
    pub(super) fn isosurface(&mut self) -> SourceResult<Shape> {
        if !self.accept(K::Function)? {
            return self.expected("'function'");
        }
        let function = self.plain_function()?;
        let mut surface = Isosurface::new(function, self.options.isosurface_search);
        while self.isosurface_item(&mut surface)? {
            self.comma()?;
        }
        surface.accuracy *= self.options.overrides.isosurface_accuracy;
        Ok(Shape::Isosurface(Arc::new(surface)))
    }

    fn isosurface_item(&mut self, surface: &mut Isosurface) -> SourceResult<bool> {
        let span = self.span();
        match self.keyword()? {
            Some(K::ContainedBy) => surface.container = self.container()?,
            Some(K::Threshold) => {
                self.next()?;
                surface.threshold = self.float()?;
            }
            Some(K::Accuracy) => {
                self.next()?;
                surface.accuracy = self.positive_or("accuracy", 0.001)?;
            }
            Some(K::MaxGradient) => {
                self.next()?;
                surface.max_gradient = self.positive_or("max_gradient", 1.1)?;
            }
            Some(K::Evaluate) => {
                self.next()?;
                let mut p = [0.0; 3];
                for (i, value) in p.iter_mut().enumerate() {
                    if i > 0 {
                        self.comma()?;
                    }
                    *value = self.float()?;
                }
                surface.evaluate = Some(p);
            }
            Some(K::MaxTrace) => {
                self.next()?;
                let n = self.integer()?;
                if !(1..=MAX_TRACE).contains(&n) {
                    self.warn(Topic::Range, span, format!("max_trace lies between 1 and {MAX_TRACE}"));
                }
                surface.max_trace = n.clamp(1, MAX_TRACE) as u32;
            }
            Some(K::AllIntersections) => {
                self.next()?;
                surface.max_trace = MAX_TRACE as u32;
            }
            Some(K::Open) => {
                self.next()?;
                surface.open = true;
            }
            _ => return Ok(false),
        }
        Ok(true)
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

    /// `contained_by { sphere | box }`.
    fn container(&mut self) -> SourceResult<Container> {
        self.next()?;
        self.open("contained_by")?;
        let container = match self.keyword()? {
            Some(K::Sphere) => {
                self.next()?;
                self.open("sphere")?;
                let center = self.vector()?;
                self.comma()?;
                let radius = self.float()?;
                self.close("sphere")?;
                Container::Sphere { center, radius }
            }
            Some(K::Box) => {
                self.next()?;
                self.open("box")?;
                let a = self.vector()?;
                self.comma()?;
                let b = self.vector()?;
                self.close("box")?;
                Container::Box { min: a.min(b), max: a.max(b) }
            }
            _ => return self.expected("a sphere or a box"),
        };
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
        loop {
            self.comma()?;
            match self.keyword()? {
                Some(K::ContainedBy) => surface.container = self.container()?,
                Some(K::Accuracy) => {
                    self.next()?;
                    surface.accuracy = self.positive_or("accuracy", 0.001)?;
                }
                Some(K::MaxGradient) => {
                    self.next()?;
                    surface.max_gradient = self.positive_or("max_gradient", 1.0)?;
                }
                Some(K::Precompute) => {
                    self.next()?;
                    surface.precompute = Some(self.precompute()?);
                }
                _ => return Ok(Shape::Parametric(Arc::new(surface))),
            }
        }
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

    fn precompute(&mut self) -> SourceResult<(u32, [bool; 3])> {
        let span = self.span();
        let depth = self.integer()?;
        if !(1..=20).contains(&depth) {
            return self.error(span, "the depth of precompute lies between 1 and 20");
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
            function: JuliaFunction::Sqr,
            max_iteration: 20,
            precision: 20.0,
            slice_normal: DVec4::W,
            slice_distance: 0.0,
        };
        let span = self.span();
        while self.julia_item(&mut julia)? {
            self.comma()?;
        }
        if !julia.hypercomplex && !matches!(julia.function, JuliaFunction::Sqr | JuliaFunction::Cube) {
            return self.error(span, "quaternion Julia fractals iterate only sqr and cube; add 'hypercomplex'");
        }
        Ok(Shape::JuliaFractal(Arc::new(julia)))
    }

    fn julia_item(&mut self, julia: &mut JuliaFractal) -> SourceResult<bool> {
        use JuliaFunction as F;
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        let function = match keyword {
            K::Sqr => F::Sqr,
            K::Cube => F::Cube,
            K::Exp => F::Exp,
            K::Ln => F::Ln,
            K::Sin => F::Sin,
            K::Asin => F::Asin,
            K::Cos => F::Cos,
            K::Acos => F::Acos,
            K::Tan => F::Tan,
            K::Atan => F::Atan,
            K::Sinh => F::Sinh,
            K::Asinh => F::Asinh,
            K::Cosh => F::Cosh,
            K::Acosh => F::Acosh,
            K::Tanh => F::Tanh,
            K::Atanh => F::Atanh,
            K::Reciprocal => F::Reciprocal,
            K::Pwr => {
                self.next()?;
                self.expect_punct('(', "before the arguments")?;
                let a = self.float()?;
                self.comma()?;
                let b = self.float()?;
                self.expect_punct(')', "to close it")?;
                julia.function = F::Pwr(a, b);
                return Ok(true);
            }
            _ => return self.julia_setting(keyword, julia),
        };
        self.next()?;
        julia.function = function;
        Ok(true)
    }

    fn julia_setting(&mut self, keyword: K, julia: &mut JuliaFractal) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::Quaternion | K::Hypercomplex => {
                self.next()?;
                julia.hypercomplex = keyword == K::Hypercomplex;
            }
            K::MaxIteration => {
                self.next()?;
                julia.max_iteration = self.integer()?.clamp(1, 1 << 20) as u32;
            }
            K::Precision => {
                self.next()?;
                julia.precision = self.float()?.max(1.0);
            }
            K::Slice => {
                self.next()?;
                let normal = self.vector4()?;
                self.comma()?;
                julia.slice_distance = self.float()?;
                match normal.try_normalize() {
                    // POV-Ray's smallest fourth component of a slice
                    Some(n) if n.w.abs() >= 1e-10 => julia.slice_normal = n,
                    _ => return self.error(span, "the slice's normal needs a fourth component that is not 0"),
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}
