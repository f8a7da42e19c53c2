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
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        let span = self.span();
        match keyword {
            K::AssumedGamma => {
                self.next()?;
                let working = self.gamma_value()?;
                if self.defaults.gamma_given {
                    self.warn(Topic::Ignored, span, "assumed_gamma was given before; this one has no effect");
                    return Ok(true);
                }
                self.defaults.gamma_given = true;
                self.scene.settings.gamma = Gamma::Linear(working);
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
                self.subsurface_settings(span)?;
            }
            K::Photons => {
                self.next()?;
                self.photon_settings(span)?;
            }
            K::Radiosity => {
                self.next()?;
                self.radiosity_settings(span)?;
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
}
