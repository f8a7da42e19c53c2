//! `radiosity`, `photons` and `subsurface` of `global_settings`.
//!
//! Unlike in most blocks, POV-Ray takes no commas between these settings, and neither is one taken here.

mod photons;
mod radiosity;
#[cfg(test)]
mod tests;

pub(super) use photons::PHOTONS;
pub(super) use radiosity::RADIOSITY;

use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Span};
use crate::eval::Evaluator;
use crate::scene::Subsurface;
use crate::syntax::Keyword as K;

pub(super) static SUBSURFACE: Block<Subsurface> = Block::new(
    "subsurface",
    "in global_settings: how light below surfaces is looked for",
    &[
        Item::new(
            K::Samples,
            Takes::Other("INTEGER, INTEGER", |e, s, _| {
                let often = e.integer()?;
                e.comma()?;
                s.samples = [often, e.integer()?].map(up_to_u32);
                Ok(())
            }),
            "50, 50",
            "samples of light that is scattered often, and once",
        ),
        Item::new(
            K::Radiosity,
            Takes::Other("BOOL", |e, s, _| switch(e).map(|on| s.radiosity = on)),
            "off",
            "whether it is lit by radiosity",
        ),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `subsurface`; goes on from earlier blocks.
    pub(super) fn subsurface_settings(&mut self, span: Span) -> SourceResult<()> {
        self.open("subsurface")?;
        let mut subsurface = self.scene.settings.subsurface.unwrap_or_default();
        subsurface.span = span;
        while self.item_of(&SUBSURFACE, &mut subsurface)? {}
        self.close_of(&SUBSURFACE)?;
        self.scene.settings.subsurface = Some(subsurface);
        Ok(())
    }

    /// Whether another number follows, past a comma if there is one.
    fn starts_another(&mut self) -> SourceResult<bool> {
        self.comma()?;
        self.starts_expression()
    }
}

/// `on`, `off` or a number behind a word; numbers count as POV-Ray counts them here, without their fraction.
fn switch(e: &mut Evaluator<'_>) -> SourceResult<bool> {
    Ok(e.float()?.trunc() != 0.0)
}

/// As many as there can be.
fn up_to_u32(n: i64) -> u32 {
    n.clamp(0, i64::from(u32::MAX)) as u32
}
