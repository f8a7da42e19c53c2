//! Surface coordinates.

use super::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Surface coordinates, worked out when somebody asks for them: few textures do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Uv {
    /// Known.
    At(DVec2),
    /// Longitude and latitude of a direction seen from the middle of a sphere, any length.
    Around(DVec3),
    /// Longitude of a direction in the xz plane, any length; the other coordinate is known.
    Turned(DVec2, f64),
    /// On a torus around the y axis: the direction in the xz plane, and that from the ring to the point (outward, up),
    /// any lengths.
    Ring(DVec2, DVec2),
}

impl Default for Uv {
    fn default() -> Self {
        Self::At(DVec2::ZERO)
    }
}

impl Uv {
    /// The coordinates.
    pub fn get(self) -> DVec2 {
        match self {
            Self::At(uv) => uv,
            Self::Around(direction) => spherical_uv(direction.normalize_or(DVec3::X)),
            Self::Turned(outward, v) => {
                DVec2::new(spherical_uv(DVec3::new(outward.x, 0.0, outward.y).normalize_or(DVec3::X)).x, v)
            }
            Self::Ring(around, across) => {
                DVec2::new(0.5 - around.y.atan2(around.x) / TAU, 0.5 + across.y.atan2(across.x) / TAU)
            }
        }
    }

    /// Where patterns are looked up by them: (u, v, 0).
    pub fn lookup_point(self) -> DVec3 {
        self.get().extend(0.0)
    }
}

/// Longitude from +x towards +z and latitude from -y to +y of a unit vector, each over 0 ..= 1.
pub fn spherical_uv(n: DVec3) -> DVec2 {
    /// POV-Ray's threshold for a pole: the squared distance from the axis.
    const POV_POLE: f64 = 1e-10;
    let u = if n.x * n.x + n.z * n.z <= POV_POLE { 0.0 } else { full_turn_angle(n.z, n.x) / TAU };
    DVec2::new(u, 0.5 + n.y.clamp(-1.0, 1.0).asin() / PI)
}

/// The angle of the direction (x, y) from +x toward +y, from 0 to a whole turn.
#[inline]
pub fn full_turn_angle(y: f64, x: f64) -> f64 {
    let angle = y.atan2(x);
    if angle < 0.0 { angle + TAU } else { angle }
}
