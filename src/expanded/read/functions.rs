//! Functions: expressions become the programs that they were written from.

use super::reader::{Reader, Value, misplaced};
use super::tree::{Items, Node, Read, Rule, number, numbers, place, wrong};
use crate::diag::Diagnostic;
use crate::function::{Binary, FunctionBody, Internal, ProgramBuilder, Slot, Spline, SplineKind, Unary};
use crate::math::Transform;
use crate::math::noise::NoiseGenerator;
use crate::scene::{Function, PointFunction, PointSource};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::sync::Arc;

/// As POV-Ray has it.
const MAX_PARAMETERS: usize = 56;

/// An expression on its way to a program.
struct Body<'t> {
    builder: ProgramBuilder<PointFunction>,
    /// Variables, innermost last.
    names: Vec<(&'t str, u32)>,
    /// The function's parameters and the indices of sums and products around this.
    n_arguments: u32,
    /// What calls gave, so that each is made once: an expression repeats what a program keeps.
    calls: FxHashMap<(usize, SmallVec<[Slot; 4]>, u8), Slot>,
}

impl<'t> Body<'t> {
    fn new(names: Vec<(&'t str, u32)>, n_arguments: u32) -> Self {
        Self { builder: ProgramBuilder::default(), names, n_arguments, calls: FxHashMap::default() }
    }
}

impl<'a> Reader<'a> {
    /// `function(parameters) { … }` of a declaration.
    pub(super) fn declared_function(&mut self, node: Node<'a>) -> Read<Arc<Function>> {
        let mut items = Items::of(node);
        let names: Vec<&str> = match items.optional(Rule::parameters) {
            Some(parameters) => {
                let names: Vec<&str> = parameters.clone().into_inner().map(|name| name.as_str()).collect();
                if names.len() > MAX_PARAMETERS {
                    return wrong(&parameters, format!("a function takes 1 to {MAX_PARAMETERS} parameters"));
                }
                names
            }
            None => vec!["x", "y", "z"],
        };
        self.function_body(items.node()?, &names)
    }

    /// `function { … }` of these arguments.
    pub(super) fn plain_function(&mut self, node: Node<'a>, names: &[&'a str]) -> Read<Arc<Function>> {
        let mut items = Items::of(node);
        if let Some(parameters) = items.optional(Rule::parameters) {
            return wrong(&parameters, "a function that is not declared takes no parameter list");
        }
        self.function_body(items.node()?, names)
    }

    /// The inside of a function; one that only calls another expression with all its arguments is that one.
    pub(super) fn function_body(&mut self, node: Node<'a>, names: &[&'a str]) -> Read<Arc<Function>> {
        let inner = Items::of(node).node()?;
        if inner.as_rule() != Rule::expression {
            return Ok(Arc::new(self.special_body(inner)?));
        }
        if let Some(known) = self.called_alone(&inner, names) {
            return Ok(known);
        }
        let numbered = names.iter().zip(0..).map(|(name, i)| (*name, i)).collect();
        let mut body = Body::new(numbered, names.len() as u32);
        let result = self.expression(inner, &mut body)?;
        let program = FunctionBody::Program(body.builder.finish(result));
        Ok(Arc::new(Function { n_parameters: names.len(), body: program }))
    }

    /// The declared function of `F(x, y, z)`.
    fn called_alone(&self, expression: &Node<'a>, names: &[&str]) -> Option<Arc<Function>> {
        let mut terms = expression.clone().into_inner();
        let (call, None) = (terms.next()?, terms.next()) else { return None };
        let mut parts = call.clone().into_inner();
        let callee = parts.next().filter(|_| call.as_rule() == Rule::call)?;
        if !parts.map(|part| part.as_str()).eq(names.iter().copied()) {
            return None;
        }
        let pick = |v: &Value| if let Value::Function(f) = v { Some(Arc::clone(f)) } else { None };
        let function = self.known(&callee, "function", pick).ok()?;
        let is_program = matches!(function.body, FunctionBody::Program(_));
        (is_program && function.n_parameters == names.len()).then_some(function)
    }

    fn special_body(&mut self, node: Node<'a>) -> Read<Function> {
        let mut items = Items::of(node.clone());
        let (n_parameters, body) = match node.as_rule() {
            Rule::internal => {
                let value = items.number()?;
                let internal = (value >= 0.0).then(|| Internal::new(value as u32, self.noise_generator())).flatten();
                let Some(internal) = internal else {
                    return wrong(&node, format!("there is no internal function {value}"));
                };
                (3 + internal.n_extra(), FunctionBody::Internal(internal))
            }
            Rule::pigment => {
                let pigment = Arc::unwrap_or_clone(self.pigment(node.clone())?);
                (3, self.point_function(PointSource::Pigment(pigment), &node)?)
            }
            Rule::pattern_function => {
                let (mut pattern, list) = self.pattern(items.node()?)?;
                if let Some(list) = list {
                    return wrong(&list, "a pattern that is called has values, not things to choose from");
                }
                for item in items {
                    self.pattern_modifier(item, &mut pattern)?;
                }
                (3, self.point_function(PointSource::Pattern(pattern), &node)?)
            }
            Rule::transform_function => {
                let mut all = Transform::IDENTITY;
                for item in items {
                    all = all.then(&self.transform(item)?);
                }
                (3, FunctionBody::Transform(all))
            }
            Rule::spline => (1, FunctionBody::Spline(self.spline(node)?)),
            _ => return misplaced(&node),
        };
        Ok(Function { n_parameters, body })
    }

    fn point_function(&mut self, source: PointSource, node: &Node<'a>) -> Read<FunctionBody<PointFunction>> {
        let settings = self.settings_here();
        let function = Arc::new(PointFunction { source, settings });
        match self.queries.check(&function) {
            Ok(()) => Ok(FunctionBody::External(function)),
            Err(refused) => Err(Box::new(Diagnostic { span: refused.span.or(Some(place(node))), ..refused })),
        }
    }

    fn noise_generator(&self) -> NoiseGenerator {
        match self.scene.settings.noise_generator {
            Some(1) => NoiseGenerator::Original,
            Some(3) => NoiseGenerator::Perlin,
            _ => NoiseGenerator::Corrected,
        }
    }

    /// `spline { … }`.
    pub(super) fn spline(&mut self, node: Node<'a>) -> Read<Arc<Spline>> {
        let mut items = Items::of(node);
        if let Some(name) = items.optional(Rule::identifier) {
            return self.known(&name, "spline", |v| if let Value::Spline(s) = v { Some(Arc::clone(s)) } else { None });
        }
        let mut spline = Spline::new(match items.word()? {
            "quadratic_spline" => SplineKind::Quadratic,
            "cubic_spline" => SplineKind::Cubic,
            "natural_spline" => SplineKind::Natural,
            _ => SplineKind::Linear,
        });
        for knot in items {
            let mut inner = Items::of(knot);
            let at = inner.number()?;
            let value = inner.node()?;
            let given = if value.as_rule() == Rule::vector { numbers(&value)? } else { vec![number(&value)?] };
            if given.len() > 5 {
                return wrong(&value, "the values of a spline have at most 5 components");
            }
            let mut components = [0.0; 5];
            components[..given.len()].copy_from_slice(&given);
            spline.insert(at, components, given.len());
        }
        Ok(Arc::new(spline))
    }

    fn expression(&mut self, node: Node<'a>, body: &mut Body<'a>) -> Read<Slot> {
        roomy(|| self.climb(&mut Items::of(node), 0, body))
    }

    /// Operands with operators between them that bind at least as much as `least`, from left to right.
    fn climb(&mut self, items: &mut Items<'a>, least: u8, body: &mut Body<'a>) -> Read<Slot> {
        let first = items.node()?;
        let mut left = self.operand(first, body)?;
        while let Some((f, binding)) = items.peek().and_then(operator).filter(|(_, binding)| *binding >= least) {
            items.node()?;
            let right = self.climb(items, binding + 1, body)?;
            left = body.builder.as_written(f, left, right);
        }
        Ok(left)
    }

    fn operand(&mut self, node: Node<'a>, body: &mut Body<'a>) -> Read<Slot> {
        match node.as_rule() {
            Rule::literal => Ok(body.builder.constant(number(&node)?)),
            Rule::negative => {
                let inner = Items::of(node).node()?;
                let operand = self.operand(inner, body)?;
                Ok(body.builder.unary(Unary::Neg, operand))
            }
            Rule::parentheses => {
                let inner = Items::of(node).node()?;
                self.expression(inner, body)
            }
            Rule::variable => {
                let name = node.as_str();
                match body.names.iter().rev().find(|(known, _)| *known == name) {
                    Some((_, index)) => Ok(body.builder.argument(*index)),
                    None => wrong(&node, format!("this function has no parameter '{name}'")),
                }
            }
            Rule::call => self.call(node, body),
            Rule::fold => self.fold(node, body),
            _ => misplaced(&node),
        }
    }

    fn call(&mut self, node: Node<'a>, body: &mut Body<'a>) -> Read<Slot> {
        let mut items = Items::of(node.clone());
        let callee = items.node()?;
        let mut arguments: SmallVec<[Slot; 4]> = SmallVec::new();
        while let Some(argument) = items.optional(Rule::expression) {
            arguments.push(self.expression(argument, body)?);
        }
        let member = items.optional(Rule::member);
        let word = callee.as_str();
        let slot = match (&arguments[..], unary(word), binary(word), word) {
            ([a], Some(f), ..) => body.builder.unary(f, *a),
            ([a, b], _, Some(f), _) => body.builder.as_written(f, *a, *b),
            ([c, negative, other], .., "select") => body.builder.select([*c, *negative, *other, *other]),
            ([c, negative, zero, positive], .., "select") => body.builder.select([*c, *negative, *zero, *positive]),
            (_, Some(_), ..) | (_, _, Some(_), _) | (.., "select") => {
                return wrong(&node, format!("'{word}' takes another number of arguments"));
            }
            _ => return self.declared_call(&callee, arguments, member.as_ref(), body),
        };
        match member {
            Some(member) => wrong(&member, "one number has no members"),
            None => Ok(slot),
        }
    }

    fn declared_call(
        &mut self,
        callee: &Node<'a>,
        arguments: SmallVec<[Slot; 4]>,
        member: Option<&Node<'a>>,
        body: &mut Body<'a>,
    ) -> Read<Slot> {
        let pick = |v: &Value| if let Value::Function(f) = v { Some(Arc::clone(f)) } else { None };
        let function = self.known(callee, "function", pick)?;
        let (given, needed) = (arguments.len(), function.n_parameters);
        if given != needed {
            return wrong(callee, format!("this function takes {needed} arguments, not {given}"));
        }
        let component = match (member.map(|member| member.as_str()), function.width()) {
            (None, 1) => 0,
            (Some(".x" | ".u" | ".red"), 2..) => 0,
            (Some(".y" | ".v" | ".green"), 2..) => 1,
            (Some(".z" | ".blue"), 2..) => 2,
            (Some(".t" | ".filter"), 2..) => 3,
            (Some(".transmit"), 2..) => 4,
            (None, _) => return wrong(callee, "this function gives several numbers: say which, as in '.x' or '.red'"),
            (Some(_), _) => return wrong(member.unwrap_or(callee), "this function has no such member"),
        };
        let key = (Arc::as_ptr(&function) as usize, arguments.clone(), component);
        if let Some(known) = body.calls.get(&key) {
            return Ok(*known);
        }
        let slot = body.builder.call(&function, arguments, component);
        body.calls.insert(key, slot);
        Ok(slot)
    }

    /// `sum(i, from, to, E)`: E is a program of its own that also takes all outer arguments.
    fn fold(&mut self, node: Node<'a>, body: &mut Body<'a>) -> Read<Slot> {
        let mut items = Items::of(node);
        let product = items.word()? == "prod";
        let name = items.word()?;
        let from = items.node()?;
        let from = self.expression(from, body)?;
        let to = items.node()?;
        let to = self.expression(to, body)?;
        let index = body.n_arguments;
        let mut names = body.names.clone();
        names.push((name, index));
        let mut inner = Body::new(names, index + 1);
        let result = items.node()?;
        let result = self.expression(result, &mut inner)?;
        let arguments = (0..index).map(|i| body.builder.argument(i)).collect();
        Ok(body.builder.fold(product, from, to, inner.builder.finish(result), arguments))
    }
}

/// What an operator does, and how strongly it binds.
fn operator(rule: Rule) -> Option<(Binary, u8)> {
    Some(match rule {
        Rule::or => (Binary::Or, 0),
        Rule::and => (Binary::And, 1),
        Rule::below => (Binary::Less, 2),
        Rule::at_most => (Binary::LessEqual, 2),
        Rule::above => (Binary::Greater, 2),
        Rule::at_least => (Binary::GreaterEqual, 2),
        Rule::equal => (Binary::Equal, 2),
        Rule::unlike => (Binary::NotEqual, 2),
        Rule::plus => (Binary::Add, 3),
        Rule::minus => (Binary::Sub, 3),
        Rule::times => (Binary::Mul, 4),
        Rule::over => (Binary::Div, 4),
        _ => return None,
    })
}

fn unary(word: &str) -> Option<Unary> {
    Some(match word {
        "sin" => Unary::Sin,
        "cos" => Unary::Cos,
        "tan" => Unary::Tan,
        "asin" => Unary::Asin,
        "acos" => Unary::Acos,
        "atan" => Unary::Atan,
        "sinh" => Unary::Sinh,
        "cosh" => Unary::Cosh,
        "tanh" => Unary::Tanh,
        "asinh" => Unary::Asinh,
        "acosh" => Unary::Acosh,
        "atanh" => Unary::Atanh,
        "abs" => Unary::Abs,
        "radians" => Unary::Radians,
        "degrees" => Unary::Degrees,
        "int" => Unary::Int,
        "floor" => Unary::Floor,
        "ceil" => Unary::Ceil,
        "sqrt" => Unary::Sqrt,
        "exp" => Unary::Exp,
        "ln" => Unary::Ln,
        "log" => Unary::Log,
        _ => return None,
    })
}

fn binary(word: &str) -> Option<Binary> {
    Some(match word {
        "pow" => Binary::Pow,
        "atan2" => Binary::Atan2,
        "mod" => Binary::Mod,
        "div" => Binary::IntDiv,
        "min" => Binary::Min,
        "max" => Binary::Max,
        _ => return None,
    })
}
