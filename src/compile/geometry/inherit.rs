//! Pass 3, `inherit`: what children take from what contains them.
//!
//! Rules of the shape facts, section 12.2. Inside a shared group, what is missing stays missing
//! and is found at the hit, on the way back through the instances.

use super::builder::Builder;
use crate::compiled::geometry::{
    Appearance, AppearanceId, InteriorId, LightGroupId, NodeId, ObjectId, PhotonRoleId, Placement, PlacementId,
    RayMask, TextureId,
};
use crate::math::Transform;
use crate::scene::{Interior, Object, PlacedTexture, Shape, Texture, TextureLayer};
use crate::stack::roomy;
use smallvec::SmallVec;
use std::sync::Arc;

/// What an object finds around it on the way down.
#[derive(Clone, Debug)]
pub(super) struct Context {
    /// Takes the space that contains the object to that of the group.
    pub(super) group_from_parent: Transform,
    /// An odd number of inversions so far.
    pub(super) inverse: bool,
    /// Any inversion so far.
    pub(super) turned: bool,
    pub(super) texture: Option<PlacementId>,
    pub(super) interior_texture: Option<PlacementId>,
    /// What a leaf without any texture gets; `None` inside shared groups.
    pub(super) default_texture: Option<PlacementId>,
    /// The index of that texture's finish.
    pub(super) default_ior: Option<f32>,
    pub(super) interior: Option<InteriorId>,
    /// What finishes give to the interiors of a light group's members, which share it.
    pub(super) finish_ior: Option<f32>,
    pub(super) uv_mapping: bool,
    pub(super) hollow: Option<bool>,
    pub(super) double_illuminate: Option<bool>,
    pub(super) no_image: bool,
    pub(super) no_reflection: bool,
    pub(super) no_shadow: bool,
    pub(super) no_radiosity: bool,
    pub(super) importance: Option<f32>,
    pub(super) photons: Option<PhotonRoleId>,
    /// Cut faces without texture look for one; holds the solid's root once it is known.
    pub(super) cutaway: bool,
    pub(super) cutaway_root: Option<NodeId>,
    pub(super) light_group: Option<LightGroupId>,
}

impl Context {
    /// Around a shared group, or around nothing.
    pub(super) fn bare() -> Self {
        Self {
            group_from_parent: Transform::IDENTITY,
            inverse: false,
            turned: false,
            texture: None,
            interior_texture: None,
            default_texture: None,
            default_ior: None,
            interior: None,
            finish_ior: None,
            uv_mapping: false,
            hollow: None,
            double_illuminate: None,
            no_image: false,
            no_reflection: false,
            no_shadow: false,
            no_radiosity: false,
            importance: None,
            photons: None,
            cutaway: false,
            cutaway_root: None,
            light_group: None,
        }
    }

    pub(super) fn hidden_from(&self) -> RayMask {
        RayMask::new(self.no_image, self.no_reflection, self.no_shadow, self.no_radiosity)
    }

    /// The appearance of a leaf, or of an instance on behalf of its contents.
    pub(super) fn appearance(&self, object: ObjectId) -> Appearance {
        let cutaway = self.cutaway_root.filter(|_| self.texture.is_none());
        Appearance {
            texture: if cutaway.is_some() { None } else { self.texture.or(self.default_texture) },
            interior_texture: self.interior_texture,
            interior: self.interior,
            uv_mapping: self.uv_mapping,
            double_illuminate: self.double_illuminate,
            cutaway,
            cut_is_opaque: false,
            object,
            light_group: self.light_group,
            importance: self.importance,
            photons: self.photons,
        }
    }
}

impl Builder<'_> {
    /// The context inside an object: its own properties, completed by those around it.
    /// `group_from_parent` becomes that of the object's contents.
    pub(super) fn enter(&mut self, object: &Object, around: &Context) -> Context {
        let flags = &object.flags;
        let lacks_one = object.texture.is_none() || object.rare.interior_texture.is_none();
        let uv_mapping = flags.uv_mapping || (around.uv_mapping && lacks_one);
        let place = &around.group_from_parent;
        let hollow = flags.hollow.or(around.hollow);
        let own = |builder: &mut Self, placed: &Option<PlacedTexture>| {
            placed.as_ref().map(|p| builder.placement(p, place, flags.uv_mapping))
        };
        let texture = own(self, &object.texture);
        let interior_texture = own(self, &object.rare.interior_texture);
        let interior = object.interior.as_ref().map(|i| self.interior(i, object, around));
        Context {
            group_from_parent: object.place.then(place),
            inverse: around.inverse != flags.inverse,
            turned: around.turned || flags.turned,
            texture: texture.or(around.texture),
            interior_texture: interior_texture.or(around.interior_texture),
            interior: interior.or(around.interior),
            uv_mapping,
            hollow,
            double_illuminate: around.double_illuminate.or(flags.double_illuminate),
            no_image: around.no_image || flags.no_image,
            no_reflection: around.no_reflection || flags.no_reflection,
            no_shadow: around.no_shadow || flags.no_shadow,
            no_radiosity: around.no_radiosity || flags.no_radiosity,
            importance: object.rare.radiosity_importance.or(around.importance),
            photons: self.photon_role(object, around),
            cutaway: around.cutaway || flags.cutaway_textures,
            default_texture: around.default_texture,
            default_ior: around.default_ior,
            finish_ior: around.finish_ior,
            cutaway_root: around.cutaway_root,
            light_group: around.light_group,
        }
    }

    /// Notes a texture in a place, or finds the same one.
    fn placement(&mut self, placed: &PlacedTexture, group_from_parent: &Transform, fixed: bool) -> PlacementId {
        if placed.place.is_identity() && (fixed || group_from_parent.is_identity()) {
            return self.unmoved(&placed.texture);
        }
        let texture = self.texture(&placed.texture);
        // Under uv mapping textures do not move with anything.
        let forward = if fixed { placed.place.transform() } else { placed.place.then(group_from_parent) };
        self.placement_of(texture, &forward)
    }

    /// The same for a texture where it was written.
    pub(super) fn unmoved(&mut self, texture: &Arc<Texture>) -> PlacementId {
        if let Some(known) = self.unmoved_ids.get(&Arc::as_ptr(texture)) {
            return *known;
        }
        let id = self.texture(texture);
        let placement = self.add_placement(id, None);
        self.unmoved_ids.insert(Arc::as_ptr(texture), placement);
        placement
    }

    fn placement_of(&mut self, texture: TextureId, group_from_texture: &Transform) -> PlacementId {
        let m = group_from_texture.linear();
        let columns = [m.x_axis, m.y_axis, m.z_axis, group_from_texture.origin()];
        let key = columns.map(|v| v.to_array().map(f64::to_bits));
        if let Some(known) = self.placement_ids.get(&(texture, key)) {
            return *known;
        }
        let placement = self.add_placement(texture, Some(Box::new(group_from_texture.inverse())));
        self.placement_ids.insert((texture, key), placement);
        placement
    }

    fn add_placement(&mut self, texture: TextureId, texture_from_group: Option<Box<Transform>>) -> PlacementId {
        self.geometry.placements.push(Placement { texture, texture_from_group })
    }

    /// The number of a texture.
    ///
    /// Copies of one declared texture share its pigment, normal and finish, and its number.
    pub(super) fn texture(&mut self, texture: &Arc<Texture>) -> TextureId {
        if let Some(known) = self.texture_ids.get(&Arc::as_ptr(texture)) {
            return *known;
        }
        let textures = &mut self.textures;
        let mut add = || textures.push(Arc::clone(texture));
        let id = match &**texture {
            Texture::Layers(layers) => *self.layered_ids.entry(parts_of(layers)).or_insert_with(add),
            Texture::Patterned(_) => add(),
        };
        self.texture_ids.insert(Arc::as_ptr(texture), id);
        id
    }

    /// A new interior, private to the object that asks.
    pub(super) fn interior(&mut self, interior: &Arc<Interior>, object: &Object, around: &Context) -> InteriorId {
        self.geometry.hollow.push(last_hollow(object, around.hollow));
        let mut own = Arc::clone(interior);
        if let Some(ior) = self.last_finish_ior(object, around) {
            let own = Arc::make_mut(&mut own);
            (own.ior, own.dispersion) = (ior.into(), 1.0);
        }
        if interior.has_place() && !around.group_from_parent.is_identity() {
            Arc::make_mut(&mut own).apply(&around.group_from_parent);
        }
        self.interiors.push(own)
    }

    /// The index that finishes give to an interior: whoever shares it and is visited last decides, as in POV-Ray.
    pub(super) fn last_finish_ior(&self, object: &Object, around: &Context) -> Option<f32> {
        let outer = match around.texture {
            Some(id) => self.textures[self.geometry.placements[id].texture].finish_ior(),
            None => around.default_ior,
        };
        around.finish_ior.or_else(|| self.last_ior(object, outer))
    }

    fn last_ior(&self, object: &Object, outer: Option<f32>) -> Option<f32> {
        let own = object.texture.as_ref().map_or(outer, |placed| placed.texture.finish_ior());
        match &object.shape {
            Shape::Csg { children, .. } | Shape::LightGroup { children, .. } if self.census.of(children).finish_ior => {
                let shares = |o: &&Arc<Object>| o.interior.is_none() && !matches!(o.shape, Shape::LightSource(_));
                children.iter().rev().filter(shares).find_map(|child| roomy(|| self.last_ior(child, own))).or(own)
            }
            _ => own,
        }
    }

    /// Notes an appearance.
    pub(super) fn add_appearance(&mut self, appearance: Appearance) -> AppearanceId {
        let appearances = &mut self.geometry.appearances;
        match appearances.last() {
            Some((id, last)) if *last == appearance => id,
            _ => appearances.push(appearance),
        }
    }
}

/// Where a texture's parts lie in memory.
pub(super) type TextureParts = SmallVec<[[usize; 3]; 1]>;

fn parts_of(layers: &[TextureLayer]) -> TextureParts {
    let normal = |layer: &TextureLayer| layer.normal.as_ref().map_or(0, |n| Arc::as_ptr(n).addr());
    layers.iter().map(|l| [Arc::as_ptr(&l.pigment).addr(), normal(l), Arc::as_ptr(&l.finish).addr()]).collect()
}

/// Whether an interior ends up hollow: whoever shares it and is visited last decides.
fn last_hollow(object: &Object, around: Option<bool>) -> bool {
    let (mut object, mut hollow) = (object, object.flags.hollow.or(around));
    while let Shape::Csg { children, .. } | Shape::LightGroup { children, .. } = &object.shape {
        let shares = |o: &&Arc<Object>| o.interior.is_none() && !matches!(o.shape, Shape::LightSource(_));
        let Some(last) = children.iter().rev().find(shares) else { break };
        (object, hollow) = (last, last.flags.hollow.or(hollow));
    }
    hollow.unwrap_or(false)
}
