//! The way of a ray through groups and instances to its nearest hit.

use super::Geometry;
use super::graph::{Group, Item, ItemKind, RayMask};
use super::record::{Hit, Path, RayKind};
use super::shape::Primitive;
use super::solid::Scratch;
use crate::compiled::handle::{InstanceId, NodeId, PrimitiveId, Table, TextureId};
use crate::math::{Range, Ray};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// A search in progress.
pub(super) struct Walk<'a, S> {
    pub(super) geometry: &'a Geometry,
    pub(super) kind: RayKind,
    /// The kind, to compare with what an item is hidden from.
    mask: RayMask,
    pub(super) scratch: &'a mut Scratch,
    /// Where hits count: up to the nearest so far, if it is looked for.
    pub(super) range: Range,
    /// Instances that the ray is in.
    pub(super) path: Path,
    /// The ray in world space.
    ray: &'a Ray,
    /// What is looked for, and what was found of it.
    pub(super) search: S,
}

/// What a ray looks for.
pub(super) trait Search: Sized {
    /// Any hit of a thing says as much as its nearest.
    const ANY: bool;
    /// Notes a hit inside the range; breaks when it ends the search.
    fn record(walk: &mut Walk<'_, Self>, hit: Found) -> ControlFlow<()>;
    /// Notes what ended the search: first the item itself, then the instances around it.
    fn ended_by(&mut self, _item: &Item, _path: &Path) {}
}

/// A hit of a thing.
#[derive(Clone, Copy)]
pub(super) struct Found {
    t: f64,
    primitive: PrimitiveId,
    part: u32,
    owner: Owner,
}

/// What POV-Ray has as one object: a primitive by itself or a solid, by index.
#[derive(Clone, Copy, Debug)]
pub(super) enum Owner {
    Primitive(PrimitiveId),
    Solid(NodeId),
}

/// The nearest hit.
#[derive(Default)]
pub(super) struct Nearest {
    pub(super) best: Option<(Hit, Owner)>,
}

/// All hits of shapes; of a solid, the nearest.
#[derive(Default)]
pub(super) struct All {
    pub(super) hits: SmallVec<[Hit; 4]>,
}

/// Whatever stands in the way of light.
pub(super) struct Blocking<'a> {
    /// By texture, whether no light comes through; none is asked for where all are so.
    pub(super) opaque: Option<&'a Table<TextureId, bool>>,
    /// Something was met that may let light through.
    pub(super) is_filtered: bool,
    /// What ended the search.
    pub(super) blocker: Option<Blocker>,
}

/// An item with the instances in which it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blocker {
    item: Item,
    path: Path,
}

/// What a ray to a light met. Trying it first saves the way through the hierarchy, and changes no answer.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LastShadow {
    /// What stood in its way.
    pub(super) blocker: Option<Blocker>,
    /// Light came through something.
    pub(super) is_filtered: bool,
}

impl Search for Nearest {
    const ANY: bool = false;

    #[inline(always)]
    fn record(walk: &mut Walk<'_, Self>, found: Found) -> ControlFlow<()> {
        if let Some((best, owner)) = &walk.search.best
            && found.t >= best.t
            && !walk.precedes(&found, best, *owner)
        {
            return ControlFlow::Continue(());
        }
        let Found { t, primitive, part, owner } = found;
        walk.search.best = Some((Hit { t, primitive, part, path: walk.path }, owner));
        walk.range.max = t.next_up();
        ControlFlow::Continue(())
    }
}

impl Search for All {
    const ANY: bool = false;

    fn record(walk: &mut Walk<'_, Self>, Found { t, primitive, part, .. }: Found) -> ControlFlow<()> {
        walk.search.hits.push(Hit { t, primitive, part, path: walk.path });
        ControlFlow::Continue(())
    }
}

impl Search for Blocking<'_> {
    const ANY: bool = true;

    #[inline(always)]
    fn record(walk: &mut Walk<'_, Self>, found: Found) -> ControlFlow<()> {
        let is_opaque = |opaque| walk.geometry.blocks_light(found.primitive, &walk.path, opaque);
        if walk.search.opaque.is_none_or(is_opaque) {
            return ControlFlow::Break(());
        }
        walk.search.is_filtered = true;
        ControlFlow::Continue(())
    }

    fn ended_by(&mut self, item: &Item, path: &Path) {
        self.blocker.get_or_insert(Blocker { item: *item, path: *path });
    }
}

impl<'a, S: Search> Walk<'a, S> {
    pub(super) fn new(
        geometry: &'a Geometry,
        ray: &'a Ray,
        range: Range,
        kind: RayKind,
        scratch: &'a mut Scratch,
        search: S,
    ) -> Self {
        Self { geometry, kind, mask: RayMask::of(kind), scratch, range, path: Path::default(), ray, search }
    }

    /// Passes by what surely blocks no light.
    pub(super) fn looks_for_blockers(&mut self) {
        self.mask = RayMask::of_blockers();
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

    /// Tries one item, wherever it stands; `ray` is in world space.
    pub(super) fn retry(&mut self, blocker: &Blocker, ray: &Ray) -> ControlFlow<()> {
        let mut local = *ray;
        for step in blocker.path.steps() {
            local = self.geometry.instances[*step].parent_from_group.inverse_ray(&local);
        }
        self.path = blocker.path;
        let flow = self.item(&blocker.item, &local);
        self.path = Path::default();
        flow
    }

    /// An item of a group; one that ends the search is noted.
    // Always inline, as what it calls: spheres are tried for less than a call costs.
    #[inline(always)]
    fn tried(&mut self, item: &Item, ray: &Ray) -> ControlFlow<()> {
        let flow = self.item(item, ray);
        if flow.is_break() {
            self.search.ended_by(item, &self.path);
        }
        flow
    }

    #[inline(always)]
    pub(super) fn item(&mut self, item: &Item, ray: &Ray) -> ControlFlow<()> {
        if item.hidden_from.intersects(self.mask) {
            return ControlFlow::Continue(());
        }
        match &item.kind {
            ItemKind::Sphere(sphere, primitive) => self.shape(sphere, *primitive, ray),
            ItemKind::Plane(plane, primitive) => self.shape(plane, *primitive, ray),
            ItemKind::Primitive(id) => self.primitive(*id, ray),
            ItemKind::Solid(root) => self.solid(*root, ray),
            ItemKind::Instance(id) => self.instance(*id, ray),
        }
    }

    /// A shape in the group's own space.
    #[inline(always)]
    fn shape(&mut self, shape: &impl Primitive, primitive: PrimitiveId, ray: &Ray) -> ControlFlow<()> {
        match shape.intersect(ray, self.range) {
            Some(hit) => {
                S::record(self, Found { t: hit.t, primitive, part: hit.part, owner: Owner::Primitive(primitive) })
            }
            None => ControlFlow::Continue(()),
        }
    }

    #[inline(never)]
    fn solid(&mut self, root: NodeId, ray: &Ray) -> ControlFlow<()> {
        match self.geometry.solid_nearest(root, ray, self.range, self.kind, S::ANY, self.scratch) {
            Some((hit, primitive)) => {
                S::record(self, Found { t: hit.t, primitive, part: hit.part, owner: Owner::Solid(root) })
            }
            None => ControlFlow::Continue(()),
        }
    }

    #[inline(never)]
    fn instance(&mut self, id: InstanceId, ray: &Ray) -> ControlFlow<()> {
        let instance = &self.geometry.instances[id];
        self.path.push(id);
        let geometry = self.geometry;
        let flow = self.group(&geometry.groups[instance.group], &instance.parent_from_group.inverse_ray(ray));
        self.path.pop();
        flow
    }

    #[inline(never)]
    fn primitive(&mut self, id: PrimitiveId, ray: &Ray) -> ControlFlow<()> {
        let primitive = &self.geometry.primitives[id];
        let moved;
        let ray = match &primitive.group_from_local {
            Some(place) => {
                moved = place.inverse_ray(ray);
                &moved
            }
            None => ray,
        };
        let owner = Owner::Primitive(id);
        if S::ANY {
            if primitive.shape.occluded(ray, self.range) {
                return S::record(self, Found { t: self.range.max, primitive: id, part: 0, owner });
            }
        } else if let Some(hit) = primitive.shape.intersect(ray, self.range) {
            return S::record(self, Found { t: hit.t, primitive: id, part: hit.part, owner });
        }
        ControlFlow::Continue(())
    }

    /// Whether the owner of one of two equally near hits comes first, as in POV-Ray (shape facts, section 13):
    /// what is infinite before what is not, then the object whose box the ray enters first, then by the file.
    #[cold]
    fn precedes(&self, found: &Found, best: &Hit, owner: Owner) -> bool {
        let (new, old) = (self.entry(found.owner, &self.path), self.entry(owner, &best.path));
        let by_file = (found.primitive, self.path.steps()) < (best.primitive, best.path.steps());
        new < old || (new == old && by_file)
    }

    /// The parameter at which the ray enters the box of an object.
    fn entry(&self, owner: Owner, path: &Path) -> f64 {
        let local = match owner {
            Owner::Primitive(i) => self.geometry.primitives[i].bounds(),
            Owner::Solid(i) => self.geometry.nodes[i].bounds,
        };
        if !local.is_finite() {
            return f64::NEG_INFINITY;
        }
        let outward = path.steps().iter().rev().map(|i| &self.geometry.instances[*i].parent_from_group);
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
