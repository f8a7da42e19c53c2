//! Light between surfaces: asked for at a vertex, taken from records nearby, or gathered by rays of its own.
//!
//! Source: radiosity facts, sections 2 to 5 (measured).

use super::{escaped, reflected};
use crate::compiled::geometry::RayKind;
use crate::math::{DVec3, Rgb, gray};
use crate::render::environment;
use crate::render::medium::Interiors;
use crate::render::path::Path;
use crate::render::radiance::Radiance;
use crate::render::radiosity::{Blend, Phase, Question, Record, Shared, about};
use crate::render::random::{Branch, Dimension};
use crate::render::shade::SurfaceLayer;
use crate::render::vertex::Vertex;
use crate::render::worker::Worker;

/// POV-Ray's distance of what is not there.
const NOTHING_SEEN: f64 = 2e10;

/// POV-Ray's nearest distance, in largest distances of reuse, from which on a record is kept.
const LEAST_ROOM: f64 = 1e-4;

/// POV-Ray's share of a ray's weight from which on an answer is held to the full error bound.
const FULL_WEIGHT: f64 = 0.25;

/// Factor from the sum of weights to a number of records.
const RECORDS_PER_WEIGHT: f64 = 4.0;

/// Draws of directions for each ray, after which bumps do not count any longer.
const DRAWS_PER_RAY: u32 = 5;

/// Light between surfaces at one texture of a vertex, worked out once for all layers.
#[derive(Default)]
pub(super) struct Indirect {
    front: Option<Rgb>,
    back: Option<Rgb>,
}

impl Indirect {
    /// What a layer behind `filter` sends back of the light that falls on both sides.
    ///
    /// The first layer that shows enough asks; those above it get nothing.
    #[inline(never)]
    pub(super) fn reflected(
        &mut self,
        worker: &mut Worker<'_>,
        vertex: &Vertex<'_>,
        layer: &SurfaceLayer<'_>,
        filter: Rgb,
    ) -> Rgb {
        let Some(shared) = &worker.prepared.radiosity else { return Rgb::ZERO };
        if vertex.path.bounce >= shared.settings.recursion_limit {
            return Rgb::ZERO;
        }
        let visible = gray(filter * layer.albedo) * layer.opacity;
        let bent = if shared.settings.normal { layer.normal } else { vertex.facing };
        let sides = [
            (layer.finish.raw_diffuse, &mut self.front, [vertex.facing, bent]),
            (layer.finish.diffuse_back, &mut self.back, [-vertex.facing; 2]),
        ];
        let mut sum = Rgb::ZERO;
        for (amount, known, [facing, normal]) in sides {
            let share = visible * amount;
            if known.is_none() && share > worker.adc_bailout(vertex.path) {
                let asking = Asking { vertex, facing, normal, weight: f64::from(vertex.path.weight * share) };
                *known = Some(asking.light(worker, shared));
            }
            sum += amount * known.unwrap_or(Rgb::ZERO);
        }
        sum * layer.albedo * layer.opacity
    }
}

/// The light that falls on one side of a surface; it counts in full, since nobody knows yet how much of it is seen.
pub(super) fn on_side(worker: &mut Worker<'_>, vertex: &Vertex<'_>, normal: DVec3) -> Rgb {
    match &worker.prepared.radiosity {
        Some(shared) if vertex.path.bounce < shared.settings.recursion_limit => {
            let weight = f64::from(vertex.path.weight);
            Asking { vertex, facing: normal, normal, weight }.light(worker, shared)
        }
        _ => Rgb::ZERO,
    }
}

/// One side of a surface that asks for light.
struct Asking<'a> {
    vertex: &'a Vertex<'a>,
    /// Unit normal on this side, before any bump.
    facing: DVec3,
    /// The normal about which light is gathered.
    normal: DVec3,
    /// How much of the pixel the answer makes up.
    weight: f64,
}

impl Asking<'_> {
    /// The light that falls on the surface from everywhere, as the settings weigh it.
    fn light(&self, worker: &mut Worker<'_>, shared: &Shared<'_>) -> Rgb {
        let settings = shared.settings;
        let depth = self.vertex.path.bounce;
        let phase = worker.gathering.phase;
        let mut blend = Blend::default();
        let question = self.question(shared, phase);
        shared.records.blend(depth, &question, &mut blend);
        worker.gathering.records.blend(depth, &question, &mut blend);
        if depth == 0 {
            worker.gathering.asked += 1;
            worker.gathering.known += RECORDS_PER_WEIGHT * blend.weight();
        }
        let wanted = settings.wanted(depth);
        let makes_do = phase != Phase::Pretrace && !settings.always_sample;
        if RECORDS_PER_WEIGHT * blend.weight() < wanted && !(makes_do && blend.weight() > 0.0) {
            let record = self.gather(worker, shared);
            blend.add(record.light, record.quality.into());
        }
        let known = (RECORDS_PER_WEIGHT * blend.weight() / wanted) as f32;
        worker.gathering.quality = worker.gathering.quality.min(known);
        let light = blend.mean();
        let colorless = Rgb::splat(gray(light));
        settings.brightness as f32 * (light + settings.gray_threshold * (colorless - light))
    }

    fn question(&self, shared: &Shared<'_>, phase: Phase) -> Question {
        let settings = shared.settings;
        let depth = self.vertex.path.bounce;
        let factor = if phase == Phase::Pretrace { settings.low_error_factor } else { 1.0 };
        let lenience = (FULL_WEIGHT - self.weight).max(0.0);
        Question {
            point: self.vertex.point(),
            normal: self.normal,
            error: (settings.error_bound * factor + lenience) * settings.coarseness(depth),
            is_smooth: phase != Phase::Pretrace && depth == 0,
        }
    }

    /// Sends rays in all directions, and keeps what they say.
    fn gather(&self, worker: &mut Worker<'_>, shared: &Shared<'_>) -> Record {
        let depth = self.vertex.path.bounce;
        // What the picture misses is found for one place alone, from its own numbers: so no pixel depends on another.
        let stands_alone = worker.gathering.phase == Phase::Picture && depth == 0;
        if stands_alone {
            let random = self.vertex.path.random;
            let n = f64::from(shared.directions.len());
            let first = |depth: u32| random.branch(Branch::Gathered(depth)).unit(Dimension::Direction) * n;
            worker.gathering.begin(Phase::Picture, (0..shared.settings.recursion_limit).map(|d| first(d) as u32));
        }
        let outer_quality = worker.gathering.quality;
        let mut sample = Sample::default();
        let n = shared.settings.rays(depth);
        let mut draws = (DRAWS_PER_RAY * n).min(shared.directions.len());
        for i in 0..n {
            let direction = self.direction(worker, shared, &mut draws);
            self.add_ray(worker, shared, &mut sample, (i, n), direction);
        }
        worker.gathering.quality = outer_quality;
        let settings = shared.settings;
        let distance = self.vertex.point().distance(worker.world().camera.location);
        let reuse = settings.reuse.map(|share| share * settings.coarseness(depth) * distance);
        let record = sample.record(self, n, reuse);
        if f64::from(record.nearest) > LEAST_ROOM * reuse[1] && !stands_alone {
            worker.gathering.keep(depth, record, settings.reach(depth, record.mean_distance));
        }
        if stands_alone {
            worker.gathering.records.clear();
        }
        record
    }

    /// The next direction that leaves the surface; after so many `draws` bumps do not count any longer.
    fn direction(&self, worker: &mut Worker<'_>, shared: &Shared<'_>, draws: &mut u32) -> DVec3 {
        let depth = self.vertex.path.bounce;
        let mut next = |normal| about(normal, shared.directions.get(worker.gathering.next_direction(depth)));
        if self.normal == self.facing {
            return next(self.normal);
        }
        while *draws > 0 {
            *draws -= 1;
            let direction = next(self.normal);
            if direction.dot(self.facing) > 0.0 {
                return direction;
            }
        }
        next(self.facing)
    }

    /// Follows ray `i` of `n`.
    fn add_ray(
        &self,
        worker: &mut Worker<'_>,
        shared: &Shared<'_>,
        sample: &mut Sample,
        (i, n): (u32, u32),
        direction: DVec3,
    ) {
        let settings = shared.settings;
        let depth = self.vertex.path.bounce;
        // A ray that counts too little is black, and meets nothing.
        let Some(weight) = settings.weight(depth) else {
            sample.add(Rgb::ZERO, 1.0);
            return;
        };
        let (ray, range) = self.vertex.leave(direction);
        let path = Path {
            ray,
            range,
            kind: RayKind::Radiosity,
            bounce: depth + 1,
            below: self.vertex.path.below,
            level: settings.start_level(depth),
            weight,
            interiors: Interiors::default(),
            wavelength: None,
            random: self.vertex.path.random.branch(Branch::Gathered(i)),
        };
        worker.statistics.sample_rays += 1;
        worker.gathering.quality = 1.0;
        let last = (n - 1) as f32;
        let share = |importance: f32| f64::from(n) / f64::from((importance * last).floor() + 1.0);
        let is_seen = |importance: f32| importance * last >= i as f32;
        let (light, importance): (Radiance, f32) = match worker.intersect(&path) {
            Some(hit) => {
                sample.note_distance(hit.t, direction);
                let surface = worker.world().geometry.surface(&path.ray, &hit);
                let importance = surface.importance.unwrap_or(settings.importance);
                if !is_seen(importance) {
                    return;
                }
                (reflected(worker, &path, &hit, &surface, None), importance)
            }
            None if !is_seen(settings.importance) => return,
            None => {
                let sky = environment::radiance(worker.world(), worker.options(), &path);
                (escaped(worker, &path, sky), settings.importance)
            }
        };
        let mut rgb = light.rgb;
        if let Some(limit) = settings.max_sample
            && rgb.max_element() > limit
        {
            rgb *= limit / rgb.max_element();
        }
        sample.add(rgb, f64::from(worker.gathering.quality) * share(importance));
    }
}

/// What the rays of one sample found so far.
#[derive(Default)]
struct Sample {
    light: Blend,
    nearness: f64,
    nearest: Option<(f64, DVec3)>,
}

impl Sample {
    fn add(&mut self, light: Rgb, weight: f64) {
        self.light.add(light, weight);
    }

    fn note_distance(&mut self, distance: f64, direction: DVec3) {
        self.nearness += distance.recip();
        if self.nearest.is_none_or(|(nearest, _)| distance < nearest) {
            self.nearest = Some((distance, direction));
        }
    }

    /// The mean of `n` rays.
    fn record(&self, asking: &Asking<'_>, n: u32, [least, largest]: [f64; 2]) -> Record {
        let (nearest, toward_nearest) = self.nearest.unwrap_or((NOTHING_SEEN, DVec3::ZERO));
        Record {
            point: asking.vertex.point(),
            normal: asking.normal,
            mean_distance: (f64::from(n) / self.nearness).min(largest).max(least) as f32,
            nearest: nearest as f32,
            toward_nearest,
            light: self.light.mean(),
            quality: (self.light.weight() / f64::from(n)) as f32,
        }
    }
}
