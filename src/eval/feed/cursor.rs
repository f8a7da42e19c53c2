//! A place in a file or macro body, from which tokens are read.

use crate::diag::{FileId, Span};
use crate::syntax::formula::{Formula, Statement};
use crate::syntax::vectors::read_vector;
use crate::syntax::{Directive, Piece, Position, Source, Symbol, Token, TokenKind, Words};
use std::rc::Rc;

/// A place in a source, and how far to go.
#[derive(Debug)]
pub(in crate::eval) struct Cursor {
    pub(in crate::eval) source: Rc<Source>,
    tokens: Option<Rc<Piece>>,
    piece: u32,
    index: usize,
    /// Tokens of this piece that belong to the cursor.
    limit: usize,
    /// Where a macro body ends; the end of the file otherwise.
    pub(super) end: Option<Position>,
    run: Option<Run>,
    /// Its end is reported instead of going on below: a macro within a formula.
    pub(in crate::eval) fenced: bool,
    pub(in crate::eval) role: Role,
    /// How many blocks were open when it started.
    pub(in crate::eval) blocks: usize,
    /// What led here.
    pub(in crate::eval) call: Span,
    /// Its file as it was come to, once anybody has asked.
    pub(super) read_as: Option<FileId>,
}

/// Components of a literal vector, and how many there are.
pub(in crate::eval) type Literal = ([f64; 5], u8);

/// Literal vectors of which some are still to come.
#[derive(Clone, Copy, Debug)]
struct Run {
    at: usize,
    end: usize,
    comma: bool,
}

/// What a cursor reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::eval) enum Role {
    /// The scene file.
    Main,
    /// An include file.
    Include,
    /// A macro body.
    Macro(Symbol),
    /// A file opened by `#fopen`.
    Data,
}

impl Cursor {
    /// Over a file from its beginning, or over a macro body.
    pub(in crate::eval) fn new(source: Rc<Source>, range: (Position, Option<Position>), role: Role) -> Self {
        let (start, end) = range;
        Self {
            source,
            tokens: None,
            // Nothing is loaded yet; the first step loads piece `start.piece`.
            piece: start.piece,
            index: start.index as usize,
            limit: 0,
            end,
            run: None,
            fenced: false,
            role,
            blocks: 0,
            call: Span::default(),
            read_as: None,
        }
    }

    /// Where it stands.
    pub(in crate::eval) fn position(&self) -> Position {
        Position { piece: self.piece, index: self.index as u32 }
    }

    /// Which token of the current piece comes next.
    pub(in crate::eval) fn index(&self) -> usize {
        self.index
    }

    /// Lets the token that was read last come again.
    pub(in crate::eval) fn step_back(&mut self) {
        if self.run.is_none() {
            self.index = self.index.saturating_sub(1);
        }
    }

    /// Makes its first piece the current one.
    pub(in crate::eval) fn enter(&mut self, words: &mut Words) {
        if self.tokens.is_none() {
            self.load(self.piece, words);
        }
    }

    /// Whether it reads the body of a macro.
    pub(in crate::eval) fn is_macro(&self) -> bool {
        matches!(self.role, Role::Macro(_))
    }

    /// Goes somewhere else in the same source.
    pub(in crate::eval) fn jump(&mut self, to: Position, words: &mut Words) {
        self.run = None;
        self.index = to.index as usize;
        if to.piece != self.piece || self.tokens.is_none() {
            self.load(to.piece, words);
        }
    }

    /// Makes a piece the current one; false past the end.
    fn load(&mut self, piece: u32, words: &mut Words) -> bool {
        if self.end.is_some_and(|end| piece > end.piece) {
            return false;
        }
        let Some(tokens) = self.source.tokens(piece as usize, words) else { return false };
        self.piece = piece;
        self.limit = match self.end {
            Some(end) if end.piece == piece => tokens.tokens.len().min(end.index as usize),
            _ => tokens.tokens.len(),
        };
        self.tokens = Some(tokens);
        true
    }

    /// The next token, taken, if it stands in the current piece and `wanted` likes it.
    #[inline]
    fn step_if(&mut self, wanted: impl Fn(&Token) -> bool) -> Option<&Token> {
        if self.run.is_some() || self.index >= self.limit {
            return None;
        }
        let token = self.tokens.as_ref()?.tokens.get(self.index).filter(|token| wanted(token))?;
        self.index += 1;
        Some(token)
    }

    /// The next token, where that takes no more than reading it.
    #[inline]
    pub(super) fn quick_step(&mut self) -> Option<&Token> {
        self.step_if(|token| !matches!(token.kind, TokenKind::Vectors | TokenKind::Bad(_)))
    }

    /// The next token, where nothing has to run in front of it.
    #[inline]
    pub(in crate::eval) fn plain_step(&mut self) -> Option<&Token> {
        self.step_if(|token| match token.kind {
            TokenKind::Number(_) | TokenKind::String | TokenKind::Keyword(_) | TokenKind::OrEqual(_) => true,
            TokenKind::Punct(c) => c != '#',
            _ => false,
        })
    }

    /// Whether a token comes next that can be no part of an expression, with nothing to run in front of it.
    #[inline]
    pub(in crate::eval) fn ends_expression(&self) -> bool {
        let ends =
            |token: &Token| matches!(token.kind, TokenKind::Punct(',' | ';' | '{' | '}') | TokenKind::Keyword(_));
        let next = self.tokens.as_ref().and_then(|piece| piece.tokens.get(self.index));
        self.run.is_none() && self.index < self.limit && next.is_some_and(ends)
    }

    /// The next token, taken, if it is a directive in the current piece.
    #[inline]
    pub(in crate::eval) fn directive(&mut self) -> Option<(Directive, Span)> {
        let token = self.step_if(|token| matches!(token.kind, TokenKind::Directive(_)))?;
        let TokenKind::Directive(directive) = token.kind else { return None };
        Some((directive, token.span))
    }

    /// The next token; `None` at the end. For a literal vector its components go to `literal`.
    pub(in crate::eval) fn step(&mut self, words: &mut Words, literal: &mut Literal) -> Option<Token> {
        loop {
            if let Some(token) = self.step_run(literal) {
                return Some(token);
            }
            if self.index < self.limit
                && let Some(piece) = &self.tokens
            {
                let token = piece.tokens[self.index];
                self.index += 1;
                if token.kind != TokenKind::Vectors {
                    return Some(token);
                }
                self.run = Some(Run { at: token.span.start as usize, end: token.span.end as usize, comma: false });
            } else if self.tokens.is_none() {
                let (piece, index) = (self.piece, self.index);
                if !self.load(piece, words) {
                    return None;
                }
                self.index = index;
                if self.index >= self.limit && !self.advance_piece(words) {
                    return None;
                }
            } else if !self.advance_piece(words) {
                return None;
            }
        }
    }

    fn advance_piece(&mut self, words: &mut Words) -> bool {
        let loaded = self.load(self.piece + 1, words);
        if loaded {
            self.index = 0;
        }
        loaded
    }

    /// The next token of a run of vectors: a vector or the comma behind it.
    #[inline]
    fn step_run(&mut self, literal: &mut Literal) -> Option<Token> {
        let run = self.run.as_mut()?;
        let start = run.at as u32;
        let span = |end: usize| Span { file: self.source.file, start, end: end as u32 };
        if run.comma {
            let text = self.source.text();
            let next = text[run.at..run.end].iter().position(|b| *b == b'<').map(|n| run.at + n);
            run.comma = false;
            match next {
                Some(next) => run.at = next,
                None => {
                    self.run = None;
                    return None;
                }
            }
            return Some(Token { kind: TokenKind::Punct(','), span: span(start as usize + 1) });
        }
        let (components, n, end) = read_vector(&self.source.text()[..run.end], run.at);
        *literal = (components, n);
        run.at = end;
        run.comma = true;
        let token = Token { kind: TokenKind::Vector, span: span(end) };
        if end >= run.end {
            self.run = None;
        }
        Some(token)
    }

    /// The formula that begins with the held back token, or else with the next one, and the
    /// index of its first token.
    #[inline]
    pub(in crate::eval) fn formula(
        &self,
        held: Option<&Token>,
        full: bool,
        is_macro: impl Fn(Symbol) -> bool,
    ) -> Option<(Rc<Formula>, usize)> {
        let piece = self.tokens.as_ref()?;
        if self.run.is_some() {
            return None;
        }
        let start = match held {
            None => self.index,
            // What is held back may come from elsewhere: the end of a macro, say.
            Some(held) => {
                let before = self.index.checked_sub(1)?;
                if piece.tokens.get(before)?.span != held.span {
                    return None;
                }
                before
            }
        };
        if start >= self.limit {
            return None;
        }
        Some((piece.formula(start, full, self.source.text(), &is_macro)?, start))
    }

    /// The statement that comes next, or begins so many tokens before; and the index of its first token.
    #[inline]
    pub(in crate::eval) fn statement(
        &self,
        before: usize,
        is_macro: impl Fn(Symbol) -> bool,
    ) -> Option<(Rc<Statement>, usize)> {
        let (piece, start) = (self.tokens.as_ref()?, self.index.checked_sub(before)?);
        if start >= self.limit || self.run.is_some() {
            return None;
        }
        let statement = piece.statement(start, self.source.text(), &is_macro)?;
        // Behind a macro's last statement its caller goes on, maybe with a semicolon.
        (start + statement.length < self.limit).then_some((statement, start))
    }

    /// Lets that token of the current piece come next.
    pub(in crate::eval) fn go_on_at(&mut self, token: usize) {
        self.index = token;
    }

    /// Goes past tokens of the current piece.
    pub(in crate::eval) fn skip_tokens(&mut self, n: usize) {
        self.index += n;
    }

    /// Where a token of the current piece stands.
    pub(in crate::eval) fn span_of(&self, index: usize) -> Span {
        let token = self.tokens.as_ref().and_then(|piece| piece.tokens.get(index));
        token.map_or(Span { file: self.source.file, start: 0, end: 0 }, |t| t.span)
    }

    /// Whether another literal vector of the current run follows.
    pub(in crate::eval) fn more_vectors(&self) -> bool {
        self.run.is_some()
    }

    /// Reads up to `n` literal vectors without making tokens of them; how many there were.
    ///
    /// Must be called where a vector, or the comma before one, comes next.
    pub(in crate::eval) fn take_vectors(&mut self, n: usize, mut take: impl FnMut([f64; 5], u8)) -> usize {
        let Some(run) = self.run else { return 0 };
        let text = Rc::clone(&self.source);
        let text = &text.text()[..run.end];
        let (mut at, mut taken) = (run.at, 0);
        let mut ended = false;
        while taken < n {
            let Some(start) = text[at..].iter().position(|b| *b == b'<') else {
                ended = true;
                break;
            };
            let (components, width, end) = read_vector(text, at + start);
            take(components, width);
            taken += 1;
            at = end;
        }
        self.run = (!ended && at < run.end).then_some(Run { at, comma: true, ..run });
        taken
    }
}
