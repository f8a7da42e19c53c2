//! Marching through media: what they add to light that passes, and what they take.
//!
//! Source: `docs/povray/media.md`, sections 3 to 5 (measured).

use super::Airlight;
use super::segment::{Lit, Part, for_each_part};
use super::settling::Settling;
use crate::compiled::medium::{Medium, Method, Sampling};
use crate::math::{DVec3, LANES, Ray, Rgb, each_lane, gray};

/// A piece of a ray within media.
#[derive(Clone, Copy)]
pub(super) struct Segment<'a> {
    /// World space, unit direction.
    pub(super) ray: &'a Ray,
    pub(super) length: f64,
    /// What is there, at least one.
    pub(super) media: &'a [&'a Medium],
}

/// Light that arrives at a point of a ray from a light source, and the unit direction to it.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Incoming {
    pub(in crate::render) color: Rgb,
    pub(in crate::render) direction: DVec3,
}

/// Hands over, one by one, what photons have brought to the surroundings of a point, per unit of volume.
pub(in crate::render) type Carried<'c> = dyn FnMut(DVec3, &mut dyn FnMut(Incoming)) + 'c;

/// What media do along a segment under lights.
///
/// `settling` belongs to the first of the media with the most intervals. `incoming` gives the light of a source, by its
/// number, at a point, the sample's number along the segment beside it; `number` gives random numbers in 0..1.
pub(super) fn scattered(
    segment: Segment<'_>,
    settling: &Settling,
    lights: &[Lit],
    incoming: impl FnMut(usize, DVec3, u32) -> Option<Incoming>,
    carried: Option<&mut Carried<'_>>,
    number: impl FnMut() -> f64,
) -> Airlight {
    let mut march = March::new(segment, lights, Some(settling), incoming, number);
    march.carried = carried.map(|carried| carried as &mut Carried<'_>);
    let (mut radiance, mut depth) = (Rgb::ZERO, Rgb::ZERO);
    for_each_part(segment.length, lights, march.master, march.has_density, |part| {
        let found = march.part(&part);
        radiance += found.light * (-depth).exp();
        depth += found.depth;
    });
    let transmittance = (-depth).exp();
    Airlight { transmittance, radiance, transparency: gray(transmittance) }
}

/// What part of light comes through a segment.
pub(super) fn transmittance(segment: Segment<'_>, number: impl FnMut() -> f64) -> Rgb {
    let media = segment.media;
    let length = segment.length as f32;
    if media.iter().all(|medium| medium.is_uniform()) {
        let depth: Rgb = media.iter().map(|medium| medium.uniform * medium.extinction).sum();
        return (-depth * length).exp();
    }
    let mut march = March::new(segment, &[], None, |_, _, _| None, number);
    // The shortcut of POV-Ray for media that it takes for uniform.
    let once = media.iter().all(|medium| medium.ends_plain);
    let mut depth = Rgb::ZERO;
    for_each_part(segment.length, &[], march.master, march.has_density, |part| {
        depth += if once { march.once(&part) } else { march.depth(&part) };
    });
    (-depth).exp()
}

/// Samples that are taken together.
const BATCH: usize = 16;

/// Steps of method 3 in a part.
fn n_steps(min_samples: u32) -> u32 {
    (min_samples / 2).saturating_add(1).max(2)
}

/// Extinction so far, and points that wait until there are enough to look at together.
#[derive(Default)]
struct Taken {
    points: [DVec3; LANES],
    weights: [f32; LANES],
    n: usize,
    extinction: Rgb,
}

/// What all media do at a point, per unit length.
#[derive(Clone, Copy, Debug, Default)]
struct Coefficients {
    emission: Rgb,
    extinction: Rgb,
    scattering: Rgb,
}

impl Coefficients {
    fn add(&mut self, medium: &Medium, density: Rgb) {
        self.emission += density * medium.emission;
        self.extinction += density * medium.extinction;
        self.scattering += density * medium.scattering;
    }
}

/// What a sample, or the mean of some, says of its part.
#[derive(Clone, Copy, Debug, Default)]
struct Sample {
    /// Light that the part adds, were it all like this.
    light: Rgb,
    /// Optical depth of the part, were it all like this.
    depth: Rgb,
}

/// Sums of light over samples, and of its square.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    n: u32,
    light: DVec3,
    squares: DVec3,
    depth: Rgb,
}

struct March<'a, L, N> {
    segment: Segment<'a>,
    lights: &'a [Lit],
    master: &'a Sampling,
    has_density: bool,
    /// The smallest of all media.
    threshold: f32,
    /// When samples of the first two methods are enough. Without it, only what media take counts.
    settling: Option<&'a Settling>,
    /// Of all points, if they are the same everywhere.
    uniform: Option<Coefficients>,
    incoming: L,
    /// Light that photons have left.
    carried: Option<&'a mut Carried<'a>>,
    number: N,
    n_samples: u32,
}

impl<'a, L, N> March<'a, L, N>
where
    L: FnMut(usize, DVec3, u32) -> Option<Incoming>,
    N: FnMut() -> f64,
{
    fn new(segment: Segment<'a>, lights: &'a [Lit], settling: Option<&'a Settling>, incoming: L, number: N) -> Self {
        let media = segment.media;
        let first_of_most = media[1..]
            .iter()
            .fold(media[0], |best, next| if next.sampling.intervals > best.sampling.intervals { next } else { best });
        let uniform = media.iter().all(|medium| medium.is_uniform()).then(|| {
            let mut sums = Coefficients::default();
            media.iter().for_each(|medium| sums.add(medium, medium.uniform));
            sums
        });
        Self {
            segment,
            lights,
            master: &first_of_most.sampling,
            has_density: first_of_most.has_density,
            threshold: media.iter().map(|medium| medium.sampling.threshold).fold(f32::INFINITY, f32::min),
            settling,
            uniform,
            incoming,
            carried: None,
            number,
            n_samples: 0,
        }
    }

    fn part(&mut self, part: &Part) -> Sample {
        match self.master.method {
            Method::Random | Method::Even => self.averaged(part),
            Method::Adaptive => self.stepped(part),
        }
    }

    /// Optical depth of a part by one sample.
    fn once(&mut self, part: &Part) -> Rgb {
        let place = self.place(0);
        self.sample(part, place).depth
    }

    /// Where sample number `j` lies: at an even distance for method 2, else anywhere.
    fn place(&mut self, j: u32) -> f64 {
        let Sampling { method, min_samples, jitter, .. } = *self.master;
        match method {
            Method::Even if jitter == 0.0 => (f64::from(j) + 0.5) / f64::from(min_samples),
            Method::Even => (f64::from(j) + 0.5 + (self.number)() * jitter) / f64::from(min_samples),
            Method::Random | Method::Adaptive => (self.number)(),
        }
    }

    /// Optical depth of a part, by the places and weights that its method comes to where nothing is halved.
    fn depth(&mut self, part: &Part) -> Rgb {
        let min_samples = self.master.min_samples;
        let mut taken = Taken::default();
        if self.master.method != Method::Adaptive {
            for j in 0..min_samples {
                let place = self.place(j);
                self.take(part, place, 1.0 / min_samples as f32, &mut taken);
            }
            return self.depth_of(part, taken);
        }
        let n = n_steps(min_samples);
        let (step, share) = (1.0 / (f64::from(n) + 1.0), 1.0 / (3.0 * n as f32));
        for j in 0..=n {
            let place = self.displaced(f64::from(j) * step, step);
            self.take(part, place, if j == 0 || j == n { share } else { 2.0 * share }, &mut taken);
            if j < n {
                let middle = self.displaced((f64::from(j) + 0.5) * step, step);
                self.take(part, middle, share, &mut taken);
            }
        }
        self.depth_of(part, taken)
    }

    /// Takes a sample of extinction, with others.
    fn take(&self, part: &Part, place: f64, weight: f32, taken: &mut Taken) {
        taken.points[taken.n] = self.segment.ray.at(part.from + place * part.length);
        taken.weights[taken.n] = weight;
        taken.n += 1;
        if taken.n == LANES {
            self.look(taken);
        }
    }

    /// Adds what is at the points so far.
    fn look(&self, taken: &mut Taken) {
        for medium in self.segment.media {
            let densities = medium.densities_at(&taken.points);
            let mean: Rgb = densities.iter().zip(taken.weights).map(|(density, weight)| weight * *density).sum();
            taken.extinction += mean * medium.extinction;
        }
        (taken.weights, taken.n) = ([0.0; LANES], 0);
    }

    fn depth_of(&self, part: &Part, mut taken: Taken) -> Rgb {
        if taken.n > 0 {
            self.look(&mut taken);
        }
        taken.extinction * part.length as f32
    }

    /// Methods 1 and 2: the mean of samples, each weakened by what lies before it.
    fn averaged(&mut self, part: &Part) -> Sample {
        let Sampling { min_samples, max_samples, .. } = *self.master;
        let mut sums = Sums::default();
        let (mut places, mut samples) = ([0.0; BATCH], [Sample::default(); BATCH]);
        let mut j = 0;
        while j < min_samples {
            let n = BATCH.min((min_samples - j) as usize);
            for place in &mut places[..n] {
                *place = self.place(j);
                j += 1;
            }
            self.samples(part, &places[..n], &mut samples);
            samples.iter().zip(&places[..n]).for_each(|(sample, place)| sums.add(sample.weakened(*place)));
        }
        if let Some(settling) = self.settling.filter(|_| max_samples > min_samples) {
            while sums.n <= max_samples && !sums.are_enough(settling) {
                let place = (self.number)();
                sums.add(self.sample(part, place).weakened(place));
            }
        }
        sums.mean()
    }

    /// Method 3: steps of equal length, which leave out the last piece of the part.
    fn stepped(&mut self, part: &Part) -> Sample {
        let n = n_steps(self.master.min_samples);
        let step = 1.0 / (f64::from(n) + 1.0);
        let mut sum = Sample::default();
        let (mut places, mut samples) = ([0.0; BATCH], [Sample::default(); BATCH]);
        let first = self.displaced(0.0, step);
        let mut low = self.sample(part, first);
        let mut j = 0;
        while j < n {
            // The middles and ends of some steps, which all are looked at.
            let n_places = BATCH.min(2 * (n - j) as usize);
            for (k, place) in places[..n_places].iter_mut().enumerate() {
                *place = self.displaced((f64::from(j) + 0.5 * (k + 1) as f64) * step, step);
            }
            self.samples(part, &places[..n_places], &mut samples);
            for two in samples[..n_places].chunks_exact(2) {
                let start = f64::from(j) * step;
                let mean = self.mean(part, (start, low), two[0], (start + step, two[1]), self.master.depth);
                sum.light += mean.light * (-sum.depth / n as f32).exp();
                sum.depth += mean.depth;
                low = two[1];
                j += 1;
            }
        }
        Sample { light: sum.light / n as f32, depth: sum.depth / n as f32 }
    }

    /// The mean between two places, halved where the ends of a half differ.
    fn mean(&mut self, part: &Part, low: (f64, Sample), middle: Sample, high: (f64, Sample), halvings: u32) -> Sample {
        let middle = (0.5 * (low.0 + high.0), middle);
        let mut half = |from: (f64, Sample), to: (f64, Sample), end: Sample| {
            let differ = (from.1.light - to.1.light).abs().element_sum() > self.threshold;
            if differ && halvings > 0 {
                let place = self.displaced(0.5 * (from.0 + to.0), to.0 - from.0);
                let between = self.sample(part, place);
                self.mean(part, from, between, to, halvings - 1).times(0.5)
            } else {
                end.times(1.0 / 3.0).plus(middle.1.times(1.0 / 6.0))
            }
        };
        let near = half(low, middle, low.1);
        near.plus(half(middle, high, high.1))
    }

    /// A place, displaced by at most half of a distance.
    fn displaced(&mut self, place: f64, distance: f64) -> f64 {
        match self.master.jitter {
            0.0 => place,
            jitter => place + jitter * ((self.number)() - 0.5) * distance,
        }
    }

    /// What is found at places of a part, at most [`BATCH`].
    fn samples(&mut self, part: &Part, places: &[f64], samples: &mut [Sample; BATCH]) {
        let mut sums = [self.uniform.unwrap_or_default(); BATCH];
        if self.uniform.is_none() {
            self.add_coefficients(part, places, &mut sums);
        }
        for ((place, sum), sample) in places.iter().zip(sums).zip(samples) {
            let distance = part.from + place * part.length;
            *sample = self.lit(part, distance, self.segment.ray.at(distance), sum);
        }
    }

    /// What is found at a place of a part, 0 being its start and 1 its end.
    fn sample(&mut self, part: &Part, place: f64) -> Sample {
        let distance = part.from + place * part.length;
        let point = self.segment.ray.at(distance);
        let found = self.uniform.unwrap_or_else(|| self.coefficients(point));
        self.lit(part, distance, point, found)
    }

    /// What is found where media have some coefficients.
    fn lit(&mut self, part: &Part, distance: f64, point: DVec3, found: Coefficients) -> Sample {
        self.n_samples = self.n_samples.wrapping_add(1);
        let mut light = if self.settling.is_some() { found.emission } else { Rgb::ZERO };
        if self.settling.is_some() && part.lit && found.scattering != Rgb::ZERO {
            light += found.scattering * self.incoming(distance, point);
        }
        if self.carried.is_some() && found.scattering != Rgb::ZERO {
            light += found.scattering * self.brought(point);
        }
        let length = part.length as f32;
        Sample { light: light * length, depth: found.extinction * length }
    }

    fn coefficients(&self, point: DVec3) -> Coefficients {
        let mut sums = Coefficients::default();
        self.segment.media.iter().for_each(|medium| sums.add(medium, medium.density_at(point)));
        sums
    }

    /// Coefficients at points, one medium after the other: neighbours along a ray have much in common.
    fn add_coefficients(&self, part: &Part, places: &[f64], sums: &mut [Coefficients; BATCH]) {
        for medium in self.segment.media {
            for (places, sums) in places.chunks(LANES).zip(sums.chunks_mut(LANES)) {
                let point = |place: f64| self.segment.ray.at(part.from + place * part.length);
                let points = each_lane(|i| point(places[i.min(places.len() - 1)]));
                let densities = medium.densities_at(&points);
                sums.iter_mut().zip(densities).for_each(|(sum, density)| sum.add(medium, density));
            }
        }
    }

    /// Light from all sources, as much of each as media turn into the direction of the ray.
    fn incoming(&mut self, distance: f64, point: DVec3) -> Rgb {
        let mut sum = Rgb::ZERO;
        for lit in self.lights.iter().filter(|lit| lit.holds(distance)) {
            if let Some(incoming) = (self.incoming)(lit.light, point, self.n_samples) {
                sum += incoming.color * self.phase(incoming.direction.dot(self.segment.ray.direction));
            }
        }
        sum
    }

    /// Light that photons have left around a point, as much as media turn into the direction of the ray.
    fn brought(&mut self, point: DVec3) -> Rgb {
        let Some(carried) = self.carried.take() else { return Rgb::ZERO };
        let mut sum = Rgb::ZERO;
        let direction = self.segment.ray.direction;
        carried(point, &mut |incoming| sum += incoming.color * self.phase(incoming.direction.dot(direction)));
        self.carried = Some(carried);
        sum
    }

    /// Mean of the phase functions of all media; one that scatters nothing counts as 1, as in POV-Ray.
    fn phase(&self, cosine: f64) -> f32 {
        let media = self.segment.media;
        let sum: f64 = media.iter().map(|medium| medium.phase.map_or(1.0, |phase| phase.at(cosine))).sum();
        (sum / media.len() as f64) as f32
    }
}

impl Sample {
    /// The light as it leaves the part, if that is everywhere like the sample's place.
    fn weakened(self, place: f64) -> Self {
        Self { light: self.light * (-self.depth * place as f32).exp(), ..self }
    }

    fn plus(self, other: Self) -> Self {
        Self { light: self.light + other.light, depth: self.depth + other.depth }
    }

    fn times(self, factor: f32) -> Self {
        Self { light: self.light * factor, depth: self.depth * factor }
    }
}

impl Sums {
    fn add(&mut self, sample: Sample) {
        let light = sample.light.as_dvec3();
        self.n += 1;
        self.light += light;
        self.squares += light * light;
        self.depth += sample.depth;
    }

    /// Whether the variance of the mean is small.
    fn are_enough(&self, settling: &Settling) -> bool {
        let n = f64::from(self.n);
        let mean = self.light / n;
        let variance = (self.squares / n - mean * mean) / n;
        variance.max_element() < settling.threshold(self.n)
    }

    fn mean(&self) -> Sample {
        let n = f64::from(self.n);
        Sample { light: (self.light / n).as_vec3(), depth: self.depth / n as f32 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled::medium::Density;
    use crate::compiled::texture::{Blend, Pattern, PatternKind, Pigment, Warp};
    use crate::math::Color;
    use std::sync::Arc;

    /// POV-Ray's numbers: the Mersenne twister of seed 5489 but for its first number.
    ///
    /// Source: Matsumoto and Nishimura, "Mersenne Twister", ACM Transactions on Modeling and Computer Simulation 8, 1998.
    fn povray_numbers() -> impl FnMut() -> f64 {
        let mut state = vec![5489_u32];
        for i in 1..624_u32 {
            let last = state[i as usize - 1];
            state.push(1_812_433_253_u32.wrapping_mul(last ^ (last >> 30)).wrapping_add(i));
        }
        let mut next = 0;
        let mut number = move || {
            let joined = (state[next] & 0x8000_0000) | (state[(next + 1) % 624] & 0x7fff_ffff);
            let odd = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            state[next] = state[(next + 397) % 624] ^ (joined >> 1) ^ odd;
            let mut y = state[next];
            next = (next + 1) % 624;
            y ^= y >> 11;
            y ^= (y << 7) & 0x9d2c_5680;
            y ^= (y << 15) & 0xefc6_0000;
            f64::from(y ^ (y >> 18)) / 2.0_f64.powi(32)
        };
        number();
        number
    }

    /// A medium that glows and absorbs, its density a ramp along the ray or 1.
    fn medium(ramp: bool, sampling: Sampling) -> Medium {
        let mut pattern = Pattern::of(PatternKind::Gradient(DVec3::Z));
        pattern.warps = vec![Warp::Scaling { factor: DVec3::splat(0.5), offset: DVec3::ZERO }].into();
        let colors = Blend::map([(0.0, Color::BLACK), (1.0, Color::rgb(2.0, 1.0, 0.5))]);
        let pigment = Pigment::Colors(Box::new(pattern), Arc::new(colors));
        Medium {
            sampling,
            emission: Rgb::splat(if ramp { 0.3 } else { 0.1 }),
            scattering: Rgb::ZERO,
            extinction: Rgb::splat(if ramp { 0.7 } else { 0.5 }),
            phase: None,
            uniform: Rgb::ONE,
            densities: ramp.then_some(Density { pigment, side_by_side: false }).into_iter().collect(),
            has_density: ramp,
            ends_plain: !ramp,
            collects_photons: true,
        }
    }

    /// The light of a medium two units deep against POV-Ray's; one thread, whose numbers these are.
    fn check(ramp: bool, sampling: Sampling, expected: [f32; 3]) {
        let medium = medium(ramp, sampling);
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        let segment = Segment { ray: &ray, length: 2.0, media: &[&medium] };
        let settling = Settling::new(&sampling);
        let found = scattered(segment, &settling, &[], |_, _, _| None, None, povray_numbers()).radiance;
        assert!((found - Rgb::from(expected)).abs().max_element() < 1.6e-5, "{found} instead of {expected:?}");
    }

    #[test]
    fn random_samples_are_those_of_povray() {
        let plain = Sampling {
            method: Method::Random,
            intervals: 1,
            min_samples: 4,
            max_samples: 4,
            jitter: 0.0,
            depth: 2,
            threshold: 0.1,
            confidence: 0.9,
            variance: 1.0 / 128.0,
            ratio: 0.9,
        };
        check(true, plain, [0.137896, 0.128695, 0.096147]);
        let more = Sampling { min_samples: 2, max_samples: 8, variance: 0.0, ..plain };
        check(true, more, [0.167117, 0.149325, 0.109117]);
        let even =
            Sampling { method: Method::Even, intervals: 3, min_samples: 2, max_samples: 2, jitter: 0.5, ..plain };
        check(true, even, [0.291203, 0.213321, 0.132067]);
        check(false, Sampling { intervals: 10, min_samples: 1, max_samples: 1, ..plain }, [0.174655; 3]);
    }
}
