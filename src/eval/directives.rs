//! Which directive does what, and the blocks that `#end` closes.

use super::{Evaluator, Place};
use crate::diag::{Diagnostic, SourceResult, Span, Topic};
use crate::scene::Gamma;
use crate::syntax::{Directive, Keyword, Position, TokenKind};

/// A conditional or loop whose `#end` is still to come.
#[derive(Debug)]
pub(super) struct Block {
    pub(super) kind: BlockKind,
    /// The directive that opened it.
    pub(super) span: Span,
}

/// The sorts of block.
#[derive(Debug)]
pub(super) enum BlockKind {
    /// A branch of `#if` and its relatives is running.
    If {
        /// It is the `#else` branch.
        last: bool,
    },
    /// `#switch`; a case has matched, or none yet.
    Switch { value: f64, matched: bool },
    /// `#while`: the cursor's depth and where its condition stands.
    While { cursor: usize, condition: Position },
    /// `#for`.
    For(Box<ForLoop>),
}

/// A running `#for`.
#[derive(Debug)]
pub(super) struct ForLoop {
    pub(super) cursor: usize,
    pub(super) body: Position,
    pub(super) variable: Place,
    pub(super) end: f64,
    pub(super) step: f64,
}

impl Block {
    /// The word that opened it.
    pub(super) fn word(&self) -> &'static str {
        match self.kind {
            BlockKind::If { .. } => "if",
            BlockKind::Switch { .. } => "switch",
            BlockKind::While { .. } => "while",
            BlockKind::For { .. } => "for",
        }
    }
}

impl Evaluator<'_> {
    /// Runs a directive whose hash mark and word were just taken.
    pub(super) fn run_directive(&mut self, directive: Directive, span: Span) -> SourceResult<()> {
        let bare = std::mem::replace(&mut self.bare, false);
        let parentheses = std::mem::replace(&mut self.parentheses, 0);
        self.deeper()?;
        let case_wanted = std::mem::take(&mut self.case_wanted);
        if case_wanted && matches!(directive, Directive::Else | Directive::End) {
            return self.error(span, "a #switch needs at least one #case or #range");
        }
        let in_scene = self.feed.depth() == 1;
        if let Err(errors) = self.dispatch(directive, span) {
            return self.not_opened(directive.opens_block() && in_scene, span, errors);
        }
        self.case_wanted |= case_wanted && !matches!(directive, Directive::Case | Directive::Range);
        self.budget.shallower();
        self.bare = bare;
        self.parentheses = parentheses;
        Ok(())
    }

    /// Fails, and notes the directive whose `#end` would be one too many now.
    pub(super) fn not_opened<T>(&mut self, noted: bool, span: Span, errors: Vec<Diagnostic>) -> SourceResult<T> {
        if noted {
            self.unopened = Some(span);
        }
        Err(errors)
    }

    fn dispatch(&mut self, directive: Directive, span: Span) -> SourceResult<()> {
        match directive {
            Directive::Declare => self.declaration(false),
            Directive::Local => self.declaration(true),
            Directive::Undef => self.undefine(),
            Directive::If => self.run_if(span),
            Directive::Ifdef => self.run_ifdef(span, true),
            Directive::Ifndef => self.run_ifdef(span, false),
            Directive::Else => self.run_else(span),
            Directive::Elseif => self.run_elseif(span),
            Directive::Switch => self.run_switch(span),
            Directive::Case | Directive::Range => self.run_case(directive, span),
            Directive::While => self.run_while(span),
            Directive::For => self.run_for(span),
            Directive::End => self.run_end(span),
            Directive::Break => self.run_break(span),
            Directive::Macro => self.define_macro(span),
            Directive::Include => self.include(span),
            Directive::Version => self.set_version(span),
            Directive::Default => self.set_default(),
            Directive::Fopen => self.open_file(span),
            Directive::Fclose => self.close_file(),
            Directive::Read => self.read_file(span),
            Directive::Write => self.write_file(span),
            Directive::Debug | Directive::Render | Directive::Statistics | Directive::Warning | Directive::Error => {
                self.run_message(directive, span)
            }
        }
    }

    /// `declare`, `include`, `version` and `default` without a hash mark, tolerated at top level.
    pub(super) fn hashless_directive(&mut self) -> SourceResult<bool> {
        let directive = match self.keyword()? {
            Some(Keyword::Declare) => Directive::Declare,
            Some(Keyword::Include) => Directive::Include,
            Some(Keyword::Version) => Directive::Version,
            Some(Keyword::Default) => Directive::Default,
            _ => return Ok(false),
        };
        let span = self.span();
        if matches!(directive, Directive::Declare | Directive::Include) {
            self.warn_here(Topic::Syntax, span, format!("'{}' should have a # in front", directive.word()));
        }
        self.take();
        self.run_directive(directive, span)?;
        Ok(true)
    }

    /// `#version F`.
    fn set_version(&mut self, span: Span) -> SourceResult<()> {
        if let TokenKind::Name(name) = self.fill(true)?
            && &**self.names.words.word(name) == "unofficial"
        {
            self.take();
        }
        self.bare = true;
        let value = self.float()?;
        self.semicolon(false)?;
        let hundredths = (value * 100.0).round();
        if hundredths > 370.0 {
            self.report.give_up();
            return self.error(span, format!("version {value} is newer than 3.7, the newest that is supported"));
        }
        if !self.version_given && !self.scene.objects.is_empty() {
            self.warn(Topic::Version, span, "#version should be the first statement of a scene");
        }
        self.version = hundredths.max(0.0) as u32;
        self.version_given = true;
        self.scene.settings.version = self.version;
        if !self.defaults.gamma_given {
            self.scene.settings.gamma = Gamma::implied(self.version);
        }
        Ok(())
    }

    /// `#default { … }`.
    fn set_default(&mut self) -> SourceResult<()> {
        self.open("#default")?;
        self.default_block()?;
        self.close("#default")
    }

    /// `#debug`, `#warning`, `#error`, `#render`, `#statistics`.
    fn run_message(&mut self, directive: Directive, span: Span) -> SourceResult<()> {
        let text = self.string()?;
        let stream = match directive {
            Directive::Error => {
                self.report.give_up();
                return self.error(span, format!("#error: {}", text.trim_end()));
            }
            Directive::Warning => {
                let line = text.replace('\n', " ");
                self.warn(Topic::Scene, span, line.trim_end());
                return Ok(());
            }
            Directive::Debug => super::Stream::Debug,
            Directive::Render => super::Stream::Render,
            _ => super::Stream::Statistics,
        };
        self.world.say(stream, &text);
        Ok(())
    }
}
