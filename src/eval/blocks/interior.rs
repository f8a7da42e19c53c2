//! `interior { … }`, `media { … }` and `density { … }`.

use super::pattern::no_list;
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::{Color, Rgb};
use crate::scene::{Blend, Density, Interior, Media, Pattern, PatternKind};
use crate::stack::roomy;
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// From this language version on, media use the newer defaults.
const VERSION_WITH_MEDIA_METHOD_3: u32 = 350;

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
            if let Some(transform) = self.transformation()? {
                interior.apply(&transform);
                continue;
            }
            match self.keyword()? {
                Some(keyword) if self.interior_item(keyword, &mut interior)? => {}
                _ => break,
            }
        }
        self.close("interior")?;
        Ok(interior)
    }

    fn interior_item(&mut self, keyword: K, interior: &mut Interior) -> SourceResult<bool> {
        let span = self.span();
        let target = match keyword {
            K::Ior => &mut interior.ior,
            K::Caustics => &mut interior.caustics,
            K::Dispersion => &mut interior.dispersion,
            K::FadeDistance => &mut interior.fade_distance,
            K::FadePower => &mut interior.fade_power,
            K::Refraction => &mut interior.refraction,
            K::FadeColor | K::FadeColour => {
                self.next()?;
                interior.fade_color = self.rgb_only("fade_color")?;
                return Ok(true);
            }
            K::DispersionSamples => {
                self.next()?;
                let n = self.integer()?;
                if n < 2 {
                    return self.error(span, "dispersion_samples must be at least 2");
                }
                interior.dispersion_samples = n.min(i64::from(u32::MAX)) as u32;
                return Ok(true);
            }
            K::Media => {
                self.next()?;
                let media = self.media_block()?;
                interior.media.push(media);
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        *target = self.float()?;
        Ok(true)
    }

    /// What a `media` block starts from under the version in force.
    fn default_media(&self, span: Span) -> Media {
        let new = self.version >= VERSION_WITH_MEDIA_METHOD_3;
        Media {
            span,
            method: if new { 3 } else { 1 },
            intervals: if new { 1 } else { 10 },
            samples: if new { [10, 10] } else { [1, 1] },
            jitter: 0.0,
            aa_level: 3,
            aa_threshold: 0.1,
            confidence: 0.9,
            variance: 1.0 / 128.0,
            ratio: 0.9,
            absorption: Rgb::ZERO,
            emission: Rgb::ZERO,
            scattering: (0, Rgb::ZERO, 0.0, 1.0),
            density: Vec::new(),
            collect: true,
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
            if let Some(transform) = self.transformation()? {
                media.apply(&transform);
                continue;
            }
            match self.keyword()? {
                Some(keyword) if self.media_item(keyword, &mut media)? => {}
                _ => break,
            }
        }
        self.close("media")?;
        Ok(media)
    }

    fn media_item(&mut self, keyword: K, media: &mut Media) -> SourceResult<bool> {
        let span = self.span();
        let float_target = match keyword {
            K::Jitter => Some(&mut media.jitter),
            K::AaThreshold => Some(&mut media.aa_threshold),
            K::Confidence => Some(&mut media.confidence),
            K::Variance => Some(&mut media.variance),
            K::Ratio => Some(&mut media.ratio),
            _ => None,
        };
        if let Some(target) = float_target {
            self.next()?;
            let value = self.float()?;
            *target = value;
            return self.media_number(span, keyword, value);
        }
        match keyword {
            K::Method => {
                self.next()?;
                media.method = match self.integer()? {
                    n @ 1..=3 => n as u8,
                    n => return self.error(span, format!("there is no media method {n}; use 1, 2 or 3")),
                };
            }
            K::Intervals => {
                self.next()?;
                media.intervals = self.at_least_one(span, "intervals")?;
            }
            K::AaLevel => {
                self.next()?;
                media.aa_level = self.at_least_one(span, "aa_level")?;
            }
            K::Samples => {
                self.next()?;
                let min = self.at_least_one(span, "samples")?;
                self.comma()?;
                let max = if self.starts_expression()? { self.at_least_one(span, "samples")? } else { min };
                if max < min {
                    return self.error(span, "the largest number of samples is below the smallest");
                }
                media.samples = [min, max];
            }
            K::Absorption => {
                self.next()?;
                media.absorption = self.rgb_only("absorption")?;
            }
            K::Emission => {
                self.next()?;
                media.emission = self.rgb_only("emission")?;
            }
            K::Scattering => {
                self.next()?;
                self.scattering(media)?;
            }
            K::Density => {
                self.next()?;
                let density = self.density_block()?;
                media.density.push(Arc::new(density));
            }
            K::Collect => {
                self.next()?;
                media.collect = self.optional_bool()?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Numbers outside of their range are errors, as in POV-Ray.
    fn media_number(&mut self, span: Span, keyword: K, value: f64) -> SourceResult<bool> {
        match keyword {
            K::AaThreshold if value <= 0.0 => self.error(span, "aa_threshold must be positive"),
            K::Confidence if !(0.0..1.0).contains(&value) => {
                self.error(span, "confidence must be at least 0 and less than 1")
            }
            _ => Ok(true),
        }
    }

    fn at_least_one(&mut self, span: Span, what: &str) -> SourceResult<u32> {
        match self.integer()? {
            n if n >= 1 => Ok(n.min(i64::from(u32::MAX)) as u32),
            _ => self.error(span, format!("{what} must be at least 1")),
        }
    }

    fn scattering(&mut self, media: &mut Media) -> SourceResult<()> {
        self.open("scattering")?;
        let span = self.span();
        let mut kind = self.integer()?;
        if !(1..=5).contains(&kind) {
            self.warn(Topic::Range, span, format!("there is no scattering type {kind}; type 1 is used"));
            kind = 1;
        }
        self.comma()?;
        let color = self.rgb_only("scattering")?;
        let (mut eccentricity, mut extinction) = (0.0, 1.0);
        loop {
            self.comma()?;
            let span = self.span();
            if self.accept(K::Eccentricity)? {
                eccentricity = self.float()?;
                if kind != 5 {
                    return self.error(span, "eccentricity belongs to scattering type 5");
                }
            } else if self.accept(K::Extinction)? {
                extinction = self.float()?;
            } else {
                break;
            }
        }
        media.scattering = (kind as u8, color, eccentricity, extinction);
        self.close("scattering")
    }

    /// `{ … }` after `density`.
    pub(super) fn density_block(&mut self) -> SourceResult<Density> {
        self.open("density")?;
        let density = self.density_items()?;
        self.close("density")?;
        Ok(density)
    }

    /// The inside of a density, also of a `density_map` entry.
    pub(super) fn density_items(&mut self) -> SourceResult<Density> {
        roomy(|| self.whole_density())
    }

    fn whole_density(&mut self) -> SourceResult<Density> {
        let pick = |v: &Value| if let Value::Density(d) = v { Some((**d).clone()) } else { None };
        let mut density = self.take_declared(pick)?.unwrap_or(Density::Solid(Color::rgb(1.0, 1.0, 1.0)));
        while self.density_item(&mut density)? {}
        Ok(density)
    }

    fn density_item(&mut self, density: &mut Density) -> SourceResult<bool> {
        self.comma()?;
        match self.keyword()? {
            Some(K::ColorMap | K::ColourMap) => {
                self.next()?;
                let map = Blend::Map(self.color_map()?);
                *density = Density::Colors(density_pattern(density), map);
                return Ok(true);
            }
            Some(K::DensityMap) => {
                self.next()?;
                let pattern = density_pattern(density);
                let map = self.density_map(matches!(pattern.kind, PatternKind::Average))?;
                *density = Density::Densities(pattern, map);
                return Ok(true);
            }
            _ => {}
        }
        let mut pattern = density_pattern(density);
        let mut list = Vec::new();
        let mut read_list = |e: &mut Evaluator, n: usize| {
            e.comma()?;
            while list.len() < n && e.accept(K::Density)? {
                list.push(Arc::new(e.density_block()?));
                e.comma()?;
            }
            no_list(e, n)
        };
        if self.pattern_keyword(&mut pattern, &mut read_list)? {
            *density = match density {
                _ if !list.is_empty() => Density::Densities(pattern, Blend::List(list)),
                Density::Colors(_, map) => Density::Colors(pattern, map.clone()),
                _ => Density::Colors(pattern, Blend::Default),
            };
            return Ok(true);
        }
        if self.starts_color()? {
            *density = Density::Solid(self.color()?);
            return Ok(true);
        }
        let more = self.pattern_modifier(&mut pattern)?;
        if more {
            match density {
                Density::Solid(_) => {}
                Density::Colors(p, _) | Density::Densities(p, _) => *p = pattern,
            }
        }
        Ok(more)
    }
}

fn density_pattern(density: &Density) -> Pattern {
    match density {
        Density::Solid(_) => Pattern::new(PatternKind::None),
        Density::Colors(pattern, _) | Density::Densities(pattern, _) => pattern.clone(),
    }
}
