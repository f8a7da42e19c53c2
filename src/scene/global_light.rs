//! Settings of light that comes from everywhere: radiosity, photons, subsurface light.
//!
//! Source of names, defaults and ranges: the manual's section 3.4.1 and measurements of POV-Ray 3.7.0.10.

use crate::diag::Span;
use std::sync::Arc;

/// `global_settings { radiosity { … } }`; several blocks add to one another.
#[derive(Clone, Debug, PartialEq)]
pub struct Radiosity {
    /// The word of the last block.
    pub span: Span,
    /// Rays for each sample, at least 1.
    pub count: u32,
    /// Directions from which they are taken in turn, at least `count`.
    pub directions: u32,
    /// Error up to which samples are reused, above 0.
    pub error_bound: f64,
    /// Factor of `error_bound` while samples are gathered in advance, above 0.
    pub low_error_factor: f64,
    /// Samples that are blended at a point, 1 to 20.
    pub nearest_count: u32,
    /// Samples that are enough for the pretrace to go no finer, below `nearest_count`; 0 switches that off.
    pub enough_for_pretrace: u32,
    /// Least distance of reuse in distances from the camera, at least 0, where one was given.
    pub minimum_reuse: Option<f64>,
    /// Largest distance of reuse in distances from the camera, above 0, where one was given.
    pub maximum_reuse: Option<f64>,
    /// Step of the first pretrace in sizes of the picture, above 0, at most 1.
    pub pretrace_start: f64,
    /// Step of the last one, at most `pretrace_start`.
    pub pretrace_end: f64,
    /// Bounces, 1 to 20.
    pub recursion_limit: u32,
    /// Factor of all gathered light, above 0.
    pub brightness: f64,
    /// How much of its colour gathered light loses, 0 to 1.
    pub gray_threshold: f64,
    /// Brightest a sample ray may be in any channel; `None` for no limit.
    pub max_sample: Option<f64>,
    /// Weight below which sample rays end, above 0.
    pub adc_bailout: f64,
    /// New samples are also taken while the picture is made.
    pub always_sample: bool,
    /// Samples go by the perturbed normal.
    pub normal: bool,
    /// Sample rays pass through media.
    pub media: bool,
    /// Sample rays see subsurface light.
    pub subsurface: bool,
}

impl Radiosity {
    /// What holds where no `minimum_reuse` was given and `maximum_reuse` leaves room for it.
    pub const MINIMUM_REUSE: f64 = 0.015;
    /// The same the other way round.
    pub const MAXIMUM_REUSE: f64 = 0.2;

    /// The least and the largest distance of reuse, in distances from the camera. Where only one was given and they
    /// would be too near, the other one moves away: the largest is twice the least.
    pub fn reuse(&self) -> [f64; 2] {
        match (self.minimum_reuse, self.maximum_reuse) {
            (Some(least), Some(largest)) => [least, largest],
            (Some(least), None) => [least, Self::MAXIMUM_REUSE.max(2.0 * least)],
            (None, Some(largest)) => [Self::MINIMUM_REUSE.min(0.5 * largest), largest],
            (None, None) => [Self::MINIMUM_REUSE, Self::MAXIMUM_REUSE],
        }
    }
}

impl Default for Radiosity {
    fn default() -> Self {
        Self {
            span: Span::default(),
            count: 35,
            directions: 1600,
            error_bound: 1.8,
            low_error_factor: 0.5,
            nearest_count: 5,
            enough_for_pretrace: 0,
            minimum_reuse: None,
            maximum_reuse: None,
            pretrace_start: 0.08,
            pretrace_end: 0.04,
            recursion_limit: 2,
            brightness: 1.0,
            gray_threshold: 0.0,
            max_sample: None,
            adc_bailout: 0.01,
            always_sample: false,
            normal: false,
            media: false,
            subsurface: false,
        }
    }
}

/// `global_settings { photons { … } }`; the last block holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Photons {
    /// The word of the block.
    pub span: Span,
    /// Distance of photons on their targets; none are shot unless it is above 0.
    pub spacing: f64,
    /// About how many to shoot, by which the spacing goes then.
    pub count: Option<u32>,
    /// Least and largest number of photons that make up the light at a point; the largest is above 0.
    pub gather: [u32; 2],
    /// Random shift in steps between photons.
    pub jitter: f64,
    /// Fraction of a target's radius from which on an empty ring ends the search.
    pub autostop: f64,
    /// Where few photons are near: how much denser a wider search may be to count, at least 0.
    pub expand_increase: f64,
    /// Below how many photons it counts in any case.
    pub expand_minimum: u32,
    /// How far around a point of a surface photons are gathered.
    pub surface_radius: GatherRadius,
    /// The same in media.
    pub media_radius: GatherRadius,
    /// Most photons left in a medium on the way through a part of it; 0 for none.
    pub media_steps: u32,
    /// Distance of these, in spacings, above 0.
    pub media_factor: f64,
    /// Surfaces a photon may meet; `None` for as many as other rays.
    pub max_trace_level: Option<u32>,
    /// Weight below which a photon ends; `None` for that of other rays.
    pub adc_bailout: Option<f64>,
    /// A file with photons.
    pub file: Option<PhotonFile>,
}

/// How far around a point photons are gathered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GatherRadius {
    /// Scene units; `None` for what the density of photons suggests.
    pub length: Option<f64>,
    /// Multiplies it.
    pub factor: f64,
}

/// A file with photons, by the name in the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PhotonFile {
    /// To be written.
    Save(Arc<str>),
    /// To be read instead of shooting any.
    Load(Arc<str>),
}

impl Default for Photons {
    fn default() -> Self {
        let automatic = GatherRadius { length: None, factor: 1.0 };
        Self {
            span: Span::default(),
            spacing: 1.0,
            count: None,
            gather: [20, 100],
            jitter: 0.4,
            autostop: 0.5,
            expand_increase: 0.2,
            expand_minimum: 35,
            surface_radius: automatic,
            media_radius: automatic,
            media_steps: 0,
            media_factor: 1.0,
            max_trace_level: None,
            adc_bailout: None,
            file: None,
        }
    }
}

/// `global_settings { subsurface { … } }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subsurface {
    /// The word of the last block.
    pub span: Span,
    /// Samples of light scattered often, and of light scattered once.
    pub samples: [u32; 2],
    /// Radiosity shines into the material, too.
    pub radiosity: bool,
}

impl Default for Subsurface {
    fn default() -> Self {
        Self { span: Span::default(), samples: [50, 50], radiosity: false }
    }
}
