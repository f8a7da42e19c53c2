//! `radiosity`, `photons` and `subsurface` of `global_settings`.
//!
//! Unlike in most blocks, POV-Ray takes no commas between these settings, and neither is one taken here.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::scene::{GatherRadius, PhotonFile, Photons, Radiosity, Subsurface};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// Before this version the block alone did not switch radiosity on.
const VERSION_WITH_RADIOSITY_ON: u32 = 350;

const ABOVE_0: Rule = ("above 0", |v| v > 0.0);
const FRACTION: Rule = ("above 0 and at most 1", |v| v > 0.0 && v <= 1.0);
const TO_20: Rule = ("1 to 20", |v| (1.0..21.0).contains(&v));

/// What a number must be, in words.
type Rule = (&'static str, fn(f64) -> bool);

pub(super) static RADIOSITY: Block<Radiosity> = Block::new(
    "radiosity",
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

pub(super) static PHOTONS: Block<Photons> = Block::new(
    "photons",
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

pub(super) static SUBSURFACE: Block<Subsurface> = Block::new(
    "subsurface",
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
    /// `{ … }` after `radiosity`; goes on from earlier blocks.
    pub(super) fn radiosity_settings(&mut self, span: Span) -> SourceResult<()> {
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

    /// `{ … }` after `photons`; every block starts anew.
    pub(super) fn photon_settings(&mut self, span: Span) -> SourceResult<()> {
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

/// `on`, `off` or a number behind a word; numbers count as POV-Ray counts them here, without their fraction.
fn switch(e: &mut Evaluator<'_>) -> SourceResult<bool> {
    Ok(e.float()?.trunc() != 0.0)
}

/// As many as there can be.
fn up_to_u32(n: i64) -> u32 {
    n.clamp(0, i64::from(u32::MAX)) as u32
}

#[cfg(test)]
mod tests {
    use crate::diag::{Severity, Span};
    use crate::eval::{Memory, NoQueries, Options, evaluate};
    use crate::scene::{GatherRadius, PhotonFile, Photons, Radiosity, Settings, Subsurface};

    /// What a scene's settings are, with its warnings; or its error.
    fn read(version: &str, text: &str) -> Result<(Settings, Vec<String>), String> {
        let text = format!("#version {version}; global_settings {{ assumed_gamma 1 {text} }} sphere {{ 0, 1 }}");
        let host = Memory::new([("a.pov", text.as_str())]);
        let said = |diagnostics: Vec<crate::diag::Diagnostic>, severity| -> Vec<String> {
            let wanted = diagnostics.into_iter().filter(|d| d.severity == severity);
            wanted.inspect(|d| assert!(d.span.is_some(), "{text}: {}", d.message)).map(|d| d.message).collect()
        };
        match evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries) {
            Ok(read) => Ok((read.scene.settings, said(read.warnings, Severity::Warning))),
            Err(failed) => Err(said(failed.diagnostics, Severity::Error).swap_remove(0)),
        }
    }

    /// Settings of radiosity that give these values, apart from their place.
    fn radiosity(text: &str, expected: Radiosity) {
        let found = read("3.7", text).map(|(s, _)| s.radiosity.map(|r| Radiosity { span: Span::default(), ..r }));
        assert_eq!(found, Ok(Some(expected)), "{text}");
    }

    /// The same of photons.
    fn photons(text: &str, expected: Photons) {
        let found = read("3.7", text).map(|(s, _)| s.photons.map(|p| Photons { span: Span::default(), ..p }));
        assert_eq!(found, Ok(Some(expected)), "{text}");
    }

    fn warns(text: &str, message: &str) {
        match read("3.7", text) {
            Ok((_, warnings)) => assert!(warnings.iter().any(|w| w.contains(message)), "{text}: {warnings:?}"),
            Err(error) => panic!("{text}: {error}"),
        }
    }

    fn fails(text: &str, message: &str) {
        let found = read("3.7", text).map(|_| ());
        assert!(found.as_ref().is_err_and(|error| error.contains(message)), "{text}: {found:?}");
    }

    /// What POV-Ray 3.7.0.10 takes; the defaults are those of its manual.
    #[test]
    fn radiosity_is_kept() {
        let default = Radiosity::default;
        assert!(read("3.7", "").is_ok_and(|(s, _)| s.radiosity.is_none() && s.photons.is_none()));
        radiosity("radiosity {}", default());
        radiosity("radiosity { count 10.7 }", Radiosity { count: 10, ..default() });
        radiosity("radiosity { count 2000 }", Radiosity { count: 2000, directions: 2000, ..default() });
        radiosity("radiosity { count 5.5 5 }", Radiosity { count: 5, directions: 5, ..default() });
        radiosity("radiosity { count 5, error_bound 1 }", Radiosity { count: 5, error_bound: 1.0, ..default() });
        let nearest = Radiosity { nearest_count: 20, enough_for_pretrace: 3, ..default() };
        radiosity("radiosity { nearest_count 20.9, 3 }", nearest);
        radiosity("radiosity { low_error_factor 2 }", Radiosity { low_error_factor: 2.0, ..default() });
        radiosity("radiosity { recursion_limit 20.5 }", Radiosity { recursion_limit: 20, ..default() });
        let factors = Radiosity { brightness: 3.0, gray_threshold: 1.0, adc_bailout: 2.0, ..default() };
        radiosity("radiosity { brightness 3 gray_threshold 1 adc_bailout 2 }", factors);
        radiosity("radiosity { max_sample 0.3 }", Radiosity { max_sample: Some(0.3), ..default() });
        radiosity("radiosity { max_sample -5 }", default());
        let on = Radiosity { always_sample: true, normal: true, media: true, subsurface: true, ..default() };
        radiosity("radiosity { always_sample on normal yes media -1 subsurface 1.5 }", on);
        radiosity("radiosity { always_sample off normal .9 media -.4 subsurface 0 }", default());
        let both = Radiosity { pretrace_start: 0.5, pretrace_end: 0.3, ..default() };
        radiosity("radiosity { pretrace_start .5 } radiosity { pretrace_end .3 }", both);
    }

    #[test]
    fn distances_of_reuse_keep_apart() {
        let reuse = |text: &str| {
            read("3.7", &format!("radiosity {{ {text} }}")).map(|(s, w)| (s.radiosity.map(|r| r.reuse()), w.len()))
        };
        let check = |text, reuse_at, n_warnings| assert_eq!(reuse(text), Ok((Some(reuse_at), n_warnings)), "{text}");
        check("", [0.015, 0.2], 0);
        check("minimum_reuse .15", [0.15, 0.3], 1);
        check("maximum_reuse .02", [0.01, 0.02], 1);
        check("minimum_reuse .1 maximum_reuse .2", [0.1, 0.2], 0);
        check("minimum_reuse .15 maximum_reuse .2", [0.15, 0.2], 1);
        check("minimum_reuse 0 maximum_reuse 1", [0.0, 1.0], 0);
        fails("radiosity { minimum_reuse .2 maximum_reuse .2 }", "must be above minimum_reuse");
    }

    /// Each of these is refused by POV-Ray 3.7.0.10, too.
    #[test]
    fn radiosity_has_ranges() {
        for text in [
            "count 0.5",
            "count 10, 5",
            "count 10,, 20",
            "count",
            "error_bound 0",
            "low_error_factor 0",
            "nearest_count 0",
            "nearest_count 21",
            "nearest_count 5.7,5",
            "nearest_count 5,-1",
            "minimum_reuse -1",
            "maximum_reuse 0",
            "pretrace_start 0",
            "pretrace_start 1.1",
            "pretrace_end 0",
            "recursion_limit 0",
            "recursion_limit 21",
            "brightness 0",
            "gray_threshold -1",
            "gray_threshold 1.1",
            "adc_bailout 0",
        ] {
            fails(&format!("radiosity {{ {text} }}"), "");
        }
        fails("radiosity { pretrace_end .09 }", "pretrace_end must not be above pretrace_start");
        fails("radiosity { always_sample }", "expected");
        fails("radiosity { count 5, , brightness 2 }", "to close radiosity");
        fails("radiosity { distance_maximum 5 }", "to close radiosity");
        fails("radiosity { importance .5 }", "to close radiosity");
        fails("radiosity off", "to open radiosity");
        warns("radiosity { load_file \"x\" }", "load_file of radiosity has no effect");
        warns("radiosity { save_file concat(\"x\", \"y\") }", "save_file of radiosity has no effect");
        let old =
            |version| read(version, "radiosity {}").map_or(0, |(_, w)| w.iter().filter(|w| w.contains("3.5")).count());
        assert_eq!((old("3.1"), old("3.5")), (1, 0));
    }

    /// What POV-Ray 3.7.0.10 takes.
    #[test]
    fn photons_are_kept() {
        let default = Photons::default;
        photons("photons {}", default());
        photons(
            "photons { spacing -1 jitter 5 autostop 2 }",
            Photons { spacing: -1.0, jitter: 5.0, autostop: 2.0, ..default() },
        );
        photons("photons { count 100.5 }", Photons { count: Some(100), ..default() });
        photons("photons { count -5 }", default());
        photons("photons { gather 20.9 20.1 }", Photons { gather: [20, 20], ..default() });
        let thresholds = Photons { expand_increase: 0.0, expand_minimum: 3, ..default() };
        photons("photons { expand_thresholds -.2, 3.7 }", thresholds);
        let radius = |length, factor| GatherRadius { length, factor };
        let radii = |surface_radius, media_radius| Photons { surface_radius, media_radius, ..default() };
        photons("photons { radius }", default());
        photons("photons { radius .1 2 .3 4 }", radii(radius(Some(0.1), 2.0), radius(Some(0.3), 4.0)));
        photons("photons { radius ,,.5 }", radii(radius(None, 1.0), radius(Some(0.5), 1.0)));
        photons("photons { radius -1, 2, jitter .4 }", radii(radius(None, 2.0), radius(None, 1.0)));
        photons("photons { media 100.9, 2 }", Photons { media_steps: 100, media_factor: 2.0, ..default() });
        let limits = Photons { max_trace_level: Some(2), adc_bailout: Some(0.5), ..default() };
        photons("photons { max_trace_level 2.9 adc_bailout .5 }", limits);
        photons("photons { max_trace_level -1 adc_bailout -1 }", default());
        photons("photons { save_file \"a\" }", Photons { file: Some(PhotonFile::Save("a".into())), ..default() });
        photons("photons { spacing 3 } photons { count 5 }", Photons { count: Some(5), ..default() });
    }

    /// What POV-Ray 3.7.0.10 refuses or warns about.
    #[test]
    fn photons_have_ranges() {
        for text in ["gather 5", "gather 5,, 10", "gather -1, 10", "gather 11, 10", "media -1", "media 10, 0"] {
            fails(&format!("photons {{ {text} }}"), "");
        }
        for text in ["expand_thresholds .2", "radius 1, 2, 3, 4, 5", "target", "steps 5", "spacing .1, count 5"] {
            fails(&format!("photons {{ {text} }}"), "");
        }
        warns("photons { expand_thresholds .2, -10 }", "taken for 0");
        warns("photons { save_file \"a\" load_file \"b\" }", "this load_file is what counts");
        warns("photons { gather 0, .5 }", "switched off");
        assert!(read("3.7", "photons { gather 0, 0 }").is_ok_and(|(s, _)| s.photons.is_none()));
    }

    #[test]
    fn subsurface_is_kept() {
        let check = |text: &str, samples, radiosity| {
            let found = read("3.7", text).map(|(s, _)| s.subsurface.map(|s| Subsurface { span: Span::default(), ..s }));
            assert_eq!(found, Ok(Some(Subsurface { samples, radiosity, ..Subsurface::default() })), "{text}");
        };
        check("subsurface {}", [50, 50], false);
        check("subsurface { radiosity on samples 5 6 }", [5, 6], true);
        fails("subsurface { samples 5 }", "expected");
        fails("subsurface { radiosity }", "expected");
        fails("subsurface { radiosity off, samples 4, 4 }", "to close subsurface");
    }
}
