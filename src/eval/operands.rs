//! Operands of expressions: literals, identifiers, calls, and their components.

use super::macros::arguments_in_words;
use super::{Evaluator, Number, Value};
use crate::diag::{SourceResult, Span};
use crate::syntax::expression::component;
use crate::syntax::{Keyword, Symbol, TokenKind};

impl Evaluator<'_> {
    /// A literal that is all of an expression, as most are: behind it stands what cannot go on with it.
    pub(super) fn lone_literal(&mut self) -> SourceResult<Option<Number>> {
        let literal = match self.fill(false)? {
            TokenKind::Number(value) => Number::scalar(value),
            TokenKind::Vector => Number { n: self.feed.literal().1, v: self.feed.literal().0 },
            _ => return Ok(None),
        };
        if !self.feed.ends_expression() {
            return Ok(None);
        }
        self.take();
        self.fill(self.bare)?;
        Ok(Some(literal))
    }

    /// A number, identifier, call, literal vector or parenthesis, at its own width.
    pub(super) fn bare_operand(&mut self) -> SourceResult<Number> {
        match self.fill(false)? {
            TokenKind::Number(value) => {
                self.take();
                Ok(Number::scalar(value))
            }
            TokenKind::Name(name) => self.identifier(name),
            TokenKind::Vector => {
                let (v, n) = *self.feed.literal();
                self.take();
                Ok(Number { n, v })
            }
            TokenKind::Punct('(') => {
                self.bracketed('(', "of the expression", ')', "to close the parenthesis", |e| e.full(1))
            }
            TokenKind::Punct('<') => self.vector_literal(),
            TokenKind::Keyword(keyword) => match self.built_in(keyword)? {
                Some(value) => Ok(value),
                None => self.expected("a number, a vector or something that gives one"),
            },
            _ => self.expected("a number, a vector or something that gives one"),
        }
    }

    /// `< a, b, … >` of any expressions; commas may be missing, the last one may trail.
    fn vector_literal(&mut self) -> SourceResult<Number> {
        let span = self.span();
        let mut value = Number { n: 0, v: [0.0; 5] };
        let parentheses = std::mem::replace(&mut self.parentheses, 0);
        let read = |e: &mut Self| {
            // Version 1.0 asks for parentheses around operators here too.
            e.parentheses = 0;
            while value.n < 5 && !e.at_punct('>')? {
                value.v[value.n as usize] = e.float()?;
                value.n += 1;
                if value.n < 5 {
                    e.comma()?;
                }
            }
            e.parentheses = 1;
            Ok(())
        };
        self.bracketed('<', "of the vector", '>', "to close the vector", read)?;
        self.parentheses = parentheses;
        if value.n < 2 {
            return self.error(span, "a vector has two to five components");
        }
        Ok(value)
    }

    /// What an identifier gives: a variable, an element, a call of a function or spline.
    fn identifier(&mut self, name: Symbol) -> SourceResult<Number> {
        let Some(place) = self.names.find(name) else {
            let span = self.span();
            return self.undeclared(name, span);
        };
        if let Some(number) = place.with(|value| value.and_then(Value::number)) {
            self.note_use(name);
            self.take();
            return Ok(number);
        }
        let span = self.span();
        let place = self.place()?;
        match place.get() {
            None => self.error(span, "this array element was never set"),
            Some(value) => match self.called(&value, span)? {
                Some(number) => Ok(number),
                None => {
                    let (kind, word) = (value.kind(), self.names.words.word(name).clone());
                    let message = format!("expected a number or vector, found the {kind} '{word}'");
                    match kind {
                        "string" => self.error_with_hint(span, message, format!("val({word}) makes a number of it")),
                        _ => self.error(span, message),
                    }
                }
            },
        }
    }

    /// The number that a value gives in an expression: itself, or the result of calling it.
    pub(super) fn called(&mut self, value: &Value, span: Span) -> SourceResult<Option<Number>> {
        match value {
            Value::Float(_) | Value::Vector(_) => Ok(value.number()),
            Value::Function(function) => {
                let arguments = self.float_arguments()?;
                let (wanted, given) = (function.n_parameters, arguments.len());
                if wanted != given {
                    return self
                        .error(span, format!("this function takes {}, not {given}", arguments_in_words(wanted)));
                }
                let n = function.width().clamp(1, 5) as u8;
                Ok(Some(Number { n, v: function.call_by(&arguments, self.queries) }))
            }
            Value::Spline(spline) => self.spline_call(spline).map(Some),
            _ => Ok(None),
        }
    }

    /// `.x` and the like behind an operand.
    pub(super) fn component(&mut self, value: Number) -> SourceResult<Number> {
        if self.fill(self.bare)? != TokenKind::Punct('.') {
            return Ok(value);
        }
        self.take();
        let TokenKind::Keyword(word) = self.fill(self.bare)? else {
            return self.expected("a component such as x or red behind the dot");
        };
        if word == Keyword::Gray {
            self.take();
            let c = value.widened(3).v;
            return Ok(Number::scalar(0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2]));
        }
        let Some(index) = component(word) else {
            return self.expected("a component such as x or red behind the dot");
        };
        if index >= value.n {
            let (span, n) = (self.span(), value.n);
            return self.error(span, format!("there is no component '{}' in a value of width {n}", word.word()));
        }
        self.take();
        Ok(Number::scalar(value.v[usize::from(index)]))
    }
}
