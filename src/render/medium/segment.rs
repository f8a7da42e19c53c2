//! A straight way through media, cut into parts that are sampled one by one.
//!
//! Source: `docs/povray/media.md`, section 4 (measured).

use crate::compiled::light::{Beam, Light};
use crate::compiled::medium::Sampling;
use crate::math::{DVec3, Ray};
use smallvec::SmallVec;

/// The piece of a ray on which a light may shine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct Lit {
    /// Number of the light.
    pub(in crate::render) light: usize,
    /// Distances along the ray.
    from: f64,
    to: f64,
}

impl Lit {
    /// The piece of the first `length` of a ray on which a light may shine, if any.
    pub(in crate::render) fn new(index: usize, light: &Light, ray: &Ray, length: f64) -> Option<Self> {
        let (from, to) = match light.beam {
            Beam::Spot { cos_falloff, .. } => in_cone(light, cos_falloff, ray, length)?,
            Beam::Cylinder { falloff, .. } => in_tube(light, falloff, ray, length)?,
            Beam::Even => (0.0, length),
        };
        Some(Self { light: index, from, to })
    }

    /// Whether it may shine at a distance.
    pub(super) fn holds(&self, distance: f64) -> bool {
        self.from <= distance && distance <= self.to
    }
}

/// Where a ray is within the angle of a spotlight, in front of it.
fn in_cone(light: &Light, cosine: f64, ray: &Ray, length: f64) -> Option<(f64, f64)> {
    let from = ray.origin - light.location;
    let (along, ahead) = (ray.direction.dot(light.axis), from.dot(light.axis));
    let square = cosine * cosine;
    // (axis · p)² - cos² p², with p on the ray.
    let roots = quadratic_roots(
        along * along - square,
        along * ahead - square * from.dot(ray.direction),
        ahead * ahead - square * from.length_squared(),
    );
    let inside = |t: f64| {
        let p = from + t * ray.direction;
        p.dot(light.axis) > cosine * p.length()
    };
    hull([roots[0], roots[1], -ahead / along], length, inside)
}

/// Where a ray is within the radius of a light that shines in a tube.
fn in_tube(light: &Light, radius: f64, ray: &Ray, length: f64) -> Option<(f64, f64)> {
    let across = |v: DVec3| v - v.dot(light.axis) * light.axis;
    let (from, step) = (across(ray.origin - light.location), across(ray.direction));
    let roots = quadratic_roots(step.length_squared(), from.dot(step), from.length_squared() - radius * radius);
    hull([roots[0], roots[1], 0.0], length, |t| (from + t * step).length() < radius)
}

/// Where `a t² + 2 b t + c` is 0; NaN where there is no such place.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    // The sum has no cancellation; the other root follows from the product.
    let q = -(b + b.signum() * (b * b - a * c).sqrt());
    [q / a, c / q]
}

/// From the first to the last place between 0 and `length` that is inside, where inside may only change at some places.
fn hull(changes: [f64; 3], length: f64, inside: impl Fn(f64) -> bool) -> Option<(f64, f64)> {
    let mut places: SmallVec<[f64; 5]> = changes.into_iter().filter(|t| *t > 0.0 && *t < length).collect();
    places.extend([0.0, length]);
    places.sort_by(f64::total_cmp);
    let pieces = || places.windows(2).filter(|piece| piece[0] < piece[1] && inside(0.5 * (piece[0] + piece[1])));
    Some((pieces().next()?[0], pieces().next_back()?[1]))
}

/// A part of a ray that is sampled by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    /// Where it starts.
    pub(super) from: f64,
    /// How long it is.
    pub(super) length: f64,
    /// Lights may shine there.
    pub(super) lit: bool,
}

/// Calls `visit` with each part of the first `length` of a ray, nearest first.
pub(super) fn for_each_part(
    length: f64,
    lights: &[Lit],
    sampling: &Sampling,
    has_density: bool,
    mut visit: impl FnMut(Part),
) {
    let ranges = ranges(length, lights);
    let n_parts = u64::from(sampling.intervals).max(ranges.len() as u64);
    let weight = |range: &Part| if range.lit { sampling.ratio } else { 1.0 - sampling.ratio };
    let total: f64 = ranges.iter().map(weight).sum();
    let mut left = n_parts;
    for (i, range) in ranges.iter().enumerate() {
        let after = (ranges.len() - 1 - i) as u64;
        let n = match ranges.len() {
            1 if !range.lit && !has_density => 1,
            1 => n_parts,
            _ => ((n_parts as f64 * weight(range) / total) as u64 + 1).min(left - after),
        };
        left = left.saturating_sub(n);
        let length = range.length / n as f64;
        (0..n).for_each(|k| visit(Part { from: range.from + k as f64 * length, length, lit: range.lit }));
    }
}

/// Lit and dark pieces by turns.
fn ranges(length: f64, lights: &[Lit]) -> SmallVec<[Part; 4]> {
    let mut sorted: SmallVec<[Lit; 4]> = SmallVec::from_slice(lights);
    sorted.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut ranges = SmallVec::new();
    let mut end = 0.0;
    let mut add = |from: f64, to: f64, lit: bool| {
        if to > from {
            ranges.push(Part { from, length: to - from, lit });
        }
    };
    let mut lit = sorted.iter().peekable();
    while let Some(first) = lit.next() {
        let mut to = first.to;
        while let Some(next) = lit.next_if(|next| next.from <= to) {
            to = to.max(next.to);
        }
        add(end, first.from, false);
        add(first.from, to, true);
        end = to;
    }
    add(end, length, false);
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled::medium::Method;

    fn check(intervals: u32, ratio: f64, lit: &[(f64, f64)], expected: &[usize]) {
        let sampling = Sampling {
            method: Method::Adaptive,
            intervals,
            min_samples: 10,
            max_samples: 10,
            jitter: 0.0,
            depth: 2,
            threshold: 0.1,
            confidence: 0.9,
            variance: 0.1,
            ratio,
        };
        let lights: Vec<Lit> = lit.iter().map(|(from, to)| Lit { light: 0, from: *from, to: *to }).collect();
        let mut counts: Vec<(bool, usize)> = Vec::new();
        let mut end = 0.0;
        for_each_part(2.0, &lights, &sampling, false, |part| {
            assert!((part.from - end).abs() < 1e-12);
            end = part.from + part.length;
            match counts.last_mut().filter(|last| last.0 == part.lit) {
                Some(last) => last.1 += 1,
                None => counts.push((part.lit, 1)),
            }
        });
        assert_eq!(counts.iter().map(|c| c.1).collect::<Vec<_>>(), expected);
        assert!((end - 2.0).abs() < 1e-12);
    }

    #[test]
    fn parts_are_shared_out_by_their_light() {
        check(8, 0.7, &[(0.5, 1.0)], &[2, 5, 1]);
        check(1, 0.9, &[(0.5, 1.0)], &[1, 1, 1]);
        check(5, 0.9, &[(0.0, 2.0)], &[5]);
        check(5, 0.9, &[], &[1]);
        check(4, 0.9, &[(0.0, 1.0), (0.5, 2.0)], &[4]);
        check(2, 0.9, &[(0.0, 0.5), (1.5, 2.0)], &[1, 1, 1]);
    }
}
