//! The way of a ray through groups and instances to its nearest hit.

use super::Geometry;
use super::graph::{Group, Item, ItemKind};
use super::record::{Hit, Path, RayKind};
use super::shape::Primitive as _;
use super::solid::Scratch;
use crate::math::{Range, Ray};
use std::ops::ControlFlow;

/// A search in progress.
pub(super) struct Walk<'a> {
    pub(super) geometry: &'a Geometry,
    pub(super) kind: RayKind,
    pub(super) scratch: &'a mut Scratch,
    /// Ends at the nearest hit so far.
    pub(super) range: Range,
    pub(super) best: Option<Hit>,
    /// Instances that the ray is in.
    pub(super) path: Path,
    /// Any hit ends the search.
    pub(super) any: bool,
    /// The item of the outermost group that ended it.
    pub(super) blocker: Option<Item>,
}

impl<'a> Walk<'a> {
    pub(super) fn new(
        geometry: &'a Geometry,
        range: Range,
        kind: RayKind,
        scratch: &'a mut Scratch,
        any: bool,
    ) -> Self {
        Self { geometry, kind, scratch, range, best: None, path: Path::default(), any, blocker: None }
    }

    /// Goes through a group; `ray` is in the group's space. Breaks when any hit will do and there is one.
    pub(super) fn group(&mut self, group: &Group, ray: &Ray) -> ControlFlow<()> {
        for item in &group.infinite {
            self.tried(item, ray)?;
        }
        group.bvh.walk(ray, self.range, |items, t_max| {
            for item in &group.items[items] {
                self.tried(item, ray)?;
            }
            *t_max = self.range.max;
            ControlFlow::Continue(())
        })
    }

    /// An item of a group; one that ends the search is noted, over any of a group within it.
    #[inline]
    fn tried(&mut self, item: &Item, ray: &Ray) -> ControlFlow<()> {
        let flow = self.item(item, ray);
        if flow.is_break() {
            self.blocker = Some(*item);
        }
        flow
    }

    #[inline]
    pub(super) fn item(&mut self, item: &Item, ray: &Ray) -> ControlFlow<()> {
        if item.skips.skips(self.kind) {
            return ControlFlow::Continue(());
        }
        match &item.kind {
            ItemKind::Sphere(sphere, primitive) => {
                if let Some(hit) = sphere.intersect(ray, self.range) {
                    return self.record(hit.t, *primitive, hit.part);
                }
            }
            ItemKind::Primitive(index) => return self.primitive(*index, ray),
            ItemKind::Solid(root) => {
                if let Some(c) = self.geometry.solid_nearest(*root, ray, self.range, self.kind, self.scratch) {
                    return self.record(c.t, c.primitive, c.part);
                }
            }
            ItemKind::Instance(index) => {
                let instance = &self.geometry.instances[*index as usize];
                self.path.push(*index);
                let geometry = self.geometry;
                let flow =
                    self.group(&geometry.groups[instance.group as usize], &instance.parent_from_group.inverse_ray(ray));
                self.path.pop();
                return flow;
            }
        }
        ControlFlow::Continue(())
    }

    fn primitive(&mut self, index: u32, ray: &Ray) -> ControlFlow<()> {
        let primitive = &self.geometry.primitives[index as usize];
        let moved;
        let ray = match &primitive.group_from_local {
            Some(place) => {
                moved = place.inverse_ray(ray);
                &moved
            }
            None => ray,
        };
        if self.any {
            if primitive.shape.occluded(ray, self.range) {
                return self.record(self.range.max, index, 0);
            }
        } else if let Some(hit) = primitive.shape.intersect(ray, self.range) {
            return self.record(hit.t, index, hit.part);
        }
        ControlFlow::Continue(())
    }

    /// Notes a hit inside the range.
    fn record(&mut self, t: f64, primitive: u32, part: u32) -> ControlFlow<()> {
        self.best = Some(Hit { t, primitive, part, path: self.path });
        self.range.max = t;
        if self.any { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
