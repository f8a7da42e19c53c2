//! Solids that are what a few convex parts have in common, each as it is or turned inside out.
//!
//! A line lies in such a part, or out of it, along one stretch. The ends of the stretches are all crossings, and say which
//! of them survive: no point has to be tested. Where two ends are so near each other that rounding or the thickness of
//! surfaces would decide, the answer is left to the search that tests points.
//!
//! Source: Roth, Ray Casting for Modeling Solids, Computer Graphics and Image Processing 18, 1982.

use super::Geometry;
use super::graph::{Node, NodeKind, Operation, Primitive};
use super::shape::{Primitive as _, Shape, ShapeHit, ShapeHits};
use crate::compiled::handle::{NodeId, PrimitiveId, Table};
use crate::math::{Range, Ray, gamma};
use arrayvec::ArrayVec;

/// Of more parts, a hierarchy finds those that matter.
const MOST_PARTS: usize = 7;

/// Where a line is inside of a convex part.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    primitive: PrimitiveId,
    /// Where it begins and ends; infinite where it does not.
    low: ShapeHit,
    high: ShapeHit,
    /// As far from the ends it is sure what is inside: far beyond rounding, and beyond the thickness of surfaces.
    margin: f64,
    /// The part is what is not in the stretch.
    inverse: bool,
}

impl Stretch {
    /// Whether the part contains what lies at a parameter, if that is sure.
    fn contains(&self, t: f64) -> Option<bool> {
        let Self { low, high, margin, .. } = self;
        if low.t + margin < t && t < high.t - margin {
            Some(!self.inverse)
        } else if t < low.t - margin || high.t + margin < t {
            Some(self.inverse)
        } else {
            None
        }
    }
}

/// What a line has of a convex part.
enum Met {
    Stretch(Stretch),
    Nothing,
    /// Only points can tell.
    Unsure,
}

/// The parts of a solid, if it is one of this kind: those that are not turned inside out first.
pub(crate) fn of_solid(
    root: NodeId,
    nodes: &Table<NodeId, Node>,
    primitives: &Table<PrimitiveId, Primitive>,
) -> Box<[PrimitiveId]> {
    let mut found = ArrayVec::new();
    if matches!(nodes[root].kind, NodeKind::Primitive(_)) || collect(root, nodes, primitives, &mut found).is_none() {
        return Box::default();
    }
    // What is found for less comes first: it may be all that is needed.
    found.sort_by_key(|id| (primitives[*id].inverse, !primitives[*id].shape.is_quick()));
    found.into_iter().collect()
}

fn collect(
    id: NodeId,
    nodes: &Table<NodeId, Node>,
    primitives: &Table<PrimitiveId, Primitive>,
    found: &mut ArrayVec<PrimitiveId, MOST_PARTS>,
) -> Option<()> {
    let node = &nodes[id];
    match &node.kind {
        _ if !node.is_bare() => None,
        NodeKind::Primitive(p) => {
            let shape = &primitives[*p].shape;
            let fits = shape.is_chordal() || matches!(shape, Shape::Plane(_));
            fits.then(|| found.try_push(*p).ok()).flatten()
        }
        NodeKind::Csg { operation: Operation::Intersection, children, .. } => {
            children.iter().try_for_each(|child| collect(*child, nodes, primitives, found))
        }
        NodeKind::Csg { .. } => None,
    }
}

impl Geometry {
    /// The nearest crossing that all parts leave, with its primitive; `Err` where points have to be tested.
    pub(super) fn nearest_of_convex_parts(
        &self,
        parts: &[PrimitiveId],
        ray: &Ray,
        range: Range,
        hits: &mut ShapeHits,
    ) -> Result<Option<(ShapeHit, PrimitiveId)>, ()> {
        // What points at the ray's origin are off by, as a parameter, twice as much as shapes and inside tests round.
        let rounding = gamma(64) * ray.origin.abs().max_element() / ray.direction.abs().max_element();
        let mut stretches = ArrayVec::<Stretch, MOST_PARTS>::new();
        let mut common = range;
        for id in parts {
            let primitive = &self.primitives[*id];
            match stretch(*id, primitive, ray, rounding, hits) {
                Met::Unsure => return Err(()),
                // A part that is turned inside out then is everywhere.
                Met::Nothing if primitive.inverse => {}
                Met::Nothing => return Ok(None),
                Met::Stretch(stretch) => {
                    if !primitive.inverse {
                        common.min = common.min.max(stretch.low.t - stretch.margin);
                        common.max = common.max.min(stretch.high.t + stretch.margin);
                        if common.is_empty() {
                            return Ok(None);
                        }
                    }
                    stretches.push(stretch);
                }
            }
        }
        let mut best: Option<(ShapeHit, PrimitiveId)> = None;
        let mut unsure = f64::INFINITY;
        for (i, stretch) in stretches.iter().enumerate() {
            for hit in [stretch.low, stretch.high] {
                let is_nearer = best.is_none_or(|(best, _)| hit.t < best.t);
                if !is_nearer || !range.contains(hit.t) {
                    continue;
                }
                let others = stretches.iter().enumerate().filter(|(j, _)| *j != i);
                let mut is_sure = true;
                let is_left = others.map(|(_, other)| other.contains(hit.t)).all(|contains| {
                    is_sure &= contains.is_some();
                    contains.unwrap_or(true)
                });
                match (is_left, is_sure) {
                    (false, _) => {}
                    (true, true) => best = Some((hit, stretch.primitive)),
                    (true, false) => unsure = unsure.min(hit.t),
                }
            }
        }
        if best.map_or(unsure < f64::INFINITY, |(hit, _)| unsure <= hit.t) { Err(()) } else { Ok(best) }
    }
}

/// The stretch of a line in a part.
fn stretch(id: PrimitiveId, primitive: &Primitive, ray: &Ray, rounding: f64, hits: &mut ShapeHits) -> Met {
    /// As a part of the larger parameter.
    const MARGIN: f64 = 1e-9;
    let moved;
    let local = match &primitive.group_from_local {
        None => ray,
        Some(place) => {
            moved = place.inverse_ray(ray);
            &moved
        }
    };
    let inverse = primitive.inverse;
    if let Shape::Plane(plane) = &primitive.shape {
        let Some((t, margin, enters)) = plane.passage(local) else { return Met::Unsure };
        let ends = if enters { [t, f64::INFINITY] } else { [f64::NEG_INFINITY, t] };
        let [low, high] = ends.map(|t| ShapeHit { t, part: 0 });
        return Met::Stretch(Stretch { primitive: id, low, high, margin, inverse });
    }
    hits.clear();
    primitive.shape.crossings(local, Range::LINE, hits);
    match hits[..] {
        [a, b] => {
            let [low, high] = if a.t <= b.t { [a, b] } else { [b, a] };
            let margin = MARGIN * low.t.abs().max(high.t.abs()) + rounding;
            Met::Stretch(Stretch { primitive: id, low, high, margin, inverse })
        }
        // A line that crosses nothing is inside everywhere or nowhere.
        [] if !primitive.shape.contains(local.origin) => Met::Nothing,
        _ => Met::Unsure,
    }
}
