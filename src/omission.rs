//! What may be left out of a scene without changing its picture, by name.
//!
//! Whatever is not done because this scene does not need it is an [`Omission`]: a layer below an opaque one, a part that
//! is taken away where nothing is, the question what a ray is inside of where nothing bends light. Each is counted
//! ([`Ledger`]), and each can be kept ([`Keep`]), which costs time or memory and changes no bit of the picture: so
//! anyone can see that it is right to leave it out.
//!
//! ```
//! use whitted::omission::{Keep, Ledger, Omission};
//! let mut ledger = Ledger::new(Keep::NONE.with(Omission::FlatMaps));
//! assert!(ledger.omits(Omission::CoveredLayers, 80) && !ledger.omits(Omission::FlatMaps, 100));
//! assert_eq!(ledger.of(Omission::CoveredLayers).bytes, 80);
//! ```

/// One kind of thing that is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omission {
    /// What was declared and is not used anywhere.
    Declarations,
    /// Objects that no ray sees.
    HiddenObjects,
    /// Solids of which nothing is left.
    EmptySolids,
    /// Parts of solids that take nothing away.
    IdleParts,
    /// Solids that have one part only.
    SinglePartSolids,
    /// Steps of patterns that move no point.
    IdentityWarps,
    /// Maps in which all colours are the same.
    FlatMaps,
    /// Layers of textures below an opaque one.
    CoveredLayers,
    /// Terms of finishes that are zero.
    FinishTerms,
    /// Textures of what is in the way to a light, in scenes of which none lets light through.
    ShadowTextures,
    /// Rays to lights that do not shine on a place: cones, tubes, fading.
    SpentLights,
    /// The question what a ray is inside of, where no interior bends or fades light.
    Interiors,
}

impl Omission {
    /// In the order in which a scene goes through them.
    pub const ALL: [Self; 12] = [
        Self::Declarations,
        Self::HiddenObjects,
        Self::EmptySolids,
        Self::IdleParts,
        Self::SinglePartSolids,
        Self::IdentityWarps,
        Self::FlatMaps,
        Self::CoveredLayers,
        Self::FinishTerms,
        Self::ShadowTextures,
        Self::SpentLights,
        Self::Interiors,
    ];

    /// What it is called on a command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Declarations => "declarations",
            Self::HiddenObjects => "hidden-objects",
            Self::EmptySolids => "empty-solids",
            Self::IdleParts => "idle-parts",
            Self::SinglePartSolids => "single-part-solids",
            Self::IdentityWarps => "identity-warps",
            Self::FlatMaps => "flat-maps",
            Self::CoveredLayers => "covered-layers",
            Self::FinishTerms => "finish-terms",
            Self::ShadowTextures => "shadow-textures",
            Self::SpentLights => "spent-lights",
            Self::Interiors => "interiors",
        }
    }

    /// What it is, in a few words.
    pub fn about(self) -> &'static str {
        match self {
            Self::Declarations => "declared objects and textures that nothing uses",
            Self::HiddenObjects => "objects that no ray sees",
            Self::EmptySolids => "solids of which nothing is left",
            Self::IdleParts => "parts of solids that take nothing away",
            Self::SinglePartSolids => "solids that have one part only",
            Self::IdentityWarps => "steps of patterns that move no point",
            Self::FlatMaps => "maps of a single colour",
            Self::CoveredLayers => "layers below an opaque one",
            Self::FinishTerms => "finishes without a term for lights or mirrors",
            Self::ShadowTextures => "textures that need not be looked up on the way to a light",
            Self::SpentLights => "lights with places where they do not shine",
            Self::Interiors => "interiors that no ray need know of",
        }
    }

    /// The one with such a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|omission| omission.name() == name)
    }
}

/// Which of them are not left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keep(u16);

impl Keep {
    /// Everything that can be left out is.
    pub const NONE: Self = Self(0);
    /// Nothing is left out.
    pub const ALL: Self = Self(u16::MAX);

    /// With one more.
    #[must_use]
    pub const fn with(self, omission: Omission) -> Self {
        Self(self.0 | 1 << omission as u16)
    }

    /// Whether it is kept.
    pub const fn holds(self, omission: Omission) -> bool {
        self.0 >> omission as u16 & 1 != 0
    }
}

/// How often something was found that is not needed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Found {
    /// How many.
    pub count: usize,
    /// The memory they would take, as far as it is theirs alone.
    pub bytes: usize,
}

/// What was found that is not needed, and whether it is left out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ledger {
    keep: Keep,
    found: [Found; Omission::ALL.len()],
}

impl Ledger {
    /// Of nothing so far.
    pub fn new(keep: Keep) -> Self {
        Self { keep, ..Self::default() }
    }

    /// What is kept.
    pub fn keep(&self) -> Keep {
        self.keep
    }

    /// Notes something that is not needed and would take so many bytes; whether to leave it out.
    pub fn omits(&mut self, omission: Omission, bytes: usize) -> bool {
        self.note(omission, Found { count: 1, bytes });
        !self.keep.holds(omission)
    }

    /// Notes several of them.
    pub fn note(&mut self, omission: Omission, more: Found) {
        let found = &mut self.found[omission as usize];
        *found = Found { count: found.count + more.count, bytes: found.bytes + more.bytes };
    }

    /// Takes in what another has noted.
    pub fn add(&mut self, other: &Self) {
        for omission in Omission::ALL {
            self.note(omission, other.of(omission));
        }
    }

    /// What was found of a kind.
    pub fn of(&self, omission: Omission) -> Found {
        self.found[omission as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_a_name_and_a_place_of_its_own() {
        for (i, omission) in Omission::ALL.into_iter().enumerate() {
            assert_eq!(omission as usize, i);
            assert_eq!(Omission::named(omission.name()), Some(omission));
            let kept = |other: Omission| Keep::NONE.with(omission).holds(other);
            assert!(Omission::ALL.into_iter().all(|other| kept(other) == (other == omission)));
            assert!(Keep::ALL.holds(omission) && !Keep::NONE.holds(omission));
        }
        assert_eq!(Omission::named("nothing"), None);
    }
}
