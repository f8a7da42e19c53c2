//! Where samples lie: evenly shifted lattices, so that a mean over them has the expected value of POV-Ray's, with less
//! noise.

use super::Material;
use crate::math::DVec3;
use std::f64::consts::TAU;

/// The golden ratio less 1.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Direction `i` of `n`, spread evenly over the sphere; for random shifts each by itself is uniform.
///
/// Source: a lattice of the golden ratio shifted on the torus (Cranley and Patterson, "Randomization of Number Theoretic
/// Methods for Multiple Integration", SIAM Journal on Numerical Analysis 13 (6), 1976), through Archimedes' map.
pub(in crate::render) fn direction(i: u32, n: u32, [shift, turn]: [f64; 2]) -> DVec3 {
    let x = 2.0 * (f64::from(i) + shift) / f64::from(n) - 1.0;
    let angle = TAU * (f64::from(i) * GOLDEN + turn).fract();
    let radius = (1.0 - x * x).max(0.0).sqrt();
    DVec3::new(x, radius * angle.cos(), radius * angle.sin())
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
        let n = 1000;
        let all = || (0..n).map(|i| direction(i, n, [0.25, 0.75]));
        let mean = all().sum::<DVec3>() / f64::from(n);
        let squares = all().map(|d| d * d).sum::<DVec3>() / f64::from(n);
        // Lattices err by about 1 / n.
        assert!(mean.length() < 5e-3 && (squares - 1.0 / 3.0).abs().max_element() < 5e-3, "{mean} {squares}");
        assert!(all().all(|d| (d.length() - 1.0).abs() < 1e-12));
    }

    /// The weights add up to the integral of σ e^(-2σs), in an object of any depth.
    #[test]
    fn depths_have_povrays_mean() {
        let table = ReducedAlbedo::new(1.3);
        for (color, most) in [([0.8, 0.4, 0.2], f64::INFINITY), ([0.8, 0.4, 0.2], 0.3), ([0.8, 0.0, 0.2], 0.01)] {
            let material = Material::new(&table, Rgb::from(color), Rgb::new(0.5, 0.1, 2.0));
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
