//! What light sources add to a layer.
//!
//! Source: sections 3 to 5 of the shading facts (measured).

use super::finish::{self, Incidence};
use super::layers::Place;
use super::tracer::Tracer;
use crate::compiled::light::{Area, Arrival, Light, is_dark};
use crate::compiled::texture::Finish;
use crate::math::{DVec3, Rgb};
use smallvec::SmallVec;

/// POV-Ray's cosine below which a surface is turned away from a light.
const TURNED_AWAY: f64 = 1e-10;

/// Light that arrives at one hit, worked out once for all layers: what each of the lights that shine there gives,
/// in their order, as far as a layer has asked.
#[derive(Default)]
pub(super) struct LightCache {
    entries: SmallVec<[Cached; 2]>,
}

#[derive(Clone, Copy)]
struct Cached {
    arrival: Arrival,
    shadowed: Option<Rgb>,
}

/// One layer of a texture as light meets it.
pub(super) struct Skin<'f> {
    pub(super) finish: &'f Finish,
    /// Unit perturbed normal.
    pub(super) normal: DVec3,
    /// The pigment's colour.
    pub(super) rgb: Rgb,
    /// What part of the layer is not see-through.
    pub(super) opacity: f32,
}

/// Light that falls on a layer from one direction.
struct Beam {
    /// Unit direction to the light.
    direction: DVec3,
    /// Cosine between normal and light, not negative.
    cosine: f64,
    /// It falls on the far side.
    back: bool,
    /// The light gives highlights.
    highlights: bool,
    /// Its colour after shadows and attenuation.
    rgb: Rgb,
}

impl Tracer<'_> {
    /// Diffuse light and highlights from all lights that shine on the surface.
    pub(super) fn direct_light(&mut self, skin: &Skin<'_>, place: &mut Place<'_>) -> Rgb {
        let world = self.world;
        let mut sum = Rgb::ZERO;
        for (order, index) in world.lights_for(place.surface.light_group).enumerate() {
            let light = &world.lights[index];
            self.light = index;
            if place.lights.entries.len() <= order {
                let arrival = light.arrival(place.surface.point, light.location);
                place.lights.entries.push(Cached { arrival, shadowed: None });
            }
            let Cached { arrival, shadowed: known } = place.lights.entries[order];
            let sampled = light.area.as_ref().filter(|a| a.illumination && self.options.area_lights());
            let lit = lit_side(skin, light, arrival.direction, place);
            if sampled.is_none() && (is_dark(arrival.color) || lit.is_none()) {
                continue;
            }
            let rgb = match known {
                Some(known) => known,
                None => {
                    let found = self.shadowed(place, light, &arrival, sampled.is_some());
                    place.lights.entries[order].shadowed = Some(found);
                    found
                }
            };
            if is_dark(rgb) {
                continue;
            }
            let answer = match (sampled, lit) {
                (Some(area), _) => self.area_answer(skin, place, light, area, rgb),
                (None, Some(beam)) => self.answer(skin, place, &Beam { rgb, ..beam }),
                (None, None) => Rgb::ZERO,
            };
            sum += answer * self.film(skin, place, arrival.direction);
        }
        sum
    }

    /// What a thin film makes of light from a direction; 1 without one.
    fn film(&self, skin: &Skin<'_>, place: &Place<'_>, direction: DVec3) -> Rgb {
        if skin.finish.irid_amount == 0.0 {
            return Rgb::ONE;
        }
        let wavelength = self.world.settings.irid_wavelength;
        finish::irid(skin.finish, wavelength, place.surface.point, direction, skin.normal, place.direction())
    }

    /// What a layer makes of light from one direction.
    fn answer(&mut self, skin: &Skin<'_>, place: &Place<'_>, beam: &Beam) -> Rgb {
        let finish = skin.finish;
        let mut answer = Rgb::ZERO;
        let amount = if beam.back { finish.diffuse_back } else { finish.diffuse };
        if amount > 0.0 {
            let mut diffuse = amount * skin.opacity * finish::brilliance(finish, beam.cosine);
            if finish.crand != 0.0 {
                diffuse -= finish.crand * self.random.unit() as f32;
            }
            answer += diffuse * skin.rgb;
        }
        if beam.highlights {
            let at =
                Incidence { view: place.direction(), light: beam.direction, normal: skin.normal, cosine: beam.cosine };
            answer += finish::highlights(finish, &at, skin.rgb);
        }
        answer * beam.rgb
    }

    /// Each sample of an area light shades by itself; all share one shadow, as in POV-Ray.
    fn area_answer(&mut self, skin: &Skin<'_>, place: &Place<'_>, light: &Light, area: &Area, shadow: Rgb) -> Rgb {
        let point = place.surface.point;
        let axes = area.axes((light.location - point).normalize_or(DVec3::Z));
        let mut sum = Rgb::ZERO;
        for j in 0..area.n2 {
            for i in 0..area.n1 {
                let (a, b) = self.jittered(area, i, j);
                let arrival = light.arrival(point, light.location + area.offset(a, b, axes));
                if is_dark(arrival.color) {
                    continue;
                }
                if let Some(beam) = lit_side(skin, light, arrival.direction, place) {
                    // The shadow carries the light's colour; what is left is cone and fade.
                    let factor = ratio(arrival.color, light.color);
                    let rgb = shadow * factor / (area.n1 * area.n2) as f32;
                    sum += self.answer(skin, place, &Beam { rgb, ..beam });
                }
            }
        }
        sum
    }

    /// Grid position of a sample, displaced at random if the light says so.
    pub(super) fn jittered(&mut self, area: &Area, i: usize, j: usize) -> (f64, f64) {
        let (mut a, mut b) = (i as f64, j as f64);
        if area.jitter {
            a += self.random.unit() - 0.5;
            b += self.random.unit() - 0.5;
        }
        (a, b)
    }
}

/// Common factor of two colours that differ only in brightness.
fn ratio(color: Rgb, of: Rgb) -> f32 {
    let largest = of.abs().max_position();
    color[largest] / of[largest]
}

/// How light from a direction falls on a layer, still without its colour; `None` if the surface stays dark.
fn lit_side(skin: &Skin<'_>, light: &Light, direction: DVec3, place: &Place<'_>) -> Option<Beam> {
    let cosine = direction.dot(skin.normal);
    let front = cosine >= TURNED_AWAY || place.surface.double_illuminate;
    let back = !front && skin.finish.diffuse_back != 0.0;
    if !front && !back && !light.two_sided {
        return None;
    }
    let highlights = !back && !light.shadowless;
    Some(Beam { direction, cosine: cosine.abs(), back, highlights, rgb: Rgb::ZERO })
}
