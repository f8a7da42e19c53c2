//! The way of a ray through groups and instances to its nearest hit.

use super::Geometry;
use super::graph::{Group, Item, ItemKind, Skips};
use super::record::{Hit, Path, RayKind};
use super::shape::Primitive;
use super::solid::Scratch;
use crate::math::{Range, Ray};
use std::ops::ControlFlow;

/// A search in progress.
pub(super) struct Walk<'a> {
    pub(super) geometry: &'a Geometry,
    pub(super) kind: RayKind,
    /// What passes this kind of ray by.
    passed: Skips,
    pub(super) scratch: &'a mut Scratch,
    /// Ends at the nearest hit so far.
    pub(super) range: Range,
    pub(super) best: Option<Hit>,
    /// Instances that the ray is in.
    pub(super) path: Path,
    /// The ray in world space.
    ray: &'a Ray,
    /// Any hit ends the search.
    pub(super) any: bool,
    /// The item of the outermost group that ended it.
    pub(super) blocker: Option<Item>,
    /// What the nearest hit so far belongs to.
    winner: Owner,
}

/// What POV-Ray has as one object: a primitive by itself or a solid, by index.
#[derive(Clone, Copy, Debug)]
enum Owner {
    Primitive(u32),
    Solid(u32),
}

impl<'a> Walk<'a> {
    pub(super) fn new(
        geometry: &'a Geometry,
        ray: &'a Ray,
        range: Range,
        kind: RayKind,
        scratch: &'a mut Scratch,
        any: bool,
    ) -> Self {
        Self {
            geometry,
            kind,
            passed: Skips::of(kind),
            scratch,
            range,
            best: None,
            path: Path::default(),
            ray,
            any,
            blocker: None,
            winner: Owner::Primitive(0),
        }
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
    // Always inline, as what it calls: spheres are tried for less than a call costs.
    #[inline(always)]
    fn tried(&mut self, item: &Item, ray: &Ray) -> ControlFlow<()> {
        let flow = self.item(item, ray);
        if flow.is_break() {
            self.blocker = Some(*item);
        }
        flow
    }

    #[inline(always)]
    pub(super) fn item(&mut self, item: &Item, ray: &Ray) -> ControlFlow<()> {
        if item.skips.meets(self.passed) {
            return ControlFlow::Continue(());
        }
        match &item.kind {
            ItemKind::Sphere(sphere, primitive) => self.shape(sphere, *primitive, ray),
            ItemKind::Plane(plane, primitive) => self.shape(plane, *primitive, ray),
            ItemKind::Primitive(index) => self.primitive(*index, ray),
            ItemKind::Solid(root) => self.solid(*root, ray),
            ItemKind::Instance(index) => self.instance(*index, ray),
        }
    }

    /// A shape in the group's own space.
    #[inline(always)]
    fn shape(&mut self, shape: &impl Primitive, primitive: u32, ray: &Ray) -> ControlFlow<()> {
        match shape.intersect(ray, self.range) {
            Some(hit) => self.record(hit.t, primitive, hit.part, Owner::Primitive(primitive)),
            None => ControlFlow::Continue(()),
        }
    }

    #[inline(never)]
    fn solid(&mut self, root: u32, ray: &Ray) -> ControlFlow<()> {
        match self.geometry.solid_nearest(root, ray, self.range, self.kind, self.any, self.scratch) {
            Some(c) => self.record(c.t, c.primitive, c.part, Owner::Solid(root)),
            None => ControlFlow::Continue(()),
        }
    }

    #[inline(never)]
    fn instance(&mut self, index: u32, ray: &Ray) -> ControlFlow<()> {
        let instance = &self.geometry.instances[index as usize];
        self.path.push(index);
        let geometry = self.geometry;
        let flow = self.group(&geometry.groups[instance.group as usize], &instance.parent_from_group.inverse_ray(ray));
        self.path.pop();
        flow
    }

    #[inline(never)]
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
                return self.record(self.range.max, index, 0, Owner::Primitive(index));
            }
        } else if let Some(hit) = primitive.shape.intersect(ray, self.range) {
            return self.record(hit.t, index, hit.part, Owner::Primitive(index));
        }
        ControlFlow::Continue(())
    }

    /// Notes a hit inside the range, which reaches to what is as near as the nearest so far.
    fn record(&mut self, t: f64, primitive: u32, part: u32, owner: Owner) -> ControlFlow<()> {
        let as_near = |best: &Hit| t >= best.t && !self.any;
        if self.best.as_ref().is_some_and(|best| as_near(best) && !self.precedes(owner, primitive, best)) {
            return ControlFlow::Continue(());
        }
        self.best = Some(Hit { t, primitive, part, path: self.path });
        self.winner = owner;
        self.range.max = t.next_up();
        if self.any { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Whether the owner of one of two equally near hits comes first, as in POV-Ray (shape facts, section 13):
    /// what is infinite before what is not, then the object whose box the ray enters first, then by the file.
    #[cold]
    fn precedes(&self, owner: Owner, primitive: u32, best: &Hit) -> bool {
        let (new, old) = (self.entry(owner, &self.path), self.entry(self.winner, &best.path));
        let by_file = (primitive, self.path.steps()) < (best.primitive, best.path.steps());
        new < old || (new == old && by_file)
    }

    /// The parameter at which the ray enters the box of an object.
    fn entry(&self, owner: Owner, path: &Path) -> f64 {
        let local = match owner {
            Owner::Primitive(i) => self.geometry.primitives[i as usize].bounds(),
            Owner::Solid(i) => self.geometry.nodes[i as usize].bounds,
        };
        if !local.is_finite() {
            return f64::NEG_INFINITY;
        }
        let outward = path.steps().iter().rev().map(|i| &self.geometry.instances[*i as usize].parent_from_group);
        let world = outward.fold(local, |bounds, place| place.bounds(&bounds));
        let (o, d) = (self.ray.origin, self.ray.direction);
        let slab = |axis: usize| {
            let near = if d[axis] < 0.0 { world.max } else { world.min };
            // NaN, of a ray within a side of the box, says nothing.
            (near[axis] - o[axis]) / d[axis]
        };
        [0, 1, 2].map(slab).into_iter().fold(0.0, f64::max)
    }
}
