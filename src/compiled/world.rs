//! All that rendering needs, in one place.

use super::atmosphere::Atmosphere;
use super::camera::Camera;
use super::features::Features;
use super::geometry::{Geometry, InteriorId, LightGroupId, TextureId, Touching};
use super::handle::Table;
use super::interior::Interior;
use super::labels::Labels;
use super::light::Light;
use super::medium::Medium;
use super::photons::Photons;
use super::radiosity::Radiosity;
use super::subsurface::Subsurface;
use super::texture::Texture;
use crate::imaging::Curve;
use crate::math::Rgb;
use std::sync::Arc;

/// A compiled scene. Every handle in the geometry is valid here.
#[derive(Debug)]
pub struct World {
    /// What rays meet.
    pub geometry: Geometry,
    /// How surfaces look.
    pub textures: Table<TextureId, Texture>,
    /// Of each texture, whether no light comes through anywhere.
    pub opaque: Table<TextureId, bool>,
    /// What fills objects.
    pub interiors: Table<InteriorId, Arc<Interior>>,
    /// What is in interiors and in the atmosphere.
    pub media: Vec<Medium>,
    /// Lights of the whole scene, in file order, then those of groups.
    pub lights: Vec<Light>,
    /// Indices of those that shine outside of groups.
    pub global_lights: Vec<usize>,
    /// Of each group, indices of the lights that shine there.
    pub group_lights: Table<LightGroupId, Vec<usize>>,
    /// Where the picture is taken from.
    pub camera: Camera,
    /// Sky and fog.
    pub atmosphere: Atmosphere,
    /// Limits and constants of shading.
    pub settings: Settings,
    /// How light between surfaces is gathered, if it is.
    pub radiosity: Option<Radiosity>,
    /// How photons are shot and gathered, if they are.
    pub photons: Option<Photons>,
    /// How light below surfaces is sampled, if it is.
    pub subsurface: Option<Subsurface>,
    /// Names, for layers.
    pub labels: Labels,
    /// Where objects that bend or dim light may touch.
    pub touching: Touching,
    /// What of all this there is.
    pub features: Features,
}

impl World {
    /// The world as rays meet it, as an indented tree: what stands in which group, solid and place, its box, and which
    /// texture it shows; then lights, and how much there is of what. The same for the same scene, every time.
    pub fn dump(&self) -> String {
        use std::fmt::Write as _;
        let mut out = self.geometry.dump();
        for (i, light) in self.lights.iter().enumerate() {
            let kind = if i < self.global_lights.len() { "light" } else { "light of a group" };
            let (at, color) = (light.location, light.color);
            let _ = writeln!(
                out,
                "{kind} {i} at <{}, {}, {}> rgb <{}, {}, {}>",
                at.x, at.y, at.z, color.x, color.y, color.z
            );
        }
        out.extend(self.subsurface.map(|subsurface| subsurface.dump()));
        for (what, count) in self.summary() {
            let _ = writeln!(out, "{what:<22}{count:>12}");
        }
        out
    }

    /// How much there is of what, in a fixed order.
    pub fn summary(&self) -> Vec<(&'static str, usize)> {
        let mut summary = self.geometry.summary();
        summary.extend([
            ("textures", self.textures.len()),
            ("interiors", self.interiors.len()),
            ("lights", self.lights.len()),
            ("lights of groups", self.lights.len() - self.global_lights.len()),
            ("light groups", self.group_lights.len()),
        ]);
        summary.extend(self.features.summary());
        summary
    }
}

/// Limits and constants of shading.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Bends and reflections of a ray, the camera ray being 1.
    pub max_trace_level: u32,
    /// Rays that count less than this are black.
    pub adc_bailout: f32,
    /// Wavelengths of red, green and blue for thin films.
    pub irid_wavelength: Rgb,
    /// Scenes below version 3.7 weigh a surface's own light by `1 - filter * max(rgb) - transmit`.
    pub legacy_opacity: bool,
    /// Curve from working values to linear light.
    pub transfer: Transfer,
    /// Working values are those that files show: an old scene without gamma.
    pub display_values: bool,
}

/// From a scene's working values to linear light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transfer {
    /// They are linear.
    Linear,
    /// A power; negative values become 0.
    Power(f64),
    /// The sRGB curve.
    Srgb,
}

impl Transfer {
    /// The same in a file's words.
    pub fn curve(self) -> Curve {
        match self {
            Self::Linear => Curve::Power(1.0),
            Self::Power(gamma) => Curve::Power(gamma),
            Self::Srgb => Curve::Srgb,
        }
    }

    /// Linear light of a working value.
    pub fn linear(self, v: f32) -> f32 {
        match self {
            Self::Linear => v,
            Self::Power(gamma) => f64::from(v.max(0.0)).powf(gamma) as f32,
            Self::Srgb => crate::imaging::linear_from_srgb(v),
        }
    }
}

impl World {
    /// The texture behind a handle.
    pub fn texture(&self, id: TextureId) -> &Texture {
        &self.textures[id]
    }

    /// The interior behind a handle.
    pub fn interior(&self, id: InteriorId) -> &Interior {
        &self.interiors[id]
    }

    /// Indices of the lights that shine on a member of a group, or on anything outside of groups.
    pub fn lights_for(&self, group: Option<LightGroupId>) -> &[usize] {
        group.map_or(&self.global_lights, |group| &self.group_lights[group])
    }
}
