//! Constructive solid geometry: which crossings survive, and what is inside.
//!
//! A crossing survives a merge if it is in no other child, an intersection if it is in every other
//! child, and clips if it is in all of them; this is decided at the crossing's own point by each
//! child's inside test, never by sorting intervals, as POV-Ray does (shape facts, section 10.2).
//!
//! Asking the others costs more than finding a crossing. So only a crossing nearer than the nearest
//! survivor so far is asked about, and nothing behind that survivor is looked at.

use super::Geometry;
use super::graph::{Node, NodeKind, Operation, RayMask};
use super::record::RayKind;
use super::shape::{Primitive as _, Shape, ShapeHit, ShapeHits};
use super::slab::SlabRay;
use super::span::Confines;
use super::walk::LastShadow;
use crate::compiled::handle::{NodeId, PrimitiveId};
use crate::math::{DVec3, Range, Ray, gamma};

/// A crossing of a solid's part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) t: f64,
    pub(crate) primitive: PrimitiveId,
    pub(crate) part: u32,
    /// The node of the primitive.
    node: NodeId,
    /// Its place among the crossings that the primitive recorded.
    rank: u32,
}

/// Per-thread buffers, so that no ray allocates, and what is likely to hold again. The latter changes no answer.
#[derive(Debug, Default)]
pub struct Scratch {
    hits: ShapeHits,
    /// For each light, what the last ray to it met: neighbouring points often share it.
    pub(super) shadows: Vec<LastShadow>,
    /// Stretches of the ray that lie inside of parts of merges.
    covers: Vec<Cover>,
    /// A node and the position of its child that last removed a crossing of another.
    remover: (NodeId, usize),
}

/// A stretch of a ray on which a part of a merge hides the others.
#[derive(Clone, Copy, Debug)]
struct Cover {
    merge: NodeId,
    /// The child of the merge.
    node: NodeId,
    low: f64,
    high: f64,
}

impl Cover {
    /// The ends of a stretch are left to inside tests: this part of its largest parameter is far beyond their rounding.
    const MARGIN: f64 = 1e-9;

    fn new(merge: NodeId, node: NodeId, (a, b): (f64, f64)) -> Self {
        let margin = Self::MARGIN * a.abs().max(b.abs());
        Self { merge, node, low: a.min(b) + margin, high: a.max(b) - margin }
    }
}

impl Scratch {
    /// Notes whether something that lets light through was the first in the way to a light.
    pub fn note_filtered(&mut self, light: usize, is_filtered: bool) {
        self.shadows[light].is_filtered = is_filtered;
    }
}

/// A search for the nearest crossing of a solid that survives.
struct Search<'a> {
    geometry: &'a Geometry,
    ray: &'a SlabRay<'a>,
    kind: RayKind,
    /// Any survivor will do.
    any: bool,
    best: Option<Crossing>,
    scratch: &'a mut Scratch,
}

impl Search<'_> {
    /// Looks through a node's crossings in a range, if the ray meets the node's box, where that is asked.
    fn node(&mut self, id: NodeId, range: Range, asks_box: bool) {
        let geometry = self.geometry;
        let node = &geometry.nodes[id];
        let range = Range { max: range.max.min(self.end()), ..range };
        if asks_box && !self.ray.may_meet(&node.bounds, range) || !self.passes_bounds(node) {
            return;
        }
        // Only what is inside of all clips is left in the end.
        let range = node.clips.iter().fold(range, |range, clip| geometry.span(*clip, self.ray, range));
        if range.is_empty() {
            return;
        }
        match &node.kind {
            NodeKind::Primitive(primitive) => self.primitive(id, *primitive, range),
            NodeKind::Csg { operation, children, parts, confining, .. } => {
                let mut confines = Confines::new(range);
                for i in confining {
                    confines.confine(*i, geometry.span(children[*i as usize], self.ray, range));
                }
                if confines.leaves_nothing() {
                    return;
                }
                let ray = self.ray.ray;
                let mut child = |i: u32| {
                    let child = children[i as usize];
                    if let Some(range) = confines.left_to(i)
                        && !geometry.hides(*operation, child, self.kind)
                    {
                        self.node(child, range, parts.is_none() && !geometry.is_quick(child));
                    }
                    self.end()
                };
                match parts {
                    Some(parts) => parts.visit_met(ray, range, child),
                    None => (0..children.len() as u32).for_each(|i| _ = child(i)),
                }
            }
        }
    }

    /// Where the search ends: just behind what is as near as the nearest survivor so far.
    fn end(&self) -> f64 {
        match &self.best {
            Some(_) if self.any => f64::NEG_INFINITY,
            Some(best) => best.t.next_up(),
            None => f64::INFINITY,
        }
    }

    /// Looks through the crossings of one primitive.
    fn primitive(&mut self, node: NodeId, id: PrimitiveId, range: Range) {
        let primitive = &self.geometry.primitives[id];
        // A part that hides what is inside of it is worth knowing from end to end.
        let merge = self.merge_hidden_by(node).filter(|_| primitive.shape.is_convex() && !primitive.inverse);
        let sought = if merge.is_some() { Range::LINE } else { range };
        let hits = &mut self.scratch.hits;
        hits.clear();
        match &primitive.group_from_local {
            Some(place) => primitive.shape.crossings(&place.inverse_ray(self.ray.ray), sought, hits),
            None => primitive.shape.crossings(self.ray.ray, sought, hits),
        }
        if let Some(merge) = merge
            && let [a, b] = hits[..]
        {
            self.scratch.covers.push(Cover::new(merge, node, (a.t, b.t)));
        }
        for rank in 0..self.scratch.hits.len() {
            let hit = self.scratch.hits[rank];
            if !range.contains(hit.t) {
                continue;
            }
            let crossing = Crossing { t: hit.t, primitive: id, part: hit.part, node, rank: rank as u32 };
            let is_nearer = self.best.is_none_or(|best| {
                crossing.t < best.t || crossing.t == best.t && self.geometry.counts_before(&crossing, &best)
            });
            if is_nearer && !self.is_covered(&crossing) && self.survives(&crossing) {
                self.best = Some(crossing);
            }
        }
    }

    /// The merge whose other children a node hides wherever it is solid.
    fn merge_hidden_by(&self, node: NodeId) -> Option<NodeId> {
        let nodes = &self.geometry.nodes;
        let node = &nodes[node];
        let parent = node.parent.filter(|_| node.clips.is_empty())?.node;
        let is_merge = |n: &Node| matches!(&n.kind, NodeKind::Csg { operation: Operation::Merge, .. });
        is_merge(&nodes[parent]).then_some(parent)
    }

    /// Whether another part of the same merge is known to hide a crossing.
    fn is_covered(&self, crossing: &Crossing) -> bool {
        let Some(parent) = self.geometry.nodes[crossing.node].parent else { return false };
        let t = crossing.t;
        self.scratch.covers.iter().any(|c| c.merge == parent.node && c.node != crossing.node && c.low < t && t < c.high)
    }

    /// Whether a crossing is left by everything around its primitive.
    fn survives(&mut self, crossing: &Crossing) -> bool {
        let geometry = self.geometry;
        let point = self.ray.ray.at(crossing.t);
        let mut node = &geometry.nodes[crossing.node];
        loop {
            if !node.clips.iter().all(|clip| geometry.node_contains(*clip, point)) {
                return false;
            }
            let Some(parent) = node.parent else { return true };
            if !self.is_left_by_others(parent.node, parent.position as usize, crossing, point) {
                return false;
            }
            node = &geometry.nodes[parent.node];
        }
    }

    /// Whether the other children of a node leave a crossing of the child at `position`.
    fn is_left_by_others(&mut self, id: NodeId, position: usize, crossing: &Crossing, point: DVec3) -> bool {
        let geometry = self.geometry;
        let NodeKind::Csg { operation, children, parts, .. } = &geometry.nodes[id].kind else {
            return true;
        };
        if *operation == Operation::Union {
            return true;
        }
        let mut remover = None;
        let mut leaves = |other: usize| {
            let leaves = other == position
                || geometry.leaves(*operation, children[other], point, self.kind)
                || self.share_a_face(children[position], children[other], crossing);
            if !leaves {
                remover = Some(other);
            }
            leaves
        };
        // Neighbouring crossings often lie in the same part.
        let (node, last) = self.scratch.remover;
        let is_left = (node != id || last >= children.len() || leaves(last))
            && match parts {
                Some(parts) => parts.all_at(point, leaves),
                None => (0..children.len()).all(leaves),
            };
        if let Some(remover) = remover {
            self.scratch.remover = (id, remover);
        }
        is_left
    }

    /// Whether the ray enters two children, or leaves them, at the same place, as far as numbers tell: there rounding
    /// would decide whether one is inside of the other, and leave holes where both have the same face.
    ///
    /// Not for faces along the axes: their coordinates are exact, and POV-Ray's rule is for all rays the same.
    fn share_a_face(&self, child: NodeId, other: NodeId, crossing: &Crossing) -> bool {
        /// What a crossing may be off by, about, as a part of the coordinates that go into it.
        const ROUNDING: f64 = gamma(8);
        let primitive = &self.geometry.primitives[crossing.primitive];
        let is_flat = matches!(primitive.shape, Shape::Cuboid(_) | Shape::Plane(_));
        if is_flat && primitive.group_from_local.is_none() {
            return false;
        }
        let (Ray { origin, direction }, t) = (self.ray.ray, crossing.t);
        let reach = (origin.abs() + (*direction * t).abs()).max_element();
        let off = ROUNDING * reach / direction.abs().max_element();
        let ends = [t - off, t + off].map(|t| self.ray.ray.at(t));
        let [before, behind] = ends.map(|end| self.geometry.node_contains(other, end));
        before != behind && ends.map(|end| self.geometry.node_contains(child, end)) == [before, behind]
    }

    /// Whether the ray meets, or starts in, everything that bounds the node.
    fn passes_bounds(&mut self, node: &Node) -> bool {
        node.bounded_by.iter().all(|bound| {
            self.geometry.node_contains(*bound, self.ray.ray.origin) || {
                let kind = RayKind::Refracted;
                let mut search = Search { kind, any: true, best: None, scratch: self.scratch, ..*self };
                search.node(*bound, Range::FORWARD, !self.geometry.is_quick(*bound));
                search.best.is_some()
            }
        })
    }
}

impl Geometry {
    /// The nearest surviving crossing of a solid, or any, with its primitive.
    pub(super) fn solid_nearest(
        &self,
        root: NodeId,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        any: bool,
        scratch: &mut Scratch,
    ) -> Option<(ShapeHit, PrimitiveId)> {
        let (node, ray) = (&self.nodes[root], &SlabRay::new(ray));
        if !node.convex_parts.is_empty() {
            if !ray.may_meet(&node.bounds, range) {
                return None;
            }
            if let Ok(nearest) = self.nearest_of_convex_parts(&node.convex_parts, ray.ray, range, &mut scratch.hits) {
                return nearest;
            }
        }
        scratch.covers.clear();
        let mut search = Search { geometry: self, ray, kind, any, best: None, scratch };
        // What a file says about bounds is about whole objects.
        search.node(root, range, true);
        search.best.map(|Crossing { t, primitive, part, .. }| (ShapeHit { t, part }, primitive))
    }

    /// Whether the first of two equally near crossings of a solid is seen.
    ///
    /// POV-Ray shows the one recorded last. A node records its children in their order, but whatever filters
    /// (merge, intersection, a node with clips) takes what each child delivers from the end (shape facts, section 13).
    #[cold]
    fn counts_before(&self, a: &Crossing, b: &Crossing) -> bool {
        let (mut nodes, mut positions) = ([a.node, b.node], [a.rank, b.rank]);
        // What is further in has the higher number.
        while nodes[0] != nodes[1] {
            let inner = usize::from(nodes[1] > nodes[0]);
            let Some(parent) = self.nodes[nodes[inner]].parent else { break };
            (nodes[inner], positions[inner]) = (parent.node, parent.position);
        }
        let is_later = positions[0] > positions[1];
        is_later != self.nodes[nodes[0]].is_reversed
    }

    /// Whether a node is found as soon as its box, which holds all of the shape.
    fn is_quick(&self, node: NodeId) -> bool {
        let node = &self.nodes[node];
        match &node.kind {
            NodeKind::Primitive(p) if node.is_bare() => {
                let primitive = &self.primitives[*p];
                primitive.group_from_local.is_none() && primitive.shape.is_quick()
            }
            _ => false,
        }
    }

    /// Whether another child leaves a crossing at `point`.
    fn leaves(&self, operation: Operation, other: NodeId, point: DVec3, kind: RayKind) -> bool {
        match operation {
            Operation::Union => true,
            Operation::Merge => self.hides(operation, other, kind) || !self.node_contains(other, point),
            Operation::Intersection => self.node_contains(other, point),
        }
    }

    /// Whether a part passes by unseen: POV-Ray honours a part's own flags only in some
    /// operations and for some rays (shape facts, section 12.3).
    fn hides(&self, operation: Operation, child: NodeId, kind: RayKind) -> bool {
        let honoured = match (operation, kind) {
            (Operation::Intersection, _)
            | (_, RayKind::Shadow | RayKind::Probe)
            | (Operation::Union, RayKind::Camera) => false,
            (Operation::Union | Operation::Merge, _) => true,
        };
        honoured && self.nodes[child].hidden_from.intersects(RayMask::of(kind))
    }

    /// Whether a point is inside a node and all its clips.
    pub(super) fn node_contains(&self, id: NodeId, point: DVec3) -> bool {
        let node = &self.nodes[id];
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
    pub(super) fn primitive_contains(&self, id: PrimitiveId, point: DVec3) -> bool {
        let primitive = &self.primitives[id];
        let local = primitive.group_from_local.as_ref().map_or(point, |place| place.inverse_point(point));
        if primitive.inverse { primitive.shape.excludes(local) } else { primitive.shape.contains(local) }
    }
}
