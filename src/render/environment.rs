//! Sky and background: what rays see that meet nothing.
//!
//! Source: section 6 of the camera and image facts (measured).

use super::options::Options;
use super::path::Path;
use super::radiance::Radiance;
use crate::compiled::World;
use crate::compiled::atmosphere::Sky;
use crate::compiled::geometry::RayKind;
use crate::compiled::texture::Context;
use crate::math::{Color, Rgb, gray};

/// The light at the end of a path that meets nothing.
pub(super) fn radiance(world: &World, options: &Options, path: &Path) -> Radiance {
    let direction = path.ray.direction;
    let Some(sky) = &world.atmosphere.sky else { return behind(world, options, path, Rgb::ZERO, Rgb::ONE) };
    let point = sky.sky_from_world.point(direction);
    let context = Context { direction, point, ..Context::default() };
    let colors = sky.pigments.iter().rev().map(|pigment| pigment.color_or_clear(point, &context));
    radiance_of(world, options, path, sky, colors)
}

/// The light of a sky of which the colours are known, uppermost first.
pub(super) fn radiance_of(
    world: &World,
    options: &Options,
    path: &Path,
    sky: &Sky,
    colors: impl Iterator<Item = Color>,
) -> Radiance {
    if world.atmosphere.legacy {
        let (rgb, filter) = legacy_sky(sky, colors);
        return behind(world, options, path, rgb, filter);
    }
    let (mut rgb, mut filter) = (Rgb::ZERO, Rgb::ONE);
    for color in colors {
        rgb += color.rgb * color.opacity() * filter * sky.emission;
        filter *= color.transmittance();
    }
    behind(world, options, path, rgb, filter)
}

/// The light of a sky and what its filter leaves of the background.
fn behind(world: &World, options: &Options, path: &Path, mut rgb: Rgb, mut filter: Rgb) -> Radiance {
    let atmosphere = &world.atmosphere;
    let shows_through = options.alpha && !matches!(path.kind, RayKind::Reflected | RayKind::Radiosity);
    if shows_through && atmosphere.legacy {
        return Radiance::CLEAR;
    }
    let opaque = |rgb: Rgb| Color { rgb, ..Color::BLACK };
    let background = match atmosphere.background {
        Some(background) if shows_through => background.translucent,
        Some(background) if options.alpha => opaque(background.mirrored),
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
