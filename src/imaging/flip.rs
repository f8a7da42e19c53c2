//! FLIP: the difference that a person sees when flipping between two pictures.
//!
//! Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A
//! Difference Evaluator for Alternating Images", HPG 2020, for display (low dynamic range)
//! pictures. Constants are the paper's; the viewer sits 0.7 m from a screen 0.7 m wide
//! with 3840 pixels across.

use super::Picture;

/// Pixels in a degree of the visual field.
const PIXELS_PER_DEGREE: f64 = 3840.0 * std::f64::consts::PI / 180.0;
/// Exponent of the colour difference (paper, section 4.1.4).
const Q_C: f64 = 0.7;
/// Exponent of the feature difference (section 4.2.3).
const Q_F: f64 = 0.5;
/// Share of the largest colour difference that is mapped to [`P_T`].
const P_C: f64 = 0.4;
/// See [`P_C`].
const P_T: f64 = 0.95;

type Triple = [f64; 3];

/// One plane of numbers, row-major.
struct Plane {
    width: usize,
    height: usize,
    data: Vec<f64>,
}

/// Perceived difference of each pixel, 0 (equal) to 1; pictures must have the same size.
pub fn flip(reference: &Picture, test: &Picture) -> Vec<f32> {
    let [a, b] = [reference, test].map(opponent_planes);
    let colors = color_difference(&a, &b);
    let features = feature_difference(&a[0], &b[0]);
    colors.iter().zip(&features).map(|(c, f)| c.powf(1.0 - f) as f32).collect()
}

/// Y, Cx and Cz of the clamped picture.
fn opponent_planes(picture: &Picture) -> [Plane; 3] {
    let mut planes: [Plane; 3] = std::array::from_fn(|_| Plane {
        width: picture.width,
        height: picture.height,
        data: Vec::with_capacity(picture.pixels.len()),
    });
    for pixel in &picture.pixels {
        // A comparison with NaN is false, so NaN becomes 0.
        let rgb = [0, 1, 2].map(|i| if pixel[i] > 0.0 { f64::from(pixel[i].min(1.0)) } else { 0.0 });
        let ycc = opponent_from_xyz(xyz_from_rgb(rgb));
        planes.iter_mut().zip(ycc).for_each(|(plane, v)| plane.data.push(v));
    }
    planes
}

fn color_difference(a: &[Plane; 3], b: &[Plane; 3]) -> Vec<f64> {
    // Contrast sensitivity as sums of Gaussians: weights and widths, section 4.1.1.
    let sensitivities = [vec![(1.0, 0.0047)], vec![(1.0, 0.0053)], vec![(34.1, 0.04), (13.5, 0.025)]];
    let filter = |planes: &[Plane; 3]| -> [Plane; 3] {
        std::array::from_fn(|i| contrast_filtered(&planes[i], &sensitivities[i]))
    };
    let (a, b) = (filter(a), filter(b));
    let lab = |p: &[Plane; 3], i: usize| hunt_lab(rgb_from_xyz(xyz_from_opponent([0, 1, 2].map(|c| p[c].data[i]))));
    let largest = hyab(hunt_lab([0.0, 1.0, 0.0]), hunt_lab([0.0, 0.0, 1.0])).powf(Q_C);
    let knee = P_C * largest;
    let redistribute = |e: f64| {
        if e < knee { P_T / knee * e } else { P_T + (e - knee) / (largest - knee) * (1.0 - P_T) }
    };
    (0..a[0].data.len()).map(|i| redistribute(hyab(lab(&a, i), lab(&b, i)).powf(Q_C))).collect()
}

fn contrast_filtered(plane: &Plane, gaussians: &[(f64, f64)]) -> Plane {
    // Three standard deviations of the widest Gaussian of all channels.
    let radius = (3.0 * (0.04 / (2.0 * std::f64::consts::PI.powi(2))).sqrt() * PIXELS_PER_DEGREE).ceil() as i64;
    let mut sum = vec![0.0; plane.data.len()];
    let mut total = 0.0;
    for &(weight, width) in gaussians {
        let kernel: Vec<f64> = (-radius..=radius)
            .map(|i| (-(std::f64::consts::PI * i as f64 / PIXELS_PER_DEGREE).powi(2) / width).exp())
            .collect();
        let amount = weight * (std::f64::consts::PI / width).sqrt();
        total += amount * kernel.iter().sum::<f64>().powi(2);
        let filtered = separable(plane, &kernel, &kernel);
        sum.iter_mut().zip(&filtered.data).for_each(|(s, v)| *s += amount * v);
    }
    sum.iter_mut().for_each(|s| *s /= total);
    Plane { width: plane.width, height: plane.height, data: sum }
}

/// Difference of edges and points in luminance, section 4.2.
fn feature_difference(a: &Plane, b: &Plane) -> Vec<f64> {
    let deviation = 0.5 * 0.082 * PIXELS_PER_DEGREE;
    let radius = (3.0 * deviation).ceil() as i64;
    let offsets: Vec<f64> = (-radius..=radius).map(|i| i as f64).collect();
    let gaussian: Vec<f64> = offsets.iter().map(|x| (-x * x / (2.0 * deviation * deviation)).exp()).collect();
    let blur: Vec<f64> = gaussian.iter().map(|g| g / gaussian.iter().sum::<f64>()).collect();
    let edge = balanced(offsets.iter().zip(&gaussian).map(|(x, g)| -x * g).collect());
    let point =
        balanced(offsets.iter().zip(&gaussian).map(|(x, g)| (x * x / (deviation * deviation) - 1.0) * g).collect());
    let magnitudes = |plane: &Plane, kernel: &[f64]| -> Vec<f64> {
        let luminance = Plane { data: plane.data.iter().map(|y| (y + 16.0) / 116.0).collect(), ..*plane };
        let (x, y) = (separable(&luminance, kernel, &blur), separable(&luminance, &blur, kernel));
        x.data.iter().zip(&y.data).map(|(x, y)| x.hypot(*y)).collect()
    };
    let edges = (magnitudes(a, &edge), magnitudes(b, &edge));
    let points = (magnitudes(a, &point), magnitudes(b, &point));
    (0..a.data.len())
        .map(|i| (edges.0[i] - edges.1[i]).abs().max((points.0[i] - points.1[i]).abs()))
        .map(|d| (std::f64::consts::FRAC_1_SQRT_2 * d).powf(Q_F).min(1.0))
        .collect()
}

/// Scales positive weights to a sum of 1 and negative ones to -1.
fn balanced(kernel: Vec<f64>) -> Vec<f64> {
    let positive: f64 = kernel.iter().filter(|v| **v > 0.0).sum();
    let negative: f64 = -kernel.iter().filter(|v| **v < 0.0).sum::<f64>();
    kernel.into_iter().map(|v| if v > 0.0 { v / positive } else { v / negative }).collect()
}

/// Convolution by rows, then by columns; the border's pixels go on outside.
fn separable(plane: &Plane, horizontal: &[f64], vertical: &[f64]) -> Plane {
    let (w, h) = (plane.width as i64, plane.height as i64);
    let pass = |data: &[f64], kernel: &[f64], dx: i64, dy: i64| -> Vec<f64> {
        let radius = kernel.len() as i64 / 2;
        let at = |x: i64, y: i64| data[(y.clamp(0, h - 1) * w + x.clamp(0, w - 1)) as usize];
        let sum = |x: i64, y: i64| {
            (-radius..=radius).map(|i| kernel[(i + radius) as usize] * at(x + i * dx, y + i * dy)).sum()
        };
        (0..h).flat_map(|y| (0..w).map(move |x| (x, y))).map(|(x, y)| sum(x, y)).collect()
    };
    let rows = pass(&plane.data, horizontal, 1, 0);
    Plane { width: plane.width, height: plane.height, data: pass(&rows, vertical, 0, 1) }
}

/// Linear sRGB to XYZ under D65, rational form of the standard's primaries (paper, appendix).
const XYZ_FROM_RGB: [Triple; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

fn xyz_from_rgb(rgb: Triple) -> Triple {
    XYZ_FROM_RGB.map(|row| row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2])
}

fn rgb_from_xyz(xyz: Triple) -> Triple {
    let m = glam::DMat3::from_cols_array_2d(&XYZ_FROM_RGB).transpose().inverse();
    (m * glam::DVec3::from(xyz)).to_array().map(|v| v.clamp(0.0, 1.0))
}

fn white() -> Triple {
    xyz_from_rgb([1.0; 3])
}

fn opponent_from_xyz(xyz: Triple) -> Triple {
    let [x, y, z] = std::array::from_fn(|i| xyz[i] / white()[i]);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn xyz_from_opponent(ycc: Triple) -> Triple {
    let y = (ycc[0] + 16.0) / 116.0;
    let relative = [y + ycc[1] / 500.0, y, y - ycc[2] / 200.0];
    std::array::from_fn(|i| relative[i] * white()[i])
}

/// CIELAB with chroma scaled by lightness (Hunt effect).
fn hunt_lab(rgb: Triple) -> Triple {
    let xyz = xyz_from_rgb(rgb);
    let [x, y, z] = std::array::from_fn(|i| {
        let t = xyz[i] / white()[i];
        let delta: f64 = 6.0 / 29.0;
        if t > delta.powi(3) { t.cbrt() } else { t / (3.0 * delta * delta) + 4.0 / 29.0 }
    });
    let lightness = 116.0 * y - 16.0;
    [lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)]
}

/// Distance for large colour differences: city block in lightness, Euclidean in chroma.
fn hyab(a: Triple, b: Triple) -> f64 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).hypot(a[2] - b[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(a: [f32; 4], b: [f32; 4], expected: f64) {
        let (a, b) = (Picture::filled(9, 7, a), Picture::filled(9, 7, b));
        // The paper's own program gives its values in single precision.
        flip(&a, &b).iter().for_each(|e| assert!((f64::from(*e) - expected).abs() < 2e-3, "{e} {expected}"));
    }

    #[test]
    fn uniform_pictures_have_known_differences() {
        check([0.3, 0.2, 0.9, 1.0], [0.3, 0.2, 0.9, 1.0], 0.0);
        // Green against blue is the largest difference by definition.
        check([0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0], 1.0);
        // Black against white is a difference of 100: above the knee.
        let (largest, e) = (hyab(hunt_lab([0.0, 1.0, 0.0]), hunt_lab([0.0, 0.0, 1.0])).powf(Q_C), 100f64.powf(Q_C));
        let expected = P_T + (e - P_C * largest) / (largest * (1.0 - P_C)) * (1.0 - P_T);
        check([0.0, 0.0, 0.0, 1.0], [1.0, 1.0, 1.0, 1.0], expected);
    }

    #[test]
    fn a_lost_edge_counts_more_than_its_colours() {
        let mut edge = Picture::filled(64, 8, [0.2, 0.2, 0.2, 1.0]);
        (0..8).for_each(|y| edge.pixels[y * 64 + 32..(y + 1) * 64].fill([0.3, 0.3, 0.3, 1.0]));
        let plain = Picture::filled(64, 8, [0.25, 0.25, 0.25, 1.0]);
        let (errors, at) = (flip(&edge, &plain), 4 * 64 + 32);
        let colors = color_difference(&opponent_planes(&edge), &opponent_planes(&plain));
        assert!(f64::from(errors[at]) > 1.2 * colors[at], "{} {}", errors[at], colors[at]);
    }
}
