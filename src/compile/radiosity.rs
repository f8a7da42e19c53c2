//! Settings of radiosity, as rays need them.

use crate::compiled::radiosity::Radiosity;
use crate::scene::{self, Settings};

/// From this version on radiosity takes the place of ambient light.
///
/// Source: radiosity facts, section 1.
const WITHOUT_AMBIENT: u32 = 370;

pub(super) fn radiosity(radiosity: &scene::Radiosity, settings: &Settings) -> Radiosity {
    Radiosity {
        count: radiosity.count,
        directions: radiosity.directions,
        error_bound: radiosity.error_bound,
        low_error_factor: radiosity.low_error_factor,
        nearest_count: radiosity.nearest_count,
        enough_for_pretrace: radiosity.enough_for_pretrace,
        reuse: radiosity.reuse(),
        pretrace: [radiosity.pretrace_start, radiosity.pretrace_end],
        recursion_limit: radiosity.recursion_limit,
        brightness: radiosity.brightness,
        gray_threshold: radiosity.gray_threshold as f32,
        max_sample: radiosity.max_sample.map(|limit| limit as f32),
        adc_bailout: radiosity.adc_bailout,
        always_sample: radiosity.always_sample,
        normal: radiosity.normal,
        media: radiosity.media,
        subsurface: radiosity.subsurface,
        replaces_ambient: settings.version >= WITHOUT_AMBIENT,
        importance: settings.radiosity_importance,
    }
}
