//! One file as tokens, made when they are needed and kept while they are useful.

use super::formula::{self, Formula, Statement};
use super::lexer::tokenise;
use super::memo::Memo;
use super::{Directive, Symbol, Text, Token, TokenKind, Words};
use crate::diag::FileId;
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::Arc;

/// Pieces whose tokens are kept; beyond that the oldest are made again when needed.
const KEPT_PIECES: usize = 64;

/// A place between two tokens.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Position {
    /// Which piece.
    pub piece: u32,
    /// Which token of it.
    pub index: u32,
}

/// The file a cursor runs over.
#[derive(Debug)]
pub struct Source {
    /// Its number in the source map.
    pub file: FileId,
    text: Arc<Text>,
    parsed: RefCell<Parsed>,
}

/// The tokens of one piece of a file, and what was found among them.
#[derive(Debug)]
pub struct Piece {
    /// The tokens.
    pub tokens: Vec<Token>,
    /// Without and with comparisons.
    formulas: [RefCell<Memo<Formula>>; 2],
    statements: RefCell<Memo<Statement>>,
}

impl Piece {
    fn new(tokens: Vec<Token>) -> Self {
        Self { tokens, formulas: Default::default(), statements: RefCell::default() }
    }

    /// The formula that starts at a token, from the second time it is asked for; `is_macro` tells
    /// which names stand for macros.
    #[inline]
    pub fn formula(
        &self,
        start: usize,
        full: bool,
        text: &[u8],
        is_macro: &dyn Fn(Symbol) -> bool,
    ) -> Option<Rc<Formula>> {
        let find = || formula::parse(&self.tokens[start..], text, full, is_macro);
        self.formulas[usize::from(full)].borrow_mut().at(start, self.tokens.len(), find)
    }

    /// The same for the statement that a directive begins.
    #[inline]
    pub fn statement(&self, start: usize, text: &[u8], is_macro: &dyn Fn(Symbol) -> bool) -> Option<Rc<Statement>> {
        let TokenKind::Directive(directive) = self.tokens.get(start)?.kind else { return None };
        if !Statement::may_begin_with(directive) {
            return None;
        }
        let find = || Statement::parse(&self.tokens[start..], text, is_macro);
        self.statements.borrow_mut().at(start, self.tokens.len(), find)
    }
}

#[derive(Debug, Default)]
struct Parsed {
    /// Of the pieces that were met.
    ends: Vec<usize>,
    tokens: Vec<Option<Rc<Piece>>>,
    kept: VecDeque<usize>,
    /// Where the branch that starts at a position ends.
    branch_ends: FxHashMap<Position, (Position, Directive)>,
}

impl Parsed {
    /// Room for the tokens of another piece: that of the oldest, when enough are kept and nobody reads it. Memory
    /// that is given back gets mixed with what the scene keeps, and has to be touched anew elsewhere.
    fn room(&mut self) -> Vec<Token> {
        if self.kept.len() < KEPT_PIECES {
            return Vec::new();
        }
        let oldest = self.kept.pop_front().and_then(|index| self.tokens[index].take());
        oldest.and_then(Rc::into_inner).map_or_else(Vec::new, |piece| piece.tokens)
    }
}

impl Source {
    /// Over a file.
    pub fn new(file: FileId, text: Arc<Text>) -> Self {
        Self { file, text, parsed: RefCell::default() }
    }

    /// The bytes of the file.
    pub fn text(&self) -> &Arc<Vec<u8>> {
        self.text.bytes()
    }

    /// The tokens of piece number `index`; `None` past the end of the file.
    pub fn tokens(&self, index: usize, names: &mut Words) -> Option<Rc<Piece>> {
        if let Some(Some(tokens)) = self.parsed.borrow().tokens.get(index) {
            return Some(Rc::clone(tokens));
        }
        // A piece begins where the one before ends.
        let start = match index.checked_sub(1) {
            None => byte_order_mark(self.text()),
            Some(before) => self.end_of(before, names)?,
        };
        if start >= self.text().len() {
            return None;
        }
        let parsed = &mut *self.parsed.borrow_mut();
        let mut room = parsed.room();
        let end = match self.text.kept(index) {
            Some(kept) => kept.write(self.file, names, &mut room),
            None => {
                let end = tokenise(self.file, self.text(), start, names, &mut room);
                self.text.keep(index, &room, names, end);
                end
            }
        };
        if parsed.ends.len() == index {
            parsed.ends.push(end);
            parsed.tokens.push(None);
        }
        let tokens = Rc::new(Piece::new(room));
        parsed.tokens[index] = Some(Rc::clone(&tokens));
        parsed.kept.push_back(index);
        Some(tokens)
    }

    fn end_of(&self, piece: usize, names: &mut Words) -> Option<usize> {
        if self.parsed.borrow().ends.len() <= piece {
            self.tokens(piece, names)?;
        }
        self.parsed.borrow().ends.get(piece).copied()
    }

    /// The directive that ends the branch which starts at `start` (an `#else`, `#elseif`, `#case`,
    /// `#range` or `#end` of the same nesting) and the position behind it.
    ///
    /// # Errors
    /// The first malformed token on the way, or `None` if the file ends before.
    pub fn branch_end(&self, start: Position, names: &mut Words) -> Result<(Position, Directive), Option<Token>> {
        if let Some(known) = self.parsed.borrow().branch_ends.get(&start) {
            return Ok(*known);
        }
        let (mut at, mut depth) = (start, 0_usize);
        while let Some(tokens) = self.tokens(at.piece as usize, names) {
            for token in &tokens.tokens[(at.index as usize).min(tokens.tokens.len())..] {
                at.index += 1;
                match token.kind {
                    TokenKind::Directive(d) if d.opens_block() => depth += 1,
                    TokenKind::Directive(Directive::End) if depth > 0 => depth -= 1,
                    TokenKind::Directive(d) if depth == 0 && d.ends_branch() => {
                        self.parsed.borrow_mut().branch_ends.insert(start, (at, d));
                        return Ok((at, d));
                    }
                    TokenKind::Bad(_) => return Err(Some(*token)),
                    _ => {}
                }
            }
            at = Position { piece: at.piece + 1, index: 0 };
        }
        Err(None)
    }
}

/// Length of the leading bytes above 127, a byte order mark, which count as nothing.
fn byte_order_mark(text: &[u8]) -> usize {
    text.iter().take_while(|b| **b > 127).count()
}
