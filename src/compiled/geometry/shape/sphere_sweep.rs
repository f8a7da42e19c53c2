//! Spheres of changing size, swept along a curve.
//!
//! A line meets the sphere at u where the distance of its centre from the line is at most R(u). Over a run of such u the
//! two places where the line enters and leaves the sphere move steadily, so that together the run's spheres cover one
//! stretch of the line: from the first entry to the last exit. No crossing is lost or made up, however flat the curve
//! lies to the line.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::slab::SlabRay;
use crate::math::{Bounds, DVec3, Range, Ray, gamma, quadratic_roots, roots_in};
use smallvec::SmallVec;
use std::sync::Arc;

/// A polynomial in u, rising, or places on the curve.
type Polynomial = SmallVec<[f64; 8]>;

/// One piece of the curve, for u from 0 to 1.
#[derive(Clone, Debug)]
pub(crate) struct SweepSegment {
    /// Coefficients of the centre, rising; all but two vanish where `is_line`.
    center: [DVec3; 4],
    radius: [f64; 4],
    is_line: bool,
    bounds: Bounds,
}

/// A distance from the surface, in units of the sweep's size, whose square is below the bound of a point's error.
const SETTLED: f64 = 1.0 / (1 << 23) as f64;

/// The union of the spheres of all segments.
#[derive(Clone, Debug)]
pub(crate) struct SphereSweep {
    pub(crate) segments: Arc<[SweepSegment]>,
    pub(crate) bounds: Bounds,
    /// Hits up to this ray parameter do not count.
    pub(crate) tolerance: f64,
}

impl SweepSegment {
    /// From coefficients of the centre and the radius, rising.
    pub(crate) fn new(center: [DVec3; 4], radius: [f64; 4], is_line: bool) -> Self {
        // The curve lies within the hull of its Bézier points, and so do its two shifts by R.
        let bezier =
            |c: [DVec3; 4]| [c[0], c[0] + c[1] / 3.0, c[0] + (c[1] * 2.0 + c[2]) / 3.0, c[0] + c[1] + c[2] + c[3]];
        let shifted = |side: f64| bezier(std::array::from_fn(|i| center[i] + DVec3::splat(side * radius[i])));
        let bounds = Bounds::around(shifted(1.0).into_iter().chain(shifted(-1.0)));
        Self { center, radius, is_line, bounds }
    }

    /// The box around all its spheres.
    pub(crate) fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn center_at(&self, u: f64) -> DVec3 {
        let [a, b, c, d] = self.center;
        a + (b + (c + d * u) * u) * u
    }

    fn radius_at(&self, u: f64) -> f64 {
        let [a, b, c, d] = self.radius;
        a + (b + (c + d * u) * u) * u
    }

    fn degree(&self) -> usize {
        if self.is_line { 1 } else { 3 }
    }

    /// F = |p - C(u)|² - R(u)² as a polynomial in u.
    fn power_of_point(&self, p: DVec3) -> Polynomial {
        let n = self.degree();
        let mut sum = Polynomial::from_elem(0.0, 2 * n + 1);
        let offset = |i: usize| if i == 0 { p - self.center[0] } else { -self.center[i] };
        for i in 0..=n {
            for j in 0..=n {
                sum[i + j] += offset(i).dot(offset(j)) - self.radius[i] * self.radius[j];
            }
        }
        sum
    }

    fn contains(&self, p: DVec3) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let power = self.power_of_point(p);
        power[0] <= 0.0 || power.iter().sum::<f64>() <= 0.0 || !roots_in(&power, 0.0, 1.0).is_empty()
    }

    /// The sphere between two, ends included, in which a point lies deepest.
    fn deepest(&self, p: DVec3, [from, to]: [f64; 2]) -> f64 {
        let power = self.power_of_point(p);
        let inner = roots_in(&derivative(&power), from, to);
        let all = [from, to].into_iter().chain(inner);
        all.min_by(|a, b| value(&power, *a).total_cmp(&value(&power, *b))).unwrap_or(from)
    }

    /// R² less the squared distance of the centre from a line with unit direction, as a polynomial in u.
    fn margin(&self, o: DVec3, d: DVec3) -> Polynomial {
        let n = self.degree();
        let across = |i: usize| {
            let offset = if i == 0 { o - self.center[0] } else { -self.center[i] };
            offset - d * offset.dot(d)
        };
        let mut sum = Polynomial::from_elem(0.0, 2 * n + 1);
        for i in 0..=n {
            for j in 0..=n {
                sum[i + j] += self.radius[i] * self.radius[j] - across(i).dot(across(j));
            }
        }
        sum
    }

    /// Where a line enters (side -1) or leaves (side 1) the sphere at u, which it meets.
    fn meet(&self, o: DVec3, d: DVec3, u: f64, side: f64) -> f64 {
        let (w, r) = (o - self.center_at(u), self.radius_at(u).abs());
        let middle = w.dot(d);
        let across = (w - d * middle).length();
        side * ((r - across) * (r + across)).max(0.0).sqrt() - middle
    }

    /// Where a line enters the first (side -1) or leaves the last (side 1) of a run of spheres that it meets.
    ///
    /// From any sphere's place it goes on to that of the sphere in which this place lies deepest: Newton's method for
    /// the least value of F over the run, whose error is squared by each step, and which stays on the run.
    fn end(&self, o: DVec3, d: DVec3, run: [f64; 2], side: f64) -> f64 {
        let mut place = self.meet(o, d, 0.5 * (run[0] + run[1]), side);
        // Where spheres touch the line only, steps just halve the error: then as many as there are digits.
        for _ in 0..f64::MANTISSA_DIGITS {
            let next = self.meet(o, d, self.deepest(o + d * place, run), side);
            let gain = (next - place) * side;
            if gain <= gamma(2) * place.abs() || gain.is_nan() {
                break;
            }
            place = next;
        }
        place
    }

    /// Both ends at once for a straight segment: at the run's ends, or on the cone that touches all spheres. There the
    /// deepest u is linear in t, and F a quadratic.
    fn line_ends(&self, o: DVec3, d: DVec3, run: [f64; 2]) -> [f64; 2] {
        let (w, axis) = (o - self.center[0], self.center[1]);
        let (r, widening) = (self.radius[0], self.radius[1]);
        let [a, b] = run.map(|u| [-1.0, 1.0].map(|side| self.meet(o, d, u, side)));
        let mut ends = [a[0].min(b[0]), a[1].max(b[1])];
        let square = axis.length_squared() - widening * widening;
        if square <= 0.0 {
            return ends; // one sphere holds all others
        }
        let (start, rate) = ((axis.dot(w) + r * widening) / square, axis.dot(d) / square);
        let linear = 2.0 * (w.dot(d) - square * start * rate);
        let constant = w.length_squared() - r * r - square * start * start;
        for t in quadratic_roots(1.0 - square * rate * rate, linear, constant).into_iter().flatten() {
            if (run[0]..=run[1]).contains(&(start + rate * t)) {
                ends = [ends[0].min(t), ends[1].max(t)];
            }
        }
        ends
    }

    /// Stretches of a line with unit direction inside.
    fn stretches(&self, o: DVec3, d: DVec3, segment: u32, out: &mut Vec<Stretch>) {
        let margin = self.margin(o, d);
        let mut edges = Polynomial::from_elem(0.0, 1);
        edges.extend(roots_in(&margin, 0.0, 1.0));
        edges.push(1.0);
        let pairs = edges.windows(2).filter(|pair| pair[0] < pair[1]);
        let mut run: Option<[f64; 2]> = None;
        let mut record = |run: [f64; 2]| {
            let [low, high] = if self.is_line {
                self.line_ends(o, d, run)
            } else {
                [-1.0, 1.0].map(|side| self.end(o, d, run, side))
            };
            out.push(Stretch { low, high, low_segment: segment, high_segment: segment });
        };
        for pair in pairs {
            let is_met = value(&margin, 0.5 * (pair[0] + pair[1])) > 0.0;
            run = match run {
                Some([start, _]) if is_met => Some([start, pair[1]]),
                None if is_met => Some([pair[0], pair[1]]),
                _ => {
                    run.into_iter().for_each(&mut record);
                    None
                }
            };
        }
        run.into_iter().for_each(record);
    }
}

/// A stretch of a line inside the sweep, with the segments that begin and end it.
#[derive(Clone, Copy)]
struct Stretch {
    low: f64,
    high: f64,
    low_segment: u32,
    high_segment: u32,
}

fn derivative(p: &[f64]) -> Polynomial {
    p.iter().enumerate().skip(1).map(|(i, c)| c * i as f64).collect()
}

fn value(p: &[f64], u: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, c| sum * u + c)
}

impl Primitive for SphereSweep {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let size = self.bounds.size().length();
        let near = NearRay::new(ray, self.bounds.center(), size);
        let line = Ray::new(near.origin, near.direction);
        let everywhere = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };
        let slabs = SlabRay::new(&line);
        let mut stretches = Vec::new();
        for (i, segment) in self.segments.iter().enumerate() {
            if slabs.may_meet(&segment.bounds, everywhere) {
                segment.stretches(near.origin, near.direction, i as u32, &mut stretches);
            }
        }
        stretches.sort_unstable_by(|a, b| a.low.total_cmp(&b.low));
        let mut record = |s: f64, part: u32| {
            let t = near.t(s);
            if range.contains(t) && t > self.tolerance {
                out.push(ShapeHit { t, part });
            }
        };
        let mut rest = stretches.into_iter();
        let Some(mut open) = rest.next() else { return };
        for next in rest.chain([Stretch { low: f64::INFINITY, high: 0.0, low_segment: 0, high_segment: 0 }]) {
            if next.low > open.high {
                record(open.low, open.low_segment);
                record(open.high, open.high_segment);
                open = next;
            } else if next.high > open.high {
                (open.high, open.high_segment) = (next.high, next.high_segment);
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        self.segments.iter().any(|segment| segment.contains(p))
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let p = ray.at(t);
        let segment = &self.segments[part as usize];
        let size = self.bounds.min.abs().max(self.bounds.max.abs()).max_element();
        let error = gamma(256) * size;
        let onto = |p: DVec3| {
            let u = segment.deepest(p, [0.0, 1.0]);
            let (center, radius) = (segment.center_at(u), segment.radius_at(u).abs());
            let normal = (p - center).normalize_or(DVec3::X);
            (center + normal * radius, normal)
        };
        let (mut point, mut normal) = onto(p);
        // Of a point off the surface another sphere is the deepest, which is off by the square of that: small sweeps seen
        // from far away ask for another step, or two.
        for _ in 0..3 {
            if point.distance(p) <= SETTLED * size {
                break;
            }
            let before = point;
            (point, normal) = onto(point);
            if point.distance(before) <= error {
                break;
            }
        }
        // Along a line of touch the sphere is only known to the square root of the rounding of u,
        // which moves the point by that squared.
        LocalSurface::plain(point, error, normal)
    }
}
