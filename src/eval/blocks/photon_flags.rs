//! `photons { … }` of an object or a light.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::scene::PhotonFlags;
use crate::syntax::Keyword as K;

pub(super) static PHOTONS: Block<PhotonFlags> = Block::new(
    "photons",
    "in an object or light: what photons do there",
    &[
        Item::new(
            K::Target,
            Takes::Other("[FLOAT]", |e, flags, at| {
                flags.target = Some(if e.starts_expression()? { e.float()? } else { 1.0 });
                pass_or_refract(e, flags, at);
                Ok(())
            }),
            "",
            "photons are aimed at it; the number is a factor of their distance",
        ),
        Item::new(
            K::Refraction,
            Takes::Other("BOOL", |e, flags, at| {
                flags.refraction = Some(e.float()? > 0.0);
                pass_or_refract(e, flags, at);
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
            Takes::Other("[BOOL]", |e, flags, at| {
                flags.pass_through = e.optional_bool()?;
                pass_or_refract(e, flags, at);
                Ok(())
            }),
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

/// A target cannot let photons pass and bend them as well: of the words that ask for both, the last decides.
///
/// Source: photon facts, section 1 (measured).
fn pass_or_refract(e: &mut Evaluator<'_>, flags: &mut PhotonFlags, last: Word) {
    let is_target = flags.target.is_some_and(|spacing| spacing > 0.0);
    if !is_target || !flags.pass_through || flags.refraction == Some(false) {
        return;
    }
    let off = if last.word != K::PassThrough && flags.refraction == Some(true) {
        flags.pass_through = false;
        "pass_through"
    } else {
        flags.refraction = Some(false);
        "refraction"
    };
    let message = format!("a target of photons cannot have both pass_through and refraction; here {off} is off");
    e.warn(Topic::Ignored, last.span, message);
}
