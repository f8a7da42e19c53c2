//! Where along a ray a part of a solid can contain a point.
//!
//! Crossings of one child of an intersection survive only where all other children contain them. Stretches outside
//! of which a child contains nothing are found for less than its crossings, and what does not lie in all of them need
//! not be looked for.

use super::Geometry;
use super::graph::{NodeKind, Operation};
use super::shape::Primitive as _;
use super::slab::SlabRay;
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

impl Geometry {
    /// The part of a range outside of which a node contains no point of the ray; errs on the side of more.
    pub(super) fn span(&self, index: u32, ray: &SlabRay<'_>, range: Range) -> Range {
        let node = &self.nodes[index as usize];
        match &node.kind {
            // The shape knows better than its box.
            NodeKind::Primitive(p) if self.has_span(*p) => self.primitives[*p as usize].shape.span(ray.ray, range),
            NodeKind::Csg { operation: Operation::Intersection, children, confining, .. } => {
                let mut range = ray.within(&node.extent, range);
                for i in confining {
                    if range.is_empty() {
                        break;
                    }
                    range = self.span(children[*i as usize], ray, range);
                }
                range
            }
            _ => ray.within(&node.extent, range),
        }
    }

    /// Whether a primitive's own shape says where it contains points.
    fn has_span(&self, primitive: u32) -> bool {
        let primitive = &self.primitives[primitive as usize];
        primitive.shape.has_span() && !primitive.inverse && primitive.group_from_local.is_none()
    }

    /// Whether [`span`](Self::span) may be less than the whole range.
    pub(crate) fn confines(&self, index: u32) -> bool {
        let node = &self.nodes[index as usize];
        let of_kind = || match &node.kind {
            NodeKind::Primitive(p) => self.has_span(*p),
            NodeKind::Csg { confining, .. } => !confining.is_empty(),
        };
        node.extent != Bounds::INFINITE || of_kind()
    }
}
