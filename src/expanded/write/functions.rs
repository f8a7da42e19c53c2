//! Functions: programs become expressions again.
//!
//! A program is a list of operations of which several may use the same earlier one; an expression is a tree. What is
//! used more than once and is long becomes a function of its own, so that no text grows beyond its program.

use super::number::{double, vector, vector2, vector4};
use super::writer::Writer;
use crate::function::{Binary, Callee, FunctionBody, Op, Program, Spline, SplineKind, Unary};
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, DVec3, DVec4};
use crate::scene::{Function, PointFunction, PointSource};
use crate::stack::roomy;
use std::sync::Arc;

/// Longest text of an operation that is written again where it is used again.
const SHORT: usize = 40;

/// Longest text of one expression: POV-Ray's reader and ours nest only so deep.
const LONG: usize = 4000;

/// How strongly an expression holds together, weakest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Signed,
    Primary,
}

/// An expression's text.
#[derive(Clone)]
struct Term {
    text: String,
    binding: Binding,
}

impl Term {
    fn primary(text: String) -> Self {
        Self { text, binding: Binding::Primary }
    }

    /// The text where something that binds like `least` is wanted.
    fn at(&self, least: Binding) -> String {
        if self.binding >= least { self.text.clone() } else { format!("({})", self.text) }
    }
}

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
    fn function_name(&mut self, function: &Arc<Function>, always: bool) -> Option<String> {
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

    /// The text of a program with these texts for its arguments.
    fn expression(&mut self, program: &Program<PointFunction>, arguments: &[Term], names: &[&str]) -> String {
        let ops = program.ops();
        let mut uses = vec![0_u32; ops.len()];
        ops.iter().for_each(|op| op.each_operand(|slot| uses[slot as usize] += 1));
        let mut terms: Vec<Term> = Vec::with_capacity(ops.len());
        for (i, op) in ops.iter().enumerate() {
            let mut term = self.term(op, &terms, arguments, names);
            let long = (uses[i] > 1 && term.text.len() > SHORT) || term.text.len() > LONG;
            if long && i as u32 != program.result() && !names.is_empty() {
                term = self.part(&term, names);
            }
            terms.push(term);
        }
        terms.swap_remove(program.result() as usize).text
    }

    /// A part of an expression as a function of its own.
    fn part(&mut self, term: &Term, names: &[&str]) -> Term {
        let list = names.join(", ");
        // It is known by nothing but its number, and met once.
        self.parts += 1;
        let name = self.shared_at(usize::MAX - 2 * self.parts, "Part", true, |w, _| {
            w.block(&format!("function({list})"), &term.text);
        });
        Term::primary(format!("{}({list})", name.unwrap_or_default()))
    }

    fn term(&mut self, op: &Op<PointFunction>, terms: &[Term], arguments: &[Term], names: &[&str]) -> Term {
        let at = |slot: &u32| &terms[*slot as usize];
        let list = |slots: &[u32]| slots.iter().map(|s| at(s).text.clone()).collect::<Vec<_>>().join(", ");
        match op {
            Op::Constant(value) => constant(*value),
            Op::Argument(index) => arguments.get(*index as usize).cloned().unwrap_or_else(|| constant(0.0)),
            Op::Unary(Unary::Neg, a) => {
                Term { text: format!("-{}", at(a).at(Binding::Primary)), binding: Binding::Signed }
            }
            Op::Unary(f, a) => Term::primary(format!("{}({})", unary_word(*f), at(a).text)),
            Op::Binary(f, a, b) => binary(*f, at(a), at(b)),
            Op::Select(slots) => Term::primary(format!("select({})", list(slots))),
            Op::Call { callee, arguments, component, repeats: _ } => {
                let (name, member) = self.callee(callee, *component);
                Term::primary(format!("{name}({}){member}", list(arguments)))
            }
            Op::Fold { product, from, to, body, arguments } => {
                let index = format!("i{}", arguments.len());
                let mut inner: Vec<Term> = arguments.iter().map(|slot| at(slot).clone()).collect();
                inner.push(Term::primary(index.clone()));
                let (from, to) = (at(from).text.clone(), at(to).text.clone());
                // No part of the body can be a function of its own: it would not know the index.
                let _ = names;
                let body = roomy(|| self.expression(body, &inner, &[]));
                let word = if *product { "prod" } else { "sum" };
                Term::primary(format!("{word}({index}, {from}, {to}, {body})"))
            }
        }
    }

    /// The name of what is called, and which of several numbers is meant.
    fn callee(&mut self, callee: &Callee<PointFunction>, component: u8) -> (String, &'static str) {
        let is_color = matches!(callee, Callee::External(e) if matches!(e.source, PointSource::Pigment(_)));
        let function = match callee {
            Callee::Function(function) => Arc::clone(function),
            Callee::External(external) => called(FunctionBody::External(Arc::clone(external))),
            Callee::Spline(spline) => called(FunctionBody::Spline(Arc::clone(spline))),
            Callee::Internal(internal) => called(FunctionBody::Internal(internal.clone())),
        };
        let members = if is_color { COLORS } else { PLACES };
        let name = self.function_name(&function, true).unwrap_or_default();
        (name, if function.width() == 1 { "" } else { members[usize::from(component)] })
    }
}

/// Members of what gives points and of what gives colours.
const PLACES: [&str; 5] = [".x", ".y", ".z", ".t", ".transmit"];
const COLORS: [&str; 5] = [".red", ".green", ".blue", ".filter", ".transmit"];

/// Only functions can be called.
fn called(body: FunctionBody<PointFunction>) -> Arc<Function> {
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

fn constant(value: f64) -> Term {
    if value.is_nan() {
        return Term::primary("ln(-1)".into());
    }
    let text = double(value);
    let binding = if text.starts_with('-') { Binding::Signed } else { Binding::Primary };
    Term { text, binding }
}

fn binary(f: Binary, a: &Term, b: &Term) -> Term {
    let (sign, binding) = match f {
        Binary::Add => (" + ", Binding::Sum),
        Binary::Sub => (" - ", Binding::Sum),
        Binary::Mul => ("*", Binding::Product),
        Binary::Div => ("/", Binding::Product),
        Binary::Less => (" < ", Binding::Comparison),
        Binary::LessEqual => (" <= ", Binding::Comparison),
        Binary::Greater => (" > ", Binding::Comparison),
        Binary::GreaterEqual => (" >= ", Binding::Comparison),
        Binary::Equal => (" = ", Binding::Comparison),
        Binary::NotEqual => (" != ", Binding::Comparison),
        Binary::And => (" & ", Binding::And),
        Binary::Or => (" | ", Binding::Or),
        Binary::Pow | Binary::Atan2 | Binary::Mod | Binary::IntDiv | Binary::Min | Binary::Max => {
            return Term::primary(format!("{}({}, {})", binary_word(f), a.text, b.text));
        }
    };
    let next = match binding {
        Binding::Or => Binding::And,
        Binding::And => Binding::Comparison,
        Binding::Comparison => Binding::Sum,
        Binding::Sum => Binding::Product,
        _ => Binding::Signed,
    };
    // On the left, what binds as much comes first anyway.
    Term { text: format!("{}{sign}{}", a.at(binding), b.at(next)), binding }
}

fn binary_word(f: Binary) -> &'static str {
    match f {
        Binary::Pow => "pow",
        Binary::Atan2 => "atan2",
        Binary::Mod => "mod",
        Binary::IntDiv => "div",
        Binary::Min => "min",
        _ => "max",
    }
}

/// The word of a function of one number; a sign has none.
pub(crate) fn unary_word(f: Unary) -> &'static str {
    match f {
        Unary::Neg => "-",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Asin => "asin",
        Unary::Acos => "acos",
        Unary::Atan => "atan",
        Unary::Sinh => "sinh",
        Unary::Cosh => "cosh",
        Unary::Tanh => "tanh",
        Unary::Asinh => "asinh",
        Unary::Acosh => "acosh",
        Unary::Atanh => "atanh",
        Unary::Abs => "abs",
        Unary::Radians => "radians",
        Unary::Degrees => "degrees",
        Unary::Int => "int",
        Unary::Floor => "floor",
        Unary::Ceil => "ceil",
        Unary::Sqrt => "sqrt",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
        Unary::Log => "log",
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
