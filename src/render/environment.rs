//! Sky and background: what rays see that meet nothing.
//!
//! Source: section 6 of the camera and image facts (measured).

use super::options::Options;
use super::path::Path;
use super::radiance::Radiance;
use crate::compiled::atmosphere::{Atmosphere, Sky};
use crate::compiled::geometry::RayKind;
use crate::compiled::texture::Context;
use crate::math::{Color, DVec3, Rgb, gray};

/// Who looks at the sky.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Onlooker {
    /// The picture has an alpha channel.
    pub(super) alpha: bool,
    /// By way of a mirror.
    pub(super) mirrored: bool,
}

impl Onlooker {
    pub(super) fn of(path: &Path, options: &Options) -> Self {
        Self { alpha: options.alpha, mirrored: path.kind == RayKind::Reflected }
    }
}

/// The light from a direction (unit, world).
pub(super) fn radiance(atmosphere: &Atmosphere, direction: DVec3, onlooker: Onlooker) -> Radiance {
    let Some(sky) = &atmosphere.sky else { return behind(atmosphere, onlooker, Rgb::ZERO, Rgb::ONE) };
    let point = sky.sky_from_world.point(direction);
    let context = Context { direction, normal: direction, point, ..Context::default() };
    let colors = sky.pigments.iter().rev().map(|pigment| pigment.color_or_clear(point, &context));
    radiance_of(atmosphere, sky, onlooker, colors)
}

/// The light of a sky of which the colours are known, uppermost first.
pub(super) fn radiance_of(
    atmosphere: &Atmosphere,
    sky: &Sky,
    onlooker: Onlooker,
    colors: impl Iterator<Item = Color>,
) -> Radiance {
    if atmosphere.legacy {
        let (rgb, filter) = legacy_sky(sky, colors);
        return behind(atmosphere, onlooker, rgb, filter);
    }
    let (mut rgb, mut filter) = (Rgb::ZERO, Rgb::ONE);
    for color in colors {
        rgb += color.rgb * color.opacity() * filter * sky.emission;
        filter *= color.transmittance();
    }
    behind(atmosphere, onlooker, rgb, filter)
}

/// The light of a sky and what its filter leaves of the background.
fn behind(atmosphere: &Atmosphere, onlooker: Onlooker, mut rgb: Rgb, mut filter: Rgb) -> Radiance {
    let shows_through = onlooker.alpha && !onlooker.mirrored;
    if shows_through && atmosphere.legacy {
        return Radiance::CLEAR;
    }
    let opaque = |rgb: Rgb| Color { rgb, ..Color::BLACK };
    let background = match atmosphere.background {
        Some(background) if shows_through => background.translucent,
        Some(background) if onlooker.alpha => opaque(background.mirrored),
        Some(background) => opaque(background.opaque),
        None if shows_through => Color { transmit: 1.0, ..Color::BLACK },
        None => Color::BLACK,
    };
    rgb += background.rgb * background.opacity() * filter;
    filter *= background.transmittance();
    Radiance { rgb, transparency: gray(filter).abs().min(1.0) }
}

/// Layers of the sky before version 3.7: filters, transmits and colours multiply apart from each other.
///
/// Gives the sky's light and what it lets through of the background. Source: camera facts, section 6.2.
fn legacy_sky(sky: &Sky, of_layers: impl Iterator<Item = Color>) -> (Rgb, Rgb) {
    let (mut rgb, mut colors) = (Rgb::ZERO, Rgb::ONE);
    let (mut filters, mut transmits, mut share) = (1.0_f32, 1.0_f32, 1.0);
    for color in of_layers {
        rgb += color.rgb * (share * color.opacity());
        colors *= color.rgb;
        filters *= color.filter;
        transmits *= color.transmit;
        share = filters.abs() + transmits.abs();
    }
    (rgb * sky.emission, colors * filters + transmits)
}
