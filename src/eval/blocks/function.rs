//! `function … { … }`: bodies have an expression language of their own, which becomes a program.
//!
//! Binding, strongest first: member, one unary sign, `* /`, `+ -`, comparisons, `&`, `|`.
//! Section 2 of the function facts.

use super::pattern::no_list;
use crate::diag::{Diagnostic, SourceResult, Span};
use crate::eval::macros::arguments_in_words;
use crate::eval::{Evaluator, Place, Value};
use crate::function::{Binary, FunctionBody, Internal, ProgramBuilder, Slot, Unary};
use crate::math::noise::NoiseGenerator;
use crate::scene::{Function, Pattern, PatternKind, Pigment, PointFunction, PointSource};
use crate::syntax::{Keyword as K, Symbol, TokenKind};
use smallvec::{SmallVec, smallvec};
use std::rc::Rc;
use std::sync::Arc;

/// As POV-Ray has it.
const MAX_PARAMETERS: usize = 56;

/// Names that a body may use, innermost last.
#[derive(Default)]
struct Body {
    builder: ProgramBuilder<PointFunction>,
    names: Vec<(Rc<str>, u32)>,
    /// How many indices of enclosing `sum`s and `prod`s come after the function's parameters.
    n_arguments: u32,
    depth: u32,
}

/// Parentheses and calls nest at most this deep, so that no input overflows the stack.
const MAX_DEPTH: u32 = 200;

impl Evaluator<'_> {
    /// `[(parameters)] { … }` after `function` in a declaration.
    pub(in crate::eval) fn function_block(&mut self) -> SourceResult<Arc<Function>> {
        let mut names: Vec<Rc<str>> = Vec::new();
        let span = self.span();
        let listed = self.accept_punct('(')?;
        if listed {
            while !self.accept_punct(')')? {
                names.push(self.parameter_name()?);
                self.comma()?;
            }
            if names.is_empty() || names.len() > MAX_PARAMETERS {
                return self.error(span, format!("a function takes 1 to {MAX_PARAMETERS} parameters"));
            }
        }
        self.open("function")?;
        let function = match self.keyword()? {
            Some(k @ (K::Pigment | K::Pattern | K::Transform | K::Spline | K::Internal)) => {
                if listed && k != K::Internal {
                    let word = k.word();
                    return self
                        .error(span, format!("a {word} function takes no parameter list; it is called at a point"));
                }
                self.special_body(k)?
            }
            _ if listed => self.expression_body(&names)?,
            _ => self.expression_body(&["x".into(), "y".into(), "z".into()])?,
        };
        self.close("function")?;
        Ok(Arc::new(function))
    }

    /// `{ expression }` of x, y and z, or any other body, after `function` in a pattern or object.
    pub(super) fn plain_function(&mut self) -> SourceResult<Arc<Function>> {
        self.open("function")?;
        let function = self.plain_function_items(&["x", "y", "z"])?;
        self.close("function")?;
        Ok(function)
    }

    /// The inside of a body whose braces are read by the caller.
    pub(super) fn plain_function_items(&mut self, names: &[&str]) -> SourceResult<Arc<Function>> {
        let function = match self.keyword()? {
            Some(k @ (K::Pigment | K::Pattern | K::Transform | K::Spline | K::Internal)) => self.special_body(k)?,
            _ => {
                let names: Vec<Rc<str>> = names.iter().map(|n| Rc::from(*n)).collect();
                self.expression_body(&names)?
            }
        };
        Ok(Arc::new(function))
    }

    fn parameter_name(&mut self) -> SourceResult<Rc<str>> {
        let token = self.next()?;
        match &token.kind {
            TokenKind::Keyword(k @ (K::X | K::Y | K::Z | K::U | K::V)) => Ok(k.word().into()),
            TokenKind::Name(name) if self.meaning(*name).is_none() => Ok(self.names.words.word(*name).clone()),
            TokenKind::Name(name) => {
                let name = self.names.words.word(*name).clone();
                self.error(token.span, format!("'{name}' is already declared and cannot name a parameter"))
            }
            _ => self.error(token.span, "expected a parameter name"),
        }
    }

    fn special_body(&mut self, keyword: K) -> SourceResult<Function> {
        self.next()?;
        let span = self.span();
        let (n_parameters, body) = match keyword {
            K::Pigment => {
                let pigment = self.pigment_block(Pigment::default())?;
                (3, FunctionBody::External(self.point_function(PointSource::Pigment(pigment), span)?))
            }
            K::Pattern => {
                self.open("pattern")?;
                let mut pattern = Pattern::new(PatternKind::None);
                if !self.pattern_keyword(&mut pattern, &mut no_list)? {
                    return self.expected("a pattern");
                }
                while self.pattern_modifier(&mut pattern)? {
                    self.comma()?;
                }
                self.close("pattern")?;
                (3, FunctionBody::External(self.point_function(PointSource::Pattern(pattern), span)?))
            }
            K::Transform => (3, FunctionBody::Transform(self.transform_block()?)),
            K::Spline => (1, FunctionBody::Spline(self.spline_block()?)),
            _ => {
                self.expect_punct('(', "before the number of an internal function")?;
                let number = self.float()?;
                self.expect_punct(')', "to close it")?;
                let generator = self.noise_generator();
                let found = (number >= 0.0).then(|| Internal::new(number as u32, generator)).flatten();
                let Some(internal) = found else {
                    return self.error(span, format!("there is no internal function {number}"));
                };
                (3 + internal.n_extra(), FunctionBody::Internal(internal))
            }
        };
        Ok(Function { n_parameters, body })
    }

    /// A function of a pigment or pattern, with the settings of here; what is wrong with it stands at `span` at least.
    fn point_function(&self, source: PointSource, span: Span) -> SourceResult<Arc<PointFunction>> {
        let settings = Arc::new(self.scene.settings.clone());
        let function = Arc::new(PointFunction { source, settings });
        self.queries.check(&function).map_err(|wrong| {
            let span = wrong.span.or(Some(span));
            vec![self.with_trace(Diagnostic { span, ..wrong })]
        })?;
        Ok(function)
    }

    fn expression_body(&mut self, names: &[Rc<str>]) -> SourceResult<Function> {
        let mut body = Body { n_arguments: names.len() as u32, ..Body::default() };
        // The first of two equal names is seen, except that x and u, y and v are one variable
        // each, which the later position supplies.
        let synonym = |name: &str| match name {
            "u" => Some("x"),
            "v" => Some("y"),
            "x" => Some("u"),
            "y" => Some("v"),
            _ => None,
        };
        for (i, name) in names.iter().enumerate().rev() {
            body.names.push((name.clone(), i as u32));
        }
        for (i, name) in names.iter().enumerate() {
            if let Some(other) = synonym(name) {
                body.names.push((other.into(), i as u32));
                body.names.push((name.clone(), i as u32));
            }
        }
        let result = self.function_or(&mut body)?;
        let program = body.builder.finish(result);
        Ok(Function { n_parameters: names.len(), body: FunctionBody::Program(program) })
    }

    fn function_or(&mut self, body: &mut Body) -> SourceResult<Slot> {
        let mut left = self.function_and(body)?;
        while self.accept_punct('|')? {
            let right = self.function_and(body)?;
            left = body.builder.binary(Binary::Or, left, right);
        }
        Ok(left)
    }

    fn function_and(&mut self, body: &mut Body) -> SourceResult<Slot> {
        let mut left = self.function_comparison(body)?;
        while self.accept_punct('&')? {
            let right = self.function_comparison(body)?;
            left = body.builder.binary(Binary::And, left, right);
        }
        Ok(left)
    }

    fn function_comparison(&mut self, body: &mut Body) -> SourceResult<Slot> {
        let mut left = self.function_sum(body)?;
        loop {
            let f = match self.peek()?.kind {
                TokenKind::Punct('<') => Binary::Less,
                TokenKind::Punct('>') => Binary::Greater,
                TokenKind::Punct('=') => Binary::Equal,
                TokenKind::OrEqual('<') => Binary::LessEqual,
                TokenKind::OrEqual('>') => Binary::GreaterEqual,
                TokenKind::OrEqual('!') => Binary::NotEqual,
                _ => return Ok(left),
            };
            self.next()?;
            let right = self.function_sum(body)?;
            left = body.builder.binary(f, left, right);
        }
    }

    fn function_sum(&mut self, body: &mut Body) -> SourceResult<Slot> {
        let mut left = self.function_product(body)?;
        loop {
            let f = if self.accept_punct('+')? {
                Binary::Add
            } else if self.accept_punct('-')? {
                Binary::Sub
            } else {
                return Ok(left);
            };
            let right = self.function_product(body)?;
            left = body.builder.binary(f, left, right);
        }
    }

    fn function_product(&mut self, body: &mut Body) -> SourceResult<Slot> {
        let mut left = self.function_signed(body)?;
        loop {
            let f = if self.accept_punct('*')? {
                Binary::Mul
            } else if self.accept_punct('/')? {
                Binary::Div
            } else {
                return Ok(left);
            };
            let span = self.span();
            let right = self.function_signed(body)?;
            if f == Binary::Div && body.builder.is_zero(right) {
                return self.error(span, "division by zero");
            }
            left = body.builder.binary(f, left, right);
        }
    }

    fn function_signed(&mut self, body: &mut Body) -> SourceResult<Slot> {
        if self.accept_punct('-')? {
            let operand = self.function_operand(body)?;
            return Ok(body.builder.unary(Unary::Neg, operand));
        }
        self.accept_punct('+')?;
        self.function_operand(body)
    }

    fn function_operand(&mut self, body: &mut Body) -> SourceResult<Slot> {
        let span = self.span();
        if body.depth >= MAX_DEPTH {
            return self.error(span, "this function nests too deeply");
        }
        body.depth += 1;
        let slot = self.function_primary(body, span);
        body.depth -= 1;
        slot
    }

    fn function_primary(&mut self, body: &mut Body, span: Span) -> SourceResult<Slot> {
        if self.accept_punct('(')? {
            let inner = self.function_or(body)?;
            self.expect_punct(')', "to close it")?;
            return Ok(inner);
        }
        match self.peek()?.kind {
            TokenKind::Number(n) => {
                self.next()?;
                Ok(body.builder.constant(n))
            }
            TokenKind::Keyword(k) => {
                self.next()?;
                self.function_keyword(body, k, span)
            }
            TokenKind::Name(name) => self.function_name(body, name, span),
            _ => self.expected("an operand of a function"),
        }
    }

    /// A parameter, another function, or a number captured by value.
    fn function_name(&mut self, body: &mut Body, name: Symbol, span: Span) -> SourceResult<Slot> {
        let text = self.names.words.word(name).clone();
        if let Some(index) = body.find(&text) {
            self.next()?;
            return Ok(body.builder.argument(index));
        }
        let function = |v: &Value| match v {
            Value::Function(f) => Some(f.clone()),
            Value::Spline(s) => Some(Arc::new(Function { n_parameters: 1, body: FunctionBody::Spline(s.clone()) })),
            _ => None,
        };
        if let Some(function) = self.take_declared(function)? {
            return self.function_call(body, &function, span);
        }
        if let Some(value) = self.take_declared(|v| if let Value::Float(v) = v { Some(*v) } else { None })? {
            return Ok(body.builder.constant(value));
        }
        match self.meaning(name) {
            Some(_) => self.error(span, format!("'{text}' is not a number and cannot stand in a function")),
            None => self.undeclared(name, span),
        }
    }

    /// The scene's noise generator as it stands now.
    fn noise_generator(&self) -> NoiseGenerator {
        match self.scene.settings.noise_generator {
            Some(1) => NoiseGenerator::Original,
            Some(3) => NoiseGenerator::Perlin,
            None if self.version < 350 => NoiseGenerator::Original,
            _ => NoiseGenerator::Corrected,
        }
    }

    /// What a name stands for.
    fn meaning(&self, name: Symbol) -> Option<Value> {
        self.names.find(name).and_then(Place::get)
    }

    fn function_keyword(&mut self, body: &mut Body, keyword: K, span: Span) -> SourceResult<Slot> {
        let unary = match keyword {
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
            K::Abs => Unary::Abs,
            K::Radians => Unary::Radians,
            K::Degrees => Unary::Degrees,
            K::Int => Unary::Int,
            K::Floor => Unary::Floor,
            K::Ceil => Unary::Ceil,
            K::Sqrt => Unary::Sqrt,
            K::Exp => Unary::Exp,
            K::Ln => Unary::Ln,
            K::Log => Unary::Log,
            _ => return self.function_word(body, keyword, span),
        };
        let arguments = self.function_arguments(body)?;
        match arguments[..] {
            [a] => Ok(body.builder.unary(unary, a)),
            _ => self.error(span, format!("'{}' takes one argument", keyword.word())),
        }
    }

    fn function_word(&mut self, body: &mut Body, keyword: K, span: Span) -> SourceResult<Slot> {
        match keyword {
            K::X | K::Y | K::Z | K::U | K::V => Ok(match body.find(keyword.word()) {
                Some(index) => body.builder.argument(index),
                None => body.builder.constant(0.0),
            }),
            K::Pi => Ok(body.builder.constant(std::f64::consts::PI)),
            K::Clock => Ok(body.builder.constant(self.options.clock)),
            K::Pow | K::Atan2 | K::Mod | K::Div => {
                let f = match keyword {
                    K::Pow => Binary::Pow,
                    K::Atan2 => Binary::Atan2,
                    K::Mod => Binary::Mod,
                    _ => Binary::IntDiv,
                };
                match self.function_arguments(body)?[..] {
                    [a, b] => Ok(body.builder.binary(f, a, b)),
                    _ => self.error(span, format!("'{}' takes two arguments", keyword.word())),
                }
            }
            K::Min | K::Max => {
                let f = if keyword == K::Min { Binary::Min } else { Binary::Max };
                let arguments = self.function_arguments(body)?;
                let folded = arguments.into_iter().reduce(|a, b| body.builder.binary(f, a, b));
                folded.map_or_else(|| self.error(span, "'min' and 'max' need arguments"), Ok)
            }
            K::Select => match self.function_arguments(body)?[..] {
                [c, negative, other] => Ok(body.builder.select([c, negative, other, other])),
                [c, negative, zero, positive] => Ok(body.builder.select([c, negative, zero, positive])),
                _ => self.error(span, "'select' takes three or four arguments"),
            },
            K::Sum | K::Prod => self.function_fold(body, keyword == K::Prod),
            _ => self.error_with_hint(
                span,
                format!("'{}' cannot stand in a function", keyword.word()),
                "a function calculates with numbers, one component at a time",
            ),
        }
    }

    fn function_arguments(&mut self, body: &mut Body) -> SourceResult<SmallVec<[Slot; 4]>> {
        self.expect_punct('(', "before the arguments")?;
        let mut arguments = smallvec![];
        if self.accept_punct(')')? {
            return Ok(arguments);
        }
        loop {
            arguments.push(self.function_or(body)?);
            if !self.accept_punct(',')? {
                self.expect_punct(')', "after the arguments")?;
                return Ok(arguments);
            }
        }
    }

    /// `sum(i, from, to, E)`: E becomes a program of its own that also takes all outer names.
    fn function_fold(&mut self, body: &mut Body, product: bool) -> SourceResult<Slot> {
        self.expect_punct('(', "before the arguments")?;
        let token = self.next()?;
        let name: Rc<str> = match token.kind {
            TokenKind::Name(name) => self.names.words.word(name).clone(),
            TokenKind::Keyword(k @ (K::X | K::Y | K::Z | K::U | K::V)) => k.word().into(),
            _ => return self.error(token.span, "expected the name of the running index"),
        };
        self.expect_punct(',', "between the arguments")?;
        let from = self.function_or(body)?;
        self.expect_punct(',', "between the arguments")?;
        let to = self.function_or(body)?;
        self.expect_punct(',', "between the arguments")?;
        let index = body.n_arguments;
        let mut inner = Body {
            builder: ProgramBuilder::default(),
            names: body.names.clone(),
            n_arguments: index + 1,
            depth: body.depth,
        };
        if matches!(token.kind, TokenKind::Name(_)) {
            inner.names.push((name, index));
        }
        let result = self.function_or(&mut inner)?;
        self.expect_punct(')', "to close it")?;
        let arguments = (0..index).map(|i| body.builder.argument(i)).collect();
        let program = inner.builder.finish(result);
        Ok(body.builder.fold(product, from, to, program, arguments))
    }

    /// `f(arguments)` with a member after functions that return several numbers.
    fn function_call(&mut self, body: &mut Body, function: &Arc<Function>, span: Span) -> SourceResult<Slot> {
        let arguments = self.function_arguments(body)?;
        if arguments.len() != function.n_parameters {
            let (given, needed) = (arguments.len(), function.n_parameters);
            return self.error(span, format!("this function takes {}, not {given}", arguments_in_words(needed)));
        }
        if function.width() == 1 {
            return Ok(body.builder.call(function, arguments, 0));
        }
        self.expect_punct('.', "and which of the returned numbers is meant")?;
        let component = |body: &mut Body, i: u8| body.builder.call(function, arguments.clone(), i);
        let token = self.next()?;
        let member = match token.kind {
            TokenKind::Keyword(k) => match k {
                K::X | K::U | K::Red => Some(0),
                K::Y | K::V | K::Green => Some(1),
                K::Z | K::Blue => Some(2),
                K::T | K::Filter => Some(3),
                K::Transmit => Some(4),
                K::Gray => {
                    let weights = [0.297, 0.589, 0.114]; // POV-Ray's luminance
                    let slots = [0, 1, 2].map(|i| component(body, i));
                    return Ok(body.weighted(slots, weights));
                }
                _ => None,
            },
            TokenKind::Name(name) if &**self.names.words.word(name) == "grey" => {
                let weights = [0.297, 0.589, 0.114];
                let slots = [0, 1, 2].map(|i| component(body, i));
                return Ok(body.weighted(slots, weights));
            }
            TokenKind::Name(name) if &**self.names.words.word(name) == "hf" => {
                // Undocumented height field value: 0.996093 (red + green / 255).
                let (red, green) = (component(body, 0), component(body, 1));
                return Ok(body.weighted([red, green, green], [0.996093, 0.996093 / 255.0, 0.0]));
            }
            _ => None,
        };
        match member {
            Some(i) => Ok(component(body, i)),
            None => self.error(token.span, "expected x, y, z, t, red, green, blue, filter, transmit or gray"),
        }
    }
}

impl Body {
    fn find(&self, name: &str) -> Option<u32> {
        self.names.iter().rev().find(|(n, _)| &**n == name).map(|(_, index)| *index)
    }

    fn weighted(&mut self, slots: [Slot; 3], weights: [f64; 3]) -> Slot {
        let b = &mut self.builder;
        let mut total = None;
        for (slot, weight) in slots.into_iter().zip(weights).filter(|(_, w)| *w != 0.0) {
            let weight = b.constant(weight);
            let term = b.binary(Binary::Mul, slot, weight);
            total = Some(match total {
                None => term,
                Some(sum) => b.binary(Binary::Add, sum, term),
            });
        }
        total.unwrap_or_else(|| b.constant(0.0))
    }
}
