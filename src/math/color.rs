//! Colours: linear RGB for light, five components for what a scene declares.

use glam::Vec4;

/// Linear red, green and blue, unclamped; light and reflectances.
///
/// Single precision, as POV-Ray keeps its colours.
pub type Rgb = glam::Vec3;

/// A declared colour: reflectance with its two kinds of transparency.
///
/// `filter` lets light through tinted by the colour, `transmit` lets it through
/// unchanged. All components are unclamped. Source: POV-Ray 3.7 manual, 3.3.1.7.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Color {
    /// Reflectance.
    pub rgb: Rgb,
    /// Share of light transmitted and tinted by `rgb`.
    pub filter: f32,
    /// Share of light transmitted untinted.
    pub transmit: f32,
}

impl Color {
    /// Lets light through unchanged that was filtered.
    pub fn unfilter(&mut self) {
        self.transmit += std::mem::take(&mut self.filter);
    }

    /// Opaque black, also the colour of an empty pigment.
    pub const BLACK: Self = Self { rgb: Rgb::ZERO, filter: 0.0, transmit: 0.0 };

    /// White that lets all light through: what a picture shows outside of itself.
    pub const CLEAR: Self = Self { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };

    /// An opaque colour.
    pub const fn rgb(red: f32, green: f32, blue: f32) -> Self {
        Self { rgb: Rgb::new(red, green, blue), filter: 0.0, transmit: 0.0 }
    }

    /// From the order in which the language stores it: red, green, blue, filter, transmit.
    pub fn from_array(c: [f64; 5]) -> Self {
        Self { rgb: Rgb::new(c[0] as f32, c[1] as f32, c[2] as f32), filter: c[3] as f32, transmit: c[4] as f32 }
    }

    /// Red, green, blue, filter, transmit.
    pub fn to_array(self) -> [f64; 5] {
        [self.rgb.x, self.rgb.y, self.rgb.z, self.filter, self.transmit].map(f64::from)
    }

    /// What part of light from behind comes through, per channel.
    pub fn transmittance(self) -> Rgb {
        self.rgb * self.filter + Rgb::splat(self.transmit)
    }

    /// One minus both transparencies; negative when they add up to more than one.
    pub fn opacity(self) -> f32 {
        1.0 - self.filter - self.transmit
    }

    /// Linear blend in all five components: `self` at `t == 0`, `other` at `t == 1`.
    #[inline]
    pub fn lerp(self, other: Self, t: f32) -> Self {
        let (from, to) = (self.tinted(), other.tinted());
        Self::from_tinted(from + (to - from) * t, self.transmit + (other.transmit - self.transmit) * t)
    }

    /// `weight` times another colour added in all five components.
    #[inline]
    #[must_use]
    pub fn plus(self, weight: f32, other: Self) -> Self {
        Self::from_tinted(self.tinted() + weight * other.tinted(), self.transmit + weight * other.transmit)
    }

    /// The first four components, which fill a register.
    #[inline(always)]
    fn tinted(self) -> Vec4 {
        self.rgb.extend(self.filter)
    }

    #[inline(always)]
    fn from_tinted(tinted: Vec4, transmit: f32) -> Self {
        Self { rgb: tinted.truncate(), filter: tinted.w, transmit }
    }
}

/// Luminance with POV-Ray's weights (0.297, 0.589, 0.114).
pub fn gray(c: Rgb) -> f32 {
    0.297 * c.x + 0.589 * c.y + 0.114 * c.z
}
