//! Operands of trees: literals, names with what stands behind them, calls.

use super::{MAX_INDICES, Parsed, Parser, Width};
use crate::syntax::built_in::{BuiltIn, Gives, Takes};
use crate::syntax::expression::component;
use crate::syntax::formula::{Demand, List, MacroCall, Node};
use crate::syntax::vectors::read_vector;
use crate::syntax::{Keyword, Symbol, TokenKind};

impl Parser<'_> {
    pub(super) fn operand_with_component(&mut self) -> Parsed {
        let (start, first) = (self.at, self.names.len());
        let skip = self.has_component().then(|| self.skip());
        let (node, width) = match self.peek() {
            Some(TokenKind::Name(name)) => {
                self.at += 1;
                self.name(name, start)?
            }
            _ => self.operand()?,
        };
        if !self.accept('.') {
            return Some((node, width));
        }
        let token = self.at as u16;
        let index = self.component()?;
        self.settle_names(first, Demand::Either);
        Some((self.skipped_to(Node::ComponentOf(node, index, token), skip?), Width::Float))
    }

    /// Whether a dot stands behind the operand that comes next, which is no variable.
    fn has_component(&self) -> bool {
        let kind = |at: usize| self.tokens.get(at).map(|t| t.kind);
        let (mut depth, mut at) = (0_usize, self.at);
        // A name or word stands before its bracket; a vector ends where no parenthesis is open.
        if matches!(kind(at), Some(TokenKind::Name(_) | TokenKind::Keyword(_))) {
            at += 1;
        }
        let in_vector = kind(at) == Some(TokenKind::Punct('<'));
        while let Some(kind) = kind(at) {
            match kind {
                TokenKind::Punct('(' | '[') => depth += 1,
                TokenKind::Punct(')' | ']') => depth = depth.saturating_sub(1),
                _ => {}
            }
            at += 1;
            if depth == 0 && (!in_vector || kind == TokenKind::Punct('>')) {
                break;
            }
        }
        // More indices may follow.
        kind(at) == Some(TokenKind::Punct('.')) || kind(at) == Some(TokenKind::Punct('['))
    }

    fn component(&mut self) -> Option<u8> {
        let TokenKind::Keyword(word) = self.peek()? else { return None };
        self.at += 1;
        component(word)
    }

    /// What stands behind a name decides what it must be.
    fn name(&mut self, name: Symbol, token: usize) -> Parsed {
        match self.peek()? {
            TokenKind::Punct('(') if (self.is_macro)(name) => self.macro_call(name, token as u16),
            TokenKind::Punct('.') => {
                self.at += 1;
                let index = self.component()?;
                let operand = self.demand(name, 0, Demand::Component(index));
                Some((self.leaf(Node::Component(operand)), Width::Float))
            }
            TokenKind::Punct('[') => {
                let mut indices = Vec::new();
                while self.accept('[') {
                    indices.push(self.float(Self::sum)?);
                    if !self.accept(']') {
                        return None;
                    }
                }
                if indices.len() > MAX_INDICES {
                    return None;
                }
                let list = self.list(&indices);
                let operand = self.variable(name, list.n);
                Some((self.parent(Node::Element(operand, list, token as u16), indices[0]), Width::Float))
            }
            TokenKind::Punct('(') => {
                let arguments = self.arguments()?;
                if self.peek() == Some(TokenKind::Punct('.')) {
                    return None;
                }
                self.demand(name, 0, Demand::Function(arguments.n));
                let first = self.formula.lists[usize::from(arguments.start)];
                Some((self.parent(Node::CallName(name, arguments), first), Width::Float))
            }
            _ => {
                let operand = self.variable(name, 0);
                Some((self.leaf(Node::Name(operand)), Width::Float))
            }
        }
    }

    /// `( value, value … )` behind the name of a macro.
    fn macro_call(&mut self, name: Symbol, token: u16) -> Parsed {
        let skip = self.skip();
        let mut items = Vec::new();
        self.accept('(').then_some(())?;
        while !self.accept(')') {
            if !items.is_empty() && !self.accept(',') || items.len() == usize::from(u8::MAX) {
                return None;
            }
            let first = self.names.len();
            let outside = std::mem::replace(&mut self.numeric, false);
            let (item, _) = self.sum()?;
            self.numeric = outside;
            let alone = matches!(self.node(item), Node::Name(_) | Node::Element(..));
            self.settle_names(first, if alone { Demand::Reference } else { Demand::Either });
            items.push(item);
        }
        // These would belong to the last token of the macro.
        if matches!(self.peek(), Some(TokenKind::Punct('.' | '[' | '('))) {
            return None;
        }
        let arguments = self.list(&items);
        let index = u16::try_from(self.formula.calls.len()).ok()?;
        self.formula.calls.push(MacroCall { name, arguments, token, whole: false, numeric: self.numeric });
        Some((self.skipped_to(Node::Macro(index), skip), Width::Unknown))
    }

    /// `( float, float … )`.
    fn arguments(&mut self) -> Option<List> {
        self.accept('(').then_some(())?;
        let mut items = vec![self.float(Self::sum)?];
        while self.accept(',') {
            items.push(self.float(Self::sum)?);
        }
        let closed = self.accept(')') && items.len() <= usize::from(u8::MAX);
        closed.then(|| self.list(&items))
    }

    /// `( vector, … )`, so many of them and then so many floats.
    fn vector_arguments(&mut self, n_vectors: usize, n_floats: usize) -> Option<List> {
        self.accept('(').then_some(())?;
        let mut items = Vec::new();
        for i in 0..n_vectors + n_floats {
            if i > 0 {
                self.accept(',').then_some(())?;
            }
            let float = i >= n_vectors;
            let item = if float { self.float(Self::sum)? } else { self.operand_of(Demand::Either, Self::sum)?.0 };
            items.push(item);
        }
        self.accept(')').then(|| self.list(&items))
    }

    fn operand(&mut self) -> Parsed {
        let kind = self.peek()?;
        let token = self.at;
        self.at += 1;
        match kind {
            TokenKind::Number(value) => Some((self.leaf(Node::Constant(value)), Width::Float)),
            TokenKind::Punct('(') => {
                let (node, width) = self.full()?;
                self.accept(')').then(|| (self.parent(Node::Group(node), node), width))
            }
            TokenKind::Punct('<') => self.vector(),
            TokenKind::Vectors => {
                let span = self.tokens[token].span;
                let (v, n, end) = read_vector(self.text, span.start as usize);
                let whole = end >= span.end as usize && n <= 3;
                whole.then(|| (self.leaf(Node::Axes([v[0], v[1], v[2]], n)), Width::Vector))
            }
            TokenKind::Keyword(word) => self.built_in(word, token as u16),
            _ => None,
        }
    }

    fn vector(&mut self) -> Parsed {
        let mut items = Vec::new();
        while items.len() < 5 && self.peek()? != TokenKind::Punct('>') {
            items.push(self.float(Self::sum)?);
            if items.len() < 5 {
                self.accept(',');
            }
        }
        if items.len() < 2 || !self.accept('>') {
            return None;
        }
        let list = self.list(&items);
        Some((self.parent(Node::Vector(list), items[0]), Width::Vector))
    }

    /// Other functions than these are better read token by token: they have effects, or take what no tree holds.
    fn built_in(&mut self, word: Keyword, token: u16) -> Parsed {
        let built_in = BuiltIn::in_values(word)?;
        let arguments = match built_in.takes {
            Takes::Number(value) => return Some((self.leaf(Node::Constant(value)), Width::Float)),
            Takes::Axis([x, y, z, _], n @ ..=3) => {
                return Some((self.leaf(Node::Axes([x, y, z], n)), Width::Vector));
            }
            Takes::Vectors(n_vectors, n_floats) => {
                let skip = self.skip();
                let arguments = self.vector_arguments(n_vectors, n_floats)?;
                let width = if built_in.gives == Gives::Float { Width::Float } else { Width::Vector };
                return Some((self.skipped_to(Node::VectorCall(word, arguments, token), skip), width));
            }
            Takes::Float => {
                self.accept('(').then_some(())?;
                let argument = self.float(Self::full)?;
                self.accept(')').then(|| self.list(&[argument]))?
            }
            Takes::TwoFloats => self.arguments().filter(|a| a.n == 2)?,
            Takes::Floats => self.arguments()?,
            Takes::Choice => self.arguments().filter(|a| a.n == 3 || a.n == 4)?,
            Takes::Axis(..) | Takes::State | Takes::Other(_) => return None,
        };
        let first = self.formula.lists[usize::from(arguments.start)];
        Some((self.parent(Node::Call(word, arguments, token), first), Width::Float))
    }
}
