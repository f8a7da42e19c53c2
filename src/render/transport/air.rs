//! What lies between the ends of a ray.

use crate::compiled::geometry::{LightGroupId, Surface};
use crate::math::DVec3;
use crate::render::film::{Gather, Term};
use crate::render::light::light_through;
use crate::render::medium::{Airlight, Carried, Incoming, Passage, airlight, fog, rainbow};
use crate::render::path::Path;
use crate::render::photons::{Caught, Gathered, Nearby};
use crate::render::radiance::Radiance;
use crate::render::random::{Branch, Random};
use crate::render::vertex::MediumPoint;
use crate::render::worker::Worker;

/// POV-Ray's length of a ray that meets nothing, for fog and media.
const MISS_LENGTH: f64 = 2e10;

/// Numbers of the random choices of media in objects and in the atmosphere.
const IN_OBJECTS: u32 = 0;
const IN_ATMOSPHERE: u32 = 1;

/// The light along a ray that meets nothing but a sky.
pub(in crate::render) fn escaped<G: Gather>(worker: &mut Worker<'_>, path: &Path, sky: Radiance) -> G {
    let mut found = G::default();
    found.add(Term::Background, sky);
    if worker.has_air(path) {
        through_air(worker, path, MISS_LENGTH, None, &mut found);
    }
    found
}

/// Carries what was found on a surface through what the ray to it is inside of, then through what is in the air.
#[inline(always)]
pub(super) fn through_media<G: Gather>(
    worker: &mut Worker<'_>,
    path: &Path,
    length: f64,
    surface: &Surface,
    found: &mut G,
) {
    if !worker.has_air(path) {
        return;
    }
    if worker.world().features.filled_interiors > 0
        && let Some(air) = filled(worker, path, length, surface.light_group)
    {
        found.pass(Term::Media, &air);
    }
    through_air(worker, path, length, surface.light_group, found);
}

/// Carries what was found at the end of a ray through what is in the air.
#[inline(always)]
fn through_air<G: Gather>(
    worker: &mut Worker<'_>,
    path: &Path,
    length: f64,
    group: Option<LightGroupId>,
    found: &mut G,
) {
    if !path.interiors.are_hollow() {
        return;
    }
    if !worker.world().atmosphere.media.is_empty() {
        through_atmosphere(worker, path, length, group, found);
    } else if let Some(air) = airlight(worker.world(), &path.ray, length, path.random) {
        found.pass(Term::Atmosphere, &air);
    }
}

/// The same where media are between rainbows and fog.
fn through_atmosphere<G: Gather>(
    worker: &mut Worker<'_>,
    path: &Path,
    length: f64,
    group: Option<LightGroupId>,
    found: &mut G,
) {
    let world = worker.world();
    found.pass(Term::Atmosphere, &rainbow(world, &path.ray, length, path.random));
    let media = world.atmosphere.media.clone();
    if let Some(air) = media_light(worker, path, (length, IN_ATMOSPHERE), media, group) {
        found.pass(Term::Media, &air);
    }
    found.pass(Term::Atmosphere, &fog(world, &path.ray, length));
}

/// What the media of the objects do that a ray is inside of.
fn filled(worker: &mut Worker<'_>, path: &Path, length: f64, group: Option<LightGroupId>) -> Option<Airlight> {
    let media = path.interiors.media(worker.world());
    if media.is_empty() { None } else { media_light(worker, path, (length, IN_OBJECTS), media.into_iter(), group) }
}

/// What media do along the first `length` of a ray, lit as what the ray ends on.
fn media_light(
    worker: &mut Worker<'_>,
    path: &Path,
    (length, place): (f64, u32),
    media: impl Iterator<Item = usize> + Clone,
    group: Option<LightGroupId>,
) -> Option<Airlight> {
    let (world, prepared) = (worker.world(), worker.prepared);
    let passage = Passage { world, ray: &path.ray, length, random: path.random.branch(Branch::Medium(place)) };
    let incoming =
        |light: usize, point: DVec3, random: Random| arriving(worker, light, MediumPoint { point, path, random });
    let caught = prepared.photons.as_ref().filter(|caught| place == IN_OBJECTS && caught.in_media.len() > 0);
    let mut nearby = Nearby::default();
    let mut gather = caught.map(|caught| {
        move |point: DVec3, hand_over: &mut dyn FnMut(Incoming)| brought(caught, point, &mut nearby, hand_over)
    });
    let carried = gather.as_mut().map(|gather| gather as &mut Carried<'_>);
    passage.airlight(media, world.lights_for(group).iter().copied(), &prepared.settling, incoming, carried)
}

/// What photons have left around a point.
fn brought(caught: &Caught<'_>, point: DVec3, nearby: &mut Nearby, hand_over: &mut dyn FnMut(Incoming)) {
    let [_, most] = caught.settings.gather;
    let Some(Gathered { photons, extent }) = caught.in_media.gather_in_space(most, point, nearby) else { return };
    let density = extent.recip() as f32;
    photons.into_iter().for_each(|(direction, flux)| hand_over(Incoming { color: density * flux, direction }));
}

/// The light of a source at a point in a medium.
fn arriving(worker: &mut Worker<'_>, index: usize, place: MediumPoint<'_>) -> Option<Incoming> {
    let light = &worker.world().lights[index];
    let arrival = light.arrival(place.point, light.location);
    // Its samples would have each their own cone and fade; here POV-Ray leaves them out (measured).
    let bare = light.area.is_some_and(|area| area.illumination) && worker.options().area_lights();
    if !bare && light.is_spent(arrival.color) {
        return None;
    }
    let color = light_through(worker, &place, index, &arrival, bare);
    Some(Incoming { color, direction: arrival.direction })
}
