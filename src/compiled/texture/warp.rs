//! Steps on the way of a lookup point into a pattern.
//!
//! Source: section 12 of the pattern facts (measured).

use super::crackle::random_number;
use super::formula::cubic;
use crate::math::noise::{Octaves, lattice_hash, vector_turbulence, vector_turbulence_of_points};
use crate::math::{DAffine3, DMat3, DVec3, Points, floor, full_turn_angle, modulo};
use std::f64::consts::TAU;

/// One step, ready to apply to a point.
#[derive(Clone, Debug)]
pub enum Warp {
    /// Scales and moves along the axes, as most transformations of textures do.
    Scaling {
        /// Factor along each axis.
        factor: DVec3,
        /// Added after it.
        offset: DVec3,
    },
    /// Carries the point from the containing space inwards: `pattern_from_outer`.
    Affine(DAffine3),
    /// Repeats a slab along an axis.
    Repeat {
        /// 0 to 2.
        axis: usize,
        /// Width of the slab; may be negative.
        width: f32,
        /// Shift for each repetition.
        offset: DVec3,
        /// Axes that every other slab mirrors.
        flip: [bool; 3],
    },
    /// Adds a sum of vector noises.
    Turbulence {
        /// Strength per axis.
        amount: DVec3,
        /// Octaves.
        octaves: Octaves,
    },
    /// Pushes points away from centres, or draws them in.
    BlackHole(Box<BlackHole>),
    /// Wraps the plane around an axis, a point or a ring.
    Around {
        /// Around what.
        shape: Around,
        /// Unit vector; z leaves the result as it is.
        orientation: DVec3,
        /// Power of the distance that stretches the wrapped plane.
        dist_exp: f64,
    },
    /// Flattens one coordinate.
    Planar {
        /// Unit vector; z leaves the result as it is.
        orientation: DVec3,
        /// What takes the coordinate's place.
        distance: f64,
    },
    /// Unfolds the faces of a cube.
    Cubic,
}

/// What a plane is wrapped around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Around {
    /// The y axis.
    Cylinder,
    /// The origin.
    Sphere,
    /// A ring about the y axis, by its radius.
    Torus(f64),
}

/// A region of influence, possibly repeated.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct BlackHole {
    pub center: DVec3,
    pub radius: f64,
    pub strength: f64,
    pub falloff: f64,
    /// Draws in instead of pushing away.
    pub inverse: bool,
    /// Distance of repetitions; 0 along an axis without.
    pub repeat: Option<DVec3>,
    /// Random shift of repeated centres.
    pub turbulence: Option<DVec3>,
}

impl Warp {
    /// An affine map in its simplest form.
    pub fn affine(pattern_from_outer: DAffine3) -> Self {
        let factor = DVec3::from_array(std::array::from_fn(|i| pattern_from_outer.matrix3.col(i)[i]));
        if pattern_from_outer.matrix3 == DMat3::from_diagonal(factor) {
            Self::Scaling { factor, offset: pattern_from_outer.translation }
        } else {
            Self::Affine(pattern_from_outer)
        }
    }

    /// The linear part of an affine step.
    pub fn linear(&self) -> Option<DMat3> {
        match self {
            Self::Scaling { factor, .. } => Some(DMat3::from_diagonal(*factor)),
            Self::Affine(pattern_from_outer) => Some(pattern_from_outer.matrix3),
            _ => None,
        }
    }

    /// Carries a point one step inwards.
    #[inline]
    pub fn apply(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Scaling { factor, offset } => *factor * p + *offset,
            Self::Affine(pattern_from_outer) => pattern_from_outer.transform_point3(p),
            bent => bent.bend(p),
        }
    }

    /// Carries four points one step inwards.
    #[inline]
    pub fn apply_to_points(&self, points: &Points) -> Points {
        match self {
            Self::Scaling { factor, offset } => points.map_coordinates(|axis, c| factor[axis] * c + offset[axis]),
            Self::Turbulence { amount, octaves } => {
                points.moved(*amount, &vector_turbulence_of_points(*octaves, points))
            }
            other => points.map(|p| other.apply(p)).into(),
        }
    }

    /// A step that is no affine map.
    #[inline(never)]
    fn bend(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Scaling { .. } | Self::Affine(_) => self.apply(p),
            Self::Repeat { axis, width, offset, flip } => repeat(p, *axis, *width, *offset, *flip),
            Self::Turbulence { amount, octaves } => p + *amount * vector_turbulence(*octaves, p),
            Self::BlackHole(hole) => hole.apply(p),
            Self::Around { shape, orientation, dist_exp } => oriented(around(*shape, *dist_exp, p), *orientation),
            Self::Planar { orientation, distance } => oriented(DVec3::new(p.x, p.y, *distance), *orientation),
            Self::Cubic => unfolded(p),
        }
    }
}

fn repeat(mut p: DVec3, axis: usize, width: f32, offset: DVec3, flip: [bool; 3]) -> DVec3 {
    let n = floor(p[axis] / f64::from(width));
    // POV-Ray's product is in single precision.
    p[axis] -= f64::from(n as f32 * width);
    if modulo(n, 2.0) == 1.0 {
        for i in 0..3 {
            p[i] = if flip[i] { -p[i] } else { p[i] };
        }
        if flip[axis] {
            p[axis] += f64::from(width);
        }
    }
    p + n * offset
}

impl BlackHole {
    fn apply(&self, p: DVec3) -> DVec3 {
        let center = self.repeat.map_or(self.center, |repeat| self.nearby_center(repeat, p));
        let offset = p - center;
        let length = offset.length();
        if length >= self.radius {
            return p;
        }
        let pull = (self.strength * ((self.radius - length) / self.radius).powf(self.falloff)).min(1.0);
        if self.inverse { p - pull * offset } else { p + pull * offset }
    }

    /// The centre of the repetition that holds `p`, shifted at random.
    fn nearby_center(&self, repeat: DVec3, p: DVec3) -> DVec3 {
        let mut center = self.center;
        let mut block = [0_i64; 3];
        for i in 0..3 {
            if repeat[i] > 0.0 {
                block[i] = floor(p[i] / repeat[i]) as i64;
            }
        }
        if let Some(turbulence) = self.turbulence {
            let s = lattice_hash(block[0], block[1], block[2]);
            for i in 0..3 {
                center[i] += random_number(s + i) * turbulence[i];
            }
        }
        for i in 0..3 {
            center[i] += repeat[i] * block[i] as f64;
        }
        center
    }
}

/// Turns a mapped point from z to another orientation.
fn oriented(p: DVec3, o: DVec3) -> DVec3 {
    if o == DVec3::Z {
        return p;
    }
    DVec3::new(o.x * p.z + (o.y + o.z) * p.x, (o.x + o.z) * p.y - o.y * p.z, -o.x * p.x + o.y * p.y + o.z * p.z)
}

/// The angle of (x, z) from +x toward +z, as a part of a whole turn.
fn turns(p: DVec3) -> f64 {
    if p.x == 0.0 && p.z == 0.0 { 0.0 } else { full_turn_angle(p.z, p.x) / TAU }
}

fn around(shape: Around, dist_exp: f64, p: DVec3) -> DVec3 {
    let rho = (p.x * p.x + p.z * p.z).sqrt();
    let stretch = |length: f64| if dist_exp == 0.0 { 1.0 } else { length.powf(dist_exp) };
    match shape {
        Around::Cylinder if rho == 0.0 => p,
        Around::Cylinder => DVec3::new(turns(p) * stretch(rho), p.y, rho),
        Around::Sphere => {
            let length = p.length();
            if length == 0.0 {
                return p;
            }
            let latitude = 0.5 + (p.y / length).clamp(-1.0, 1.0).asin() / std::f64::consts::PI;
            DVec3::new(turns(p) * stretch(length), latitude * stretch(length), length)
        }
        Around::Torus(_) if rho == 0.0 => p,
        Around::Torus(major) => {
            let u = rho - major;
            let length = (u * u + p.y * p.y).sqrt();
            let angle = if length == 0.0 { 0.0 } else { (-u / length).clamp(-1.0, 1.0).acos() };
            let angle = if p.y > 0.0 { TAU - angle } else { angle };
            DVec3::new(turns(p) * stretch(length), angle / TAU * stretch(length), length)
        }
    }
}

/// Faces of the cube as they lie on its unfolded net of four by three.
fn unfolded(p: DVec3) -> DVec3 {
    let m = p.abs().max_element();
    if m == 0.0 {
        return p;
    }
    let q = p / m;
    let across = |c: f64| (c + 1.0) / 8.0;
    let up = |c: f64| (c + 1.0) / 6.0;
    let third = 1.0 / 3.0;
    let (u, v) = match cubic(p) as u32 {
        0 => (0.75 - across(q.z), third + up(q.y)),
        1 => (0.25 + across(q.x), 1.0 - up(q.z)),
        2 => (0.25 + across(q.x), third + up(q.y)),
        3 => (across(q.z), third + up(q.y)),
        4 => (0.25 + across(q.x), up(q.z)),
        _ => (1.0 - across(q.x), third + up(q.y)),
    };
    DVec3::new(u, v, m)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(offset: DVec3, flip: [bool; 3], expected: [f64; 3]) {
        let warp = Warp::Repeat { axis: 0, width: 0.7, offset, flip };
        let found = warp.apply(DVec3::new(1.3, 0.7, -1.2));
        assert!((found - DVec3::from(expected)).abs().max_element() < 1e-8, "{found}");
    }

    #[test]
    fn repeat_is_that_of_povray() {
        check(DVec3::ZERO, [false; 3], [0.600000012, 0.7, -1.2]);
        check(DVec3::ZERO, [true, false, false], [0.099999976, 0.7, -1.2]);
        check(DVec3::new(0.1, 0.2, 0.0), [true, true, false], [0.199999976, -0.5, -1.2]);
    }

    fn check_at(warp: &Warp, expected: [f64; 3]) {
        let found = warp.apply(DVec3::new(0.3, 0.7, -1.2));
        assert!((found - DVec3::from(expected)).abs().max_element() < 1e-9, "{warp:?}: {found}");
    }

    #[test]
    fn mappings_are_those_of_povray() {
        let plain = |shape| Warp::Around { shape, orientation: DVec3::Z, dist_exp: 0.0 };
        let turned = |shape| Warp::Around { shape, orientation: DVec3::Y, dist_exp: 1.0 };
        check_at(&plain(Around::Cylinder), [0.788989565, 0.7, 1.236931688]);
        check_at(&turned(Around::Cylinder), [0.975926194, -1.236931688, 0.7]);
        check_at(&plain(Around::Sphere), [0.788989565, 0.663923532, 1.421267040]);
        check_at(&turned(Around::Sphere), [1.121364864, -1.421267040, 0.943612633]);
        check_at(&plain(Around::Torus(1.0)), [0.788989565, 0.698056625, 0.739010571]);
        check_at(&turned(Around::Torus(1.0)), [0.583071629, -0.739010571, 0.515871225]);
    }

    #[test]
    fn black_holes_are_those_of_povray() {
        let hole = |inverse| {
            Warp::BlackHole(Box::new(BlackHole {
                center: DVec3::ZERO,
                radius: 2.0,
                strength: 1.0,
                falloff: 2.0,
                inverse,
                repeat: None,
                turbulence: None,
            }))
        };
        check_at(&hole(false), [0.325119888, 0.758613072, -1.300479552]);
        check_at(&hole(true), [0.274880112, 0.641386928, -1.099520448]);
    }
}
