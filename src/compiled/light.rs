//! Lights as shading asks them: in which direction, how far, how bright.
//!
//! Space: world. Source: section 3 of the shading facts (measured).

use super::geometry::Geometry;
use super::photons::PhotonRole;
use crate::math::{DVec3, Rgb, power};

/// A light source.
#[derive(Debug)]
pub struct Light {
    /// Where it stands; the middle of an area light.
    pub location: DVec3,
    /// Its colour; channels may be negative.
    pub color: Rgb,
    /// Brightness up to which light of it counts as black.
    pub dark: f32,
    /// How brightness depends on the direction.
    pub beam: Beam,
    /// Unit direction in which it points.
    pub axis: DVec3,
    /// What it points at.
    pub point_at: DVec3,
    /// All its light runs along the axis.
    pub parallel: bool,
    /// Casts no shadow and gives no highlights.
    pub shadowless: bool,
    /// Distance at which the brightness is as given, and the power of its decay.
    pub fade: Option<(f64, f64)>,
    /// Its extent, if any.
    pub area: Option<Area>,
    /// Lights both sides of every surface.
    pub two_sided: bool,
    /// Shines only through this.
    pub projected_through: Option<Box<Geometry>>,
    /// Fog and the atmosphere's media weaken it.
    pub media_attenuation: bool,
    /// It lights media.
    pub lights_media: bool,
    /// What its photons may do.
    pub photons: PhotonRole,
    /// Each of its samples shoots photons.
    pub samples_shoot: bool,
}

/// Angular falloff.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Beam {
    /// The same in all directions.
    Even,
    /// A cone.
    Spot {
        /// Cosine of the half angle of the bright core.
        cos_radius: f64,
        /// Cosine of the half angle where the light ends.
        cos_falloff: f64,
        /// Exponent of the cosine.
        tightness: f64,
    },
    /// A tube.
    Cylinder {
        /// Radius of the bright core.
        radius: f64,
        /// Radius where the light ends.
        falloff: f64,
        /// Exponent of the distance from the edge.
        tightness: f64,
    },
}

/// A grid of lights.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    /// Edge of the grid with `n1` samples.
    pub axis1: DVec3,
    /// Edge of the grid with `n2` samples.
    pub axis2: DVec3,
    /// Samples along the first axis.
    pub n1: usize,
    /// Samples along the second axis.
    pub n2: usize,
    /// Levels that are always subdivided.
    pub adaptive: u32,
    /// Samples are displaced at random.
    pub jitter: bool,
    /// The grid is bent into a disc.
    pub circular: bool,
    /// The grid turns to face each point.
    pub orient: bool,
    /// Samples also shade, not only cast shadows.
    pub illumination: bool,
}

/// What of a light arrives at a point when nothing is in its way.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// Unit direction from the point to the light.
    pub direction: DVec3,
    /// How far the light is; along the axis for parallel lights, where it may be negative.
    pub distance: f64,
    /// Colour with angular and distance attenuation.
    pub color: Rgb,
}

impl Light {
    /// POV-Ray's limit up to which light counts as black; of a light dimmer than 1 it is a share of its colour.
    pub fn dark(color: Rgb) -> f32 {
        1e-10 * color.abs().max_element().min(1.0)
    }

    /// Whether of its own colour so little is left that it counts as black.
    pub fn is_spent(&self, color: Rgb) -> bool {
        color.abs().max_element() <= self.dark
    }

    /// Direction and distance to the light or one of its samples at `source`.
    ///
    /// Each sample of a parallel area light shines from where it stands toward `point_at`, and has a plane across that.
    #[inline(always)]
    pub fn toward(&self, point: DVec3, source: DVec3) -> (DVec3, f64) {
        let to = source - point;
        if !self.parallel {
            let distance = to.length();
            return (if distance > 0.0 { to / distance } else { DVec3::Y }, distance);
        }
        let direction = match &self.area {
            Some(_) => (source - self.point_at).normalize_or(-self.axis),
            None => -self.axis,
        };
        (direction, to.dot(direction))
    }

    /// The light that arrives from `source` when nothing is in its way.
    #[inline(always)]
    pub fn arrival(&self, point: DVec3, source: DVec3) -> Arrival {
        let (direction, distance) = self.toward(point, source);
        let factor = self.angular(point, direction) * self.distance_fade(distance);
        Arrival { direction, distance, color: self.color * factor as f32 }
    }

    /// Factor by which the beam weakens light at a point, `direction` being that to the light.
    pub fn angular(&self, point: DVec3, direction: DVec3) -> f64 {
        match self.beam {
            Beam::Even => 1.0,
            Beam::Spot { cos_radius, cos_falloff, tightness } => {
                let cosine = -self.axis.dot(direction);
                // Of parallel light all comes from straight ahead, but nothing from behind the light's plane.
                if cosine <= 0.0 || self.parallel && (point - self.location).dot(self.axis) < 0.0 {
                    return 0.0;
                }
                let soft = cos_radius > 0.0 && cosine < cos_radius;
                power(cosine, tightness) * if soft { smooth_step(cos_falloff, cos_radius, cosine) } else { 1.0 }
            }
            Beam::Cylinder { radius, falloff, tightness } => {
                let from = point - self.location;
                let along = from.dot(self.axis);
                let across = (from.length_squared() - along * along).max(0.0).sqrt();
                if along <= 0.0 || across >= falloff {
                    return 0.0;
                }
                let inner = 1.0 - across / falloff;
                let soft = radius > 0.0 && across > radius;
                power(inner, tightness) * if soft { smooth_step(0.0, 1.0 - radius / falloff, inner) } else { 1.0 }
            }
        }
    }

    /// Factor by which a way of that length weakens light.
    pub fn distance_fade(&self, distance: f64) -> f64 {
        match self.fade {
            // Points behind a parallel light have no distance from it: POV-Ray's result there is
            // meaningless or NaN, ours is as if they were at the light.
            Some((reference, exponent)) => 2.0 / (1.0 + power(distance.max(0.0) / reference, exponent)),
            None => 1.0,
        }
    }
}

impl Area {
    /// The grid's edges as seen from a point, `toward` being the unit direction to the middle.
    pub fn axes(&self, toward: DVec3) -> (DVec3, DVec3) {
        if !self.orient {
            return (self.axis1, self.axis2);
        }
        // POV-Ray's own limit for directions near z.
        let reference = if (toward.z.abs() - 1.0).abs() < 0.01 { DVec3::Y } else { DVec3::Z };
        let size = self.axis1.length();
        let axis1 = size * toward.cross(reference).normalize_or(DVec3::X);
        (axis1, size * toward.cross(axis1).normalize_or(DVec3::Y))
    }

    /// Displacement of a sample from the middle; `i` and `j` may lie between grid points.
    pub fn offset(&self, i: f64, j: f64, (axis1, axis2): (DVec3, DVec3)) -> DVec3 {
        let along = |v: f64, n: usize| if n > 1 { v / (n - 1) as f64 - 0.5 } else { 0.0 };
        let (mut a, mut b) = (along(i, self.n1), along(j, self.n2));
        if self.circular {
            // POV-Ray moves the grid off the axes by this much before it bends it.
            (a, b) = (a + 0.001, b + 0.001);
            let scale = a.abs().max(b.abs()) / a.hypot(b);
            (a, b) = (a * scale, b * scale);
        }
        a * axis1 + b * axis2
    }
}

/// 0 up to `low`, 1 from `high` on, smooth between.
fn smooth_step(low: f64, high: f64, x: f64) -> f64 {
    if x < low {
        return 0.0;
    }
    if x >= high {
        return 1.0;
    }
    let u = (x - low) / (high - low);
    u * u * (3.0 - 2.0 * u)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn light(location: [f64; 3], point_at: [f64; 3], beam: Beam) -> Light {
        let (location, point_at) = (DVec3::from(location), DVec3::from(point_at));
        Light {
            location,
            color: Rgb::splat(0.8),
            dark: Light::dark(Rgb::splat(0.8)),
            beam,
            axis: (point_at - location).normalize(),
            point_at,
            parallel: matches!(beam, Beam::Cylinder { .. }),
            shadowless: false,
            fade: None,
            area: None,
            two_sided: false,
            projected_through: None,
            media_attenuation: false,
            lights_media: true,
            photons: PhotonRole::default(),
            samples_shoot: false,
        }
    }

    /// A wall at the origin facing the light: section 3 of the shading facts.
    fn check(light: &Light, expected: f32) {
        let arrival = light.arrival(DVec3::ZERO, light.location);
        let found = arrival.color.x * arrival.direction.dot(-DVec3::Z) as f32;
        assert!((found - expected).abs() < 2e-5, "{found} instead of {expected}: {light:?}");
    }

    fn spot(degrees: f64, radius: f64, falloff: f64, tightness: f64) -> Light {
        let (cos_radius, cos_falloff) = (radius.to_radians().cos(), falloff.to_radians().cos());
        let beam = Beam::Spot { cos_radius, cos_falloff, tightness };
        light([0.0, 0.0, -9.0], [9.0 * degrees.to_radians().tan(), 0.0, 0.0], beam)
    }

    #[test]
    fn spots_fall_off_as_in_povray() {
        let standard =
            [(29.0, 0.8), (31.0, 0.792813), (35.0, 0.632258), (40.0, 0.248493), (44.0, 0.013489), (46.0, 0.0)];
        standard.iter().for_each(|(angle, expected)| check(&spot(*angle, 30.0, 45.0, 0.0), *expected));
        check(&spot(35.0, 20.0, 50.0, 10.0), 0.069581);
        check(&spot(15.0, 0.0, 30.0, 0.0), 0.671077);
        check(&spot(25.0, 30.0, 20.0, 0.0), 0.8);
        check(&spot(31.0, 30.0, 20.0, 0.0), 0.0);
        check(&spot(80.0, 90.0, 95.0, 0.0), 0.8);
    }

    #[test]
    fn cylinders_fall_off_as_in_povray() {
        let cylinder = |o: f64, radius: f64, falloff: f64, tightness: f64| {
            light([o, 0.0, -9.0], [o, 0.0, 0.0], Beam::Cylinder { radius, falloff, tightness })
        };
        let standard = [(0.7, 0.8), (0.8, 0.716793), (0.9, 0.281605), (0.99, 0.003738), (1.01, 0.0)];
        standard.iter().for_each(|(o, expected)| check(&cylinder(*o, 0.75, 1.0, 0.0), *expected));
        check(&cylinder(2.0, 1.0, 3.0, 2.0), 0.044450);
        check(&cylinder(2.0, 0.0, 3.0, 0.0), 0.8);
    }

    #[test]
    fn light_fades_and_parallel_light_is_even() {
        let faded =
            |z: f64, power: f64| Light { fade: Some((5.0, power)), ..light([0.0, 0.0, z], [0.0; 3], Beam::Even) };
        check(&faded(-9.9, 2.0), 0.325170);
        check(&faded(-9.9, 1.5), 0.422599);
        check(&faded(-1.0, 2.0), 2.0 * 0.769238);
        check(&Light { parallel: true, ..light([0.0, 0.0, -9.0], [9.0, 0.0, 0.0], Beam::Even) }, 0.565682);
        // Only a spotlight leaves dark what is behind its plane.
        let behind = |beam| Light { parallel: true, ..light([0.0, 0.0, 9.0], [0.0, 0.0, 18.0], beam) };
        assert!(behind(Beam::Even).arrival(DVec3::ZERO, 9.0 * DVec3::Z).color == Rgb::splat(0.8));
        let spot = Beam::Spot { cos_radius: 0.8, cos_falloff: 0.7, tightness: 0.0 };
        assert!(behind(spot).arrival(DVec3::ZERO, 9.0 * DVec3::Z).color == Rgb::ZERO);
    }
}
