//! Light sources.

use super::{Object, PhotonFlags};
use crate::math::{DVec3, Rgb, Transform};
use std::sync::Arc;

/// `light_source { … }`, positions in the space that contains it.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct LightSource {
    pub location: DVec3,
    pub color: Rgb,
    pub kind: LightKind,
    pub parallel: bool,
    /// Unit axis, from `location` to `point_at` as they stood at the closing brace.
    pub axis: DVec3,
    pub point_at: DVec3,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub area: Option<AreaLight>,
    pub looks_like: Option<Arc<Object>>,
    pub projected_through: Option<Arc<Object>>,
    pub media_attenuation: bool,
    pub media_interaction: bool,
    pub photons: PhotonFlags,
}

impl LightSource {
    /// A light of which nothing more is said.
    pub fn new(location: DVec3, color: Rgb) -> Self {
        Self {
            location,
            color,
            kind: LightKind::Point,
            parallel: false,
            axis: DVec3::Z,
            point_at: DVec3::Z,
            fade_distance: 0.0,
            fade_power: 0.0,
            area: None,
            looks_like: None,
            projected_through: None,
            media_attenuation: false,
            media_interaction: true,
            photons: PhotonFlags::NONE,
        }
    }
}

/// The last of `spotlight`, `cylinder`, `shadowless` wins.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum LightKind {
    Point,
    /// Angles in degrees, measured from the axis.
    Spot {
        radius_deg: f64,
        falloff_deg: f64,
        tightness: f64,
    },
    Cylinder {
        radius: f64,
        falloff: f64,
        tightness: f64,
    },
    Shadowless,
}

/// `area_light`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct AreaLight {
    pub axis1: DVec3,
    pub axis2: DVec3,
    pub size1: u32,
    pub size2: u32,
    /// `adaptive` level; 100 where none was given.
    pub adaptive: u32,
    pub jitter: bool,
    pub circular: bool,
    pub orient: bool,
    pub area_illumination: bool,
}

impl AreaLight {
    /// `adaptive` where none was given: all samples are taken.
    pub const NOT_ADAPTIVE: u32 = 100;
}

impl LightSource {
    /// Moves the light; radii, falloffs and fade distances keep their size, as in POV-Ray.
    pub fn apply(&mut self, transform: &Transform) {
        self.location = transform.point(self.location);
        self.point_at = transform.point(self.point_at);
        let axis = transform.vector(self.axis);
        self.axis = axis.try_normalize().unwrap_or(self.axis);
        if let Some(area) = &mut self.area {
            area.axis1 = transform.vector(area.axis1);
            area.axis2 = transform.vector(area.axis2);
        }
        for object in [&mut self.looks_like, &mut self.projected_through].into_iter().flatten() {
            Arc::make_mut(object).apply(transform);
        }
    }
}
