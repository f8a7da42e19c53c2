//! A point of light transport: where light is asked for, and from where rays go on.
//!
//! Visibility, direct light and what fills objects work from a [`Vertex`] alone. It is the only thing that knows how a
//! ray leaves: a point within a medium would be one that starts rays at itself.

use super::medium::Interiors;
use super::path::Path;
use super::random::Random;
use crate::compiled::World;
use crate::compiled::geometry::{LightGroupId, Surface};
use crate::math::{DVec3, Range, Ray};

/// A place where light is asked for.
pub(super) trait Place {
    /// World space.
    fn point(&self) -> DVec3;
    /// The path that came, or passes, there.
    fn path(&self) -> &Path;
    /// What it is inside of.
    fn interiors(&self) -> &Interiors {
        &self.path().interiors
    }
    /// Random choices there.
    fn random(&self) -> Random;
    /// Whether photons stay there, so that light that they bring comes from them alone.
    fn collects_photons(&self, world: &World) -> bool;
    /// A ray from there along a unit direction, and where its hits count.
    fn leave(&self, direction: DVec3) -> (Ray, Range);
}

/// A place within a medium.
#[derive(Clone, Copy, Debug)]
pub(super) struct MediumPoint<'p> {
    /// World space.
    pub(super) point: DVec3,
    /// The path that passes there.
    pub(super) path: &'p Path,
    /// Random choices there.
    pub(super) random: Random,
}

impl Place for MediumPoint<'_> {
    fn point(&self) -> DVec3 {
        self.point
    }

    fn path(&self) -> &Path {
        self.path
    }

    fn random(&self) -> Random {
        self.random
    }

    fn collects_photons(&self, world: &World) -> bool {
        self.path.interiors.media(world).into_iter().any(|medium| world.media[medium].collects_photons)
    }

    /// Hits nearer than rounding may bring the point to the surface where the path starts do not count.
    fn leave(&self, direction: DVec3) -> (Ray, Range) {
        let rounding = crate::math::gamma(N_ROUNDINGS) * self.point.abs().max_element();
        let min = self.path.range.min.max(rounding);
        (Ray::new(self.point, direction), Range { min, max: f64::INFINITY })
    }
}

/// Roundings between the start of a path and a point on it: a product and a sum, and those of the start itself.
const N_ROUNDINGS: u32 = 8;

/// The end of a ray on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex<'p> {
    /// The ray that came here.
    pub(super) path: &'p Path,
    /// Its length.
    pub(super) length: f64,
    /// What it met.
    pub(super) surface: &'p Surface,
    /// Unit shading normal on the side of the ray, before any bump.
    pub(super) facing: DVec3,
}

impl<'p> Vertex<'p> {
    /// Where a ray of that length met a surface.
    pub(super) fn new(path: &'p Path, length: f64, surface: &'p Surface) -> Self {
        Self { path, length, surface, facing: facing(surface, path.ray.direction) }
    }

    /// World space.
    pub(super) fn point(&self) -> DVec3 {
        self.surface.point
    }

    /// Unit direction of the ray that came here.
    pub(super) fn view(&self) -> DVec3 {
        self.path.ray.direction
    }

    /// What the ray that came here is inside of.
    pub(super) fn interiors(&self) -> &'p Interiors {
        &self.path.interiors
    }

    /// Whose lights shine here.
    pub(super) fn light_group(&self) -> Option<LightGroupId> {
        self.surface.light_group
    }

    /// A ray from here along a unit direction, and where its hits count.
    pub(super) fn leave(&self, direction: DVec3) -> (Ray, Range) {
        self.surface.leave(direction)
    }
}

impl Place for Vertex<'_> {
    fn point(&self) -> DVec3 {
        Vertex::point(self)
    }

    fn path(&self) -> &Path {
        self.path
    }

    fn random(&self) -> Random {
        self.path.random
    }

    fn collects_photons(&self, world: &World) -> bool {
        world.geometry.photon_role(self.surface).collects()
    }

    fn leave(&self, direction: DVec3) -> (Ray, Range) {
        Vertex::leave(self, direction)
    }
}

/// The unit shading normal on the side from which a direction comes.
pub(super) fn facing(surface: &Surface, direction: DVec3) -> DVec3 {
    if surface.normal.dot(direction) > 0.0 { -surface.normal } else { surface.normal }
}
