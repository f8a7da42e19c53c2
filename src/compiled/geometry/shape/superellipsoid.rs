//! Superquadric ellipsoids.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, gamma};
use std::ops::ControlFlow;

mod hollow;

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
        let mut reach = near.range(range);
        for axis in 0..3 {
            // A little larger than the shape, so that roots on its flat faces are enclosed.
            reach = reach.between([-1.001, 1.001], o[axis], d[axis]);
        }
        let Range { min: low, max: high } = reach;
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

    /// Powers of both norms: across z, and of that and z.
    fn powers(&self) -> [f64; 2] {
        [2.0 / self.east_west, 2.0 / self.north_south]
    }

    /// The p-norm of two lengths and its slope, from the lengths and their slopes; without end where a length
    /// leaves 0 and p < 1.
    fn norm_along((a, da): (f64, f64), (b, db): (f64, f64), p: f64) -> (f64, f64) {
        let ((low, d_low), (high, d_high)) = if a < b { ((a, da), (b, db)) } else { ((b, db), (a, da)) };
        if high == 0.0 {
            // Both lengths grow from here or have shrunk up to here.
            return (0.0, Self::norm(da.abs(), db.abs(), p).copysign(da + db));
        }
        let ratio = low / high;
        let power = raised(ratio, p);
        let root = rooted(1.0 + power, p);
        let share = match (ratio > 0.0, p < 1.0) {
            (true, _) => power / ratio,
            (false, true) => f64::INFINITY,
            (false, false) => 0.0,
        };
        let low_slope = if d_low == 0.0 { 0.0 } else { share * d_low };
        (high * root, root / (1.0 + power) * (d_high + low_slope))
    }

    /// Value and slope at a point along a direction.
    fn value_along(&self, p: DVec3, d: DVec3) -> (f64, f64) {
        let side = |axis: usize| (p[axis].abs(), d[axis] * 1.0f64.copysign(p[axis]));
        let [pe, pn] = self.powers();
        let across = Self::norm_along(side(0), side(1), pe);
        let (norm, slope) = Self::norm_along(across, side(2), pn);
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
        if high == 0.0 { 0.0 } else { high * rooted(1.0 + raised(low / high, p), p) }
    }

    /// The norm across z, and of that and z: 1 on the surface, and linear in the size of `p`.
    fn norms(&self, p: DVec3) -> [f64; 2] {
        let ([pe, pn], p) = (self.powers(), p.abs());
        let across = Self::norm(p.x, p.y, pe);
        [across, Self::norm(across, p.z, pn)]
    }

    /// Direction of steepest rise at a point with such norms.
    fn gradient(&self, p: DVec3, [across, whole]: [f64; 2]) -> DVec3 {
        let ([pe, pn], a) = (self.powers(), p.abs());
        // d norm(a, b; p) / da = (a / norm)^(p - 1).
        let slope = |part: f64, norm: f64, p: f64| match norm {
            0.0 => 0.0,
            _ if p == 2.0 => part / norm,
            _ => (part / norm).powf(p - 1.0),
        };
        let outer = slope(across, whole, pn);
        let g = DVec3::new(outer * slope(a.x, across, pe), outer * slope(a.y, across, pe), slope(a.z, whole, pn));
        // On a symmetry plane a sharp edge has no slope of its own: finite values only.
        let g = DVec3::select(g.abs().cmplt(DVec3::INFINITY), g, DVec3::splat(1.0 / gamma(1)));
        g * DVec3::ONE.copysign(p)
    }

    /// Where a chord enters a convex shape.
    fn first(&self, chord: &Chord) -> Option<f64> {
        self.outer_root(chord, chord.low, chord.high).map(|s| chord.low + s)
    }

    /// Where a chord leaves a convex shape.
    fn last(&self, chord: &Chord) -> Option<f64> {
        self.outer_root(chord, chord.high, chord.low).map(|s| chord.high - s)
    }
}

/// x^p; most shapes have a round side.
#[inline]
fn raised(x: f64, p: f64) -> f64 {
    if p == 2.0 { x * x } else { x.powf(p) }
}

/// x^(1/p).
#[inline]
fn rooted(x: f64, p: f64) -> f64 {
    if p == 2.0 {
        x.sqrt()
    } else if x == 1.0 {
        1.0
    } else {
        x.powf(1.0 / p)
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
            let _: ControlFlow<()> = self.roots(&chord, |s| {
                record(s);
                ControlFlow::Continue(())
            });
        }
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let chord = Chord::new(ray, range)?;
        let hit = |s: f64| Some(chord.near.t(s)).filter(|t| range.contains(*t)).map(|t| ShapeHit { t, part: 0 });
        if !self.is_convex() {
            let mut nearest = None;
            let _: ControlFlow<()> = self.roots(&chord, |s| {
                nearest = hit(s);
                if nearest.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            return nearest;
        }
        self.first(&chord).and_then(hit).or_else(|| self.last(&chord).and_then(hit))
    }

    fn contains(&self, p: DVec3) -> bool {
        self.norms(p)[1] - 1.0 < INSIDE_SLACK
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let p = ray.at(t);
        let norms = self.norms(p);
        // The whole norm is linear in size, so scaling moves the point onto the surface; directions do not change.
        let error = gamma(64) * (1.0 + 1.0 / self.east_west + 1.0 / self.north_south);
        let moved = p / norms[1];
        // Spikes thinner than the last place of their coordinates have a norm of no use.
        LocalSurface::plain(if moved.is_finite() { moved } else { p }, error, self.gradient(p, norms))
    }
}
