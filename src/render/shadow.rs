//! What is in the way of light.
//!
//! Source: sections 3.5, 3.6 and 4 of the shading facts (measured).

use super::layers::Place;
use super::ray::{Inside, Interiors};
use super::tracer::{TextureSpace, Tracer, context_at, texture_space};
use crate::compiled::geometry::{Hit, RayKind, Surface};
use crate::compiled::light::{Area, Arrival, Light, is_dark};
use crate::compiled::texture::{Context, Frame, Pick, Texture};
use crate::math::{DVec3, Range, Ray, Rgb};

/// How near to a light a surface may be and still not shade it, as a share of the distance: a
/// light that stands on a surface is meant to shine, and a millionth is far above rounding.
const LIGHT_MARGIN: f64 = 1e-6;

/// POV-Ray's distance by which a blocker must be nearer than the object a light is projected through.
const PROJECTION_MARGIN: f64 = 0.001;

/// POV-Ray's largest difference of neighbouring samples that is not subdivided.
const AREA_THRESHOLD: f32 = 0.1;

impl Tracer<'_> {
    /// The colour of a light at a place after everything in its way.
    ///
    /// With `bare` the light's own colour is filtered, without cone and fade: for lights whose
    /// samples each have their own.
    pub(super) fn shadowed(&mut self, place: &Place<'_>, light: &Light, arrival: &Arrival, bare: bool) -> Rgb {
        let color = if bare { light.color } else { arrival.color };
        let casts = !light.shadowless && self.options.shadows();
        match &light.area {
            Some(area) if casts && self.options.area_lights() => self.area_shadow(place, light, area, color),
            _ => self.arriving(place, light, arrival.direction, arrival.distance, color),
        }
    }

    /// A colour on its way from a light or one of its samples.
    fn arriving(&mut self, place: &Place<'_>, light: &Light, direction: DVec3, distance: f64, color: Rgb) -> Rgb {
        let mut reach = distance;
        if let Some(window) = &light.projected_through {
            let (ray, range) = place.surface.leave(direction);
            let range = Range { max: distance, ..range };
            match window.intersect(&ray, range, RayKind::Shadow, &mut self.scratch) {
                Some(hit) => reach = hit.t - PROJECTION_MARGIN,
                None => return Rgb::ZERO,
            }
        }
        if light.shadowless || !self.options.shadows() {
            return color;
        }
        let fogged = light.media_attenuation && self.options.atmosphere() && !self.world.atmosphere.fogs.is_empty();
        self.filtered(place, direction, reach, fogged.then_some(distance), color)
    }

    fn area_shadow(&mut self, place: &Place<'_>, light: &Light, area: &Area, color: Rgb) -> Rgb {
        let axes = area.axes((light.location - place.surface.point).normalize_or(DVec3::Z));
        let mut grid = AreaShadow { place, light, area, color, axes, known: vec![None; area.n1 * area.n2] };
        grid.block(self, [0, 0], [area.n1 - 1, area.n2 - 1], 0)
    }

    /// A colour after all surfaces along a straight way of length `reach`, and after fog along `fogged`.
    fn filtered(
        &mut self,
        place: &Place<'_>,
        direction: DVec3,
        reach: f64,
        fogged: Option<f64>,
        mut color: Rgb,
    ) -> Rgb {
        let geometry = &self.world.geometry;
        let (mut ray, range) = place.surface.leave(direction);
        let mut range = Range { max: reach * (1.0 - LIGHT_MARGIN), ..range };
        self.statistics.shadow_rays += 1;
        if self.all_opaque {
            let blocked = geometry.occluded(&ray, range, self.light, &mut self.scratch);
            if blocked {
                return Rgb::ZERO;
            }
            return color * fogged.map_or(Rgb::ONE, |length| self.fog_on_the_way(&ray, length, &place.path.interiors));
        }
        let mut interiors = None;
        let mut way = fogged;
        loop {
            let Some(hit) = geometry.intersect(&ray, range, RayKind::Shadow, &mut self.scratch) else {
                let inside = interiors.as_ref().unwrap_or(&place.path.interiors);
                return color * way.map_or(Rgb::ONE, |length| self.fog_on_the_way(&ray, length, inside));
            };
            if geometry.blocks_light(&hit, &self.world.opaque) {
                return Rgb::ZERO;
            }
            let surface = geometry.surface(&ray, &hit);
            if surface.textures.iter().all(|t| self.world.opaque[t.texture.0 as usize]) {
                return Rgb::ZERO;
            }
            let interiors = interiors.get_or_insert_with(|| Interiors::from_slice(&place.path.interiors));
            if let Some(length) = &mut way {
                color *= self.fog_on_the_way(&ray, hit.t, interiors);
                *length -= hit.t;
            }
            color *= self.surface_transmittance(&surface, &hit, &ray) * self.leaving_fade(&surface, hit.t, interiors);
            if is_dark(color) {
                return Rgb::ZERO;
            }
            let left = range.max - hit.t;
            (ray, range) = surface.leave(direction);
            range.max = left;
            self.statistics.shadow_rays += 1;
        }
    }

    /// What fog leaves of a light along a part of its way, outside of solid objects.
    fn fog_on_the_way(&self, ray: &Ray, length: f64, interiors: &Interiors) -> Rgb {
        if interiors.iter().all(|i| i.hollow) {
            super::atmosphere::fog_factor(self.world, ray, length)
        } else {
            Rgb::ONE
        }
    }

    /// Attenuation inside the object that a shadow ray leaves here; keeps the list of objects.
    fn leaving_fade(&self, surface: &Surface, length: f64, interiors: &mut Interiors) -> Rgb {
        let interior = self.world.interior(surface.interior.interior);
        match interiors.iter().position(|i| i.key == surface.interior) {
            Some(at) => {
                interiors.remove(at);
                let fade = interior.fade.filter(|f| f.power > 0.0);
                fade.map_or(Rgb::ONE, |f| f.transmittance(length))
            }
            None => {
                let (key, hollow) = (surface.interior, surface.hollow);
                interiors.push(Inside { key, hollow, ior: interior.ior, dispersion: interior.dispersion });
                Rgb::ONE
            }
        }
    }

    /// What all textures of a surface let through.
    fn surface_transmittance(&mut self, surface: &Surface, hit: &Hit, ray: &Ray) -> Rgb {
        let mut context = context_at(surface, ray.direction);
        let caustics = self.world.interior(surface.interior.interior).caustics;
        let mut sum = Rgb::ZERO;
        for seen in &surface.textures {
            let texture = self.world.texture(seen.texture);
            let TextureSpace { point, texture_from_world } = texture_space(self.world, surface, hit, seen);
            let mut frame = Frame::new(texture_from_world.as_deref());
            let caustics = texture.top_layer().and_then(|top| top.finish.caustics).unwrap_or(caustics);
            sum += seen.weight * self.transmittance(texture, point, &mut frame, &mut context, caustics);
        }
        sum
    }

    /// What a texture lets through; spaces and bumps are kept for what is still to come, as in shading.
    fn transmittance(
        &self,
        texture: &Texture,
        point: DVec3,
        frame: &mut Frame<'_>,
        context: &mut Context,
        caustics: f64,
    ) -> Rgb {
        let layers = match texture {
            Texture::Layers(layers) => layers,
            Texture::Patterned(patterned) => {
                let (pick, warped) = patterned.pattern.pick(&patterned.items, point, context);
                let point = if patterned.uv_mapping { context.uv_point() } else { warped };
                frame.enter(&patterned.pattern, patterned.no_bump_scale);
                let mut of = |item: &Texture| self.transmittance(item, point, frame, context, caustics);
                return match pick {
                    Pick::One(item) => of(item),
                    Pick::Two(lower, upper, t) => {
                        let upper = of(upper);
                        of(lower).lerp(upper, t)
                    }
                    Pick::All(items) => items.iter().map(|(w, item)| *w * of(item)).sum(),
                };
            }
        };
        let mut filter = Rgb::ONE;
        for layer in layers.iter().rev() {
            let quick = layer.quick_color.filter(|_| self.options.quick_colors());
            if let Some(color) = quick.or_else(|| layer.pigment.color(point, context)) {
                filter *= color.transmittance();
            }
            if caustics != 0.0 {
                let mut normal = context.normal;
                if let Some(bumps) = &layer.normal {
                    let bent = bumps.perturb(normal, point, frame, context);
                    (normal, context.perturbed_normal) = (bent.normal, bent.inner);
                }
                filter *= 1.0 + normal.dot(context.direction).abs().powf(caustics) as f32;
            }
        }
        filter
    }
}

/// A grid of lights seen from one place; each sample is looked at once.
struct AreaShadow<'a, 'p> {
    place: &'a Place<'p>,
    light: &'a Light,
    area: &'a Area,
    color: Rgb,
    axes: (DVec3, DVec3),
    known: Vec<Option<Rgb>>,
}

impl AreaShadow<'_, '_> {
    fn sample(&mut self, tracer: &mut Tracer<'_>, i: usize, j: usize) -> Rgb {
        let at = j * self.area.n1 + i;
        if let Some(known) = self.known[at] {
            return known;
        }
        let (a, b) = tracer.jittered(self.area, i, j);
        let source = self.light.location + self.area.offset(a, b, self.axes);
        let (direction, distance) = self.light.toward(self.place.surface.point, source);
        let found = tracer.arriving(self.place, self.light, direction, distance, self.color);
        self.known[at] = Some(found);
        found
    }

    /// Mean over a block of the grid: of its corners if they agree, else of its quarters.
    fn block(&mut self, tracer: &mut Tracer<'_>, low: [usize; 2], high: [usize; 2], depth: u32) -> Rgb {
        let corners = [[low[0], low[1]], [high[0], low[1]], [low[0], high[1]], [high[0], high[1]]];
        let mut values = corners.map(|[i, j]| self.sample(tracer, i, j));
        let long = high[0] - low[0] > 1 || high[1] - low[1] > 1;
        let differ = |a: usize, b: usize| {
            let d = (values[a] - values[b]).abs();
            d.x + d.y + d.z > AREA_THRESHOLD
        };
        if long && (depth < self.area.adaptive || differ(0, 1) || differ(2, 3) || differ(0, 2) || differ(1, 3)) {
            let below = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
            let above = [(low[0] + high[0]).div_ceil(2), (low[1] + high[1]).div_ceil(2)];
            values = [
                self.block(tracer, low, below, depth + 1),
                self.block(tracer, [above[0], low[1]], [high[0], below[1]], depth + 1),
                self.block(tracer, [low[0], above[1]], [below[0], high[1]], depth + 1),
                self.block(tracer, above, high, depth + 1),
            ];
        }
        0.25 * (values[0] + values[1] + values[2] + values[3])
    }
}
