//! Light that has arrived at a place, in 20 bytes.
//!
//! Colour and direction are as coarse as POV-Ray's: what is cut off shows. Source: photon facts, section 4 (measured).

use crate::math::{DVec3, Rgb};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Steps of a half turn.
const STEPS: f64 = 127.0;

/// Bits of the brightest channel.
const BITS: i32 = 8;

/// Light that has arrived at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct Photon {
    /// World space.
    position: [f32; 3],
    /// Of all channels: the brightest one is half of two to this power, or more.
    exponent: i16,
    channels: [u8; 3],
    /// Elevation and azimuth of the direction to where it came from, in steps.
    from: [i8; 2],
    /// The axis along which the map is split here.
    pub(super) axis: u8,
}

impl Photon {
    /// `from` is the unit direction to where it came from; `None` for light that is none.
    pub(in crate::render) fn new(position: DVec3, flux: Rgb, from: DVec3) -> Option<Self> {
        let brightest = flux.max_element();
        if !(brightest > 0.0 && brightest.is_finite() && position.is_finite()) {
            return None;
        }
        let exponent = exponent_of(brightest);
        let scale = f64::from(BITS - exponent).exp2();
        let channel = |value: f32| (f64::from(value) * scale) as u8;
        let step = |angle: f64| (angle / PI * STEPS) as i8;
        Some(Self {
            position: position.as_vec3().to_array(),
            exponent: exponent as i16,
            channels: [channel(flux.x), channel(flux.y), channel(flux.z)],
            from: [step(from.y.clamp(-1.0, 1.0).asin()), step(from.z.atan2(from.x))],
            axis: 0,
        })
    }

    /// World space.
    #[inline]
    pub(in crate::render) fn position(&self) -> DVec3 {
        let [x, y, z] = self.position.map(f64::from);
        DVec3::new(x, y, z)
    }

    /// Along one axis.
    #[inline]
    pub(super) fn coordinate(&self, axis: u8) -> f32 {
        self.position[usize::from(axis)]
    }

    /// Light times area, scene units.
    pub(in crate::render) fn flux(&self) -> Rgb {
        let scale = f64::from(i32::from(self.exponent) - BITS).exp2() as f32;
        let [r, g, b] = self.channels.map(f32::from);
        scale * Rgb::new(r, g, b)
    }

    /// Unit direction to where it came from.
    pub(in crate::render) fn from(&self) -> DVec3 {
        static TURNS: LazyLock<[(f64, f64); 256]> = LazyLock::new(turns);
        let [(y, across), (z, x)] = self.from.map(|step| TURNS[usize::from(step as u8)]);
        DVec3::new(across * x, y, across * z)
    }
}

/// Sines and cosines of all steps, by their bits.
fn turns() -> [(f64, f64); 256] {
    std::array::from_fn(|bits| (f64::from(bits as u8 as i8) * (PI / STEPS)).sin_cos())
}

/// The power of two that a number is half of, or more, and less than all.
fn exponent_of(value: f32) -> i32 {
    let exponent = value.log2().floor() as i32 + 1;
    // Logarithms are rounded.
    let share = f64::from(value) / f64::from(exponent).exp2();
    exponent + i32::from(share >= 1.0) - i32::from(share < 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_lose_less_than_a_step() {
        for (value, expected) in [(1.0, 1.0), (0.999, 0.996_093_75), (0.5, 0.5), (3e-9, 2.997e-9), (4e7, 39_845_888.0)]
        {
            let photon = Photon::new(DVec3::ONE, Rgb::new(value, 0.1 * value, 0.0), DVec3::Y).unwrap();
            let found = photon.flux();
            assert!((found.x / expected - 1.0).abs() < 1e-3, "{value}: {found}");
            assert!(
                found.x <= value && found.y <= 0.1 * value && found.y > (0.1 - 1.0 / 128.0) * value && found.z == 0.0
            );
        }
        assert!([0.0, -1.0, f32::NAN].iter().all(|v| Photon::new(DVec3::ONE, Rgb::splat(*v), DVec3::Y).is_none()));
    }

    #[test]
    fn directions_come_back_within_a_step() {
        for from in [DVec3::Y, -DVec3::Y, DVec3::X, -DVec3::X, DVec3::Z, DVec3::new(-0.6, 0.48, -0.64)] {
            let found = Photon::new(DVec3::ZERO, Rgb::ONE, from).unwrap().from();
            // Each angle is cut by a step at most.
            assert!(found.dot(from) > (2.0_f64.sqrt() * PI / STEPS).cos(), "{from} {found}");
        }
        assert_eq!(size_of::<Photon>(), 20);
    }
}
