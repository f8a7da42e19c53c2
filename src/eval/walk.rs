//! Walking expressions that were parsed into trees.

use super::expressions::{EPSILON, truth};
use super::float_functions::{largest, one_argument, selected, smallest, two_arguments, within_bounds};
use super::names::Names;
use super::vector_functions::rotated_about;
use super::{Evaluator, Number, Place, Value};
use crate::diag::{SourceResult, Span};
use crate::math::{DVec3, Transform};
use crate::syntax::Keyword;
use crate::syntax::expression::Operator;
use crate::syntax::formula::{Demand, Formula, List, MAX_STACK, Node, NodeId, OperandId};
use smallvec::SmallVec;

/// A formula on its way to a value.
pub(super) struct Walk<'f> {
    pub(super) formula: &'f Formula,
    /// The index of its first token in the current piece.
    pub(super) start: usize,
    /// The values of the operands, which are all floats; or none, and each is looked up when it is met.
    pub(super) floats: &'f [f64],
}

impl Walk<'_> {
    /// The value of a constant or of an operand that is known.
    #[inline]
    fn leaf(&self, id: NodeId) -> Option<f64> {
        match self.formula.nodes[usize::from(id)] {
            Node::Constant(value) => Some(value),
            Node::Name(operand) | Node::Component(operand) => self.floats.get(usize::from(operand)).copied(),
            _ => None,
        }
    }

    /// The value of a name that stands for a number.
    #[inline]
    fn number(&self, operand: OperandId, names: &Names) -> Number {
        names.number(self.formula.name(operand)).unwrap_or(Number::scalar(f64::NAN))
    }

    /// What is asked of such a name, where that is a float; rare enough to stand beside the loop over nodes.
    #[inline(never)]
    fn float(&self, operand: OperandId, names: &Names) -> f64 {
        let index = match self.formula.operands[usize::from(operand)].demand {
            Demand::Component(index) => index,
            _ => 0,
        };
        self.number(operand, names).v[usize::from(index)]
    }

    pub(super) fn item(&self, list: List, i: usize) -> NodeId {
        self.formula.lists[usize::from(list.start) + i]
    }
}

impl Evaluator<'_> {
    /// A node whose operands are floats.
    #[inline]
    pub(super) fn walk_float(&mut self, walk: &Walk<'_>, root: NodeId) -> SourceResult<f64> {
        // Half of all expressions are this short.
        if let Some(leaf) = walk.leaf(root) {
            return Ok(leaf);
        }
        if let Node::Binary(operator, left, right, _) = walk.formula.nodes[usize::from(root)]
            && operator != Operator::Divide
            && let (Some(left), Some(right)) = (walk.leaf(left), walk.leaf(right))
        {
            return Ok(operator.apply(left, right));
        }
        self.run_floats(walk, root)
    }

    /// The same by running the nodes that belong to it in order.
    fn run_floats(&mut self, walk: &Walk<'_>, root: NodeId) -> SourceResult<f64> {
        let nodes = &walk.formula.nodes[..=usize::from(root)];
        let mut at = usize::from(walk.formula.first[usize::from(root)]);
        // The last value, and those that wait below it; the parser sees to it that they have room.
        let (mut top, mut waiting, mut n) = (0.0_f64, [0.0; MAX_STACK], 0_usize);
        while let Some(node) = nodes.get(at) {
            let id = at as NodeId;
            at += 1;
            let value = match *node {
                Node::Constant(value) => value,
                Node::Name(operand) | Node::Component(operand) => match walk.floats.get(usize::from(operand)) {
                    Some(float) => *float,
                    None => walk.float(operand, &self.names),
                },
                Node::Skip(to) => {
                    at = usize::from(to);
                    continue;
                }
                Node::ComponentOf(..) | Node::VectorCall(..) | Node::Macro(_) | Node::Axes(..) | Node::Vector(_) => {
                    self.float_of_vectors(walk, id)?
                }
                Node::Group(_) => continue,
                Node::Negate(_) => {
                    top = -top;
                    continue;
                }
                Node::Not(_) => {
                    top = f64::from(top.abs() <= EPSILON);
                    continue;
                }
                Node::Binary(operator, _, _, token) => {
                    if operator == Operator::Divide && top == 0.0 {
                        self.warn_division(self.token_span(walk, token));
                    }
                    n = n.wrapping_sub(1);
                    top = operator.apply(waiting[n % MAX_STACK], top);
                    continue;
                }
                Node::Choice(..) => {
                    n = n.wrapping_sub(2);
                    let (condition, yes) = (waiting[n % MAX_STACK], waiting[(n + 1) % MAX_STACK]);
                    top = if truth(condition) { yes } else { top };
                    continue;
                }
                Node::Call(_, list, _) | Node::CallName(_, list) | Node::Element(_, list, _) => {
                    waiting[n % MAX_STACK] = top;
                    let first = (n + 1).saturating_sub(usize::from(list.n));
                    top = self.float_call(walk, node, &waiting[first..=n])?;
                    n = first;
                    continue;
                }
            };
            waiting[n % MAX_STACK] = top;
            n += 1;
            top = value;
        }
        Ok(top)
    }

    /// A function or array of floats.
    fn float_call(&mut self, walk: &Walk<'_>, node: &Node, arguments: &[f64]) -> SourceResult<f64> {
        match *node {
            Node::Call(word, _, token) => self.built_in_call(walk, word, arguments, token),
            Node::CallName(name, _) => {
                Ok(self.names.function(name).map_or(f64::NAN, |f| f.call_by(arguments, self.queries)[0]))
            }
            Node::Element(array, _, token) => Ok(self.element_number(walk, array, arguments, token)?.v[0]),
            _ => Ok(f64::NAN),
        }
    }

    /// A node whose operands may be vectors.
    fn float_of_vectors(&mut self, walk: &Walk<'_>, id: NodeId) -> SourceResult<f64> {
        match walk.formula.nodes[usize::from(id)] {
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
                self.want_float(value, self.token_span(walk, call.token))
            }
            _ => Ok(self.walk(walk, id, 1)?.v[0]),
        }
    }

    fn built_in_call(&mut self, walk: &Walk<'_>, word: Keyword, arguments: &[f64], token: u16) -> SourceResult<f64> {
        let value = match (word, arguments) {
            (Keyword::Max, _) => Ok(largest(arguments)),
            (Keyword::Min, _) => Ok(smallest(arguments)),
            (Keyword::Select, _) => Ok(selected(arguments)),
            (Keyword::Rand, [stream, ..]) => match self.random.next(*stream) {
                Some(value) => Ok(value),
                None => return self.no_stream(self.token_span(walk, token)),
            },
            (_, [a]) => match one_argument(word) {
                Some(function) => Ok(function(*a)),
                None => within_bounds(word, *a),
            },
            (_, [a, b, ..]) => two_arguments(word, *a, *b),
            (_, []) => Ok(f64::NAN),
        };
        match value {
            Ok(value) => Ok(value),
            complaint => self.settle(complaint, self.token_span(walk, token)),
        }
    }

    fn element_number(&self, walk: &Walk<'_>, array: OperandId, indices: &[f64], token: u16) -> SourceResult<Number> {
        let place = self.names.find(walk.formula.name(array));
        let found: Result<_, String> = place.map_or(Ok(None), |place| {
            place.with(|value| match value {
                Some(Value::Array(array)) => {
                    let flat = array.flat_index(indices)?;
                    Ok(array.elements.get(flat).and_then(Option::as_ref).and_then(Value::number))
                }
                _ => Ok(None),
            })
        });
        match found {
            Ok(Some(number)) => Ok(number),
            Ok(None) => self.error(self.token_span(walk, token), "this array element was never set"),
            Err(message) => self.error(self.token_span(walk, token), message),
        }
    }

    /// Any node, in a place of width `n`.
    #[inline]
    pub(super) fn walk(&mut self, walk: &Walk<'_>, id: NodeId, n: u8) -> SourceResult<Number> {
        match walk.formula.nodes[usize::from(id)] {
            Node::Constant(value) => Ok(Number::scalar(value).widened(n)),
            Node::Name(operand) => Ok(walk.number(operand, &self.names).widened(n)),
            _ => self.walk_parent(walk, id, n),
        }
    }

    fn walk_parent(&mut self, walk: &Walk<'_>, id: NodeId, n: u8) -> SourceResult<Number> {
        let value = match walk.formula.nodes[usize::from(id)] {
            Node::Axes(v, n) => Number { n, v: [v[0], v[1], v[2], 0.0, 0.0] },
            Node::Vector(list) => {
                let mut value = Number { n: list.n, v: [0.0; 5] };
                for i in 0..usize::from(list.n) {
                    value.v[i] = self.walk_float(walk, walk.item(list, i))?;
                }
                value
            }
            Node::Element(array, list, token) => {
                let indices = self.walk_list(walk, list)?;
                self.element_number(walk, array, &indices, token)?
            }
            Node::Group(inner) => self.walk(walk, inner, 1)?,
            Node::Negate(inner) => self.walk(walk, inner, n)?.map(|c| -c),
            Node::Not(inner) => self.walk(walk, inner, n)?.map(|c| f64::from(c.abs() <= EPSILON)),
            Node::Binary(operator, left, right, token) => {
                let left = self.walk(walk, left, n)?;
                let right = self.walk(walk, right, n.max(left.n))?;
                if operator == Operator::Divide && right.widened(left.n).has_zero() {
                    self.warn_division(self.token_span(walk, token));
                }
                operator.combine(left, right)
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

    fn walk_list(&mut self, walk: &Walk<'_>, list: List) -> SourceResult<SmallVec<[f64; 8]>> {
        (0..usize::from(list.n)).map(|i| self.walk_float(walk, walk.item(list, i))).collect()
    }

    /// An element of an array, to be passed by reference.
    pub(super) fn walk_place(
        &mut self,
        walk: &Walk<'_>,
        array: OperandId,
        indices: List,
        token: u16,
    ) -> SourceResult<Place> {
        let indices = self.walk_list(walk, indices)?;
        let span = self.token_span(walk, token);
        let name = walk.formula.name(array);
        let Some(mut place) = self.names.find(name).cloned() else { return self.undeclared(name, span) };
        match place.flat_index(&indices) {
            Ok(flat) => place.path.push(flat as u32),
            Err(message) => return self.error(span, message),
        }
        if place.with(|value| value.is_none()) {
            return self.error(span, "this array element was never set");
        }
        Ok(place)
    }

    /// Where a token of the formula stands.
    pub(super) fn token_span(&self, walk: &Walk<'_>, token: u16) -> Span {
        self.feed.span_of(walk.start + usize::from(token))
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

    /// The result for any widths.
    #[inline]
    pub(super) fn combine(self, a: Number, b: Number) -> Number {
        match self {
            Self::Add => a.zip_all(b, |a, b| a + b),
            Self::Subtract => a.zip_all(b, |a, b| a - b),
            Self::Multiply => a.zip_all(b, |a, b| a * b),
            _ => a.zip(b, |a, b| self.apply(a, b)),
        }
    }
}
