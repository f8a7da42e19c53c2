//! Pass 5, `build`: objects become items of groups and nodes of solids.
//!
//! Unions that nothing holds together are split; contents used more than once become shared
//! groups; everything else is written out in its group's space.

use super::census::{Census, Entry};
use super::height_field::GridKey;
use super::inherit::{Context, TextureParts};
use super::labels::Labeler;
use super::photon_targets::Targets;
use super::primitive::fold;
use super::quadric_reach::within;
use super::room::{extent, gap};
use crate::compile::function::Functions;
use crate::compiled::Table;
use crate::compiled::geometry::{
    Cuboid, Geometry, Group, GroupBuilder, GroupId, Instance, InteriorId, Item, ItemKind, LightGroupId,
    MAX_INSTANCE_DEPTH, MeshTree, Node, NodeId, NodeKind, ObjectId, Operation, Parent, Parts, PlacementId, Primitive,
    PrimitiveId, RayMask, Shape as Compiled, TextureId, convex_parts, padded,
};
use crate::diag::Diagnostic;
use crate::math::Bounds;
use crate::omission::{Keep, Ledger, Omission};
use crate::scene::{CsgOperation, Interior, Object, Shape, Texture};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Contents lighter than this are cheaper to copy than to reach through an instance.
const SHARED_WEIGHT: u64 = 6;

/// Whether contents used more than once can be built once, as far as the object that holds them decides.
pub(super) fn can_be_shared(facts: Entry, object: &Object, splits: bool) -> bool {
    let plain = splits || (object.rare.clipped_by.is_empty() && object.rare.bounded_by.is_empty());
    let movable = !facts.light_groups && !facts.placed_media && !facts.photon_targets;
    facts.uses > 1 && facts.weight >= SHARED_WEIGHT && movable && plain
}

/// A shared group, once it is built.
#[derive(Clone, Copy)]
struct Shared {
    group: GroupId,
    /// Instances inside each other, this one included.
    height: usize,
}

/// Everything under construction.
pub(super) struct Builder<'a> {
    pub(super) census: &'a Census,
    pub(super) functions: &'a Functions,
    pub(super) geometry: Geometry,
    pub(super) textures: Table<TextureId, Arc<Texture>>,
    pub(super) texture_ids: FxHashMap<*const Texture, TextureId>,
    pub(super) layered_ids: FxHashMap<TextureParts, TextureId>,
    pub(super) placement_ids: FxHashMap<(TextureId, [[u64; 3]; 4]), PlacementId>,
    /// Of textures where they were written, as most are.
    pub(super) unmoved_ids: FxHashMap<*const Texture, PlacementId>,
    pub(super) interiors: Table<InteriorId, Arc<Interior>>,
    pub(super) meshes: FxHashMap<*const crate::scene::Mesh, Arc<MeshTree>>,
    pub(super) height_grids: FxHashMap<GridKey, Arc<crate::compiled::geometry::HeightGrid>>,
    /// In the order in which they are met.
    pub(super) watched: Vec<super::watch::Watched>,
    /// By the object as it was first declared, which of them it is.
    pub(super) watched_ids: FxHashMap<*const crate::scene::Isosurface, usize>,
    pub(super) errors: Vec<Diagnostic>,
    pub(super) labeler: Labeler,
    /// What rays do not need.
    pub(super) ledger: Ledger,
    /// Sample rays of radiosity meet things, too.
    pub(super) with_radiosity: bool,
    /// At which photons are shot, if any are.
    pub(super) targets: Option<Targets>,
    default_interior: Arc<Interior>,
    shared: FxHashMap<(*const Arc<Object>, u8), Shared>,
    n_light_groups: u32,
}

impl<'a> Builder<'a> {
    /// With room for so many simple objects: most scenes of many objects have little else.
    pub(super) fn new(census: &'a Census, n_objects: usize, functions: &'a Functions, keep: Keep) -> Self {
        let geometry = Geometry {
            primitives: Table::with_capacity(n_objects),
            appearances: Table::with_capacity(n_objects),
            hollow: Table::with_capacity(n_objects),
            ..Geometry::default()
        };
        Self {
            census,
            functions,
            geometry,
            textures: Table::default(),
            texture_ids: FxHashMap::default(),
            layered_ids: FxHashMap::default(),
            placement_ids: FxHashMap::default(),
            unmoved_ids: FxHashMap::default(),
            interiors: Table::with_capacity(n_objects),
            meshes: FxHashMap::default(),
            height_grids: FxHashMap::default(),
            watched: Vec::new(),
            watched_ids: FxHashMap::default(),
            errors: Vec::new(),
            labeler: Labeler::default(),
            ledger: Ledger::new(keep),
            with_radiosity: false,
            targets: None,
            default_interior: Arc::default(),
            shared: FxHashMap::default(),
            n_light_groups: 0,
        }
    }

    /// Places frame-level objects, each with its default texture.
    pub(super) fn place_roots(&mut self, objects: &[(&Object, &Arc<Texture>)], split: bool, items: &mut GroupBuilder) {
        let mut around = Context::bare();
        let mut before: Option<&Arc<Texture>> = None;
        for (object, default) in objects {
            if before.is_none_or(|before| !Arc::ptr_eq(before, default)) {
                around.default_texture = Some(self.unmoved(default));
                around.default_ior = default.finish_ior();
                before = Some(default);
            }
            (around.interior, around.finish_ior) = (None, None);
            self.place_frame(object, &mut around, split, items);
        }
    }

    /// An object at frame level, or a member of a light group: owns an interior.
    fn place_frame(&mut self, object: &Object, around: &mut Context, split: bool, items: &mut GroupBuilder) {
        self.labeler.begin(object);
        if matches!(object.shape, Shape::LightGroup { .. }) {
            around.finish_ior = self.last_finish_ior(object, around);
        } else if object.interior.is_none() {
            let default = Arc::clone(&self.default_interior);
            around.interior = Some(self.interior(&default, object, around));
        }
        self.place(object, around, split, items, &mut 0);
    }

    /// Places an object in a group. `height` grows to that of the instances inside.
    fn place(&mut self, object: &Object, around: &Context, split: bool, items: &mut GroupBuilder, height: &mut usize) {
        let outer = self.labeler.enter(object);
        self.place_kind(object, around, split, items, height);
        self.labeler.leave(outer);
    }

    /// The same, by its kind.
    fn place_kind(
        &mut self,
        object: &Object,
        around: &Context,
        split: bool,
        items: &mut GroupBuilder,
        height: &mut usize,
    ) {
        match &object.shape {
            Shape::LightSource(light) => {
                if let Some(looks) = &light.looks_like {
                    let around = Context { no_shadow: true, ..around.clone() };
                    roomy(|| self.place(looks, &around, split, items, height));
                }
            }
            Shape::LightGroup { children, .. } => {
                let mut inside = self.enter(object, around);
                inside.light_group = Some(LightGroupId::new(self.n_light_groups));
                self.n_light_groups += 1;
                for child in children.iter() {
                    roomy(|| self.place_frame(child, &mut inside.clone(), split, items));
                }
            }
            Shape::Csg { children, .. } => {
                let inside = self.enter(object, around);
                let splits = split && object.splits() && !inside.turned;
                if self.place_shared(object, children, &inside, splits, items, height) {
                    return;
                }
                if splits {
                    for child in children.iter() {
                        roomy(|| self.place(child, &inside, split, items, height));
                    }
                } else {
                    self.place_solid(object, around, items);
                }
            }
            _ if object.rare.clipped_by.is_empty() && !is_bounded(object) => {
                let inside = self.enter(object, around);
                let id = self.labeler.object_id();
                if let Some(primitive) = self.primitive(object, &inside, id) {
                    self.push_primitive(primitive, &inside, items);
                }
            }
            _ => self.place_solid(object, around, items),
        }
    }

    /// Whether any ray sees an object, or it is kept although none does.
    fn is_wanted(&mut self, hidden_from: RayMask) -> bool {
        !hidden_from.is_all(self.with_radiosity) || !self.ledger.omits(Omission::HiddenObjects, size_of::<Item>())
    }

    fn push_primitive(&mut self, id: PrimitiveId, inside: &Context, items: &mut GroupBuilder) {
        let hidden_from = inside.hidden_from();
        if !self.is_wanted(hidden_from) {
            return;
        }
        let primitive = &self.geometry.primitives[id];
        let kind = match (&primitive.shape, &primitive.group_from_local) {
            (Compiled::Sphere(sphere), None) => ItemKind::Sphere(*sphere, id),
            (Compiled::Plane(plane), None) => ItemKind::Plane(*plane, id),
            _ => ItemKind::Primitive(id),
        };
        items.push(Item { kind, hidden_from }, &primitive.bounds());
    }

    fn place_solid(&mut self, object: &Object, around: &Context, items: &mut GroupBuilder) {
        let id = self.labeler.object_id();
        let root = self.geometry.nodes.next_handle();
        if self.node(object, around, id, true).is_some() {
            self.screen(root, object, around);
            self.link(root);
            let node = &self.geometry.nodes[root];
            let hidden_from = node.hidden_from;
            let mut bounds = node.bounds;
            if !self.is_wanted(hidden_from) {
                return;
            }
            if bounds.is_empty() {
                if self.ledger.omits(Omission::EmptySolids, size_of::<Item>()) {
                    return;
                }
                bounds = Bounds::INFINITE;
            }
            items.push(Item { kind: ItemKind::Solid(root), hidden_from }, &bounds);
        }
    }

    /// Leaves the rays that miss POV-Ray's box of a solid with nothing, where that box may be too small: a height field
    /// is solid below its own.
    fn screen(&mut self, root: NodeId, object: &Object, around: &Context) {
        let Geometry { nodes, primitives, .. } = &mut self.geometry;
        let is_field = |node: &Node| {
            let NodeKind::Primitive(p) = node.kind else { return false };
            matches!(primitives[p].shape, Compiled::HeightField(_))
        };
        if !nodes.handles_from(root).any(|id| is_field(&nodes[id])) {
            return;
        }
        let screen = padded(around.group_from_parent.bounds(&super::extent::extent(object)));
        let screen = match nodes[root].kind {
            NodeKind::Primitive(p) => within(&primitives[p], &screen, true),
            NodeKind::Csg { .. } => screen,
        };
        if !screen.is_finite() {
            return;
        }
        let screening = primitives.push(Primitive {
            shape: Compiled::Cuboid(Cuboid { min: screen.min, max: screen.max }),
            group_from_local: None,
            inverse: false,
            uv_from_group: None,
            appearance: nodes[root].appearance,
        });
        let kind = NodeKind::Primitive(screening);
        let bound = nodes.push(Node { kind, bounds: screen, extent: screen, ..Node::placeholder() });
        let bounded_by = &mut nodes[root].bounded_by;
        *bounded_by = bounded_by.iter().copied().chain([bound]).collect();
    }

    /// Tells the nodes of a solid what they are parts of.
    fn link(&mut self, root: NodeId) {
        let nodes = &mut self.geometry.nodes;
        // What is around a node stands before it.
        for id in nodes.handles_from(root) {
            nodes[id].is_reversed ^= nodes[id].flips;
            let is_reversed = nodes[id].is_reversed != nodes[id].reverses();
            for position in 0..nodes[id].children().len() {
                let child = nodes[id].children()[position];
                nodes[child].parent = Some(Parent { node: id, position: position as u32 });
                nodes[child].is_reversed = is_reversed;
            }
        }
        self.geometry.nodes[root].convex_parts = convex_parts(root, &self.geometry.nodes, &self.geometry.primitives);
    }

    /// Places CSG contents as an instance if they are used often enough; whether it did.
    fn place_shared(
        &mut self,
        object: &Object,
        children: &Arc<[Arc<Object>]>,
        inside: &Context,
        splits: bool,
        items: &mut GroupBuilder,
        height: &mut usize,
    ) -> bool {
        if !can_be_shared(self.census.of(children), object, splits) || inside.cutaway || inside.turned {
            return false;
        }
        let Shape::Csg { operation, .. } = &object.shape else { return false };
        let key = (children.as_ptr(), if splits { u8::MAX } else { *operation as u8 });
        let shared = match self.shared.get(&key) {
            Some(shared) => *shared,
            None => {
                let shared = self.build_shared(object, children, splits);
                self.shared.insert(key, shared);
                shared
            }
        };
        if shared.height > MAX_INSTANCE_DEPTH {
            return false;
        }
        *height = (*height).max(shared.height);
        let id = self.labeler.object_id();
        let appearance = self.add_appearance(inside.appearance(id));
        let parent_from_group = inside.group_from_parent;
        let bounds = padded(parent_from_group.bounds(&self.geometry.groups[shared.group].bounds));
        let instance = self.geometry.instances.push(Instance { group: shared.group, parent_from_group, appearance });
        if self.is_wanted(inside.hidden_from()) {
            items.push(Item { kind: ItemKind::Instance(instance), hidden_from: inside.hidden_from() }, &bounds);
        }
        true
    }

    /// Builds contents once, as they are without anything around them.
    fn build_shared(&mut self, object: &Object, children: &Arc<[Arc<Object>]>, splits: bool) -> Shared {
        let mut items = GroupBuilder::with_capacity(0);
        let mut height = 0;
        if splits {
            for child in children.iter() {
                roomy(|| self.place(child, &Context::bare(), true, &mut items, &mut height));
            }
        } else {
            let bare = Object { flags: Default::default(), ..Object::new(object.shape.clone(), object.span) };
            self.place_solid(&bare, &Context::bare(), &mut items);
        }
        let group = self.geometry.groups.push(Group::new(items));
        Shared { group, height: height + 1 }
    }

    /// Builds an object as a part of a solid; `None` for what has no surface.
    fn node(&mut self, object: &Object, around: &Context, id: ObjectId, is_root: bool) -> Option<NodeId> {
        roomy(|| self.whole_node(object, around, id, is_root))
    }

    fn whole_node(&mut self, object: &Object, around: &Context, id: ObjectId, is_root: bool) -> Option<NodeId> {
        if let Shape::LightSource(light) = &object.shape {
            let looks = light.looks_like.clone()?;
            return self.node(&looks, &Context { no_shadow: true, ..around.clone() }, id, is_root);
        }
        let mut inside = self.enter(object, around);
        let own = self.geometry.nodes.push(Node::placeholder());
        let mut node = Node { hidden_from: inside.hidden_from(), ..Node::placeholder() };
        match &object.shape {
            Shape::Csg { operation, children } => {
                if is_root && self.cuts_away(object, &inside) {
                    inside.cutaway_root = Some(own);
                }
                node.appearance = self.add_appearance(Context { cutaway_root: None, ..inside.clone() }.appearance(id));
                self.combine(*operation, children, &inside, id, &mut node);
            }
            Shape::LightGroup { children, .. } => {
                inside.light_group = Some(LightGroupId::new(self.n_light_groups));
                self.n_light_groups += 1;
                node.appearance = self.add_appearance(inside.appearance(id));
                self.combine(CsgOperation::Union, children, &inside, id, &mut node);
            }
            _ => {
                let primitive = self.primitive(object, &inside, id)?;
                let compiled = &self.geometry.primitives[primitive];
                node.appearance = compiled.appearance;
                node.bounds = compiled.bounds();
                node.extent = extent(compiled);
                node.gap = gap(compiled);
                node.kind = NodeKind::Primitive(primitive);
            }
        }
        // Clips and bounds stand in the space around the object and keep their own inversions.
        let clip_context = Context { group_from_parent: around.group_from_parent, ..Context::bare() };
        node.clips = object.rare.clipped_by.iter().filter_map(|o| self.part(o, &clip_context, id)).collect();
        if (!is_root || keeps_bounds(&object.shape)) && !object.flags.bounds_are_clips {
            node.bounded_by =
                object.rare.bounded_by.iter().filter_map(|o| self.node(o, &clip_context, id, false)).collect();
        }
        if !node.clips.is_empty() || !node.bounded_by.is_empty() {
            node.nesting = 0;
        }
        for clip in &node.clips {
            let clip = &self.geometry.nodes[*clip];
            node.bounds = node.bounds.intersection(&clip.extent);
            node.extent = node.extent.intersection(&clip.extent);
            node.gap = node.gap.union(&clip.gap);
        }
        if !node.clips.is_empty()
            && let NodeKind::Primitive(p) = node.kind
        {
            let primitive = &self.geometry.primitives[p];
            node.bounds = within(primitive, &node.bounds, true);
            node.extent = within(primitive, &node.extent, false);
        }
        super::half_spaces::tighten(&self.geometry, &mut node);
        if is_root && let Some(shrunken) = super::extent::shrunken(object) {
            let place = &around.group_from_parent;
            node.bounds = node.bounds.intersection(&padded(place.bounds(&shrunken)));
        }
        self.geometry.nodes[own] = node;
        self.replace_by_single_part(own, &inside);
        Some(own)
    }

    /// Puts the only part of a solid in its place.
    fn replace_by_single_part(&mut self, own: NodeId, inside: &Context) {
        let nodes = &mut self.geometry.nodes;
        let node = &nodes[own];
        let &[only] = node.children() else { return };
        let is_plain = node.clips.is_empty() && node.bounded_by.is_empty() && !inside.cutaway;
        if !is_plain
            || nodes[only].hidden_from != node.hidden_from
            || !self.ledger.omits(Omission::SinglePartSolids, size_of::<Node>())
        {
            return;
        }
        let part = std::mem::replace(&mut nodes[only], Node::placeholder());
        let node = &nodes[own];
        let Node { bounds, extent, gap, appearance, .. } = *node;
        let flips = part.flips != node.reverses();
        nodes[own] = Node { bounds, extent, gap, appearance, flips, ..part };
    }

    /// Builds an object whose inside counts. What has no surface is mostly nowhere, or everywhere when inverted.
    fn part(&mut self, object: &Object, around: &Context, id: ObjectId) -> Option<NodeId> {
        let built = self.node(object, around, id, false);
        if built.is_some() || matches!(object.shape, Shape::LightSource(_)) {
            return built;
        }
        let inside = self.enter(object, around);
        let appearance = self.add_appearance(inside.appearance(id));
        // The union of no parts has no inside, their intersection is everywhere.
        let mut node = Node { appearance, ..Node::placeholder() };
        let inverse = inside.inverse && !is_patch(&object.shape);
        if let (true, NodeKind::Csg { operation, .. }) = (inverse != is_everywhere(&object.shape), &mut node.kind) {
            *operation = Operation::Intersection;
            (node.extent, node.gap) = (Bounds::INFINITE, Bounds::EMPTY);
        }
        Some(self.geometry.nodes.push(node))
    }

    /// The part of a box that a node's surface, or its surface and inside, can reach.
    fn reach(&self, node: NodeId, around: &Bounds, surface_only: bool) -> Bounds {
        match self.geometry.nodes[node].kind {
            NodeKind::Primitive(p) => within(&self.geometry.primitives[p], around, surface_only),
            NodeKind::Csg { .. } => *around,
        }
    }

    /// Whether cut faces of a solid look for textures: only where there is one to find.
    fn cuts_away(&self, object: &Object, inside: &Context) -> bool {
        inside.cutaway && inside.texture.is_none() && self.census.textured(object)
    }

    /// Builds children and what they combine to. An inverted union is the intersection of inverted
    /// children, and the other way round; a difference is the intersection of its first child with
    /// the inverted others.
    fn combine(
        &mut self,
        operation: CsgOperation,
        children: &Arc<[Arc<Object>]>,
        inside: &Context,
        id: ObjectId,
        node: &mut Node,
    ) {
        let compiled = match (operation, inside.inverse) {
            (CsgOperation::Union, false) if !inside.turned => Operation::Union,
            // A union that was turned inside out and back has become a merge.
            (CsgOperation::Union | CsgOperation::Merge, false)
            | (CsgOperation::Intersection | CsgOperation::Difference, true) => Operation::Merge,
            _ => Operation::Intersection,
        };
        let mut around = inside.clone();
        // Children of unions and merges get the default texture even where cut faces look for one.
        if compiled != Operation::Intersection {
            around.cutaway_root = None;
        }
        let mut built = Vec::new();
        // Around what all parts so far leave.
        let mut left = Bounds::INFINITE;
        for (i, child) in children.iter().enumerate() {
            let before = self.mark();
            let is_cut = operation == CsgOperation::Difference && i > 0;
            around.inverse = inside.inverse != is_cut;
            around.turned = inside.turned || is_cut;
            let root = inside.cutaway_root;
            // Deeper intersections look for textures again.
            if matches!(&child.shape, Shape::Csg { operation, .. } if *operation as u8 >= CsgOperation::Intersection as u8)
            {
                around.cutaway_root = root;
            } else if compiled != Operation::Intersection {
                around.cutaway_root = None;
            }
            let part = match compiled {
                Operation::Union => self.node(child, &around, id, false),
                Operation::Merge | Operation::Intersection => self.part(child, &around, id),
            };
            if let Some(part) = part
                && compiled == Operation::Intersection
            {
                let (part, bytes) = (&self.geometry.nodes[part], self.bytes_since(before));
                // All that it takes away lies apart from what is there.
                if part.gap.intersection(&left).is_empty()
                    && !inside.cutaway
                    && self.ledger.omits(Omission::IdleParts, bytes)
                {
                    self.forget_since(before);
                    continue;
                }
                left = left.intersection(&part.extent);
            }
            built.extend(part);
        }
        if compiled == Operation::Intersection && !inside.cutaway {
            node.nesting = self.flatten(&mut built);
        }
        let nodes = &self.geometry.nodes;
        let hull = |f: fn(&Node) -> Bounds| built.iter().fold(Bounds::EMPTY, |sum, n| sum.union(&f(&nodes[*n])));
        node.bounds = hull(|n| n.bounds);
        if compiled == Operation::Intersection {
            let common = |skip: usize| {
                let others = built.iter().enumerate().filter(|(i, _)| *i != skip);
                others.fold(Bounds::INFINITE, |b, (_, n)| b.intersection(&nodes[*n].extent))
            };
            let inside = |n: NodeId, around: Bounds| self.reach(n, &around, false);
            node.extent = built.iter().fold(common(usize::MAX), |around, n| inside(*n, around));
            // A child's surface survives only inside the others; quadratic, so only for a few.
            if built.len() <= 16 {
                node.bounds = built.iter().enumerate().fold(Bounds::EMPTY, |sum, (i, n)| {
                    let around = nodes[*n].bounds.intersection(&common(i)).intersection(&node.extent);
                    sum.union(&self.reach(*n, &around, true))
                });
            } else {
                // Whatever survives lies on a child or inside of it.
                let reaches = built.iter().map(|n| nodes[*n].bounds.union(&nodes[*n].extent));
                node.bounds = reaches.fold(node.bounds, |sum, reach| sum.intersection(&reach));
            }
            node.gap = hull(|n| n.gap);
        } else {
            node.extent = hull(|n| n.extent);
            node.gap = built.iter().fold(Bounds::INFINITE, |gap, n| gap.intersection(&nodes[*n].gap));
        }
        let boxes = |f: fn(&Node) -> Bounds| built.iter().map(|n| f(&nodes[*n])).collect::<Vec<_>>();
        let says = boxes(if compiled == Operation::Intersection { |n| n.gap } else { |n| n.extent });
        let confines = |i: &u32| self.geometry.confines(built[*i as usize]);
        let confining = match compiled {
            Operation::Intersection => (0..built.len() as u32).filter(confines).collect(),
            Operation::Union | Operation::Merge => Box::default(),
        };
        node.kind = NodeKind::Csg {
            operation: compiled,
            confining,
            parts: Parts::new(&boxes(|n| n.bounds), &says),
            children: built.into(),
            is_difference: operation == CsgOperation::Difference && !inside.inverse,
        };
    }

    /// Takes intersections apart that stand deep in each other, so that a hierarchy finds their parts; how deep they still
    /// stand then, with the one around these parts.
    fn flatten(&mut self, built: &mut Vec<NodeId>) -> u8 {
        /// Up to here going down is as good.
        const DEEPEST: u8 = 8;
        let nesting = |builder: &Self, part: &NodeId| builder.geometry.nodes[*part].nesting;
        let deepest = built.iter().map(|part| nesting(self, part)).max().unwrap_or(0);
        if deepest < DEEPEST {
            return deepest + 1;
        }
        let mut parts = Vec::new();
        self.take_apart(built, &mut parts);
        for (part, is_reversed) in &parts {
            // The intersection around them reverses each once.
            self.geometry.nodes[*part].flips ^= !is_reversed;
        }
        *built = parts.into_iter().map(|(part, _)| part).collect();
        1
    }

    /// The parts of an intersection, those of intersections among them, in the order in which their crossings are taken,
    /// each with whether its own are taken in reverse.
    fn take_apart(&mut self, children: &[NodeId], parts: &mut Vec<(NodeId, bool)>) {
        for child in children {
            let nodes = &mut self.geometry.nodes;
            if nodes[*child].nesting == 0 {
                parts.push((*child, true));
                continue;
            }
            let inner = std::mem::replace(&mut nodes[*child], Node::placeholder());
            let first = parts.len();
            self.take_apart(inner.children(), parts);
            if !inner.flips {
                parts[first..].reverse();
                parts[first..].iter_mut().for_each(|(_, is_reversed)| *is_reversed ^= true);
            }
        }
    }

    /// How far the parts of solids have come.
    fn mark(&self) -> (NodeId, PrimitiveId) {
        (self.geometry.nodes.next_handle(), self.geometry.primitives.next_handle())
    }

    /// The memory of what was added since.
    fn bytes_since(&self, (node, primitive): (NodeId, PrimitiveId)) -> usize {
        let Geometry { nodes, primitives, .. } = &self.geometry;
        nodes.handles_from(node).count() * size_of::<Node>()
            + primitives.handles_from(primitive).count() * size_of::<Primitive>()
    }

    fn forget_since(&mut self, (node, primitive): (NodeId, PrimitiveId)) {
        self.geometry.nodes.truncate(node);
        self.geometry.primitives.truncate(primitive);
    }

    /// Adds the primitive of an object; `None` with a message, or silently where nothing shows.
    fn primitive(&mut self, object: &Object, inside: &Context, id: ObjectId) -> Option<PrimitiveId> {
        let mut inverse = inside.inverse && !is_patch(&object.shape);
        let folded = match super::freeform::convert(self, object, inside) {
            Some(converted) => converted?,
            None => fold(&object.shape, inside.group_from_parent, &mut inverse)?,
        };
        let appearance = self.add_appearance(inside.appearance(id));
        Some(self.geometry.primitives.push(Primitive {
            shape: folded.shape,
            group_from_local: folded.group_from_local.map(Box::new),
            inverse,
            uv_from_group: folded.uv_from_group.map(Box::new),
            appearance,
        }))
    }
}

/// Shapes at frame level whose `bounded_by` POV-Ray tests ray by ray; of others it keeps the box only.
fn keeps_bounds(shape: &Shape) -> bool {
    matches!(shape, Shape::Csg { .. } | Shape::Polynomial { .. } | Shape::Text(_) | Shape::Quadric { .. })
}

/// Whether bounds hide something of a primitive at frame level.
fn is_bounded(object: &Object) -> bool {
    let has_bounds = !object.rare.bounded_by.is_empty() && !object.flags.bounds_are_clips;
    has_bounds && (keeps_bounds(&object.shape) || super::extent::shrunken(object).is_some())
}

/// Whether an equation without a variable holds: all points are inside.
fn is_everywhere(shape: &Shape) -> bool {
    match shape {
        Shape::Quadric { constant, .. } => *constant <= 0.0,
        Shape::Polynomial { coefficients, .. } => coefficients.iter().all(|c| *c == 0.0),
        _ => false,
    }
}

/// Surfaces without an inside, on which `inverse` has no effect.
pub(super) fn is_patch(shape: &Shape) -> bool {
    match shape {
        Shape::Triangle { .. }
        | Shape::SmoothTriangle(_)
        | Shape::Polygon { .. }
        | Shape::BicubicPatch(_)
        | Shape::Parametric(_) => true,
        Shape::Mesh(mesh) => mesh.inside_vector.is_none(),
        _ => false,
    }
}
