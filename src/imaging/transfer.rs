//! The sRGB transfer curve.

/// Display value of linear light; the linear segment goes on below 0, the power above 1.
///
/// Source: IEC 61966-2-1.
pub fn srgb_from_linear(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// Linear light of a display value; inverse of [`srgb_from_linear`].
pub fn linear_from_srgb(display: f32) -> f32 {
    if display < 0.040_45 { display / 12.92 } else { ((display + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_and_its_inverse_agree() {
        for i in -100..=400 {
            let v = i as f32 / 200.0;
            // The two published breakpoints differ by 3e-8 in linear light; 5e-6 covers that and rounding.
            assert!((linear_from_srgb(srgb_from_linear(v)) - v).abs() < 5e-6, "{v}");
        }
    }
}
