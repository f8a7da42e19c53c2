//! Expressions that were parsed into trees: which may be used where.
//!
//! Gives the same value, in the same order of evaluation, as reading the tokens does; see
//! [`crate::syntax::formula`] for when it may be used, and [`super::walk`] for the evaluation.

use super::macro_results::gives_operand;
use super::names::Names;
use super::walk::Walk;
use super::{Evaluator, Number, Place, Value};
use crate::diag::SourceResult;
use crate::syntax::formula::{Demand, Formula, MAX_PLAIN, Node, Operand};

/// Whether, and how, a formula can be walked.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reading {
    Float,
    Number,
    Tokens,
}

/// What a formula gives.
pub(super) enum Known {
    /// A float, whatever the width of the place.
    Float(f64),
    Number(Number),
}

impl Known {
    /// In a place of width `n`.
    pub(super) fn widened(self, n: u8) -> Number {
        match self {
            Self::Float(f) => Number::scalar(f).widened(n),
            Self::Number(number) => number.widened(n),
        }
    }
}

impl Known {
    /// Puts it where a number was.
    #[inline]
    pub(super) fn store(self, into: &mut Value) {
        match (self, into) {
            (Self::Float(new), Value::Float(old)) => *old = new,
            (new, old) => *old = Value::from(new),
        }
    }
}

impl From<Known> for Value {
    fn from(outcome: Known) -> Self {
        match outcome {
            Known::Float(f) => Self::Float(f),
            Known::Number(number) => Self::from(number),
        }
    }
}

impl Evaluator<'_> {
    /// The value of the expression that comes next, if it is known as a tree; it is taken.
    #[inline]
    pub(super) fn formula(&mut self, full: bool, n: u8) -> SourceResult<Option<Number>> {
        self.known_formula(full, n, true)
    }

    /// The same for an argument: a name alone is not taken, since it goes by reference.
    pub(super) fn formula_argument(&mut self) -> SourceResult<Option<Number>> {
        self.known_formula(false, 1, false)
    }

    fn known_formula(&mut self, full: bool, n: u8, names: bool) -> SourceResult<Option<Number>> {
        if self.version < 150 {
            return Ok(None);
        }
        let found = self.feed.formula(full, |name| self.names.is_macro(name));
        let Some((formula, start)) = found else { return Ok(None) };
        if formula.open_ended && !self.bare
            || !names && matches!(formula.nodes.last(), Some(Node::Name(_) | Node::Element(..)))
        {
            return Ok(None);
        }
        let Some(value) = self.value_of(&formula, start, n)? else { return Ok(None) };
        self.feed.pass_formula(&formula);
        Ok(Some(value.widened(n)))
    }

    /// What a formula gives in a place of width `n`; its first token is number `start` of the piece.
    #[inline]
    pub(super) fn value_of(&mut self, formula: &Formula, start: usize, n: u8) -> SourceResult<Option<Known>> {
        match self.value_of_floats(formula, start, n)? {
            None => self.number_of(formula, start, n),
            known => Ok(known),
        }
    }

    fn number_of(&mut self, formula: &Formula, start: usize, n: u8) -> SourceResult<Option<Known>> {
        let reading = reading(formula, &self.names, self.budget.macros());
        let walk = Walk { formula, start, floats: &[] };
        Ok(match reading {
            Reading::Float => Some(Known::Float(self.walk_float(&walk, formula.root())?)),
            Reading::Number => Some(Known::Number(self.walk(&walk, formula.root(), n)?)),
            Reading::Tokens => None,
        })
    }

    /// The value of a plain formula whose variables are all floats; `None`, and nothing done, for others.
    #[inline]
    fn value_of_floats(&mut self, formula: &Formula, start: usize, n: u8) -> SourceResult<Option<Known>> {
        if !formula.plain || self.names.any_deprecated() {
            return Ok(None);
        }
        let mut floats = [0.0; MAX_PLAIN];
        for (i, operand) in formula.operands.iter().enumerate() {
            match self.names.float(operand.name) {
                Some(value) => floats[i] = value,
                None => return Ok(None),
            }
        }
        let walk = Walk { formula, start, floats: &floats };
        Ok(Some(match formula.scalar {
            true => Known::Float(self.walk_float(&walk, formula.root())?),
            false => Known::Number(self.walk(&walk, formula.root(), n)?),
        }))
    }

    /// Whether all names of a formula stand for what the tree takes them for.
    pub(super) fn is_known(&self, formula: &Formula) -> bool {
        reading(formula, &self.names, self.budget.macros()) != Reading::Tokens
    }
}

/// How a formula can be walked where so many macros are running.
fn reading(formula: &Formula, names: &Names, n_macros: usize) -> Reading {
    let mut reading = if formula.scalar { Reading::Float } else { Reading::Number };
    let fits = !names.any_deprecated()
        && formula.operands.iter().all(|operand| match names.find(operand.name) {
            Some(place) => fits(place, *operand, &mut reading),
            None => false,
        })
        && formula.calls.iter().all(|call| gives_operand(call, names, n_macros));
    if fits { reading } else { Reading::Tokens }
}

/// Whether a formula takes an operand for what it is; a vector may change how the formula is read.
fn fits(place: &Place, operand: Operand, reading: &mut Reading) -> bool {
    place.with(|value| {
        let value = match (operand.n_indices, value) {
            (0, value) => value,
            (n, Some(Value::Array(array))) if array.dimensions.len() == usize::from(n) => array.any(),
            _ => return false,
        };
        match (value, operand.demand) {
            (Some(Value::Float(_)), Demand::Float | Demand::Number | Demand::Either) => true,
            (Some(Value::Vector(_)), Demand::Either) => true,
            (Some(Value::Vector(_)), Demand::Number) => {
                *reading = Reading::Number;
                true
            }
            (Some(Value::Float(_)), Demand::Component(index)) => index == 0,
            (Some(Value::Vector(v)), Demand::Component(index)) => index < v.n,
            (Some(Value::Function(f)), Demand::Function(n)) => f.n_parameters == usize::from(n) && f.width() == 1,
            (value, Demand::Reference) => is_reference(value),
            _ => false,
        }
    })
}

/// Whether a value can be passed by reference.
fn is_reference(value: Option<&Value>) -> bool {
    !matches!(value, None | Some(Value::Function(_) | Value::Spline(_) | Value::Macro(_) | Value::File(_)))
}
