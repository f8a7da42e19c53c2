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

mod record;

pub use record::{
    Hit, InteriorId, InteriorKey, LightGroupId, MAX_INSTANCE_DEPTH, ObjectId, RayKind, Surface, TextureId, TextureRef,
};

use crate::math::{Bounds, DVec3, Range, Ray};

/// Per-thread buffers, so that no ray allocates.
#[derive(Debug, Default)]
pub struct Scratch {}

/// All objects of a scene, or of one object that is asked about.
#[derive(Debug, Default)]
pub struct Geometry {}

impl Geometry {
    /// The nearest hit strictly inside `range`; an empty range gives `None`.
    pub fn intersect(&self, _ray: &Ray, _range: Range, _kind: RayKind, _scratch: &mut Scratch) -> Option<Hit> {
        None
    }

    /// Whether a shadow ray meets anything inside `range`. For scenes in which nothing transmits light.
    pub fn occluded(&self, ray: &Ray, range: Range, scratch: &mut Scratch) -> bool {
        self.intersect(ray, range, RayKind::Shadow, scratch).is_some()
    }

    /// The full record of a hit that [`intersect`](Self::intersect) gave for the same ray.
    pub fn surface(&self, _ray: &Ray, _hit: &Hit) -> Surface<'_> {
        unimplemented!("geometry without objects gives no hit")
    }

    /// The interiors of frame-level objects that contain the point, in file order.
    pub fn containing(&self, _point: DVec3) -> Vec<InteriorKey> {
        Vec::new()
    }

    /// Whether the point is inside any object.
    pub fn contains(&self, _point: DVec3) -> bool {
        false
    }

    /// A box around everything; infinite if anything is.
    pub fn bounds(&self) -> Bounds {
        Bounds::EMPTY
    }
}
