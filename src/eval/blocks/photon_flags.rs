//! `photons { … }` of an object or a light.

use super::table::{Block, Item, Takes};
use crate::diag::SourceResult;
use crate::eval::Evaluator;
use crate::scene::PhotonFlags;
use crate::syntax::Keyword as K;

pub(super) static PHOTONS: Block<PhotonFlags> = Block::new(
    "photons",
    "in an object or light: what photons do there",
    &[
        Item::new(
            K::Target,
            Takes::Other("[FLOAT]", |e, flags, _| {
                flags.target = Some(if e.starts_expression()? { e.float()? } else { 1.0 });
                Ok(())
            }),
            "",
            "photons are aimed at it; the number is a factor of their distance",
        ),
        Item::new(
            K::Refraction,
            Takes::Other("BOOL", |e, flags, _| {
                flags.refraction = Some(e.float()? > 0.0);
                Ok(())
            }),
            "",
            "whether photons go through it, or are shot at what is bent",
        ),
        Item::new(
            K::Reflection,
            Takes::Other("BOOL", |e, flags, _| {
                flags.reflection = Some(e.float()? > 0.0);
                Ok(())
            }),
            "",
            "whether it mirrors photons, or they are shot at what mirrors",
        ),
        Item::new(
            K::Collect,
            Takes::Other("[BOOL]", |e, flags, _| {
                flags.collect = Some(e.optional_bool()?);
                Ok(())
            }),
            "",
            "whether photons stay on it",
        ),
        Item::new(
            K::PassThrough,
            Takes::Switch(|flags| &mut flags.pass_through),
            "",
            "photons go on to what is behind it",
        ),
        Item::new(K::AreaLight, Takes::Switch(|flags| &mut flags.area_light), "", "photons come from the whole grid"),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `photons` of an object or light.
    pub(super) fn photons_block(&mut self, mut flags: PhotonFlags) -> SourceResult<PhotonFlags> {
        self.open("photons")?;
        self.items_of(&PHOTONS, &mut flags)?;
        self.close_of(&PHOTONS)?;
        Ok(flags)
    }
}
