//! Marching through media: what they add to light that passes, and what they take.
//!
//! Source: `docs/povray/media.md`, sections 3 to 5 (measured).

use super::Airlight;
use super::segment::{Lit, Part, for_each_part};
use super::settling::Settling;
use crate::compiled::medium::{Medium, Method, Sampling};
use crate::math::{DVec3, Ray, Rgb, gray};

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

/// What media do along a segment under lights.
///
/// `settling` belongs to the first of the media with the most intervals. `incoming` gives the light of a source, by its
/// number, at a point, the sample's number along the segment beside it; `number` gives random numbers in 0..1.
pub(super) fn scattered(
    segment: Segment<'_>,
    settling: &Settling,
    lights: &[Lit],
    incoming: impl FnMut(usize, DVec3, u32) -> Option<Incoming>,
    number: impl FnMut() -> f64,
) -> Airlight {
    let mut march = March::new(segment, lights, Some(settling), incoming, number);
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
        depth += if once { march.once(&part) } else { march.part(&part).depth };
    });
    (-depth).exp()
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
    scatters: bool,
    /// Emission and extinction, if they are the same everywhere.
    uniform: Option<(Rgb, Rgb)>,
    incoming: L,
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
        let first_of_most = media[1..].iter().fold(media[0], |best, next| {
            if next.sampling.intervals > best.sampling.intervals { next } else { best }
        });
        let uniform = media.iter().all(|medium| medium.is_uniform()).then(|| {
            let sum = |of: fn(&Medium) -> Rgb| media.iter().map(|medium| medium.uniform * of(medium)).sum();
            (sum(|medium| medium.emission), sum(|medium| medium.extinction))
        });
        Self {
            segment,
            lights,
            master: &first_of_most.sampling,
            has_density: first_of_most.has_density,
            threshold: media.iter().map(|medium| medium.sampling.threshold).fold(f32::INFINITY, f32::min),
            settling,
            scatters: media.iter().any(|medium| medium.scattering != Rgb::ZERO),
            uniform,
            incoming,
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
        let number = (self.number)();
        let place = match self.master.method {
            Method::Even => (0.5 + number * self.master.jitter) / f64::from(self.master.min_samples),
            Method::Random | Method::Adaptive => number,
        };
        self.sample(part, place).depth
    }

    /// Methods 1 and 2: the mean of samples, each weakened by what lies before it.
    fn averaged(&mut self, part: &Part) -> Sample {
        let Sampling { min_samples, max_samples, jitter, method, .. } = *self.master;
        let mut sums = Sums::default();
        for j in 0..min_samples {
            let number = (self.number)();
            let place = match method {
                Method::Even => (f64::from(j) + 0.5 + number * jitter) / f64::from(min_samples),
                Method::Random | Method::Adaptive => number,
            };
            sums.add(self.weakened(part, place));
        }
        if let Some(settling) = self.settling.filter(|_| max_samples > min_samples) {
            while sums.n <= max_samples && !sums.are_enough(settling) {
                let place = (self.number)();
                sums.add(self.weakened(part, place));
            }
        }
        sums.mean()
    }

    fn weakened(&mut self, part: &Part, place: f64) -> Sample {
        let Sample { light, depth } = self.sample(part, place);
        Sample { light: light * (-depth * place as f32).exp(), depth }
    }

    /// Method 3: steps of equal length, which leave out the last piece of the part.
    fn stepped(&mut self, part: &Part) -> Sample {
        let n = (self.master.min_samples / 2).saturating_add(1).max(2);
        let step = 1.0 / (f64::from(n) + 1.0);
        let mut before = self.displaced(part, 0.0, step);
        let mut sum = Sample::default();
        for j in 1..=n {
            let place = f64::from(j) * step;
            let next = self.displaced(part, place, step);
            let mean = self.mean(part, (place - step, before), (place, next), self.master.depth);
            sum.light += mean.light * (-sum.depth / n as f32).exp();
            sum.depth += mean.depth;
            before = next;
        }
        Sample { light: sum.light / n as f32, depth: sum.depth / n as f32 }
    }

    /// The mean between two places, halved where the ends of a half differ.
    fn mean(&mut self, part: &Part, low: (f64, Sample), high: (f64, Sample), halvings: u32) -> Sample {
        let place = 0.5 * (low.0 + high.0);
        let middle = (place, self.displaced(part, place, high.0 - low.0));
        let mut half = |from: (f64, Sample), to: (f64, Sample), end: Sample| {
            let differ = (from.1.light - to.1.light).abs().element_sum() > self.threshold;
            if differ && halvings > 0 {
                self.mean(part, from, to, halvings - 1).times(0.5)
            } else {
                end.times(1.0 / 3.0).plus(middle.1.times(1.0 / 6.0))
            }
        };
        let near = half(low, middle, low.1);
        near.plus(half(middle, high, high.1))
    }

    fn displaced(&mut self, part: &Part, place: f64, distance: f64) -> Sample {
        let number = (self.number)();
        self.sample(part, place + self.master.jitter * (number - 0.5) * distance)
    }

    /// What is found at a place of a part, 0 being its start and 1 its end.
    fn sample(&mut self, part: &Part, place: f64) -> Sample {
        self.n_samples = self.n_samples.wrapping_add(1);
        let distance = part.from + place * part.length;
        let point = self.segment.ray.at(distance);
        let shines = self.settling.is_some() && part.lit && self.scatters;
        let (mut light, extinction, scattering) = match self.uniform {
            Some((emission, extinction)) if !shines => (emission, extinction, Rgb::ZERO),
            _ => self.coefficients(point),
        };
        if self.settling.is_none() {
            light = Rgb::ZERO;
        } else if shines && scattering != Rgb::ZERO {
            light += scattering * self.incoming(distance, point);
        }
        let length = part.length as f32;
        Sample { light: light * length, depth: extinction * length }
    }

    /// Emission, extinction and scattering at a point.
    fn coefficients(&self, point: DVec3) -> (Rgb, Rgb, Rgb) {
        let mut sums = (Rgb::ZERO, Rgb::ZERO, Rgb::ZERO);
        for medium in self.segment.media {
            let density = medium.density(point);
            sums.0 += density * medium.emission;
            sums.1 += density * medium.extinction;
            sums.2 += density * medium.scattering;
        }
        sums
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

    /// Mean of the phase functions of all media; one that scatters nothing counts as 1, as in POV-Ray.
    fn phase(&self, cosine: f64) -> f32 {
        let media = self.segment.media;
        let sum: f64 = media.iter().map(|medium| medium.phase.map_or(1.0, |phase| phase.at(cosine))).sum();
        (sum / media.len() as f64) as f32
    }
}

impl Sample {
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
