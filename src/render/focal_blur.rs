//! Depth of field: samples over the lens until they agree.
//!
//! Source: section 2 of the camera facts (measured).

use super::camera::RawRay;
use super::gather::Gather;
use super::jitter::{jitter, shuffled};
use super::ray::Radiance;
use super::tracer::Tracer;
use crate::compiled::camera::{Camera, FocalBlur};
use crate::compiled::texture::Context;
use crate::math::MersenneTwister;
use crate::math::{DVec2, DVec3, Ray, gray};
use std::f64::consts::{PI, TAU};
use std::rc::Rc;

/// Lens points and jitter of a sample count.
pub(super) struct Lens {
    points: Vec<DVec2>,
    jitter: f64,
    /// Unit vectors in the plane of the lens.
    across: DVec3,
    along: DVec3,
    half_aperture: f64,
    /// From the length of the camera's direction to the distance that is in focus.
    scale: f64,
    /// Chi-square thresholds for stopping, by sample count.
    quantiles: Vec<f64>,
}

impl Tracer<'_> {
    /// Mean over the lens at an image position.
    pub(super) fn blurred<G: Gather>(&mut self, blur: &FocalBlur, x: f64, y: f64) -> G {
        let Some(lens) = self.lens.as_ref().map(Rc::clone) else { return G::default() };
        let n_max = lens.points.len();
        let base = (313.0 * x + 11.0).trunc() as i64 + (311.0 * y + 17.0).trunc() as i64;
        let mut sums = [[0.0f64; 2]; 4];
        let mut sum = G::default();
        let mut n = 0;
        for batch in batches(n_max) {
            for _ in 0..batch {
                // A lens ray that does not exist counts as clear where samples are compared, but adds nothing.
                let mut light = Radiance::CLEAR;
                if let Some(ray) = self.lens_ray(&lens, x, y, n, base) {
                    let found: G = self.follow(ray, f64::INFINITY);
                    light = found.light();
                    sum.add_scaled(&found, 1.0);
                }
                let values = [light.rgb.x, light.rgb.y, light.rgb.z, light.transparency];
                for (s, v) in sums.iter_mut().zip(values.map(f64::from)) {
                    *s = [s[0] + v, s[1] + v * v];
                }
                n += 1;
            }
            let count = n as f64;
            let threshold = match n_max {
                1 => 0.0,
                _ => blur.variance * lens.quantiles[n] / lens.quantiles[n_max - 1],
            };
            let steady = |s: &[f64; 2]| (s[1] / count - (s[0] / count).powi(2)) / count < threshold;
            if n >= blur.min_samples && sums.iter().all(steady) {
                break;
            }
        }
        sum.scaled(1.0 / n.max(1) as f32)
    }

    fn lens_ray(&self, lens: &Lens, x: f64, y: f64, k: usize, base: i64) -> Option<Ray> {
        let camera = &self.world.camera;
        let cell = |i: i64| (2.0 * (shuffled(base + i) % 16) as f64 + 1.0) / 32.0 - 0.5;
        let k_index = k as i64;
        let (dx, dy) = (cell(k_index), cell(k_index + 1));
        let [jx, jy] = jitter(dx, dy);
        let (x, y) = (x + dx + (jx - 0.5) / 16.0, y + dy + (jy - 0.5) / 16.0);
        let raw = RawRay::through(camera, x, y, self.options.width, self.options.height)?;
        let [jx, jy] = jitter(x + 0.5, y - 0.5);
        let point = lens.points[k] + 2.0 * lens.jitter * DVec2::new(jx, jy);
        let shift = lens.half_aperture * (point.x * lens.across - point.y * lens.along);
        Some(raw.focused(camera, shift, lens.scale))
    }
}

impl RawRay {
    /// The ray through a shifted point of the lens that meets the same point in focus.
    fn focused(mut self, camera: &Camera, shift: DVec3, scale: f64) -> Ray {
        self.origin += shift;
        self.direction = scale * self.direction - shift;
        self.finish(camera)
    }
}

impl Lens {
    /// The lens of a camera.
    pub(super) fn new(camera: &Camera, blur: &FocalBlur) -> Self {
        let across = camera.up.cross(camera.direction).normalize_or(DVec3::X);
        let along = camera.direction.cross(across).normalize_or(DVec3::Y);
        let n = blur.max_samples.max(1);
        let (points, jitter) = match &blur.bokeh {
            Some(pigment) => {
                let brightness = |x: f64, y: f64| {
                    f64::from(gray(pigment.color_or_clear(DVec3::new(x, y, 0.0), &Context::default()).rgb))
                };
                (bokeh_points(n, brightness), 0.5 / (n as f64).sqrt())
            }
            None => {
                let jitter = match n {
                    7 => 0.144_338,
                    19 => 0.096_225,
                    37 => 0.072_168_8,
                    _ => 0.5 / (n as f64).sqrt(),
                };
                (round_points(n), jitter)
            }
        };
        let quantiles = (0..=n).map(|nu| stopping_quantile(nu, blur.confidence)).collect();
        Self {
            points,
            jitter,
            across,
            along,
            half_aperture: 0.5 * blur.aperture,
            scale: blur.focal_distance / camera.direction.length(),
            quantiles,
        }
    }
}

/// Sizes of batches after which sampling may stop.
fn batches(n: usize) -> Vec<usize> {
    let first: &[usize] = match n {
        0..7 => &[],
        7..19 => &[7],
        19..37 => &[7, 6, 6],
        _ => &[7, 6, 6, 4, 4, 4, 4, 2],
    };
    let mut left = n - first.iter().sum::<usize>();
    let mut sizes = first.to_vec();
    while left > 0 {
        sizes.push(left.min(4));
        left -= left.min(4);
    }
    sizes
}

/// The innermost points: four on a square, or full rings of a hexagon, in POV-Ray's order.
fn first_points(n: usize) -> Vec<DVec2> {
    if n < 7 {
        return [(-0.25, 0.25), (0.25, 0.25), (-0.25, -0.25), (0.25, -0.25)].map(DVec2::from).to_vec();
    }
    let p = |x: i32, y: i32| vec![(-x, y), (-x, -y), (x, y), (x, -y)];
    let q = |x: i32, y: i32| vec![(-x, y), (x, -y), (-x, -y), (x, y)];
    let (rings, lattice) = match n {
        7..19 => (1, [vec![(-2, 0), (0, 0), (2, 0)], p(1, 1)].concat()),
        19..37 => (
            2,
            [p(2, 2), vec![(4, 0), (-4, 0), (0, 0), (0, 2), (0, -2)], p(3, 1), p(1, 1), vec![(-2, 0), (2, 0)]].concat(),
        ),
        _ => (
            3,
            [
                vec![(0, 0)],
                q(3, 3),
                vec![(-6, 0), (6, 0)],
                q(2, 2),
                vec![(-4, 0), (4, 0)],
                q(1, 1),
                vec![(-2, 0), (2, 0)],
                p(5, 1),
                p(4, 2),
                p(1, 3),
                p(3, 1),
                vec![(0, 2), (0, -2)],
            ]
            .concat(),
        ),
    };
    let step = 1.0 / (f64::from(rings + 1) * 3f64.sqrt());
    let rounded = |v: f64| (v * 1e6).round() / 1e6;
    let place = |(i, j): (i32, i32)| {
        DVec2::new(rounded(f64::from(i) * step * 0.5), rounded(f64::from(j) / f64::from(2 * (rings + 1))))
    };
    lattice.into_iter().map(place).collect()
}

/// Points over a round lens of diameter 1.
fn round_points(n: usize) -> Vec<DVec2> {
    let mut points = first_points(n);
    points.truncate(n);
    let side = 2 * ((n as f64 / PI).sqrt().ceil() as usize) + 1;
    let cell = |p: DVec2| {
        let index = |v: f64| (((v + 0.5) * side as f64).max(0.0) as usize).min(side - 1);
        index(p.y) * side + index(p.x)
    };
    let mut taken = vec![false; side * side];
    points.iter().for_each(|p| taken[cell(*p)] = true);
    let mut budget = 10 * n;
    let mut candidate = 0;
    while points.len() < n {
        let mut next = || {
            candidate += 1;
            budget = budget.saturating_sub(1);
            let radius = (0.25 * radical_inverse(candidate, 2)).sqrt();
            (radius * DVec2::from_angle(TAU * radical_inverse(candidate, 3)), budget)
        };
        let (mut point, mut left) = next();
        while taken[cell(point)] && left > n - points.len() {
            (point, left) = next();
        }
        taken[cell(point)] = true;
        points.push(point);
    }
    points
}

/// Points over a lens whose shape a pigment draws on the unit square.
fn bokeh_points(n: usize, brightness: impl Fn(f64, f64) -> f64) -> Vec<DVec2> {
    let mut random = MersenneTwister::default();
    // POV-Ray's stream starts with the second number.
    random.next_u32();
    let mut points = Vec::with_capacity(n);
    let mut tries = 0u64;
    while points.len() < n {
        tries += 1;
        let (x, y) = (radical_inverse(tries, 2), radical_inverse(tries, 3));
        // The second term grows until every point is accepted, so a black pigment ends, too.
        if random.next_f64() <= brightness(x, y) + (tries - 1) as f64 / (n * n) as f64 {
            points.push(DVec2::new(x - 0.5, y - 0.5));
        }
    }
    points
}

/// Digits of `i` in a base, mirrored behind the point.
fn radical_inverse(mut i: u64, base: u64) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0 / base as f64);
    while i > 0 {
        value += (i % base) as f64 * digit;
        i /= base;
        digit /= base as f64;
    }
    value
}

/// Chi-square quantile with POV-Ray's tail: its series for odd degrees up to 25 is off by a factor.
fn stopping_quantile(degrees: usize, confidence: f64) -> f64 {
    let odd = degrees % 2 == 1 && degrees <= 25;
    let tail = (1.0 - confidence) * if odd { 1.040_362_905_3 } else { 1.0 };
    if degrees == 0 { 0.0 } else { chi_square_quantile(degrees as f64, tail) }
}

/// The value below which a share `p` of a chi-square distribution lies, by bisection.
fn chi_square_quantile(degrees: f64, p: f64) -> f64 {
    let (mut low, mut high) = (0.0, degrees + 20.0 * (2.0 * degrees).sqrt() + 50.0);
    // Sixty halvings exhaust double precision.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if regularised_gamma(0.5 * degrees, 0.5 * middle) < p { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Regularised lower incomplete gamma function for half-integral `a`, by its series.
///
/// Source: Abramowitz and Stegun, 6.5.29.
fn regularised_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let mut log_gamma = if a.fract() == 0.0 { 0.0 } else { PI.sqrt().ln() };
    let mut b = if a.fract() == 0.0 { 1.0 } else { 0.5 };
    while b < a {
        log_gamma += f64::ln(b);
        b += 1.0;
    }
    let (mut term, mut sum, mut k) = (1.0 / a, 1.0 / a, a);
    while term > sum * f64::EPSILON {
        k += 1.0;
        term *= x / k;
        sum += term;
    }
    (sum.ln() + a * x.ln() - x - log_gamma).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(degrees: f64, tail: f64, expected: f64) {
        let found = chi_square_quantile(degrees, tail);
        assert!((found - expected).abs() < 1e-7, "{found} instead of {expected}");
    }

    #[test]
    fn quantiles_are_those_that_stop_povray() {
        check(36.0, 0.5, 35.335_572_8);
        assert!((stopping_quantile(7, 0.9) - 2.879_020_015_6).abs() < 1e-7);
        assert!((stopping_quantile(13, 0.5) - 12.591_729_637_6).abs() < 1e-7);
    }

    #[test]
    fn lenses_have_their_number_of_points() {
        for n in [1, 4, 6, 7, 10, 19, 25, 37, 50, 200] {
            let points = round_points(n);
            assert_eq!(points.len(), n);
            assert!(points.iter().all(|p| p.length() <= 0.51), "{n}");
            assert_eq!(batches(n).iter().sum::<usize>(), n);
        }
        assert_eq!(bokeh_points(20, |_, _| 0.0).len(), 20);
    }
}
