//! Outlines swept along an axis: prisms and text.

use super::outline::{Segment, around, join, odd_right_of};
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::parts::{Tree, WORTH_A_TREE};
use crate::compiled::geometry::slab::SlabRay;
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, gamma};
use passage::{Band, Boxes, Passage};
use std::sync::Arc;

mod passage;

/// Closed curves that belong together: what an odd number of them surrounds is inside.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub(crate) segments: Box<[Segment]>,
    /// Lower and upper corner of a box around each segment.
    hulls: Box<[[DVec2; 2]]>,
    /// The same for lanes.
    boxes: Boxes,
    min: DVec2,
    max: DVec2,
    /// Around the outline swept by its prism.
    swept: Bounds,
    /// How many segments the prism's outlines before it have.
    first: u32,
}

impl Outline {
    pub(crate) fn new(mut segments: Vec<Segment>) -> Self {
        join(&mut segments);
        let hulls: Box<_> = segments.iter().map(Segment::bounds).collect();
        let [min, max] = around(&hulls);
        Self { segments: segments.into(), boxes: Boxes::new(&hulls), hulls, min, max, swept: Bounds::EMPTY, first: 0 }
    }

    fn contains(&self, p: DVec2) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all() && odd_right_of(&self.segments, &self.hulls, p)
    }
}

/// Outlines in (x, z), from `low` to `high` in y.
#[derive(Clone, Debug)]
pub(crate) struct Prism {
    /// Solids beside each other: one for a prism, one for each glyph of a text.
    pub(crate) outlines: Arc<[Outline]>,
    /// Finds outlines where there are many.
    pub(crate) tree: Option<Arc<Tree>>,
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// The outline stands at y = 1 and grows from the origin.
    pub(crate) conic: bool,
    pub(crate) open: bool,
    /// Two caps and nothing between or inside, as POV-Ray makes of text with a negative thickness.
    pub(crate) caps_only: bool,
    /// The lower cap's normal points down, as in text; prisms have both pointing up.
    pub(crate) outward_caps: bool,
}

/// POV-Ray's height below which a conic sweep has come to its point: no cap, and no inside.
const AT_APEX: f64 = 1e-10;

/// The line `normal . p + constant = 0`.
struct Shadow {
    normal: DVec2,
    constant: f64,
}

const LOW_CAP: u32 = u32::MAX - 1;
const HIGH_CAP: u32 = u32::MAX;

impl Prism {
    /// Where the outline is hit, seen from the swept axis.
    fn flat(&self, p: DVec3, y: f64) -> DVec2 {
        let p = DVec2::new(p.x, p.z);
        if self.conic { p / y } else { p }
    }

    /// Closed, with everything inside, caps as prisms have them.
    pub(crate) fn new(mut outlines: Vec<Outline>, heights: [f64; 2], conic: bool) -> Self {
        let [low, high] = heights;
        let mut first = 0;
        for outline in &mut outlines {
            outline.first = first;
            first += outline.segments.len() as u32;
            let corner = |y: f64| {
                let scale = if conic { y } else { 1.0 };
                let (a, b) = (outline.min * scale, outline.max * scale);
                Bounds::from_corners(DVec3::new(a.x, y, a.y), DVec3::new(b.x, y, b.y))
            };
            outline.swept = super::super::graph::padded(corner(low).union(&corner(high)));
        }
        let swept: Vec<Bounds> = outlines.iter().map(|outline| outline.swept).collect();
        let tree = (!conic && swept.len() >= WORTH_A_TREE).then(|| Arc::new(Tree::new(&swept)));
        let outlines = outlines.into();
        Self { outlines, tree, low, high, conic, open: false, caps_only: false, outward_caps: false }
    }

    /// `None` where a ray's shadow passes by an outline.
    fn passage(&self, outline: &Outline, slabs: &SlabRay<'_>, shadow: &Shadow, range: Range) -> Option<Passage> {
        let (ray, hull) = (slabs.ray, [outline.min, outline.max]);
        let corner = hull[0].abs().max(hull[1].abs());
        // Products of points as far away as corners round less often than that, here and where boxes were found.
        let product_error = |direction: DVec2| gamma(64) * direction.abs().dot(corner);
        let slack = 2.0 * product_error(shadow.normal) + gamma(64) * shadow.constant.abs();
        let across = Band::new(shadow.normal, [-shadow.constant; 2], slack);
        let Range { min, max } = slabs.within(&outline.swept, range);
        if min > max {
            return None;
        }
        let (a, b) = (ray.at(min), ray.at(max));
        // As uncertain as the box was taken to be.
        let slack = gamma(64) * (a.abs().max(b.abs()).max_element() + ray.origin.abs().max_element());
        let direction = shadow.normal.perp();
        let (start, end, slack) = if self.conic {
            let height = if a.y * b.y > 0.0 { a.y.abs().min(b.y.abs()) } else { 0.0 };
            if height <= 2.0 * slack {
                // The shadow's ends may be anywhere.
                let along = Band::new(direction, [f64::NEG_INFINITY, f64::INFINITY], 0.0);
                return Some(Passage { across, along, hull });
            }
            let (a, b) = (self.flat(a, a.y), self.flat(b, b.y));
            (a, b, 2.0 * slack * (1.0 + a.abs().max(b.abs()).max_element()) / height)
        } else {
            (self.flat(a, 1.0), self.flat(b, 1.0), slack)
        };
        let (from, to) = (direction.dot(start), direction.dot(end));
        let slack_along = direction.abs().element_sum() * slack + 2.0 * product_error(direction);
        let along = Band::new(direction, [from.min(to), from.max(to)], slack_along);
        Some(Passage { across, along, hull: [start.min(end) - slack, start.max(end) + slack] })
    }

    /// The ray's shadow on the plane of the outline.
    fn shadow(&self, ray: &Ray) -> Shadow {
        let (o, d) = (ray.origin, ray.direction);
        // The plane that holds the ray and, for cones, the origin; else, the axis' direction.
        if self.conic {
            let n = o.cross(d);
            Shadow { normal: DVec2::new(n.x, n.z), constant: n.y }
        } else {
            let normal = DVec2::new(-d.z, d.x);
            Shadow { normal, constant: -normal.dot(DVec2::new(o.x, o.z)) }
        }
    }

    /// Crossings with one piece of outline swept without end: (t, w).
    fn sides(&self, segment: &Segment, ray: &Ray, shadow: &Shadow, mut found: impl FnMut(f64, f64)) {
        let (o, d) = (ray.origin, ray.direction);
        for w in segment.zeros(shadow.normal.x, shadow.normal.y, shadow.constant) {
            let p = segment.at(w);
            let lean = if self.conic { p } else { DVec2::ZERO };
            let start = if self.conic { p * o.y } else { p };
            let gap = start - DVec2::new(o.x, o.z);
            let speed = DVec2::new(d.x, d.z) - lean * d.y;
            found(gap.dot(speed) / speed.length_squared(), w);
        }
    }

    /// Goes through the outlines that a ray may meet, in their order, and perhaps others.
    fn met_by(&self, ray: &Ray, range: Range, visit: impl FnMut(&Outline)) {
        match &self.tree {
            Some(tree) => tree.met_by(ray, range).into_iter().map(|i| &self.outlines[i as usize]).for_each(visit),
            None => self.outlines.iter().for_each(visit),
        }
    }

    /// Crossings with what an outline makes.
    #[inline]
    fn outline_crossings(
        &self,
        outline: &Outline,
        slabs: &SlabRay<'_>,
        shadow: &Shadow,
        range: Range,
        out: &mut ShapeHits,
    ) {
        let ray = slabs.ray;
        let Some(passage) = self.passage(outline, slabs, shadow, range) else { return };
        // A ray along the axis meets caps alone.
        let no_sides = self.caps_only || shadow.normal == DVec2::ZERO;
        let sides = if no_sides { 0 } else { outline.segments.len() };
        outline.boxes.met_by(&passage, sides, |i| {
            let (segment, part) = (&outline.segments[i], outline.first + i as u32);
            self.sides(segment, ray, shadow, |t, _| {
                let y = ray.origin.y + t * ray.direction.y;
                if range.contains(t) && self.low <= y && y <= self.high {
                    out.push(ShapeHit { t, part });
                }
            });
        });
        if self.open || ray.direction.y == 0.0 {
            return;
        }
        for (y, part) in [(self.low, LOW_CAP), (self.high, HIGH_CAP)] {
            let t = (y - ray.origin.y) / ray.direction.y;
            // POV-Ray's threshold for a cone's missing cap at its apex.
            let there = !self.conic || y.abs() > AT_APEX;
            if there && range.contains(t) && outline.contains(self.flat(ray.at(t), y)) {
                out.push(ShapeHit { t, part });
            }
        }
    }

    fn size(&self) -> f64 {
        let b = self.bounds();
        b.min.abs().max(b.max.abs()).max_element()
    }
}

impl Primitive for Prism {
    fn bounds(&self) -> Bounds {
        self.outlines.iter().fold(Bounds::EMPTY, |sum, o| sum.union(&o.swept))
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let (shadow, slabs) = (self.shadow(ray), SlabRay::new(ray));
        self.met_by(ray, range, |outline| self.outline_crossings(outline, &slabs, &shadow, range, out));
    }

    fn contains(&self, p: DVec3) -> bool {
        // A prism does not hold its upper cap, a letter does.
        let below = if self.outward_caps { p.y <= self.high } else { p.y < self.high };
        let within = self.low <= p.y && below && !(self.conic && p.y.abs() <= AT_APEX);
        within && !self.caps_only && self.outlines.iter().any(|o| o.contains(self.flat(p, p.y)))
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let point = ray.at(t);
        let error = gamma(64) * self.size();
        match part {
            LOW_CAP if self.outward_caps => return LocalSurface::plain(point.with_y(self.low), error, DVec3::NEG_Y),
            LOW_CAP => return LocalSurface::plain(point.with_y(self.low), error, DVec3::Y),
            HIGH_CAP => return LocalSurface::plain(point.with_y(self.high), error, DVec3::Y),
            _ => {}
        }
        let owner = self.outlines[..self.outlines.partition_point(|outline| outline.first <= part)].last();
        let Some(segment) = owner.and_then(|outline| outline.segments.get((part - outline.first) as usize)) else {
            return LocalSurface::plain(point, error, DVec3::Y);
        };
        let mut nearest = (f64::INFINITY, 0.0);
        self.sides(segment, ray, &self.shadow(ray), |s, w| {
            if (s - t).abs() < nearest.0 {
                nearest = ((s - t).abs(), w);
            }
        });
        let (on_curve, slope) = (segment.at(nearest.1), segment.slope(nearest.1));
        let scale = if self.conic { point.y } else { 1.0 };
        let point = DVec3::new(on_curve.x * scale, point.y, on_curve.y * scale);
        let lean = if self.conic { -(on_curve.x * slope.y - on_curve.y * slope.x) } else { 0.0 };
        LocalSurface::plain(point, error, DVec3::new(slope.y, lean, -slope.x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::MersenneTwister;

    /// Rays from near and far meet the sides of a star with rounded corners where they meet any of its pieces.
    fn check(heights: [f64; 2], conic: bool) {
        let corner = |i: usize| (if i.is_multiple_of(2) { 1.0 } else { 0.4 }) * DVec2::from_angle(0.6 * i as f64);
        let piece = |i: usize| Segment::cubic([0, 1, 2, 3].map(|j| corner((i + j) % 10)));
        let prism = Prism::new(vec![Outline::new((0..10).map(piece).collect())], heights, conic);
        let mut twister = MersenneTwister::default();
        let mut random = || 2.0 * twister.next_f64() - 1.0;
        let mut met = 0;
        for i in 0..20_000 {
            let mut vector = || DVec3::new(random(), random(), random());
            let (origin, target) = (vector() * 10f64.powi(i % 5 - 1), vector());
            let ray = Ray::new(origin, target - origin);
            let mut expected = Vec::new();
            for segment in &prism.outlines[0].segments {
                prism.sides(segment, &ray, &prism.shadow(&ray), |t, _| {
                    let y = ray.origin.y + t * ray.direction.y;
                    expected.extend((Range::FORWARD.contains(t) && prism.low <= y && y <= prism.high).then_some(t));
                });
            }
            let mut found = ShapeHits::new();
            prism.crossings(&ray, Range::FORWARD, &mut found);
            let found: Vec<_> = found.into_iter().filter(|hit| hit.part < LOW_CAP).map(|hit| hit.t).collect();
            assert_eq!(found, expected, "{ray:?}");
            met += found.len();
        }
        assert!(met > 5_000, "only {met} crossings");
    }

    #[test]
    fn no_piece_on_the_way_is_left_out() {
        check([-0.5, 0.5], false);
        check([0.25, 1.0], true);
        check([0.0, 1.0], true);
        check([-1.0, -0.01], true);
        check([-0.7, 0.9], true);
    }
}
