//! Patterns made of noise and of waves; their values and their bumps.
//!
//! Source: sections 3, 4 and 14 of the pattern facts (measured).

use crate::math::lanes::{Lanes, Work, dispatch};
use crate::math::noise::{Congruential, NoiseGenerator, Octaves, halving_vector_noises, vector_noise};
use crate::math::sine::sines;
use crate::math::{DVec3, floor, fraction, full_turn_angle};
use bytemuck::cast;
use std::f64::consts::TAU;

/// One period of the sine is 1.
fn sine(turns: f64) -> f64 {
    (TAU * turns).sin()
}

/// Granite's first frequency.
pub(super) const GRANITE_SCALE: f64 = 4.0;
/// How many octaves of noise granite is.
pub(super) const GRANITE_OCTAVES: usize = 6;
/// How many octaves of noise wrinkles are.
pub(super) const WRINKLES_OCTAVES: usize = 10;

/// An octave of granite: a folded noise.
#[inline(always)]
pub(super) fn granite(generator: NoiseGenerator, noise: f64) -> f64 {
    match generator {
        NoiseGenerator::Original => (0.5 - noise).abs(),
        _ => (1.0 - 2.0 * noise).abs().min(0.5),
    }
}

/// An octave of wrinkles.
#[inline(always)]
pub(super) fn wrinkles(generator: NoiseGenerator, noise: f64) -> f64 {
    match generator {
        NoiseGenerator::Original => noise,
        _ => (2.0 * noise - 0.5).clamp(0.0, 1.0),
    }
}

/// Displacement of a normal by wrinkles.
pub(super) fn wrinkles_bump(p: DVec3) -> DVec3 {
    halving_vector_noises(p, WRINKLES_OCTAVES)
}

/// Agate: bands along z, shifted by `amount` times a turbulence.
pub(super) fn agate(amount: f64, turbulence: f64, p: DVec3) -> f64 {
    let bands = 0.5 * (sine(1.3 * amount * turbulence + 1.1 * p.z) + 1.0);
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

/// Marble: x, shifted by turbulence.
#[inline(always)]
pub(super) fn marble(shift: f64, p: DVec3) -> f64 {
    p.x + shift
}

/// Wood that wobbles: a distance from the z axis.
pub(super) fn wobbling_wood(amount: DVec3, turbulence: DVec3, p: DVec3) -> f64 {
    let x = p.x + sine((p.x + turbulence.x) * amount.x);
    let y = p.y + sine((p.y + turbulence.y) * amount.y);
    (x * x + y * y).sqrt()
}

/// The argument of both spirals: z plus radius plus angle, shifted by turbulence.
pub(super) fn spiral(arms: f64, shift: f64, p: DVec3) -> f64 {
    let r = (p.x * p.x + p.y * p.y).sqrt();
    // From -y turning toward +x.
    let angle = if r == 0.0 { 0.0 } else { full_turn_angle(p.x, -p.y) };
    p.z + r + arms * (angle * (1.0 / TAU)) + shift
}

/// A spiral and rings, both folded.
pub(super) fn double_spiral(arms: f64, shift: f64, p: DVec3) -> f64 {
    let folded = |v: f64| 1.0 - (2.0 * fraction(v) - 1.0).abs();
    folded((p.x * p.x + p.y * p.y).sqrt()) + folded(spiral(arms, shift, p))
}

/// Sources of ripples and waves, four a group.
#[derive(Clone, Debug)]
pub struct WaveSources {
    groups: Box<[SourceGroup]>,
    count: usize,
}

/// Four sources; what stands beyond the last one counts nothing.
#[derive(Clone, Copy, Debug)]
struct SourceGroup {
    /// Coordinates of unit vectors towards the sources.
    directions: [[f64; 4]; 3],
    frequencies: [f64; 4],
    /// 1 for a source, 0 for none.
    present: [f64; 4],
}

/// Which waves.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Waves {
    /// Of equal length.
    Ripples,
    /// Of different lengths; long ones are higher.
    Waves,
}

/// Seed of the frequencies, as measured.
const FREQUENCY_SEED: u32 = -560_851_967_i32 as u32;

impl WaveSources {
    /// `number_of_waves` sources.
    pub fn new(n: u32) -> Self {
        let mut random = Congruential(FREQUENCY_SEED);
        let nothing = SourceGroup { directions: [[0.0; 4]; 3], frequencies: [1.0; 4], present: [0.0; 4] };
        let mut groups = vec![nothing; (n as usize).div_ceil(4)];
        for i in 0..n as usize {
            let direction = vector_noise(DVec3::new(i as f64, 0.0, 0.0)).normalize_or(DVec3::X).to_array();
            let group = &mut groups[i / 4];
            for (coordinates, coordinate) in group.directions.iter_mut().zip(direction) {
                coordinates[i % 4] = coordinate;
            }
            // 1/32767 to as many digits as POV-Ray has, and a least frequency.
            group.frequencies[i % 4] = f64::from(random.draw()) * 0.000_030_518_509_476 + 0.01;
            group.present[i % 4] = 1.0;
        }
        Self { groups: groups.into(), count: n as usize }
    }

    /// Ripples of equal length.
    pub(super) fn ripples(&self, frequency: f64, phase: f64, p: DVec3) -> f64 {
        0.5 * (1.0 + self.mean::<false>(Waves::Ripples, frequency, phase, p).x)
    }

    /// Waves of different lengths; long ones are higher.
    pub(super) fn waves(&self, frequency: f64, phase: f64, p: DVec3) -> f64 {
        0.2 * (2.5 + self.mean::<false>(Waves::Waves, frequency, phase, p).x)
    }

    /// Displacement of a normal by ripples.
    pub(super) fn ripples_bump(&self, frequency: f64, phase: f64, p: DVec3) -> DVec3 {
        self.mean::<true>(Waves::Ripples, frequency, phase, p)
    }

    /// Displacement of a normal by waves.
    pub(super) fn waves_bump(&self, frequency: f64, phase: f64, p: DVec3) -> DVec3 {
        self.mean::<true>(Waves::Waves, frequency, phase, p)
    }

    /// Mean height of the waves of all sources, in x; for bumps heights times unit directions away from the sources.
    fn mean<const BUMP: bool>(&self, waves: Waves, frequency: f64, phase: f64, p: DVec3) -> DVec3 {
        dispatch(Heights::<BUMP> { groups: &self.groups, waves, frequency, phase, p }) * (1.0 / self.count as f64)
    }
}

/// The sum of the heights of waves.
struct Heights<'s, const BUMP: bool> {
    groups: &'s [SourceGroup],
    waves: Waves,
    frequency: f64,
    phase: f64,
    p: DVec3,
}

impl<const BUMP: bool> Work for Heights<'_, BUMP> {
    type Output = DVec3;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> DVec3 {
        let (zero, one, tau) = (simd.splat_f64s(0.0), simd.splat_f64s(1.0), simd.splat_f64s(TAU));
        let (frequency, phase) = (simd.splat_f64s(self.frequency), simd.splat_f64s(self.phase));
        let mut sums = [zero; 3];
        for group in self.groups {
            let x = simd.sub_f64s(simd.splat_f64s(self.p.x), cast(group.directions[0]));
            let y = simd.sub_f64s(simd.splat_f64s(self.p.y), cast(group.directions[1]));
            let z = simd.sub_f64s(simd.splat_f64s(self.p.z), cast(group.directions[2]));
            let squares = simd.add_f64s(simd.mul_f64s(x, x), simd.mul_f64s(y, y));
            let distance = simd.sqrt_f64s(simd.add_f64s(squares, simd.mul_f64s(z, z)));
            let distance = simd.select_f64s(simd.equal_f64s(distance, zero), one, distance);
            let own = cast(group.frequencies);
            let height = match self.waves {
                Waves::Ripples => {
                    let turns = simd.add_f64s(simd.mul_f64s(frequency, distance), phase);
                    sines(simd, simd.mul_f64s(tau, turns))
                }
                Waves::Waves => {
                    let turns = simd.mul_f64s(simd.mul_f64s(frequency, own), distance);
                    simd.div_f64s(sines(simd, simd.mul_f64s(tau, simd.add_f64s(turns, phase))), own)
                }
            };
            let height = simd.mul_f64s(height, cast(group.present));
            if BUMP {
                let height = simd.div_f64s(height, distance);
                sums[0] = simd.add_f64s(sums[0], simd.mul_f64s(x, height));
                sums[1] = simd.add_f64s(sums[1], simd.mul_f64s(y, height));
                sums[2] = simd.add_f64s(sums[2], simd.mul_f64s(z, height));
            } else {
                sums[0] = simd.add_f64s(sums[0], height);
            }
        }
        DVec3::new(simd.reduce_sum_f64s(sums[0]), simd.reduce_sum_f64s(sums[1]), simd.reduce_sum_f64s(sums[2]))
    }
}

/// Leopard: spots where the mean of three sines is far from 0.
pub(super) fn leopard([x, y, z]: [f64; 3]) -> f64 {
    let mean = (x + y + z) * (1.0 / 3.0);
    mean * mean
}

/// Quilted: a pillow in every unit cube. Gives the offset from the cube's centre and the height over it.
#[inline(always)]
fn pillow(control: [f64; 2], p: DVec3) -> (DVec3, f64) {
    // Rounds down, and from negative whole numbers one further, as in POV-Ray.
    let below = |v: f64| {
        let towards_zero = floor(v.abs());
        if v >= 0.0 { towards_zero } else { -towards_zero - 1.0 }
    };
    let offset = p - DVec3::new(below(p.x), below(p.y), below(p.z)) - 0.5;
    let t = offset.length();
    let u = 1.0 - t;
    // 2 / sqrt(3): the height is 1 at a corner of the cube.
    let height = 1.154_700_538 * t * (t * t + 3.0 * u * (u * control[0] + t * control[1]));
    (offset, height)
}

/// The value of quilted.
#[inline(always)]
pub(super) fn quilted(control: [f64; 2], p: DVec3) -> f64 {
    let (offset, height) = pillow(control, p);
    let size = offset.abs();
    (height * (size.x + size.y + size.z) * (1.0 / 3.0)).abs()
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
        // As many digits as the facts have.
        const FREQUENCY_DIGITS: f64 = 1e-12;
        const DIRECTION_DIGITS: f64 = 1e-6;
        for (i, expected) in frequencies.into_iter().enumerate() {
            assert!((w.groups[i / 4].frequencies[i % 4] - expected).abs() < FREQUENCY_DIGITS);
        }
        let direction = |i: usize| DVec3::from_array(w.groups[i / 4].directions.map(|lanes| lanes[i % 4]));
        let close =
            |i: usize, d: [f64; 3]| assert!((direction(i) - DVec3::from(d)).abs().max_element() < DIRECTION_DIGITS);
        close(0, [-0.604378, 0.492048, -0.626590]);
        close(9, [0.564897, 0.722041, -0.399436]);
    }
}
