//! Where rays go on from a surface: mirrored, straight through, refracted, in bands of wavelengths.
//!
//! Source: sections 7 and 8 of the shading facts (measured).

use super::dispersion;
use crate::compiled::World;
use crate::compiled::texture::Finish;
use crate::math::{DVec3, Rgb, gray};
use crate::render::film::Term;
use crate::render::medium::{Crossing, Interiors};
use crate::render::path::Path;
use crate::render::radiance::Radiance;
use crate::render::random::{Branch, Random};
use crate::render::shade::finish::irid;
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;

/// POV-Ray's difference from 1 below which a ray goes straight on.
const STRAIGHT: f64 = 1e-10;

/// What light from the far side of a surface crosses.
pub(super) struct Boundary<'t> {
    /// Unit normal of the uppermost layer.
    pub(super) normal: DVec3,
    /// What all layers let through.
    pub(super) filter: Rgb,
    /// The finish whose legacy keywords count.
    pub(super) legacy: Option<&'t Finish>,
    /// The uppermost layer's finish.
    pub(super) top: Option<&'t Finish>,
    /// Random choices in the texture.
    pub(super) random: Random,
}

/// How rays go on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bend {
    /// The same way, at the same level.
    Straight,
    /// One ray along a unit direction.
    Refracted(DVec3),
    /// White light in so many bands, each bent by itself.
    Dispersed(u32),
    /// None goes through: it is mirrored on this side.
    TotalReflection,
}

/// Rays through a surface.
pub(super) struct Refraction {
    bend: Bend,
    crossing: Crossing,
    /// On the far side.
    interiors: Interiors,
    /// Fade inside an object that is left, and the legacy factor.
    attenuation: Rgb,
}

/// A ray that goes on.
pub(super) struct Secondary {
    pub(super) path: Path,
    /// Factor of its light among all bands.
    pub(super) hue: Rgb,
}

impl Refraction {
    pub(super) fn new(worker: &mut Worker<'_>, vertex: &Vertex<'_>, boundary: &Boundary<'_>) -> Self {
        let world = worker.world();
        let surface = vertex.surface;
        let interior = world.interior(surface.interior.interior);
        let mut interiors = vertex.interiors().clone();
        let crossing = interiors.cross_at(world, surface, (vertex.view(), vertex.path.kind), &mut worker.scratch);
        let factor = boundary.legacy.map_or(interior.refraction, |finish| finish.refraction.unwrap_or(1.0));
        let mut attenuation = Rgb::splat(factor);
        if let Some(fade) = interior.fade.filter(|_| crossing.leaving) {
            attenuation *= fade.transmittance(vertex.length);
        }
        let (eta, dispersion) = (crossing.eta(), crossing.dispersion());
        let disperses = (dispersion - 1.0).abs() >= STRAIGHT;
        let bend = match vertex.path.wavelength {
            _ if (eta - 1.0).abs() < STRAIGHT && !disperses => Bend::Straight,
            None if disperses => Bend::Dispersed(interior.dispersion_samples.max(2)),
            wavelength => {
                let eta = wavelength.map_or(eta, |w| dispersion::index_ratio(eta, dispersion, w));
                refracted(vertex.view(), boundary.normal, eta).map_or(Bend::TotalReflection, Bend::Refracted)
            }
        };
        Self { bend, crossing, interiors, attenuation }
    }

    /// How many rays go on.
    pub(super) fn n_rays(&self) -> u32 {
        if let Bend::Dispersed(n) = self.bend { n } else { 1 }
    }

    /// What the light counts as: none gets through where all is reflected.
    pub(super) fn term(&self) -> Term {
        if self.bend == Bend::TotalReflection { Term::Reflection } else { Term::Refraction }
    }

    /// Ray number `i` of [`Self::n_rays`].
    #[inline(always)]
    pub(super) fn ray(&self, vertex: &Vertex<'_>, boundary: &Boundary<'_>, i: u32) -> Secondary {
        let weight = vertex.path.weight * boundary.filter.abs().max_element();
        let random = boundary.random.branch(Branch::Transmission(i));
        let beyond = |direction: DVec3, wavelength: Option<f64>| {
            let level = vertex.path.level + u32::from(self.bend != Bend::Straight);
            let (ray, range) = vertex.leave(direction);
            let kind = vertex.path.kind.transmitted();
            let (bounce, below) = (vertex.path.bounce, vertex.path.below);
            Path {
                ray,
                range,
                bounce,
                below,
                kind,
                level,
                weight,
                interiors: self.interiors.clone(),
                wavelength,
                random,
            }
        };
        let path = match self.bend {
            Bend::Straight => beyond(vertex.view(), vertex.path.wavelength),
            Bend::Refracted(direction) => beyond(direction, vertex.path.wavelength),
            Bend::Dispersed(n) => {
                let (wavelength, hue) = dispersion::band(i, n);
                let eta = dispersion::index_ratio(self.crossing.eta(), self.crossing.dispersion(), wavelength);
                let path = match refracted(vertex.view(), boundary.normal, eta) {
                    Some(direction) => beyond(direction, Some(wavelength)),
                    None => mirrored(vertex, boundary.normal, weight, random),
                };
                return Secondary { path, hue };
            }
            Bend::TotalReflection => mirrored(vertex, boundary.normal, weight, random),
        };
        Secondary { path, hue: Rgb::ONE }
    }

    /// The sum of what all rays brought back, as it leaves the surface.
    pub(super) fn weighted(
        &self,
        world: &World,
        vertex: &Vertex<'_>,
        boundary: &Boundary<'_>,
        sum: Radiance,
    ) -> Radiance {
        if self.bend == Bend::TotalReflection {
            let film = match boundary.top.filter(|finish| finish.irid_amount != 0.0) {
                Some(finish) => {
                    let direction = mirror_direction(vertex.view(), boundary.normal, vertex.facing);
                    let wavelength = world.settings.irid_wavelength;
                    irid(finish, wavelength, vertex.point(), direction, boundary.normal, vertex.view())
                }
                None => Rgb::ONE,
            };
            return Radiance::opaque(self.attenuation * (sum.rgb * film));
        }
        let factor = self.attenuation * boundary.filter;
        let share = 1.0 / self.n_rays() as f32;
        // The backdrop shows through by the same factors, as greys; not through what disperses, as in POV-Ray.
        let shows = if matches!(self.bend, Bend::Dispersed(_)) { 0.0 } else { 1.0 };
        let backdrop = shows * gray(factor).abs().min(gray(boundary.filter).abs()).min(1.0);
        Radiance { rgb: factor * (share * sum.rgb), transparency: backdrop * (share * sum.transparency) }
    }
}

/// The mirrored ray about a normal; it stays in the objects in which it came.
#[inline(always)]
pub(super) fn mirrored(vertex: &Vertex<'_>, normal: DVec3, weight: f32, random: Random) -> Path {
    let (ray, range) = vertex.leave(mirror_direction(vertex.view(), normal, vertex.facing));
    Path {
        ray,
        range,
        bounce: vertex.path.bounce,
        below: vertex.path.below,
        kind: vertex.path.kind.mirrored(),
        level: vertex.path.level + 1,
        weight,
        interiors: vertex.interiors().clone(),
        wavelength: vertex.path.wavelength,
        random,
    }
}

/// Mirror direction, kept on the ray's side of the surface.
///
/// Source: section 7.3 of the shading facts.
fn mirror_direction(direction: DVec3, normal: DVec3, facing: DVec3) -> DVec3 {
    let about = |v: DVec3, n: DVec3| v - 2.0 * v.dot(n) * n;
    let mut mirrored = about(direction, normal);
    if mirrored.dot(facing) < 0.0 {
        mirrored = if mirrored.dot(normal) < 0.0 { about(direction, facing) } else { about(mirrored, facing) };
    }
    mirrored.normalize_or(facing)
}

/// Snell's law for a unit direction; `None` for total reflection.
///
/// The part across the normal is what Snell's law is about: taken from the direction itself, not from the cosine, it stays
/// exact however near to the normal a strong refraction brings a ray.
pub(super) fn refracted(direction: DVec3, normal: DVec3, eta: f64) -> Option<DVec3> {
    let normal = if direction.dot(normal) <= 0.0 { normal } else { -normal };
    let across = eta * (direction - direction.dot(normal) * normal);
    let along_squared = 1.0 - across.length_squared();
    (along_squared >= 0.0).then(|| (across - along_squared.sqrt() * normal).normalize_or(direction))
}
