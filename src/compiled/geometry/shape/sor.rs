//! Surfaces of revolution whose squared radius is a cubic of the height.

use super::outline::settle;
use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::slab::SlabRay;
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv, gamma, roots_in};
use std::sync::Arc;

/// ρ² as a cubic of y - `low`, rising, from `low` to `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SorSegment {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) squared: [f64; 4],
}

impl SorSegment {
    /// Squared radius and its slope.
    fn at(&self, y: f64) -> (f64, f64) {
        let (h, c) = (y - self.low, &self.squared);
        (((c[3] * h + c[2]) * h + c[1]) * h + c[0], (3.0 * c[3] * h + 2.0 * c[2]) * h + c[1])
    }
}

/// `sor`: pieces from bottom to top.
#[derive(Clone, Debug)]
pub(crate) struct Sor {
    segments: Arc<[SorSegment]>,
    open: bool,
    bounds: Bounds,
}

const BASE: u32 = u32::MAX - 1;
const CAP: u32 = u32::MAX;

impl Sor {
    /// Pieces from bottom to top, with or without caps.
    pub(crate) fn new(segments: Vec<SorSegment>, open: bool) -> Self {
        let mut sor = Self { segments: segments.into(), open, bounds: Bounds::EMPTY };
        sor.bounds = sor.reach();
        sor
    }

    /// A box around the whole.
    fn reach(&self) -> Bounds {
        let (low, high) = self.ends();
        let mut squared: f64 = 0.0;
        for s in self.segments.iter() {
            let turning = roots_in(&[s.squared[1], 2.0 * s.squared[2], 3.0 * s.squared[3]], 0.0, s.high - s.low);
            let heights = turning.into_iter().map(|h| s.low + h).chain([s.low, s.high]);
            squared = heights.map(|y| s.at(y).0).fold(squared, f64::max);
        }
        let r = squared.sqrt() * (1.0 + gamma(64));
        Bounds { min: DVec3::new(-r, low, -r), max: DVec3::new(r, high, r) }
    }

    fn ends(&self) -> (f64, f64) {
        let low = self.segments.first().map_or(0.0, |s| s.low);
        (low, self.segments.last().map_or(0.0, |s| s.high))
    }

    /// Squared radii of base and cap.
    fn rims(&self) -> (f64, f64) {
        let at = |s: Option<&SorSegment>, y: f64| s.map_or(0.0, |s| s.at(y).0);
        (at(self.segments.first(), self.ends().0), at(self.segments.last(), self.ends().1))
    }
}

impl Primitive for Sor {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let b = self.bounds();
        if !SlabRay::new(ray).may_meet(&b, range) {
            return;
        }
        let near = NearRay::new(ray, b.center(), 2.0 * b.size().length());
        let (o, d) = (near.origin, near.direction);
        let (reach, size) = (near.range(range), 4.0 * b.size().length());
        let reach = Range { min: reach.min.max(-size), max: reach.max.min(size) };
        let mut record = |s: f64, part: u32| {
            let t = near.t(s);
            if range.contains(t) {
                out.push(ShapeHit { t, part });
            }
        };
        let mut rest = self.segments.iter().zip(0..).peekable();
        let mut below: Option<(f64, f64)> = None;
        while let Some((segment, part)) = rest.next() {
            let within = reach.between([segment.low, segment.high], o.y, d.y);
            let above = rest.peek().map(|(next, _)| next.squared[0]);
            // Of two pieces on the level of a ray the upper one is met.
            if within.is_empty() || d.y == 0.0 && o.y == segment.high && above.is_some() {
                below = None;
                continue;
            }
            // ρ² less the cubic of h + s d.y, expanded.
            let (h, v, c) = (o.y - segment.low, d.y, &segment.squared);
            let along = [
                o.x * o.x + o.z * o.z - segment.at(o.y).0,
                2.0 * (o.x * d.x + o.z * d.z) - segment.at(o.y).1 * v,
                d.x * d.x + d.z * d.z - (3.0 * c[3] * h + c[2]) * v * v,
                -c[3] * v * v * v,
            ];
            let mut roots = roots_in(&along, within.min, within.max);
            if d.y != 0.0 {
                // Neighbours, or a cap, agree on which side of the common rim the ray passes.
                let beyond = |y: f64, rim: f64| {
                    let s = (y - o.y) / d.y;
                    let p = o + d * s;
                    (s, p.x * p.x + p.z * p.z - rim)
                };
                let low = below.take().unwrap_or_else(|| beyond(segment.low, segment.squared[0]));
                let high = beyond(segment.high, above.unwrap_or_else(|| segment.at(segment.high).0));
                below = Some(high);
                let (first, last) = if d.y > 0.0 { (low, high) } else { (high, low) };
                if within.min == first.0 && within.max == last.0 {
                    settle(&mut roots, [first.0, last.0], [first.1, last.1]);
                }
            }
            roots.into_iter().for_each(|s| record(s, part));
        }
        if !self.open && d.y != 0.0 {
            let ((low, high), (base, cap)) = (self.ends(), self.rims());
            for (y, rim, part) in [(low, base, BASE), (high, cap, CAP)] {
                let s = (y - o.y) / d.y;
                let p = o + d * s;
                if p.x * p.x + p.z * p.z <= rim {
                    record(s, part);
                }
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        let here = self.segments.iter().find(|s| s.low <= p.y && p.y <= s.high);
        here.is_some_and(|s| p.x * p.x + p.z * p.z <= s.at(p.y).0)
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let p = ray.at(t);
        let flat = DVec2::new(p.x, p.z);
        let outward = flat.normalize_or(DVec2::X);
        let ((low, high), (base, cap)) = (self.ends(), self.rims());
        let b = self.bounds();
        let error = gamma(128) * b.min.abs().max(b.max.abs()).max_element();
        let (point, normal, v) = match part {
            BASE => (p.with_y(low), DVec3::NEG_Y, flat.length() / base.sqrt() - 1.0),
            CAP => (p.with_y(high), DVec3::Y, 2.0 - flat.length() / cap.sqrt()),
            _ => {
                let segment = &self.segments[part as usize];
                let (squared, slope) = segment.at(p.y);
                let rim = outward * squared.max(0.0).sqrt();
                let share = (p.y - segment.low) / (segment.high - segment.low);
                let v = (f64::from(part) + share) / self.segments.len() as f64;
                (DVec3::new(rim.x, p.y, rim.y), DVec3::new(p.x, -0.5 * slope, p.z), v)
            }
        };
        LocalSurface { uv: Some(Uv::Turned(outward, v)), ..LocalSurface::plain(point, error, normal) }
    }
}
