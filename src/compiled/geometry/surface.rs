//! From a hit to everything about the place, for the winner alone.

use super::Geometry;
use super::graph::{Appearance, Group, Item, ItemKind, NodeKind, Operation, Primitive};
use super::record::{Hit, InteriorKey, Path, Surface, TexturePlace, TextureRef};
use super::shape::{LocalSurface, Primitive as _, Shape};
use crate::compiled::handle::{
    AppearanceId, GroupId, Handle as _, InstanceId, NodeId, ObjectId, PlacementId, PrimitiveId, Table, TextureId,
};
use crate::compiled::photons::PhotonRole;
use crate::math::{DVec2, DVec3, Ray, Transform, Uv, transformed_point_error};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::borrow::Cow;

/// The appearance gathered on the way from a primitive to the world.
struct Inherited<'a> {
    appearance: Cow<'a, Appearance>,
    depths: Depths,
}

/// Where each part of an appearance was found: the number of instances around the object that gave it.
#[derive(Clone, Copy, Default)]
struct Depths {
    texture: u8,
    interior_texture: u8,
    interior: u8,
}

/// Takes from what contains it what an appearance lacks (shape facts, section 12.2).
fn inherit(appearance: &mut Appearance, depths: &mut Depths, outer: &Appearance, depth: u8) {
    // The odd rule of POV-Ray: one of the two missing is enough.
    if outer.uv_mapping && (appearance.texture.is_none() || appearance.interior_texture.is_none()) {
        appearance.uv_mapping = true;
    }
    if appearance.texture.is_none() && outer.texture.is_some() {
        (appearance.texture, depths.texture) = (outer.texture, depth);
    }
    if appearance.interior_texture.is_none() && outer.interior_texture.is_some() {
        (appearance.interior_texture, depths.interior_texture) = (outer.interior_texture, depth);
    }
    if appearance.interior.is_none() && outer.interior.is_some() {
        (appearance.interior, depths.interior) = (outer.interior, depth);
    }
    appearance.double_illuminate = outer.double_illuminate.or(appearance.double_illuminate);
    appearance.object = outer.object;
    appearance.light_group = outer.light_group.or(appearance.light_group);
    appearance.importance = appearance.importance.or(outer.importance);
    appearance.photons = appearance.photons.or(outer.photons);
}

impl Inherited<'_> {
    /// Identity of the interior that was found.
    #[inline]
    fn interior_key(&self, path: &Path) -> InteriorKey {
        InteriorKey {
            interior: self.appearance.interior.unwrap_or_default(),
            instance: instance_number(&path.steps()[..usize::from(self.depths.interior)]),
        }
    }
}

impl Geometry {
    /// The interior of an appearance, with the frame-level object.
    pub(super) fn interior_of(&self, appearance: AppearanceId, path: &Path) -> Option<(ObjectId, InteriorKey)> {
        let inherited = self.appearance_of(appearance, path);
        inherited.appearance.interior.map(|_| (inherited.appearance.object, inherited.interior_key(path)))
    }

    /// What a surface says about photons.
    pub fn photon_role(&self, surface: &Surface) -> PhotonRole {
        surface.photons.map_or_else(PhotonRole::default, |id| self.photon_roles[id])
    }

    /// Whether fog and media outside also fill an interior's object.
    pub fn is_hollow(&self, key: InteriorKey) -> bool {
        self.hollow.get(key.interior).copied().unwrap_or(false)
    }

    /// Whether what was hit surely lets no light through, by [`opaque`](Self::shadow) textures.
    pub fn blocks(&self, hit: &Hit, opaque: &Table<TextureId, bool>) -> bool {
        self.blocks_light(hit.primitive, &hit.path, opaque)
    }

    /// Whether all textures that may show on a primitive are among those marked in `opaque`.
    ///
    /// Where only the [`surface`](Self::surface) could say, `false`.
    pub(super) fn blocks_light(&self, primitive: PrimitiveId, path: &Path, opaque: &Table<TextureId, bool>) -> bool {
        let primitive = &self.primitives[primitive];
        let inherited = self.appearance_of(primitive.appearance, path);
        let appearance = &inherited.appearance;
        let is_opaque = |texture: TextureId| opaque.get(texture).copied().unwrap_or(false);
        let own_block = match &primitive.shape {
            Shape::Blob(blob) => !blob.has_textures,
            Shape::Mesh(mesh) => mesh.tree.own_textures().iter().all(|texture| is_opaque(*texture)),
            _ => true,
        };
        let blocks = |placement: PlacementId| self.placements.get(placement).is_some_and(|p| is_opaque(p.texture));
        own_block
            && (appearance.texture.is_some_and(blocks) && appearance.cutaway.is_none() || appearance.cut_is_opaque)
            && appearance.interior_texture.is_none_or(blocks)
    }

    /// Notes which cuts through solids let no light through, whichever of the parts' textures show there.
    pub(crate) fn learn_opacity(&mut self, opaque: &Table<TextureId, bool>) {
        let mut known = FxHashMap::default();
        for i in 0..self.appearances.len() {
            let id = AppearanceId::at(i);
            let Appearance { cutaway: Some(root), texture: None, .. } = self.appearances[id] else { continue };
            let is_opaque = *known.entry(root).or_insert_with(|| self.parts_block(root, opaque));
            self.appearances[id].cut_is_opaque = is_opaque;
        }
        if opaque.iter().any(|is_opaque| !is_opaque) {
            self.hide_clear_items(opaque);
        }
    }

    /// Hides what surely blocks no light from rays that look for blockers.
    fn hide_clear_items(&mut self, opaque: &Table<TextureId, bool>) {
        let is_clear = |item: &Item| match item.kind {
            ItemKind::Sphere(_, p) | ItemKind::Plane(_, p) | ItemKind::Primitive(p) => self.is_clear(p, opaque),
            ItemKind::Solid(root) => self.parts_are_clear(root, opaque),
            // What its parts inherit is not known here.
            ItemKind::Instance(_) => false,
        };
        let marked = |items: &[Item]| -> Vec<Item> {
            let mark = |item: &Item| Item { hidden_from: item.hidden_from.with_blockers(is_clear(item)), ..*item };
            items.iter().map(mark).collect()
        };
        let of_group = |group: &Group| (marked(&group.items), marked(&group.infinite));
        let root = of_group(&self.root);
        let groups: Vec<_> = self.groups.iter().map(of_group).collect();
        (self.root.items, self.root.infinite) = root;
        for (i, (items, infinite)) in groups.into_iter().enumerate() {
            let group = &mut self.groups[GroupId::at(i)];
            (group.items, group.infinite) = (items, infinite);
        }
    }

    /// Whether a primitive has a texture of its own that may let light through, so that nothing of it
    /// [blocks](Self::blocks_light), whatever is around it.
    fn is_clear(&self, primitive: PrimitiveId, opaque: &Table<TextureId, bool>) -> bool {
        let appearance = &self.appearances[self.primitives[primitive].appearance];
        let lets_through = |placement: PlacementId| !opaque[self.placements[placement].texture];
        !appearance.cut_is_opaque && appearance.texture.is_some_and(lets_through)
    }

    /// Whether that holds for all parts of a solid.
    fn parts_are_clear(&self, node: NodeId, opaque: &Table<TextureId, bool>) -> bool {
        match &self.nodes[node].kind {
            NodeKind::Primitive(p) => self.is_clear(*p, opaque),
            NodeKind::Csg { children, .. } => roomy(|| children.iter().all(|c| self.parts_are_clear(*c, opaque))),
        }
    }

    /// Whether the textures of all parts of a solid let no light through.
    fn parts_block(&self, node: NodeId, opaque: &Table<TextureId, bool>) -> bool {
        match &self.nodes[node].kind {
            NodeKind::Primitive(p) => {
                let texture = self.appearances[self.primitives[*p].appearance].texture;
                texture.is_none_or(|placement| opaque.get(self.placements[placement].texture).is_some_and(|o| *o))
            }
            NodeKind::Csg { children, .. } => roomy(|| children.iter().all(|child| self.parts_block(*child, opaque))),
        }
    }

    /// The full record of a hit that [`intersect`](Self::intersect) gave for the same ray.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let primitive = &self.primitives[hit.primitive];
        let group_from_local = primitive.group_from_local.as_deref();
        // Step by step, as the ray came and the next one will go: so the bound of errors is theirs.
        let places = || hit.path.steps().iter().map(|step| &self.instances[*step].parent_from_group);
        let mut local_ray = *ray;
        for place in places().chain(group_from_local) {
            local_ray = place.inverse_ray(&local_ray);
        }
        let mut found = primitive.shape.surface(&local_ray, hit.t, hit.part);
        if primitive.inverse {
            found.normal = -found.normal;
            found.shading_normal = found.shading_normal.map(|n| -n);
        }
        let (local_point, uv) = (found.point, found.uv);
        if let Some(place) = group_from_local {
            found.carry(place);
        }
        let group_point = found.point;
        for place in places().rev() {
            found.carry(place);
        }
        let point = found.point;
        let geometric_normal = found.normal.try_normalize().unwrap_or(-ray.direction);
        let normal = found.shading_normal.and_then(DVec3::try_normalize).unwrap_or(geometric_normal);
        let from_inside = normal.dot(ray.direction) > 0.0;

        let inherited = self.appearance_of(primitive.appearance, &hit.path);
        let appearance: &Appearance = &inherited.appearance;
        let interior = inherited.interior_key(&hit.path);
        Surface {
            point,
            point_error: found.error + crate::math::gamma(2) * point.abs().max_element(),
            retreat: ray.direction * -found.depth,
            geometric_normal,
            normal,
            uv: uv_of(primitive, uv, [local_point, group_point, point]),
            from_inside,
            textures: self.textures_of(primitive, &inherited, hit, from_inside, (local_point, group_point)),
            uv_mapping: appearance.uv_mapping,
            interior,
            hollow: self.is_hollow(interior),
            double_illuminate: appearance.double_illuminate.unwrap_or(false),
            object: appearance.object,
            light_group: appearance.light_group,
            importance: appearance.importance,
            photons: appearance.photons,
        }
    }

    /// Takes world space to the space in which a texture of a hit was written; `room` holds it where it must be made.
    pub fn texture_from_world<'s>(
        &'s self,
        hit: &Hit,
        seen: &TextureRef,
        room: &'s mut Option<Transform>,
    ) -> &'s Transform {
        let local_from_world = || {
            let primitive = &self.primitives[hit.primitive];
            let local = primitive.group_from_local.as_deref().copied().unwrap_or_default();
            let world = self.world_from(&hit.path, hit.path.steps().len()).unwrap_or_default();
            local.then_once(&world).inverse()
        };
        match seen.place {
            TexturePlace::Placement { id, depth } => {
                let placement = self.placements[id].texture_from_group.as_deref().unwrap_or(&Transform::IDENTITY);
                match self.world_from(&hit.path, depth.into()) {
                    None => placement,
                    Some(world_from_group) => room.insert(world_from_group.inverse().then_once(placement)),
                }
            }
            TexturePlace::Shape => room.insert(local_from_world()),
            TexturePlace::Component(i) => {
                let own = match &self.primitives[hit.primitive].shape {
                    Shape::Blob(blob) => {
                        blob.parts[i as usize].texture.map(|(_, component_from_blob)| component_from_blob)
                    }
                    _ => None,
                };
                room.insert(local_from_world().then_once(&own.unwrap_or_default()))
            }
        }
    }

    /// Takes the space inside the first `depth` instances of a path to the world; `None` for none.
    #[inline]
    fn world_from(&self, path: &Path, depth: usize) -> Option<Transform> {
        path.steps()[..depth]
            .iter()
            .rev()
            .map(|i| self.instances[*i].parent_from_group)
            .reduce(|inner, outer| inner.then_once(&outer))
    }

    /// An appearance with all that it inherits through the instances around it.
    #[inline(always)]
    fn appearance_of(&self, appearance: AppearanceId, path: &Path) -> Inherited<'_> {
        let own = &self.appearances[appearance];
        match path.steps() {
            [] => Inherited { appearance: Cow::Borrowed(own), depths: Depths::default() },
            steps => self.inherited(*own, steps),
        }
    }

    /// The same inside some instances.
    fn inherited(&self, mut appearance: Appearance, steps: &[InstanceId]) -> Inherited<'_> {
        let depth = steps.len() as u8;
        let mut depths = Depths { texture: depth, interior_texture: depth, interior: depth };
        for (step, depth) in steps.iter().zip(0..depth).rev() {
            let outer = &self.appearances[self.instances[*step].appearance];
            inherit(&mut appearance, &mut depths, outer, depth);
        }
        Inherited { appearance: Cow::Owned(appearance), depths }
    }

    /// Which textures show at a hit; `points` are the local and the group's coordinates.
    #[inline]
    fn textures_of(
        &self,
        primitive: &Primitive,
        inherited: &Inherited<'_>,
        hit: &Hit,
        from_inside: bool,
        points: (DVec3, DVec3),
    ) -> SmallVec<[TextureRef; 1]> {
        let appearance = &inherited.appearance;
        let of_parts = matches!(&primitive.shape, Shape::Blob(_) | Shape::Mesh(_));
        if of_parts || appearance.cutaway.is_some() || (from_inside && appearance.interior_texture.is_some()) {
            return self.textures_of_parts(primitive, inherited, hit, from_inside, points);
        }
        // By far the most: one texture for the whole object.
        let mut textures = SmallVec::new();
        if let Some(texture) = appearance.texture {
            textures.push(self.placed(texture, 1.0, inherited.depths.texture));
        }
        textures
    }

    /// The same where the side, the part or the place may decide.
    fn textures_of_parts(
        &self,
        primitive: &Primitive,
        inherited: &Inherited<'_>,
        hit: &Hit,
        from_inside: bool,
        (point_local, point_group): (DVec3, DVec3),
    ) -> SmallVec<[TextureRef; 1]> {
        let appearance = &inherited.appearance;
        let whole =
            |weight: f32| appearance.texture.map(|texture| self.placed(texture, weight, inherited.depths.texture));
        let mixes = matches!(&primitive.shape, Shape::Blob(blob) if blob.has_textures);
        if from_inside
            && !mixes
            && let Some(placement) = appearance.interior_texture
        {
            return smallvec::smallvec![self.placed(placement, 1.0, inherited.depths.interior_texture)];
        }
        if let Shape::Blob(blob) = &primitive.shape {
            let mixed = blob.textures(point_local);
            if !mixed.is_empty() {
                let seen = |(component, weight): (u32, f32)| match blob.parts[component as usize].texture {
                    Some((texture, _)) => {
                        Some(TextureRef { texture, weight, place: TexturePlace::Component(component) })
                    }
                    None => whole(weight),
                };
                return mixed.into_iter().filter_map(seen).collect();
            }
        }
        let own = self.textures_of_part(&primitive.shape, hit.part, point_local);
        if !own.is_empty() {
            let place = TexturePlace::Shape;
            return own.into_iter().map(|(texture, weight)| TextureRef { texture, weight, place }).collect();
        }
        match appearance.cutaway {
            Some(root) if self.appearances[primitive.appearance].texture.is_none() => {
                let cut = self.cutaway(root, point_group);
                cut.into_iter().map(|(p, weight)| self.placed(p, weight, inherited.depths.texture)).collect()
            }
            _ => whole(1.0).into_iter().collect(),
        }
    }

    /// Textures that belong to parts of a shape, with weights.
    fn textures_of_part(&self, shape: &Shape, part: u32, point_local: DVec3) -> SmallVec<[(TextureId, f32); 3]> {
        match shape {
            Shape::Mesh(mesh) => mesh.tree.textures(part, point_local),
            _ => SmallVec::new(),
        }
    }

    /// A placement inside so many instances.
    #[inline]
    fn placed(&self, placement: PlacementId, weight: f32, depth: u8) -> TextureRef {
        let texture = self.placements[placement].texture;
        TextureRef { texture, weight, place: TexturePlace::Placement { id: placement, depth } }
    }

    /// Textures of the parts of a solid that contain a point of a cut, evenly weighted at each
    /// level (shape facts, section 10.5).
    fn cutaway(&self, node: NodeId, point: DVec3) -> SmallVec<[(PlacementId, f32); 2]> {
        let mut found = SmallVec::<[(PlacementId, f32); 2]>::new();
        match &self.nodes[node].kind {
            NodeKind::Primitive(p) => {
                let texture = self.appearances[self.primitives[*p].appearance].texture;
                found.extend(texture.map(|t| (t, 1.0)));
            }
            NodeKind::Csg { operation, children, is_difference, .. } => {
                let consulted =
                    if *is_difference && *operation == Operation::Intersection { 1 } else { children.len() };
                for child in &children[..consulted.min(children.len())] {
                    if self.contains_unclipped(*child, point) {
                        found.extend(self.cutaway(*child, point));
                    }
                }
                if !*is_difference {
                    let share = 1.0 / found.len() as f32;
                    found.iter_mut().for_each(|(_, weight)| *weight = share);
                }
            }
        }
        found
    }

    /// Whether a point is inside a node, whatever clips it.
    fn contains_unclipped(&self, id: NodeId, point: DVec3) -> bool {
        match &self.nodes[id].kind {
            NodeKind::Primitive(p) => self.primitive_contains(*p, point),
            NodeKind::Csg { operation: Operation::Intersection, children, .. } => {
                children.iter().all(|n| self.node_contains(*n, point))
            }
            NodeKind::Csg { children, .. } => children.iter().any(|n| self.node_contains(*n, point)),
        }
    }
}

impl LocalSurface {
    /// Takes the place to the space around it.
    fn carry(&mut self, place: &Transform) {
        self.error = transformed_point_error(place, self.point, self.error);
        self.point = place.point(self.point);
        self.normal = place.normal(self.normal);
        self.shading_normal = self.shading_normal.map(|n| place.normal(n));
    }
}

/// Own coordinates of a shape, in the space in which they are defined; of others the world's x and y. `points` are
/// those of the shape's own space, of its group's and of the world.
fn uv_of(primitive: &Primitive, uv: Option<Uv>, [local, group, world]: [DVec3; 3]) -> Uv {
    match (&primitive.uv_from_group, &primitive.shape) {
        (Some(uv_from_group), Shape::Sphere(_)) => Uv::Around(uv_from_group.point(group)),
        (None, Shape::Sphere(sphere)) => Uv::Around(local - sphere.center),
        _ => uv.unwrap_or(Uv::At(DVec2::new(world.x, world.y))),
    }
}

/// A number for a chain of instances: 0 for none, different for different chains (up to the
/// chance of a 32-bit hash). Source: FNV-1a.
fn instance_number(steps: &[InstanceId]) -> u32 {
    if steps.is_empty() {
        return 0;
    }
    steps.iter().fold(0x811c_9dc5_u32, |hash, step| (hash ^ step.number()).wrapping_mul(0x0100_0193))
}
