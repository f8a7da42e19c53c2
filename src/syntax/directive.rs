//! The words that may follow `#`.

use super::Keyword;

/// A directive, by its word. Source: POV-Ray 3.7 manual, section 3.3.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Directive {
    Break,
    Case,
    Debug,
    Declare,
    Default,
    Else,
    Elseif,
    End,
    Error,
    Fclose,
    Fopen,
    For,
    If,
    Ifdef,
    Ifndef,
    Include,
    Local,
    Macro,
    Range,
    Read,
    Render,
    Statistics,
    Switch,
    Undef,
    Version,
    Warning,
    While,
    Write,
}

impl Directive {
    /// The directive of a word; other words lose their `#` (language facts, section 1).
    pub fn from_keyword(word: Keyword) -> Option<Self> {
        Some(match word {
            Keyword::Break => Self::Break,
            Keyword::Case => Self::Case,
            Keyword::Debug => Self::Debug,
            Keyword::Declare => Self::Declare,
            Keyword::Default => Self::Default,
            Keyword::Else => Self::Else,
            Keyword::Elseif => Self::Elseif,
            Keyword::End => Self::End,
            Keyword::Error => Self::Error,
            Keyword::Fclose => Self::Fclose,
            Keyword::Fopen => Self::Fopen,
            Keyword::For => Self::For,
            Keyword::If => Self::If,
            Keyword::Ifdef => Self::Ifdef,
            Keyword::Ifndef => Self::Ifndef,
            Keyword::Include => Self::Include,
            Keyword::Local => Self::Local,
            Keyword::Macro => Self::Macro,
            Keyword::Range => Self::Range,
            Keyword::Read => Self::Read,
            Keyword::Render => Self::Render,
            Keyword::Statistics => Self::Statistics,
            Keyword::Switch => Self::Switch,
            Keyword::Undef => Self::Undef,
            Keyword::Version => Self::Version,
            Keyword::Warning => Self::Warning,
            Keyword::While => Self::While,
            Keyword::Write => Self::Write,
            _ => return None,
        })
    }

    /// The word after `#`.
    pub fn word(self) -> &'static str {
        let found = Keyword::ALL.iter().find(|k| Self::from_keyword(**k) == Some(self));
        found.map_or("?", |k| k.word())
    }

    /// Whether an `#end` belongs to it.
    pub fn opens_block(self) -> bool {
        matches!(self, Self::If | Self::Ifdef | Self::Ifndef | Self::While | Self::For | Self::Switch | Self::Macro)
    }

    /// Whether it ends one branch of a block and begins another.
    pub(super) fn opens_branch(self) -> bool {
        self.ends_branch() && self != Self::End
    }

    /// Whether it ends the branch of a block it stands in.
    pub fn ends_branch(self) -> bool {
        matches!(self, Self::Else | Self::Elseif | Self::Case | Self::Range | Self::End)
    }
}
