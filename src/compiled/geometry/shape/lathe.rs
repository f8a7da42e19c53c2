//! Curves turned around the y axis.

use super::outline::{ROOT_ERROR, Segment, around, join, odd_right_of, settle};
use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Roots, Uv, quadratic_roots, roots_in};
use smallvec::SmallVec;
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

/// Up to this slope, per unit of length, a line counts as nearly across the axis.
const ACROSS: f64 = 0.1;

/// Up to this one, the roots of both sides of a piece are so near to each other that they would lose more than five bits.
const FLAT: f64 = 1.0 / 32.0;

/// A cubic in powers of steps of some length from a place on.
fn shifted(c: &[f64; 4], from: f64, length: f64) -> [f64; 4] {
    let [a, b, c, d] = *c;
    [
        ((d * from + c) * from + b) * from + a,
        ((3.0 * d * from + 2.0 * c) * from + b) * length,
        (3.0 * d * from + c) * length * length,
        d * length * length * length,
    ]
}

/// The stretches of 0 ..= 1 in which a cubic may be nearer to a height than some band, and perhaps others.
fn stretches(y: &[f64; 4], middle: f64, band: f64) -> SmallVec<[[f64; 2]; 4]> {
    let mut edges: SmallVec<[f64; 8]> = SmallVec::from_slice(&[0.0]);
    for side in [-band, band] {
        edges.extend(roots_in(&[y[0] - (middle + side), y[1], y[2], y[3]], 0.0, 1.0));
    }
    edges[1..].sort_unstable_by(f64::total_cmp);
    edges.push(1.0);
    let mut found: SmallVec<[[f64; 2]; 4]> = SmallVec::new();
    for pair in edges.windows(2) {
        let height = shifted(y, 0.5 * (pair[0] + pair[1]), 0.0)[0];
        if (height - middle).abs() > band {
            continue;
        }
        match found.last_mut() {
            Some(last) if last[1] == pair[0] => last[1] = pair[1],
            _ => found.push([pair[0], pair[1]]),
        }
    }
    found
}

impl Lathe {
    /// Turns a curve around a core that is not inside, by default one as thick as the curve leaves room for.
    pub(crate) fn new(mut segments: Vec<Segment>, hollow: Option<f64>) -> Self {
        join(&mut segments);
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
    #[inline(always)]
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
        for w in self.eliminant_roots(segment, o, d) {
            let by_height = (segment.at(w).y - o.y) / d.y;
            // For rays nearly across the axis the circle tells the distance better.
            let near_height = |s: &f64| (s - by_height).abs();
            let by_circle =
                around(w).and_then(|r| r.into_iter().min_by(|a, b| near_height(a).total_cmp(&near_height(b))));
            found(if d.y.abs() > ACROSS { by_height } else { by_circle.unwrap_or(by_height) }, w);
        }
    }

    /// Where on a piece a line that is not across the axis meets what it makes.
    #[inline(always)]
    fn eliminant_roots(&self, segment: &Segment, o: DVec3, d: DVec3) -> Roots {
        let (o2, d2) = (DVec2::new(o.x, o.z), DVec2::new(d.x, d.z));
        if d.y.abs() <= FLAT {
            return self.flat_roots(segment, o, d);
        }
        let mut y = segment.y;
        let mut c = [0.0; 7];
        // |d.y o2 + (y(w) - o.y) d2|² = d.y² r(w)², the ray's parameter eliminated.
        y[0] -= o.y;
        let (rise, turn, radius) = (d2.length_squared(), 2.0 * d.y * o2.dot(d2), -d.y * d.y);
        let offset = d.y * d.y * o2.length_squared();
        square(&y, &mut c, rise);
        square(&segment.x, &mut c, radius);
        for i in 0..4 {
            c[i] += turn * y[i];
        }
        c[0] += offset;
        let mut roots = roots_in(&c, 0.0, 1.0);
        // In the same steps as the first coefficient, which is that of the end of the piece before to the last bit. The
        // other way round, so that the point of a piece on the axis is outside.
        let end = segment.end - DVec2::new(0.0, o.y);
        let last = ((rise * end.y * end.y + radius * end.x * end.x) + turn * end.y) + offset;
        settle(&mut roots, [0.0, 1.0], [-c[0], -last]);
        roots
    }

    /// The same for a line that is nearly across the axis.
    #[inline(never)]
    fn flat_roots(&self, segment: &Segment, o: DVec3, d: DVec3) -> Roots {
        let (o2, d2) = (DVec2::new(o.x, o.z), DVec2::new(d.x, d.z));
        let y = segment.y;
        // From where the line is nearest to the axis, at the height `middle`:
        // |d2|² (y(w) - middle)² = d.y² (r(w)² - nearest²).
        // The flatter the line, the nearer to each other are the roots of pieces that cross it; so only those stretches of
        // w are looked at in which the curve is between the heights at which the line enters and leaves the hull.
        let flat = d2.length();
        let to_nearest = -o2.dot(d2) / (flat * flat);
        let (middle, nearest) = (o.y + to_nearest * d.y, o2.perp_dot(d2) / flat);
        let [min, max] = self.hull();
        let size = max.abs().max(min.abs()).max_element();
        let radius = min.x.abs().max(max.x.abs());
        let band = d.y.abs() / flat * radius * 1.0625 + ROOT_ERROR * (size + middle.abs());
        let depth = |r: f64, rise: f64| d.y * d.y * ((r - nearest) * (r + nearest)) - (flat * rise) * (flat * rise);
        let mut all = Roots::new();
        for [from, to] in stretches(&y, middle, band) {
            // Both coordinates in powers of a step of this stretch's length: heights above the middle keep their digits.
            let (r, mut rise) = (shifted(&segment.x, from, to - from), shifted(&y, from, to - from));
            rise[0] -= middle;
            let mut c = [0.0; 7];
            square(&rise, &mut c, flat * flat);
            square(&r, &mut c, -d.y * d.y);
            c[0] += d.y * d.y * nearest * nearest;
            all.extend(roots_in(&c, 0.0, 1.0).into_iter().map(|v| from + v * (to - from)));
        }
        settle(&mut all, [0.0, 1.0], [segment.start(), segment.end].map(|p| depth(p.x, p.y - middle)));
        all
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
