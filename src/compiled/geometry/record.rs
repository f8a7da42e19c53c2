//! What a ray asks for and what it gets back.

use crate::compiled::handle::{
    InstanceId, InteriorId, LightGroupId, ObjectId, PhotonRoleId, PlacementId, PrimitiveId, TextureId,
};
use crate::math::{DVec3, Range, Ray, Uv};
use smallvec::SmallVec;

/// Who sends the ray; decides which objects it passes by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the camera: passes `no_image` objects by.
    Camera,
    /// Refracted or transmitted, with no reflection on its way from the camera: passes `no_image` objects by.
    Refracted,
    /// With a reflection on its way: passes `no_reflection` objects by.
    Reflected,
    /// Towards a light: passes `no_shadow` objects by.
    Shadow,
    /// Gathers light for radiosity, bent and mirrored ways included: passes `no_radiosity` objects by.
    Radiosity,
    /// From a light, as a photon: passes `no_shadow` and `no_image` objects by.
    Photon,
    /// A photon with a reflection on its way: passes `no_shadow` objects by.
    MirroredPhoton,
    /// Sent by the scene itself (`trace`) while it is read: meets everything.
    Probe,
}

impl RayKind {
    /// What becomes of it behind a surface.
    #[must_use]
    pub fn transmitted(self) -> Self {
        if self == Self::Camera { Self::Refracted } else { self }
    }

    /// What becomes of it in a mirror.
    #[must_use]
    pub fn mirrored(self) -> Self {
        match self {
            Self::Radiosity => Self::Radiosity,
            Self::Photon | Self::MirroredPhoton => Self::MirroredPhoton,
            _ => Self::Reflected,
        }
    }

    /// Whether it carries light instead of looking for it.
    pub fn is_photon(self) -> bool {
        matches!(self, Self::Photon | Self::MirroredPhoton)
    }
}

/// Identity of an interior: which one, and in which copy of the object that owns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct InteriorKey {
    /// Which interior.
    pub interior: InteriorId,
    /// Tells copies of one shared object apart; 0 outside shared groups.
    pub instance: u32,
}

/// How many shared groups may stand inside each other; deeper ones are copied out by `compile`. Every hit carries
/// room for as many.
pub const MAX_INSTANCE_DEPTH: usize = 12;

/// The instances a ray went through to reach a primitive, outermost first.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Path {
    /// Only the first `len` count.
    steps: [InstanceId; MAX_INSTANCE_DEPTH],
    len: u8,
}

impl Path {
    /// The instances, outermost first.
    pub(crate) fn steps(&self) -> &[InstanceId] {
        &self.steps[..usize::from(self.len)]
    }

    /// Goes into an instance; `compile` keeps the depth in bounds.
    pub(crate) fn push(&mut self, instance: InstanceId) {
        self.steps[usize::from(self.len)] = instance;
        self.len += 1;
    }

    /// Comes out again.
    pub(crate) fn pop(&mut self) {
        self.len -= 1;
    }
}

/// The nearest hit of a ray: enough to rebuild everything else.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Ray parameter; world distance for a unit direction.
    pub t: f64,
    /// Which primitive.
    pub(crate) primitive: PrimitiveId,
    /// Which part of the primitive: face, segment or glyph, as the shape sees fit.
    pub(crate) part: u32,
    /// Through which instances.
    pub(crate) path: Path,
}

/// One texture seen at a hit, with its share.
#[derive(Clone, Copy, Debug)]
pub struct TextureRef {
    /// Which texture.
    pub texture: TextureId,
    /// Share among all textures of the hit; they add up to 1.
    pub weight: f32,
    /// In which space it was written: for [`Geometry::texture_from_world`](super::Geometry::texture_from_world).
    pub(super) place: TexturePlace,
}

/// The space in which a texture was written; its map from the world is worked out for those who ask.
#[derive(Clone, Copy, Debug)]
pub(super) enum TexturePlace {
    /// Of a placement, inside so many instances of the hit's path.
    Placement { id: PlacementId, depth: u8 },
    /// Of the shape itself.
    Shape,
    /// Of a component of a blob, by its number.
    Component(u32),
}

/// Everything about the place a ray hit.
#[derive(Clone, Debug)]
pub struct Surface {
    /// World position, moved onto the surface.
    pub point: DVec3,
    /// Bound of the distance between `point` and the true surface, world units.
    pub point_error: f64,
    /// From `point` back to where the ray came through the surface, if that is not the same.
    pub retreat: DVec3,
    /// Unit world normal of the surface itself: the object's own outward side, not turned to the ray.
    pub geometric_normal: DVec3,
    /// Unit world normal for shading: interpolated where the surface is smooth, else the geometric one.
    pub normal: DVec3,
    /// Surface coordinates.
    pub uv: Uv,
    /// Whether the ray hits the back: raw `normal` along the direction.
    pub from_inside: bool,
    /// Which textures show, already chosen for this side; empty means black and opaque.
    pub textures: SmallVec<[TextureRef; 1]>,
    /// Textures are looked up at (u, v, 0).
    pub uv_mapping: bool,
    /// What fills the object.
    pub interior: InteriorKey,
    /// Fog and media outside also fill the object.
    pub hollow: bool,
    /// Both sides are lit.
    pub double_illuminate: bool,
    /// The frame-level object.
    pub object: ObjectId,
    /// The light group that the object belongs to.
    pub light_group: Option<LightGroupId>,
    /// Share of radiosity's sample rays that see the object, where it says so.
    pub importance: Option<f32>,
    /// What photons may do here, where some are shot.
    pub photons: Option<PhotonRoleId>,
}

/// How far a new ray starts from the surface, in units of `point_error`: one for the error of
/// this surface, the rest for the rounding of the next intersection test near it.
pub(super) const LEAVE_FACTOR: f64 = 4.0;

impl Surface {
    /// A ray that leaves the surface along `direction` (unit, world), with its range.
    ///
    /// The origin is moved off the surface along the geometric normal by a few times
    /// `point_error`, to the side where the direction points, so that the ray cannot meet the
    /// surface it leaves; no distance is fixed, so tiny and huge scenes behave alike.
    /// Source: Pharr, Jakob, Humphreys, Physically Based Rendering, 3rd ed., section 3.9.5.
    pub fn leave(&self, direction: DVec3) -> (Ray, Range) {
        let side = if self.geometric_normal.dot(direction) < 0.0 { -1.0 } else { 1.0 };
        // Only rays that go back have to get through the surface first.
        let goes_back = side * self.geometric_normal.dot(self.retreat) > 0.0;
        let point = if goes_back { self.point + self.retreat } else { self.point };
        let origin = point + self.geometric_normal * (side * LEAVE_FACTOR * self.point_error);
        (Ray::new(origin, direction), Range::FORWARD)
    }
}
