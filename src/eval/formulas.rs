//! Walking expressions that were parsed into trees.
//!
//! Gives the same value, in the same order of evaluation, as reading the tokens does; see
//! [`crate::syntax::formula`] for when it may be used.

use super::expressions::{EPSILON, truth};
use super::float_functions::{largest, one_argument, selected, smallest, two_arguments, within_bounds};
use super::vector_functions::rotated_about;
use super::{Evaluator, Number, Place, Value};
use crate::diag::{SourceResult, Span};
use crate::math::{DVec3, Transform};
use crate::syntax::formula::{Demand, Formula, List, Node, NodeId, Operator};
use crate::syntax::{Keyword, Symbol, TokenKind};
use smallvec::SmallVec;
use std::rc::Rc;

/// Whether, and how, a formula can be walked.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reading {
    Float,
    Number,
    Tokens,
}

impl Evaluator<'_> {
    /// The value of the expression that comes next, if it is known as a tree; it is taken.
    #[inline]
    pub(super) fn formula(&mut self, full: bool, n: u8) -> SourceResult<Option<Number>> {
        if self.version < 150 {
            return Ok(None);
        }
        self.known_formula(full, n, true)
    }

    /// The same for an argument: a name alone is not taken, since it goes by reference.
    pub(super) fn formula_argument(&mut self) -> SourceResult<Option<Number>> {
        if self.version < 150 {
            return Ok(None);
        }
        self.known_formula(false, 1, false)
    }

    fn known_formula(&mut self, full: bool, n: u8, names: bool) -> SourceResult<Option<Number>> {
        let Some(cursor) = self.cursors.last() else { return Ok(None) };
        let held = usize::from(self.ahead.is_some());
        let Some((formula, start)) = cursor.formula(self.ahead.as_ref(), full, &self.scopes) else { return Ok(None) };
        if formula.open_ended && !self.bare
            || !names && matches!(formula.nodes.last(), Some(Node::Name(_) | Node::Element(..)))
        {
            return Ok(None);
        }
        let Some(value) = self.value_of(&formula, start, n)? else { return Ok(None) };
        self.skip_tokens(formula.length - held);
        self.take();
        Ok(Some(value))
    }

    /// What a formula gives in a place of width `n`; its first token is number `start` of the piece.
    pub(super) fn value_of(&mut self, formula: &Rc<Formula>, start: usize, n: u8) -> SourceResult<Option<Number>> {
        let reading = self.reading(formula);
        let walk = Walk { formula, start };
        let root = (formula.nodes.len() - 1) as NodeId;
        let value = match reading {
            Reading::Float => Number::scalar(self.walk_float(&walk, root)?),
            Reading::Number => self.walk(&walk, root, n)?,
            Reading::Tokens => return Ok(None),
        };
        Ok(Some(value.widened(n)))
    }

    fn skip_tokens(&mut self, n: usize) {
        if let Some(cursor) = self.cursors.last_mut() {
            cursor.skip_tokens(n);
        }
    }

    /// `( formula )` where a condition is expected; `None`, and nothing taken, for anything else.
    pub(super) fn condition_formula(&mut self) -> SourceResult<Option<f64>> {
        let Some(cursor) = self.cursors.last() else { return Ok(None) };
        if self.ahead.is_some() || self.version < 150 || cursor.upcoming(0) != Some(TokenKind::Punct('(')) {
            return Ok(None);
        }
        let Some((formula, start)) = cursor.formula_behind(1, true, &self.scopes) else { return Ok(None) };
        if cursor.upcoming(1 + formula.length) != Some(TokenKind::Punct(')')) {
            return Ok(None);
        }
        match self.reading(&formula) {
            Reading::Float => {}
            _ => return Ok(None),
        }
        let value = self.walk_float(&Walk { formula: &formula, start }, (formula.nodes.len() - 1) as NodeId)?;
        self.skip_tokens(formula.length + 2);
        Ok(Some(value))
    }

    /// `NAME = formula ;` behind `#declare` or `#local`, for a variable that holds a number or is
    /// new in a macro; false, and nothing taken, for anything else.
    pub(super) fn declaration_formula(&mut self, local: bool) -> SourceResult<bool> {
        let Some(cursor) = self.cursors.last() else { return Ok(false) };
        let (Some(TokenKind::Name(name)), Some(TokenKind::Punct('='))) = (cursor.upcoming(0), cursor.upcoming(1))
        else {
            return Ok(false);
        };
        if self.ahead.is_some() || self.version < 350 {
            return Ok(false);
        }
        let Some((formula, start)) = cursor.formula_behind(2, false, &self.scopes) else { return Ok(false) };
        let end = 2 + formula.length;
        let alone = cursor.upcoming(end) == Some(TokenKind::Punct(';'))
            && cursor.upcoming(end + 1).is_some_and(|next| next != TokenKind::Punct(';'));
        let place = if local { self.scopes.find_innermost(name) } else { self.scopes.find(name) };
        let place = match place {
            _ if !alone => return Ok(false),
            Some(place) if place.path.is_empty() && place.with(|v| v.and_then(Value::number).is_some()) => {
                Some(Rc::clone(&place.slot))
            }
            None if local => None,
            _ => return Ok(false),
        };
        let Some(number) = self.value_of(&formula, start, 1)? else { return Ok(false) };
        self.skip_tokens(end + 1);
        match place {
            Some(slot) => *slot.borrow_mut() = Value::from(number),
            None => self.scopes.bind(self.local_table(), name, Place::new(Value::from(number))),
        }
        Ok(true)
    }

    /// Whether all names stand for what the tree takes them for.
    fn reading(&self, formula: &Formula) -> Reading {
        let mut reading = if formula.scalar { Reading::Float } else { Reading::Number };
        if !self.scopes.deprecated.is_empty() {
            return Reading::Tokens;
        }
        for (name, demand) in &formula.demands {
            let Some(place) = self.scopes.find(*name) else { return Reading::Tokens };
            let fits = place.with(|value| match (value, demand) {
                (Some(Value::Float(_)), Demand::Float | Demand::Number | Demand::Operand) => true,
                (Some(Value::Vector(_)), Demand::Operand) => true,
                (Some(Value::Float(_)), Demand::Component(index)) => *index == 0,
                (Some(Value::Vector(_)), Demand::Number) => {
                    reading = Reading::Number;
                    true
                }
                (Some(Value::Vector(v)), Demand::Component(index)) => *index < v.n,
                (Some(Value::Array(array)), Demand::FloatArray(n)) => {
                    array.dimensions.len() == usize::from(*n) && matches!(array.sample(), Some(Value::Float(_)))
                }
                (Some(Value::Function(f)), Demand::Function(n)) => f.n_parameters == usize::from(*n) && f.width() == 1,
                (value, Demand::Reference) => Self::is_reference(value),
                _ => false,
            });
            if !fits {
                return Reading::Tokens;
            }
        }
        if formula.calls.iter().all(|call| self.gives_operand(call)) { reading } else { Reading::Tokens }
    }

    /// A node whose operands are all floats.
    fn walk_float(&mut self, walk: &Walk<'_>, id: NodeId) -> SourceResult<f64> {
        match walk.formula.nodes[id as usize] {
            Node::Constant(value) => Ok(value),
            Node::Name(name) => Ok(self.component_of_name(name, 0)),
            Node::Component(name, index) => Ok(self.component_of_name(name, index)),
            Node::Group(inner) => self.walk_float(walk, inner),
            Node::Negate(inner) => Ok(-self.walk_float(walk, inner)?),
            Node::Not(inner) => Ok(f64::from(self.walk_float(walk, inner)?.abs() <= EPSILON)),
            Node::Binary(operator, left, right, token) => {
                let (a, b) = (self.walk_float(walk, left)?, self.walk_float(walk, right)?);
                if operator == Operator::Divide && b == 0.0 {
                    self.warn_division(self.token_span(walk, token));
                }
                Ok(operator.apply(a, b))
            }
            Node::Choice(condition, yes, no) => {
                let condition = self.walk_float(walk, condition)?;
                let (yes, no) = (self.walk_float(walk, yes)?, self.walk_float(walk, no)?);
                Ok(if truth(condition) { yes } else { no })
            }
            Node::Element(name, indices, token) => self.walk_element(walk, name, indices, token),
            Node::Call(word, arguments, token) => self.walk_call(walk, word, arguments, token),
            Node::CallName(name, arguments) => {
                let arguments = self.walk_list(walk, arguments)?;
                let function = self.scopes.find(name).and_then(|place| {
                    place.with(|value| match value {
                        Some(Value::Function(f)) => Some(f.clone()),
                        _ => None,
                    })
                });
                Ok(function.map_or(f64::NAN, |f| f.call(&arguments)[0]))
            }
            Node::ComponentOf(inner, index, token) => {
                let value = self.walk(walk, inner, 1)?;
                if index < value.n {
                    return Ok(value.v[usize::from(index)]);
                }
                let (span, n) = (self.token_span(walk, token), value.n);
                self.error(span, format!("there is no component of that name in a value of width {n}"))
            }
            Node::VectorCall(Keyword::Vlength, list, token) => {
                Ok(self.walk_vector(walk, walk.item(list, 0), token)?.length())
            }
            Node::VectorCall(Keyword::Vdot, list, token) => {
                let a = self.walk_vector(walk, walk.item(list, 0), token)?;
                Ok(a.dot(self.walk_vector(walk, walk.item(list, 1), token)?))
            }
            Node::Macro(call) => {
                let call = &walk.formula.calls[usize::from(call)];
                let value = self.walk_macro(walk, call, 1)?;
                let span = self.token_span(walk, call.token);
                self.want_float(value, span)
            }
            Node::Axes(..) | Node::Vector(_) | Node::VectorCall(..) => Ok(self.walk(walk, id, 1)?.v[0]),
        }
    }

    /// Any node, in a place of width `n`.
    pub(super) fn walk(&mut self, walk: &Walk<'_>, id: NodeId, n: u8) -> SourceResult<Number> {
        let value = match walk.formula.nodes[id as usize] {
            Node::Constant(value) => Number::scalar(value),
            Node::Axes(v, n) => Number { n, v: [v[0], v[1], v[2], 0.0, 0.0] },
            Node::Vector(list) => {
                let mut value = Number { n: list.n, v: [0.0; 5] };
                for i in 0..usize::from(list.n) {
                    value.v[i] = self.walk_float(walk, walk.item(list, i))?;
                }
                value
            }
            Node::Name(name) => {
                let found = self.scopes.find(name).and_then(|place| place.with(|v| v.and_then(Value::number)));
                found.unwrap_or(Number::scalar(f64::NAN))
            }
            Node::Group(inner) => self.walk(walk, inner, 1)?,
            Node::Negate(inner) => self.walk(walk, inner, n)?.map(|c| -c),
            Node::Not(inner) => self.walk(walk, inner, n)?.map(|c| f64::from(c.abs() <= EPSILON)),
            Node::Binary(operator, left, right, token) => {
                let left = self.walk(walk, left, n)?;
                let right = self.walk(walk, right, n.max(left.n))?;
                if operator == Operator::Divide {
                    let width = left.n.max(right.n);
                    if right.widened(width).v[..usize::from(width)].contains(&0.0) {
                        self.warn_division(self.token_span(walk, token));
                    }
                }
                left.zip(right, |a, b| operator.apply(a, b))
            }
            Node::Choice(condition, yes, no) => {
                let condition = self.walk(walk, condition, 1)?.v[0];
                let (yes, no) = (self.walk(walk, yes, n)?, self.walk(walk, no, n)?);
                if truth(condition) { yes } else { no }
            }
            Node::VectorCall(word, list, token) if !matches!(word, Keyword::Vlength | Keyword::Vdot) => {
                Number::vector(self.walk_vector_call(walk, word, list, token)?)
            }
            Node::Macro(call) => self.walk_macro(walk, &walk.formula.calls[usize::from(call)], n)?,
            _ => Number::scalar(self.walk_float(walk, id)?),
        };
        Ok(value.widened(n))
    }

    /// An argument of a vector function.
    fn walk_vector(&mut self, walk: &Walk<'_>, id: NodeId, token: u16) -> SourceResult<DVec3> {
        let value = self.walk(walk, id, 3)?;
        if value.n > 3 {
            let (span, found) = (self.token_span(walk, token), value.n);
            return self.error(span, format!("expected a vector of 3 components, found one of {found}"));
        }
        Ok(value.xyz())
    }

    fn walk_vector_call(&mut self, walk: &Walk<'_>, word: Keyword, list: List, token: u16) -> SourceResult<DVec3> {
        let a = self.walk_vector(walk, walk.item(list, 0), token)?;
        if word == Keyword::Vnormalize {
            let span = self.token_span(walk, token);
            return Ok(self.normalized(a, span));
        }
        let b = self.walk_vector(walk, walk.item(list, 1), token)?;
        Ok(match word {
            Keyword::Vcross => a.cross(b),
            Keyword::Vrotate => Transform::rotation_deg(b).vector(a),
            _ => rotated_about(a, b, self.walk_float(walk, walk.item(list, 2))?),
        })
    }

    fn component_of_name(&self, name: Symbol, index: u8) -> f64 {
        let Some(place) = self.scopes.find(name) else { return f64::NAN };
        place.with(|value| match value {
            Some(Value::Float(f)) => *f,
            Some(Value::Vector(v)) => v.v[usize::from(index)],
            _ => f64::NAN,
        })
    }

    fn walk_list(&mut self, walk: &Walk<'_>, list: List) -> SourceResult<SmallVec<[f64; 8]>> {
        (0..usize::from(list.n)).map(|i| self.walk_float(walk, walk.item(list, i))).collect()
    }

    fn walk_element(&mut self, walk: &Walk<'_>, name: Symbol, indices: List, token: u16) -> SourceResult<f64> {
        let (place, flat) = self.walk_index(walk, name, indices, token)?;
        let found = place.with(|value| match value {
            Some(Value::Array(array)) => array.elements.get(flat).and_then(Option::as_ref).and_then(Value::number),
            _ => None,
        });
        match found {
            Some(number) => Ok(number.v[0]),
            None => self.error(self.token_span(walk, token), "this array element was never set"),
        }
    }

    /// An array and the flat index of an element of it.
    pub(super) fn walk_index(
        &mut self,
        walk: &Walk<'_>,
        name: Symbol,
        indices: List,
        token: u16,
    ) -> SourceResult<(Place, usize)> {
        let indices = self.walk_list(walk, indices)?;
        let span = self.token_span(walk, token);
        let Some(place) = self.scopes.find(name).cloned() else { return self.undeclared(name, span) };
        let flat: Result<usize, String> = place.with(|value| {
            let Some(Value::Array(array)) = value else { return Ok(0) };
            let mut flat = 0;
            for (index, size) in indices.iter().zip(&array.dimensions) {
                flat = flat * size + super::arrays::whole_index(*index, *size)?;
            }
            Ok(flat)
        });
        match flat {
            Ok(flat) => Ok((place, flat)),
            Err(message) => self.error(span, message),
        }
    }

    fn walk_call(&mut self, walk: &Walk<'_>, word: Keyword, list: List, token: u16) -> SourceResult<f64> {
        let first = self.walk_float(walk, walk.item(list, 0))?;
        if let Some(function) = one_argument(word) {
            return Ok(function(first));
        }
        if word == Keyword::Rand {
            return match self.random.next(first) {
                Some(value) => Ok(value),
                None => self.no_stream(self.token_span(walk, token)),
            };
        }
        let value = match word {
            Keyword::Max | Keyword::Min | Keyword::Select => {
                let mut values: SmallVec<[f64; 8]> = SmallVec::from_slice(&[first]);
                for i in 1..usize::from(list.n) {
                    values.push(self.walk_float(walk, walk.item(list, i))?);
                }
                Ok(match word {
                    Keyword::Max => largest(&values),
                    Keyword::Min => smallest(&values),
                    _ => selected(&values),
                })
            }
            _ if list.n == 2 => two_arguments(word, first, self.walk_float(walk, walk.item(list, 1))?),
            _ => within_bounds(word, first),
        };
        match value {
            Ok(value) => Ok(value),
            complaint => self.settle(complaint, self.token_span(walk, token)),
        }
    }

    /// Where a token of the formula stands.
    pub(super) fn token_span(&self, walk: &Walk<'_>, token: u16) -> Span {
        self.cursors.last().map_or(self.last_span, |c| c.span_of(walk.start + usize::from(token)))
    }
}

/// A formula and the index of its first token in the current piece.
pub(super) struct Walk<'f> {
    pub(super) formula: &'f Formula,
    pub(super) start: usize,
}

impl Walk<'_> {
    pub(super) fn item(&self, list: List, i: usize) -> NodeId {
        self.formula.lists[usize::from(list.start) + i]
    }
}

impl Operator {
    /// The result for two floats, with the language's tolerance (language facts, section 5).
    #[inline]
    pub(super) fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            // Plus infinity whatever the numerator, as in POV-Ray.
            Self::Divide if b == 0.0 => f64::INFINITY,
            Self::Divide => a / b,
            Self::Less => f64::from(a < b),
            Self::AtMost => f64::from(a <= b + EPSILON),
            // So NaN and equal infinities count as equal.
            Self::Equal => 1.0 - Self::Differs.apply(a, b),
            Self::Differs => f64::from((a - b).abs() > EPSILON),
            Self::AtLeast => f64::from(a + EPSILON >= b),
            Self::Greater => f64::from(a > b),
            Self::And => f64::from(truth(a) && truth(b)),
            Self::Or => f64::from(truth(a) || truth(b)),
        }
    }
}
