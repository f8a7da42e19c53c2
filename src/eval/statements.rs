//! Directives that are known as trees, as nearly all in loops are: they run without a look at their tokens.
//!
//! Each does what its tokens would do (`declarations`, `conditions`, `loops`), or nothing at all if a name in it stands
//! for what the tree does not expect.

use super::expressions::truth;
use super::formulas::Known;
use super::names::Slot;
use super::{Evaluator, Value};
use crate::diag::SourceResult;
use crate::syntax::formula::{Action, Part, Scope, Statement};
use crate::syntax::{Directive, Symbol};
use smallvec::SmallVec;
use std::rc::Rc;

/// What became of a statement.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
    /// Nothing was done: its tokens have to be read.
    Unread,
}

impl Evaluator<'_> {
    /// Runs the directives that come next in the innermost file or macro.
    pub(super) fn run_directives(&mut self) -> SourceResult<()> {
        while self.feed.held().is_none() {
            if let Some((statement, start)) = self.feed.statement(0, |name| self.names.is_macro(name))
                && self.run_statement(&statement, start)? == Outcome::Done
            {
                continue;
            }
            let Some((directive, span)) = self.feed.directive() else { break };
            match directive {
                Directive::End if !self.case_wanted => self.run_end(span)?,
                Directive::Else if !self.case_wanted => self.run_else(span)?,
                _ => self.run_directive(directive, span)?,
            }
        }
        Ok(())
    }

    /// Runs a statement whose first token, number `start` of the piece, comes next.
    fn run_statement(&mut self, statement: &Statement, start: usize) -> SourceResult<Outcome> {
        if self.case_wanted || self.version < 350 {
            return Ok(Outcome::Unread);
        }
        match &statement.action {
            Action::Set(name, scope) => self.set_variable(*name, *scope, statement, start),
            Action::SetElement(name, scope, indices) => self.set_element((*name, *scope), indices, statement, start),
            Action::If | Action::While => {
                let span = self.feed.span_of(start);
                let in_scene = self.feed.depth() == 1;
                let condition = match self.condition_of(statement, start) {
                    Ok(Some(condition)) => condition,
                    Ok(None) => return Ok(Outcome::Unread),
                    Err(errors) => return self.not_opened(in_scene, span, errors),
                };
                match statement.action {
                    Action::If => self.choose(condition, span)?,
                    _ => self.enter_while(condition, self.feed.position_of(start + 1), span)?,
                }
                Ok(Outcome::Done)
            }
        }
    }

    /// Whether the condition of a statement holds; nothing is taken if it has to be read by its tokens.
    pub(super) fn condition_of(&mut self, statement: &Statement, start: usize) -> SourceResult<Option<bool>> {
        let Some(value) = self.part(&statement.value, start)? else { return Ok(None) };
        self.feed.go_on_at(start + statement.length);
        match value {
            Known::Float(value) => Ok(Some(truth(value))),
            Known::Number(value) => {
                self.want_float(value, self.feed.span_of(start + 1)).map(|value| Some(truth(value)))
            }
        }
    }

    fn part(&mut self, part: &Part, start: usize) -> SourceResult<Option<Known>> {
        self.value_of(&part.formula, start + part.offset, 1)
    }

    /// A variable that holds a number already, or is new in the innermost table.
    #[inline]
    fn set_variable(
        &mut self,
        name: Symbol,
        scope: Scope,
        statement: &Statement,
        start: usize,
    ) -> SourceResult<Outcome> {
        let slot: Option<Slot> = match self.names.find_in(scope, name) {
            Some(place) if place.holds_number() => Some(Rc::clone(&place.slot)),
            None if scope == Scope::Local => None,
            _ => return Ok(Outcome::Unread),
        };
        let table = self.names.innermost();
        let Some(value) = self.part(&statement.value, start)? else { return Ok(Outcome::Unread) };
        self.feed.go_on_at(start + statement.length);
        match slot {
            Some(slot) => value.store(&mut slot.borrow_mut()),
            None => {
                let place = self.names.place(Value::from(value));
                self.names.bind(table, name, place);
            }
        }
        Ok(Outcome::Done)
    }

    /// An element of an array.
    fn set_element(
        &mut self,
        (name, scope): (Symbol, Scope),
        indices: &[Part],
        statement: &Statement,
        start: usize,
    ) -> SourceResult<Outcome> {
        let is_array = |value: Option<&Value>| match value {
            Some(Value::Array(array)) => array.dimensions.len() == indices.len(),
            _ => false,
        };
        let mut place = match self.names.find_in(scope, name) {
            Some(place) if place.path.is_empty() && place.with(is_array) => place.clone(),
            _ => return Ok(Outcome::Unread),
        };
        // Nothing may have happened by the time that tokens turn out to be needed.
        let known = self.is_known(&statement.value.formula)
            && indices.iter().all(|index| index.formula.calls.is_empty() && self.is_known(&index.formula));
        if !known {
            return Ok(Outcome::Unread);
        }
        let span = self.feed.span_of(start + 1);
        let mut floats = SmallVec::<[f64; 2]>::new();
        for index in indices {
            let Some(index) = self.part(index, start)? else { return Ok(Outcome::Unread) };
            floats.push(self.want_float(index.widened(1), span)?);
        }
        match place.flat_index(&floats) {
            Ok(flat) => place.path.push(flat as u32),
            Err(message) => return self.error(span, message),
        }
        let Some(value) = self.part(&statement.value, start)? else { return Ok(Outcome::Unread) };
        self.feed.go_on_at(start + statement.length);
        self.store(&place, Some(Value::from(value)), span)?;
        Ok(Outcome::Done)
    }
}
