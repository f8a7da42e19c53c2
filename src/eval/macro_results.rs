//! Macros that give a number, called from within a formula.
//!
//! The tokens that a macro yields join those of its caller, so in general nothing is known of an
//! expression that calls one until its tokens arrive. A macro whose body is made of whole statements
//! and one expression ([`crate::syntax::formula::MacroResult`]) is the exception that nearly all
//! macros in expressions are: its body runs as always, its expression gives the operand.

use super::macros::Arguments;
use super::names::Names;
use super::walk::Walk;
use super::{Evaluator, Macro, Number, Value};
use crate::diag::SourceResult;
use crate::syntax::formula::{MacroCall, MacroResult, Node};
use crate::syntax::{Token, TokenKind};
use std::rc::Rc;

/// Calls inside one another beyond which tokens are read, which takes none of the stack.
const MAX_DEPTH: usize = 200;

/// Whether a call can be an operand where so many macros are running: the macro gives a number whatever stands around it.
pub(super) fn gives_operand(call: &MacroCall, names: &Names, n_macros: usize) -> bool {
    let Some(called) = names.macro_named(call.name) else { return false };
    let Some(Some(result)) = called.result.get() else { return false };
    called.parameters.len() == usize::from(call.arguments.n)
        && n_macros < MAX_DEPTH
        && (result.closed || call.whole)
        && (result.numeric || call.numeric || !call.whole)
}

impl Evaluator<'_> {
    /// Calls a macro for its result in a place of width `n`.
    pub(super) fn walk_macro(&mut self, walk: &Walk<'_>, call: &MacroCall, n: u8) -> SourceResult<Number> {
        let span = self.token_span(walk, call.token);
        let mut arguments = Arguments::new();
        for i in 0..usize::from(call.arguments.n) {
            let item = walk.item(call.arguments, i);
            arguments.push(match walk.formula.nodes[usize::from(item)] {
                Node::Name(operand) => {
                    let name = walk.formula.name(operand);
                    match self.names.find(name) {
                        Some(place) => place.clone(),
                        None => return self.undeclared(name, span),
                    }
                }
                Node::Element(array, indices, token) => self.walk_place(walk, array, indices, token)?,
                _ => {
                    let value = Value::from(self.walk(walk, item, 1)?);
                    self.names.place(value)
                }
            });
        }
        let Some(called) = self.names.macro_named(call.name) else { return self.undeclared(call.name, span) };
        let held = self.feed.set_aside();
        self.enter_macro(&called, &mut arguments, span)?;
        let value = self.run_body(&called, n)?;
        self.leave_cursor()?;
        self.feed.bring_back(held);
        Ok(value)
    }

    /// Runs the body that was just entered; its last expression.
    fn run_body(&mut self, called: &Rc<Macro>, n: u8) -> SourceResult<Number> {
        let depth = self.feed.depth();
        self.feed.fence(&mut self.names.words);
        let Some(Some(result)) = called.result.get() else { return Ok(Number::scalar(f64::NAN)) };
        while let Some(directive) = self.before_result(result)? {
            let TokenKind::Directive(word) = directive.kind else {
                return self.error(directive.span, "this does not belong to the value that the macro gives");
            };
            self.run_directive(word, directive.span)?;
        }
        debug_assert_eq!(self.feed.depth(), depth);
        match self.value_of(&result.formula, result.start, n)? {
            Some(value) => {
                self.take();
                Ok(value.widened(n))
            }
            None => self.result_by_tokens(n),
        }
    }

    /// Runs directives; the token behind them, taken, if it still stands before the result.
    fn before_result(&mut self, result: &MacroResult) -> SourceResult<Option<Token>> {
        self.run_directives()?;
        if self.feed.next_index() >= result.start {
            return Ok(None);
        }
        match self.feed.release() {
            Some(token) => Ok(Some(token)),
            None => self.fetch().map(Some),
        }
    }

    fn result_by_tokens(&mut self, n: u8) -> SourceResult<Number> {
        let bare = std::mem::replace(&mut self.bare, false);
        let value = self.arithmetic_by_tokens(n)?;
        if self.fill(false)? != TokenKind::End {
            return self.expected("the end of the macro behind its value");
        }
        self.take();
        self.bare = bare;
        Ok(value)
    }
}
