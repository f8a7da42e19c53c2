//! Going on behind an error, so that one run shows several.
//!
//! Reading goes on behind the top-level statement that went wrong: where its braces close, or, if they
//! never do, where a line begins like a statement. What the statement would have declared is noted, and errors that
//! only follow from its absence are not told. Errors that leave nothing to go on with (an include file that is
//! missing or wrong, a limit, `#error`) end the reading.

use super::blocks::is_object_keyword;
use super::cursor::Cursor;
use super::directives::BlockKind;
use super::{Evaluator, Role};
use crate::diag::Diagnostic;
use crate::syntax::{Directive, Keyword, Position, Symbol, Token, TokenKind};
use std::rc::Rc;

/// More errors than this are more than anyone mends at a time.
const MAX_ERRORS: usize = 10;

/// Where the search for the end of a statement stands.
#[derive(Default)]
struct Search {
    /// Braces that are open.
    braces: usize,
    /// Conditionals, loops and macros that began behind the error and are open.
    blocks: usize,
    /// What the tokens behind `#declare` and its like are called.
    names: Vec<Symbol>,
    naming: bool,
}

impl Search {
    /// Counts a token; `misspelt` if it is a hash mark with a word that is no directive.
    fn note(&mut self, token: &Token, misspelt: bool) {
        match token.kind {
            TokenKind::Punct('{') => self.braces += 1,
            TokenKind::Punct('}') => self.braces = self.braces.saturating_sub(1),
            TokenKind::Name(name) if self.naming => self.names.push(name),
            _ => {}
        }
        self.naming = misspelt || matches!(token.kind, TokenKind::Directive(d) if declares(d));
    }
}

fn declares(directive: Directive) -> bool {
    matches!(directive, Directive::Declare | Directive::Local | Directive::Macro)
}

/// Whether a statement may begin with this, at the start of a line.
fn begins_statement(kind: TokenKind) -> bool {
    match kind {
        TokenKind::Directive(d) => declares(d) || matches!(d, Directive::Include | Directive::Default),
        TokenKind::Keyword(word) => {
            is_object_keyword(word)
                || matches!(word, Keyword::Camera | Keyword::Background | Keyword::GlobalSettings | Keyword::SkySphere)
        }
        _ => false,
    }
}

impl Evaluator<'_> {
    /// Where the next statement of the scene file begins.
    pub(super) fn statement_start(&self) -> Position {
        let Some(cursor) = self.cursors.last() else { return Position::default() };
        let mut start = cursor.position();
        start.index -= u32::from(self.ahead.is_some() && start.index > 0);
        start
    }

    /// Notes errors of the statement that began at `start` and goes behind it; false if that is the end.
    pub(super) fn recover(&mut self, start: Position, errors: Vec<Diagnostic>) -> bool {
        let follows = self.follows(&errors);
        if !follows {
            self.errors.extend(errors);
        }
        let stop = self.given_up.get() || self.errors.len() >= MAX_ERRORS;
        if stop || self.cursors.iter().any(|c| matches!(c.role, Role::Include | Role::Data)) {
            return false;
        }
        self.back_to_the_scene() && self.skip_statement(start)
    }

    /// Whether the errors only follow from one that was told.
    fn follows(&mut self, errors: &[Diagnostic]) -> bool {
        let Some(span) = errors.first().and_then(|e| e.span) else { return false };
        let text = String::from_utf8_lossy(self.sources.bytes(span)).into_owned();
        let name = self.names.intern(text.trim_start_matches(['#', ' ']));
        self.undeclared_by_error.contains(&name) || self.errors.iter().any(|e| e.span == Some(span))
    }

    /// Leaves macros and loops; false if the file ends on the way.
    fn back_to_the_scene(&mut self) -> bool {
        let held = self.ahead.take().is_some() && self.cursors.len() == 1;
        self.ready = false;
        (self.bare, self.case_wanted) = (false, false);
        (self.parentheses, self.nesting, self.macro_depth) = (0, 0, 0);
        while self.cursors.len() > 1 {
            let cursor = self.cursors.pop();
            if cursor.is_some_and(|c| c.is_macro()) {
                self.scopes.pop();
            }
        }
        let Some(scene) = self.cursors.last_mut() else { return false };
        if held {
            scene.step_back();
        }
        if let Some(span) = self.unopened.take()
            && self.skip_block(span).is_err()
        {
            return false;
        }
        let loops = |kind: &BlockKind| matches!(kind, BlockKind::While { .. } | BlockKind::For(_));
        let Some(outermost) = self.open_blocks.iter().position(|b| loops(&b.kind)) else { return true };
        while self.open_blocks.len() > outermost {
            let Some(block) = self.open_blocks.pop() else { break };
            if self.skip_block(block.span).is_err() {
                return false;
            }
        }
        true
    }

    /// Goes from where an error was found to the end of the statement; false at the end of the file.
    fn skip_statement(&mut self, start: Position) -> bool {
        let found = self.cursors.last().map_or(start, Cursor::position);
        let mut search = Search::default();
        self.go_to(start);
        while self.cursors.last().is_some_and(|c| c.position() < found) {
            let Some(token) = self.raw() else { return false };
            search.note(&token, self.is_misspelt(&token));
        }
        let closed = self.skip_to_its_end(&mut search, found == start);
        let went_on = closed || {
            self.go_to(found);
            self.skip_to_line_start()
        };
        self.undeclared_by_error.extend(search.names);
        went_on
    }

    /// The next token of the scene file as it stands.
    fn raw(&mut self) -> Option<Token> {
        self.cursors.last_mut()?.step(&mut self.names, &mut self.literal)
    }

    fn is_misspelt(&self, token: &Token) -> bool {
        matches!(token.kind, TokenKind::Name(_)) && self.sources.bytes(token.span).starts_with(b"#")
    }

    fn go_to(&mut self, position: Position) {
        if let Some(scene) = self.cursors.last_mut() {
            scene.jump(position, &mut self.names);
        }
    }

    /// Goes behind the brace or semicolon that ends a statement, or before the next one.
    fn skip_to_its_end(&mut self, search: &mut Search, mut at_start: bool) -> bool {
        loop {
            let Some(before) = self.cursors.last().map(Cursor::position) else { return false };
            let Some(token) = self.raw() else { return false };
            let outside = search.braces == 0 && search.blocks == 0;
            match token.kind {
                TokenKind::Punct('}') if search.braces <= 1 && search.blocks == 0 => return true,
                TokenKind::Punct(';') if outside => return true,
                kind if outside && !at_start && begins_statement(kind) && self.starts_line(&token) => {
                    self.go_to(before);
                    return true;
                }
                TokenKind::Directive(d) if outside && !at_start && declares(d) => {
                    self.go_to(before);
                    return true;
                }
                TokenKind::Directive(d) if !self.pass_directive(d, search) => return false,
                _ => {}
            }
            at_start = false;
            search.note(&token, self.is_misspelt(&token));
        }
    }

    /// Keeps track of conditionals while statements are skipped; false if an `#end` belongs to nothing.
    fn pass_directive(&mut self, directive: Directive, search: &mut Search) -> bool {
        if directive.opens_block() {
            search.blocks += 1;
        } else if directive == Directive::End && search.blocks > 0 {
            search.blocks -= 1;
        } else if directive == Directive::End {
            return self.open_blocks.pop().is_some();
        } else if directive.ends_branch() && search.blocks == 0 {
            // The branch that ran is over.
            return match self.open_blocks.pop() {
                Some(block) => self.skip_block(block.span).is_ok(),
                None => false,
            };
        }
        true
    }

    /// Goes to the next line that begins like a statement.
    fn skip_to_line_start(&mut self) -> bool {
        loop {
            let Some(before) = self.cursors.last().map(Cursor::position) else { return false };
            let Some(token) = self.raw() else { return false };
            if begins_statement(token.kind) && self.starts_line(&token) {
                self.go_to(before);
                return true;
            }
        }
    }

    fn starts_line(&self, token: &Token) -> bool {
        let source = self.cursors.last().map(|c| Rc::clone(&c.source));
        source.is_some_and(|source| match token.span.start.checked_sub(1) {
            Some(before) => matches!(source.text().get(before as usize), Some(b'\n' | b'\r')),
            None => true,
        })
    }
}
