//! `radiosity` of `global_settings`.

use super::super::table::{Block, Item, Takes, Word};
use super::{switch, up_to_u32};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::scene::Radiosity;
use crate::syntax::Keyword as K;

/// Before this version the block alone did not switch radiosity on.
const VERSION_WITH_RADIOSITY_ON: u32 = 350;

const ABOVE_0: Rule = ("above 0", |v| v > 0.0);
const FRACTION: Rule = ("above 0 and at most 1", |v| v > 0.0 && v <= 1.0);
const TO_20: Rule = ("1 to 20", |v| (1.0..21.0).contains(&v));

/// What a number must be, in words.
type Rule = (&'static str, fn(f64) -> bool);

pub(in crate::eval::blocks) static RADIOSITY: Block<Radiosity> = Block::new(
    "radiosity",
    "light between surfaces",
    &[
        Item::new(
            K::Count,
            Takes::Other("INTEGER [, INTEGER]", sample_directions),
            "35",
            "rays by which light is gathered at a place; and directions that they are chosen from",
        ),
        Item::new(
            K::NearestCount,
            Takes::Other("INTEGER [, INTEGER]", nearest_count),
            "5",
            "places that are blended; and how many are enough for the pretrace",
        ),
        Item::new(
            K::ErrorBound,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, ABOVE_0).map(|v| r.error_bound = v)),
            "1.8",
            "how far a place serves its neighbours; smaller is finer",
        ),
        Item::new(
            K::LowErrorFactor,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, ABOVE_0).map(|v| r.low_error_factor = v)),
            "0.5",
            "factor of error_bound in the pretrace",
        ),
        Item::new(
            K::MinimumReuse,
            Takes::Other("FLOAT", |e, r, at| {
                ruled(e, at, ("at least 0", |v| v >= 0.0)).map(|v| r.minimum_reuse = Some(v))
            }),
            "",
            "smallest reach of a place, as a share of the picture's width",
        ),
        Item::since(
            370,
            K::MaximumReuse,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, ABOVE_0).map(|v| r.maximum_reuse = Some(v))),
            "",
            "largest reach of a place, as a share of the picture's width",
        ),
        Item::new(
            K::PretraceStart,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, FRACTION).map(|v| r.pretrace_start = v)),
            "0.08",
            "size of blocks in the first pass, as a share of the picture's width",
        ),
        Item::new(
            K::PretraceEnd,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, FRACTION).map(|v| r.pretrace_end = v)),
            "0.04",
            "size of blocks in the last pass",
        ),
        Item::new(
            K::RecursionLimit,
            Takes::Other("INTEGER", |e, r, at| ruled(e, at, TO_20).map(|v| r.recursion_limit = v as u32)),
            "2",
            "how often light is scattered",
        ),
        Item::new(
            K::Brightness,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, ABOVE_0).map(|v| r.brightness = v)),
            "1",
            "factor of the light that is gathered",
        ),
        Item::new(
            K::GrayThreshold,
            Takes::Other("FLOAT", |e, r, at| {
                ruled(e, at, ("0 to 1", |v| (0.0..=1.0).contains(&v))).map(|v| r.gray_threshold = v)
            }),
            "0",
            "how much colours of gathered light are turned grey",
        ),
        Item::new(
            K::MaxSample,
            Takes::Other("FLOAT", |e, r, _| {
                r.max_sample = Some(e.float()?).filter(|v| *v > 0.0);
                Ok(())
            }),
            "-1",
            "brightest colour that a ray may bring, if above 0",
        ),
        Item::new(
            K::AdcBailout,
            Takes::Other("FLOAT", |e, r, at| ruled(e, at, ABOVE_0).map(|v| r.adc_bailout = v)),
            "0.01",
            "share of light below which it is not followed",
        ),
        Item::new(
            K::AlwaysSample,
            Takes::Other("BOOL", |e, r, _| switch(e).map(|on| r.always_sample = on)),
            "off",
            "whether light is gathered behind the pretrace",
        ),
        Item::new(
            K::Normal,
            Takes::Other("BOOL", |e, r, _| switch(e).map(|on| r.normal = on)),
            "off",
            "whether bumps count",
        ),
        Item::since(
            350,
            K::Media,
            Takes::Other("BOOL", |e, r, _| switch(e).map(|on| r.media = on)),
            "off",
            "whether media count",
        ),
        Item::since(
            370,
            K::Subsurface,
            Takes::Other("BOOL", |e, r, _| switch(e).map(|on| r.subsurface = on)),
            "off",
            "whether it lights subsurface materials",
        ),
        Item::new(K::LoadFile, Takes::Other("STRING", other_file), "", "without effect in a scene"),
        Item::new(K::SaveFile, Takes::Other("STRING", other_file), "", "without effect in a scene"),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `radiosity`; goes on from earlier blocks.
    pub(in crate::eval::blocks) fn radiosity_settings(&mut self, span: Span) -> SourceResult<()> {
        self.open("radiosity")?;
        if self.version < VERSION_WITH_RADIOSITY_ON {
            let message = "since version 3.5 a radiosity block switches radiosity on by itself";
            self.warn_here(Topic::Version, span, message);
        }
        let mut radiosity = self.scene.settings.radiosity.take().unwrap_or_default();
        radiosity.span = span;
        while self.item_of(&RADIOSITY, &mut radiosity)? {}
        self.close_of(&RADIOSITY)?;
        self.scene.settings.radiosity = Some(radiosity);
        Ok(())
    }

    /// What settings of radiosity must be to each other, which is known once all blocks are read.
    pub(in crate::eval) fn check_radiosity(&mut self) -> SourceResult<()> {
        let Some(radiosity) = &self.scene.settings.radiosity else { return Ok(()) };
        let (span, [least, largest]) = (radiosity.span, radiosity.reuse());
        if radiosity.pretrace_end > radiosity.pretrace_start {
            return self.error(span, "pretrace_end must not be above pretrace_start");
        }
        if least >= largest {
            return self.error(span, "maximum_reuse must be above minimum_reuse");
        }
        let message = match (radiosity.minimum_reuse, radiosity.maximum_reuse) {
            (Some(_), Some(_)) if least > 0.5 * largest => "maximum_reuse should be twice minimum_reuse or more".into(),
            (Some(_), None) if largest > Radiosity::MAXIMUM_REUSE => {
                format!("maximum_reuse is raised to {largest}, twice minimum_reuse")
            }
            (None, Some(_)) if least < Radiosity::MINIMUM_REUSE => {
                format!("minimum_reuse is lowered to {least}, half of maximum_reuse")
            }
            _ => return Ok(()),
        };
        self.warn(Topic::Range, span, message);
        Ok(())
    }
}

/// `count RAYS [, DIRECTIONS]`.
fn sample_directions(e: &mut Evaluator<'_>, radiosity: &mut Radiosity, at: Word) -> SourceResult<()> {
    radiosity.count = ruled(e, at, ("at least 1", |v| v >= 1.0))? as u32;
    radiosity.directions = radiosity.count.max(1600);
    if e.starts_another()? {
        let directions = e.integer()?;
        if directions < i64::from(radiosity.count) {
            return e.error(at.span, "count of radiosity takes no more rays than directions");
        }
        radiosity.directions = up_to_u32(directions);
    }
    Ok(())
}

/// `nearest_count SAMPLES [, ENOUGH]`.
fn nearest_count(e: &mut Evaluator<'_>, radiosity: &mut Radiosity, at: Word) -> SourceResult<()> {
    radiosity.nearest_count = ruled(e, at, TO_20)? as u32;
    radiosity.enough_for_pretrace = 0;
    if e.starts_another()? {
        let enough = e.integer()?;
        if !(0..i64::from(radiosity.nearest_count)).contains(&enough) {
            return e.error(at.span, "the second number of nearest_count must be 0 or more and below the first");
        }
        radiosity.enough_for_pretrace = enough as u32;
    }
    Ok(())
}

/// A file that radiosity is kept in by other means.
fn other_file(e: &mut Evaluator<'_>, _: &mut Radiosity, at: Word) -> SourceResult<()> {
    e.string()?;
    let message = format!("{} of radiosity has no effect in a scene", at.word.word());
    e.warn(Topic::Ignored, at.span, message);
    Ok(())
}

/// The number behind a word of radiosity.
fn ruled(e: &mut Evaluator<'_>, at: Word, (rule, holds): Rule) -> SourceResult<f64> {
    let value = e.float()?;
    let word = at.word.word();
    if holds(value) { Ok(value) } else { e.error(at.span, format!("{word} of radiosity must be {rule}")) }
}
