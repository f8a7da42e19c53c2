//! Counts of what was done.

/// Rays by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Camera rays.
    pub camera_rays: u64,
    /// Rays through surfaces.
    pub transmitted_rays: u64,
    /// Mirrored rays.
    pub reflected_rays: u64,
    /// Rays that gather light for radiosity.
    pub sample_rays: u64,
    /// Rays towards lights, each piece between transparent surfaces.
    pub shadow_rays: u64,
    /// Rays towards lights that were not sent, because the surface is turned away or the light does not reach it.
    pub spared_shadow_rays: u64,
}

impl Statistics {
    /// In the order of the fields.
    pub fn counts(&self) -> [u64; 6] {
        let Self { camera_rays, transmitted_rays, reflected_rays, sample_rays, shadow_rays, spared_shadow_rays } =
            *self;
        [camera_rays, transmitted_rays, reflected_rays, sample_rays, shadow_rays, spared_shadow_rays]
    }

    /// The inverse of [`counts`](Self::counts).
    pub fn from_counts(
        [camera_rays, transmitted_rays, reflected_rays, sample_rays, shadow_rays, spared_shadow_rays]: [u64; 6],
    ) -> Self {
        Self { camera_rays, transmitted_rays, reflected_rays, sample_rays, shadow_rays, spared_shadow_rays }
    }

    /// All rays that were sent.
    pub fn rays(&self) -> u64 {
        self.camera_rays + self.transmitted_rays + self.reflected_rays + self.sample_rays + self.shadow_rays
    }

    /// Sums of both.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            camera_rays: self.camera_rays + other.camera_rays,
            transmitted_rays: self.transmitted_rays + other.transmitted_rays,
            reflected_rays: self.reflected_rays + other.reflected_rays,
            sample_rays: self.sample_rays + other.sample_rays,
            shadow_rays: self.shadow_rays + other.shadow_rays,
            spared_shadow_rays: self.spared_shadow_rays + other.spared_shadow_rays,
        }
    }
}
