//! From linear light to the whole numbers of a file.

use super::dither::Spread;
use super::{Curve, Encoding, Picture};

/// Height x width x channels, row by row from the top, each 0 to `max`.
#[derive(Debug, PartialEq)]
pub(super) struct Quantised {
    /// Pixels across and down.
    pub(super) size: [u32; 2],
    pub(super) channels: Channels,
    pub(super) max: u16,
    pub(super) values: Vec<u16>,
}

/// What stands for a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channels {
    Grey = 1,
    GreyAlpha = 2,
    Rgb = 3,
    Rgba = 4,
}

impl Quantised {
    /// Values of so many bits; alpha is straight, and where there is none colours stay premultiplied.
    ///
    /// Source: camera and image facts, sections 4.1 and 4.3.
    pub(super) fn new(picture: &Picture, channels: Channels, bits: u8, encoding: &Encoding) -> Self {
        let max = u16::MAX >> (16 - bits);
        let mut values = Vec::with_capacity(picture.pixels.len() * channels as usize);
        let mut spread = Spread::new(encoding, max, picture.width);
        for (i, &pixel) in picture.pixels.iter().enumerate() {
            let light = match channels {
                Channels::Grey => greyed(pixel, encoding.working),
                Channels::GreyAlpha => greyed(straight(pixel, encoding.working), encoding.working),
                Channels::Rgb => pixel,
                Channels::Rgba => straight(pixel, encoding.working),
            };
            let rounded = spread.rounded(light, [i % picture.width, i / picture.width]);
            match channels {
                Channels::GreyAlpha => values.extend([rounded[0], rounded[3]]),
                _ => values.extend(&rounded[..channels as usize]),
            }
        }
        Self { size: [picture.width as u32, picture.height as u32], channels, max, values }
    }

    /// As bytes, where values have no more than eight bits.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.values.iter().map(|value| *value as u8).collect()
    }
}

/// Grey of the scene's values, whatever curve those have, with alpha.
fn greyed([r, g, b, alpha]: [f32; 4], working: Curve) -> [f32; 4] {
    let [r, g, b] = [r, g, b].map(|light| working.encode(light));
    let grey = working.decode(grey([r, g, b, alpha]));
    [grey, grey, grey, alpha]
}

/// As POV-Ray weighs colours.
fn grey([r, g, b, _]: [f32; 4]) -> f32 {
    0.297 * r + 0.589 * g + 0.114 * b
}

/// Divided by alpha as values of the scene, whatever curve those have. Colours brighter than their alpha raise it, as in
/// POV-Ray.
fn straight([r, g, b, alpha]: [f32; 4], working: Curve) -> [f32; 4] {
    /// What a colour is divided by where there is nothing: measured.
    const LEAST_ALPHA: f32 = 1e-6;
    let [r, g, b] = [r, g, b].map(|light| working.encode(light));
    let alpha = alpha.max(grey([r, g, b, alpha]).min(1.0));
    let scale = alpha.max(LEAST_ALPHA).recip();
    let [r, g, b] = [r, g, b].map(|value| working.decode(value * scale));
    [r, g, b, alpha]
}

#[cfg(test)]
mod tests {
    use super::super::Dither;
    use super::*;

    fn check(pixel: [f32; 4], channels: Channels, encoding: Encoding, expected: &[u16]) {
        let picture = Picture::filled(1, 1, pixel);
        assert_eq!(Quantised::new(&picture, channels, encoding.bits, &encoding).values, expected, "{encoding:?}");
    }

    #[test]
    fn values_are_those_of_povray() {
        // Section 4 of the camera facts: the probes of a background <.5,.25,2> and of alpha.
        let with = |bits, curve| Encoding { bits, curve, ..Encoding::default() };
        let pixel = [0.5, 0.25, 2.0, 1.0];
        check(pixel, Channels::Rgb, with(8, Curve::Srgb), &[188, 137, 255]);
        check(pixel, Channels::Rgb, with(8, Curve::Power(1.0)), &[128, 64, 255]);
        check(pixel, Channels::Rgb, with(8, Curve::Power(2.2)), &[186, 136, 255]);
        check([0.5, 0.5, 0.5, 0.1], Channels::Rgba, Encoding::default(), &[255, 255, 255, 128]);
        check([0.5, 0.0, 0.0, 0.1], Channels::Rgba, with(8, Curve::Power(1.0)), &[255, 0, 0, 38]);
        // An edge in a scene of assumed_gamma 2.2.
        let edge = [0.000_847_8, 0.000_847_8, 0.000_847_8, 0.1];
        let working = Encoding { working: Curve::Power(2.2), ..Encoding::default() };
        check(edge, Channels::Rgba, working, &[103, 103, 103, 26]);
        // A colour <1,.5,.2> there.
        check([1.0, 0.217_64, 0.028_99, 1.0], Channels::Grey, Encoding { bits: 16, ..working }, &[40_628]);
        // Grey of straight colours, which are not cut at 1 before they are weighed.
        check([0.5, 0.0, 0.0, 0.1], Channels::GreyAlpha, with(8, Curve::Power(1.0)), &[255, 38]);
        check([1.0, 0.15, 0.1, 0.5], Channels::GreyAlpha, with(16, Curve::Power(1.0)), &[52_002, 32_768]);
        check([f32::NAN, -1.0, f32::INFINITY, 1.0], Channels::Rgb, Encoding::default(), &[0, 0, 255]);
    }

    #[test]
    fn dithered_values_keep_their_mean() {
        let picture = Picture::filled(48, 48, [0.5, 0.5, 0.5, 1.0]);
        let methods = [Dither::Ordered(2), Dither::Ordered(4), Dither::Next, Dither::Simple, Dither::FloydSteinberg];
        for method in methods {
            let encoding = Encoding { dither: Some(method), curve: Curve::Power(1.0), bits: 5, ..Encoding::default() };
            let values = Quantised::new(&picture, Channels::Rgb, 5, &encoding).values;
            // Thresholds of POV-Ray are too high by half of one in n² on the whole.
            let mean = values.iter().map(|v| f64::from(*v)).sum::<f64>() / values.len() as f64;
            assert!((mean - 15.5).abs() <= 0.25 && values.iter().any(|v| *v != values[0]), "{method:?} {mean}");
        }
    }
}
