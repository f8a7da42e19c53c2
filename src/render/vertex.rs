//! A point of light transport: where light is asked for, and from where rays go on.
//!
//! Visibility, direct light and what fills objects work from a [`Vertex`] alone. It is the only thing that knows how a
//! ray leaves: a point within a medium would be one that starts rays at itself.

use super::medium::Interiors;
use super::path::Path;
use crate::compiled::geometry::{LightGroupId, Surface};
use crate::math::{DVec3, Range, Ray};

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

/// The unit shading normal on the side from which a direction comes.
pub(super) fn facing(surface: &Surface, direction: DVec3) -> DVec3 {
    if surface.normal.dot(direction) > 0.0 { -surface.normal } else { surface.normal }
}
