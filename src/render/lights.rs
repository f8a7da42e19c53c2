//! What light sources add to a layer.
//!
//! Source: sections 3 to 5 of the shading facts (measured).

use super::finish::{self, Incidence};
use super::layers::Place;
use super::tracer::Tracer;
use crate::compiled::light::{Arrival, Light, is_dark};
use crate::compiled::texture::Finish;
use crate::math::{Color, DVec3, Rgb};
use smallvec::SmallVec;

/// POV-Ray's cosine below which a surface is turned away from a light.
const TURNED_AWAY: f64 = 1e-10;

/// Light that arrives at one hit, worked out once for all layers.
pub(super) struct LightCache {
    entries: SmallVec<[Cached; 4]>,
}

#[derive(Clone, Copy, Default)]
struct Cached {
    arrival: Option<Arrival>,
    shadowed: Option<Rgb>,
}

impl LightCache {
    pub(super) fn new(n_lights: usize) -> Self {
        Self { entries: smallvec::smallvec![Cached::default(); n_lights] }
    }
}

impl Tracer<'_> {
    /// Diffuse light and highlights from all lights that shine on the surface.
    pub(super) fn direct_light(
        &mut self,
        finish: &Finish,
        normal: DVec3,
        color: &Color,
        opacity: f32,
        place: &mut Place<'_, '_>,
    ) -> Rgb {
        let world = self.world;
        let mut sum = Rgb::ZERO;
        for index in world.lights_for(place.surface.light_group) {
            let light = &world.lights[index];
            self.light = index;
            let entry = &mut place.lights.entries[index];
            let arrival = *entry.arrival.get_or_insert_with(|| light.arrival(place.surface.point, light.location));
            let known = entry.shadowed;
            let sampled = light.area.filter(|a| a.illumination && self.options.area_lights());
            let lit = lit_side(finish, light, arrival.direction.dot(normal), place);
            if sampled.is_none() && (is_dark(arrival.color) || lit.is_none()) {
                continue;
            }
            let incoming = match known {
                Some(known) => known,
                None => {
                    let found = self.shadowed(place, light, &arrival, sampled.is_some());
                    place.lights.entries[index].shadowed = Some(found);
                    found
                }
            };
            if is_dark(incoming) {
                continue;
            }
            let answer = match (sampled, lit) {
                (Some(area), _) => self.area_answer(finish, normal, color, opacity, place, light, &area, incoming),
                (None, Some(side)) => {
                    self.answer(finish, normal, color, opacity, place, light, arrival.direction, side, incoming)
                }
                (None, None) => Rgb::ZERO,
            };
            sum += if finish.irid_amount == 0.0 {
                answer
            } else {
                let wavelength = world.settings.irid_wavelength;
                answer
                    * finish::irid(
                        finish,
                        wavelength,
                        place.surface.point,
                        arrival.direction,
                        normal,
                        place.direction(),
                    )
            };
        }
        sum
    }

    /// What a layer makes of light from one direction.
    #[allow(clippy::too_many_arguments, reason = "one formula over the layer, the light and where they meet")]
    fn answer(
        &mut self,
        finish: &Finish,
        normal: DVec3,
        color: &Color,
        opacity: f32,
        place: &Place<'_, '_>,
        light: &Light,
        direction: DVec3,
        (cosine, back): (f64, bool),
        incoming: Rgb,
    ) -> Rgb {
        let mut answer = Rgb::ZERO;
        let amount = if back { finish.diffuse_back } else { finish.diffuse };
        if amount > 0.0 {
            let mut diffuse = amount * opacity * finish::brilliance(finish, cosine);
            if finish.crand != 0.0 {
                diffuse -= finish.crand * self.random.unit() as f32;
            }
            answer += diffuse * color.rgb;
        }
        if !back && !light.shadowless {
            let at = Incidence { view: place.direction(), light: direction, normal, cosine };
            answer += finish::highlights(finish, &at, color.rgb);
        }
        answer * incoming
    }

    /// Each sample of an area light shades by itself; all share one shadow, as in POV-Ray.
    #[allow(clippy::too_many_arguments, reason = "one formula over the layer, the light and where they meet")]
    fn area_answer(
        &mut self,
        finish: &Finish,
        normal: DVec3,
        color: &Color,
        opacity: f32,
        place: &Place<'_, '_>,
        light: &Light,
        area: &crate::compiled::light::Area,
        shadow: Rgb,
    ) -> Rgb {
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
                if let Some(side) = lit_side(finish, light, arrival.direction.dot(normal), place) {
                    // The shadow carries the light's colour; what is left is cone and fade.
                    let factor = ratio(arrival.color, light.color);
                    let incoming = shadow * factor / (area.n1 * area.n2) as f32;
                    sum += self.answer(finish, normal, color, opacity, place, light, arrival.direction, side, incoming);
                }
            }
        }
        sum
    }

    /// Grid position of a sample, displaced at random if the light says so.
    pub(super) fn jittered(&mut self, area: &crate::compiled::light::Area, i: usize, j: usize) -> (f64, f64) {
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

/// The cosine of incidence and whether the light falls on the far side; `None` if the surface stays dark.
fn lit_side(finish: &Finish, light: &Light, cosine: f64, place: &Place<'_, '_>) -> Option<(f64, bool)> {
    if cosine >= TURNED_AWAY {
        return Some((cosine, false));
    }
    if place.surface.double_illuminate {
        return Some((cosine.abs(), false));
    }
    if finish.diffuse_back != 0.0 {
        return Some((cosine.abs(), true));
    }
    light.two_sided.then_some((cosine.abs(), false))
}
