//! Where tokens come from: a stack of cursors over files and macro bodies.
//!
//! The innermost cursor yields tokens until it is exhausted, then the one below goes on.
//! A loop is a jump back within a cursor; an include or a macro call pushes one.

use super::Evaluator;
use super::scope::{Scopes, TableId};
use crate::diag::{Diagnostic, SourceResult, Span};
use crate::syntax::formula::{Formula, Statement};
use crate::syntax::vectors::read_vector;
use crate::syntax::{Directive, Names, Piece, Position, Source, Symbol, Token, TokenKind};
use std::rc::Rc;

/// A place in a source, and how far to go.
#[derive(Debug)]
pub(super) struct Cursor {
    pub(super) source: Rc<Source>,
    tokens: Option<Rc<Piece>>,
    piece: u32,
    index: usize,
    /// Tokens of this piece that belong to the cursor.
    limit: usize,
    /// Where a macro body ends; the end of the file otherwise.
    end: Option<Position>,
    run: Option<Run>,
    /// Its end is reported instead of going on below: a macro within a formula.
    pub(super) fenced: bool,
    pub(super) role: Role,
    /// How many blocks were open when it started.
    pub(super) blocks: usize,
    /// What led here.
    pub(super) call: Span,
}

/// Literal vectors of which some are still to come.
#[derive(Clone, Copy, Debug)]
struct Run {
    at: usize,
    end: usize,
    comma: bool,
}

/// What a cursor reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
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
    pub(super) fn new(source: Rc<Source>, range: (Position, Option<Position>), role: Role) -> Self {
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
        }
    }

    /// Where it stands.
    pub(super) fn position(&self) -> Position {
        Position { piece: self.piece, index: self.index as u32 }
    }

    /// Which token of the current piece comes next.
    pub(super) fn index(&self) -> usize {
        self.index
    }

    /// Lets the token that was read last come again.
    pub(super) fn step_back(&mut self) {
        if self.run.is_none() {
            self.index = self.index.saturating_sub(1);
        }
    }

    /// Makes its first piece the current one.
    pub(super) fn enter(&mut self, names: &mut Names) {
        if self.tokens.is_none() {
            self.load(self.piece, names);
        }
    }

    /// Whether it reads the body of a macro.
    pub(super) fn is_macro(&self) -> bool {
        matches!(self.role, Role::Macro(_))
    }

    /// Goes somewhere else in the same source.
    pub(super) fn jump(&mut self, to: Position, names: &mut Names) {
        self.run = None;
        self.index = to.index as usize;
        if to.piece != self.piece || self.tokens.is_none() {
            self.load(to.piece, names);
        }
    }

    /// Makes a piece the current one; false past the end.
    fn load(&mut self, piece: u32, names: &mut Names) -> bool {
        if self.end.is_some_and(|end| piece > end.piece) {
            return false;
        }
        let Some(tokens) = self.source.tokens(piece as usize, names) else { return false };
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
    fn quick_step(&mut self) -> Option<&Token> {
        self.step_if(|token| !matches!(token.kind, TokenKind::Vectors | TokenKind::Bad(_)))
    }

    /// The next token, where nothing has to run in front of it.
    #[inline]
    pub(super) fn plain_step(&mut self) -> Option<&Token> {
        self.step_if(|token| match token.kind {
            TokenKind::Number(_) | TokenKind::String | TokenKind::Keyword(_) | TokenKind::OrEqual(_) => true,
            TokenKind::Punct(c) => c != '#',
            _ => false,
        })
    }

    /// Whether a token comes next that can be no part of an expression, with nothing to run in front of it.
    #[inline]
    pub(super) fn ends_expression(&self) -> bool {
        let ends =
            |token: &Token| matches!(token.kind, TokenKind::Punct(',' | ';' | '{' | '}') | TokenKind::Keyword(_));
        let next = self.tokens.as_ref().and_then(|piece| piece.tokens.get(self.index));
        self.run.is_none() && self.index < self.limit && next.is_some_and(ends)
    }

    /// The next token, taken, if it is a directive in the current piece.
    #[inline]
    pub(super) fn directive(&mut self) -> Option<(Directive, Span)> {
        let token = self.step_if(|token| matches!(token.kind, TokenKind::Directive(_)))?;
        let TokenKind::Directive(directive) = token.kind else { return None };
        Some((directive, token.span))
    }

    /// The next token; `None` at the end. For a literal vector its components go to `literal`.
    pub(super) fn step(&mut self, names: &mut Names, literal: &mut ([f64; 5], u8)) -> Option<Token> {
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
                if !self.load(piece, names) {
                    return None;
                }
                self.index = index;
                if self.index >= self.limit && !self.advance_piece(names) {
                    return None;
                }
            } else if !self.advance_piece(names) {
                return None;
            }
        }
    }

    fn advance_piece(&mut self, names: &mut Names) -> bool {
        let loaded = self.load(self.piece + 1, names);
        if loaded {
            self.index = 0;
        }
        loaded
    }

    /// The next token of a run of vectors: a vector or the comma behind it.
    #[inline]
    fn step_run(&mut self, literal: &mut ([f64; 5], u8)) -> Option<Token> {
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
    pub(super) fn formula(&self, held: Option<&Token>, full: bool, scopes: &Scopes) -> Option<(Rc<Formula>, usize)> {
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
        Some((piece.formula(start, full, self.source.text(), &|name| scopes.is_macro(name))?, start))
    }

    /// The statement that comes next, or begins so many tokens before; and the index of its first token.
    #[inline]
    pub(super) fn statement(&self, before: usize, scopes: &Scopes) -> Option<(Rc<Statement>, usize)> {
        let (piece, start) = (self.tokens.as_ref()?, self.index.checked_sub(before)?);
        if start >= self.limit || self.run.is_some() {
            return None;
        }
        let statement = piece.statement(start, self.source.text(), &|name| scopes.is_macro(name))?;
        // Behind a macro's last statement its caller goes on, maybe with a semicolon.
        (start + statement.length < self.limit).then_some((statement, start))
    }

    /// Lets that token of the current piece come next.
    pub(super) fn go_on_at(&mut self, token: usize) {
        self.index = token;
    }

    /// Goes past tokens of the current piece.
    pub(super) fn skip_tokens(&mut self, n: usize) {
        self.index += n;
    }

    /// Where a token of the current piece stands.
    pub(super) fn span_of(&self, index: usize) -> Span {
        let token = self.tokens.as_ref().and_then(|piece| piece.tokens.get(index));
        token.map_or(Span { file: self.source.file, start: 0, end: 0 }, |t| t.span)
    }

    /// Whether another literal vector of the current run follows.
    pub(super) fn more_vectors(&self) -> bool {
        self.run.is_some()
    }

    /// Reads up to `n` literal vectors without making tokens of them; how many there were.
    ///
    /// Must be called where a vector, or the comma before one, comes next.
    pub(super) fn take_vectors(&mut self, n: usize, mut take: impl FnMut([f64; 5], u8)) -> usize {
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

impl Evaluator<'_> {
    /// The next token before directives and macros are looked at.
    #[inline]
    pub(super) fn fetch(&mut self) -> SourceResult<Token> {
        if let Some(cursor) = self.cursors.last_mut()
            && let Some(token) = cursor.quick_step()
        {
            self.last_span = token.span;
            return Ok(*token);
        }
        self.fetch_slowly()
    }

    fn fetch_slowly(&mut self) -> SourceResult<Token> {
        loop {
            let Some(cursor) = self.cursors.last_mut() else {
                return Ok(Token { kind: TokenKind::End, span: self.last_span });
            };
            if let Some(token) = cursor.step(&mut self.names, &mut self.literal) {
                self.last_span = token.span;
                if let TokenKind::Bad(what) = token.kind {
                    return self.error(token.span, what.message());
                }
                return Ok(token);
            }
            if cursor.fenced {
                return Ok(Token { kind: TokenKind::End, span: self.last_span });
            }
            self.leave_cursor()?;
        }
    }

    /// Goes on below an exhausted cursor.
    pub(super) fn leave_cursor(&mut self) -> SourceResult<()> {
        let Some(cursor) = self.cursors.last() else { return Ok(()) };
        match cursor.role {
            Role::Main => {
                if let Some(open) = self.open_blocks.last() {
                    let (span, word) = (open.span, open.word());
                    return self.error(span, format!("the file ends before the #end of this #{word}"));
                }
            }
            Role::Macro(_) => {
                if let Some(open) = self.open_blocks.get(cursor.blocks) {
                    let (span, word) = (open.span, open.word());
                    return self.error(span, format!("the macro ends before the #end of this #{word}"));
                }
                self.macro_depth -= 1;
                self.scopes.pop();
            }
            Role::Include => {
                self.include_depth -= 1;
                self.scopes.pop();
            }
            Role::Data => {}
        }
        self.cursors.pop();
        Ok(())
    }

    /// Skips to the directive that ends the current branch and returns it.
    pub(super) fn skip_branch(&mut self, opened: Span) -> SourceResult<Directive> {
        loop {
            let Some(cursor) = self.cursors.last_mut() else {
                return self.error(opened, "the file ends before the #end that belongs to this");
            };
            match cursor.source.branch_end(cursor.position(), &mut self.names) {
                Ok((to, directive)) if cursor.end.is_none_or(|end| to <= end) => {
                    cursor.jump(to, &mut self.names);
                    return Ok(directive);
                }
                Err(Some(bad)) => {
                    let TokenKind::Bad(what) = bad.kind else { return self.error(bad.span, "malformed text") };
                    return self.error(bad.span, what.message());
                }
                Ok(_) | Err(None) => {
                    if !matches!(cursor.role, Role::Include) {
                        return self.error(opened, "there is no #end that belongs to this");
                    }
                    self.leave_cursor()?;
                }
            }
        }
    }

    /// Skips to the `#end` of the current block, past all its further branches.
    pub(super) fn skip_block(&mut self, opened: Span) -> SourceResult<()> {
        while self.skip_branch(opened)? != Directive::End {}
        Ok(())
    }

    /// Adds the macro calls and includes that led here, innermost first.
    pub(super) fn with_trace(&self, mut diagnostic: Diagnostic) -> Diagnostic {
        /// More of a recursion's trail helps nobody.
        const MAX_TRAIL: usize = 8;
        for cursor in self.cursors.iter().rev() {
            let what = match cursor.role {
                Role::Macro(name) => format!("in macro '{}', called", self.names.word(name)),
                Role::Include => "in a file included".to_owned(),
                Role::Main | Role::Data => continue,
            };
            // A recursion is told once.
            if diagnostic.trace.len() < MAX_TRAIL
                && diagnostic.trace.last().is_none_or(|(span, _)| *span != cursor.call)
            {
                diagnostic.trace.push((cursor.call, what));
            }
        }
        diagnostic
    }

    /// The table names are made in by `#local`.
    pub(super) fn local_table(&self) -> TableId {
        self.scopes.innermost()
    }
}
