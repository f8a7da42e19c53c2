//! Patterns made of noise, and of waves from scattered sources; their values and their bumps.
//!
//! Source: sections 3, 4 and 14 of the pattern facts (measured).

use crate::math::noise::{
    Congruential, NoiseGenerator, Octaves, halving_noises, halving_vector_noises, turbulence, vector_noise,
    vector_turbulence,
};
use crate::math::{DVec2, DVec3, fraction};
use std::f64::consts::TAU;
use std::iter::Sum;
use std::ops::Mul;

/// One period of the sine is 1.
fn sine(turns: f64) -> f64 {
    (TAU * turns).sin()
}

/// Granite: six octaves of folded noise.
pub(super) fn granite(generator: NoiseGenerator, p: DVec3) -> f64 {
    halving_noises(
        generator,
        p,
        4.0,
        6,
        #[inline(always)]
        |n| match generator {
            NoiseGenerator::Original => (0.5 - n).abs(),
            _ => (1.0 - 2.0 * n).abs().min(0.5),
        },
    )
}

/// Wrinkles: ten octaves of noise.
pub(super) fn wrinkles(generator: NoiseGenerator, p: DVec3) -> f64 {
    let sum = halving_noises(
        generator,
        p,
        1.0,
        10,
        #[inline(always)]
        |n| match generator {
            NoiseGenerator::Original => n,
            _ => (2.0 * n - 0.5).clamp(0.0, 1.0),
        },
    );
    0.5 * sum
}

/// Displacement of a normal by wrinkles.
pub(super) fn wrinkles_bump(p: DVec3) -> DVec3 {
    halving_vector_noises(p, 10)
}

/// Agate: bands along z, shifted by turbulence of strength `amount`.
pub(super) fn agate(generator: NoiseGenerator, octaves: Octaves, amount: f64, p: DVec3) -> f64 {
    let bands = 0.5 * (sine(1.3 * amount * turbulence(generator, octaves, p) + 1.1 * p.z) + 1.0);
    bands.clamp(0.0, 1.0).powf(0.77)
}

/// Turbulence that enters a formula instead of moving its point.
#[derive(Clone, Copy, Debug)]
pub struct InnerTurbulence {
    /// Strength per axis.
    pub amount: DVec3,
    /// Octaves.
    pub octaves: Octaves,
    /// Noise of the scalar kind.
    pub generator: NoiseGenerator,
}

impl InnerTurbulence {
    fn scalar(&self, p: DVec3) -> f64 {
        self.amount.x * turbulence(self.generator, self.octaves, p)
    }
}

/// Marble: x, shifted.
pub(super) fn marble(inner: Option<&InnerTurbulence>, p: DVec3) -> f64 {
    p.x + inner.map_or(0.0, |t| t.scalar(p))
}

/// Wood: distance from the z axis, wobbling.
pub(super) fn wood(inner: Option<&InnerTurbulence>, p: DVec3) -> f64 {
    let Some(t) = inner else { return p.x.hypot(p.y) };
    let d = vector_turbulence(t.octaves, p);
    let ring = DVec2::new(p.x + sine((p.x + d.x) * t.amount.x), p.y + sine((p.y + d.y) * t.amount.y));
    (ring.x * ring.x + ring.y * ring.y).sqrt()
}

/// The argument of both spirals: z plus radius plus angle.
pub(super) fn spiral(arms: f64, inner: Option<&InnerTurbulence>, p: DVec3) -> f64 {
    let r = (p.x * p.x + p.y * p.y).sqrt();
    // From -y turning toward +x.
    let angle = if r == 0.0 { 0.0 } else { p.x.atan2(-p.y).rem_euclid(TAU) };
    p.z + r + arms * angle / TAU + inner.map_or(0.0, |t| t.scalar(p))
}

/// A spiral and rings, both folded.
pub(super) fn double_spiral(arms: f64, inner: Option<&InnerTurbulence>, p: DVec3) -> f64 {
    let folded = |v: f64| 1.0 - (2.0 * fraction(v) - 1.0).abs();
    folded((p.x * p.x + p.y * p.y).sqrt()) + folded(spiral(arms, inner, p))
}

/// Sources of ripples and waves: unit directions and frequencies.
#[derive(Clone, Debug)]
pub struct WaveSources {
    sources: Vec<(DVec3, f64)>,
}

/// Seed of the frequencies, as measured.
const FREQUENCY_SEED: u32 = -560_851_967_i32 as u32;

impl WaveSources {
    /// `number_of_waves` sources.
    pub fn new(n: u32) -> Self {
        let mut random = Congruential(FREQUENCY_SEED);
        let source = |i: u32| {
            let direction = vector_noise(DVec3::new(f64::from(i), 0.0, 0.0)).normalize_or(DVec3::X);
            // 1/32767 to as many digits as POV-Ray has, and a least frequency.
            (direction, f64::from(random.draw()) * 0.000_030_518_509_476 + 0.01)
        };
        Self { sources: (0..n).map(source).collect() }
    }

    /// Mean of `term` over all sources; it gets the unit direction from a source, the distance and the frequency.
    fn mean<T>(&self, p: DVec3, term: impl Fn(DVec3, f64, f64) -> T) -> T
    where
        T: Sum + Mul<f64, Output = T>,
    {
        let sum: T = self
            .sources
            .iter()
            .map(|(source, w)| {
                let offset = p - *source;
                let distance = offset.length();
                let distance = if distance == 0.0 { 1.0 } else { distance };
                term(offset / distance, distance, *w)
            })
            .sum();
        sum * (1.0 / self.sources.len() as f64)
    }

    /// Ripples of equal length.
    pub(super) fn ripples(&self, frequency: f64, phase: f64, p: DVec3) -> f64 {
        0.5 * (1.0 + self.mean(p, |_, d, _| sine(frequency * d + phase)))
    }

    /// Waves of different lengths; long ones are higher.
    pub(super) fn waves(&self, frequency: f64, phase: f64, p: DVec3) -> f64 {
        0.2 * (2.5 + self.mean(p, |_, d, w| sine(frequency * w * d + phase) / w))
    }

    /// Displacement of a normal by ripples.
    pub(super) fn ripples_bump(&self, frequency: f64, phase: f64, p: DVec3) -> DVec3 {
        self.mean(p, |away, d, _| away * sine(frequency * d + phase))
    }

    /// Displacement of a normal by waves.
    pub(super) fn waves_bump(&self, frequency: f64, phase: f64, p: DVec3) -> DVec3 {
        self.mean(p, |away, d, w| away * (sine(frequency * w * d + phase) / w))
    }
}

/// Quilted: a pillow in every unit cube. Gives the offset from the cube's centre and the height over it.
fn pillow(control: [f64; 2], p: DVec3) -> (DVec3, f64) {
    // Rounds down, and from negative whole numbers one further, as in POV-Ray.
    let below = |v: f64| if v >= 0.0 { v.trunc() } else { v.trunc() - 1.0 };
    let offset = p - DVec3::new(below(p.x), below(p.y), below(p.z)) - 0.5;
    let t = offset.length();
    let u = 1.0 - t;
    // 2 / sqrt(3): the height is 1 at a corner of the cube.
    let height = 1.154_700_538 * (t * t * t + 3.0 * t * u * u * control[0] + 3.0 * t * t * u * control[1]);
    (offset, height)
}

/// The value of quilted.
pub(super) fn quilted(control: [f64; 2], p: DVec3) -> f64 {
    let (offset, height) = pillow(control, p);
    let size = offset.abs();
    (height * (size.x + size.y + size.z) / 3.0).abs()
}

/// Displacement of a normal by quilted.
pub(super) fn quilted_bump(control: [f64; 2], p: DVec3) -> DVec3 {
    let (offset, height) = pillow(control, p);
    height * offset
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_are_those_of_povray() {
        let w = WaveSources::new(10);
        let frequencies = [0.919115878781, 0.960041199988, 0.433169652394, 0.709301126133, 0.689189428388];
        for (source, expected) in w.sources.iter().zip(frequencies) {
            assert!((source.1 - expected).abs() < 1e-12);
        }
        let close = |i: usize, d: [f64; 3]| assert!((w.sources[i].0 - DVec3::from(d)).abs().max_element() < 1e-6);
        close(0, [-0.604378, 0.492048, -0.626590]);
        close(9, [0.564897, 0.722041, -0.399436]);
    }
}
