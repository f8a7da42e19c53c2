//! `interior { … }` and `media { … }`.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::{Evaluator, Value};
use crate::scene::{Interior, Media};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// From this language version on, media use the newer defaults.
const VERSION_WITH_MEDIA_METHOD_3: u32 = 350;

pub(super) static INTERIOR: Block<Interior> = Block::moved(
    "interior",
    "what a solid is filled with",
    |_, interior, transform| interior.apply(transform),
    &[
        Item::new(K::Ior, Takes::Float(|i| &mut i.ior), "", "how strongly light is bent; 1.5 for glass"),
        Item::new(K::Caustics, Takes::Float(|i| &mut i.caustics), "0", "strength of faked caustics"),
        Item::since(350, K::Dispersion, Takes::Float(|i| &mut i.dispersion), "1", "ior of violet by that of red light"),
        Item::since(
            350,
            K::DispersionSamples,
            Takes::Other("INTEGER", |e, i, at| {
                let n = e.integer()?;
                if n < 2 {
                    return e.error(at.span, "dispersion_samples must be at least 2");
                }
                i.dispersion_samples = n.min(i64::from(u32::MAX)) as u32;
                Ok(())
            }),
            "7",
            "colours into which light is split",
        ),
        Item::new(
            K::FadeDistance,
            Takes::Float(|i| &mut i.fade_distance),
            "0",
            "the way after which half of the light is left",
        ),
        Item::new(
            K::FadePower,
            Takes::Float(|i| &mut i.fade_power),
            "0",
            "how light fades with the way; 1000 and more: exponentially",
        ),
        Item::spelt(K::FadeColour, K::FadeColor, Takes::Rgb(|i| &mut i.fade_color), "0", "what light fades to"),
        Item::new(K::Refraction, Takes::Float(|i| &mut i.refraction), "", "outdated: without effect"),
        Item::new(
            K::Media,
            Takes::Other("{ MEDIA }", |e, i, _| {
                let media = e.media_block()?;
                i.media.push(media);
                Ok(())
            }),
            "",
            "smoke, fire or haze that it is filled with; several add up",
        ),
    ],
);

pub(super) static MEDIA: Block<Media> = Block::moved(
    "media",
    "dust, smoke and fire",
    |_, media, transform| media.apply(transform),
    &[
        Item::new(K::Absorption, Takes::Rgb(|m| &mut m.absorption), "0", "light that is lost on a way of one unit"),
        Item::new(K::Emission, Takes::Rgb(|m| &mut m.emission), "0", "light that is given off on a way of one unit"),
        Item::new(
            K::Scattering,
            Takes::Other("{ TYPE, COLOUR [eccentricity FLOAT] [extinction FLOAT] }", scattering),
            "",
            "light of lights that is scattered on a way of one unit, and how it is spread",
        ),
        Item::new(
            K::Density,
            Takes::Other("{ DENSITY }", |e, m, _| {
                let density = e.density_block()?;
                m.density.push(Arc::new(density));
                Ok(())
            }),
            "",
            "how dense it is at each point; several are multiplied",
        ),
        Item::since(
            350,
            K::Method,
            Takes::Other("INTEGER", |e, m, at| {
                m.method = match e.integer()? {
                    n @ 1..=3 => n as u8,
                    n => return e.error(at.span, format!("there is no media method {n}; use 1, 2 or 3")),
                };
                Ok(())
            }),
            "3",
            "how it is sampled: 1 at random, 2 evenly, 3 adaptively",
        ),
        Item::new(
            K::Intervals,
            Takes::Other("INTEGER", |e, m, at| {
                m.intervals = at_least_one(e, at)?;
                Ok(())
            }),
            "1",
            "parts of a ray that are sampled by themselves",
        ),
        Item::new(
            K::Samples,
            Takes::Other("INTEGER [, INTEGER]", |e, m, at| {
                let min = at_least_one(e, at)?;
                e.comma()?;
                let max = if e.starts_expression()? { at_least_one(e, at)? } else { min };
                if max < min {
                    return e.error(at.span, "the largest number of samples is below the smallest");
                }
                m.samples = [min, max];
                Ok(())
            }),
            "10",
            "samples of each part, at least and at most",
        ),
        Item::since(
            350,
            K::AaLevel,
            Takes::Other("INTEGER", |e, m, at| {
                m.aa_level = at_least_one(e, at)?;
                Ok(())
            }),
            "3",
            "how often method 3 halves a step",
        ),
        Item::since(
            350,
            K::AaThreshold,
            Takes::Other("FLOAT", |e, m, at| {
                m.aa_threshold = e.float()?;
                if m.aa_threshold <= 0.0 {
                    return e.error(at.span, "aa_threshold must be positive");
                }
                Ok(())
            }),
            "0.1",
            "difference from which method 3 does so",
        ),
        Item::since(350, K::Jitter, Takes::Float(|m| &mut m.jitter), "0", "how much samples are moved at random"),
        Item::new(
            K::Confidence,
            Takes::Other("FLOAT", |e, m, at| {
                m.confidence = e.float()?;
                if !(0.0..1.0).contains(&m.confidence) {
                    return e.error(at.span, "confidence must be at least 0 and less than 1");
                }
                Ok(())
            }),
            "0.9",
            "how sure methods 1 and 2 must be to take no more samples",
        ),
        Item::new(K::Variance, Takes::Float(|m| &mut m.variance), "1/128", "how much samples may differ for that"),
        Item::new(K::Ratio, Takes::Float(|m| &mut m.ratio), "0.9", "share of samples in lit parts of a ray"),
        Item::since(350, K::Collect, Takes::Switch(|m| &mut m.collect), "on", "whether photons are kept in it"),
    ],
);

/// What scatters.
pub(super) static SCATTERING: Block<Scattering> = Block::new(
    "scattering",
    "light that media throw aside",
    &[
        Item::new(
            K::Eccentricity,
            Takes::Other("FLOAT", |e, scattering, at| {
                scattering.eccentricity = e.float()?;
                if scattering.kind != 5 {
                    return e.error(at.span, "eccentricity belongs to scattering type 5");
                }
                Ok(())
            }),
            "0",
            "type 5: above 0 more light goes on, below 0 more goes back",
        ),
        Item::new(
            K::Extinction,
            Takes::Float(|scattering| &mut scattering.extinction),
            "1",
            "how much of what is thrown aside is lost on the way",
        ),
    ],
);

/// `scattering` while it is being read.
pub(super) struct Scattering {
    kind: i64,
    eccentricity: f64,
    extinction: f64,
}

impl Evaluator<'_> {
    /// `{ … }` after `interior`, changing what the object has already.
    pub(super) fn interior_block(&mut self, start: Option<Arc<Interior>>) -> SourceResult<Interior> {
        let span = self.span();
        self.open("interior")?;
        let pick = |v: &Value| if let Value::Interior(i) = v { Some(i.clone()) } else { None };
        let known = self.take_declared(pick)?.or(start);
        let mut interior = known.map_or_else(Interior::default, |i| (*i).clone());
        interior.span = span;
        loop {
            self.comma()?;
            if !self.item_of(&INTERIOR, &mut interior)? {
                break;
            }
        }
        self.close_of(&INTERIOR)?;
        Ok(interior)
    }

    /// What a `media` block starts from under the version in force.
    fn default_media(&self, span: Span) -> Media {
        let media = Media::new(span);
        match self.version {
            VERSION_WITH_MEDIA_METHOD_3.. => media,
            _ => Media { method: 1, intervals: 10, samples: [1, 1], ..media },
        }
    }

    /// `{ … }` after `media`.
    pub(super) fn media_block(&mut self) -> SourceResult<Media> {
        let span = self.span();
        self.open("media")?;
        let pick = |v: &Value| if let Value::Media(m) = v { Some((**m).clone()) } else { None };
        let known = self.take_declared(pick)?;
        let mut media = known.unwrap_or_else(|| self.default_media(span));
        media.span = span;
        loop {
            self.comma()?;
            if !self.item_of(&MEDIA, &mut media)? {
                break;
            }
        }
        self.close_of(&MEDIA)?;
        Ok(media)
    }
}

fn at_least_one(e: &mut Evaluator<'_>, at: Word) -> SourceResult<u32> {
    match e.integer()? {
        n if n >= 1 => Ok(n.min(i64::from(u32::MAX)) as u32),
        _ => e.error(at.span, format!("{} must be at least 1", at.word.word())),
    }
}

fn scattering(e: &mut Evaluator<'_>, media: &mut Media, _: Word) -> SourceResult<()> {
    e.open("scattering")?;
    let span = e.span();
    let mut kind = e.integer()?;
    if !(1..=5).contains(&kind) {
        e.warn(Topic::Range, span, format!("there is no scattering type {kind}; type 1 is used"));
        kind = 1;
    }
    e.comma()?;
    let color = e.rgb_only("scattering")?;
    let mut scattering = Scattering { kind, eccentricity: 0.0, extinction: 1.0 };
    e.comma()?;
    e.items_of(&SCATTERING, &mut scattering)?;
    media.scattering = (kind as u8, color, scattering.eccentricity, scattering.extinction);
    e.close_of(&SCATTERING)
}
