//! Sorts of warnings, so that each can be switched off.

/// What a warning is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Topic {
    /// `#version` is missing or late.
    Version,
    /// Something that is not rendered yet.
    Unsupported,
    /// Something that has no effect where it stands.
    Ignored,
    /// A form of an earlier version of the language.
    Outdated,
    /// A number that lies outside of its range and is replaced.
    Range,
    /// A shape or transformation that degenerates.
    Geometry,
    /// A calculation without a finite result.
    Arithmetic,
    /// Punctuation that is missing and can be guessed.
    Syntax,
    /// Files that are not written, or are read in another way than meant.
    Files,
    /// What the scene itself says with `#warning`.
    Scene,
    /// What will take long to render.
    Cost,
}

impl Topic {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Version,
        Self::Unsupported,
        Self::Ignored,
        Self::Outdated,
        Self::Range,
        Self::Geometry,
        Self::Arithmetic,
        Self::Syntax,
        Self::Files,
        Self::Scene,
        Self::Cost,
    ];

    /// Its name in messages and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Version => "version",
            Self::Unsupported => "unsupported",
            Self::Ignored => "ignored",
            Self::Outdated => "outdated",
            Self::Range => "range",
            Self::Geometry => "geometry",
            Self::Arithmetic => "arithmetic",
            Self::Syntax => "syntax",
            Self::Files => "files",
            Self::Scene => "scene",
            Self::Cost => "cost",
        }
    }
}
