//! What is worked out once, before the first block.
//!
//! [`Prepared`] is made on one thread, or by many in an order that does not depend on them, and every worker reads it.
//! `shoot` fills what photons bring, `pretrace` what is known of light between surfaces.

use super::camera::Lens;
use super::medium::{Interiors, Settling};
use super::options::Options;
use super::photons::Caught;
use super::radiosity::Shared;
use crate::compiled::World;
use crate::compiled::camera::Projection;
use crate::compiled::subsurface::Subsurface;

/// POV-Ray's distance within which a camera ray meets nothing; of scenes smaller than 1, a share of their size.
const CAMERA_NEAR: f64 = 1e-4;

/// A world with what all its rays share.
#[derive(Debug)]
pub(super) struct Prepared<'w> {
    pub(super) world: &'w World,
    pub(super) options: &'w Options,
    /// Of a camera with depth of field.
    pub(super) lens: Option<Lens>,
    /// What the camera is inside of, for projections with one centre.
    pub(super) camera_interiors: Option<Interiors>,
    /// Within this distance a camera ray meets nothing.
    pub(super) camera_near: f64,
    /// Light that photons have brought, once they are shot.
    pub(super) photons: Option<Caught<'w>>,
    /// What is known of light between surfaces, where it counts.
    pub(super) radiosity: Option<Shared<'w>>,
    /// How light below surfaces is sampled, where it counts.
    pub(super) subsurface: Option<&'w Subsurface>,
    /// There is light that does not come straight from its sources: one of these three.
    pub(super) has_global_light: bool,
    /// Of each medium, when samples are enough.
    pub(super) settling: Vec<Settling>,
    /// Whether there are fog, rainbows or media anywhere, and they count.
    pub(super) has_air: bool,
    /// Whether neighbours among camera rays may share work.
    pub(super) side_by_side: bool,
}

impl<'w> Prepared<'w> {
    pub(super) fn new(world: &'w World, options: &'w Options) -> Self {
        let (camera, features) = (&world.camera, &world.features);
        let subsurface = world.subsurface.as_ref().filter(|_| features.translucent_textures > 0);
        let subsurface = subsurface.filter(|_| options.indirect_light());
        let radiosity = world.radiosity.as_ref().filter(|_| options.indirect_light());
        Self {
            world,
            options,
            lens: camera.blur.as_ref().map(|blur| Lens::new(camera, blur)),
            camera_interiors: camera.projection.has_one_center().then(|| match features.interiors_matter() {
                true => Interiors::at(world, camera.location),
                false => Interiors::default(),
            }),
            camera_near: CAMERA_NEAR * world.geometry.reach(camera.location).unwrap_or(1.0).min(1.0),
            photons: None,
            radiosity: radiosity.map(|radiosity| Shared::new(radiosity, options.known_light.as_deref())),
            subsurface,
            has_global_light: radiosity.is_some() || subsurface.is_some(),
            settling: world.media.iter().map(|medium| Settling::new(&medium.sampling)).collect(),
            has_air: options.atmosphere() && features.has_air(),
            side_by_side: one_ray_a_position(world)
                && (features.side_by_side_sky || features.side_by_side_textures > 0),
        }
    }
}

/// Whether each image position has one ray that always counts.
fn one_ray_a_position(world: &World) -> bool {
    let camera = &world.camera;
    camera.blur.is_none() && !matches!(camera.projection, Projection::Mesh(_)) && world.settings.adc_bailout <= 1.0
}
