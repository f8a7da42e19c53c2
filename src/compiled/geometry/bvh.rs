//! A four-wide bounding volume hierarchy with single-precision boxes, rounded outward.
//!
//! Boxes of four children are tested at once in SIMD lanes. Single precision never loses a hit:
//! boxes grow to the next number, the ray's origin is rounded to whichever side makes the box
//! larger, and the remaining relative errors are paid for at the end.
//!
//! Sources: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007 (binning);
//! Dammertz et al., Shallow Bounding Volume Hierarchies, 2008 (four children); Ize, Robust BVH Ray
//! Traversal, 2013 (error of the slab test).

use crate::math::{Bounds, DVec3, Range, Ray};
use arrayvec::ArrayVec;
use glam::{BVec4A, Vec3, Vec4};
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

/// Four children: boxes by coordinate, then what they are. Two cache lines, never three.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Node {
    /// Lower and upper planes across x, y and z, of four children each.
    planes: [[Vec4; 2]; 3],
    /// Index of a node, or a run of items when [`LEAF`] is set.
    children: [u32; 4],
}

/// Marks a child as a run of items; then four bits of length and 27 of the first item.
const LEAF: u32 = 1 << 31;
const LENGTH_SHIFT: u32 = 27;
const FIRST_MASK: u32 = (1 << LENGTH_SHIFT) - 1;

/// Children still to be visited, with the distances at which their boxes begin.
///
/// A level adds at most three. [`split`] goes by area for 33 levels, then halves; 2^27 items end
/// after 27 levels more.
type Waiting = ArrayVec<(u32, f32), { 3 * (33 + 27) + 3 }>;

/// The hierarchy; items are referred to by their position in the order that `build` gives.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
}

/// An item during construction; the fourth lanes hold its number and nothing.
#[derive(Clone, Copy)]
struct Item {
    min: Vec4,
    max: Vec4,
}

/// Makes a number below 2^27 the bits of an ordinary float, with which arithmetic is not slow.
const ITEM_TAG: u32 = 0x4000_0000;

impl Item {
    fn new(bounds: &Box32, index: u32) -> Self {
        Self { min: bounds.min.extend(f32::from_bits(ITEM_TAG | index)), max: bounds.max.extend(0.0) }
    }

    fn index(&self) -> u32 {
        self.min.w.to_bits() & FIRST_MASK
    }

    /// The middle of the box.
    fn middle(&self) -> Vec4 {
        self.min * 0.5 + self.max * 0.5
    }

    /// The same along one axis.
    fn middle_along(&self, axis: usize) -> f32 {
        let [min, max]: [&[f32; 4]; 2] = [self.min.as_ref(), self.max.as_ref()];
        min[axis] * 0.5 + max[axis] * 0.5
    }
}

/// A box under construction; its fourth lanes mean nothing.
#[derive(Clone, Copy)]
struct Hull {
    min: Vec4,
    max: Vec4,
}

impl Hull {
    const EMPTY: Self = Self { min: Vec4::INFINITY, max: Vec4::NEG_INFINITY };

    fn around(items: &[Item]) -> Self {
        items.iter().fold(Self::EMPTY, |hull, i| hull.with(i.min, i.max))
    }

    #[inline]
    fn with(&self, min: Vec4, max: Vec4) -> Self {
        Self { min: self.min.min(min), max: self.max.max(max) }
    }

    /// Half the surface, at a scale where squares of huge sizes stay finite.
    #[inline]
    fn half_area(&self) -> f64 {
        let [x, y, z, _] = (self.max - self.min).max(Vec4::ZERO).to_array().map(f64::from);
        x * y + y * z + z * x
    }
}

/// Below this, two threads cost more than they gain.
const PARALLEL_ITEMS: usize = 1 << 15;
const BINS: usize = 16;
/// As many items are sorted: most splits are of few, and there bins cost more than items.
const FEW_ITEMS: usize = 16;

impl Bvh {
    /// Builds over boxes; returns the order in which items must be stored.
    ///
    /// At most 2^27 items; `leaf_size` at most 15.
    pub(crate) fn build(boxes: impl IndexedParallelIterator<Item = Box32>, leaf_size: usize) -> (Self, Vec<u32>) {
        let mut items: Vec<Item> = boxes.enumerate().map(|(i, bounds)| Item::new(&bounds, i as u32)).collect();
        let mut nodes = nodes_over(items.len(), leaf_size);
        if !items.is_empty() {
            let hull = Hull::around(&items);
            build_subtree(&mut items, Place { hull, first: 0, leaf_size, depth: 0 }, &mut nodes);
        }
        (Self { nodes }, items.iter().map(Item::index).collect())
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
        let mut end = round_up(t_max);
        let mut waiting = Waiting::new();
        let mut current = 0u32;
        loop {
            let next = if current & LEAF != 0 {
                let first = (current & FIRST_MASK) as usize;
                let length = ((current & !LEAF) >> LENGTH_SHIFT) as usize;
                let before = t_max;
                visit(first..first + length, &mut t_max)?;
                if t_max != before {
                    end = round_up(t_max);
                }
                None
            } else {
                self.nodes[current as usize].nearest(&probe, end, &mut waiting)
            };
            // What lies behind the nearest hit so far need not be looked at.
            current = match next {
                Some(child) => child,
                None => loop {
                    match waiting.pop() {
                        Some((child, near)) if near <= end => break child,
                        Some(_) => {}
                        None => return ControlFlow::Continue(()),
                    }
                },
            };
        }
    }
}

impl Node {
    /// The nearest child that the ray meets; the others are put on `waiting`, the farthest first.
    #[inline]
    fn nearest(&self, probe: &Probe, end: f32, waiting: &mut Waiting) -> Option<u32> {
        let (near, mut hits) = probe.test(self, end);
        if hits == 0 {
            return None;
        }
        let lowest = |hits: u32| {
            let i = (hits.trailing_zeros() & 3) as usize;
            (self.children[i], near[i])
        };
        let mut best = lowest(hits);
        let first = waiting.len();
        loop {
            hits &= hits - 1;
            if hits == 0 {
                return Some(best.0);
            }
            let mut other = lowest(hits);
            if other.1 < best.1 {
                std::mem::swap(&mut other, &mut best);
            }
            // Insertion sort: there are at most three.
            waiting.push(other);
            let mut k = waiting.len() - 1;
            while k > first && waiting[k - 1].1 < waiting[k].1 {
                waiting.swap(k - 1, k);
                k -= 1;
            }
        }
    }
}

impl Bvh {
    /// Goes through leaves whose boxes hold a point, in no particular order.
    pub(crate) fn at<B>(&self, point: DVec3, mut visit: impl FnMut(Span<usize>) -> ControlFlow<B>) -> ControlFlow<B> {
        let upper = point.to_array().map(|c| Vec4::splat(round_up(c)));
        let lower = point.to_array().map(|c| Vec4::splat(round_down(c)));
        let mut waiting: SmallVec<[u32; 64]> = SmallVec::new();
        waiting.extend((!self.nodes.is_empty()).then_some(0));
        while let Some(current) = waiting.pop() {
            if current & LEAF != 0 {
                let first = (current & FIRST_MASK) as usize;
                visit(first..first + ((current & !LEAF) >> LENGTH_SHIFT) as usize)?;
                continue;
            }
            let node = &self.nodes[current as usize];
            let mut holds = BVec4A::TRUE;
            for axis in 0..3 {
                let [min, max] = &node.planes[axis];
                holds &= min.cmple(upper[axis]) & max.cmpge(lower[axis]);
            }
            let holds = holds.bitmask();
            waiting.extend((0..4).filter(|i| holds & (1 << i) != 0).map(|i| node.children[i]));
        }
        ControlFlow::Continue(())
    }
}

/// A ray made ready for slab tests.
struct Probe {
    /// Origin rounded up, from which lower planes are seen early by a ray that goes up, and late by one that goes down.
    above: [Vec4; 3],
    /// Origin rounded down, for upper planes.
    below: [Vec4; 3],
    inverse: [Vec4; 3],
    t_min: Vec4,
}

/// Reciprocals stop here, so that a product with a zero distance is zero and not NaN.
const STEEPEST: f32 = 1e37;
/// Difference, reciprocal and product round once each, on both sides: 6 units of 2^-24, doubled for
/// the rounding of this factor itself and of what it is multiplied with.
const SLACK: f32 = 1.0 + 12.0 * f32::EPSILON / 2.0;
/// Distances end here; a direction along an axis still tells boxes beside the ray from others.
const FARTHEST: f32 = 1e30;

impl Probe {
    #[inline(always)]
    fn new(ray: &Ray, t_min: f64) -> Self {
        let origin = ray.origin.as_vec3();
        // A whole unit of the last digit, where rounding was wrong by half of one at most.
        let unit = origin.abs() * f32::EPSILON + Vec3::splat(f32::MIN_POSITIVE);
        let steepest = Vec3::splat(STEEPEST);
        let inverse = ray.direction.recip().as_vec3().clamp(-steepest, steepest);
        let lanes = |v: Vec3| v.to_array().map(Vec4::splat);
        Self {
            above: lanes(origin + unit),
            below: lanes(origin - unit),
            inverse: lanes(inverse),
            t_min: Vec4::splat(round_down(t_min)),
        }
    }

    /// Entry distances, and a bit for each child that is met.
    #[inline]
    fn test(&self, node: &Node, t_max: f32) -> ([f32; 4], u32) {
        let mut near = self.t_min;
        let mut far = Vec4::splat(FARTHEST);
        for axis in 0..3 {
            let [lower, upper] = node.planes[axis];
            let lower = (lower - self.above[axis]) * self.inverse[axis];
            let upper = (upper - self.below[axis]) * self.inverse[axis];
            near = near.max(lower.min(upper));
            far = far.min(lower.max(upper));
        }
        let far = (far * SLACK).min(Vec4::splat(t_max));
        (near.to_array(), near.cmple(far).bitmask())
    }
}

/// Where a subtree begins.
#[derive(Clone, Copy)]
struct Place {
    /// Around its items.
    hull: Hull,
    /// Position of the first item.
    first: usize,
    leaf_size: usize,
    depth: u32,
}

/// Room for as many nodes as there usually are over so many items: to grow, or to shrink, moves them all.
fn nodes_over(n_items: usize, leaf_size: usize) -> Vec<Node> {
    Vec::with_capacity(n_items / (leaf_size + 1))
}

/// Appends the nodes of a subtree over `items`, which are put in order.
fn build_subtree(items: &mut [Item], place: Place, nodes: &mut Vec<Node>) {
    let Place { hull, first, leaf_size, depth } = place;
    let mut runs: SmallVec<[(Span<usize>, Hull); 4]> = SmallVec::new();
    runs.push((0..items.len(), hull));
    while runs.len() < 4 {
        let widest = runs
            .iter()
            .enumerate()
            .filter(|(_, (run, _))| run.len() > leaf_size)
            .max_by(|(_, (_, a)), (_, (_, b))| a.half_area().total_cmp(&b.half_area()));
        let Some((k, _)) = widest else { break };
        let (run, _) = runs.swap_remove(k);
        let (length, left, right) = split(&mut items[run.clone()], depth);
        runs.push((run.start..run.start + length, left));
        runs.push((run.start + length..run.end, right));
    }
    runs.sort_unstable_by_key(|(run, _)| run.start);

    let root = nodes.len();
    nodes.push(node_over(&runs, first));
    let parallel = items.len() > PARALLEL_ITEMS && rayon::current_num_threads() > 1;
    let mut parts: SmallVec<[(usize, Place, &mut [Item]); 4]> = SmallVec::new();
    let mut rest = items;
    for (slot, (run, hull)) in runs.iter().enumerate() {
        let (part, tail) = rest.split_at_mut(run.len());
        rest = tail;
        if part.len() > leaf_size {
            parts.push((slot, Place { hull: *hull, first: first + run.start, depth: depth + 1, leaf_size }, part));
        }
    }
    if !parallel {
        for (slot, place, part) in parts {
            nodes[root].children[slot] = nodes.len() as u32;
            build_subtree(part, place, nodes);
        }
        return;
    }
    let build = |(slot, place, part): (usize, Place, &mut [Item])| {
        let mut own = nodes_over(part.len(), leaf_size);
        build_subtree(part, place, &mut own);
        (slot, own)
    };
    let subtrees: Vec<(usize, Vec<Node>)> = parts.into_vec().into_par_iter().map(build).collect();
    for (slot, subtree) in subtrees {
        let offset = nodes.len() as u32;
        nodes[root].children[slot] = offset;
        nodes.extend(subtree.into_iter().map(|node| node.moved(offset)));
    }
}

/// A node whose children are all leaves, for the start.
fn node_over(runs: &[(Span<usize>, Hull)], first: usize) -> Node {
    // Unused children lie beyond all rays.
    let mut planes = [[Vec4::INFINITY; 2]; 3];
    let mut children = [LEAF; 4];
    for (axis, [min, max]) in planes.iter_mut().enumerate() {
        for (slot, (_, hull)) in runs.iter().enumerate() {
            min[slot] = hull.min[axis];
            max[slot] = hull.max[axis];
        }
    }
    for (slot, (run, _)) in runs.iter().enumerate() {
        children[slot] = LEAF | (run.len() as u32) << LENGTH_SHIFT | (first + run.start) as u32;
    }
    Node { planes, children }
}

impl Node {
    /// With nodes counted from further on.
    fn moved(mut self, offset: u32) -> Self {
        for child in &mut self.children {
            if *child & LEAF == 0 {
                *child += offset;
            }
        }
        self
    }
}

/// The bin of an item at a place from 0 to [`BINS`], the end included; 0 for NaN.
#[inline]
fn bin_at(place: f32) -> usize {
    // Adding this leaves the whole part in the lowest bits, without a conversion's checks of its range.
    const TO_BITS: f32 = (1 << 23) as f32;
    let rounded = (place - 0.5).max(0.0).min((BINS - 1) as f32) + TO_BITS;
    rounded.to_bits() as usize % BINS
}

/// Puts items in order around the best split of the surface area heuristic along the widest axis; how many go left,
/// and the boxes of both sides. Other axes are seldom better: to try them makes no ray faster, and building slower.
fn split(items: &mut [Item], depth: u32) -> (usize, Hull, Hull) {
    let middles = items.iter().fold(Hull::EMPTY, |hull, i| hull.with(i.middle(), i.middle()));
    let extent = (middles.max - middles.min).truncate();
    let axis = extent.max_position();
    // A tree deeper than any sane one is finished by halving, which bounds it.
    if extent.max_element() <= 0.0 || !extent.is_finite() || depth > 32 {
        return halve(items, axis);
    }
    if items.len() <= FEW_ITEMS {
        return sweep(items, axis);
    }
    let (low, scale) = (middles.min[axis], BINS as f32 / extent[axis]);
    let bin_of = |item: &Item| bin_at((item.middle_along(axis) - low) * scale);
    let mut counts = [0_usize; BINS];
    let mut hulls = [Hull::EMPTY; BINS];
    for item in items.iter() {
        let bin = bin_of(item);
        counts[bin] += 1;
        hulls[bin] = hulls[bin].with(item.min, item.max);
    }
    let Some(first_right) = cheapest(&counts, &hulls, items.len()) else { return halve(items, axis) };
    let mut boundary = 0;
    for i in 0..items.len() {
        if bin_of(&items[i]) < first_right {
            items.swap(i, boundary);
            boundary += 1;
        }
    }
    let side = |bins: &[Hull]| bins.iter().fold(Hull::EMPTY, |sum, h| sum.with(h.min, h.max));
    (boundary, side(&hulls[..first_right]), side(&hulls[first_right..]))
}

/// The first bin on the right of the best boundary between bins; `None` where all items are in one.
fn cheapest(counts: &[usize; BINS], hulls: &[Hull; BINS], n_items: usize) -> Option<usize> {
    let mut right = [0.0; BINS];
    let mut sum = (0, Hull::EMPTY);
    for k in (1..counts.len()).rev() {
        if counts[k] > 0 {
            sum = (sum.0 + counts[k], sum.1.with(hulls[k].min, hulls[k].max));
        }
        right[k] = sum.0 as f64 * sum.1.half_area();
    }
    let mut best = (f64::INFINITY, None);
    let mut sum = (0, Hull::EMPTY);
    for k in 1..counts.len() {
        if counts[k - 1] == 0 {
            continue;
        }
        sum = (sum.0 + counts[k - 1], sum.1.with(hulls[k - 1].min, hulls[k - 1].max));
        let cost = sum.0 as f64 * sum.1.half_area() + right[k];
        if cost < best.0 && sum.0 < n_items {
            best = (cost, Some(k));
        }
    }
    best.1
}

/// The best split between few items in their order along an axis.
fn sweep(items: &mut [Item], axis: usize) -> (usize, Hull, Hull) {
    items.sort_unstable_by(|a, b| a.middle_along(axis).total_cmp(&b.middle_along(axis)));
    let mut right = [Hull::EMPTY; FEW_ITEMS];
    let mut sum = Hull::EMPTY;
    for (k, item) in items.iter().enumerate().rev() {
        sum = sum.with(item.min, item.max);
        right[k % FEW_ITEMS] = sum;
    }
    let mut best = (f64::INFINITY, 1, Hull::around(&items[..1]));
    let mut left = Hull::EMPTY;
    for k in 1..items.len() {
        left = left.with(items[k - 1].min, items[k - 1].max);
        let cost = k as f64 * left.half_area() + (items.len() - k) as f64 * right[k % FEW_ITEMS].half_area();
        if cost < best.0 {
            best = (cost, k, left);
        }
    }
    let (_, count, left) = best;
    (count, left, right[count % FEW_ITEMS])
}

/// Half to each side of the median along an axis.
fn halve(items: &mut [Item], axis: usize) -> (usize, Hull, Hull) {
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |a, b| a.middle_along(axis).total_cmp(&b.middle_along(axis)));
    (half, Hull::around(&items[..half]), Hull::around(&items[half..]))
}
