//! `radiosity`, `photons` and `subsurface` of `global_settings`.
//!
//! Unlike in most blocks, POV-Ray takes no commas between these settings, and neither is one taken here.

use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::scene::{GatherRadius, PhotonFile, Photons, Radiosity};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// Before this version the block alone did not switch radiosity on.
const VERSION_WITH_RADIOSITY_ON: u32 = 350;

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
        while let Some(keyword) = self.keyword()? {
            if !self.radiosity_setting(keyword, &mut radiosity)? {
                break;
            }
        }
        self.close("radiosity")?;
        self.scene.settings.radiosity = Some(radiosity);
        Ok(())
    }

    fn radiosity_setting(&mut self, keyword: K, radiosity: &mut Radiosity) -> SourceResult<bool> {
        const ABOVE_0: &str = "above 0";
        const FRACTION: &str = "above 0 and at most 1";
        let positive = |v: f64| v > 0.0;
        let fraction = |v: f64| v > 0.0 && v <= 1.0;
        match keyword {
            K::Count => self.sample_directions(radiosity)?,
            K::NearestCount => self.nearest_count(radiosity)?,
            K::ErrorBound => radiosity.error_bound = self.ruled(ABOVE_0, positive)?,
            K::LowErrorFactor => radiosity.low_error_factor = self.ruled(ABOVE_0, positive)?,
            K::MinimumReuse => radiosity.minimum_reuse = Some(self.ruled("at least 0", |v| v >= 0.0)?),
            K::MaximumReuse => radiosity.maximum_reuse = Some(self.ruled(ABOVE_0, positive)?),
            K::PretraceStart => radiosity.pretrace_start = self.ruled(FRACTION, fraction)?,
            K::PretraceEnd => radiosity.pretrace_end = self.ruled(FRACTION, fraction)?,
            K::RecursionLimit => {
                radiosity.recursion_limit = self.ruled("1 to 20", |v| (1.0..21.0).contains(&v))? as u32;
            }
            K::Brightness => radiosity.brightness = self.ruled(ABOVE_0, positive)?,
            K::GrayThreshold => radiosity.gray_threshold = self.ruled("0 to 1", |v| (0.0..=1.0).contains(&v))?,
            K::MaxSample => {
                self.next()?;
                radiosity.max_sample = Some(self.float()?).filter(|v| positive(*v));
            }
            K::AdcBailout => radiosity.adc_bailout = self.ruled(ABOVE_0, positive)?,
            K::AlwaysSample => radiosity.always_sample = self.switch()?,
            K::Normal => radiosity.normal = self.switch()?,
            K::Media => radiosity.media = self.switch()?,
            K::Subsurface => radiosity.subsurface = self.switch()?,
            K::LoadFile | K::SaveFile => {
                let span = self.next()?.span;
                self.string()?;
                let message = format!("{} of radiosity has no effect in a scene", keyword.word());
                self.warn(Topic::Ignored, span, message);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// `count RAYS [, DIRECTIONS]`.
    fn sample_directions(&mut self, radiosity: &mut Radiosity) -> SourceResult<()> {
        let span = self.span();
        radiosity.count = self.ruled("at least 1", |v| v >= 1.0)? as u32;
        radiosity.directions = radiosity.count.max(1600);
        if self.starts_another()? {
            let directions = self.integer()?;
            if directions < i64::from(radiosity.count) {
                return self.error(span, "count of radiosity takes no more rays than directions");
            }
            radiosity.directions = up_to_u32(directions);
        }
        Ok(())
    }

    /// `nearest_count SAMPLES [, ENOUGH]`.
    fn nearest_count(&mut self, radiosity: &mut Radiosity) -> SourceResult<()> {
        let span = self.span();
        radiosity.nearest_count = self.ruled("1 to 20", |v| (1.0..21.0).contains(&v))? as u32;
        radiosity.enough_for_pretrace = 0;
        if self.starts_another()? {
            let enough = self.integer()?;
            if !(0..i64::from(radiosity.nearest_count)).contains(&enough) {
                return self.error(span, "the second number of nearest_count must be 0 or more and below the first");
            }
            radiosity.enough_for_pretrace = enough as u32;
        }
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
        while let Some(keyword) = self.keyword()? {
            if !self.photon_setting(keyword, &mut photons)? {
                break;
            }
        }
        self.close("photons")?;
        let gathers = photons.gather[1] > 0;
        if !gathers {
            self.warn_here(Topic::Range, span, "photons are switched off, since none are to be gathered");
        }
        self.scene.settings.photons = gathers.then_some(photons);
        Ok(())
    }

    fn photon_setting(&mut self, keyword: K, photons: &mut Photons) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::Spacing => photons.spacing = self.value()?,
            K::Jitter => photons.jitter = self.value()?,
            K::Autostop => photons.autostop = self.value()?,
            K::Count => photons.count = Some(self.value()? as u32).filter(|n| *n > 0),
            K::AdcBailout => photons.adc_bailout = Some(self.value()?).filter(|v| *v >= 0.0),
            K::MaxTraceLevel => {
                photons.max_trace_level = Some(self.value()?.trunc()).filter(|v| *v >= 0.0).map(|v| v as u32);
            }
            K::Gather => photons.gather = self.gathered()?,
            K::Radius => self.gather_radii(photons)?,
            K::ExpandThresholds => self.expand_thresholds(photons)?,
            K::Media => {
                let steps = self.value()?.trunc();
                if steps < 0.0 {
                    return self.error(span, "media of photons takes 0 steps or more");
                }
                photons.media_steps = steps as u32;
                if self.starts_another()? {
                    photons.media_factor = self.float()?;
                }
                if photons.media_factor.is_nan() || photons.media_factor <= 0.0 {
                    return self.error(span, "the second number of photons' media must be above 0");
                }
            }
            K::SaveFile | K::LoadFile => self.photon_file(keyword, photons)?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// `gather LEAST, LARGEST`.
    fn gathered(&mut self) -> SourceResult<[u32; 2]> {
        let span = self.span();
        let least = self.value()?.trunc();
        self.comma()?;
        let largest = self.float()?.trunc();
        if least < 0.0 {
            return self.error(span, "the first number of gather must be 0 or more");
        }
        if least > largest {
            return self.error(span, "the first number of gather must not be above the second");
        }
        Ok([least as u32, largest as u32])
    }

    /// `radius [SURFACES] [, FACTOR] [, MEDIA] [, FACTOR]`; each may be left out.
    fn gather_radii(&mut self, photons: &mut Photons) -> SourceResult<()> {
        self.next()?;
        let mut given = [None; 4];
        for (i, number) in given.iter_mut().enumerate() {
            if i > 0 {
                self.comma()?;
            }
            if self.starts_expression()? {
                *number = Some(self.float()?);
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
    fn expand_thresholds(&mut self, photons: &mut Photons) -> SourceResult<()> {
        let span = self.span();
        let increase = self.value()?;
        self.comma()?;
        let minimum = self.float()?.trunc();
        if increase < 0.0 || minimum < 0.0 {
            self.warn(Topic::Range, span, "numbers of expand_thresholds below 0 are taken for 0");
        }
        photons.expand_increase = increase.max(0.0);
        photons.expand_minimum = minimum as u32;
        Ok(())
    }

    /// `save_file NAME` or `load_file NAME`.
    fn photon_file(&mut self, keyword: K, photons: &mut Photons) -> SourceResult<()> {
        let span = self.next()?.span;
        let name: Arc<str> = (&*self.string()?).into();
        let (file, other) = match keyword {
            K::SaveFile => (PhotonFile::Save(name), matches!(photons.file, Some(PhotonFile::Load(_)))),
            _ => (PhotonFile::Load(name), matches!(photons.file, Some(PhotonFile::Save(_)))),
        };
        if other {
            let message = format!("photons are either saved or loaded; this {} is what counts", keyword.word());
            self.warn(Topic::Ignored, span, message);
        }
        photons.file = Some(file);
        Ok(())
    }

    /// `{ … }` after `subsurface`; goes on from earlier blocks.
    pub(super) fn subsurface_settings(&mut self, span: Span) -> SourceResult<()> {
        self.open("subsurface")?;
        let mut subsurface = self.scene.settings.subsurface.unwrap_or_default();
        subsurface.span = span;
        loop {
            if self.accept(K::Samples)? {
                let often = self.integer()?;
                self.comma()?;
                subsurface.samples = [often, self.integer()?].map(up_to_u32);
            } else if self.keyword()? == Some(K::Radiosity) {
                subsurface.radiosity = self.switch()?;
            } else {
                break;
            }
        }
        self.close("subsurface")?;
        self.scene.settings.subsurface = Some(subsurface);
        Ok(())
    }

    /// The number after a word.
    fn value(&mut self) -> SourceResult<f64> {
        self.next()?;
        self.float()
    }

    /// The number after a word, which must be as the words of `rule` say.
    fn ruled(&mut self, rule: &str, holds: impl Fn(f64) -> bool) -> SourceResult<f64> {
        let (span, word) = (self.span(), self.keyword()?.map_or("", K::word));
        let value = self.value()?;
        if holds(value) { Ok(value) } else { self.error(span, format!("{word} of radiosity must be {rule}")) }
    }

    /// `on`, `off` or a number after a word; numbers count as POV-Ray counts them here, without their fraction.
    fn switch(&mut self) -> SourceResult<bool> {
        Ok(self.value()?.trunc() != 0.0)
    }

    /// Whether another number follows, past a comma if there is one.
    fn starts_another(&mut self) -> SourceResult<bool> {
        self.comma()?;
        self.starts_expression()
    }
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
