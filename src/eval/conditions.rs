//! `#if`, `#ifdef`, `#switch` and their branches.

use super::directives::{Block, BlockKind};
use super::expressions::{EPSILON, truth};
use super::{Evaluator, Role};
use crate::diag::{SourceResult, Span};
use crate::syntax::Directive;

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
                    return self.error(self.last_span, format!("#{word} inside of an #if"));
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
        let in_macro = self.cursors.iter().rposition(|c| matches!(c.role, Role::Macro(_)));
        let floor = in_macro.map_or(0, |i| self.cursors[i].blocks);
        while self.open_blocks.len() > floor {
            let Some(block) = self.open_blocks.pop() else { break };
            self.skip_block(block.span)?;
            if !matches!(block.kind, BlockKind::If { .. }) {
                return Ok(());
            }
        }
        let Some(depth) = in_macro else {
            return self.error(span, "#break outside of a loop, a #switch or a macro");
        };
        while self.cursors.len() > depth {
            self.leave_cursor()?;
        }
        Ok(())
    }
}
