//! Macros that give a number: statements, then one expression.

use super::parser::parse_part;
use super::reader::Reader;
use super::{Formula, Node};
use crate::syntax::{Directive, Symbol, Token, TokenKind};
use std::rc::Rc;

/// The expression at the end of a macro's body, with nothing but whole statements before it.
#[derive(Clone, Debug)]
pub struct MacroResult {
    /// The index of its first token in the piece that holds the body.
    pub start: usize,
    /// The expression.
    pub formula: Rc<Formula>,
    /// Whether it is a single operand, which no operator of the caller can cut in two.
    pub closed: bool,
    /// Whether it is surely a number; a name alone may stand for anything.
    pub numeric: bool,
}

/// The result of the body that `range` of `tokens` holds, up to its `#end` at `range.end`.
///
/// `None` for bodies that yield anything else, or might: their tokens join the caller's.
pub fn result_of(
    tokens: &[Token],
    range: std::ops::Range<usize>,
    text: &[u8],
    is_macro: &dyn Fn(Symbol) -> bool,
) -> Option<MacroResult> {
    let body = Reader { tokens: tokens.get(..=range.end)?, text, is_macro };
    let (start, numbers) = body.statements(range.start)?;
    let formula = parse_part(&body.tokens[start..], text, false, is_macro)?;
    if start + formula.length != range.end {
        return None;
    }
    let (closed, numeric) = match formula.nodes.last()? {
        Node::Binary(..) | Node::Choice(..) => (false, true),
        Node::Name(name) => (true, numbers.contains(&formula.name(*name))),
        Node::Element(..) | Node::Macro(_) => (true, false),
        _ => (true, true),
    };
    Some(MacroResult { start, formula: Rc::new(formula), closed, numeric })
}

impl Reader<'_> {
    /// Where declarations, conditionals and loops end, and the names that numbers were given to.
    fn statements(&self, mut at: usize) -> Option<(usize, Vec<Symbol>)> {
        let (mut depth, mut numbers) = (0_usize, Vec::new());
        loop {
            match self.kind(at)? {
                TokenKind::Directive(Directive::Local | Directive::Declare) => {
                    let (end, name, number) = self.behind_declaration(at + 1)?;
                    numbers.retain(|known| *known != name);
                    // What is declared in a branch may not be.
                    numbers.extend((number && depth == 0).then_some(name));
                    at = end;
                }
                TokenKind::Directive(
                    word @ (Directive::If
                    | Directive::Ifdef
                    | Directive::Ifndef
                    | Directive::While
                    | Directive::For
                    | Directive::Elseif),
                ) => {
                    depth += usize::from(word != Directive::Elseif);
                    at = self.brackets(at + 1, '(', ')')?;
                }
                TokenKind::Directive(Directive::Else) => at += 1,
                TokenKind::Directive(Directive::End) => {
                    depth = depth.checked_sub(1)?;
                    at += 1;
                }
                TokenKind::Directive(_) => return None,
                _ => return (depth == 0).then_some((at, numbers)),
            }
        }
    }

    /// Behind `NAME [ indices ] = value ;`, the name, and whether it is surely a number then.
    fn behind_declaration(&self, at: usize) -> Option<(usize, Symbol, bool)> {
        let TokenKind::Name(name) = self.kind(at)? else { return None };
        let mut equals = at + 1;
        while self.is(equals, '[') {
            equals = self.brackets(equals, '[', ']')?;
        }
        self.is(equals, '=').then_some(())?;
        let formula = parse_part(&self.tokens[equals + 1..], self.text, false, self.is_macro);
        let end = match &formula {
            Some(formula) => equals + 1 + formula.length,
            None => self.braceless(equals + 1)?,
        };
        // A second semicolon is one that the macro yields, or forgiven: left to the tokens.
        (self.is(end, ';') && !self.is(end + 1, ';')).then_some(())?;
        let alone = equals == at + 1;
        let number = formula.is_some_and(|f| match f.nodes.last() {
            Some(Node::Name(_) | Node::Element(..) | Node::Macro(_)) => false,
            root => root.is_some(),
        });
        Some((end + 1, name, alone && number))
    }

    /// The `;` behind a value that begins with a built-in word and has neither braces nor directives.
    fn braceless(&self, start: usize) -> Option<usize> {
        matches!(self.kind(start)?, TokenKind::Keyword(_) | TokenKind::Punct('<' | '(')).then_some(())?;
        let mut at = start;
        loop {
            match self.kind(at)? {
                TokenKind::Punct(';') => return Some(at),
                TokenKind::Punct('{') | TokenKind::Directive(_) => return None,
                _ => at += 1,
            }
        }
    }

    /// Behind the bracket that closes the one at `at`; no directives between them.
    fn brackets(&self, mut at: usize, open: char, close: char) -> Option<usize> {
        self.is(at, open).then_some(())?;
        let mut depth = 0_usize;
        loop {
            match self.kind(at)? {
                TokenKind::Punct(c) if c == open => depth += 1,
                TokenKind::Punct(c) if c == close => depth -= 1,
                TokenKind::Directive(_) => return None,
                _ => {}
            }
            at += 1;
            if depth == 0 {
                return Some(at);
            }
        }
    }
}
