//! One worker: sends a ray, shades what it meets.

use super::camera::RawRay;
use super::focal_blur::Lens;
use super::gather::{Gather, Term};
use super::layers::Place;
use super::lights::LightCache;
use super::neighbours::Neighbour;
use super::options::Options;
use super::random::Random;
use super::ray::{Inside, Interiors, Path, Radiance, Statistics};
use crate::compiled::World;
use crate::compiled::atmosphere::Sky;
use crate::compiled::camera::Projection;
use crate::compiled::geometry::{Hit, RayKind, Scratch, Surface, TextureRef};
use crate::compiled::texture::{Context, Frame, Texture};
use crate::math::{DVec3, Range, Ray, Transform};
use std::borrow::Cow;
use std::rc::Rc;

/// POV-Ray's distance within which a camera ray meets nothing.
const CAMERA_NEAR: f64 = 1e-4;
/// POV-Ray's length of a ray that meets nothing, for fog.
const MISS_LENGTH: f64 = 2e10;

/// The state of one worker; owns its buffers, shares the world.
pub(super) struct Tracer<'w> {
    pub(super) world: &'w World,
    pub(super) options: &'w Options,
    pub(super) scratch: Scratch,
    /// Number of the light that shadow rays go to.
    pub(super) light: usize,
    pub(super) random: Random,
    pub(super) statistics: Statistics,
    /// Whether shadow rays need no more than a yes or no.
    pub(super) all_opaque: bool,
    /// Whether it makes a difference which objects a camera ray starts in.
    interiors_matter: bool,
    /// Whether neighbours among camera rays may share work.
    pub(super) side_by_side: bool,
    /// Whether they do where they see the sky.
    pub(super) sky_side_by_side: bool,
    /// Where the camera is, for projections with one centre.
    camera_interiors: Option<Interiors>,
    /// Of a camera with depth of field.
    pub(super) lens: Option<Rc<Lens>>,
}

impl<'w> Tracer<'w> {
    pub(super) fn new(world: &'w World, options: &'w Options) -> Self {
        let sky_side_by_side = world.atmosphere.sky.as_ref().is_some_and(Sky::is_side_by_side);
        let mut tracer = Self {
            world,
            options,
            scratch: Scratch::default(),
            light: 0,
            random: Random::default(),
            statistics: Statistics::default(),
            all_opaque: world.all_opaque(),
            interiors_matter: world.interiors_matter(),
            side_by_side: one_ray_a_position(world)
                && (sky_side_by_side || world.textures.iter().any(Texture::is_side_by_side)),
            sky_side_by_side,
            camera_interiors: None,
            lens: world.camera.blur.as_ref().map(|blur| Rc::new(Lens::new(&world.camera, blur))),
        };
        let moving = matches!(
            world.camera.projection,
            Projection::Orthographic | Projection::Cylinder { kind: 3 | 4, .. } | Projection::Mesh(_)
        );
        if !moving {
            tracer.camera_interiors = Some(tracer.interiors_at(world.camera.location));
        }
        tracer
    }

    pub(super) fn take_statistics(&mut self) -> Statistics {
        std::mem::take(&mut self.statistics)
    }

    /// The light through a continuous image position, pixel centres being integers.
    pub(super) fn camera_ray<G: Gather>(&mut self, x: f64, y: f64) -> G {
        self.start_at(x, y);
        let camera = &self.world.camera;
        if let Some(blur) = &camera.blur {
            return self.blurred(blur, x, y);
        }
        if let Projection::Mesh(mesh) = &camera.projection {
            return self.mesh_camera_ray(mesh, x, y);
        }
        match RawRay::through(camera, x, y, self.options.width, self.options.height) {
            Some(raw) => self.follow(raw.finish(camera), f64::INFINITY),
            None => nothing(),
        }
    }

    /// Follows a ray that starts at the camera and sees no farther than `far`; its direction is a unit vector.
    // Always inline, as what makes the ray: it is put together where it stays.
    #[inline(always)]
    pub(super) fn follow<G: Gather>(&mut self, ray: Ray, far: f64) -> G {
        let path = self.camera_path(ray, far);
        let mut found: G = self.trace(&path);
        found.note_sample();
        found
    }

    /// Draws random numbers from now on that belong to an image position.
    pub(super) fn start_at(&mut self, x: f64, y: f64) {
        self.random = Random::at(x, y);
    }

    /// The path of a ray that starts at the camera.
    #[inline(always)]
    pub(super) fn camera_path(&mut self, ray: Ray, far: f64) -> Path {
        self.statistics.camera_rays += 1;
        let known = self.camera_interiors.is_some() && self.is_clear(ray.origin);
        let interiors = match &self.camera_interiors {
            Some(known_interiors) if known => Interiors::from_slice(known_interiors),
            _ => self.interiors_at(ray.origin),
        };
        let range = Range { min: CAMERA_NEAR, max: far };
        let kind = RayKind::Camera;
        Path { ray, range, kind, level: 1, weight: 1.0, interiors, wavelength: None }
    }

    /// Whether nothing lies between the middle of the lens and a point of it: then both are inside the same objects.
    fn is_clear(&mut self, origin: DVec3) -> bool {
        let shift = origin - self.world.camera.location;
        if shift == DVec3::ZERO {
            return true;
        }
        let across = Ray::new(self.world.camera.location, shift);
        let range = Range { min: 0.0, max: 1.0 };
        self.world.geometry.intersect(&across, range, RayKind::Probe, &mut self.scratch).is_none()
    }

    fn interiors_at(&self, point: DVec3) -> Interiors {
        if !self.interiors_matter {
            return Interiors::new();
        }
        let entry = |key: crate::compiled::geometry::InteriorKey| {
            let interior = self.world.interior(key.interior);
            Inside {
                key,
                hollow: self.world.geometry.is_hollow(key),
                ior: interior.ior,
                dispersion: interior.dispersion,
            }
        };
        self.world.geometry.containing(point).into_iter().map(entry).collect()
    }

    /// The light that comes along a ray, towards its origin.
    pub(super) fn trace<G: Gather>(&mut self, path: &Path) -> G {
        if path.weight < self.world.settings.adc_bailout {
            return G::default();
        }
        let hit = self.world.geometry.intersect(&path.ray, path.range, path.kind, &mut self.scratch);
        match &hit {
            Some(hit) => {
                let surface = self.world.geometry.surface(&path.ray, hit);
                self.arrive(path, Some((hit, &surface)), None)
            }
            None => self.arrive(path, None, None),
        }
    }

    /// The light from what a ray met.
    #[inline(always)]
    fn arrive<G: Gather>(&mut self, path: &Path, met: Option<(&Hit, &Surface)>, only: Option<Only<'_>>) -> G {
        let Some((hit, surface)) = met else { return self.miss(path, self.sky(path)) };
        let mut found = G::default();
        self.shade(path, hit, surface, only, &mut found);
        self.dim(path, hit.t, &mut found);
        found
    }

    /// The light along a ray that meets nothing but a sky.
    fn miss<G: Gather>(&mut self, path: &Path, sky: Radiance) -> G {
        let mut found = G::default();
        found.add(Term::Background, sky);
        self.dim(path, MISS_LENGTH, &mut found);
        found
    }

    /// Lays what is in the air over what was found at the end of a ray.
    #[inline(always)]
    fn dim<G: Gather>(&mut self, path: &Path, length: f64, found: &mut G) {
        if let Some(veil) = self.veil(path, length) {
            found.veil(&veil);
        }
    }

    /// The light from the sky that a camera ray met.
    pub(super) fn seen_sky<G: Gather>(&mut self, path: &Path, sky: Radiance) -> G {
        let mut found: G = self.miss(path, sky);
        found.note_sample();
        found
    }

    /// The light from what a camera ray met.
    pub(super) fn seen<G: Gather>(&mut self, path: &Path, met: Option<(&Hit, &Surface)>, only: Option<Only<'_>>) -> G {
        let mut found: G = self.arrive(path, met, only);
        found.note_sample();
        found
    }

    #[inline(always)]
    fn shade<G: Gather>(&mut self, path: &Path, hit: &Hit, surface: &Surface, only: Option<Only<'_>>, found: &mut G) {
        let world = self.world;
        let neighbour = only.and_then(|only| only.neighbour);
        let context = context_at(surface, path.ray.direction);
        let mut place = Place { path, surface, context, length: hit.t, lights: LightCache::default(), neighbour };
        for seen in &surface.textures {
            if seen.weight < world.settings.adc_bailout {
                continue;
            }
            let now;
            let TextureSpace { point, texture_from_world } = match only {
                Some(only) => only.space,
                None => {
                    now = texture_space(world, surface, hit, seen);
                    &now
                }
            };
            let mut frame = Frame::new(texture_from_world.as_deref());
            let texture = world.texture(seen.texture);
            let shaded: G = self.shade_texture(texture, *point, &mut frame, &mut place, true);
            found.add_scaled(&shaded, seen.weight);
        }
        found.note_hit(surface, hit.t, place.facing());
    }
}

/// Whether each image position has one ray that always counts.
fn one_ray_a_position(world: &World) -> bool {
    let camera = &world.camera;
    camera.blur.is_none() && !matches!(camera.projection, Projection::Mesh(_)) && world.settings.adc_bailout <= 1.0
}

/// What patterns may ask about a surface before any bump.
pub(super) fn context_at(surface: &Surface, direction: DVec3) -> Context {
    let normal = if surface.normal.dot(direction) > 0.0 { -surface.normal } else { surface.normal };
    Context { uv: surface.uv, normal, perturbed_normal: normal, direction, point: surface.point }
}

/// Where a texture of a hit is looked up.
pub(super) struct TextureSpace<'w> {
    pub(super) point: DVec3,
    /// The map there, unless it is looked up by surface coordinates.
    pub(super) texture_from_world: Option<Cow<'w, Transform>>,
}

/// What is known already of a hit with a single texture.
#[derive(Clone, Copy)]
pub(super) struct Only<'p> {
    pub(super) space: &'p TextureSpace<'p>,
    pub(super) neighbour: Option<Neighbour<'p>>,
}

/// Where a texture of a hit is looked up.
// Always inline: the map is too large to be handed back for nothing.
#[inline(always)]
pub(super) fn texture_space<'w>(world: &'w World, surface: &Surface, hit: &Hit, seen: &TextureRef) -> TextureSpace<'w> {
    if surface.uv_mapping {
        return TextureSpace { point: surface.uv.lookup_point(), texture_from_world: None };
    }
    let texture_from_world = world.geometry.texture_from_world(hit, seen);
    TextureSpace { point: texture_from_world.point(surface.point), texture_from_world: Some(texture_from_world) }
}

/// What an image position gives through which the camera sends no ray.
pub(super) fn nothing<G: Gather>() -> G {
    let mut nothing = G::default();
    nothing.add(Term::Background, Radiance::CLEAR);
    nothing
}
