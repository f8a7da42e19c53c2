//! Superquadric ellipsoids.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, gamma};
use smallvec::SmallVec;

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1.
///
/// Source: Barr, Superquadrics and Angle-Preserving Transformations, 1981.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Superellipsoid {
    /// Roundness of the sections across z, e.
    pub(crate) east_west: f64,
    /// Roundness of the sections along z, n.
    pub(crate) north_south: f64,
}

/// Pieces in which a stretch between symmetry planes is searched for two close roots.
const SAMPLES: usize = 8;

/// POV-Ray's own threshold of the inside test, in the shape's unit cube.
const INSIDE_SLACK: f64 = 1e-10;

/// A line through the shape: unit direction, and the stretch of it in which roots are looked for.
struct Chord {
    near: NearRay,
    low: f64,
    high: f64,
}

impl Chord {
    /// `None` where the line passes by.
    fn new(ray: &Ray, range: Range) -> Option<Self> {
        let near = NearRay::new(ray, DVec3::ZERO, 4.0);
        let (o, d) = (near.origin, near.direction);
        let reach = near.range(range);
        let (mut low, mut high) = (reach.min, reach.max);
        for axis in 0..3 {
            // A little larger than the shape, so that roots on its flat faces are enclosed.
            let (a, b) = ((-1.001 - o[axis]) / d[axis], (1.001 - o[axis]) / d[axis]);
            low = low.max(a.min(b));
            high = high.min(a.max(b));
        }
        (low < high && (high - low).is_finite()).then_some(Self { near, low, high })
    }

    fn at(&self, s: f64) -> DVec3 {
        self.near.origin + self.near.direction * s
    }
}

impl Superellipsoid {
    /// Whether the shape is convex, and with it its value.
    fn is_convex(&self) -> bool {
        self.east_west <= 2.0 && self.north_south <= 2.0
    }

    /// The p-norm of two lengths and its slope, from the lengths and their slopes.
    fn norm_along((a, da): (f64, f64), (b, db): (f64, f64), p: f64) -> (f64, f64) {
        let ((low, d_low), (high, d_high)) = if a < b { ((a, da), (b, db)) } else { ((b, db), (a, da)) };
        if high == 0.0 {
            return (0.0, 0.0);
        }
        let ratio = low / high;
        let power = ratio.powf(p);
        let root = (1.0 + power).powf(1.0 / p);
        let share = if ratio > 0.0 { power / ratio } else { 0.0 };
        (high * root, root / (1.0 + power) * (d_high + share * d_low))
    }

    /// Value and slope at a point along a direction.
    fn value_along(&self, p: DVec3, d: DVec3) -> (f64, f64) {
        let side = |axis: usize| (p[axis].abs(), d[axis] * 1.0f64.copysign(p[axis]));
        let across = Self::norm_along(side(0), side(1), 2.0 / self.east_west);
        let (norm, slope) = Self::norm_along(across, side(2), 2.0 / self.north_south);
        (norm - 1.0, slope)
    }

    /// The outermost root of a convex shape on a chord, seen from one of its ends.
    ///
    /// From outside Newton's method never passes the root of a convex function; where the slope turns, there is none.
    fn outer_root(&self, chord: &Chord, from: f64, to: f64) -> Option<f64> {
        /// Contacts halve their distance each round, so bits run out before that.
        const ROUNDS: usize = 64;
        let direction = if from < to { chord.near.direction } else { -chord.near.direction };
        let (mut s, end) = (0.0, (to - from).abs());
        let point = |s: f64| chord.at(if from < to { from + s } else { from - s });
        for round in 0..ROUNDS {
            let (value, slope) = self.value_along(point(s), direction);
            if value <= 0.0 {
                // From within there is nothing to be found; a step onto the surface may round across it.
                return (round > 0).then_some(s);
            }
            let next = s - value / slope;
            if slope >= 0.0 || next > end {
                return None;
            }
            if next <= s * (1.0 + f64::EPSILON) {
                return Some(s);
            }
            s = next;
        }
        Some(s)
    }

    /// The p-norm's (aᵖ + bᵖ)^(1/p), without overflow for large powers.
    fn norm(a: f64, b: f64, p: f64) -> f64 {
        let (low, high) = (a.min(b), a.max(b));
        if high == 0.0 { 0.0 } else { high * (1.0 + (low / high).powf(p)).powf(1.0 / p) }
    }

    /// 0 on the surface, and linear in the size of `p`.
    fn value(&self, p: DVec3) -> f64 {
        let p = p.abs();
        Self::norm(Self::norm(p.x, p.y, 2.0 / self.east_west), p.z, 2.0 / self.north_south) - 1.0
    }

    /// Direction of steepest rise.
    fn gradient(&self, p: DVec3) -> DVec3 {
        let (pe, pn) = (2.0 / self.east_west, 2.0 / self.north_south);
        let a = p.abs();
        let across = Self::norm(a.x, a.y, pe);
        let whole = Self::norm(across, a.z, pn);
        // d norm(a, b; p) / da = (a / norm)^(p - 1).
        let slope = |part: f64, norm: f64, power: f64| if norm == 0.0 { 0.0 } else { (part / norm).powf(power - 1.0) };
        let outer = slope(across, whole, pn);
        let g = DVec3::new(outer * slope(a.x, across, pe), outer * slope(a.y, across, pe), slope(a.z, whole, pn));
        // On a symmetry plane a sharp edge has no slope of its own: finite values only.
        let g = DVec3::select(g.abs().cmplt(DVec3::INFINITY), g, DVec3::splat(1.0 / gamma(1)));
        g * DVec3::new(1.0f64.copysign(p.x), 1.0f64.copysign(p.y), 1.0f64.copysign(p.z))
    }

    /// Where values of opposite sign enclose a root. Source: Oliveira, Takahashi, An Enhancement
    /// of the Bisection Method Average Performance Preserving Minmax Optimality, 2021 (in spirit:
    /// false position, with bisection when it stalls).
    fn root(&self, ray: &NearRay, (mut low, mut f_low): (f64, f64), (mut high, mut f_high): (f64, f64)) -> f64 {
        for round in 0..200 {
            let guess = if round % 3 == 2 { 0.5 * (low + high) } else { low - f_low * (high - low) / (f_high - f_low) };
            let s = if guess > low && guess < high { guess } else { 0.5 * (low + high) };
            if s <= low || s >= high || high - low <= gamma(2) * low.abs().max(high.abs()) {
                break;
            }
            let f = self.value(ray.origin + ray.direction * s);
            if (f < 0.0) == (f_low < 0.0) { (low, f_low) = (s, f) } else { (high, f_high) = (s, f) }
        }
        0.5 * (low + high)
    }

    /// The least value between two samples whose neighbours are no lower, by golden section.
    fn dip(&self, ray: &NearRay, mut low: f64, mut high: f64) -> (f64, f64) {
        const GOLDEN: f64 = 0.381_966_011_250_105_1;
        let f = |s: f64| self.value(ray.origin + ray.direction * s);
        for _ in 0..48 {
            let (a, b) = (low + GOLDEN * (high - low), high - GOLDEN * (high - low));
            let (fa, fb) = (f(a), f(b));
            if fa <= 0.0 {
                return (a, fa);
            }
            if fa < fb { high = b } else { low = a }
        }
        let s = 0.5 * (low + high);
        (s, f(s))
    }

    /// Where a chord enters a convex shape.
    fn first(&self, chord: &Chord) -> Option<f64> {
        self.outer_root(chord, chord.low, chord.high).map(|s| chord.low + s)
    }

    /// Where a chord leaves a convex shape.
    fn last(&self, chord: &Chord) -> Option<f64> {
        self.outer_root(chord, chord.high, chord.low).map(|s| chord.high - s)
    }

    /// Every root on a chord of a shape that need not be convex.
    fn sampled(&self, chord: &Chord, mut record: impl FnMut(f64)) {
        let Chord { near, low, high } = chord;
        let (o, d, low, high) = (near.origin, near.direction, *low, *high);
        // Between symmetry planes the function is smooth.
        let mut cuts: SmallVec<[f64; 16]> = SmallVec::from_slice(&[low, high]);
        for plane in [
            DVec3::X,
            DVec3::Y,
            DVec3::Z,
            DVec3::new(1.0, 1.0, 0.0),
            DVec3::new(1.0, -1.0, 0.0),
            DVec3::new(1.0, 0.0, 1.0),
            DVec3::new(1.0, 0.0, -1.0),
            DVec3::new(0.0, 1.0, 1.0),
            DVec3::new(0.0, 1.0, -1.0),
        ] {
            let s = -plane.dot(o) / plane.dot(d);
            if s > low && s < high {
                cuts.push(s);
            }
        }
        cuts.sort_unstable_by(f64::total_cmp);
        let mut samples: SmallVec<[(f64, f64); 96]> = SmallVec::new();
        for pair in cuts.windows(2) {
            samples.extend(
                (0..SAMPLES).map(|k| pair[0] + (pair[1] - pair[0]) * (k as f64 / SAMPLES as f64)).map(|s| (s, 0.0)),
            );
        }
        samples.push((high, 0.0));
        for sample in &mut samples {
            sample.1 = self.value(o + d * sample.0);
        }
        for i in 1..samples.len() {
            let (a, b) = (samples[i - 1], samples[i]);
            if (a.1 < 0.0) != (b.1 < 0.0) {
                record(self.root(near, a, b));
            }
            let Some(c) = samples.get(i + 1) else { continue };
            if a.1 > 0.0 && b.1 > 0.0 && c.1 > 0.0 && b.1 <= a.1 && b.1 <= c.1 {
                let bottom = self.dip(near, a.0, c.0);
                if bottom.1 < 0.0 {
                    record(self.root(near, a, bottom));
                    record(self.root(near, bottom, *c));
                }
            }
        }
    }
}

impl Primitive for Superellipsoid {
    fn bounds(&self) -> Bounds {
        Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let Some(chord) = Chord::new(ray, range) else { return };
        let mut record = |s: f64| {
            let t = chord.near.t(s);
            if range.contains(t) {
                out.push(ShapeHit { t, part: 0 });
            }
        };
        if self.is_convex() {
            [self.first(&chord), self.last(&chord)].into_iter().flatten().for_each(record);
        } else {
            self.sampled(&chord, &mut record);
        }
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        if !self.is_convex() {
            let mut hits = ShapeHits::new();
            self.crossings(ray, range, &mut hits);
            return super::nearest_of(hits);
        }
        let chord = Chord::new(ray, range)?;
        let hit = |s: f64| Some(chord.near.t(s)).filter(|t| range.contains(*t)).map(|t| ShapeHit { t, part: 0 });
        self.first(&chord).and_then(hit).or_else(|| self.last(&chord).and_then(hit))
    }

    fn contains(&self, p: DVec3) -> bool {
        self.value(p) < INSIDE_SLACK
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let p = ray.at(t);
        // The value is linear in size, so scaling moves the point onto the surface.
        let point = p / (self.value(p) + 1.0);
        LocalSurface::plain(
            point,
            gamma(64) * (1.0 + 1.0 / self.east_west + 1.0 / self.north_south),
            self.gradient(point),
        )
    }
}
