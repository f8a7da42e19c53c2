//! What fills an object: refraction, attenuation, faked caustics.

use super::subsurface::ReducedAlbedo;
use crate::math::{Rgb, power};
use std::ops::Range;
use std::sync::Arc;

/// An interior with its defaults resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Interior {
    /// Index of refraction; 1 where none was given.
    pub ior: f64,
    /// Ratio of the indices for violet and red; 1 without dispersion or without an index.
    pub dispersion: f64,
    /// Rays that a white ray splits into.
    pub dispersion_samples: u32,
    /// Attenuation with distance, if any.
    pub fade: Option<InteriorFade>,
    /// Exponent of faked caustics; 0 for none.
    pub caustics: f64,
    /// Legacy factor of transmitted light.
    pub refraction: f32,
    /// Which of the world's media are in it.
    pub media: Range<usize>,
    /// From colours to what its material does with light below the surface, where a scene asks for that.
    pub reduced_albedo: Option<Arc<ReducedAlbedo>>,
}

impl Interior {
    /// Whether it changes what a ray carries or where it goes.
    pub fn is_optical(&self) -> bool {
        self.ior != 1.0 || self.dispersion != 1.0 || self.fade.is_some()
    }
}

/// Attenuation with the distance travelled inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InteriorFade {
    /// Distance at which half is left (or 1/e of it, for the exponential form).
    pub distance: f64,
    /// Power of the decay; 1000 and more mean exponential.
    pub power: f64,
    /// What is left at infinity.
    pub color: Rgb,
}

impl InteriorFade {
    /// What part of the light is left after a way of length `s`.
    ///
    /// Source: section 8.3 of the shading facts (measured).
    pub fn transmittance(&self, s: f64) -> Rgb {
        let ratio = s / self.distance;
        if self.power >= 1000.0 {
            let depth = ratio as f32;
            return ((self.color - Rgb::ONE) * depth).exp();
        }
        let share = 1.0 / (1.0 + power(ratio, self.power));
        self.color + (Rgb::ONE - self.color) * share as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(distance: f64, power: f64, color: [f32; 3], expected: [f32; 3]) {
        let fade = InteriorFade { distance, power, color: Rgb::from(color) };
        let found = 0.8 * fade.transmittance(2.0);
        assert!((found - Rgb::from(expected)).abs().max_element() < 2e-5, "{found} {expected:?}");
    }

    #[test]
    fn light_fades_as_in_povray() {
        check(1.0, 1.0, [0.0; 3], [0.266667; 3]);
        check(1.0, 2.0, [0.0; 3], [0.160006; 3]);
        check(1.0, 0.0, [0.0; 3], [0.4; 3]);
        check(1.0, -1.0, [0.0; 3], [0.533333; 3]);
        check(1.0, 2.0, [0.5, 0.2, 0.0], [0.480003, 0.287999, 0.160006]);
        check(1.0, 1000.0, [0.5, 0.2, 0.0], [0.294301, 0.161517, 0.108263]);
        check(3.0, 999.0, [0.5, 0.2, 0.0], [0.8; 3]);
    }
}
