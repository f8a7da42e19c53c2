//! The feed of tokens: a stack of cursors over files and macro bodies, with one token held back.
//!
//! The innermost cursor yields tokens until it is exhausted, then the one below goes on.
//! A loop is a jump back within a cursor; an include or a macro call pushes one. What a directive or a name means is
//! the evaluator's business: tokens are given out as they stand.

mod cursor;
#[cfg(test)]
mod tests;

pub(super) use cursor::{Cursor, Literal, Role};

use crate::diag::{FileId, SourceMap, Span, Way};
use crate::syntax::formula::{Formula, Statement};
use crate::syntax::{Directive, Position, Source, Symbol, Token, TokenKind, Words};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Gives tokens one by one.
#[derive(Debug, Default)]
pub(super) struct Feed {
    cursors: Vec<Cursor>,
    /// The token held back, and whether directives and macros in front of it are done.
    ahead: Option<Token>,
    ready: bool,
    /// Components of the last literal vector that was fetched.
    literal: Literal,
    last_span: Span,
}

/// A token that was held back while something else is read.
#[derive(Debug)]
pub(super) struct Held(Option<Token>, bool);

/// What is held back.
impl Feed {
    /// The token held back, whatever has run in front of it.
    #[inline]
    pub(super) fn held(&self) -> Option<&Token> {
        self.ahead.as_ref()
    }

    /// The kind of the token held back, if all in front of it has run.
    #[inline]
    pub(super) fn ready(&self) -> Option<TokenKind> {
        match &self.ahead {
            Some(token) if self.ready => Some(token.kind),
            _ => None,
        }
    }

    /// Holds a token back; `ready` if all in front of it has run.
    #[inline]
    pub(super) fn hold(&mut self, token: Token, ready: bool) {
        self.ahead = Some(token);
        self.ready = ready;
    }

    /// Holds the next token back, if none is held and nothing has to run in front of it.
    #[inline]
    pub(super) fn hold_plain(&mut self) -> Option<TokenKind> {
        if self.ahead.is_some() {
            return None;
        }
        let token = *self.cursors.last_mut()?.plain_step()?;
        self.last_span = token.span;
        self.hold(token, true);
        Some(token.kind)
    }

    /// Takes the token held back.
    #[inline]
    pub(super) fn release(&mut self) -> Option<Token> {
        self.ready = false;
        self.ahead.take()
    }

    /// Lays the token held back aside.
    pub(super) fn set_aside(&mut self) -> Held {
        Held(self.ahead.take(), std::mem::replace(&mut self.ready, false))
    }

    /// Holds back again what was laid aside.
    pub(super) fn bring_back(&mut self, held: Held) {
        (self.ahead, self.ready) = (held.0, held.1);
    }

    /// Where the token held back stands, else the last one that was fetched.
    #[inline]
    pub(super) fn span(&self) -> Span {
        self.ahead.map_or(self.last_span, |token| token.span)
    }

    /// Where the last token stands that was fetched.
    #[inline]
    pub(super) fn last_span(&self) -> Span {
        self.last_span
    }

    /// Components of the last literal vector that was fetched.
    #[inline]
    pub(super) fn literal(&self) -> &Literal {
        &self.literal
    }
}

/// What comes next.
impl Feed {
    /// The next token as it stands; `None` where the innermost cursor is exhausted and has to be left.
    #[inline]
    pub(super) fn fetch(&mut self, words: &mut Words) -> Option<Token> {
        if let Some(cursor) = self.cursors.last_mut()
            && let Some(token) = cursor.quick_step()
        {
            self.last_span = token.span;
            return Some(*token);
        }
        self.fetch_slowly(words)
    }

    fn fetch_slowly(&mut self, words: &mut Words) -> Option<Token> {
        let end = Token { kind: TokenKind::End, span: self.last_span };
        let Some(cursor) = self.cursors.last_mut() else { return Some(end) };
        match cursor.step(words, &mut self.literal) {
            Some(token) => {
                self.last_span = token.span;
                Some(token)
            }
            None => cursor.fenced.then_some(end),
        }
    }

    /// The next token of the innermost cursor, without a trace of it.
    pub(super) fn raw(&mut self, words: &mut Words) -> Option<Token> {
        self.cursors.last_mut()?.step(words, &mut self.literal)
    }

    /// The directive that comes next, taken.
    #[inline]
    pub(super) fn directive(&mut self) -> Option<(Directive, Span)> {
        let (directive, span) = self.cursors.last_mut()?.directive()?;
        self.last_span = span;
        Some((directive, span))
    }

    /// Whether a token comes next, behind the one held back, that can be no part of an expression.
    #[inline]
    pub(super) fn ends_expression(&self) -> bool {
        self.cursors.last().is_some_and(Cursor::ends_expression)
    }

    /// The formula that comes next, the token held back being part of it, and the number of its first token.
    #[inline]
    pub(super) fn formula(&self, full: bool, is_macro: impl Fn(Symbol) -> bool) -> Option<(Rc<Formula>, usize)> {
        self.cursors.last()?.formula(self.ahead.as_ref(), full, is_macro)
    }

    /// Goes behind a formula whose first token may be held back.
    #[inline]
    pub(super) fn pass_formula(&mut self, formula: &Formula) {
        let held = usize::from(self.ahead.is_some());
        if let Some(cursor) = self.cursors.last_mut() {
            cursor.skip_tokens(formula.length - held);
        }
        self.release();
    }

    /// The statement that comes next, or begins so many tokens before, and the number of its first token; no token may be
    /// held back.
    #[inline]
    pub(super) fn statement(&self, before: usize, is_macro: impl Fn(Symbol) -> bool) -> Option<(Rc<Statement>, usize)> {
        self.cursors.last()?.statement(before, is_macro)
    }

    /// Reads literal vectors while more of them follow, the one held back first; the last one of a run stays, since an
    /// operator may come behind it.
    #[inline]
    pub(super) fn take_vectors(&mut self, n: usize, mut take: impl FnMut([f64; 5], u8)) {
        // The held back vector goes first, and only if a comma and another one follow it.
        let Some(cursor) = self.cursors.last_mut() else { return };
        if !cursor.more_vectors() {
            return;
        }
        let (v, width) = self.literal;
        take(v, width);
        cursor.take_vectors(n - 1, take);
        self.release();
    }
}

/// Where it stands.
impl Feed {
    /// Where the innermost cursor stands.
    #[inline]
    pub(super) fn position(&self) -> Position {
        self.cursors.last().map_or(Position::default(), Cursor::position)
    }

    /// Where the next statement begins: at the token held back, if there is one.
    pub(super) fn next_position(&self) -> Position {
        let mut next = self.position();
        next.index -= u32::from(self.ahead.is_some() && next.index > 0);
        next
    }

    /// The number of the token that comes next in the current piece, that held back included.
    pub(super) fn next_index(&self) -> usize {
        self.cursors.last().map_or(0, Cursor::index) - usize::from(self.ahead.is_some())
    }

    /// The place of a token of the current piece.
    pub(super) fn position_of(&self, index: usize) -> Position {
        Position { index: index as u32, ..self.position() }
    }

    /// Where a token of the current piece stands in its text.
    #[inline]
    pub(super) fn span_of(&self, index: usize) -> Span {
        self.cursors.last().map_or(self.last_span, |cursor| cursor.span_of(index))
    }

    /// Goes elsewhere in the innermost file or macro.
    #[inline]
    pub(super) fn jump(&mut self, to: Position, words: &mut Words) {
        if let Some(cursor) = self.cursors.last_mut() {
            cursor.jump(to, words);
        }
    }

    /// Lets that token of the current piece come next.
    #[inline]
    pub(super) fn go_on_at(&mut self, token: usize) {
        if let Some(cursor) = self.cursors.last_mut() {
            cursor.go_on_at(token);
        }
    }

    /// Skips to the directive that ends the current branch, which must stand in the same file or macro.
    #[inline]
    pub(super) fn skip_branch(&mut self, words: &mut Words) -> Option<Directive> {
        let cursor = self.cursors.last_mut()?;
        let (to, directive) = cursor.source.branch_end(cursor.position(), words).ok()?;
        if cursor.end.is_some_and(|end| to > end) {
            return None;
        }
        cursor.jump(to, words);
        Some(directive)
    }

    /// The malformed token that keeps a branch from being skipped, if there is one.
    #[cold]
    pub(super) fn bad_in_branch(&self, words: &mut Words) -> Option<Token> {
        let cursor = self.cursors.last()?;
        cursor.source.branch_end(cursor.position(), words).err()?
    }

    /// Whether a token of the innermost file begins a line.
    pub(super) fn starts_line(&self, token: &Token) -> bool {
        let before = |cursor: &Cursor| match token.span.start.checked_sub(1) {
            Some(before) => matches!(cursor.source.text().get(before as usize), Some(b'\n' | b'\r')),
            None => true,
        };
        self.cursors.last().is_some_and(before)
    }
}

/// Files and macros that are being read.
impl Feed {
    /// Lets the tokens of a file or macro come next.
    #[inline]
    pub(super) fn push(&mut self, cursor: Cursor) {
        self.cursors.push(cursor);
    }

    /// Leaves the innermost file or macro.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<Cursor> {
        self.cursors.pop()
    }

    /// How many are being read.
    #[inline]
    pub(super) fn depth(&self) -> usize {
        self.cursors.len()
    }

    /// The innermost one.
    #[inline]
    pub(super) fn innermost(&self) -> Option<&Cursor> {
        self.cursors.last()
    }

    /// The file of the innermost one.
    pub(super) fn source(&self) -> Option<&Rc<Source>> {
        self.cursors.last().map(|cursor| &cursor.source)
    }

    /// Fences the innermost one, so that its end is reported instead of going on below.
    pub(super) fn fence(&mut self, words: &mut Words) {
        if let Some(cursor) = self.cursors.last_mut() {
            cursor.enter(words);
            cursor.fenced = true;
        }
    }

    /// The depth below the innermost macro, and how many blocks were open there.
    pub(super) fn below_macro(&self) -> Option<(usize, usize)> {
        let at = self.cursors.iter().rposition(Cursor::is_macro)?;
        Some((at, self.cursors[at].blocks))
    }

    /// Whether the innermost of them, or one around it, reads an include file.
    pub(super) fn in_include(&self) -> bool {
        self.cursors.iter().any(|c| matches!(c.role, Role::Include | Role::Data))
    }

    /// Leaves all but the scene file, to which a token of its own goes back that is held; how many macros were left.
    pub(super) fn leave_all(&mut self) -> usize {
        let held = self.release().is_some() && self.cursors.len() == 1;
        let n_macros = self.cursors.iter().skip(1).filter(|c| c.is_macro()).count();
        self.cursors.truncate(1);
        if held && let Some(scene) = self.cursors.last_mut() {
            scene.step_back();
        }
        n_macros
    }

    /// The macro calls and includes that led here, innermost first, for messages.
    pub(super) fn trail(&self, words: &Words) -> Vec<(Span, String)> {
        /// More of a recursion's trail helps nobody.
        const MAX_TRAIL: usize = 8;
        let mut trail: Vec<(Span, String)> = Vec::new();
        for cursor in self.cursors.iter().rev() {
            let what = match cursor.role {
                Role::Macro(name) => format!("in macro '{}', called", words.word(name)),
                Role::Include => "in a file included".to_owned(),
                Role::Main | Role::Data => continue,
            };
            // A recursion is told once.
            if trail.len() < MAX_TRAIL && trail.last().is_none_or(|(span, _)| *span != cursor.call) {
                trail.push((cursor.call, what));
            }
        }
        trail
    }

    /// The file of the innermost one, as the calls on the way came to it; includes without a call around them are files by
    /// themselves.
    pub(super) fn read_as(&mut self, sources: &mut SourceMap) -> FileId {
        let known = self.cursors.iter().rposition(|cursor| cursor.read_as.is_some());
        for i in known.map_or(0, |i| i + 1)..self.cursors.len() {
            let (below, here) = self.cursors.split_at_mut(i);
            let (around, cursor) = (below.last(), &mut here[0]);
            let (file, call) = (cursor.source.file, cursor.call);
            // A call may begin in one macro's last token and end behind it.
            let caller = around.filter(|around| around.source.file == call.file).and_then(|around| around.read_as);
            let from = Span { file: caller.unwrap_or(call.file), ..call };
            cursor.read_as = Some(match cursor.role {
                Role::Macro(_) => sources.visit(file, Way::Call, from),
                Role::Include if from.file != call.file => sources.visit(file, Way::Include, from),
                Role::Include | Role::Main | Role::Data => file,
            });
        }
        self.cursors.last().and_then(|cursor| cursor.read_as).unwrap_or_default()
    }

    /// Folders of the files being read, innermost first, down to the scene's own.
    pub(super) fn folders(&self, sources: &SourceMap) -> Vec<PathBuf> {
        let mut folders: Vec<PathBuf> = Vec::new();
        for cursor in self.cursors.iter().rev() {
            let file = sources.file(cursor.source.file);
            if let Some(folder) = file.and_then(|f| Path::new(&f.name).parent())
                && !folders.iter().any(|f| f == folder)
            {
                folders.push(folder.to_owned());
            }
        }
        folders
    }
}
