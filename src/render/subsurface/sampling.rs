//! Where samples lie: evenly shifted lattices, so that a mean over them has the expected value of POV-Ray's, with less
//! noise.

use super::Material;
use crate::math::DVec3;
use crate::render::random::{Dimension, Random};
use std::f64::consts::TAU;

/// The golden ratio less 1.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// How many of POV-Ray's directions on the outward side are looked along, in percent: with all of them errors are half of
/// POV-Ray's, with three in five no larger (subsurface facts, section 8).
const OUTWARD: u32 = 60;

/// Which part of that is looked along into a thick object: what is met there is far, and shows little of its light.
const INWARD: u32 = 4;

/// Directions over the whole sphere, of which those that go deeper into a thick object are fewer, and count more.
pub(in crate::render) struct Directions {
    outward: DVec3,
    across: [DVec3; 2],
    /// On either side, together with the first.
    n: [u32; 2],
}

impl Directions {
    /// For an error as of POV-Ray's `wanted` directions; `outward` is a unit normal. Where the other side is as near, as
    /// many go there.
    pub(in crate::render) fn new(wanted: u32, outward: DVec3, is_thin: bool) -> Self {
        let (x, y) = outward.any_orthonormal_pair();
        let half = (wanted.saturating_mul(OUTWARD) / 100).div_ceil(2).max(wanted.min(1));
        let inward = if is_thin { half } else { half.div_ceil(INWARD) };
        Self { outward, across: [x, y], n: [half, inward] }
    }

    pub(in crate::render) fn len(&self) -> u32 {
        self.n[0] + self.n[1]
    }

    /// Direction `i`, and the share of the sphere for which it stands; for random shifts it is uniform over its side.
    ///
    /// Source: a lattice of the golden ratio shifted on the torus (Cranley and Patterson, "Randomization of Number Theoretic
    /// Methods for Multiple Integration", SIAM Journal on Numerical Analysis 13 (6), 1976), through Archimedes' map.
    pub(in crate::render) fn get(&self, i: u32, [shift, turn]: [f64; 2]) -> (DVec3, f64) {
        let (k, n, side) = if i < self.n[0] { (i, self.n[0], 1.0) } else { (i - self.n[0], self.n[1], -1.0) };
        let x = side * (f64::from(k) + shift) / f64::from(n);
        let angle = TAU * (f64::from(k) * GOLDEN + turn).fract();
        let radius = (1.0 - x * x).max(0.0).sqrt();
        let [across, along] = self.across;
        (x * self.outward + radius * (angle.cos() * across + angle.sin() * along), 0.5 / f64::from(n))
    }
}

/// Leaves out most samples that count for much less than those before, and lets the others stand for them.
///
/// Source: Arvo and Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990.
#[derive(Default)]
pub(in crate::render) struct Roulette {
    sum: f64,
    n: u32,
}

impl Roulette {
    /// Samples that count for less than this share of the mean are at risk: few enough of them are left to be cheap, and
    /// each counts for so little that it shows nowhere.
    const AT_RISK: f64 = 0.25;

    /// By what a sample is multiplied; none if it is left out.
    pub(in crate::render) fn weight(&mut self, visible: f64, random: Random) -> Option<f64> {
        let limit = Self::AT_RISK * self.sum / f64::from(self.n.max(1));
        self.sum += visible;
        self.n += 1;
        if visible >= limit {
            return Some(1.0);
        }
        (random.unit(Dimension::Roulette) * limit < visible).then(|| limit / visible)
    }
}

/// Depths at which light may have been scattered once on its way out.
///
/// POV-Ray draws a depth s for each channel by σ e^(-σs), and weighs what it finds by e^(-σs) again. The same mean comes
/// from depths by 2σ e^(-2σs), half as much each and with less noise; and a depth drawn for one channel serves all, by the
/// balance heuristic (Veach and Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995).
pub(in crate::render) struct Depths<'m> {
    material: &'m Material,
    /// Which channels let light through; the first `n` count.
    channels: [usize; 3],
    n: usize,
    /// Of each channel, the share of depths that lie within the object.
    within: DVec3,
}

impl<'m> Depths<'m> {
    /// Down to `most`, in mm.
    pub(in crate::render) fn new(material: &'m Material, most: f64) -> Self {
        let mut channels = [0; 3];
        let mut n = 0;
        for channel in 0..3 {
            if material.scattering[channel] > 0.0 {
                channels[n] = channel;
                n += 1;
            }
        }
        Self { material, channels, n, within: (-2.0 * material.extinction * most).map(|v| -v.exp_m1()) }
    }

    /// Depth `i` of `n` in mm, and what light from there counts for each channel, extinction on the way out included;
    /// none if no channel lets light through.
    pub(in crate::render) fn depth(&self, i: u32, n: u32, [shift, start]: [f64; 2]) -> Option<(f64, DVec3)> {
        let first = (start * self.n as f64) as usize;
        let channel = *self.channels.get((first + i as usize) % self.n.max(1)).filter(|_| self.n > 0)?;
        let position = (f64::from(i) + shift) / f64::from(n);
        let depth = (-position * self.within[channel]).ln_1p() / (-2.0 * self.material.extinction[channel]);
        let falloff = self.material.extinction * (-2.0 * self.material.extinction * depth).exp();
        let density = |channel: &usize| 2.0 * falloff[*channel] / self.within[*channel];
        let mean = self.channels[..self.n].iter().map(density).sum::<f64>() / self.n as f64;
        Some((depth, falloff / mean))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled::subsurface::ReducedAlbedo;
    use crate::math::Rgb;

    #[test]
    fn directions_are_even() {
        for is_thin in [true, false] {
            let directions = Directions::new(1000, DVec3::new(0.48, 0.6, 0.64), is_thin);
            let all = || (0..directions.len()).map(|i| directions.get(i, [0.25, 0.75]));
            let share = all().map(|(_, share)| share).sum::<f64>();
            let mean = all().map(|(d, share)| share * d).sum::<DVec3>();
            let squares = all().map(|(d, share)| share * d * d).sum::<DVec3>();
            // Lattices err by about 1 / n, and the smallest has 75.
            assert!(mean.length() < 1e-2 && (squares - 1.0 / 3.0).abs().max_element() < 1e-2, "{mean} {squares}");
            assert!((share - 1.0).abs() < 1e-12 && all().all(|(d, _)| (d.length() - 1.0).abs() < 1e-12));
        }
    }

    #[test]
    fn roulette_keeps_the_mean() {
        let n = 20_000;
        let mut roulette = Roulette::default();
        let light = |i: u32| if i.is_multiple_of(5) { 1.0 } else { 0.01 };
        let (mut sum, mut kept) = (0.0, 0);
        for i in 0..n {
            if let Some(weight) = roulette.weight(light(i), Random::at(f64::from(i), 0.0)) {
                sum += weight * light(i);
                kept += 1;
            }
        }
        let exact: f64 = (0..n).map(light).sum();
        // Of 16,000 small samples about one in five counts, as 0.052: a standard deviation of 2.6 in the sum.
        assert!((sum - exact).abs() < 10.0 && kept < n / 2, "{sum} {exact} {kept}");
    }

    /// The weights add up to the integral of σ e^(-2σs), in an object of any depth.
    #[test]
    fn depths_have_povrays_mean() {
        let table = ReducedAlbedo::new(1.3);
        for (color, most) in [([0.8, 0.4, 0.2], f64::INFINITY), ([0.8, 0.4, 0.2], 0.3), ([0.8, 0.0, 0.2], 0.01)] {
            let material = Material::new(&table, Rgb::from(color), Rgb::new(0.5, 0.1, 2.0), 1.3);
            let depths = Depths::new(&material, most);
            let n = 999;
            let weights = (0..n).filter_map(|i| depths.depth(i, n, [0.5, 0.1]));
            let mean = weights.map(|(_, weight)| weight).sum::<DVec3>() / f64::from(n);
            for channel in (0..3).filter(|c| material.scattering[*c] > 0.0) {
                let exact = 0.5 * -(-2.0 * material.extinction[channel] * most).exp_m1();
                assert!((mean[channel] / exact - 1.0).abs() < 2e-3, "{mean} {exact} {channel}");
            }
        }
    }
}
