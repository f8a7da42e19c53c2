//! From image positions to rays.
//!
//! Source: sections 1.4 and 1.6 of the camera facts (measured to the last bit of 16-bit images).

use crate::compiled::camera::{Camera, Projection};
use crate::compiled::texture::{Context, Frame};
use crate::math::{DMat3, DVec3, Ray};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A ray before its direction is normalised, and where a camera normal is looked up.
pub(in crate::render) struct RawRay {
    pub(in crate::render) origin: DVec3,
    pub(in crate::render) direction: DVec3,
    lookup: [f64; 2],
}

/// The omnimax lens: elevation for a distance from the middle of the picture.
const OMNIMAX: [f64; 3] = [1.411_269, -0.094_39, 0.256_74];
/// Aspect ratio of an omnimax film frame.
const OMNIMAX_ASPECT: f64 = 1.283_458;

impl RawRay {
    /// The ray through continuous position (`x`, `y`), integers being pixel centres, or `None`
    /// where the projection shows nothing.
    #[inline(always)]
    pub(in crate::render) fn through(camera: &Camera, x: f64, y: f64, width: usize, height: usize) -> Option<Self> {
        let (s, t) = ((x + 0.5) / width as f64 - 0.5, 0.5 - (y + 0.5) / height as f64);
        let (d, r, u) = (camera.direction, camera.right, camera.up);
        let (width, height) = (|| r.length(), || u.length());
        let axes = || (d.normalize_or(DVec3::Z), r.normalize_or(DVec3::X), u.normalize_or(DVec3::Y));
        let at = |origin: DVec3, direction: DVec3, lookup: [f64; 2]| Some(Self { origin, direction, lookup });
        let here = |direction: DVec3, lookup: [f64; 2]| at(camera.location, direction, lookup);
        match camera.projection {
            Projection::Perspective => here(d + s * r + t * u, [s, t]),
            Projection::Orthographic => at(camera.location + s * r + t * u, d, [s, t]),
            Projection::Fisheye { angle } => {
                let (x, y) = (2.0 * s * width(), 2.0 * t * height());
                let distance = x.hypot(y);
                let (phi, theta) = (y.atan2(x), distance * angle * 0.5);
                if distance > 1.0 { None } else { here(on_dome(axes(), phi, theta), [dome_lookup(phi), theta]) }
            }
            Projection::Omnimax => {
                let (phi, theta) = omnimax(s, t, width() / height())?;
                here(on_dome(axes(), phi, theta), [dome_lookup(phi), theta])
            }
            Projection::Panoramic => {
                let (a, b) = (PI * (0.5 - s), PI * t);
                here(a.cos() * r + b.tan() * u + a.sin() * d, [a, b])
            }
            Projection::UltraWideAngle { angle } => {
                let (a, b) = (s * angle, t * angle * height() / width());
                let (dn, rn, un) = axes();
                here(a.sin() * rn + b.sin() * un + a.cos() * b.cos() * dn, [a, b])
            }
            Projection::Cylinder { angle, kind } => {
                let (dn, rn, un) = axes();
                match kind {
                    1 | 3 => {
                        let (a, shift) = (s * angle, t * height() * un);
                        let turned = a.sin() * rn + a.cos() * dn;
                        let lookup = [a, t * height()];
                        if kind == 1 {
                            here(turned + shift, lookup)
                        } else {
                            at(camera.location + shift, turned, lookup)
                        }
                    }
                    _ => {
                        let (a, shift) = (t * angle, s * width() * rn);
                        let turned = a.sin() * un + a.cos() * dn;
                        let lookup = [s * width(), a];
                        if kind == 2 {
                            here(turned + shift, lookup)
                        } else {
                            at(camera.location + shift, turned, lookup)
                        }
                    }
                }
            }
            Projection::Spherical { horizontal, vertical } => {
                let (_, rn, un) = axes();
                let tilted = turned(d, rn, -t * vertical);
                here(turned(tilted, un, s * horizontal), [s * horizontal, t * vertical])
            }
            // Its rays start elsewhere: `mesh_camera`.
            Projection::Mesh(_) => None,
        }
    }

    /// The finished ray: unit direction, bent by the camera's normal.
    #[inline(always)]
    pub(in crate::render) fn finish(self, camera: &Camera) -> Ray {
        let direction = self.direction.normalize_or(DVec3::Z);
        let Some(normal) = &camera.normal else { return Ray::new(self.origin, direction) };
        let point = DVec3::new(self.lookup[0], self.lookup[1], 0.0);
        let context =
            Context { normal: direction, perturbed_normal: direction, direction, point, ..Context::default() };
        let bent = normal.perturb(direction, point, &Frame::default(), &context);
        Ray::new(self.origin, bent.normal.normalize_or(direction))
    }
}

/// Polar coordinates around the view direction.
fn on_dome((d, r, u): (DVec3, DVec3, DVec3), phi: f64, theta: f64) -> DVec3 {
    phi.cos() * theta.sin() * r + phi.sin() * theta.sin() * u + theta.cos() * d
}

/// The polar angle by which a camera normal is looked up: from -90 to 270 degrees, as POV-Ray measures it.
fn dome_lookup(phi: f64) -> f64 {
    if phi < -FRAC_PI_2 { phi + TAU } else { phi }
}

fn omnimax(s: f64, t: f64, aspect: f64) -> Option<(f64, f64)> {
    let (mut x, mut y) = (2.0 * s, 2.0 * t);
    if aspect > OMNIMAX_ASPECT {
        x *= aspect / OMNIMAX_ASPECT;
        y = (y - 1.0) / OMNIMAX_ASPECT + 1.0;
    } else if aspect > 1.0 {
        y = (y - 1.0) / aspect + 1.0;
    } else {
        y /= aspect;
    }
    let rho = x.hypot(y);
    let phi = y.atan2(x);
    let theta = rho * (OMNIMAX[0] + rho * rho * (OMNIMAX[1] + rho * rho * OMNIMAX[2]));
    (rho <= 1.0 && phi.sin() * theta.sin() >= -theta.cos()).then_some((phi, theta))
}

/// Right-hand rotation about a unit axis.
fn turned(v: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    DMat3::from_axis_angle(axis, angle) * v
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(projection: Projection, direction: [f64; 3], right: [f64; 3]) -> Camera {
        Camera {
            projection,
            location: DVec3::ZERO,
            direction: DVec3::from(direction),
            up: DVec3::Y,
            right: DVec3::from(right),
            normal: None,
            blur: None,
        }
    }

    /// Direction through the middle of pixel (0, 0) of a 3x3 picture.
    fn check(camera: &Camera, expected: [f64; 3]) {
        let ray = RawRay::through(camera, 0.0, 0.0, 3, 3).unwrap().finish(camera);
        assert!((ray.direction - DVec3::from(expected)).abs().max_element() < 1e-4, "{}", ray.direction);
    }

    #[test]
    fn corner_rays_are_those_of_povray() {
        check(&camera(Projection::Perspective, [0.0, 0.0, 1.0], [-4.0 / 3.0, 0.0, 0.0]), [0.3885, 0.2914, 0.8742]);
    }

    #[test]
    fn a_fisheye_shows_a_circle() {
        let fisheye = camera(Projection::Fisheye { angle: PI }, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
        assert!(RawRay::through(&fisheye, 0.0, 0.0, 100, 100).is_none());
        let edge = RawRay::through(&fisheye, -0.5, 49.5, 100, 100).unwrap();
        assert!((edge.direction + DVec3::X).length() < 1e-12);
    }
}
