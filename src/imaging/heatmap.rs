//! Where two pictures differ, as a picture.

use super::{ImageError, Picture, linear_from_srgb, metrics::display_distance};

/// Black where the pictures agree, then blue, red, yellow and white at 64 of 255 and more.
///
/// # Errors
/// [`ImageError::SizeMismatch`].
pub fn heatmap(a: &Picture, b: &Picture) -> Result<Picture, ImageError> {
    if (a.width, a.height) != (b.width, b.height) {
        return Err(ImageError::SizeMismatch([a.width, a.height], [b.width, b.height]));
    }
    let mut map = Picture::filled(a.width, a.height, [0.0, 0.0, 0.0, 1.0]);
    for (out, (a, b)) in map.pixels.iter_mut().zip(a.pixels.iter().zip(&b.pixels)) {
        let color = ramp((display_distance(a, b) / 64.0) as f32);
        *out = [linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2]), 1.0];
    }
    Ok(map)
}

/// Display colour of a difference, 0 to 1; what is not a number is white.
fn ramp(t: f32) -> [f32; 3] {
    const STOPS: [[f32; 3]; 5] = [[0.0, 0.0, 0.0], [0.1, 0.1, 0.8], [0.8, 0.1, 0.2], [1.0, 0.85, 0.0], [1.0, 1.0, 1.0]];
    // Steeper at the start, because small differences are the ones looked for.
    let position = if t.is_nan() { 4.0 } else { t.clamp(0.0, 1.0).sqrt() * 4.0 };
    let i = (position as usize).min(3);
    let f = position - i as f32;
    std::array::from_fn(|c| STOPS[i][c] + f * (STOPS[i + 1][c] - STOPS[i][c]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_is_black_and_far_is_white() {
        let (a, b) = (Picture::filled(1, 1, [0.0; 4]), Picture::filled(1, 1, [1.0; 4]));
        assert_eq!(heatmap(&a, &a).unwrap().pixels[0], [0.0, 0.0, 0.0, 1.0]);
        assert!(heatmap(&a, &b).unwrap().pixels[0][..3].iter().all(|v| *v > 0.99));
    }
}
