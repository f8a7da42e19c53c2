//! A four-wide bounding volume hierarchy with single-precision boxes, rounded outward.
//!
//! Boxes of four children are tested at once in SIMD lanes. Single precision never loses a hit:
//! boxes grow to the next number, the ray's origin is rounded to whichever side makes the box
//! larger, and the remaining relative errors are paid for at the end.
//!
//! Sources: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007 (binning);
//! Dammertz et al., Shallow Bounding Volume Hierarchies, 2008 (four children); Ize, Robust BVH Ray
//! Traversal, 2013 (error of the slab test).

use crate::math::{Bounds, Range, Ray};
use glam::{Vec3, Vec4};
use rayon::prelude::*;
use smallvec::SmallVec;
use std::ops::{ControlFlow, Range as Span};

/// Largest number not above `x`.
fn round_down(x: f64) -> f32 {
    let f = x as f32;
    if f64::from(f) > x { f.next_down() } else { f }
}

/// Smallest number not below `x`.
fn round_up(x: f64) -> f32 {
    let f = x as f32;
    if f64::from(f) < x { f.next_up() } else { f }
}

/// A single-precision box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Box32 {
    min: Vec3,
    max: Vec3,
}

impl Box32 {
    const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Half the surface, at a scale where squares of huge sizes stay finite.
    fn half_area(&self) -> f64 {
        let d = (self.max - self.min).max(Vec3::ZERO).as_dvec3();
        d.x * d.y + d.y * d.z + d.z * d.x
    }

    /// Around three corners, exactly.
    pub(crate) fn around_triangle([a, b, c]: [Vec3; 3]) -> Self {
        Self { min: a.min(b).min(c), max: a.max(b).max(c) }
    }
}

impl From<&Bounds> for Box32 {
    fn from(b: &Bounds) -> Self {
        Self { min: Vec3::from(b.min.to_array().map(round_down)), max: Vec3::from(b.max.to_array().map(round_up)) }
    }
}

/// Four children: boxes by coordinate, then what they are.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// Lower x, y, z, then upper x, y, z, of four children each.
    planes: [Vec4; 6],
    /// Index of a node, or a run of items when [`LEAF`] is set.
    children: [u32; 4],
}

/// Marks a child as a run of items; then four bits of length and 27 of the first item.
const LEAF: u32 = 1 << 31;
const LENGTH_SHIFT: u32 = 27;
const FIRST_MASK: u32 = (1 << LENGTH_SHIFT) - 1;

/// The hierarchy; items are referred to by their position in the order that `build` gives.
#[derive(Debug, Default)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
}

/// An item during construction.
#[derive(Clone, Copy)]
struct Item {
    bounds: Box32,
    index: u32,
}

/// Below this, two threads cost more than they gain.
const PARALLEL_ITEMS: usize = 8192;
const BINS: usize = 16;

impl Bvh {
    /// Builds over boxes; returns the order in which items must be stored.
    ///
    /// At most 2^27 items; `leaf_size` at most 15.
    pub(crate) fn build(boxes: impl IndexedParallelIterator<Item = Box32>, leaf_size: usize) -> (Self, Vec<u32>) {
        let mut items: Vec<Item> = boxes.enumerate().map(|(i, bounds)| Item { bounds, index: i as u32 }).collect();
        let mut nodes = Vec::new();
        if !items.is_empty() {
            nodes = build_subtree(&mut items, 0, leaf_size, 0);
        }
        nodes.shrink_to_fit();
        (Self { nodes }, items.iter().map(|i| i.index).collect())
    }

    /// Its nodes, leaves not counted.
    pub(super) fn n_nodes(&self) -> usize {
        self.nodes.len()
    }

    /// Goes through leaves that the ray may meet, near ones first. `visit` gets a run of items,
    /// may lower `t_max`, and may end the walk.
    #[inline]
    pub(crate) fn walk<B>(
        &self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(Span<usize>, &mut f64) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        if self.nodes.is_empty() {
            return ControlFlow::Continue(());
        }
        let probe = Probe::new(ray, range.min);
        let mut t_max = range.max;
        let mut waiting: SmallVec<[(u32, f32); 64]> = SmallVec::new();
        let mut current = 0u32;
        loop {
            if current & LEAF != 0 {
                let first = (current & FIRST_MASK) as usize;
                let length = ((current & !LEAF) >> LENGTH_SHIFT) as usize;
                visit(first..first + length, &mut t_max)?;
            } else {
                let node = &self.nodes[current as usize];
                let (near, hits) = probe.test(node, round_up(t_max));
                let mut found: SmallVec<[(u32, f32); 4]> = SmallVec::new();
                for (i, (child, near)) in node.children.iter().zip(near).enumerate() {
                    if hits & (1 << i) != 0 {
                        found.push((*child, near));
                    }
                }
                // Farthest first, so that the nearest comes off the stack first.
                found.sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
                waiting.extend_from_slice(&found);
            }
            // What lies behind the nearest hit so far need not be looked at.
            current = loop {
                match waiting.pop() {
                    Some((child, near)) if f64::from(near) <= t_max => break child,
                    Some(_) => {}
                    None => return ControlFlow::Continue(()),
                }
            };
        }
    }
}

/// A ray made ready for slab tests.
struct Probe {
    /// Index of the plane through which the ray enters, and leaves, on each axis.
    enter: [usize; 3],
    leave: [usize; 3],
    /// Origin rounded so that the entry comes early and the exit late.
    enter_origin: [Vec4; 3],
    leave_origin: [Vec4; 3],
    inverse: [Vec4; 3],
    t_min: Vec4,
}

/// Reciprocals stop here, so that a product with a zero distance is zero and not NaN.
const STEEPEST: f32 = 1e37;
/// Distances end here; a direction along an axis still tells boxes beside the ray from others.
const FARTHEST: f32 = 1e30;

impl Probe {
    fn new(ray: &Ray, t_min: f64) -> Self {
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let backward: [bool; 3] = std::array::from_fn(|i| d[i] < 0.0);
        let pick = |i: usize, up: bool| Vec4::splat(if up { round_up(o[i]) } else { round_down(o[i]) });
        Self {
            enter: std::array::from_fn(|i| if backward[i] { i + 3 } else { i }),
            leave: std::array::from_fn(|i| if backward[i] { i } else { i + 3 }),
            enter_origin: std::array::from_fn(|i| pick(i, !backward[i])),
            leave_origin: std::array::from_fn(|i| pick(i, backward[i])),
            inverse: std::array::from_fn(|i| {
                Vec4::splat(((1.0 / d[i]) as f32).abs().min(STEEPEST).copysign(if backward[i] { -1.0 } else { 1.0 }))
            }),
            t_min: Vec4::splat(round_down(t_min)),
        }
    }

    /// Entry distances, and a bit for each child that is met.
    #[inline]
    fn test(&self, node: &Node, t_max: f32) -> ([f32; 4], u32) {
        // Difference, reciprocal and product round once each, on both sides: 6 units of 2^-24,
        // doubled for the rounding of this factor itself.
        const SLACK: f32 = 1.0 + 12.0 * f32::EPSILON / 2.0;
        let mut near = self.t_min;
        let mut far = Vec4::splat(t_max.min(FARTHEST));
        for axis in 0..3 {
            let enter = (node.planes[self.enter[axis]] - self.enter_origin[axis]) * self.inverse[axis];
            let leave = (node.planes[self.leave[axis]] - self.leave_origin[axis]) * self.inverse[axis];
            near = near.max(enter);
            far = far.min(leave * SLACK);
        }
        (near.to_array(), near.cmple(far).bitmask())
    }
}

/// Nodes of a subtree over `items`, which are put in order; `first` is the position of the first.
fn build_subtree(items: &mut [Item], first: usize, leaf_size: usize, depth: u32) -> Vec<Node> {
    let mut runs: SmallVec<[(Span<usize>, Box32); 4]> = SmallVec::new();
    runs.push((0..items.len(), bounds_of(items)));
    while runs.len() < 4 {
        let widest = runs
            .iter()
            .enumerate()
            .filter(|(_, (run, _))| run.len() > leaf_size)
            .max_by(|(_, (_, a)), (_, (_, b))| a.half_area().total_cmp(&b.half_area()));
        let Some((k, _)) = widest else { break };
        let (run, _) = runs.swap_remove(k);
        let middle = run.start + split(&mut items[run.clone()], depth);
        for half in [run.start..middle, middle..run.end] {
            let bounds = bounds_of(&items[half.clone()]);
            runs.push((half, bounds));
        }
    }
    runs.sort_unstable_by_key(|(run, _)| run.start);

    let mut root = Node { planes: [Vec4::INFINITY; 6], children: [LEAF; 4] };
    for (slot, (run, bounds)) in runs.iter().enumerate() {
        for axis in 0..3 {
            root.planes[axis][slot] = bounds.min[axis];
            root.planes[axis + 3][slot] = bounds.max[axis];
        }
        root.children[slot] = LEAF | (run.len() as u32) << LENGTH_SHIFT | (first + run.start) as u32;
    }
    for slot in runs.len()..4 {
        for axis in 0..3 {
            root.planes[axis + 3][slot] = f32::NEG_INFINITY;
        }
    }

    let parallel = items.len() > PARALLEL_ITEMS;
    let mut parts: SmallVec<[(usize, usize, &mut [Item]); 4]> = SmallVec::new();
    let mut rest = items;
    for (slot, (run, _)) in runs.iter().enumerate() {
        let (part, tail) = rest.split_at_mut(run.len());
        rest = tail;
        if part.len() > leaf_size {
            parts.push((slot, first + run.start, part));
        }
    }
    let build =
        |(slot, first, part): (usize, usize, &mut [Item])| (slot, build_subtree(part, first, leaf_size, depth + 1));
    let subtrees: Vec<(usize, Vec<Node>)> = if parallel {
        parts.into_vec().into_par_iter().map(build).collect()
    } else {
        parts.into_iter().map(build).collect()
    };
    let mut nodes = vec![root];
    for (slot, subtree) in subtrees {
        let offset = nodes.len() as u32;
        nodes[0].children[slot] = offset;
        nodes.extend(subtree.into_iter().map(|mut node| {
            for child in &mut node.children {
                if *child & LEAF == 0 {
                    *child += offset;
                }
            }
            node
        }));
    }
    nodes
}

fn bounds_of(items: &[Item]) -> Box32 {
    items.iter().fold(Box32::EMPTY, |b, i| b.union(&i.bounds))
}

/// Puts items in order around the best split of the surface area heuristic; where the right begins.
fn split(items: &mut [Item], depth: u32) -> usize {
    let middle = |i: &Item| i.bounds.min * 0.5 + i.bounds.max * 0.5;
    let (low, high) = items
        .iter()
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), i| (low.min(middle(i)), high.max(middle(i))));
    let extent = high - low;
    let half = items.len() / 2;
    // A tree deeper than any sane one is finished by halving, which bounds it.
    if extent.max_element() <= 0.0 || !extent.is_finite() || depth > 32 {
        let axis = extent.max_position();
        items.select_nth_unstable_by(half, |a, b| middle(a)[axis].total_cmp(&middle(b)[axis]));
        return half;
    }
    let mut best = (f64::INFINITY, 0, 0);
    for axis in 0..3 {
        if extent[axis] <= 0.0 {
            continue;
        }
        let scale = BINS as f32 / extent[axis];
        let mut bins = [(0usize, Box32::EMPTY); BINS];
        for item in items.iter() {
            let bin = &mut bins[bin_of(middle(item)[axis], low[axis], scale)];
            *bin = (bin.0 + 1, bin.1.union(&item.bounds));
        }
        let mut right = [0.0; BINS];
        let mut sum = (0, Box32::EMPTY);
        for k in (1..BINS).rev() {
            sum = (sum.0 + bins[k].0, sum.1.union(&bins[k].1));
            right[k] = sum.0 as f64 * sum.1.half_area();
        }
        let mut sum = (0, Box32::EMPTY);
        for k in 1..BINS {
            sum = (sum.0 + bins[k - 1].0, sum.1.union(&bins[k - 1].1));
            let cost = sum.0 as f64 * sum.1.half_area() + right[k];
            if cost < best.0 && sum.0 > 0 && sum.0 < items.len() {
                best = (cost, axis, k);
            }
        }
    }
    let (cost, axis, bin) = best;
    if cost == f64::INFINITY {
        return half;
    }
    let scale = BINS as f32 / extent[axis];
    let mut boundary = 0;
    for i in 0..items.len() {
        if bin_of(middle(&items[i])[axis], low[axis], scale) < bin {
            items.swap(i, boundary);
            boundary += 1;
        }
    }
    boundary
}

fn bin_of(x: f32, low: f32, scale: f32) -> usize {
    (((x - low) * scale) as usize).min(BINS - 1)
}
