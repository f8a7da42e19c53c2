//! `#declare`, `#local`, `#undef`, and the values that names and arguments take.

use super::names::{Names, TableId};
use super::{Evaluator, Number, Place, Value, colors};
use crate::diag::{SourceResult, Span, Topic};
use crate::stack::roomy;
use crate::syntax::{Keyword, Symbol, TokenKind};
use std::rc::Rc;
use std::sync::Arc;

/// An argument of a macro or an element of an array.
#[derive(Clone, Debug)]
pub(super) enum Argument {
    /// Exactly one identifier or array element: passed by reference.
    Alias(Place),
    /// Anything else: passed by value.
    Value(Value),
}

/// Where a declaration stores its value.
enum Target {
    /// Into a variable or element that exists.
    Existing(Place),
    /// Under a new name.
    New(TableId),
    /// Nowhere: `#local A[i]` of an outer array.
    Nowhere,
}

impl Evaluator<'_> {
    /// `#declare` and `#local`, after the word.
    pub(super) fn declaration(&mut self, local: bool) -> SourceResult<()> {
        let deprecated = self.deprecation()?;
        let (name, span) = self.new_name()?;
        let target = self.target(name, local, span)?;
        if self.fill(true)? != TokenKind::Punct('=') {
            return self.expected("'=' in the declaration");
        }
        self.take();
        self.deeper()?;
        let (mut value, needs_semicolon) = roomy(|| self.declared_value())?;
        if let Value::Object(object) = &mut value {
            // The name by which layers know it.
            Arc::make_mut(object).name = Some(Arc::from(&**self.names.words.word(name)));
        }
        self.budget.shallower();
        self.semicolon(needs_semicolon)?;
        match target {
            Target::Existing(place) => {
                if place.path.is_empty() {
                    self.check_redeclaration(&place, span)?;
                }
                self.store(&place, Some(value), span)?;
            }
            Target::New(table) => self.names.bind(table, name, Place::new(value)),
            Target::Nowhere => self.warn_here(
                Topic::Ignored,
                span,
                "#local cannot change an array that was declared outside of this macro or file; nothing is stored",
            ),
        }
        if let Some((once, text)) = deprecated {
            let text = text.unwrap_or_else(|| format!("'{}' is deprecated", self.names.words.word(name)).into());
            self.names.deprecate(name, once, text);
        }
        Ok(())
    }

    /// `deprecated [once] ["text"]`.
    fn deprecation(&mut self) -> SourceResult<Option<(bool, Option<Rc<str>>)>> {
        if self.fill(true)? != TokenKind::Keyword(Keyword::Deprecated) {
            return Ok(None);
        }
        self.take();
        let once = self.fill(true)? == TokenKind::Keyword(Keyword::Once);
        if once {
            self.take();
        }
        let text = if self.fill(true)? == TokenKind::String { Some(self.string()?) } else { None };
        Ok(Some((once, text)))
    }

    /// A word that is not reserved, taken.
    pub(super) fn new_name(&mut self) -> SourceResult<(Symbol, Span)> {
        match self.fill(true)? {
            TokenKind::Name(name) => {
                let span = self.span();
                self.take();
                Ok((name, span))
            }
            TokenKind::Keyword(word) => {
                let span = self.span();
                let word = word.word();
                self.error_with_hint(
                    span,
                    format!("'{word}' is a reserved word and cannot be declared"),
                    "names of your own are safe with a capital letter",
                )
            }
            _ => self.expected("a name"),
        }
    }

    /// Decides where to store before the value is read: a macro may end while that is done.
    fn target(&mut self, name: Symbol, local: bool, span: Span) -> SourceResult<Target> {
        let table = if local { self.names.innermost() } else { Names::GLOBAL };
        let found = if local { self.names.find_innermost(name) } else { self.names.find(name) };
        if let Some(place) = found.cloned() {
            return self.indexed(place, span).map(Target::Existing);
        }
        if self.fill(true)? != TokenKind::Punct('[') {
            return Ok(Target::New(table));
        }
        match self.place_after(name, span)? {
            Some(_) => Ok(Target::Nowhere),
            None => self.undeclared(name, span),
        }
    }

    /// Functions and macros are not overwritten.
    fn check_redeclaration(&self, place: &Place, span: Span) -> SourceResult<()> {
        let kind = place.with(|value| match value {
            Some(Value::Function(_)) => Some("function"),
            Some(Value::Macro(_)) => Some("macro"),
            Some(Value::File(_)) => Some("open file"),
            _ => None,
        });
        match kind {
            Some(kind) => self.error_with_hint(
                span,
                format!("this {kind} is already declared"),
                "write #undef with its name before",
            ),
            None => Ok(()),
        }
    }

    /// The `;` behind a declared value.
    pub(super) fn semicolon(&mut self, needed: bool) -> SourceResult<()> {
        if self.fill(true)? != TokenKind::Punct(';') {
            if !needed || self.version < 310 {
                return Ok(());
            }
            let span = self.feed.last_span();
            if self.version >= 350 {
                return self.expected("';' behind the value");
            }
            self.warn_here(Topic::Syntax, span, "a ';' is missing behind the value");
            return Ok(());
        }
        self.take();
        // One more is forgiven.
        if self.fill(true)? == TokenKind::Punct(';') {
            self.take();
        }
        Ok(())
    }

    /// The value of a declaration, and whether a `;` must follow.
    fn declared_value(&mut self) -> SourceResult<(Value, bool)> {
        let value = match self.argument()? {
            Argument::Value(value) => value,
            Argument::Alias(place) => match place.get() {
                Some(value) => value,
                None => {
                    let span = self.feed.last_span();
                    return self.error(span, "this array element was never set");
                }
            },
        };
        let needs_semicolon = value.number().is_some();
        let value = match value {
            Value::Macro(_) | Value::File(_) => {
                let (span, kind) = (self.feed.last_span(), value.kind());
                return self.error(span, format!("a {kind} cannot be copied"));
            }
            value => value,
        };
        Ok((value, needs_semicolon))
    }

    /// Anything that can be declared: the argument of a macro, an array element, a value.
    pub(super) fn argument(&mut self) -> SourceResult<Argument> {
        let (bare, parentheses) = (self.bare, self.parentheses);
        self.bare = true;
        self.parentheses = 0;
        let argument = self.bare_argument()?;
        (self.bare, self.parentheses) = (bare, parentheses);
        Ok(argument)
    }

    fn bare_argument(&mut self) -> SourceResult<Argument> {
        if let Some(number) = self.formula_argument()? {
            return self.colored(number).map(Argument::Value);
        }
        let value = match self.fill(false)? {
            TokenKind::Name(name) => return self.identifier_argument(name),
            TokenKind::Keyword(Keyword::Array) => {
                self.take();
                Value::Array(Rc::new(self.array()?))
            }
            TokenKind::Keyword(Keyword::Transform) => {
                self.take();
                self.bare = false;
                Value::Transform(Rc::new(self.transform_block()?))
            }
            TokenKind::Keyword(word) if colors::is_color_word(word) => self.color_value()?,
            _ if self.starts_string()? => Value::String(self.string()?),
            _ if self.starts_expression()? => {
                let number = self.arithmetic(1)?;
                self.colored(number)?
            }
            TokenKind::Keyword(word) => {
                self.bare = false;
                match self.declared_block(word)? {
                    Some(value) => value,
                    None => return self.expected("a value"),
                }
            }
            _ => return self.expected("a value"),
        };
        Ok(Argument::Value(value))
    }

    /// A value that starts with an identifier: the thing itself, or an expression.
    fn identifier_argument(&mut self, name: Symbol) -> SourceResult<Argument> {
        let span = self.span();
        if self.names.find(name).is_none() {
            return self.undeclared(name, span);
        }
        let place = self.place()?;
        let Some(value) = place.get() else { return Ok(Argument::Alias(place)) };
        let number = match value {
            Value::Float(_) | Value::Vector(_) => value.number(),
            Value::Function(_) | Value::Spline(_) if self.fill(true)? == TokenKind::Punct('(') => {
                let number = self.called(&value, span)?.unwrap_or(Number::scalar(0.0));
                let number = self.arithmetic_from(number, 1)?;
                return self.colored(number).map(Argument::Value);
            }
            Value::Function(_) => return Ok(Argument::Value(value)),
            _ => None,
        };
        let Some(number) = number else { return Ok(Argument::Alias(place)) };
        let goes_on = match self.fill(true)? {
            TokenKind::Punct(c) => matches!(c, '+' | '-' | '*' | '/' | '.'),
            TokenKind::Keyword(word) => colors::is_color_word(word) && number.n == 5,
            _ => false,
        };
        if !goes_on {
            return Ok(Argument::Alias(place));
        }
        let number = self.arithmetic_from(number, 1)?;
        self.colored(number).map(Argument::Value)
    }

    /// A colour may be followed by components to overwrite.
    fn colored(&mut self, number: Number) -> SourceResult<Value> {
        if number.n == 5 { self.color_components(number).map(Value::from) } else { Ok(Value::from(number)) }
    }

    /// `#undef NAME`, after the word.
    pub(super) fn undefine(&mut self) -> SourceResult<()> {
        let (name, span) = self.new_name()?;
        let place = self.place_after(name, span)?;
        match place {
            Some(place) if !place.path.is_empty() && self.names.find(name).is_none_or(|p| p.path != place.path) => {
                self.store(&place, None, span)
            }
            _ => {
                if !self.names.unbind(name) {
                    self.warn_here(Topic::Ignored, span, "this name is not declared");
                }
                Ok(())
            }
        }
    }
}
