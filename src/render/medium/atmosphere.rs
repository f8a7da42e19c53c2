//! Rainbows and fog along a segment of a ray.
//!
//! Source: section 6 of the camera and image facts (measured).

use crate::compiled::World;
use crate::compiled::atmosphere::{Fog, Rainbow};
use crate::compiled::texture::Context;
use crate::math::noise::turbulence;
use crate::math::{DVec3, Ray, Rgb, gray};
use crate::render::random::{Dimension, Random};

/// POV-Ray's own limit for ground fog that keeps its height.
const LEVEL: f64 = 1e-10;

/// What a segment of a ray does to the light at its far end: some is lost, some is scattered in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct Airlight {
    /// Factor of the light from the far end.
    pub(in crate::render) transmittance: Rgb,
    /// Light that is added.
    pub(in crate::render) radiance: Rgb,
    /// Factor of the backdrop's share.
    pub(in crate::render) transparency: f32,
}

impl Airlight {
    /// Nothing at all.
    const NONE: Self = Self { transmittance: Rgb::ONE, radiance: Rgb::ZERO, transparency: 1.0 };
}

/// What rainbows and fog do along a segment that starts with the ray and lies in no solid object; `None` where a scene
/// has neither.
pub(in crate::render) fn airlight(world: &World, ray: &Ray, length: f64, random: Random) -> Option<Airlight> {
    let atmosphere = &world.atmosphere;
    if atmosphere.is_clear() {
        return None;
    }
    let rainbows = rainbow(world, ray, length, random);
    let Airlight { transmittance, radiance, .. } = fog(world, ray, length);
    Some(Airlight {
        transmittance: transmittance * rainbows.transmittance,
        radiance: transmittance * rainbows.radiance + radiance,
        transparency: gray(transmittance) * rainbows.transparency,
    })
}

/// What rainbows do along a segment of a ray.
pub(in crate::render) fn rainbow(world: &World, ray: &Ray, length: f64, random: Random) -> Airlight {
    rainbows(&world.atmosphere.rainbows, ray.direction, length, random)
}

/// What fogs do along a segment of a ray.
pub(in crate::render) fn fog(world: &World, ray: &Ray, length: f64) -> Airlight {
    let mut transmittance = Rgb::ONE;
    let mut radiance = Rgb::ZERO;
    for fog in &world.atmosphere.fogs {
        let k = transmittance_of(fog, ray, length);
        transmittance *= k * fog_tint(fog);
        radiance += (1.0 - k) * fog.color.rgb;
    }
    Airlight { transmittance, radiance, transparency: gray(transmittance) }
}

/// The mean of all rainbows that show in a direction.
fn rainbows(rainbows: &[Rainbow], direction: DVec3, length: f64, random: Random) -> Airlight {
    let mut sum = Airlight { transmittance: Rgb::ZERO, ..Airlight::NONE };
    let mut n = 0.0;
    for (i, rainbow) in rainbows.iter().enumerate() {
        let jitter = match rainbow.jitter {
            0.0 => 0.0,
            amount => amount * (2.0 * random.unit(Dimension::Rainbow(i)) - 1.0),
        };
        let Some((index, fade)) = rainbow_index(rainbow, direction, jitter) else { continue };
        let color = rainbow.pigment.color_or_clear(DVec3::new(index, 0.0, 0.0), &Context::default());
        let floor = fade * (1.0 - color.transmit) + color.transmit;
        let k = ((-length / rainbow.distance).exp() as f32).max(floor);
        let filter = color.filter * (1.0 - k);
        sum.transmittance += k * (Rgb::splat(1.0 - filter) + filter * color.rgb);
        sum.radiance += (1.0 - k) * color.rgb;
        sum.transparency *= k * color.transmit;
        n += 1.0;
    }
    if n == 0.0 {
        return Airlight::NONE;
    }
    Airlight { transmittance: sum.transmittance / n, radiance: sum.radiance / n, ..sum }
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

/// What all fogs leave of light that runs along a ray.
pub(in crate::render) fn fog_transmittance(world: &World, ray: &Ray, length: f64) -> Rgb {
    world.atmosphere.fogs.iter().map(|fog| transmittance_of(fog, ray, length) * fog_tint(fog)).product()
}

/// The colour that a fog gives to light behind it, whatever the distance.
fn fog_tint(fog: &Fog) -> Rgb {
    Rgb::splat(1.0 - fog.color.filter) + fog.color.filter * fog.color.rgb
}

/// What part of the light comes through a fog.
fn transmittance_of(fog: &Fog, ray: &Ray, length: f64) -> f32 {
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
///
/// Without an altitude the offset's own height is not a number, which counts as above, as in POV-Ray.
fn mean_density(fog: &Fog, ray: &Ray, length: f64) -> f64 {
    let height = |p: DVec3| (p.dot(fog.up) - fog.offset) / fog.altitude;
    let (a, e) = (height(ray.origin), height(ray.at(length)));
    let partly = |low: f64, high: f64| (high.atan() - low) / (high - low);
    match (a <= 0.0, e <= 0.0) {
        (true, true) => 1.0,
        (true, false) => partly(a, e),
        (false, true) => partly(e, a),
        (false, false) if (a - e).abs() > LEVEL => (a.atan() - e.atan()) / (a - e),
        (false, false) => 1.0 / (a * a + 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Color;

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
        let k = transmittance_of(&fog, &ray, length);
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
