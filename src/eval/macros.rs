//! Macros: fragments of text that are read again at each call.

use super::declarations::Argument;
use super::feed::{Cursor, Role};
use super::names::Names;
use super::{Evaluator, Macro, Place, Value};
use crate::diag::{SourceResult, Span};
use crate::stack::roomy;
use crate::syntax::{Position, TokenKind, formula};
use smallvec::SmallVec;
use std::cell::OnceCell;
use std::rc::Rc;

/// What the parameters of a call stand for: variables of the caller, or new ones.
pub(super) type Arguments = SmallVec<[Place; 4]>;

impl Evaluator<'_> {
    /// `#macro NAME ( parameters ) … #end`: remembers where the body stands.
    pub(super) fn define_macro(&mut self, span: Span) -> SourceResult<()> {
        let (name, _) = self.new_name()?;
        let mut parameters = Vec::new();
        if self.fill(true)? != TokenKind::Punct('(') {
            return self.expected("'(' before the parameters of the macro");
        }
        self.take();
        while self.fill(true)? != TokenKind::Punct(')') {
            let (parameter, _) = self.new_name()?;
            parameters.push(parameter);
            if self.fill(true)? == TokenKind::Punct(',') {
                self.take();
            }
        }
        self.take();
        let (source, start) = (self.feed.source().cloned(), self.feed.position());
        self.skip_block(span)?;
        let source = source.filter(|source| self.feed.source().is_some_and(|now| Rc::ptr_eq(now, source)));
        let Some(source) = source else {
            return self.error(span, "this macro does not end in the file where it began");
        };
        // The position behind the #end is never the first of a piece.
        let after = self.feed.position();
        let end = Position { index: after.index.saturating_sub(1), ..after };
        let made = Value::Macro(Rc::new(Macro { name, parameters, source, start, end, result: OnceCell::new() }));
        match self.names.find(name).cloned() {
            Some(place) if place.with(|v| matches!(v, Some(Value::Macro(_)))) => place.set(Some(made)),
            Some(place) if place.with(|v| matches!(v, Some(Value::Function(_)))) => {
                return self.error(span, "a function of this name is already declared");
            }
            _ => self.names.bind(Names::GLOBAL, name, Place::new(made)),
        }
        Ok(())
    }

    /// Evaluates the arguments and lets the body's tokens come next.
    pub(super) fn call_macro(&mut self, called: &Rc<Macro>, span: Span) -> SourceResult<()> {
        let bare = std::mem::replace(&mut self.bare, false);
        let case_wanted = std::mem::take(&mut self.case_wanted);
        self.deeper()?;
        let mut arguments = roomy(|| self.macro_arguments(called, span))?;
        self.budget.shallower();
        self.bare = bare;
        self.case_wanted = case_wanted;
        self.enter_macro(called, &mut arguments, span)?;
        if called.result.get().is_none() {
            self.find_result(called);
        }
        Ok(())
    }

    /// Opens a table with the parameters and a cursor over the body.
    pub(super) fn enter_macro(
        &mut self,
        called: &Rc<Macro>,
        arguments: &mut Arguments,
        span: Span,
    ) -> SourceResult<()> {
        self.count_step(span)?;
        let entered = self.budget.enter_macro();
        self.within(entered, span)?;
        self.names.push();
        let table = self.names.innermost();
        for (parameter, argument) in called.parameters.iter().zip(arguments.drain(..)) {
            self.names.bind(table, *parameter, argument);
        }
        let range = (called.start, Some(called.end));
        let mut cursor = Cursor::new(Rc::clone(&called.source), range, Role::Macro(called.name));
        cursor.blocks = self.open_blocks.len();
        cursor.call = span;
        self.feed.push(cursor);
        Ok(())
    }

    /// Finds out whether the body ends in an expression.
    fn find_result(&mut self, called: &Macro) {
        let (start, end) = (called.start, called.end);
        let piece = called.source.tokens(start.piece as usize, &mut self.names.words);
        let names = &self.names;
        let result = piece.filter(|_| start.piece == end.piece).and_then(|piece| {
            let range = start.index as usize..end.index as usize;
            formula::result_of(&piece.tokens, range, called.source.text(), &|name| names.is_macro(name))
        });
        called.result.get_or_init(|| result);
    }

    fn macro_arguments(&mut self, called: &Macro, span: Span) -> SourceResult<Arguments> {
        let wanted = called.parameters.len();
        if self.fill(false)? != TokenKind::Punct('(') {
            let name = self.names.words.word(called.name).clone();
            return self.expected(&format!("'(' behind the name of the macro '{name}'"));
        }
        self.take();
        let mut arguments = Arguments::new();
        while arguments.len() < wanted {
            if self.fill(false)? == TokenKind::Punct(')') {
                let (name, given) = (self.names.words.word(called.name).clone(), arguments.len());
                return self
                    .error(span, format!("the macro '{name}' takes {}, not {given}", arguments_in_words(wanted)));
            }
            let start = self.span();
            arguments.push(match self.argument()? {
                Argument::Alias(place) if place.with(|value| value.is_none()) => {
                    return self.error(start, "this array element was never set");
                }
                Argument::Alias(place) => place,
                Argument::Value(value) => self.names.place(value),
            });
            if self.fill(false)? == TokenKind::Punct(',') {
                self.take();
            }
        }
        if self.fill(false)? != TokenKind::Punct(')') {
            let name = self.names.words.word(called.name).clone();
            return self.expected(&format!("')', for the macro '{name}' takes {}", arguments_in_words(wanted)));
        }
        self.take();
        Ok(arguments)
    }
}

/// "1 argument", "2 arguments".
pub(in crate::eval) fn arguments_in_words(n: usize) -> String {
    format!("{n} argument{}", if n == 1 { "" } else { "s" })
}
