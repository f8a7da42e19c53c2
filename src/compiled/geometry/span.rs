//! Where along a ray a part of a solid can contain a point.
//!
//! Crossings of one child of an intersection survive only where all other children contain them. Stretches outside
//! of which a child contains nothing are found for less than its crossings, and what does not lie in all of them need
//! not be looked for.

use super::Geometry;
use super::graph::{NodeKind, Operation};
use super::shape::Primitive as _;
use super::slab::SlabRay;
use crate::compiled::handle::{NodeId, PrimitiveId};
use crate::math::{Bounds, Range};

/// What children of an intersection leave to each other of a range: the highest lower ends and the lowest upper ends
/// of their stretches, with the children that set them.
pub(super) struct Confines {
    low: [(f64, u32); 2],
    high: [(f64, u32); 2],
}

impl Confines {
    /// A range that nobody confines.
    pub(super) fn new(range: Range) -> Self {
        Self { low: [(range.min, u32::MAX); 2], high: [(range.max, u32::MAX); 2] }
    }

    /// Takes in the stretch of a child.
    pub(super) fn confine(&mut self, child: u32, Range { min, max }: Range) {
        if min > self.low[0].0 {
            self.low = [(min, child), self.low[0]];
        } else if min > self.low[1].0 {
            self.low[1] = (min, child);
        }
        if max < self.high[0].0 {
            self.high = [(max, child), self.high[0]];
        } else if max < self.high[1].0 {
            self.high[1] = (max, child);
        }
    }

    /// Whether nothing is left to anybody.
    pub(super) fn leaves_nothing(&self) -> bool {
        self.low[1].0 > self.high[1].0
    }

    /// What the others leave to a child; `None` for nothing.
    pub(super) fn left_to(&self, child: u32) -> Option<Range> {
        let min = self.low[usize::from(self.low[0].1 == child)].0;
        let max = self.high[usize::from(self.high[0].1 == child)].0;
        (min <= max).then_some(Range { min, max })
    }
}

/// How far down a solid is looked for stretches: whoever asks does so again at every level, and what lies deeper is
/// within the box of what lies above it.
const LEVELS: u32 = 4;

impl Geometry {
    /// The part of a range outside of which a node contains no point of the ray; errs on the side of more.
    pub(super) fn span(&self, id: NodeId, ray: &SlabRay<'_>, range: Range) -> Range {
        self.span_of(id, ray, range, LEVELS)
    }

    fn span_of(&self, id: NodeId, ray: &SlabRay<'_>, range: Range, levels: u32) -> Range {
        let node = &self.nodes[id];
        match &node.kind {
            // The shape knows better than its box.
            NodeKind::Primitive(p) if self.has_span(*p) => {
                let primitive = &self.primitives[*p];
                match &primitive.group_from_local {
                    Some(place) => primitive.shape.span(&place.inverse_ray(ray.ray), range),
                    None => primitive.shape.span(ray.ray, range),
                }
            }
            NodeKind::Csg { operation: Operation::Intersection, children, confining, .. } if levels > 0 => {
                let mut range = ray.within(&node.extent, range);
                for i in confining {
                    if range.is_empty() {
                        break;
                    }
                    range = self.span_of(children[*i as usize], ray, range, levels - 1);
                }
                range
            }
            _ => ray.within(&node.extent, range),
        }
    }

    /// Whether a primitive's own shape says where it contains points.
    fn has_span(&self, primitive: PrimitiveId) -> bool {
        let primitive = &self.primitives[primitive];
        primitive.shape.has_span() && !primitive.inverse
    }

    /// Whether [`span`](Self::span) may be less than the whole range.
    pub(crate) fn confines(&self, id: NodeId) -> bool {
        let node = &self.nodes[id];
        let of_kind = || match &node.kind {
            NodeKind::Primitive(p) => self.has_span(*p),
            NodeKind::Csg { confining, .. } => !confining.is_empty(),
        };
        node.extent != Bounds::INFINITE || of_kind()
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape::{Plane, Primitive, Quadric, Sphere};
    use super::*;
    use crate::math::{DVec3, MersenneTwister, Ray};

    /// Part of a stretch by which it may be too long at either end, and the shortest, in units of the shape, of which that
    /// is well above the slack for rounding.
    const EXCESS: f64 = 1e-4;
    const SHORTEST: f64 = 1e-3;

    /// Sends rays from near and far at a shape of about unit size: no point beside the stretch is inside, and the
    /// stretch is not much longer than it has to be.
    fn check(shape: &impl Primitive) {
        let mut twister = MersenneTwister::default();
        let mut random = || 2.0 * twister.next_f64() - 1.0;
        let (mut confined, mut inside) = (0, 0);
        for i in 0..20_000 {
            let mut vector = || DVec3::new(random(), random(), random());
            let (origin, target) = (vector() * 10f64.powi(i % 9 - 2), vector());
            let ray = Ray::new(origin, (target - origin) * 10f64.powi(i % 5 - 2));
            let span = shape.span(&ray, Range::FORWARD);
            let beside = [span.min.next_down(), span.min * 0.999_999, span.max.next_up(), span.max * 1.000_001];
            for t in beside.into_iter().filter(|t| *t > 0.0 && t.is_finite()) {
                confined += 1;
                assert!(!shape.contains(ray.at(t)), "{ray:?} at {t}, beside {span:?}");
            }
            let length = span.max - span.min;
            // From far away, rounding takes its toll.
            if i % 9 < 4 && length * ray.direction.length() > SHORTEST && length.is_finite() {
                let near_ends = [span.min + EXCESS * length, span.max - EXCESS * length];
                inside += near_ends.into_iter().filter(|t| *t > 0.0 && !shape.contains(ray.at(*t))).count();
            }
        }
        assert!(confined > 5_000 && inside == 0, "{confined} ends, {inside} of them too far away");
    }

    #[test]
    fn nothing_is_inside_beside_its_span() {
        check(&Plane { normal: DVec3::new(0.6, 0.0, 0.8), distance: 0.3 });
        check(&Sphere { center: DVec3::new(0.1, -0.2, 0.3), radius: 0.8 });
        let linear = DVec3::new(0.1, 0.2, -0.1);
        let quadric = |squares: [f64; 3], products: [f64; 3], constant: f64| {
            Quadric::new(squares.into(), products.into(), linear, constant, false)
        };
        check(&quadric([1.0, 2.0, 0.5], [0.0, 0.3, 0.0], -1.0));
        check(&quadric([1.0, 1.0, 0.0], [0.0; 3], -0.5));
    }
}
