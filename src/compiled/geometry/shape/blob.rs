//! Sums of soft spheres and cylinders.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::TextureId;
use crate::compiled::geometry::graph::padded;
use crate::compiled::geometry::parts::{Positions, Tree, WORTH_A_TREE};
use crate::math::{Bounds, DVec3, Range, Ray, Transform, gamma, roots_in};
use smallvec::SmallVec;
use std::sync::Arc;

/// Where a part's field is measured from; each counts only within its own region.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Core {
    /// The origin.
    Point,
    /// The z axis between 0 and this length.
    Axis(f64),
    /// The origin, for z < 0 only: the lower end of an axis.
    Start,
    /// The point (0, 0, length), for z beyond it: the upper end of an axis.
    End(f64),
}

/// A part's texture, with the way from the blob's space to the texture's.
pub(crate) type OwnTexture = Option<(TextureId, Transform)>;

/// A soft part: strength (1 - r²/R²)² within R of its core.
#[derive(Clone, Debug)]
pub(crate) struct BlobPart {
    pub(crate) core: Core,
    pub(crate) radius: f64,
    pub(crate) strength: f64,
    /// Takes the part's space to the blob's.
    pub(crate) blob_from_part: Transform,
    /// Its own texture.
    pub(crate) texture: OwnTexture,
}

/// The surface where the field takes a value; inside where it is higher.
#[derive(Clone, Debug)]
pub(crate) struct Blob {
    pub(crate) parts: Arc<[BlobPart]>,
    pub(crate) threshold: f64,
    /// Whether any part has a texture of its own.
    pub(crate) has_textures: bool,
    /// Around the parts that can hold a surface.
    bounds: Bounds,
    /// Finds parts where there are many.
    tree: Option<Arc<Tree>>,
}

/// POV-Ray's slack of the inside test.
const INSIDE_SLACK: f64 = 1e-6;

/// A stretch of a ray within the influence of a part, whose field is strength (peak - fall (t - nearest)²)² there.
///
/// Each has its own origin, so that a part much smaller than the blob keeps its digits.
#[derive(Clone, Copy)]
struct Stretch {
    low: f64,
    high: f64,
    /// Where the ray comes nearest to the core.
    nearest: f64,
    peak: f64,
    fall: f64,
    strength: f64,
}

impl Stretch {
    /// Adds the field from `t` on to a polynomial that rises in powers of steps of some length.
    #[inline]
    fn add_from(&self, t: f64, length: f64, sum: &mut [f64; 5]) {
        let from = t - self.nearest;
        let k = self.peak - self.fall * from * from;
        let (l, m) = (-2.0 * self.fall * from * length, -self.fall * length * length);
        let terms = [k * k, 2.0 * k * l, l * l + 2.0 * k * m, 2.0 * l * m, m * m];
        for (total, term) in sum.iter_mut().zip(terms) {
            *total += self.strength * term;
        }
    }
}

impl BlobPart {
    /// Position relative to the core, with the part across it that counts; `None` outside the region.
    fn offset(&self, p: DVec3) -> Option<DVec3> {
        match self.core {
            Core::Point => Some(p),
            Core::Axis(length) => (0.0 <= p.z && p.z <= length).then_some(p.with_z(0.0)),
            Core::Start => (p.z < 0.0).then_some(p),
            Core::End(length) => (p.z > length).then_some(p - DVec3::Z * length),
        }
    }

    /// Field and gradient at a point of the blob's space.
    fn sample(&self, p: DVec3) -> (f64, DVec3) {
        let Some(offset) = self.offset(self.blob_from_part.inverse_point(p)) else { return (0.0, DVec3::ZERO) };
        let r2 = self.radius * self.radius;
        let rest = 1.0 - offset.length_squared() / r2;
        if rest <= 0.0 {
            return (0.0, DVec3::ZERO);
        }
        let gradient = offset * (-4.0 * self.strength * rest / r2);
        (self.strength * rest * rest, self.blob_from_part.normal(gradient))
    }

    /// The field along a ray; `None` where the ray stays outside.
    fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let local = self.blob_from_part.inverse_ray(ray);
        let (mut o, mut d) = (local.origin, local.direction);
        let (z, dz) = (o.z, d.z);
        let (from, to) = match self.core {
            Core::Point => (f64::NEG_INFINITY, f64::INFINITY),
            Core::Axis(length) => {
                (o.z, d.z) = (0.0, 0.0);
                (0.0, length)
            }
            Core::Start => (f64::NEG_INFINITY, 0.0),
            Core::End(length) => {
                o.z -= length;
                (length, f64::INFINITY)
            }
        };
        let speed = d.length_squared();
        let way = |o: DVec3| if speed > 0.0 { -o.dot(d) / speed } else { 0.0 };
        // From far away, the rounding of the first way is what the second finds.
        let first = way(o);
        let second = way(o + d * first);
        let distance = (o + d * first + d * second).length();
        let radius = self.radius.abs();
        if distance >= radius {
            return None;
        }
        let (nearest, rest) = (first + second, (radius - distance) * (radius + distance));
        let half = (rest / speed).sqrt();
        let within = Range { min: nearest - half, max: nearest + half };
        let Range { min: low, max: high } = within.between([from, to], z, dz);
        let squared = radius * radius;
        let (peak, fall) = (rest / squared, speed / squared);
        (low < high).then_some(Stretch { low, high, nearest, peak, fall, strength: self.strength })
    }

    /// A box around the part's influence.
    fn bounds(&self) -> Bounds {
        let r = DVec3::splat(self.radius.abs());
        let end = match self.core {
            Core::Point | Core::Start => DVec3::ZERO,
            Core::Axis(length) | Core::End(length) => DVec3::Z * length,
        };
        let start = if matches!(self.core, Core::End(_)) { end } else { DVec3::ZERO };
        let local = Bounds::around([start - r, start + r, end - r, end + r]);
        self.blob_from_part.bounds(&local)
    }
}

impl Blob {
    /// The surface where the parts' field reaches the threshold.
    pub(crate) fn new(parts: Arc<[BlobPart]>, threshold: f64) -> Self {
        let all = threshold <= 0.0 && parts.iter().any(|p| p.strength < 0.0);
        let holding = parts.iter().filter(|p| all || p.strength > 0.0);
        let bounds = holding.fold(Bounds::EMPTY, |sum, p| sum.union(&p.bounds()));
        let has_textures = parts.iter().any(|p| p.texture.is_some());
        let tree = (parts.len() >= WORTH_A_TREE).then(|| {
            let boxes: Vec<Bounds> = parts.iter().map(|part| padded(part.bounds())).collect();
            Arc::new(Tree::new(&boxes))
        });
        Self { parts, threshold, has_textures, bounds, tree }
    }

    fn field(&self, p: DVec3) -> f64 {
        self.felt_at(p).map(|i| self.parts[i].sample(p).0).sum()
    }

    /// Parts that may be felt at a point, and others, in their order.
    fn felt_at(&self, p: DVec3) -> impl DoubleEndedIterator<Item = usize> {
        self.near(move |tree| tree.around(p))
    }

    /// The parts that a search finds, or all.
    fn near(&self, search: impl FnOnce(&Tree) -> Positions) -> impl DoubleEndedIterator<Item = usize> {
        let all = if self.tree.is_some() { 0 } else { self.parts.len() };
        let found = self.tree.as_ref().map(|tree| search(tree)).unwrap_or_default();
        found.into_iter().map(|i| i as usize).chain(0..all)
    }

    /// The parts felt at a point, by number, with their shares in the texture. Empty if no part has a texture. The
    /// last part comes first, as in POV-Ray: bumps of one texture are seen by the slope patterns of those after it.
    pub(crate) fn textures(&self, p: DVec3) -> SmallVec<[(u32, f32); 4]> {
        if !self.has_textures {
            return SmallVec::new();
        }
        let weights = self.felt_at(p).rev().map(|i| (i as u32, self.parts[i].sample(p).0.abs()));
        let felt: SmallVec<[_; 4]> = weights.filter(|(_, w)| *w > 0.0).collect();
        let sum: f64 = felt.iter().map(|(_, w)| w).sum();
        felt.into_iter().map(|(i, w)| (i, (w / sum) as f32)).collect()
    }

    /// Goes along a ray to every place where the field takes the threshold, until `found` returns false. Between the
    /// places where the ray enters or leaves a part the field is one quartic.
    fn search(&self, ray: &Ray, range: Range, mut found: impl FnMut(f64) -> bool) {
        let met = self.near(|tree| tree.met_by(ray, range));
        let mut stretches: SmallVec<[Stretch; 8]> = met.filter_map(|i| self.parts[i].stretch(ray)).collect();
        stretches.sort_unstable_by(|a, b| a.low.total_cmp(&b.low));
        let mut ahead = stretches.iter().peekable();
        let mut within: SmallVec<[&Stretch; 16]> = SmallVec::new();
        let mut at = range.min;
        // Whether the field was above the threshold where the last piece ended: there the next one begins.
        let mut before = None;
        while at < range.max {
            if within.is_empty() {
                let Some(next) = ahead.peek() else { return };
                if next.low > at {
                    (at, before) = (next.low, None);
                }
            }
            within.extend(std::iter::from_fn(|| ahead.next_if(|s| s.low <= at)));
            let next = ahead.peek().map_or(range.max, |s| s.low.min(range.max));
            let end = within.iter().fold(next, |end, s| end.min(s.high));
            if at < end && !self.search_piece(&within, [at, end], &mut before, &mut found) {
                return;
            }
            at = at.max(end);
            within.retain(|s| s.high > at);
        }
    }

    /// The same between two places. `before` goes from piece to piece, so that a root at a common end is found once, even
    /// where rounding puts it outside of both pieces or inside of both.
    fn search_piece(
        &self,
        within: &[&Stretch],
        [at, end]: [f64; 2],
        before: &mut Option<bool>,
        mut found: impl FnMut(f64) -> bool,
    ) -> bool {
        let length = end - at;
        let mut sum = [-self.threshold, 0.0, 0.0, 0.0, 0.0];
        for stretch in within {
            stretch.add_from(at, length, &mut sum);
        }
        let roots = roots_in(&sum, 0.0, 1.0);
        // By the first coefficient that has a sign.
        let above = sum.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
        let crossed = before.is_some_and(|before| before != above);
        *before = Some(above != (roots.len() % 2 == 1));
        (!crossed || found(at)) && roots.into_iter().all(|u| found(at + u * length))
    }
}

impl Primitive for Blob {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        self.search(ray, range, |t| {
            out.extend(range.contains(t).then_some(ShapeHit { t, part: 0 }));
            true
        });
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let mut first = None;
        self.search(ray, range, |t| {
            first = range.contains(t).then_some(ShapeHit { t, part: 0 });
            first.is_none()
        });
        first
    }

    fn contains(&self, p: DVec3) -> bool {
        self.field(p) > self.threshold - INSIDE_SLACK
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let hit = ray.at(t);
        let felt: SmallVec<[usize; 16]> = self.felt_at(hit).collect();
        let sample = |p: DVec3| {
            felt.iter().fold((-self.threshold, DVec3::ZERO, self.threshold.abs()), |(f, g, m), i| {
                let part = &self.parts[*i];
                let (field, gradient) = part.sample(p);
                (f + field, g + gradient, m + field.abs() + part.strength.abs())
            })
        };
        let (point, error, gradient) = super::onto_surface(hit, sample);
        let b = self.bounds();
        let size = b.min.abs().max(b.max.abs()).max_element();
        // A step out of the parts' influence, or to another place of the surface, would leave this one.
        let (before, after) = (sample(hit), sample(point));
        let (point, gradient) = if after.0.abs() <= before.0.abs() { (point, gradient) } else { (hit, before.1) };
        let normal = if gradient == DVec3::ZERO { DVec3::X } else { -gradient };
        LocalSurface::plain(point, error + gamma(64) * size, normal)
    }
}
