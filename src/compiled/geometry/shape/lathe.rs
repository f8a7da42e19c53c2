//! Curves turned around the y axis.

use super::outline::{Segment, around, odd_right_of};
use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv, gamma, quadratic_roots, roots_in};
use std::sync::Arc;

/// x² + z² = r(w)², y = y(w), for pieces (r, y) of a curve.
#[derive(Clone, Debug)]
pub(crate) struct Lathe {
    curve: Arc<Curve>,
}

/// The curve that is turned.
#[derive(Debug)]
struct Curve {
    segments: Box<[Segment]>,
    /// Smallest and largest radius and height of each segment.
    hulls: Box<[[DVec2; 2]]>,
    /// Of the whole.
    hull: [DVec2; 2],
    /// Radius within which nothing is inside.
    hollow: f64,
}

/// Product of two cubics, rising.
fn square(c: &[f64; 4], sum: &mut [f64; 7], factor: f64) {
    for i in 0..4 {
        for j in 0..4 {
            sum[i + j] += factor * c[i] * c[j];
        }
    }
}

impl Lathe {
    /// Turns a curve around a core that is not inside, by default one as thick as the curve leaves room for.
    pub(crate) fn new(segments: Vec<Segment>, hollow: Option<f64>) -> Self {
        let hulls: Box<_> = segments.iter().map(Segment::bounds).collect();
        let hull = around(&hulls);
        let hollow = hollow.unwrap_or(hull[0].x);
        Self { curve: Arc::new(Curve { segments: segments.into(), hulls, hull, hollow }) }
    }

    /// Smallest and largest radius and height of the curve.
    fn hull(&self) -> [DVec2; 2] {
        self.curve.hull
    }

    /// Crossings of a unit-speed ray with one turned piece, (s, w), anywhere on the line.
    fn turned(&self, segment: &Segment, near: &NearRay, mut found: impl FnMut(f64, f64)) {
        let (o, d) = (near.origin, near.direction);
        let (o2, d2) = (DVec2::new(o.x, o.z), DVec2::new(d.x, d.z));
        let around = |w: f64| {
            let r = segment.at(w).x;
            quadratic_roots(d2.length_squared(), 2.0 * o2.dot(d2), o2.length_squared() - r * r)
        };
        if d.y == 0.0 {
            for w in segment.zeros(0.0, 1.0, -o.y) {
                around(w).into_iter().flatten().for_each(|s| found(s, w));
            }
            return;
        }
        // |d.y o2 + (y(w) - o.y) d2|² = d.y² r(w)², the ray's parameter eliminated.
        let mut y = segment.y;
        y[0] -= o.y;
        let mut c = [0.0; 7];
        square(&y, &mut c, d2.length_squared());
        square(&segment.x, &mut c, -d.y * d.y);
        for i in 0..4 {
            c[i] += 2.0 * d.y * o2.dot(d2) * y[i];
        }
        c[0] += d.y * d.y * o2.length_squared();
        for w in roots_in(&c, 0.0, 1.0) {
            let by_height = (segment.at(w).y - o.y) / d.y;
            // For rays nearly across the axis the circle tells the distance better.
            let near_height = |s: &f64| (s - by_height).abs();
            let by_circle =
                around(w).and_then(|r| r.into_iter().min_by(|a, b| near_height(a).total_cmp(&near_height(b))));
            found(if d.y.abs() > 0.1 { by_height } else { by_circle.unwrap_or(by_height) }, w);
        }
    }

    fn near(&self, ray: &Ray) -> NearRay {
        let [min, max] = self.hull();
        let size = max.abs().max(min.abs()).max_element();
        NearRay::new(ray, DVec3::new(0.0, 0.5 * (min.y + max.y), 0.0), 4.0 * size)
    }
}

/// Whether a unit-speed ray may meet a ring of such radii and heights within a range; errs on the side of yes.
fn may_meet(near: &NearRay, reach: Range, [min, max]: &[DVec2; 2]) -> bool {
    let (o, d) = (near.origin, near.direction);
    let (o2, d2) = (DVec2::new(o.x, o.z), DVec2::new(d.x, d.z));
    let pad = ROOT_ERROR * (o.y.abs() + min.y.abs().max(max.y.abs()));
    let reach = reach.between([min.y - pad, max.y + pad], o.y, d.y);
    if reach.is_empty() {
        return false;
    }
    let Range { min: low, max: high } = reach;
    // The distance from the axis first falls, then rises. What is not a number says nothing.
    let nearest = (-o2.dot(d2) / d2.length_squared()).max(low).min(high);
    let distance = |s: f64| (o2 + d2 * s).length();
    let slack = |s: f64| ROOT_ERROR * (o2.length() + s.abs());
    let (outer, inner) = (min.x.abs().max(max.x.abs()), min.x.max(-max.x).max(0.0));
    let passes_by = distance(nearest) > outer * (1.0 + ROOT_ERROR) + slack(nearest);
    let within = |s: f64| distance(s) + slack(s) < inner * (1.0 - ROOT_ERROR);
    !(passes_by || within(low) && within(high))
}

/// How uncertain roots of the eliminant are, in units of the curve's size, by trial with millions of rays.
const ROOT_ERROR: f64 = gamma(1024);

impl Primitive for Lathe {
    fn bounds(&self) -> Bounds {
        let [min, max] = self.hull();
        let r = min.x.abs().max(max.x.abs());
        Bounds { min: DVec3::new(-r, min.y, -r), max: DVec3::new(r, max.y, r) }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let near = self.near(ray);
        let reach = near.range(range);
        for ((segment, part), hull) in self.curve.segments.iter().zip(0..).zip(&self.curve.hulls) {
            if !may_meet(&near, reach, hull) {
                continue;
            }
            self.turned(segment, &near, |s, _| {
                let t = near.t(s);
                if range.contains(t) {
                    out.push(ShapeHit { t, part });
                }
            });
        }
    }

    /// An odd number of curve crossings further out; never inside the core.
    fn contains(&self, p: DVec3) -> bool {
        let [min, max] = self.hull();
        let flat = DVec2::new(DVec2::new(p.x, p.z).length(), p.y);
        let least = DVec2::new(self.curve.hollow, min.y);
        least.cmple(flat).all() && flat.cmple(max).all() && odd_right_of(&self.curve.segments, &self.curve.hulls, flat)
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let segment = &self.curve.segments[part as usize];
        let near = self.near(ray);
        let mut nearest = (f64::INFINITY, 0.0);
        self.turned(segment, &near, |s, w| {
            let miss = (near.t(s) - t).abs();
            if miss < nearest.0 {
                nearest = (miss, w);
            }
        });
        let w = nearest.1;
        let (c, slope) = (segment.at(w), segment.slope(w));
        let p = ray.at(t);
        let outward = DVec2::new(p.x, p.z).normalize_or(DVec2::X);
        let point = DVec3::new(outward.x * c.x.abs(), c.y, outward.y * c.x.abs());
        let rise = slope.x * c.x.signum();
        let normal = DVec3::new(slope.y * outward.x, -rise, slope.y * outward.y);
        let uv = Uv::Turned(outward, (f64::from(part) + w) / self.curve.segments.len() as f64);
        let [min, max] = self.hull();
        let error = ROOT_ERROR * max.abs().max(min.abs()).max_element();
        LocalSurface { uv: Some(uv), ..LocalSurface::plain(point, error, normal) }
    }
}
