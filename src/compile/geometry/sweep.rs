//! Prisms, lathes, surfaces of revolution and sphere sweeps: points become polynomial pieces.
//!
//! Source of all layouts: freeform facts, sections 6 to 10.

use crate::compiled::geometry::{
    Lathe, Outline, Prism, Segment, Shape as Compiled, Sor, SorSegment, SphereSweep, SweepSegment,
};
use crate::math::{Bounds, DVec2, DVec3};
use crate::scene::{self, SweepSpline};

/// POV-Ray's distance at which outline points are the same, in units of the outline's size.
const SAME_POINT: f64 = 1e-10;

/// POV-Ray's `tolerance` of sphere sweeps where none is given.
const SWEEP_TOLERANCE: f64 = 1e-6;

/// Tells whether two of some points are the same.
fn sameness(points: &[DVec2]) -> impl Fn(DVec2, DVec2) -> bool {
    let size = points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    move |a, b| (a - b).abs().max_element() <= SAME_POINT * size
}

/// A prism; `None` if its outline does not close.
pub(super) fn prism(prism: &scene::Prism) -> Option<Compiled> {
    let p = &prism.points;
    let segments = match prism.spline {
        SweepSpline::Linear => linear_outline(p),
        SweepSpline::Quadratic => steered_outline(p, 0, |w| Segment::quadratic(w[0], w[1], w[2]))?,
        SweepSpline::Cubic => steered_outline(p, 1, |w| Segment::cubic([w[0], w[1], w[2], w[3]]))?,
        // Traversed backwards, as POV-Ray does: its normals depend on it.
        _ => p.chunks_exact(4).map(|w| Segment::bezier([w[3], w[2], w[1], w[0]])).collect(),
    };
    let [a, b] = prism.heights;
    let swept = Prism::new(vec![Outline::new(segments)], [a.min(b), a.max(b)], prism.conic);
    Some(Compiled::Prism(Prism { open: prism.open, ..swept }))
}

/// Lines; an outline ends where a point repeats its first, the last one is closed in any case.
fn linear_outline(points: &[DVec2]) -> Vec<Segment> {
    let mut segments = Vec::new();
    let same = sameness(points);
    let mut start = 0;
    for i in 1..points.len() {
        if i == start {
            continue;
        }
        segments.push(Segment::line(points[i - 1], points[i]));
        if same(points[i], points[start]) {
            start = i + 1;
        }
    }
    if start + 1 < points.len() {
        segments.push(Segment::line(points[points.len() - 1], points[start]));
    }
    segments
}

/// Splines with one control point before each outline and `after` behind it.
fn steered_outline(points: &[DVec2], after: usize, segment: impl Fn(&[DVec2]) -> Segment) -> Option<Vec<Segment>> {
    let mut segments = Vec::new();
    let same = sameness(points);
    let mut rest = points;
    while rest.len() > 2 + after {
        let end = (2..rest.len() - after).find(|i| same(rest[*i], rest[1]))?;
        segments.extend((1..end).map(|i| segment(&rest[i - 1..=i + 1 + after])));
        rest = &rest[end + 1 + after..];
    }
    Some(segments)
}

/// A lathe.
pub(super) fn lathe(spline: SweepSpline, p: &[DVec2]) -> Compiled {
    let segments: Vec<Segment> = match spline {
        SweepSpline::Linear => p.windows(2).map(|w| Segment::line(w[0], w[1])).collect(),
        SweepSpline::Quadratic => p.windows(3).map(|w| Segment::quadratic(w[0], w[1], w[2])).collect(),
        SweepSpline::Bezier => p.chunks_exact(4).map(|w| Segment::bezier([w[0], w[1], w[2], w[3]])).collect(),
        _ => p.windows(4).map(|w| Segment::cubic([w[0], w[1], w[2], w[3]])).collect(),
    };
    // POV-Ray's core is as thick as the box around the curve leaves room for, which for Bézier curves holds all points.
    let least = || p.iter().map(|point| point.x).fold(f64::INFINITY, f64::min);
    let hollow = matches!(spline, SweepSpline::Bezier).then(least);
    Compiled::Lathe(Lathe::new(segments, hollow))
}

/// A surface of revolution; the first and last point only steer.
pub(super) fn sor(points: &[DVec2], open: bool) -> Compiled {
    let piece = |w: &[DVec2]| {
        let (r1, r2) = (w[1].x * w[1].x, w[2].x * w[2].x);
        let slope = |a: DVec2, at: DVec2, b: DVec2| 2.0 * at.x * (b.x - a.x) / (b.y - a.y);
        let (s1, s2) = (slope(w[0], w[1], w[2]), slope(w[1], w[2], w[3]));
        let h = w[2].y - w[1].y;
        // Hermite's cubic over the height above the lower point.
        let c2 = (3.0 * (r2 - r1) / h - 2.0 * s1 - s2) / h;
        let c3 = (2.0 * (r1 - r2) / h + s1 + s2) / (h * h);
        SorSegment { low: w[1].y, high: w[2].y, squared: [r1, s1, c2, c3] }
    };
    Compiled::Sor(Sor::new(points.windows(4).map(piece).collect(), open))
}

/// A sphere sweep; centre and radius follow the same curve.
pub(super) fn sphere_sweep(spline: SweepSpline, spheres: &[(DVec3, f64)], tolerance: f64) -> Compiled {
    // Rows give the coefficients of a segment, rising, by the spheres around it.
    const CATMULL_ROM: [[f64; 4]; 4] =
        [[0.0, 1.0, 0.0, 0.0], [-0.5, 0.0, 0.5, 0.0], [1.0, -2.5, 2.0, -0.5], [-0.5, 1.5, -1.5, 0.5]];
    const B_SPLINE: [[f64; 4]; 4] =
        [[1.0, 4.0, 1.0, 0.0], [-3.0, 0.0, 3.0, 0.0], [3.0, -6.0, 3.0, 0.0], [-1.0, 3.0, -3.0, 1.0]];
    let curved = |rows: &[[f64; 4]; 4], scale: f64, w: &[(DVec3, f64)]| {
        let center = rows.map(|row| row.iter().zip(w).map(|(k, q)| q.0 * *k).sum::<DVec3>() * scale);
        let radius = rows.map(|row| row.iter().zip(w).map(|(k, q)| q.1 * k).sum::<f64>() * scale);
        SweepSegment::new(center, radius, false)
    };
    let segments: Vec<SweepSegment> = match spline {
        SweepSpline::Linear => spheres
            .windows(2)
            .map(|w| {
                let [(c0, r0), (c1, r1)] = [w[0], w[1]];
                SweepSegment::new([c0, c1 - c0, DVec3::ZERO, DVec3::ZERO], [r0, r1 - r0, 0.0, 0.0], true)
            })
            .collect(),
        SweepSpline::B => spheres.windows(4).map(|w| curved(&B_SPLINE, 1.0 / 6.0, w)).collect(),
        _ => spheres.windows(4).map(|w| curved(&CATMULL_ROM, 1.0, w)).collect(),
    };
    let bounds = segments.iter().fold(Bounds::EMPTY, |sum, s| sum.union(&s.bounds()));
    // Rays start off the surface here: only a larger tolerance than POV-Ray's own can be seen.
    let tolerance = if tolerance > SWEEP_TOLERANCE { tolerance } else { 0.0 };
    Compiled::SphereSweep(SphereSweep { segments: segments.into(), bounds, tolerance })
}
