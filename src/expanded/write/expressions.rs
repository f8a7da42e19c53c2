//! Expressions: programs as the trees that they were.
//!
//! A program is a list of operations of which several may use the same earlier one; an expression is a tree. What is
//! used more than once and is long becomes a function of its own, so that no text grows beyond its program.

use super::functions::called;
use super::number::double;
use super::writer::Writer;
use crate::function::{Binary, Callee, FunctionBody, Op, Program, Unary};
use crate::scene::{PointFunction, PointSource};
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
pub(super) struct Term {
    text: String,
    binding: Binding,
}

impl Term {
    pub(super) fn primary(text: String) -> Self {
        Self { text, binding: Binding::Primary }
    }

    /// The text where something that binds like `least` is wanted.
    fn at(&self, least: Binding) -> String {
        if self.binding >= least { self.text.clone() } else { format!("({})", self.text) }
    }
}

impl Writer<'_> {
    /// The text of a program with these texts for its arguments.
    pub(super) fn expression(
        &mut self,
        program: &Program<PointFunction>,
        arguments: &[Term],
        names: &[&str],
    ) -> String {
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
