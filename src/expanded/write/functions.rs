//! Functions and splines, declared where they are used more than once.

use super::expressions::Term;
use super::number::{double, vector, vector2, vector4};
use super::writer::Writer;
use crate::function::{FunctionBody, Program, Spline, SplineKind};
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, DVec3, DVec4};
use crate::scene::{Function, PointFunction, PointSource};
use std::sync::Arc;

impl Writer<'_> {
    /// `function { … }` where a pattern, an isosurface or a parametric surface takes one of these arguments.
    pub(super) fn plain_function(&mut self, function: &Arc<Function>, names: &[&str]) {
        self.function_head("function", function, names);
    }

    /// The same behind other words.
    pub(super) fn function_head(&mut self, head: &str, function: &Arc<Function>, names: &[&str]) {
        let n = function.n_parameters;
        // Only what is called with exactly these arguments can be called by its name.
        let named = (n == names.len() && function.width() == 1).then(|| self.function_name(function, false)).flatten();
        match (named, &function.body) {
            (Some(name), _) => self.block(head, format_args!("{name}({})", names.join(", "))),
            (None, FunctionBody::Program(program)) => {
                let arguments: Vec<Term> = names.iter().map(|name| Term::primary((*name).into())).collect();
                let text = self.expression(program, &arguments, names);
                self.block(head, text);
            }
            (None, body) => {
                self.open(head);
                self.special_body(body);
                self.close();
            }
        }
    }

    /// The name of a function that several things use; with `always`, of any. What has a body that is shared by itself is
    /// known by that.
    pub(super) fn function_name(&mut self, function: &Arc<Function>, always: bool) -> Option<String> {
        let key = match &function.body {
            FunctionBody::Program(_) | FunctionBody::Transform(_) => Arc::as_ptr(function) as usize,
            FunctionBody::External(external) => Arc::as_ptr(external) as usize,
            FunctionBody::Internal(internal) => internal.identity(),
            // Odd, as no address of something that is shared is: the spline itself may have a name, too.
            FunctionBody::Spline(spline) => Arc::as_ptr(spline) as usize | 1,
        };
        self.shared_at(key, "Function", always, |w, _| match &function.body {
            FunctionBody::Program(program) => w.declared_program(program, function.n_parameters),
            body => {
                w.noise_for(body);
                w.open("function");
                w.special_body(body);
                w.close();
            }
        })
    }

    /// `function(parameters) { expression }`.
    fn declared_program(&mut self, program: &Program<PointFunction>, n_parameters: usize) {
        let names = parameter_names(n_parameters);
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let arguments: Vec<Term> = names.iter().map(|name| Term::primary((*name).into())).collect();
        let text = self.expression(program, &arguments, &names);
        self.block(&format!("function({})", names.join(", ")), text);
    }

    /// A body that is no expression.
    fn special_body(&mut self, body: &FunctionBody<PointFunction>) {
        match body {
            FunctionBody::Program(_) => {}
            FunctionBody::Internal(internal) => self.line(format_args!("internal({})", internal.number())),
            FunctionBody::External(external) => match &external.source {
                PointSource::Pigment(pigment) => {
                    self.open("pigment");
                    self.pigment_parts(pigment);
                    self.close();
                }
                PointSource::Pattern(pattern) => {
                    self.open("pattern");
                    self.pattern(pattern, |_| {});
                    self.close();
                }
            },
            FunctionBody::Spline(spline) => {
                self.open("spline");
                self.spline_content(spline);
                self.close();
            }
            FunctionBody::Transform(transform) => {
                self.open("transform");
                self.transform(transform);
                self.close();
            }
        }
    }

    /// The scene's noise generator stands as it stood where the function was declared.
    fn noise_for(&mut self, body: &FunctionBody<PointFunction>) {
        let needed = match body {
            FunctionBody::External(external) => external.settings.noise_generator(),
            FunctionBody::Internal(internal) => noise_number(internal.generator()),
            _ => return,
        };
        if needed != self.noise_here() {
            self.statement_ahead(&format!("global_settings {{ noise_generator {needed} }}"));
            self.noise_ahead = Some(needed);
        }
    }

    /// The noise generator in force where declarations stand.
    fn noise_here(&self) -> u8 {
        self.noise_ahead.unwrap_or_else(|| self.settings.noise_generator.unwrap_or(2))
    }

    /// Puts the scene's own noise generator back.
    pub(super) fn end_of_declarations(&mut self) {
        let own = self.settings.noise_generator.unwrap_or(2);
        if self.noise_ahead.is_some_and(|noise| noise != own) {
            self.statement_ahead(&format!("global_settings {{ noise_generator {own} }}"));
        }
    }

    fn spline_content(&mut self, spline: &Arc<Spline>) {
        let name = self.shared(spline, "Spline", false, |w| {
            w.open("spline");
            w.spline_parts(spline);
            w.close();
        });
        match name {
            Some(name) => self.line(name),
            None => self.spline_parts(spline),
        }
    }

    fn spline_parts(&mut self, spline: &Spline) {
        self.line(match spline.kind() {
            SplineKind::Linear => "linear_spline",
            SplineKind::Quadratic => "quadratic_spline",
            SplineKind::Cubic => "cubic_spline",
            SplineKind::Natural => "natural_spline",
        });
        for (at, value) in spline.knots() {
            self.line(format_args!("{}, {}", double(*at), knot(value, spline.width())));
        }
    }
}

/// Only functions can be called.
pub(super) fn called(body: FunctionBody<PointFunction>) -> Arc<Function> {
    Arc::new(Function { n_parameters: 0, body })
}

/// What parameters are called: as in a pattern, if there are as many.
fn parameter_names(n: usize) -> Vec<String> {
    match n {
        3 => ["x", "y", "z"].map(str::to_owned).to_vec(),
        2 => ["u", "v"].map(str::to_owned).to_vec(),
        _ => (0..n).map(|i| format!("p{i}")).collect(),
    }
}

fn noise_number(generator: NoiseGenerator) -> u8 {
    match generator {
        NoiseGenerator::Original => 1,
        NoiseGenerator::Corrected => 2,
        NoiseGenerator::Perlin => 3,
    }
}

/// A spline's value with as many components as it has.
fn knot(value: &[f64; 5], width: usize) -> String {
    let [a, b, c, d, _] = *value;
    match width {
        0 | 1 => double(a),
        2 => vector2(DVec2::new(a, b)),
        3 => vector(DVec3::new(a, b, c)),
        4 => vector4(DVec4::new(a, b, c, d)),
        _ => super::number::numbers(value),
    }
}
