//! Directives that are made of formulas and the tokens around them.

use super::Formula;
use super::parser::parse_part;
use super::reader::Reader;
use crate::syntax::{Directive, Symbol, Token, TokenKind};

/// A directive that is known as a whole.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What it does.
    pub action: Action,
    /// Its condition or value.
    pub value: Part,
    /// How many tokens it takes up.
    pub length: usize,
}

/// What a [`Statement`] does with its value.
#[derive(Clone, Debug)]
pub enum Action {
    /// `#if ( formula )`.
    If,
    /// `#while ( formula )`.
    While,
    /// `#declare NAME = formula ;` and `#local …`.
    Set(Symbol, Scope),
    /// `#declare NAME [formula] … = formula ;` and `#local …`.
    SetElement(Symbol, Scope, Vec<Part>),
}

/// Whose name is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// `#declare`: the innermost one there is.
    Any,
    /// `#local`: one of the innermost table.
    Local,
}

/// A formula of a statement, and how many tokens stand before it.
#[derive(Clone, Debug)]
pub struct Part {
    /// The formula.
    pub formula: Formula,
    /// Number of its first token, counted from that of the statement.
    pub offset: usize,
}

impl Statement {
    /// Whether the directive is one of those that are known as a whole.
    #[inline]
    pub fn may_begin_with(directive: Directive) -> bool {
        matches!(directive, Directive::If | Directive::While | Directive::Declare | Directive::Local)
    }

    /// Reads one from the beginning of `tokens`; `None` if something else stands there.
    ///
    /// `is_macro` tells which names stand for macros at the time.
    pub fn parse(tokens: &[Token], text: &[u8], is_macro: &dyn Fn(Symbol) -> bool) -> Option<Self> {
        let reader = Reader { tokens, text, is_macro };
        match reader.kind(0)? {
            TokenKind::Directive(Directive::If) => reader.condition(Action::If),
            TokenKind::Directive(Directive::While) => reader.condition(Action::While),
            TokenKind::Directive(Directive::Declare) => reader.declaration(Scope::Any),
            TokenKind::Directive(Directive::Local) => reader.declaration(Scope::Local),
            _ => None,
        }
    }
}

impl Reader<'_> {
    /// The formula from there on, and where it ends.
    fn part(&self, offset: usize, full: bool) -> Option<(Part, usize)> {
        let formula = parse_part(self.tokens.get(offset..)?, self.text, full, self.is_macro)?;
        let end = offset + formula.length;
        Some((Part { formula, offset }, end))
    }

    fn condition(&self, action: Action) -> Option<Statement> {
        let (value, end) = self.is(1, '(').then(|| self.part(2, true))??;
        self.is(end, ')').then(|| Statement { action, value, length: end + 1 })
    }

    fn declaration(&self, scope: Scope) -> Option<Statement> {
        let TokenKind::Name(name) = self.kind(1)? else { return None };
        let (mut indices, mut at) = (Vec::new(), 2);
        while self.is(at, '[') {
            let (index, end) = self.part(at + 1, false)?;
            indices.push(index);
            at = self.is(end, ']').then_some(end + 1)?;
        }
        let (value, end) = self.is(at, '=').then(|| self.part(at + 1, false))??;
        // A second semicolon is forgiven, and may come from anywhere.
        let alone = self.is(end, ';') && self.kind(end + 1).is_some_and(|next| next != TokenKind::Punct(';'));
        let action =
            if indices.is_empty() { Action::Set(name, scope) } else { Action::SetElement(name, scope, indices) };
        alone.then(|| Statement { action, value, length: end + 1 })
    }
}
