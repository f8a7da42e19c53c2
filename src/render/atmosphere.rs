//! Sky for rays that meet nothing; rainbows and fog for all.
//!
//! Source: section 6 of the camera and image facts (measured).

use super::ray::{Path, Radiance};
use super::tracer::Tracer;
use crate::compiled::World;
use crate::compiled::atmosphere::{Fog, Rainbow, Sky};
use crate::compiled::geometry::RayKind;
use crate::compiled::texture::Context;
use crate::math::noise::turbulence;
use crate::math::{Color, DVec3, Ray, Rgb, gray};

/// POV-Ray's own limit for ground fog that keeps its height.
const LEVEL: f64 = 1e-10;

/// What lies between a ray's origin and what it meets: light behind it is weakened, some is added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Veil {
    pub(super) factor: Rgb,
    pub(super) added: Rgb,
    /// Factor of the backdrop's share.
    pub(super) transparency: f32,
}

impl Veil {
    /// Nothing at all.
    const NONE: Self = Self { factor: Rgb::ONE, added: Rgb::ZERO, transparency: 1.0 };
}

impl Tracer<'_> {
    /// What a ray sees that meets nothing.
    pub(super) fn sky(&self, path: &Path) -> Radiance {
        let Some(sky) = &self.world.atmosphere.sky else { return self.behind(path, Rgb::ZERO, Rgb::ONE) };
        let direction = path.ray.direction;
        let point = sky.sky_from_world.point(direction);
        let context = Context { direction, normal: direction, point, ..Context::default() };
        self.sky_of(sky, path, sky.pigments.iter().rev().map(|pigment| pigment.color_or_clear(point, &context)))
    }

    /// What a ray sees of a sky of which the colours are known, uppermost first.
    pub(super) fn sky_of(&self, sky: &Sky, path: &Path, colors: impl Iterator<Item = Color>) -> Radiance {
        if self.world.atmosphere.legacy {
            let (rgb, filter) = legacy_sky(sky, colors);
            return self.behind(path, rgb, filter);
        }
        let (mut rgb, mut filter) = (Rgb::ZERO, Rgb::ONE);
        for color in colors {
            rgb += color.rgb * color.opacity() * filter * sky.emission;
            filter *= color.transmittance();
        }
        self.behind(path, rgb, filter)
    }

    /// The light of a sky and what its filter leaves of the background.
    fn behind(&self, path: &Path, mut rgb: Rgb, mut filter: Rgb) -> Radiance {
        let atmosphere = &self.world.atmosphere;
        let shows_through = self.options.alpha && path.kind != RayKind::Reflected;
        if shows_through && atmosphere.legacy {
            return Radiance::CLEAR;
        }
        let opaque = |rgb: Rgb| Color { rgb, ..Color::BLACK };
        let background = match atmosphere.background {
            Some(background) if shows_through => background.translucent,
            Some(background) if self.options.alpha => opaque(background.mirrored),
            Some(background) => opaque(background.opaque),
            None if shows_through => Color { transmit: 1.0, ..Color::BLACK },
            None => Color::BLACK,
        };
        rgb += background.rgb * background.opacity() * filter;
        filter *= background.transmittance();
        Radiance { rgb, transparency: gray(filter).abs().min(1.0) }
    }

    /// What rainbows and fog do along a ray; `None` where there is nothing, or inside a solid object.
    pub(super) fn veil(&mut self, path: &Path, length: f64) -> Option<Veil> {
        let atmosphere = &self.world.atmosphere;
        let empty = atmosphere.fogs.is_empty() && atmosphere.rainbows.is_empty();
        if empty || !self.options.atmosphere() || !path.interiors.iter().all(|i| i.hollow) {
            return None;
        }
        let rainbows = self.rainbows(path, length);
        let mut factor = Rgb::ONE;
        let mut added = Rgb::ZERO;
        for fog in &atmosphere.fogs {
            let k = fog_transmittance(fog, &path.ray, length);
            factor *= k * fog_tint(fog);
            added += (1.0 - k) * fog.color.rgb;
        }
        Some(Veil {
            factor: factor * rainbows.factor,
            added: factor * rainbows.added + added,
            transparency: gray(factor) * rainbows.transparency,
        })
    }

    /// The mean of all rainbows that show in a direction.
    fn rainbows(&mut self, path: &Path, length: f64) -> Veil {
        let world = self.world;
        let mut sum = Veil { factor: Rgb::ZERO, added: Rgb::ZERO, transparency: 1.0 };
        let mut n = 0.0;
        for rainbow in &world.atmosphere.rainbows {
            let jitter = if rainbow.jitter == 0.0 { 0.0 } else { rainbow.jitter * (2.0 * self.random.unit() - 1.0) };
            let Some((index, fade)) = rainbow_index(rainbow, path.ray.direction, jitter) else { continue };
            let color = rainbow.pigment.color_or_clear(DVec3::new(index, 0.0, 0.0), &Context::default());
            let floor = fade * (1.0 - color.transmit) + color.transmit;
            let k = ((-length / rainbow.distance).exp() as f32).max(floor);
            let filter = color.filter * (1.0 - k);
            sum.factor += k * (Rgb::splat(1.0 - filter) + filter * color.rgb);
            sum.added += (1.0 - k) * color.rgb;
            sum.transparency *= k * color.transmit;
            n += 1.0;
        }
        if n == 0.0 { Veil::NONE } else { Veil { factor: sum.factor / n, added: sum.added / n, ..sum } }
    }
}

/// Position in the band and how far the arc has faded.
fn rainbow_index(rainbow: &Rainbow, direction: DVec3, jitter: f64) -> Option<(f64, f32)> {
    let along = direction.dot(rainbow.direction);
    let (x, y) = (direction.dot(rainbow.right), direction.dot(rainbow.up));
    let beta = (y / x.hypot(y)).clamp(-1.0, 1.0).acos().abs();
    if along < 0.0 || beta > rainbow.arc {
        return None;
    }
    let from = rainbow.angle - 0.5 * rainbow.width;
    let index = (along.clamp(-1.0, 1.0).acos() - from) / rainbow.width + jitter;
    if !(0.0..=1.0 - LEVEL).contains(&index) {
        return None;
    }
    let fade = if beta > rainbow.falloff && rainbow.arc > rainbow.falloff {
        let z = (beta - rainbow.falloff) / (rainbow.arc - rainbow.falloff);
        (z * z * (3.0 - 2.0 * z)) as f32
    } else {
        0.0
    };
    Some((index, fade))
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

/// What all fogs leave of light that runs along a ray.
pub(super) fn fog_factor(world: &World, ray: &Ray, length: f64) -> Rgb {
    world.atmosphere.fogs.iter().map(|fog| fog_transmittance(fog, ray, length) * fog_tint(fog)).product()
}

/// The colour that a fog gives to light behind it, whatever the distance.
fn fog_tint(fog: &Fog) -> Rgb {
    Rgb::splat(1.0 - fog.color.filter) + fog.color.filter * fog.color.rgb
}

/// What part of the light comes through a fog.
fn fog_transmittance(fog: &Fog, ray: &Ray, length: f64) -> f32 {
    let mean = if fog.ground { mean_density(fog, ray, length) } else { 1.0 };
    let thinned = match &fog.turbulence {
        None => length,
        Some(t) => {
            let noise = turbulence(t.generator, t.octaves, ray.at(0.5 * length) * t.scale);
            length * (1.0 - (-length / fog.distance).exp() * (t.depth * noise).min(1.0))
        }
    };
    ((-thinned * mean / fog.distance).exp() as f32).max(fog.color.transmit)
}

/// Mean density of a ground fog along a ray, 1 below its offset.
fn mean_density(fog: &Fog, ray: &Ray, length: f64) -> f64 {
    let height = |p: DVec3| (p.dot(fog.up) - fog.offset) / fog.altitude;
    let (a, e) = (height(ray.origin), height(ray.at(length)));
    let partly = |low: f64, high: f64| (high.atan() - low) / (high - low);
    match (a > 0.0, e > 0.0) {
        (false, false) => 1.0,
        (false, true) => partly(a, e),
        (true, false) => partly(e, a),
        (true, true) if (a - e).abs() > LEVEL => (a.atan() - e.atan()) / (a - e),
        (true, true) => 1.0 / (a * a + 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plane of colour <.2,.4,.8> at distance 4 of a height-3 camera looking along a slope.
    fn check(ground: bool, slope: f64, expected: f32) {
        let fog = Fog {
            ground,
            distance: 10.0,
            color: Color::rgb(0.5, 0.5, 0.5),
            offset: 0.5,
            altitude: 2.0,
            up: DVec3::Y,
            turbulence: None,
        };
        let direction = DVec3::new(slope, slope, 1.0);
        let length = 4.0 * direction.length();
        let ray = Ray::new(DVec3::new(0.0, 3.0, 0.0), direction.normalize());
        let k = fog_transmittance(&fog, &ray, length);
        let red = k * 0.2 + (1.0 - k) * 0.5;
        // The facts give four decimals.
        assert!((red - expected).abs() < 6e-5, "{red} instead of {expected}");
    }

    #[test]
    fn fog_is_that_of_povray() {
        check(false, 0.0, 0.2989);
        check(true, 0.5, 0.2354);
        check(true, -0.5, 0.2819);
    }
}
