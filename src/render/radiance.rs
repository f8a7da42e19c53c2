//! Light along a ray.

use crate::math::Rgb;

/// Light along a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Radiance {
    /// Linear or not, as the scene's working values are.
    pub rgb: Rgb,
    /// What part of a backdrop behind everything would be seen.
    pub transparency: f32,
}

impl Radiance {
    /// What a refused ray gives.
    pub(super) const BLACK: Self = Self { rgb: Rgb::ZERO, transparency: 0.0 };
    /// What a picture shows where the camera sends no ray.
    pub(super) const CLEAR: Self = Self { rgb: Rgb::ZERO, transparency: 1.0 };

    /// Light that hides any backdrop.
    pub(super) fn opaque(rgb: Rgb) -> Self {
        Self { rgb, transparency: 0.0 }
    }
}

/// What is found at several places and mixed by their weights: light, or what lets it through.
pub(super) trait Mix: Default {
    /// Adds a share of another.
    fn add_scaled(&mut self, other: &Self, weight: f32);
    /// A share of this.
    #[must_use]
    fn scaled(self, weight: f32) -> Self;
}

impl Mix for Radiance {
    fn add_scaled(&mut self, other: &Self, weight: f32) {
        self.rgb += weight * other.rgb;
        self.transparency += weight * other.transparency;
    }

    fn scaled(self, weight: f32) -> Self {
        Self { rgb: weight * self.rgb, transparency: weight * self.transparency }
    }
}

impl Mix for Rgb {
    fn add_scaled(&mut self, other: &Self, weight: f32) {
        *self += weight * *other;
    }

    fn scaled(self, weight: f32) -> Self {
        weight * self
    }
}
