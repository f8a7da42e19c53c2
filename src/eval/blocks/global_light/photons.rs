//! `photons` of `global_settings`.

use super::super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::scene::{GatherRadius, PhotonFile, Photons};
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(in crate::eval::blocks) static PHOTONS: Block<Photons> = Block::new(
    "photons",
    "in global_settings: light that is carried to where glass and mirrors throw it",
    &[
        Item::new(K::Spacing, Takes::Float(|p| &mut p.spacing), "1", "distance between photons on targets"),
        Item::new(
            K::Count,
            Takes::Other("INTEGER", |e, p, _| {
                p.count = Some(e.float()? as u32).filter(|n| *n > 0);
                Ok(())
            }),
            "0",
            "how many are shot, instead of spacing",
        ),
        Item::new(
            K::Gather,
            Takes::Other("INTEGER, INTEGER", gathered),
            "20, 100",
            "photons that are put together, at least and at most",
        ),
        Item::new(
            K::Media,
            Takes::Other("INTEGER [, FLOAT]", photon_media),
            "",
            "steps in media, and factor of the distance between them",
        ),
        Item::new(K::Jitter, Takes::Float(|p| &mut p.jitter), "0.4", "how much directions are moved at random"),
        Item::new(
            K::MaxTraceLevel,
            Takes::Other("INTEGER", |e, p, _| {
                p.max_trace_level = Some(e.float()?.trunc()).filter(|v| *v >= 0.0).map(|v| v as u32);
                Ok(())
            }),
            "-1",
            "how often photons are mirrored or bent, if 0 or more",
        ),
        Item::new(
            K::AdcBailout,
            Takes::Other("FLOAT", |e, p, _| {
                p.adc_bailout = Some(e.float()?).filter(|v| *v >= 0.0);
                Ok(())
            }),
            "-1",
            "share of light below which photons are not followed, if 0 or more",
        ),
        Item::new(
            K::Autostop,
            Takes::Float(|p| &mut p.autostop),
            "0.5",
            "share of a target's directions that is tried before shooting may end without a hit",
        ),
        Item::new(
            K::ExpandThresholds,
            Takes::Other("FLOAT, INTEGER", expand_thresholds),
            "0.2, 35",
            "increase of density at which the radius grows on, and photons below which it does",
        ),
        Item::new(
            K::Radius,
            Takes::Other("[FLOAT] [, FLOAT] [, FLOAT] [, FLOAT]", gather_radii),
            "",
            "how far photons are gathered, and its factor; the same in media",
        ),
        Item::new(K::SaveFile, Takes::Other("STRING", photon_file), "", "where photons are saved"),
        Item::new(
            K::LoadFile,
            Takes::Other("STRING", photon_file),
            "",
            "where photons come from instead of being shot",
        ),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `photons`; every block starts anew.
    pub(in crate::eval::blocks) fn photon_settings(&mut self, span: Span) -> SourceResult<()> {
        self.open("photons")?;
        let mut photons = Photons { span, ..Photons::default() };
        while self.item_of(&PHOTONS, &mut photons)? {}
        self.close_of(&PHOTONS)?;
        let gathers = photons.gather[1] > 0;
        if !gathers {
            self.warn_here(Topic::Range, span, "photons are switched off, since none are to be gathered");
        }
        self.scene.settings.photons = gathers.then_some(photons);
        Ok(())
    }
}

/// `gather LEAST, LARGEST`.
fn gathered(e: &mut Evaluator<'_>, photons: &mut Photons, at: Word) -> SourceResult<()> {
    let least = e.float()?.trunc();
    e.comma()?;
    let largest = e.float()?.trunc();
    if least < 0.0 {
        return e.error(at.span, "the first number of gather must be 0 or more");
    }
    if least > largest {
        return e.error(at.span, "the first number of gather must not be above the second");
    }
    photons.gather = [least as u32, largest as u32];
    Ok(())
}

/// `radius [SURFACES] [, FACTOR] [, MEDIA] [, FACTOR]`; each may be left out.
fn gather_radii(e: &mut Evaluator<'_>, photons: &mut Photons, _: Word) -> SourceResult<()> {
    let mut given = [None; 4];
    for (i, number) in given.iter_mut().enumerate() {
        if i > 0 {
            e.comma()?;
        }
        if e.starts_expression()? {
            *number = Some(e.float()?);
        }
    }
    let radius = |length: Option<f64>, factor: Option<f64>| GatherRadius {
        length: length.filter(|v| *v > 0.0),
        factor: factor.unwrap_or(1.0),
    };
    photons.surface_radius = radius(given[0], given[1]);
    photons.media_radius = radius(given[2], given[3]);
    Ok(())
}

/// `expand_thresholds INCREASE, MINIMUM`.
fn expand_thresholds(e: &mut Evaluator<'_>, photons: &mut Photons, at: Word) -> SourceResult<()> {
    let increase = e.float()?;
    e.comma()?;
    let minimum = e.float()?.trunc();
    if increase < 0.0 || minimum < 0.0 {
        e.warn(Topic::Range, at.span, "numbers of expand_thresholds below 0 are taken for 0");
    }
    photons.expand_increase = increase.max(0.0);
    photons.expand_minimum = minimum as u32;
    Ok(())
}

/// `save_file NAME` or `load_file NAME`.
fn photon_file(e: &mut Evaluator<'_>, photons: &mut Photons, at: Word) -> SourceResult<()> {
    let name: Arc<str> = (&*e.string()?).into();
    let (file, other) = match at.word {
        K::SaveFile => (PhotonFile::Save(name), matches!(photons.file, Some(PhotonFile::Load(_)))),
        _ => (PhotonFile::Load(name), matches!(photons.file, Some(PhotonFile::Save(_)))),
    };
    if other {
        let message = format!("photons are either saved or loaded; this {} is what counts", at.word.word());
        e.warn(Topic::Ignored, at.span, message);
    }
    photons.file = Some(file);
    Ok(())
}

/// `media STEPS [, FACTOR]`.
fn photon_media(e: &mut Evaluator<'_>, photons: &mut Photons, at: Word) -> SourceResult<()> {
    let steps = e.float()?.trunc();
    if steps < 0.0 {
        return e.error(at.span, "media of photons takes 0 steps or more");
    }
    photons.media_steps = steps as u32;
    if e.starts_another()? {
        photons.media_factor = e.float()?;
    }
    if photons.media_factor.is_nan() || photons.media_factor <= 0.0 {
        return e.error(at.span, "the second number of photons' media must be above 0");
    }
    Ok(())
}
