//! Colours: linear RGB for light, five components for what a scene declares.

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
    /// Opaque black, also the colour of an empty pigment.
    pub const BLACK: Self = Self { rgb: Rgb::ZERO, filter: 0.0, transmit: 0.0 };

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
        Self {
            rgb: self.rgb + (other.rgb - self.rgb) * t,
            filter: self.filter + (other.filter - self.filter) * t,
            transmit: self.transmit + (other.transmit - self.transmit) * t,
        }
    }
}

/// Luminance with POV-Ray's weights (0.297, 0.589, 0.114).
pub fn gray(c: Rgb) -> f32 {
    0.297 * c.x + 0.589 * c.y + 0.114 * c.z
}
