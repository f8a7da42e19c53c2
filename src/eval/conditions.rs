//! `#if`, `#ifdef`, `#switch` and their branches.

use super::Evaluator;
use super::directives::{Block, BlockKind};
use super::expressions::{EPSILON, truth};
use super::feed::Role;
use crate::diag::{SourceResult, Span};
use crate::syntax::{Directive, Token, TokenKind};

impl Evaluator<'_> {
    pub(super) fn run_if(&mut self, span: Span) -> SourceResult<()> {
        let holds = truth(self.condition()?);
        self.choose(holds, span)
    }

    pub(super) fn run_ifdef(&mut self, span: Span, wanted: bool) -> SourceResult<()> {
        let defined = self.bracketed('(', "before the name", ')', "behind the name", Self::defined)?;
        self.choose(defined == wanted, span)
    }

    /// Runs the first branch, or the first further one whose condition holds.
    pub(super) fn choose(&mut self, mut holds: bool, span: Span) -> SourceResult<()> {
        let mut last = false;
        while !holds {
            match self.skip_branch(span)? {
                Directive::Elseif => holds = truth(self.condition()?),
                Directive::Else => (holds, last) = (true, true),
                Directive::End => return Ok(()),
                other => {
                    let word = other.word();
                    return self.error(self.feed.last_span(), format!("#{word} inside of an #if"));
                }
            }
        }
        self.open_blocks.push(Block { kind: BlockKind::If { last }, span });
        Ok(())
    }

    /// `#else` behind a branch that ran.
    pub(super) fn run_else(&mut self, span: Span) -> SourceResult<()> {
        match self.open_blocks.last().map(|b| &b.kind) {
            Some(BlockKind::If { last: false }) => self.end_branches(),
            Some(BlockKind::If { last: true }) => self.mismatched(span, "this #if already had its #else"),
            // Cases fall through into the #else of their #switch.
            Some(BlockKind::Switch { .. }) => Ok(()),
            _ => self.mismatched(span, "#else without an #if or #switch"),
        }
    }

    /// `#elseif` behind a branch that ran.
    pub(super) fn run_elseif(&mut self, span: Span) -> SourceResult<()> {
        match self.open_blocks.last().map(|b| &b.kind) {
            Some(BlockKind::If { last: false }) => self.end_branches(),
            Some(BlockKind::If { last: true }) => self.mismatched(span, "#elseif behind the #else of its #if"),
            _ => self.mismatched(span, "#elseif without an #if"),
        }
    }

    /// Leaves the innermost block past its remaining branches.
    pub(super) fn end_branches(&mut self) -> SourceResult<()> {
        match self.open_blocks.pop() {
            Some(block) => self.skip_block(block.span),
            None => Ok(()),
        }
    }

    pub(super) fn run_switch(&mut self, span: Span) -> SourceResult<()> {
        let value = self.condition()?;
        self.open_blocks.push(Block { kind: BlockKind::Switch { value, matched: false }, span });
        self.case_wanted = true;
        Ok(())
    }

    /// `#case` and `#range`: the first one of a `#switch`, or one that is fallen into.
    pub(super) fn run_case(&mut self, mut directive: Directive, span: Span) -> SourceResult<()> {
        let Some(Block { kind: BlockKind::Switch { value, matched }, .. }) = self.open_blocks.last() else {
            return self.mismatched(span, format!("#{} without a #switch", directive.word()));
        };
        let (value, fallen_into) = (*value, *matched);
        loop {
            let holds = match directive {
                Directive::Case => (self.condition()? - value).abs() < EPSILON,
                Directive::Range => self.arguments(|e| {
                    let low = e.float()?;
                    e.comma()?;
                    let high = e.float()?;
                    Ok(low <= value && value <= high)
                })?,
                Directive::Else => true,
                Directive::End => {
                    self.open_blocks.pop();
                    return Ok(());
                }
                other => return self.error(span, format!("#{} inside of a #switch", other.word())),
            };
            if holds || fallen_into {
                if let Some(Block { kind: BlockKind::Switch { matched, .. }, .. }) = self.open_blocks.last_mut() {
                    *matched = true;
                }
                return Ok(());
            }
            directive = self.skip_branch(span)?;
        }
    }

    /// Leaves the innermost loop, matched case or macro.
    pub(super) fn run_break(&mut self, span: Span) -> SourceResult<()> {
        let below = self.feed.below_macro();
        let floor = below.map_or(0, |(_, blocks)| blocks);
        while self.open_blocks.len() > floor {
            let Some(block) = self.open_blocks.pop() else { break };
            self.skip_block(block.span)?;
            if !matches!(block.kind, BlockKind::If { .. }) {
                return Ok(());
            }
        }
        let Some((depth, _)) = below else {
            return self.error(span, "#break outside of a loop, a #switch or a macro");
        };
        while self.feed.depth() > depth {
            self.leave_cursor()?;
        }
        Ok(())
    }

    /// Goes on below an exhausted cursor.
    pub(super) fn leave_cursor(&mut self) -> SourceResult<()> {
        let Some(cursor) = self.feed.innermost() else { return Ok(()) };
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
                self.budget.leave_macro();
                self.names.pop();
            }
            Role::Include => {
                self.budget.leave_include();
                self.names.pop();
            }
            Role::Data => {}
        }
        self.feed.pop();
        Ok(())
    }

    /// Skips to the directive that ends the current branch and returns it.
    pub(super) fn skip_branch(&mut self, opened: Span) -> SourceResult<Directive> {
        loop {
            if let Some(directive) = self.feed.skip_branch(&mut self.names.words) {
                return Ok(directive);
            }
            if let Some(Token { kind: TokenKind::Bad(what), span }) = self.feed.bad_in_branch(&mut self.names.words) {
                return self.error(span, what.message());
            }
            match self.feed.innermost().map(|cursor| cursor.role) {
                Some(Role::Include) => self.leave_cursor()?,
                Some(_) => return self.error(opened, "there is no #end that belongs to this"),
                None => return self.error(opened, "the file ends before the #end that belongs to this"),
            }
        }
    }

    /// Skips to the `#end` of the current block, past all its further branches.
    pub(super) fn skip_block(&mut self, opened: Span) -> SourceResult<()> {
        while self.skip_branch(opened)? != Directive::End {}
        Ok(())
    }
}
