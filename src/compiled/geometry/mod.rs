//! Everything rays meet.
//!
//! A [`Geometry`] is asked for the nearest [`Hit`] of a ray, or whether there is any; for the
//! winner alone it then builds the full [`Surface`]. Every bounce enters here at the root.
//!
//! ```
//! use whitted::compiled::geometry::{Geometry, RayKind, Scratch};
//! use whitted::math::{DVec3, Range, Ray};
//! let ray = Ray::new(DVec3::ZERO, DVec3::Z);
//! assert!(Geometry::default().intersect(&ray, Range::FORWARD, RayKind::Camera, &mut Scratch::default()).is_none());
//! ```

mod bvh;
mod convex_parts;
mod dump;
mod graph;
mod inside;
mod parts;
mod record;
mod shape;
mod slab;
mod solid;
mod span;
mod surface;
mod walk;

pub use super::handle::{InteriorId, LightGroupId, ObjectId, PhotonRoleId, StatementId, TextureId};
pub use inside::Touching;
pub use record::{Hit, InteriorKey, MAX_INSTANCE_DEPTH, RayKind, Surface, TextureRef};
pub use solid::Scratch;

// What `compile` fills in.
pub(crate) use super::handle::{AppearanceId, GroupId, InstanceId, NodeId, PlacementId, PrimitiveId};
pub(crate) use convex_parts::of_solid as convex_parts;
pub(crate) use graph::{
    Appearance, Group, GroupBuilder, Instance, Item, ItemKind, Node, NodeKind, Operation, Parent, Placement, Primitive,
    RayMask, padded,
};
pub(crate) use parts::Parts;
pub(crate) use shape::{
    Blob, BlobPart, Cone, Container, Core, Cuboid, Disc, HeightField, HeightGrid, Isosurface, Julia, JuliaFunction,
    Lathe, Mesh, MeshData, MeshTree, Outline, Ovus, PLANE_BOUNDARY, Parametric, Plane, Polygon, Polynomial, Prism,
    Quadric, SearchNotes, Segment, Shape, SmoothTriangle, Sor, SorSegment, Sphere, SphereSweep, Superellipsoid,
    SweepSegment, Torus, Triangle,
};

use super::handle::Table;
use super::photons::PhotonRole;
use crate::math::{Bounds, DVec3, Range, Ray};
use record::{LEAVE_FACTOR, Path};
use smallvec::SmallVec;
use walk::{All, Blocking, LastShadow, Nearest, Walk};

/// All objects of a scene, or of one object that is asked about.
///
/// Every handle in its tables stands for something, instances nest at most [`MAX_INSTANCE_DEPTH`] deep, and
/// a primitive reached through no instance has an appearance without gaps: `compile` sees to that.
#[derive(Debug, Default)]
pub struct Geometry {
    /// What every ray enters.
    pub(crate) root: Group,
    pub(crate) groups: Table<GroupId, Group>,
    pub(crate) instances: Table<InstanceId, Instance>,
    pub(crate) nodes: Table<NodeId, Node>,
    pub(crate) primitives: Table<PrimitiveId, Primitive>,
    pub(crate) appearances: Table<AppearanceId, Appearance>,
    pub(crate) placements: Table<PlacementId, Placement>,
    /// Of each interior, whether fog and media outside also fill its object.
    pub(crate) hollow: Table<InteriorId, bool>,
    /// What objects say about photons, where some are shot.
    pub(crate) photon_roles: Table<PhotonRoleId, PhotonRole>,
}

/// What is in the way of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadow {
    /// Nothing.
    Clear,
    /// Perhaps something that lets some through, perhaps something that does not.
    Filtered,
    /// Something opaque.
    Blocked,
}

impl Geometry {
    /// The nearest hit strictly inside `range`; an empty range gives `None`.
    pub fn intersect(&self, ray: &Ray, range: Range, kind: RayKind, scratch: &mut Scratch) -> Option<Hit> {
        let mut walk = Walk::new(self, ray, range, kind, scratch, Nearest::default());
        // Nothing ends this search before its end.
        let _: std::ops::ControlFlow<()> = walk.group(&self.root, ray);
        walk.search.best.map(|(hit, _)| hit)
    }

    /// Surfaces of other interiors that a ray which goes through one along `direction` passes with it, nearest first: where
    /// two touch, the second lies within the step by which the ray leaves the first.
    pub fn passed_with(
        &self,
        surface: &Surface,
        direction: DVec3,
        kind: RayKind,
        scratch: &mut Scratch,
    ) -> SmallVec<[Surface; 1]> {
        let ahead = surface.geometric_normal * surface.geometric_normal.dot(direction).signum();
        // What is as near as rounding can tell may be in front.
        let ray = Ray::new(surface.point - ahead * surface.point_error, ahead);
        let range = Range { min: 0.0, max: (1.0 + LEAVE_FACTOR) * surface.point_error };
        let mut walk = Walk::new(self, &ray, range, kind, scratch, All::default());
        let _: std::ops::ControlFlow<()> = walk.group(&self.root, &ray);
        let mut hits = walk.search.hits;
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        let surfaces = hits.iter().map(|hit| self.surface(&ray, hit));
        surfaces.filter(|other| other.interior != surface.interior).collect()
    }

    /// What stands inside `range` between a point and light number `light`.
    ///
    /// `opaque` says of each texture whether no light comes through; `None` where that holds for all. Where light last
    /// came through something ([`Scratch::note_filtered`]) it is not looked for what may let it through.
    pub fn shadow(
        &self,
        ray: &Ray,
        range: Range,
        light: usize,
        opaque: Option<&Table<TextureId, bool>>,
        scratch: &mut Scratch,
    ) -> Shadow {
        if scratch.shadows.len() <= light {
            scratch.shadows.resize(light + 1, LastShadow::default());
        }
        let search = || Blocking { opaque, is_filtered: false, blocker: None };
        // Copied only where there is one.
        if let Some(blocker) = scratch.shadows[light].blocker
            && Walk::new(self, ray, range, RayKind::Shadow, scratch, search()).retry(&blocker, ray).is_break()
        {
            return Shadow::Blocked;
        }
        // Where it will be followed piece by piece anyway, it is asked only for what surely blocks it: answered by the whole
        // ray, whatever rays were before. Pieces may pass what lies in the same place as something clear.
        let is_filtered = scratch.shadows[light].is_filtered;
        let mut walk = Walk::new(self, ray, range, RayKind::Shadow, scratch, search());
        if is_filtered {
            walk.looks_for_blockers();
        }
        if walk.group(&self.root, ray).is_break() {
            let blocker = walk.search.blocker;
            scratch.shadows[light].blocker = blocker;
            return Shadow::Blocked;
        }
        if is_filtered || walk.search.is_filtered { Shadow::Filtered } else { Shadow::Clear }
    }

    /// The interiors of frame-level objects that contain the point, in file order. As in POV-Ray, inverted
    /// finite objects do not count as containing the space around them.
    pub fn containing(&self, point: DVec3) -> SmallVec<[InteriorKey; 4]> {
        let mut found = SmallVec::<[_; 4]>::new();
        self.gather(&self.root, point, &mut Path::default(), &mut |geometry, item, path| {
            found.extend(geometry.item_interior(item, path));
            true
        });
        found.sort_by_key(|(object, _)| *object);
        found.into_iter().map(|(_, key)| key).collect()
    }

    /// Whether the point is inside any object.
    pub fn contains(&self, point: DVec3) -> bool {
        // Half spaces and inverted objects reach beyond their surface's box.
        let mut items = self.root.items.iter().chain(&self.root.infinite);
        items.any(|item| !self.gather_item(item, point, &mut Path::default(), &mut |_, _, _| false))
    }

    /// How much there is of what.
    pub(super) fn summary(&self) -> Vec<(&'static str, usize)> {
        let nodes = self.groups.iter().chain([&self.root]).map(|group| group.bvh.n_nodes()).sum();
        vec![
            ("objects at the root", self.root.items.len() + self.root.infinite.len()),
            ("infinite objects", self.root.infinite.len()),
            ("primitives", self.primitives.len()),
            ("shared groups", self.groups.len()),
            ("instances", self.instances.len()),
            ("solids' nodes", self.nodes.len()),
            ("hierarchy's nodes", nodes),
        ]
    }

    /// How many isosurfaces there are, copies not counted.
    pub(super) fn isosurfaces(&self) -> usize {
        self.primitives.iter().filter(|primitive| matches!(primitive.shape, Shape::Isosurface(_))).count()
    }

    /// How far the farthest corner of anything finite is from a point; `None` if there is nothing finite.
    pub fn reach(&self, point: DVec3) -> Option<f64> {
        let bounds = self.root.finite_bounds;
        let farthest = (bounds.min - point).abs().max((bounds.max - point).abs());
        (!bounds.is_empty()).then(|| farthest.length())
    }

    /// A box around everything; infinite if anything is.
    pub fn bounds(&self) -> Bounds {
        self.root.bounds
    }
}
