//! `global_settings { … }` and the scene-level words that belong to it.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::scene::Gamma;
use crate::syntax::Keyword as K;

/// They change the scene at once, since what is read behind them may ask for them.
pub(super) static GLOBAL_SETTINGS: Block<()> = Block::new(
    "global_settings",
    "what holds for the whole scene",
    &[
        Item::new(
            K::AssumedGamma,
            Takes::Other("FLOAT | srgb", assumed_gamma),
            "",
            "the light that numbers of colours stand for; 1 is linear",
        ),
        Item::new(
            K::AmbientLight,
            Takes::Other("COLOUR", |e, (), _| {
                e.scene.settings.ambient_light = e.rgb_only("ambient_light")?;
                Ok(())
            }),
            "1",
            "factor of ambient in all finishes",
        ),
        Item::new(
            K::IridWavelength,
            Takes::Other("COLOUR", |e, (), _| {
                e.scene.settings.irid_wavelength = e.rgb_only("irid_wavelength")?;
                Ok(())
            }),
            "rgb <0.7, 0.52, 0.48>",
            "wavelengths of red, green and blue for irid",
        ),
        Item::new(
            K::MaxTraceLevel,
            Takes::Other("INTEGER", |e, (), at| {
                let level = e.integer()?;
                if level > 256 {
                    e.warn(Topic::Range, at.span, "max_trace_level is limited to 256");
                }
                e.scene.settings.max_trace_level = level.clamp(1, 256) as u32;
                Ok(())
            }),
            "5",
            "how often light is mirrored or bent",
        ),
        Item::new(
            K::AdcBailout,
            Takes::Other("FLOAT", |e, (), _| {
                e.scene.settings.adc_bailout = e.float()?;
                Ok(())
            }),
            "1/255",
            "share of a pixel below which light is not followed",
        ),
        Item::new(
            K::NumberOfWaves,
            Takes::Other("INTEGER", |e, (), at| {
                let n = e.integer()?;
                if n < 1 {
                    e.warn(Topic::Range, at.span, "number_of_waves is at least 1");
                }
                e.scene.settings.number_of_waves = n.clamp(1, 1 << 16) as u32;
                Ok(())
            }),
            "10",
            "sources of waves and ripples",
        ),
        Item::since(
            350,
            K::NoiseGenerator,
            Takes::Other("INTEGER", |e, (), at| {
                e.scene.settings.noise_generator = match e.integer()? {
                    n @ 1..=3 => Some(n as u8),
                    _ => return e.error(at.span, "noise_generator must be 1, 2 or 3"),
                };
                Ok(())
            }),
            "",
            "1 the original noise, 2 with its range corrected, 3 after Perlin",
        ),
        Item::since(
            370,
            K::MmPerUnit,
            Takes::Other("FLOAT", |e, (), _| {
                e.scene.settings.mm_per_unit = e.float()?;
                Ok(())
            }),
            "10",
            "millimetres in a unit, for subsurface",
        ),
        Item::since(
            350,
            K::Charset,
            Takes::Other("ascii | utf8 | sys", charset),
            "ascii",
            "what bytes of strings stand for",
        ),
        Item::since(
            350,
            K::Radiosity,
            Takes::Other("{ items }", |e, (), at| e.radiosity_settings(at.span)),
            "",
            "light between surfaces",
        ),
        Item::since(
            350,
            K::Photons,
            Takes::Other("{ items }", |e, (), at| e.photon_settings(at.span)),
            "",
            "light that is mirrored and bent on its way from lights",
        ),
        Item::since(
            370,
            K::Subsurface,
            Takes::Other("{ items }", |e, (), at| e.subsurface_settings(at.span)),
            "",
            "light that enters surfaces and leaves somewhere else",
        ),
        Item::new(
            K::MaxIntersections,
            Takes::Other("INTEGER", |e, (), at| {
                e.float()?;
                e.warn(Topic::Outdated, at.span, "max_intersections has no effect");
                Ok(())
            }),
            "",
            "outdated: without effect",
        ),
        Item::new(
            K::HfGray16,
            Takes::Other("[BOOL]", |e, (), at| {
                e.optional_bool()?;
                e.warn(Topic::Ignored, at.span, "hf_gray_16 has no effect");
                Ok(())
            }),
            "",
            "outdated: without effect",
        ),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `global_settings`.
    pub(super) fn global_settings(&mut self) -> SourceResult<()> {
        self.open("global_settings")?;
        self.items_of(&GLOBAL_SETTINGS, &mut ())?;
        self.close_of(&GLOBAL_SETTINGS)
    }
}

fn assumed_gamma(e: &mut Evaluator<'_>, (): &mut (), at: Word) -> SourceResult<()> {
    let working = e.gamma_value()?;
    if e.defaults.gamma_given {
        e.warn(Topic::Ignored, at.span, "assumed_gamma was given before; this one has no effect");
        return Ok(());
    }
    e.defaults.gamma_given = true;
    e.scene.settings.gamma = Gamma::Linear(working);
    Ok(())
}

fn charset(e: &mut Evaluator<'_>, (): &mut (), _: Word) -> SourceResult<()> {
    match e.keyword()? {
        Some(K::Ascii) => e.utf8 = false,
        Some(K::Utf8 | K::Sys) => e.utf8 = true,
        _ => return e.expected("'ascii', 'utf8' or 'sys'"),
    }
    e.next()?;
    Ok(())
}
