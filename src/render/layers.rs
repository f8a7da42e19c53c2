//! A hit's texture: maps resolved, layers shaded from the top, then what comes through and what is mirrored.
//!
//! Source: sections 2 and 6 of the shading facts (measured).

use super::finish::{self, Reflectivity};
use super::gather::{Gather, Term};
use super::lights::{LightCache, Skin};
use super::neighbours::Neighbour;
use super::ray::{Path, Radiance};
use super::refraction::relative_ior;
use super::tracer::Tracer;
use crate::compiled::geometry::Surface;
use crate::compiled::texture::{Context, Finish, Frame, Layer, Pick, Texture};
use crate::math::{Color, DVec3, Rgb, gray};
use smallvec::SmallVec;

/// Where shading happens: a ray, the surface it met, and what is worked out once for all layers.
pub(super) struct Place<'p> {
    pub(super) path: &'p Path,
    pub(super) surface: &'p Surface,
    pub(super) context: Context,
    /// Length of the ray up to here.
    pub(super) length: f64,
    pub(super) lights: LightCache,
    /// Where neighbours share work.
    pub(super) neighbour: Option<Neighbour<'p>>,
}

impl Place<'_> {
    /// Unit direction of the ray.
    pub(super) fn direction(&self) -> DVec3 {
        self.path.ray.direction
    }

    /// Unit shading normal on the side of the ray, before any bump.
    pub(super) fn facing(&self) -> DVec3 {
        self.context.normal
    }
}

/// A mirror reflection that is left for later.
struct Mirror<'t> {
    layer: &'t Layer,
    normal: DVec3,
    reflectivity: Reflectivity,
    /// Share of the layer in the picture: what the layers above let through.
    visibility: f32,
}

/// What part of a layer counts, at most all of it.
fn share(filter: Rgb) -> f32 {
    gray(filter).abs().min(1.0)
}

impl Tracer<'_> {
    /// The light from a texture at a point of its containing space.
    ///
    /// `plain` holds for textures that no pattern chose; only those obey legacy finish keywords.
    /// What `frame` enters it keeps: bumps of later items pass through the spaces of earlier ones, as in POV-Ray.
    pub(super) fn shade_texture<G: Gather>(
        &mut self,
        texture: &Texture,
        point: DVec3,
        frame: &mut Frame<'_>,
        place: &mut Place<'_>,
        plain: bool,
    ) -> G {
        let patterned = match texture {
            Texture::Layers(layers) => return self.shade_layers(layers, point, frame, place, plain),
            Texture::Patterned(patterned) => patterned,
        };
        let (pick, warped) = patterned.pattern.pick(&patterned.items, point, &place.context);
        let point = if patterned.uv_mapping { place.context.uv_point() } else { warped };
        frame.enter(&patterned.pattern, patterned.no_bump_scale);
        match pick {
            Pick::One(item) => self.shade_texture(item, point, frame, place, false),
            Pick::Two(lower, upper, t) => {
                let mut mixed = self.shade_texture::<G>(upper, point, frame, place, false).scaled(t);
                mixed.add_scaled(&self.shade_texture(lower, point, frame, place, false), 1.0 - t);
                mixed
            }
            Pick::All(items) => {
                let mut sum = G::default();
                for (weight, item) in items {
                    sum.add_scaled(&self.shade_texture(item, point, frame, place, false), *weight);
                }
                sum
            }
        }
    }

    fn shade_layers<G: Gather>(
        &mut self,
        layers: &[Layer],
        point: DVec3,
        frame: &Frame<'_>,
        place: &mut Place<'_>,
        plain: bool,
    ) -> G {
        let bailout = self.world.settings.adc_bailout;
        let legacy = layers.last().filter(|_| plain).map(|top| &*top.finish);
        let mut mirrors: SmallVec<[Mirror<'_>; 2]> = SmallVec::new();
        let mut filter = Rgb::ONE;
        let mut found = G::default();
        let mut albedo = Rgb::ZERO;
        let mut top_normal = place.facing();
        for (depth, layer) in layers.iter().rev().enumerate() {
            if share(filter) <= bailout {
                break;
            }
            let normal = self.layer_normal(layer, point, frame, place);
            if depth == 0 {
                top_normal = normal;
            }
            let neighbour = place.neighbour.filter(|_| plain);
            let pigment = self.layer_color(layers, layers.len() - 1 - depth, point, place, neighbour);
            let color = pigment.unwrap_or_default();
            if self.options.flat() {
                found.add(Term::Emission, Radiance { rgb: color.rgb, transparency: 0.0 });
                found.note_shading(normal, color.rgb);
                return found;
            }
            let cosine = -place.direction().dot(normal);
            let relative_ior = || relative_ior(&place.path.interiors, &self.substance(place.surface, legacy));
            let mirrors_at = |reflection| finish::reflectivity(reflection, color.rgb, cosine, relative_ior);
            let reflectivity = layer.finish.reflection.as_ref().and_then(mirrors_at);
            if let Some(reflectivity) = reflectivity {
                mirrors.push(Mirror { layer, normal, reflectivity, visibility: share(filter) });
            }
            let skin = self.skin(&layer.finish, normal, color);
            let emission = color.rgb * layer.finish.own_light * skin.opacity;
            let direct = if layer.finish.uses_lights { self.direct_light(&skin, place) } else { Rgb::ZERO };
            found.add_own(filter, emission, direct);
            albedo += filter * color.rgb * skin.opacity;
            if let Some(color) = pigment {
                filter *= color.transmittance();
                if layer.finish.conserve_energy {
                    let reflected = reflectivity.map_or(Rgb::ZERO, |r| r.tint);
                    filter *= (Rgb::ONE - reflected).min(Rgb::ONE);
                }
            }
        }
        found.note_shading(top_normal, albedo);
        let mut mirrored_within = None;
        if share(filter) > bailout && self.options.refraction() {
            let substance = self.substance(place.surface, legacy);
            let top_finish = layers.last().map(|top| &*top.finish);
            let through = self.transmit(place, &substance, top_normal, filter, top_finish);
            let term = if through.total_reflection { Term::Reflection } else { Term::Refraction };
            found.add(term, through.radiance);
            mirrored_within = through.total_reflection.then_some(top_normal);
        }
        if self.options.reflection_and_normals() {
            // POV-Ray's own limit for normals that agree.
            let same = |a: DVec3, b: DVec3| (a - b).abs().max_element() < 1e-10;
            for mirror in mirrors.iter().filter(|m| !mirrored_within.is_some_and(|n| same(n, m.normal))) {
                let rgb = self.mirror(mirror, place);
                found.add(Term::Reflection, Radiance { rgb, transparency: 0.0 });
            }
        }
        found
    }

    /// A layer's normal; that of the last layer with bumps stays for patterns that ask for the slope, in
    /// whatever layer or texture of the hit they stand, as in POV-Ray.
    fn layer_normal(&self, layer: &Layer, point: DVec3, frame: &Frame<'_>, place: &mut Place<'_>) -> DVec3 {
        match &layer.normal {
            Some(normal) if self.options.reflection_and_normals() => {
                let bumped = normal.perturb(place.facing(), point, frame, &place.context);
                place.context.perturbed_normal = bumped.inner;
                bumped.normal
            }
            _ => place.facing(),
        }
    }

    fn layer_color(
        &self,
        layers: &[Layer],
        index: usize,
        point: DVec3,
        place: &Place<'_>,
        neighbour: Option<Neighbour<'_>>,
    ) -> Option<Color> {
        let layer = &layers[index];
        if let (true, Some(quick)) = (self.options.quick_colors(), layer.quick_color) {
            return Some(quick);
        }
        let known = neighbour.and_then(|neighbour| neighbour.color(index));
        known.or_else(|| layer.pigment.color(point, &place.context))
    }

    /// A layer as light meets it.
    fn skin<'f>(&self, finish: &'f Finish, normal: DVec3, color: Color) -> Skin<'f> {
        let opacity = if self.world.settings.legacy_opacity {
            1.0 - color.filter * color.rgb.max_element() - color.transmit
        } else {
            color.opacity()
        };
        Skin { finish, normal, rgb: color.rgb, opacity }
    }

    /// One layer's mirror image.
    fn mirror(&mut self, mirror: &Mirror<'_>, place: &Place<'_>) -> Rgb {
        let direction = reflected(place.direction(), mirror.normal, place.facing());
        let weight = place.path.weight * mirror.visibility * mirror.reflectivity.importance;
        let mut light = self.reflect(place, direction, weight).rgb;
        let finish = &mirror.layer.finish;
        if finish.irid_amount != 0.0 {
            light *= finish::irid(
                finish,
                self.world.settings.irid_wavelength,
                place.surface.point,
                direction,
                mirror.normal,
                place.direction(),
            );
        }
        let exponent = mirror.reflectivity.exponent;
        if exponent != 1.0 {
            let power = |v: f32| v.signum() * v.abs().powf(1.0 / exponent);
            light = Rgb::new(power(light.x), power(light.y), power(light.z));
        }
        light * mirror.reflectivity.tint
    }
}

/// Mirror direction, kept on the ray's side of the surface.
///
/// Source: section 7.3 of the shading facts.
pub(super) fn reflected(direction: DVec3, normal: DVec3, facing: DVec3) -> DVec3 {
    let about = |v: DVec3, n: DVec3| v - 2.0 * v.dot(n) * n;
    let mut mirrored = about(direction, normal);
    if mirrored.dot(facing) < 0.0 {
        mirrored = if mirrored.dot(normal) < 0.0 { about(direction, facing) } else { about(mirrored, facing) };
    }
    mirrored.normalize_or(facing)
}
