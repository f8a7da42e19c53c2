//! The compiled scene graph: groups of items, shared through instances; solids as trees of nodes.
//!
//! All handles are of the tables of one [`Geometry`](super::Geometry). A group is a set of
//! objects that do not combine (a split union); its items live in the group's space. A solid is a
//! tree whose parts combine; all its primitives share one space, so that surviving hits are
//! decided in the same numbers in which they were found.

use super::bvh::{Box32, Bvh};
use super::parts::Parts;
use super::record::RayKind;
use super::shape::{Plane, Primitive as _, Shape, Sphere};
use crate::compiled::handle::{
    AppearanceId, GroupId, InstanceId, InteriorId, LightGroupId, NodeId, ObjectId, PhotonRoleId, PlacementId,
    PrimitiveId, TextureId,
};
use crate::math::{Bounds, Transform};
use rayon::prelude::*;

/// A set of kinds of ray. An object has one of those from which it is hidden, which pass it by.
///
/// Rays that look for what surely blocks light are a kind of their own: from them is hidden what surely does not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct RayMask(u8);

impl RayMask {
    const IMAGE: u8 = 1;
    const REFLECTION: u8 = 2;
    const SHADOW: u8 = 4;
    const BLOCKERS: u8 = 8;
    const RADIOSITY: u8 = 16;

    pub(crate) fn new(no_image: bool, no_reflection: bool, no_shadow: bool, no_radiosity: bool) -> Self {
        let bit = |flag: bool, mask: u8| if flag { mask } else { 0 };
        let seen = bit(no_image, Self::IMAGE) | bit(no_reflection, Self::REFLECTION);
        Self(seen | bit(no_shadow, Self::SHADOW) | bit(no_radiosity, Self::RADIOSITY))
    }

    /// A kind of ray by itself; a probe is none that anything can be hidden from.
    pub(crate) fn of(kind: RayKind) -> Self {
        Self(match kind {
            RayKind::Camera | RayKind::Refracted => Self::IMAGE,
            RayKind::Reflected => Self::REFLECTION,
            RayKind::Shadow => Self::SHADOW,
            RayKind::Radiosity => Self::RADIOSITY,
            RayKind::Photon => Self::IMAGE | Self::SHADOW,
            RayKind::MirroredPhoton => Self::SHADOW,
            RayKind::Probe => 0,
        })
    }

    /// Shadow rays that are met only by what may block all light.
    pub(crate) fn of_blockers() -> Self {
        Self(Self::SHADOW | Self::BLOCKERS)
    }

    /// With those, or without them.
    #[must_use]
    pub(crate) fn with_blockers(self, is_with: bool) -> Self {
        Self(if is_with { self.0 | Self::BLOCKERS } else { self.0 & !Self::BLOCKERS })
    }

    /// Whether they have a kind of ray in common.
    pub(crate) fn intersects(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Whether these are all kinds that there are in a scene, those of radiosity only where it is on.
    pub(crate) fn is_all(self, with_radiosity: bool) -> bool {
        let seen = Self::IMAGE | Self::REFLECTION | Self::SHADOW;
        self.0 & seen == seen && (!with_radiosity || self.0 & Self::RADIOSITY != 0)
    }
}

/// What stands in a group.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ItemKind {
    /// A sphere in the group's own space, the data at hand.
    Sphere(Sphere, PrimitiveId),
    /// The same for a plane, which every ray tries.
    Plane(Plane, PrimitiveId),
    /// Any other primitive without clips.
    Primitive(PrimitiveId),
    /// A tree of nodes.
    Solid(NodeId),
    /// A shared group in another place.
    Instance(InstanceId),
}

/// An object of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Item {
    pub(crate) kind: ItemKind,
    pub(crate) hidden_from: RayMask,
}

/// Objects that do not combine.
#[derive(Debug, Default)]
pub(crate) struct Group {
    /// Finite ones, in the order of the hierarchy.
    pub(crate) items: Vec<Item>,
    pub(crate) bvh: Bvh,
    /// The rest, in file order.
    pub(crate) infinite: Vec<Item>,
    /// Around the finite ones; empty if there are none.
    pub(crate) finite_bounds: Bounds,
    /// Around all.
    pub(crate) bounds: Bounds,
}

/// Items in a leaf: their tests are costly, boxes are cheap.
const LEAF_SIZE: usize = 1;

/// A group under construction.
#[derive(Debug)]
pub(crate) struct GroupBuilder {
    finite: Vec<(Item, Box32)>,
    infinite: Vec<Item>,
    finite_bounds: Bounds,
}

impl GroupBuilder {
    /// With room for so many finite ones.
    pub(crate) fn with_capacity(n: usize) -> Self {
        Self { finite: Vec::with_capacity(n), infinite: Vec::new(), finite_bounds: Bounds::EMPTY }
    }

    /// An item with its bounds.
    pub(crate) fn push(&mut self, item: Item, bounds: &Bounds) {
        if bounds.is_finite() {
            self.finite_bounds = self.finite_bounds.union(bounds);
            self.finite.push((item, bounds.into()));
        } else {
            self.infinite.push(item);
        }
    }
}

impl Group {
    /// Builds the hierarchy over items.
    pub(crate) fn new(GroupBuilder { finite, infinite, finite_bounds }: GroupBuilder) -> Self {
        let bounds = if infinite.is_empty() { finite_bounds } else { Bounds::INFINITE };
        let (bvh, order) = Bvh::build(finite.par_iter().map(|(_, bounds)| *bounds), LEAF_SIZE);
        let items = order.iter().map(|i| finite[*i as usize].0).collect();
        Self { items, bvh, infinite, finite_bounds, bounds }
    }
}

/// A shared group in one place.
#[derive(Clone, Debug)]
pub(crate) struct Instance {
    pub(crate) group: GroupId,
    pub(crate) parent_from_group: Transform,
    /// What the contents inherit.
    pub(crate) appearance: AppearanceId,
}

/// A shape in its place.
#[derive(Clone, Debug)]
pub(crate) struct Primitive {
    pub(crate) shape: Shape,
    /// `None` where the shape is given in the space of its group.
    pub(crate) group_from_local: Option<Box<Transform>>,
    /// Inside and outside are exchanged.
    pub(crate) inverse: bool,
    /// Takes points to the space in which the shape's own uv coordinates are defined, where
    /// folding a transform into the shape changed that.
    pub(crate) uv_from_group: Option<Box<Transform>>,
    pub(crate) appearance: AppearanceId,
}

impl Primitive {
    /// Around the surface, in the shape's own space.
    pub(crate) fn local_bounds(&self) -> Bounds {
        self.shape.bounds()
    }

    /// Around the surface, in the group's space, with room for rounding.
    pub(crate) fn bounds(&self) -> Bounds {
        let local = self.local_bounds();
        let bounds = match &self.group_from_local {
            Some(place) => place.bounds(&local),
            None => local,
        };
        padded(bounds)
    }
}

/// Grown by the rounding of transforms and slab tests.
pub(crate) fn padded(b: Bounds) -> Bounds {
    if !b.is_finite() {
        return b;
    }
    let pad = b.min.abs().max(b.max.abs()) * crate::math::gamma(32);
    Bounds { min: b.min - pad, max: b.max + pad }
}

/// How children of a node combine; differences have become intersections with inverses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    Union,
    Merge,
    Intersection,
}

/// A part of a solid.
#[derive(Clone, Debug)]
pub(crate) enum NodeKind {
    Primitive(PrimitiveId),
    Csg {
        operation: Operation,
        children: Box<[NodeId]>,
        /// Written as `difference`: cut faces take the texture of the first child alone.
        is_difference: bool,
        /// Of an intersection, positions of the children that contain nothing outside some stretch of a ray.
        confining: Box<[u32]>,
        /// Finds children where there are many.
        parts: Option<Box<Parts>>,
    },
}

/// A part of a solid with its clips.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) kind: NodeKind,
    /// Around all surfaces that may survive; infinite where unknown.
    pub(crate) bounds: Bounds,
    /// Around all points inside; infinite where unknown.
    pub(crate) extent: Bounds,
    /// Around all points outside; infinite where unknown.
    pub(crate) gap: Bounds,
    /// Nodes in which a hit must be.
    pub(crate) clips: Box<[NodeId]>,
    /// Nodes that a ray must meet, or start in.
    pub(crate) bounded_by: Box<[NodeId]>,
    pub(crate) hidden_from: RayMask,
    /// Of the solid itself, at its root.
    pub(crate) appearance: AppearanceId,
    /// What this is a child of; `None` for roots, clips and bounds.
    pub(crate) parent: Option<Parent>,
    /// Crossings are taken in reverse order an odd number of times on their way from here to the root.
    pub(crate) is_reversed: bool,
    /// They were once more by solids that are gone: this was their only part, or they were taken apart.
    pub(crate) flips: bool,
    /// Of a solid's root, the parts of which it is what they have in common, if all are convex; otherwise none.
    pub(crate) convex_parts: Box<[PrimitiveId]>,
    /// Intersections that stand in each other here, this one included; 0 where it is none or clipped.
    pub(crate) nesting: u8,
}

/// What a node is a child of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parent {
    pub(crate) node: NodeId,
    /// This child's among the node's children.
    pub(crate) position: u32,
}

impl Node {
    /// What it combines.
    pub(crate) fn children(&self) -> &[NodeId] {
        match &self.kind {
            NodeKind::Primitive(_) => &[],
            NodeKind::Csg { children, .. } => children,
        }
    }

    /// Whether nothing but its kind says where it is.
    pub(crate) fn is_bare(&self) -> bool {
        self.clips.is_empty() && self.bounded_by.is_empty()
    }

    /// Whether crossings of a child are taken in reverse order.
    pub(crate) fn reverses(&self) -> bool {
        let filters = matches!(&self.kind, NodeKind::Csg { operation, .. } if *operation != Operation::Union);
        filters || !self.clips.is_empty()
    }

    /// A union of nothing.
    pub(crate) fn placeholder() -> Self {
        Self {
            kind: NodeKind::Csg {
                operation: Operation::Union,
                children: Box::default(),
                is_difference: false,
                confining: Box::default(),
                parts: None,
            },
            bounds: Bounds::EMPTY,
            extent: Bounds::EMPTY,
            gap: Bounds::INFINITE,
            clips: Box::default(),
            bounded_by: Box::default(),
            hidden_from: RayMask::default(),
            appearance: AppearanceId::default(),
            parent: None,
            is_reversed: false,
            flips: false,
            convex_parts: Box::default(),
            nesting: 0,
        }
    }
}

/// A texture with its place.
#[derive(Clone, Debug)]
pub(crate) struct Placement {
    pub(crate) texture: TextureId,
    /// Takes the space of the group in which the textured object stands to texture space; most are the same.
    pub(crate) texture_from_group: Option<Box<Transform>>,
}

/// How an object appears, as far as it says; `None` is left to what contains it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Appearance {
    pub(crate) texture: Option<PlacementId>,
    pub(crate) interior_texture: Option<PlacementId>,
    pub(crate) interior: Option<InteriorId>,
    pub(crate) uv_mapping: bool,
    pub(crate) double_illuminate: Option<bool>,
    /// Without a texture of its own, takes that of the objects cut: the solid's root node.
    pub(crate) cutaway: Option<NodeId>,
    /// All those textures let no light through; known once they are compiled.
    pub(crate) cut_is_opaque: bool,
    pub(crate) object: ObjectId,
    pub(crate) light_group: Option<LightGroupId>,
    /// How many of radiosity's sample rays see it.
    pub(crate) importance: Option<f32>,
    /// What photons may do here, where some are shot.
    pub(crate) photons: Option<PhotonRoleId>,
}
