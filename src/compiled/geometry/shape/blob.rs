//! Sums of soft spheres and cylinders.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::geometry::TextureId;
use crate::compiled::geometry::graph::padded;
use crate::compiled::geometry::parts::{Positions, Tree, WORTH_A_TREE};
use crate::math::{Bounds, DVec3, Range, Ray, Transform, gamma, quadratic_roots, roots_in};
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

/// Some parts, in their order.
type Near<'a> = SmallVec<[&'a BlobPart; 16]>;

/// POV-Ray's slack of the inside test.
const INSIDE_SLACK: f64 = 1e-6;

/// A stretch of a ray within the influence of a part: the squared distance as a quadratic of t.
struct Stretch {
    low: f64,
    high: f64,
    /// Field along the ray, rising.
    field: [f64; 5],
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

    /// The field along a ray, measured from `start` on; `None` where the ray stays outside.
    fn stretch(&self, ray: &Ray, start: f64) -> Option<Stretch> {
        let local = self.blob_from_part.inverse_ray(ray);
        let (mut o, mut d) = (local.at(start), local.direction);
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
        let r2 = self.radius * self.radius;
        let (a, b, c) = (d.length_squared(), 2.0 * o.dot(d), o.length_squared());
        let (low, high) = if a > 0.0 {
            let [low, high] = quadratic_roots(a, b, c - r2)?;
            (low, high)
        } else if c < r2 {
            (f64::NEG_INFINITY, f64::INFINITY)
        } else {
            return None;
        };
        let Range { min: low, max: high } = Range { min: low, max: high }.between([from, to], z, dz);
        // strength (1 - (c + b s + a s²) / R²)².
        let (k, l, m) = (1.0 - c / r2, -b / r2, -a / r2);
        let field = [k * k, 2.0 * k * l, l * l + 2.0 * k * m, 2.0 * l * m, m * m].map(|f| f * self.strength);
        (low < high).then_some(Stretch { low, high, field })
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
        self.felt_at(p).iter().map(|part| part.sample(p).0).sum()
    }

    /// Parts that may be felt at a point, and others.
    fn felt_at(&self, p: DVec3) -> Near<'_> {
        self.near(|tree| tree.around(p))
    }

    /// The parts that a search finds, or all.
    fn near(&self, search: impl FnOnce(&Tree) -> Positions) -> Near<'_> {
        match &self.tree {
            Some(tree) => search(tree).into_iter().map(|i| &self.parts[i as usize]).collect(),
            None => self.parts.iter().collect(),
        }
    }

    /// The parts felt at a point, by number, with their shares in the texture. Empty if no part has a texture. The
    /// last part comes first, as in POV-Ray: bumps of one texture are seen by the slope patterns of those after it.
    pub(crate) fn textures(&self, p: DVec3) -> SmallVec<[(u32, f32); 4]> {
        if !self.has_textures {
            return SmallVec::new();
        }
        let weights = self.parts.iter().enumerate().rev().map(|(i, part)| (i as u32, part.sample(p).0.abs()));
        let felt: SmallVec<[_; 4]> = weights.filter(|(_, w)| *w > 0.0).collect();
        let sum: f64 = felt.iter().map(|(_, w)| w).sum();
        felt.into_iter().map(|(i, w)| (i, (w / sum) as f32)).collect()
    }
}

impl Primitive for Blob {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Between the places where the ray enters or leaves a part the field is one quartic.
    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        // Measured from where the ray comes near, or from its origin if that is near already.
        let bounds = self.bounds();
        let center = bounds.center() - ray.origin;
        let far = center.length_squared() > bounds.size().length_squared();
        let start = if far { center.dot(ray.direction) / ray.direction.length_squared() } else { 0.0 };
        let met = self.near(|tree| tree.met_by(ray, range));
        let stretches: SmallVec<[Stretch; 8]> = met.iter().filter_map(|p| p.stretch(ray, start)).collect();
        let mut events: SmallVec<[f64; 16]> = stretches.iter().flat_map(|s| [s.low, s.high]).collect();
        events.sort_unstable_by(f64::total_cmp);
        events.dedup();
        for pair in events.windows(2) {
            let (low, high) = (pair[0].max(range.min - start), pair[1].min(range.max - start));
            if low >= high {
                continue;
            }
            let mut sum = [-self.threshold, 0.0, 0.0, 0.0, 0.0];
            let mut any = false;
            for stretch in stretches.iter().filter(|s| s.low <= pair[0] && s.high >= pair[1]) {
                any = true;
                for (total, term) in sum.iter_mut().zip(stretch.field) {
                    *total += term;
                }
            }
            if any {
                let hits = roots_in(&sum, low, high).into_iter().map(|s| ShapeHit { t: s + start, part: 0 });
                out.extend(hits.filter(|h| range.contains(h.t)));
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        self.field(p) > self.threshold - INSIDE_SLACK
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let sample = |p: DVec3| {
            self.felt_at(p).iter().fold((-self.threshold, DVec3::ZERO, self.threshold.abs()), |(f, g, m), part| {
                let (field, gradient) = part.sample(p);
                (f + field, g + gradient, m + field.abs() + part.strength.abs())
            })
        };
        let hit = ray.at(t);
        let (point, error, gradient) = super::onto_surface(hit, sample);
        let b = self.bounds();
        let size = b.min.abs().max(b.max.abs()).max_element();
        // A step out of the parts' influence would leave the surface.
        let point = if point.distance(hit) <= 1e-3 * size { point } else { hit };
        let normal = if gradient == DVec3::ZERO { DVec3::X } else { -gradient };
        LocalSurface::plain(point, error + gamma(64) * size, normal)
    }
}
