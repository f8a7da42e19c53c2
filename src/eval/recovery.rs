//! Going on behind an error, so that one run shows several.
//!
//! Reading goes on behind the top-level statement that went wrong: where its braces close, or, if they
//! never do, where a line begins like a statement. What the statement would have declared is noted, and errors that
//! only follow from its absence are not told. Errors that leave nothing to go on with (an include file that is
//! missing or wrong, a limit, `#error`) end the reading.

use super::Evaluator;
use super::blocks::is_object_keyword;
use super::directives::BlockKind;
use crate::diag::Diagnostic;
use crate::syntax::{Directive, Keyword, Position, Symbol, Token, TokenKind};

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
    /// Notes errors of the statement that began at `start` and goes behind it; false if that is the end.
    pub(super) fn recover(&mut self, start: Position, errors: Vec<Diagnostic>) -> bool {
        let named = errors.first().and_then(|e| e.span).map(|span| {
            let text = String::from_utf8_lossy(self.report.sources.bytes(span));
            self.names.words.intern(text.trim_start_matches(['#', ' ']))
        });
        self.report.fail(errors, named);
        if !self.report.goes_on() || self.feed.in_include() {
            return false;
        }
        self.back_to_the_scene() && self.skip_statement(start)
    }

    /// Leaves macros and loops; false if the file ends on the way.
    fn back_to_the_scene(&mut self) -> bool {
        (self.bare, self.case_wanted, self.parentheses) = (false, false, 0);
        self.budget.leave_all();
        for _ in 0..self.feed.leave_all() {
            self.names.pop();
        }
        if self.feed.depth() == 0 {
            return false;
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
        let found = self.feed.position();
        let mut search = Search::default();
        self.go_to(start);
        while self.feed.position() < found {
            let Some(token) = self.feed.raw(&mut self.names.words) else { return false };
            search.note(&token, self.is_misspelt(&token));
        }
        let closed = self.skip_to_its_end(&mut search, found == start);
        let went_on = closed || {
            self.go_to(found);
            self.skip_to_line_start()
        };
        self.report.miss(search.names);
        went_on
    }

    fn is_misspelt(&self, token: &Token) -> bool {
        matches!(token.kind, TokenKind::Name(_)) && self.report.sources.bytes(token.span).starts_with(b"#")
    }

    fn go_to(&mut self, position: Position) {
        self.feed.jump(position, &mut self.names.words);
    }

    /// Goes behind the brace or semicolon that ends a statement, or before the next one.
    fn skip_to_its_end(&mut self, search: &mut Search, mut at_start: bool) -> bool {
        loop {
            let before = self.feed.position();
            let Some(token) = self.feed.raw(&mut self.names.words) else { return false };
            let outside = search.braces == 0 && search.blocks == 0;
            match token.kind {
                TokenKind::Punct('}') if search.braces <= 1 && search.blocks == 0 => return true,
                TokenKind::Punct(';') if outside => return true,
                kind if outside && !at_start && begins_statement(kind) && self.feed.starts_line(&token) => {
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
            let before = self.feed.position();
            let Some(token) = self.feed.raw(&mut self.names.words) else { return false };
            if begins_statement(token.kind) && self.feed.starts_line(&token) {
                self.go_to(before);
                return true;
            }
        }
    }
}
