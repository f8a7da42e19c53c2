//! Hierarchies over the children of a solid's node, for nodes with many.
//!
//! A ray needs the children whose surfaces it may meet; a point needs those that may have a say in
//! whether it is inside. Both get positions in the list of children.

use super::bvh::{Box32, Bvh};
use super::slab::SlabRay;
use crate::math::{Bounds, DVec3, Range, Ray};
use rayon::prelude::*;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// With fewer children, going through all of them is faster.
pub(super) const WORTH_A_TREE: usize = 8;

/// Boxes in a leaf, so that whatever is found has its own box met.
const LEAF_SIZE: usize = 1;

/// Children of a node by where they are.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    /// By the boxes of surfaces.
    surfaces: Tree,
    /// By the boxes outside of which a child has no say in what is inside.
    says: Tree,
}

impl Parts {
    /// Over the children's boxes; `None` for few children.
    pub(crate) fn new(surfaces: &[Bounds], says: &[Bounds]) -> Option<Box<Self>> {
        (surfaces.len() >= WORTH_A_TREE)
            .then(|| Box::new(Self { surfaces: Tree::new(surfaces), says: Tree::new(says) }))
    }

    /// Visits the children whose surfaces the ray may meet, near ones first; `visit` says where the search ends.
    pub(super) fn visit_met(&self, ray: &Ray, range: Range, visit: impl FnMut(u32) -> f64) {
        self.surfaces.visit_met(ray, range, visit);
    }

    /// Whether a test holds for every child that has a say about a point.
    pub(super) fn all_at(&self, point: DVec3, test: impl FnMut(usize) -> bool) -> bool {
        self.says.all_at(point, test)
    }
}

/// Positions in a list, rising.
pub(super) type Positions = SmallVec<[u32; 16]>;

/// Boxes in a hierarchy, and what has none.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    bvh: Bvh,
    /// Position of each box in the order of the hierarchy.
    order: Vec<u32>,
    unbounded: Vec<u32>,
    hull: Bounds,
}

impl Tree {
    /// Over boxes; empty ones are left out.
    pub(super) fn new(boxes: &[Bounds]) -> Self {
        let numbers = 0..boxes.len() as u32;
        let occupied = numbers.filter(|i| !boxes[*i as usize].is_empty());
        let (bounded, unbounded): (Vec<u32>, Vec<u32>) = occupied.partition(|i| boxes[*i as usize].is_finite());
        let (bvh, order) = Bvh::build(bounded.par_iter().map(|i| Box32::from(&boxes[*i as usize])), LEAF_SIZE);
        let hull = bounded.iter().fold(Bounds::EMPTY, |sum, i| sum.union(&boxes[*i as usize]));
        Self { bvh, order: order.iter().map(|i| bounded[*i as usize]).collect(), unbounded, hull }
    }

    /// Boxes that the ray may meet, in their order.
    pub(super) fn met_by(&self, ray: &Ray, range: Range) -> Positions {
        let mut met = Positions::new();
        if !self.unbounded.is_empty() || SlabRay::new(ray).may_meet(&self.hull, range) {
            self.visit_met(ray, range, |i| {
                met.push(i);
                range.max
            });
        }
        met.sort_unstable();
        met
    }

    /// Visits boxes that the ray may meet, near ones first; `visit` says where the search ends.
    fn visit_met(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        let mut end = range.max;
        for i in &self.unbounded {
            end = end.min(visit(*i));
        }
        let _: ControlFlow<()> = self.bvh.walk(ray, Range { max: end, ..range }, |run, t_max| {
            for i in &self.order[run] {
                *t_max = t_max.min(visit(*i));
            }
            ControlFlow::Continue(())
        });
    }

    /// Boxes that hold the point, in their order.
    pub(super) fn around(&self, point: DVec3) -> Positions {
        let mut found = Positions::new();
        self.all_at(point, |i| {
            found.push(i as u32);
            true
        });
        found.sort_unstable();
        found
    }

    /// Whether a test holds for every box that holds a point.
    fn all_at(&self, point: DVec3, mut test: impl FnMut(usize) -> bool) -> bool {
        let mut holds = |run: &[u32]| run.iter().all(|i| test(*i as usize));
        let flow = |holds: bool| if holds { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
        holds(&self.unbounded)
            && (!self.hull.contains(point) || self.bvh.at(point, |run| flow(holds(&self.order[run]))).is_continue())
    }
}
