//! Bumps: perturbations of the surface normal.
//!
//! Space: a normal statement works in the space of its pattern. `L` is the linear part of
//! the map from pattern space to the containing space; the normal goes in by `L` transposed and
//! comes out by its inverse, normalised on both ways unless `no_bump_scale` is set.
//! Source: pattern facts, section 14 (measured).

use super::crackle::{Metric, nearest};
use super::{Blend, Context, Mapping, Pattern, Pick, Raster};
use crate::math::noise::vector_noise;
use crate::math::{DMat3, DVec3, LANES, Points, Transform};
use std::sync::Arc;

/// A perturbation of the normal.
#[derive(Clone, Debug)]
pub struct Normal {
    /// How it arises.
    pub kind: NormalKind,
    /// Its strength.
    pub amount: f64,
    /// Sampling distance for slopes of patterns.
    pub accuracy: f64,
    /// Bumps keep their depth when the pattern is scaled.
    pub no_bump_scale: bool,
    /// Linear part of the map from the containing space to the pattern's.
    pub pattern_from_outer: DMat3,
}

/// The sorts of perturbation.
#[derive(Clone, Debug)]
pub enum NormalKind {
    /// A pattern's native displacement or its slope, through an optional slope map.
    Pattern(Pattern, Option<Blend<SlopeEntry>>),
    /// A choice or mixture of others.
    Normals(Pattern, Blend<Arc<Normal>>),
    /// Heights in a picture.
    BumpMap(Pattern, Arc<Raster>, Mapping),
    /// Flat facets, in the space of normals or of points.
    Facets(Pattern, Facets),
    /// Everything inside is looked up at (u, v, 0).
    Uv(Box<Normal>),
}

/// How a surface is broken into facets.
#[derive(Clone, Copy, Debug)]
pub struct Facets {
    /// Strength where facets lie in space; 0 where they lie among the normals.
    pub coords: f64,
    /// Size of a facet.
    pub size: f64,
    /// Exponent of the metric of cells.
    pub metric: f64,
}

impl Facets {
    fn bend(&self, n: DVec3, p: DVec3) -> DVec3 {
        let metric = if self.metric == 1.0 { Metric::SignedSum } else { Metric::Power(self.metric) };
        if self.coords == 0.0 {
            return nearest(n / self.size, metric);
        }
        let push = vector_noise(nearest(p / self.size, metric));
        n + self.coords * (push - push.dot(n) * n)
    }
}

/// Height and slope where a slope map has an entry.
pub type SlopeEntry = [f64; 2];

/// The four sampling directions of a slope: corners of a regular tetrahedron.
const SAMPLES: [DVec3; LANES] = [
    DVec3::new(0.942_809_041, -0.333_333_333, 0.0),
    DVec3::new(-0.471_404_521, -0.333_333_333, 0.816_496_581),
    DVec3::new(-0.471_404_521, -0.333_333_333, -0.816_496_581),
    DVec3::Y,
];

/// The spaces between the world and a normal statement, outermost first.
#[derive(Clone, Debug, Default)]
pub struct Frame<'o> {
    /// `inner_from_outer` linear maps of enclosing patterned textures, and whether to skip normalising.
    steps: smallvec::SmallVec<[(DMat3, bool); 4]>,
    /// What the next statement's own map is composed with: the object's transformation.
    pending: Option<&'o Transform>,
}

impl<'o> Frame<'o> {
    /// At the outermost texture of an object.
    pub fn new(texture_from_world: Option<&'o Transform>) -> Self {
        Self { steps: smallvec::SmallVec::new(), pending: texture_from_world }
    }

    /// For items of a patterned texture.
    pub fn enter(&mut self, pattern: &Pattern, no_bump_scale: bool) {
        let linear = self.compose(pattern.linear());
        self.pending = None;
        self.steps.push((linear, no_bump_scale));
    }

    fn compose(&self, inner: DMat3) -> DMat3 {
        self.pending.map_or(inner, |outer| inner * outer.linear())
    }
}

impl Pattern {
    /// Linear part of all affine warps: containing space to pattern space.
    pub fn linear(&self) -> DMat3 {
        self.warps.iter().filter_map(super::Warp::linear).fold(DMat3::IDENTITY, |m, linear| linear * m)
    }
}

/// Into a space: by the transpose of its `outer_from_inner` map, which is the inverse of ours.
fn inward(n: DVec3, inner_from_outer: DMat3, keep_length: bool) -> DVec3 {
    // Most statements do not move; the inverse of the identity is the identity.
    let m = if inner_from_outer == DMat3::IDENTITY { n } else { inner_from_outer.inverse().transpose() * n };
    if keep_length { m } else { m.normalize_or(n) }
}

/// Out of a space: by the inverse transpose of `outer_from_inner`.
fn outward(n: DVec3, inner_from_outer: DMat3, keep_length: bool) -> DVec3 {
    let m = inner_from_outer.transpose() * n;
    if keep_length { m } else { m.normalize_or(n) }
}

/// What a normal statement makes of a normal.
#[derive(Clone, Copy, Debug)]
pub struct Bent {
    /// World space, for shading; a unit vector but where enclosing textures keep the depth of bumps.
    pub normal: DVec3,
    /// What slope and aoi take for the normal from now on: still in the space of the innermost texture.
    pub inner: DVec3,
}

impl Normal {
    /// The perturbed normal.
    ///
    /// `point` lies in the space that contains the statement, `normal` is a unit world vector.
    pub fn perturb(&self, normal: DVec3, point: DVec3, frame: &Frame<'_>, context: &Context) -> Bent {
        let mut n = normal;
        for (linear, keep_length) in &frame.steps {
            n = inward(n, *linear, *keep_length);
        }
        let own = frame.compose(self.pattern_from_outer);
        let bent = self.apply(n, point, own, context);
        let inner = if bent.is_finite() { bent } else { n };
        n = inner.normalize_or(n);
        for (linear, keep_length) in frame.steps.iter().rev() {
            n = outward(n, *linear, *keep_length);
        }
        // A patterned texture's own `no_bump_scale` leaves the length as it is, as in POV-Ray.
        let normal = if frame.steps.first().is_some_and(|s| s.1) { n } else { n.normalize_or(normal) };
        Bent { normal, inner }
    }

    /// Lets bumps keep their depth when they are scaled.
    pub fn keep_bump_depth(&mut self) {
        // POV-Ray's facets do not heed it.
        self.no_bump_scale = !matches!(self.kind, NormalKind::Facets(..));
        match &mut self.kind {
            NormalKind::Normals(_, normals) => {
                normals.iter_mut().for_each(|normal| Arc::make_mut(normal).keep_bump_depth());
            }
            NormalKind::Uv(inner) => inner.keep_bump_depth(),
            NormalKind::Pattern(..) | NormalKind::BumpMap(..) | NormalKind::Facets(..) => {}
        }
    }

    /// In and out of one statement's space.
    fn apply(&self, outer: DVec3, point: DVec3, own: DMat3, context: &Context) -> DVec3 {
        let local = inward(outer, own, self.no_bump_scale);
        let bent = self.bend(local, point, context);
        outward(bent, own, self.no_bump_scale)
    }

    fn bend(&self, n: DVec3, point: DVec3, context: &Context) -> DVec3 {
        match &self.kind {
            NormalKind::Pattern(pattern, slopes) => {
                let p = pattern.warp(point);
                match pattern.bump(p) {
                    Some(displacement) => n + self.amount * displacement,
                    None => n - self.slope(pattern, slopes.as_ref(), p, context),
                }
            }
            NormalKind::Normals(pattern, normals) => {
                let (pick, p) = pattern.pick(normals, point, context);
                let of = |normal: &Self| normal.apply(n, p, normal.pattern_from_outer, context);
                match pick {
                    Pick::One(normal) => of(normal),
                    Pick::Two(lower, upper, share) => of(lower).lerp(of(upper), f64::from(share)),
                    Pick::All(all) => all.iter().map(|(w, normal)| f64::from(*w) * of(normal)).sum(),
                }
            }
            NormalKind::BumpMap(pattern, image, mapping) => image.bump(mapping, pattern.warp(point), n, self.amount),
            NormalKind::Facets(pattern, facets) => facets.bend(n, pattern.warp(point)),
            NormalKind::Uv(inner) => inner.apply(n, context.uv_point(), inner.pattern_from_outer, context),
        }
    }

    /// Weighted sum of values around the point: two fifteenths of the gradient for smooth patterns.
    fn slope(&self, pattern: &Pattern, slopes: Option<&Blend<SlopeEntry>>, p: DVec3, context: &Context) -> DVec3 {
        let [a, b, c, d] = SAMPLES;
        let at = |e: DVec3| p + self.accuracy * e;
        let samples = Points::from([at(a), at(b), at(c), at(d)]);
        let values = if pattern.kind.sees_normals() {
            samples.map(|p| pattern.value_at_warped(p, context))
        } else {
            pattern.values_at_warped(&samples, &[context.uv; LANES])
        };
        let height = |value: f64| slopes.map_or(value, |map| slope_height(map, value));
        let sum: DVec3 = values.iter().zip(SAMPLES).map(|(value, e)| height(*value) * e).sum();
        5.0 * self.amount * (0.02 / self.accuracy) * sum
    }
}

/// Cubic between entries, by heights and slopes.
fn slope_height(map: &Blend<SlopeEntry>, value: f64) -> f64 {
    match map.pick(value) {
        Pick::One(entry) => entry[0],
        Pick::Two(a, b, t) => {
            let t = f64::from(t);
            let (t2, t3) = (t * t, t * t * t);
            a[0] * (2.0 * t3 - 3.0 * t2 + 1.0)
                + a[1] * (t3 - 2.0 * t2 + t)
                + b[0] * (3.0 * t2 - 2.0 * t3)
                + b[1] * (t3 - t2)
        }
        Pick::All(_) => value,
    }
}

#[cfg(test)]
mod tests {
    use super::super::PatternKind;
    use super::*;

    /// Section 14 of the pattern facts: geometric normal +y.
    fn check(kind: PatternKind, amount: f64, slopes: Option<Blend<SlopeEntry>>, points: &[([f64; 3], [f64; 3])]) {
        let pattern = Pattern::of(kind);
        let normal = Normal {
            kind: NormalKind::Pattern(pattern, slopes),
            amount,
            accuracy: 0.02,
            no_bump_scale: false,
            pattern_from_outer: DMat3::IDENTITY,
        };
        for (p, expected) in points {
            let found = normal.perturb(DVec3::Y, DVec3::from(*p), &Frame::default(), &Context::default()).normal;
            assert!((found - DVec3::from(*expected)).abs().max_element() < 2e-5, "{found} {expected:?}");
        }
    }

    #[test]
    fn slopes_are_those_of_povray() {
        let onion =
            [([0.3, 0.7, -1.2], [-0.01776, 0.99736, 0.07039]), ([0.125, -0.25, 0.5], [-0.01719, 0.99759, -0.06721])];
        check(PatternKind::Onion, 0.6, None, &onion);
        let map = Blend::map([(0.0, [0.0, 1.0]), (0.4, [0.7, -0.5]), (0.8, [0.2, 0.0])]);
        let gradient = [([0.3, 0.7, -1.2], [-0.05783, 0.99833, 0.0]), ([0.125, -0.25, 0.5], [-0.18110, 0.98346, 0.0])];
        check(PatternKind::Gradient(DVec3::X), 0.5, Some(map), &gradient);
    }
}
