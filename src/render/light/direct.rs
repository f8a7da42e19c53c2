//! What light sources add to a layer.
//!
//! Source: sections 3 to 5 of the shading facts (measured).

use super::{area, visibility};
use crate::compiled::light::{Area, Arrival, Light};
use crate::math::{DVec3, Rgb};
use crate::omission::Omission;
use crate::render::random::{Branch, Dimension};
use crate::render::shade::SurfaceLayer;
use crate::render::shade::finish::{self, Incidence};
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;
use smallvec::SmallVec;

/// POV-Ray's cosine below which a surface is turned away from a light.
const TURNED_AWAY: f64 = 1e-10;

/// Light that arrives at one vertex, worked out once for all layers: what each of the lights that shine there gives,
/// in their order, as far as a layer has asked.
#[derive(Default)]
pub(in crate::render) struct ArrivingLight {
    /// None where only one layer asks.
    entries: Option<SmallVec<[Entry; 2]>>,
}

impl ArrivingLight {
    /// Light number `order` among those that shine there.
    fn entry(&mut self, order: usize, make: impl FnOnce() -> Entry) -> &mut Entry {
        let entries = self.entries.get_or_insert_with(SmallVec::new);
        if entries.len() <= order {
            entries.push(make());
        }
        &mut entries[order]
    }
}

struct Entry {
    arrival: Arrival,
    /// Its colour after everything in the way.
    unblocked: Option<Rgb>,
}

/// Light that falls on a layer from one direction.
pub(super) struct Beam {
    /// Unit direction to the light.
    direction: DVec3,
    /// Cosine between normal and light, not negative.
    cosine: f64,
    /// It falls on the far side.
    back: bool,
    /// The light gives highlights.
    highlights: bool,
    /// Number of the light.
    light: usize,
}

/// Diffuse light and highlights from all lights that shine on a layer.
pub(in crate::render) fn direct_light(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    layer: &SurfaceLayer<'_>,
    arriving: &mut ArrivingLight,
) -> Rgb {
    let lights = worker.world().lights_for(vertex.light_group());
    let mut sum = Rgb::ZERO;
    for (order, &index) in lights.iter().enumerate() {
        sum += from_light(worker, vertex, layer, index, (arriving, order));
    }
    sum
}

/// Diffuse light and highlights from one light, which is number `order` among those that shine there.
// Not inline: what one light needs would be put ready for many.
#[inline(never)]
fn from_light(
    worker: &mut Worker<'_>,
    vertex: &Vertex<'_>,
    layer: &SurfaceLayer<'_>,
    index: usize,
    (arriving, order): (&mut ArrivingLight, usize),
) -> Rgb {
    let world = worker.world();
    let light = &world.lights[index];
    let arrive = || Entry { arrival: light.arrival(vertex.point(), light.location), unblocked: None };
    let mut once = None;
    let Entry { arrival, unblocked } =
        if layer.is_only { once.insert(arrive()) } else { arriving.entry(order, arrive) };
    let sampled =
        light.area.as_ref().filter(|a| a.illumination && vertex.path.bounce == 0 && worker.options().area_lights());
    let beam = lit_side(vertex, layer, index, light, arrival.direction);
    let is_spent = sampled.is_none() && light.is_spent(arrival.color);
    let is_dark = || is_spent && !world.features.kept.holds(Omission::SpentLights);
    if beam.is_none() && sampled.is_none() || is_dark() {
        worker.statistics.spared_shadow_rays += 1;
        return Rgb::ZERO;
    }
    let rgb =
        *unblocked.get_or_insert_with(|| visibility::light_through(worker, vertex, index, arrival, sampled.is_some()));
    if is_spent || light.is_spent(rgb) {
        return Rgb::ZERO;
    }
    let answer = match (sampled, beam) {
        (Some(area), _) => area_answer(vertex, layer, (index, light, area), rgb),
        (None, Some(beam)) => answer(vertex, layer, &beam) * rgb,
        (None, None) => Rgb::ZERO,
    };
    answer * film(world.settings.irid_wavelength, vertex, layer, arrival.direction)
}

/// What a thin film makes of light from a direction; 1 without one.
pub(super) fn film(wavelength: Rgb, vertex: &Vertex<'_>, layer: &SurfaceLayer<'_>, direction: DVec3) -> Rgb {
    if layer.finish.irid_amount == 0.0 {
        return Rgb::ONE;
    }
    finish::irid(layer.finish, wavelength, vertex.point(), direction, layer.normal, vertex.view())
}

/// What a layer makes of white light from one direction.
#[inline(always)]
pub(super) fn answer(vertex: &Vertex<'_>, layer: &SurfaceLayer<'_>, beam: &Beam) -> Rgb {
    let finish = layer.finish;
    let mut answer = Rgb::ZERO;
    let amount = if beam.back { layer.diffuse_back } else { layer.diffuse };
    if amount > 0.0 {
        let mut diffuse = amount * layer.opacity * finish::brilliance(finish, beam.cosine);
        if finish.crand != 0.0 {
            diffuse -= finish.crand * grain(layer, beam.light);
        }
        answer += diffuse * layer.albedo;
    }
    if beam.highlights {
        let at = Incidence { view: vertex.view(), light: beam.direction, normal: layer.normal, cosine: beam.cosine };
        answer += finish::highlights(finish, &at, layer.albedo);
    }
    answer
}

/// What `crand` takes from a layer's diffuse light, from 0 to 1.
#[inline(never)]
fn grain(layer: &SurfaceLayer<'_>, light: usize) -> f32 {
    layer.random.branch(Branch::Layer(layer.depth)).unit(Dimension::Crand { light }) as f32
}

/// Each sample of an area light shades by itself; all share one shadow, as in POV-Ray.
#[inline(never)]
fn area_answer(
    vertex: &Vertex<'_>,
    layer: &SurfaceLayer<'_>,
    (index, light, area): (usize, &Light, &Area),
    unblocked: Rgb,
) -> Rgb {
    let point = vertex.point();
    let axes = area.axes((light.location - point).normalize_or(DVec3::Z));
    let mut sum = Rgb::ZERO;
    for j in 0..area.n2 {
        for i in 0..area.n1 {
            let (a, b) = area::position(area, index, [i, j], vertex.path.random);
            let arrival = light.arrival(point, light.location + area.offset(a, b, axes));
            if light.is_spent(arrival.color) {
                continue;
            }
            if let Some(beam) = lit_side(vertex, layer, index, light, arrival.direction) {
                // What came through carries the light's colour; what is left is cone and fade.
                let factor = ratio(arrival.color, light.color);
                let rgb = unblocked * factor / (area.n1 * area.n2) as f32;
                sum += answer(vertex, layer, &beam) * rgb;
            }
        }
    }
    sum
}

/// Common factor of two colours that differ only in brightness.
fn ratio(color: Rgb, of: Rgb) -> f32 {
    let largest = of.abs().max_position();
    color[largest] / of[largest]
}

/// How light of a source falls on a layer from a direction; `None` if the surface stays dark.
#[inline]
fn lit_side(
    vertex: &Vertex<'_>,
    layer: &SurfaceLayer<'_>,
    index: usize,
    light: &Light,
    direction: DVec3,
) -> Option<Beam> {
    let beam = Beam::falling(vertex, layer, direction, light.two_sided)?;
    Some(Beam { highlights: beam.highlights && !light.shadowless, light: index, ..beam })
}

impl Beam {
    /// Light from anywhere, as far as the surface decides; `two_sided` light falls on what is turned away, too.
    #[inline]
    pub(super) fn falling(
        vertex: &Vertex<'_>,
        layer: &SurfaceLayer<'_>,
        direction: DVec3,
        two_sided: bool,
    ) -> Option<Self> {
        let cosine = direction.dot(layer.normal);
        let front = cosine >= TURNED_AWAY || vertex.surface.double_illuminate;
        let back = !front && layer.diffuse_back != 0.0;
        let highlights = !back && vertex.path.bounce == 0;
        (front || back || two_sided).then_some(Self { direction, cosine: cosine.abs(), back, highlights, light: 0 })
    }
}
