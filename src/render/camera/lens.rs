//! Depth of field: rays over the lens.
//!
//! Source: section 2 of the camera facts (measured).

use super::RawRay;
use crate::compiled::camera::{Camera, FocalBlur};
use crate::compiled::texture::Context;
use crate::math::MersenneTwister;
use crate::math::{DVec2, DVec3, Ray, gray};
use crate::render::enough::Confidence;
use crate::render::jitter::{jitter, shuffled};
use std::f64::consts::{PI, TAU};

/// Lens points and jitter of a sample count.
#[derive(Debug)]
pub(in crate::render) struct Lens {
    points: Vec<DVec2>,
    jitter: f64,
    /// Unit vectors in the plane of the lens.
    across: DVec3,
    along: DVec3,
    half_aperture: f64,
    /// From the length of the camera's direction to the distance that is in focus.
    scale: f64,
    /// When its rays agree.
    pub(in crate::render) confidence: Confidence,
}

impl Lens {
    /// Ray number `k` of those through a continuous image position, `k` below [`Self::n_rays`]; `None` where the
    /// projection shows nothing.
    pub(in crate::render) fn ray(
        &self,
        camera: &Camera,
        [x, y]: [f64; 2],
        [width, height]: [usize; 2],
        k: usize,
    ) -> Option<Ray> {
        let base = (313.0 * x + 11.0).trunc() as i64 + (311.0 * y + 17.0).trunc() as i64;
        let cell = |i: i64| (2.0 * (shuffled(base + i) % 16) as f64 + 1.0) / 32.0 - 0.5;
        let k_index = k as i64;
        let (dx, dy) = (cell(k_index), cell(k_index + 1));
        let [jx, jy] = jitter(dx, dy);
        let (x, y) = (x + dx + (jx - 0.5) / 16.0, y + dy + (jy - 0.5) / 16.0);
        let raw = RawRay::through(camera, x, y, width, height)?;
        let [jx, jy] = jitter(x + 0.5, y - 0.5);
        Some(self.bent(camera, raw, k, DVec2::new(jx, jy)))
    }

    /// The ray through a continuous image position and the place of the lens that a point of the unit square stands for:
    /// its first coordinate chooses one of the lens's points, all alike, and what is left moves within the jitter.
    pub(in crate::render) fn ray_at(
        &self,
        camera: &Camera,
        [x, y]: [f64; 2],
        [width, height]: [usize; 2],
        [u, v]: [f64; 2],
    ) -> Option<Ray> {
        let scaled = u * self.n_rays() as f64;
        let k = (scaled as usize).min(self.n_rays() - 1);
        let raw = RawRay::through(camera, x, y, width, height)?;
        Some(self.bent(camera, raw, k, DVec2::new(scaled - k as f64 - 0.5, v - 0.5)))
    }

    /// A ray bent to one of the lens's points, moved by a share of the jitter.
    fn bent(&self, camera: &Camera, raw: RawRay, k: usize, share: DVec2) -> Ray {
        let point = self.points[k] + 2.0 * self.jitter * share;
        let shift = self.half_aperture * (point.x * self.across - point.y * self.along);
        raw.focused(camera, shift, self.scale)
    }

    /// The most rays that one image position has.
    pub(in crate::render) fn n_rays(&self) -> usize {
        self.points.len()
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
    pub(in crate::render) fn new(camera: &Camera, blur: &FocalBlur) -> Self {
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
        Self {
            points,
            jitter,
            across,
            along,
            half_aperture: 0.5 * blur.aperture,
            scale: blur.focal_distance / camera.direction.length(),
            confidence: Confidence::new(n, blur.min_samples, blur.confidence, blur.variance),
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lenses_have_their_number_of_points() {
        for n in [1, 4, 6, 7, 10, 19, 25, 37, 50, 200] {
            let points = round_points(n);
            assert_eq!(points.len(), n);
            assert!(points.iter().all(|p| p.length() <= 0.51), "{n}");
        }
        assert_eq!(bokeh_points(20, |_, _| 0.0).len(), 20);
    }
}
