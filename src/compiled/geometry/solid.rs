//! Constructive solid geometry: which crossings survive, and what is inside.
//!
//! A node hands up all its crossings within a range. A crossing survives a merge if it is in no
//! other child, an intersection if it is in every other child, and clips if it is in all of
//! them; this is decided at the crossing's own point by each child's inside test, never by
//! sorting intervals, as POV-Ray does (shape facts, section 10.2).

use super::Geometry;
use super::graph::{Item, Node, NodeKind, Operation, Skips};
use super::record::RayKind;
use super::shape::{Primitive as _, ShapeHits};
use super::slab::SlabRay;
use super::span::Confines;
use crate::math::{DVec3, Range, Ray};

/// A crossing on its way up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) t: f64,
    pub(crate) primitive: u32,
    pub(crate) part: u32,
}

/// Per-thread buffers, so that no ray allocates.
#[derive(Debug, Default)]
pub struct Scratch {
    crossings: Vec<Crossing>,
    hits: ShapeHits,
    /// For each light, what last stood in its way: neighbouring points often share it. Finding it
    /// again first saves the way through the hierarchy and changes no answer.
    pub(super) blockers: Vec<Option<Item>>,
}

impl Geometry {
    /// The nearest surviving crossing of a solid; of equal ones the last recorded.
    pub(super) fn solid_nearest(
        &self,
        root: u32,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        scratch: &mut Scratch,
    ) -> Option<Crossing> {
        scratch.crossings.clear();
        self.crossings(root, &SlabRay::new(ray), range, kind, true, scratch);
        scratch.crossings.iter().copied().reduce(|best, c| if c.t <= best.t { c } else { best })
    }

    /// Appends what survives of a node's crossings, in the order in which POV-Ray records them.
    fn crossings(
        &self,
        index: u32,
        ray: &SlabRay<'_>,
        range: Range,
        kind: RayKind,
        is_root: bool,
        scratch: &mut Scratch,
    ) {
        let node = &self.nodes[index as usize];
        // What a file says about bounds is about whole objects.
        let may_meet = !is_root && self.is_quick(node) || ray.may_meet(&node.bounds, range);
        if !may_meet || !self.passes_bounds(node, ray, scratch) {
            return;
        }
        // Only what is inside of all clips is left in the end.
        let range = node.clips.iter().fold(range, |range, clip| self.span(*clip, ray, range));
        if range.is_empty() {
            return;
        }
        let start = scratch.crossings.len();
        let mut reverses = !node.clips.is_empty();
        match &node.kind {
            NodeKind::Primitive(p) => self.primitive_crossings(*p, ray.ray, range, scratch),
            NodeKind::Csg { operation, children, parts, confining, .. } => {
                reverses |= *operation != Operation::Union;
                let mut confines = Confines::new(range);
                for i in confining {
                    confines.confine(*i, self.span(children[*i as usize], ray, range));
                }
                if confines.leaves_nothing() {
                    return;
                }
                let mut child = |i: u32| {
                    if let Some(range) = confines.left_to(i) {
                        self.child_crossings(node, i as usize, ray, range, kind, scratch);
                    }
                };
                match parts {
                    Some(parts) => parts.met_by(ray.ray, range).iter().for_each(|i| child(*i)),
                    None => (0..children.len() as u32).for_each(child),
                }
            }
        }
        if !node.clips.is_empty() {
            let point = |c: &Crossing| ray.ray.at(c.t);
            retain(&mut scratch.crossings, start, |c| node.clips.iter().all(|n| self.node_contains(*n, point(c))));
        }
        if reverses && !(is_root && scratch.crossings.len() < 2) {
            scratch.crossings[start..].reverse();
        }
    }

    /// Whether a node is found as soon as its box, which holds all of the shape.
    fn is_quick(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::Primitive(p) if node.clips.is_empty() && node.bounded_by.is_empty() => {
                let primitive = &self.primitives[*p as usize];
                primitive.group_from_local.is_none() && primitive.shape.is_quick()
            }
            _ => false,
        }
    }

    /// Appends what a node's operation leaves of the crossings of one child.
    fn child_crossings(
        &self,
        node: &Node,
        i: usize,
        ray: &SlabRay<'_>,
        range: Range,
        kind: RayKind,
        scratch: &mut Scratch,
    ) {
        let NodeKind::Csg { operation, children, parts, .. } = &node.kind else { return };
        if self.hides(*operation, children[i], kind) {
            return;
        }
        let first = scratch.crossings.len();
        self.crossings(children[i], ray, range, kind, false, scratch);
        if *operation == Operation::Union {
            return;
        }
        retain(&mut scratch.crossings, first, |c| {
            let point = ray.ray.at(c.t);
            let leaves = |other: usize| other == i || self.leaves(*operation, children[other], point, kind);
            match parts {
                Some(parts) => parts.all_at(point, leaves),
                None => (0..children.len()).all(leaves),
            }
        });
    }

    /// Crossings of one primitive.
    fn primitive_crossings(&self, index: u32, ray: &Ray, range: Range, scratch: &mut Scratch) {
        let primitive = &self.primitives[index as usize];
        scratch.hits.clear();
        match &primitive.group_from_local {
            Some(place) => primitive.shape.crossings(&place.inverse_ray(ray), range, &mut scratch.hits),
            None => primitive.shape.crossings(ray, range, &mut scratch.hits),
        }
        let Scratch { crossings, hits, .. } = scratch;
        crossings.extend(hits.iter().map(|h| Crossing { t: h.t, primitive: index, part: h.part }));
    }

    /// Whether another child leaves a crossing at `point`.
    fn leaves(&self, operation: Operation, other: u32, point: DVec3, kind: RayKind) -> bool {
        match operation {
            Operation::Union => true,
            Operation::Merge => self.hides(operation, other, kind) || !self.node_contains(other, point),
            Operation::Intersection => self.node_contains(other, point),
        }
    }

    /// Whether a part passes by unseen: POV-Ray honours a part's own flags only in some
    /// operations and for some rays (shape facts, section 12.3).
    fn hides(&self, operation: Operation, child: u32, kind: RayKind) -> bool {
        let honoured = match (operation, kind) {
            (Operation::Intersection, _)
            | (_, RayKind::Shadow | RayKind::Probe)
            | (Operation::Union, RayKind::Camera) => false,
            (Operation::Union | Operation::Merge, _) => true,
        };
        honoured && self.nodes[child as usize].skips.meets(Skips::of(kind))
    }

    /// Whether the ray meets, or starts in, everything that bounds the node.
    fn passes_bounds(&self, node: &Node, ray: &SlabRay<'_>, scratch: &mut Scratch) -> bool {
        node.bounded_by.iter().all(|bound| {
            let start = scratch.crossings.len();
            let meets = self.node_contains(*bound, ray.ray.origin) || {
                self.crossings(*bound, ray, Range::FORWARD, RayKind::Refracted, false, scratch);
                scratch.crossings.len() > start
            };
            scratch.crossings.truncate(start);
            meets
        })
    }

    /// Whether a point is inside a node and all its clips.
    pub(super) fn node_contains(&self, index: u32, point: DVec3) -> bool {
        let node = &self.nodes[index as usize];
        if !node.extent.contains(point) {
            return false;
        }
        if !node.gap.contains(point) {
            return true;
        }
        let inside = match &node.kind {
            NodeKind::Primitive(p) => self.primitive_contains(*p, point),
            NodeKind::Csg { operation, children, parts, .. } => {
                // Inside all, or not outside all.
                let all = *operation == Operation::Intersection;
                let same = |i: usize| self.node_contains(children[i], point) == all;
                all == match parts {
                    Some(parts) => parts.all_at(point, same),
                    None => (0..children.len()).all(same),
                }
            }
        };
        inside && node.clips.iter().all(|n| self.node_contains(*n, point))
    }

    /// Whether a point is inside a primitive, as inverted.
    pub(super) fn primitive_contains(&self, index: u32, point: DVec3) -> bool {
        let primitive = &self.primitives[index as usize];
        let local = primitive.group_from_local.as_ref().map_or(point, |place| place.inverse_point(point));
        if primitive.inverse { primitive.shape.excludes(local) } else { primitive.shape.contains(local) }
    }
}

/// Keeps what passes, from `first` on.
fn retain(crossings: &mut Vec<Crossing>, first: usize, mut keep: impl FnMut(&Crossing) -> bool) {
    let mut kept = first;
    for i in first..crossings.len() {
        if keep(&crossings[i]) {
            crossings[kept] = crossings[i];
            kept += 1;
        }
    }
    crossings.truncate(kept);
}
