//! `global_settings { … }` and the scene-level words that belong to it.

use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::scene::Gamma;
use crate::syntax::Keyword as K;

impl Evaluator<'_> {
    /// `{ … }` after `global_settings`.
    pub(super) fn global_settings(&mut self) -> SourceResult<()> {
        self.open("global_settings")?;
        while self.setting()? {
            self.comma()?;
        }
        self.close("global_settings")
    }

    /// One setting, if one comes next.
    pub(super) fn setting(&mut self) -> SourceResult<bool> {
        let span = self.span();
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        match keyword {
            K::AssumedGamma => {
                self.next()?;
                let working = self.gamma_value()?;
                if self.defaults.gamma_given {
                    self.warn(Topic::Ignored, span, "assumed_gamma was given before; this one has no effect");
                    return Ok(true);
                }
                self.defaults.gamma_given = true;
                let modern = self.effective_version() >= 370;
                self.scene.settings.gamma = if modern { Gamma::Linear(working) } else { Gamma::Legacy(working) };
            }
            K::AmbientLight => {
                self.next()?;
                self.scene.settings.ambient_light = self.rgb_only("ambient_light")?;
            }
            K::IridWavelength => {
                self.next()?;
                self.scene.settings.irid_wavelength = self.rgb_only("irid_wavelength")?;
            }
            K::MaxTraceLevel => {
                self.next()?;
                let level = self.integer()?;
                if level > 256 {
                    self.warn(Topic::Range, span, "max_trace_level is limited to 256");
                }
                self.scene.settings.max_trace_level = level.clamp(1, 256) as u32;
            }
            K::MaxIntersections => {
                self.next()?;
                self.float()?;
                self.warn(Topic::Outdated, span, "max_intersections has no effect");
            }
            K::AdcBailout => {
                self.next()?;
                self.scene.settings.adc_bailout = self.float()?;
            }
            K::NumberOfWaves => {
                self.next()?;
                let n = self.integer()?;
                if n < 1 {
                    self.warn(Topic::Range, span, "number_of_waves is at least 1");
                }
                self.scene.settings.number_of_waves = n.clamp(1, 1 << 16) as u32;
            }
            K::NoiseGenerator => {
                self.next()?;
                self.scene.settings.noise_generator = match self.integer()? {
                    n @ 1..=3 => Some(n as u8),
                    _ => return self.error(span, "noise_generator must be 1, 2 or 3"),
                };
            }
            K::MmPerUnit => {
                self.next()?;
                self.scene.settings.mm_per_unit = self.float()?;
            }
            K::Charset => {
                self.next()?;
                self.charset()?;
            }
            K::HfGray16 => {
                self.next()?;
                self.optional_bool()?;
                self.warn(Topic::Ignored, span, "hf_gray_16 has no effect");
            }
            K::Subsurface => {
                self.next()?;
                self.subsurface_settings()?;
            }
            K::Photons => {
                self.next()?;
                self.scene.settings.photons = true;
                self.warn_here(Topic::Unsupported, span, "photons are not supported yet: caustics will be missing");
                self.skip_settings("photons")?;
            }
            K::Radiosity => {
                self.next()?;
                self.scene.settings.radiosity = true;
                self.warn_here(
                    Topic::Unsupported,
                    span,
                    "radiosity is not supported yet: indirect light will be missing",
                );
                self.skip_settings("radiosity")?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn charset(&mut self) -> SourceResult<()> {
        match self.keyword()? {
            Some(K::Ascii) => self.utf8 = false,
            Some(K::Utf8 | K::Sys) => self.utf8 = true,
            _ => return self.expected("'ascii', 'utf8' or 'sys'"),
        }
        self.next()?;
        Ok(())
    }

    fn subsurface_settings(&mut self) -> SourceResult<()> {
        self.open("subsurface")?;
        let (mut samples, mut radiosity) = ([50, 50], false);
        loop {
            self.comma()?;
            if self.accept(K::Samples)? {
                samples[0] = self.integer()?.clamp(0, 1 << 20) as u32;
                self.comma()?;
                if self.starts_expression()? {
                    samples[1] = self.integer()?.clamp(0, 1 << 20) as u32;
                }
            } else if self.accept(K::Radiosity)? {
                radiosity = self.optional_bool()?;
            } else {
                break;
            }
        }
        self.scene.settings.subsurface = Some((samples, radiosity));
        self.close("subsurface")
    }

    /// Reads the settings of a feature that the renderer does not have yet: words with numbers,
    /// colours or strings, evaluated for their errors and side effects.
    fn skip_settings(&mut self, what: &str) -> SourceResult<()> {
        self.open(what)?;
        while !self.at_punct('}')? {
            self.comma()?;
            if self.keyword()?.is_some() && !self.starts_expression()? && !self.at_color()? {
                self.next()?;
            } else if self.starts_string()? {
                self.string()?;
            } else if self.at_color()? {
                self.color()?;
            } else if self.starts_expression()? {
                self.any_expression()?;
            } else {
                break;
            }
        }
        self.close(what)
    }
}
