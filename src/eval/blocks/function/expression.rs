//! Expressions of functions, which become programs.
//!
//! Their operators are those of [`crate::syntax::expression`]; an operand has one sign at most.

use crate::diag::{Diagnostic, SourceResult, Span};
use crate::eval::macros::arguments_in_words;
use crate::eval::{Evaluator, Value};
use crate::function::{Binary, FunctionBody, ProgramBuilder, Slot, Unary};
use crate::scene::{Function, PointFunction};
use crate::syntax::built_in::{BuiltIn, Takes};
use crate::syntax::expression::{Build, Language, Operator, Strength, chain, component};
use crate::syntax::{Keyword as K, Symbol, TokenKind};
use smallvec::{SmallVec, smallvec};
use std::rc::Rc;
use std::sync::Arc;

/// Parentheses and calls nest at most this deep, so that no input overflows the stack.
const MAX_DEPTH: u32 = 200;

/// Reads an expression and makes a program of it.
struct Reader<'e, 'h> {
    evaluator: &'e mut Evaluator<'h>,
    builder: ProgramBuilder<PointFunction>,
    /// Names that stand for arguments, innermost last.
    names: Vec<(Rc<str>, u32)>,
    /// The function's parameters and the indices of enclosing `sum`s and `prod`s.
    n_arguments: u32,
    depth: u32,
}

/// The function of these parameters whose expression comes next.
pub(super) fn program(evaluator: &mut Evaluator<'_>, parameters: &[Rc<str>]) -> SourceResult<Function> {
    let mut names = Vec::new();
    // The first of two equal names is seen, except that x and u, y and v are one variable
    // each, which the later position supplies.
    let synonym = |name: &str| match name {
        "u" => Some("x"),
        "v" => Some("y"),
        "x" => Some("u"),
        "y" => Some("v"),
        _ => None,
    };
    for (i, name) in parameters.iter().enumerate().rev() {
        names.push((name.clone(), i as u32));
    }
    for (i, name) in parameters.iter().enumerate() {
        if let Some(other) = synonym(name) {
            names.push((other.into(), i as u32));
            names.push((name.clone(), i as u32));
        }
    }
    let mut reader = Reader { n_arguments: parameters.len() as u32, ..Reader::new(evaluator, names) };
    let result = reader.whole()?;
    let program = reader.builder.finish(result);
    Ok(Function { n_parameters: parameters.len(), body: FunctionBody::Program(program) })
}

impl Build for Reader<'_, '_> {
    type Built = Slot;
    type Place = ();
    type Mark = Span;
    type Stop = Vec<Diagnostic>;
    const LANGUAGE: Language = Language::Functions;

    fn operator(&mut self) -> SourceResult<Option<Operator>> {
        Ok(Operator::of(self.evaluator.fill(false)?))
    }

    fn take_operator(&mut self) -> Span {
        self.evaluator.take_operator()
    }

    fn operand(&mut self, (): ()) -> SourceResult<Slot> {
        if self.evaluator.accept_punct('-')? {
            let operand = self.nested_operand()?;
            return Ok(self.builder.unary(Unary::Neg, operand));
        }
        self.evaluator.accept_punct('+')?;
        self.nested_operand()
    }

    fn combine(&mut self, operator: Operator, left: &mut Slot, right: Slot, span: Span) -> SourceResult<()> {
        if operator == Operator::Divide && self.builder.is_zero(right) {
            return self.evaluator.error(span, "division by zero");
        }
        *left = self.builder.binary(binary(operator), *left, right);
        Ok(())
    }
}

/// What an operator does in a program.
fn binary(operator: Operator) -> Binary {
    match operator {
        Operator::Add => Binary::Add,
        Operator::Subtract => Binary::Sub,
        Operator::Multiply => Binary::Mul,
        Operator::Divide => Binary::Div,
        Operator::Less => Binary::Less,
        Operator::AtMost => Binary::LessEqual,
        Operator::Equal => Binary::Equal,
        Operator::Differs => Binary::NotEqual,
        Operator::AtLeast => Binary::GreaterEqual,
        Operator::Greater => Binary::Greater,
        Operator::And => Binary::And,
        Operator::Or => Binary::Or,
    }
}

impl<'e, 'h> Reader<'e, 'h> {
    fn new(evaluator: &'e mut Evaluator<'h>, names: Vec<(Rc<str>, u32)>) -> Self {
        Self { evaluator, builder: ProgramBuilder::default(), names, n_arguments: 0, depth: 0 }
    }
}

impl Reader<'_, '_> {
    /// An expression up to where it ends.
    fn whole(&mut self) -> SourceResult<Slot> {
        chain(self, Strength::Or, ())
    }

    fn nested_operand(&mut self) -> SourceResult<Slot> {
        let span = self.evaluator.span();
        if self.depth >= MAX_DEPTH {
            return self.evaluator.error(span, "this function nests too deeply");
        }
        self.depth += 1;
        let slot = self.primary(span);
        self.depth -= 1;
        slot
    }

    fn primary(&mut self, span: Span) -> SourceResult<Slot> {
        if self.evaluator.accept_punct('(')? {
            let inner = self.whole()?;
            self.evaluator.expect_punct(')', "to close it")?;
            return Ok(inner);
        }
        match self.evaluator.peek()?.kind {
            TokenKind::Number(n) => {
                self.evaluator.next()?;
                Ok(self.builder.constant(n))
            }
            TokenKind::Keyword(k) => {
                self.evaluator.next()?;
                self.keyword_operand(k, span)
            }
            TokenKind::Name(name) => self.name(name, span),
            _ => self.evaluator.expected("an operand of a function"),
        }
    }

    /// A parameter, another function, or a number captured by value.
    fn name(&mut self, name: Symbol, span: Span) -> SourceResult<Slot> {
        let text = self.evaluator.names.words.word(name).clone();
        if let Some(index) = self.find(&text) {
            self.evaluator.next()?;
            return Ok(self.builder.argument(index));
        }
        let function = |v: &Value| match v {
            Value::Function(f) => Some(f.clone()),
            Value::Spline(s) => Some(Arc::new(Function { n_parameters: 1, body: FunctionBody::Spline(s.clone()) })),
            _ => None,
        };
        if let Some(function) = self.evaluator.take_declared(function)? {
            return self.call(&function, span);
        }
        if let Some(value) = self.evaluator.take_declared(|v| if let Value::Float(v) = v { Some(*v) } else { None })? {
            return Ok(self.builder.constant(value));
        }
        match self.evaluator.names.get(name) {
            Some(_) => self.evaluator.error(span, format!("'{text}' is not a number and cannot stand in a function")),
            None => self.evaluator.undeclared(name, span),
        }
    }

    fn keyword_operand(&mut self, keyword: K, span: Span) -> SourceResult<Slot> {
        let Some(built_in) = BuiltIn::in_functions(keyword) else {
            return self.evaluator.error_with_hint(
                span,
                format!("'{}' cannot stand in a function", keyword.word()),
                "a function calculates with numbers, one component at a time",
            );
        };
        match built_in.takes {
            Takes::Number(value) => return Ok(self.builder.constant(value)),
            Takes::State => return Ok(self.builder.constant(self.evaluator.options.clock)),
            Takes::Axis(..) => {
                return Ok(match self.find(keyword.word()) {
                    Some(index) => self.builder.argument(index),
                    None => self.builder.constant(0.0),
                });
            }
            Takes::Other(_) => return self.fold(keyword == K::Prod),
            _ => {}
        }
        let arguments = self.arguments()?;
        match (built_in.takes, &arguments[..]) {
            (Takes::Float, [a]) => Ok(self.builder.unary(unary(keyword), *a)),
            (Takes::TwoFloats, [a, b]) => Ok(self.builder.binary(of_two(keyword), *a, *b)),
            (Takes::Floats, [first, rest @ ..]) => {
                let f = if keyword == K::Min { Binary::Min } else { Binary::Max };
                Ok(rest.iter().fold(*first, |a, b| self.builder.binary(f, a, *b)))
            }
            (Takes::Choice, &[c, negative, other]) => Ok(self.builder.select([c, negative, other, other])),
            (Takes::Choice, &[c, negative, zero, positive]) => Ok(self.builder.select([c, negative, zero, positive])),
            (takes, _) => {
                let message = format!("'{}' takes {}", keyword.word(), counted(takes));
                self.evaluator.error(span, message)
            }
        }
    }

    fn arguments(&mut self) -> SourceResult<SmallVec<[Slot; 4]>> {
        self.evaluator.expect_punct('(', "before the arguments")?;
        let mut arguments = smallvec![];
        if self.evaluator.accept_punct(')')? {
            return Ok(arguments);
        }
        loop {
            arguments.push(self.whole()?);
            if !self.evaluator.accept_punct(',')? {
                self.evaluator.expect_punct(')', "after the arguments")?;
                return Ok(arguments);
            }
        }
    }

    /// `sum(i, from, to, E)`: E becomes a program of its own that also takes all outer names.
    fn fold(&mut self, product: bool) -> SourceResult<Slot> {
        self.evaluator.expect_punct('(', "before the arguments")?;
        let token = self.evaluator.next()?;
        let name: Rc<str> = match token.kind {
            TokenKind::Name(name) => self.evaluator.names.words.word(name).clone(),
            TokenKind::Keyword(k @ (K::X | K::Y | K::Z | K::U | K::V)) => k.word().into(),
            _ => return self.evaluator.error(token.span, "expected the name of the running index"),
        };
        self.evaluator.expect_punct(',', "between the arguments")?;
        let from = self.whole()?;
        self.evaluator.expect_punct(',', "between the arguments")?;
        let to = self.whole()?;
        self.evaluator.expect_punct(',', "between the arguments")?;
        let index = self.n_arguments;
        let names = self.names.clone();
        let mut inner = Reader { n_arguments: index + 1, depth: self.depth, ..Reader::new(self.evaluator, names) };
        if matches!(token.kind, TokenKind::Name(_)) {
            inner.names.push((name, index));
        }
        let result = inner.whole()?;
        let program = inner.builder.finish(result);
        self.evaluator.expect_punct(')', "to close it")?;
        let arguments = (0..index).map(|i| self.builder.argument(i)).collect();
        Ok(self.builder.fold(product, from, to, program, arguments))
    }

    /// `f(arguments)` with a member after functions that return several numbers.
    fn call(&mut self, function: &Arc<Function>, span: Span) -> SourceResult<Slot> {
        let arguments = self.arguments()?;
        if arguments.len() != function.n_parameters {
            let (given, needed) = (arguments.len(), function.n_parameters);
            return self
                .evaluator
                .error(span, format!("this function takes {}, not {given}", arguments_in_words(needed)));
        }
        if function.width() == 1 {
            return Ok(self.builder.call(function, arguments, 0));
        }
        self.evaluator.expect_punct('.', "and which of the returned numbers is meant")?;
        let token = self.evaluator.next()?;
        /// POV-Ray's luminance.
        const GRAY: [f64; 3] = [0.297, 0.589, 0.114];
        /// The undocumented value of a height field: 0.996093 (red + green / 255).
        const HEIGHT: [f64; 2] = [0.996093, 0.996093 / 255.0];
        let word = match token.kind {
            TokenKind::Name(name) => &**self.evaluator.names.words.word(name),
            TokenKind::Keyword(word) => word.word(),
            _ => "",
        };
        let member = if let TokenKind::Keyword(word) = token.kind { component(word) } else { None };
        match (word, member) {
            (_, Some(i)) => Ok(self.builder.call(function, arguments, i)),
            ("gray" | "grey", _) => Ok(self.weighted(function, &arguments, &GRAY)),
            ("hf", _) => Ok(self.weighted(function, &arguments, &HEIGHT)),
            _ => self.evaluator.error(token.span, "expected x, y, z, t, red, green, blue, filter, transmit or gray"),
        }
    }

    /// The first components of a call, weighted and summed up.
    fn weighted(&mut self, function: &Arc<Function>, arguments: &SmallVec<[Slot; 4]>, weights: &[f64]) -> Slot {
        let slots: SmallVec<[Slot; 3]> =
            (0..weights.len()).map(|i| self.builder.call(function, arguments.clone(), i as u8)).collect();
        let mut total = None;
        for (slot, weight) in slots.into_iter().zip(weights) {
            let weight = self.builder.constant(*weight);
            let term = self.builder.binary(Binary::Mul, slot, weight);
            total = Some(match total {
                None => term,
                Some(sum) => self.builder.binary(Binary::Add, sum, term),
            });
        }
        total.unwrap_or_else(|| self.builder.constant(0.0))
    }

    fn find(&self, name: &str) -> Option<u32> {
        self.names.iter().rev().find(|(n, _)| &**n == name).map(|(_, index)| *index)
    }
}

/// What a function of one number does in a program.
fn unary(function: K) -> Unary {
    match function {
        K::Sin => Unary::Sin,
        K::Cos => Unary::Cos,
        K::Tan => Unary::Tan,
        K::Asin => Unary::Asin,
        K::Acos => Unary::Acos,
        K::Atan => Unary::Atan,
        K::Sinh => Unary::Sinh,
        K::Cosh => Unary::Cosh,
        K::Tanh => Unary::Tanh,
        K::Asinh => Unary::Asinh,
        K::Acosh => Unary::Acosh,
        K::Atanh => Unary::Atanh,
        K::Radians => Unary::Radians,
        K::Degrees => Unary::Degrees,
        K::Int => Unary::Int,
        K::Floor => Unary::Floor,
        K::Ceil => Unary::Ceil,
        K::Sqrt => Unary::Sqrt,
        K::Exp => Unary::Exp,
        K::Ln => Unary::Ln,
        K::Log => Unary::Log,
        _ => Unary::Abs,
    }
}

/// What a function of two numbers does in a program.
fn of_two(function: K) -> Binary {
    match function {
        K::Pow => Binary::Pow,
        K::Atan2 => Binary::Atan2,
        K::Mod => Binary::Mod,
        _ => Binary::IntDiv,
    }
}

/// How many arguments that is, in words.
fn counted(takes: Takes) -> &'static str {
    match takes {
        Takes::TwoFloats => "two arguments",
        Takes::Floats => "at least one argument",
        Takes::Choice => "three or four arguments",
        _ => "one argument",
    }
}
