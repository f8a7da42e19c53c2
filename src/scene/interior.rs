//! What fills an object: index of refraction, attenuation, media.

use super::Pattern;
use super::texture::Blend;
use crate::diag::Span;
use crate::math::{Color, Rgb, Transform};
use std::sync::Arc;

/// `interior { … }`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Interior {
    /// The word of its block, or an empty place if nothing was written.
    pub span: Span,
    /// 0 where none was given.
    pub ior: f64,
    pub caustics: f64,
    pub dispersion: f64,
    pub dispersion_samples: u32,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub fade_color: Rgb,
    /// Legacy `refraction`.
    pub refraction: f64,
    pub media: Vec<Media>,
}

impl Default for Interior {
    fn default() -> Self {
        Self {
            span: Span::default(),
            ior: 0.0,
            caustics: 0.0,
            dispersion: 1.0,
            dispersion_samples: 7,
            fade_distance: 0.0,
            fade_power: 0.0,
            fade_color: Rgb::ZERO,
            refraction: 1.0,
            media: Vec::new(),
        }
    }
}

impl Interior {
    /// Whether it matters where it is: the density of a medium depends on the place.
    pub fn has_place(&self) -> bool {
        self.media.iter().any(|media| !media.density.is_empty())
    }

    /// Moves the media's densities.
    pub fn apply(&mut self, transform: &Transform) {
        for media in &mut self.media {
            media.apply(transform);
        }
    }
}

/// `media { … }`: what fills an interior or the atmosphere.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Media {
    /// The word of the block in which it was written.
    pub span: Span,
    pub method: u8,
    pub intervals: u32,
    pub samples: [u32; 2],
    pub jitter: f64,
    pub aa_level: u32,
    pub aa_threshold: f64,
    pub confidence: f64,
    pub variance: f64,
    pub ratio: f64,
    pub absorption: Rgb,
    pub emission: Rgb,
    /// Scattering type (1 to 5, 0 for none), colour, eccentricity, extinction.
    pub scattering: (u8, Rgb, f64, f64),
    pub density: Vec<Arc<Density>>,
    pub collect: bool,
}

impl Media {
    /// A medium of which nothing is said, by the rules of version 3.5 and later.
    pub fn new(span: Span) -> Self {
        Self {
            span,
            method: 3,
            intervals: 1,
            samples: [10, 10],
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

    /// Moves the densities written so far.
    pub fn apply(&mut self, transform: &Transform) {
        for density in &mut self.density {
            Arc::make_mut(density).apply(transform);
        }
    }
}

/// A density: a colour for each point.
#[derive(Clone, Debug)]
pub enum Density {
    /// The same everywhere.
    Solid(Color),
    /// A pattern through colours.
    Colors(Pattern, Blend<Color>),
    /// A pattern through other densities.
    Densities(Pattern, Blend<Arc<Density>>),
}

impl Density {
    /// Applies a transformation written after everything so far.
    pub fn apply(&mut self, transform: &Transform) {
        match self {
            Self::Solid(_) => {}
            Self::Colors(p, _) | Self::Densities(p, _) => p.apply(transform),
        }
    }
}
