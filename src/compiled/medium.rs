//! Participating media: what fills a volume and acts on the light that passes it.
//!
//! Space: world. Source: `docs/povray/media.md`, sections 1 and 3 (measured).

use super::texture::{Context, Pigment};
use crate::math::{DVec3, LANES, Rgb, Uv, power};

/// One medium; all its coefficients are per unit length and are weighted by its density.
#[derive(Clone, Debug)]
pub struct Medium {
    /// How a piece of a ray is sampled.
    pub sampling: Sampling,
    /// Light that it gives off.
    pub emission: Rgb,
    /// Light that it turns into the direction of the ray, before the phase function.
    pub scattering: Rgb,
    /// Light that it takes from the ray.
    pub extinction: Rgb,
    /// How scattered light spreads; `None` if it scatters nothing.
    pub phase: Option<Phase>,
    /// The part of the density that is the same everywhere.
    pub uniform: Rgb,
    /// The parts of the density that depend on the place; they multiply. Cheap ones come first: where they are 0, the
    /// others are not asked.
    pub densities: Vec<Density>,
    /// A density was written, if only a plain colour.
    pub has_density: bool,
    /// The density that was written last is a plain colour, or there is none.
    pub ends_plain: bool,
    /// Light that photons bring it does not get straight from its source.
    pub collects_photons: bool,
}

/// A part of a density that depends on the place.
#[derive(Clone, Debug)]
pub struct Density {
    /// Its colours are the density, per channel.
    pub pigment: Pigment,
    /// Whether it pays to look at four points at once.
    pub side_by_side: bool,
}

/// How a medium is sampled along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Which of the three ways.
    pub method: Method,
    /// Pieces into which a ray is cut.
    pub intervals: u32,
    /// Fewest samples of a piece.
    pub min_samples: u32,
    /// Most samples of a piece, for the first two methods.
    pub max_samples: u32,
    /// Displacement of samples, as a share of their distance.
    pub jitter: f64,
    /// How often a step is halved at most.
    pub depth: u32,
    /// Difference of two samples from which on the step between them is halved.
    pub threshold: f32,
    /// Confidence and variance with which sampling ends.
    pub confidence: f64,
    /// See `confidence`.
    pub variance: f64,
    /// Share of the pieces for what is lit.
    pub ratio: f64,
}

/// The three ways of sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Method 1: samples at random.
    Random,
    /// Method 2: samples at even distances.
    Even,
    /// Method 3: even steps that are halved where neighbours differ.
    Adaptive,
}

/// The phase functions: how much light goes on at an angle, before scattering of light of the same strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phase {
    /// Type 1, the same in all directions.
    Isotropic,
    /// Type 2, Mie scattering in haze.
    Hazy,
    /// Type 3, Mie scattering in murk.
    Murky,
    /// Type 4.
    Rayleigh,
    /// Type 5, with its eccentricity.
    HenyeyGreenstein(f64),
}

impl Phase {
    /// The factor of light that comes from a direction with this cosine to the ray's own.
    ///
    /// Source: docs/povray/media.md, section 3; Henyey and Greenstein, Astrophysical Journal 93, 1941.
    pub fn at(self, cosine: f64) -> f64 {
        match self {
            Self::Isotropic => 1.0,
            Self::Hazy => 0.576_655_375 * (1.0 + 9.0 * (0.5 * (1.0 + cosine)).powi(8)),
            Self::Murky => 0.495_714_547 * (1.0 + 50.0 * (0.5 * (1.0 + cosine)).powi(32)),
            Self::Rayleigh => 0.799_372_013 * (1.0 + cosine * cosine),
            Self::HenyeyGreenstein(g) => (1.0 - g * g) / power(1.0 + g * g - 2.0 * g * cosine, 1.5),
        }
    }
}

impl Density {
    fn at(&self, point: DVec3) -> Rgb {
        self.pigment.color_or_clear(point, &Context { point, ..Context::default() }).rgb
    }

    /// Multiplies products by the density at their points.
    fn multiply(&self, points: &[DVec3; LANES], products: &mut [Rgb; LANES]) {
        if self.side_by_side {
            let colors = self.pigment.colors(&(*points).into(), &[Uv::default(); LANES]);
            products.iter_mut().zip(colors).for_each(|(product, color)| *product *= color.rgb);
            return;
        }
        let mut context = Context::default();
        for (product, point) in products.iter_mut().zip(points) {
            if *product != Rgb::ZERO {
                context.point = *point;
                *product *= self.pigment.color_or_clear(*point, &context).rgb;
            }
        }
    }
}

impl Medium {
    /// Its densities at four world points, per channel.
    pub fn densities_at(&self, points: &[DVec3; LANES]) -> [Rgb; LANES] {
        let mut products = [self.uniform; LANES];
        for density in &self.densities {
            if products.iter().all(|product| *product == Rgb::ZERO) {
                break;
            }
            density.multiply(points, &mut products);
        }
        products
    }

    /// Its density at a world point, per channel.
    #[inline]
    pub fn density_at(&self, point: DVec3) -> Rgb {
        self.densities.iter().fold(self.uniform, |product, density| {
            if product == Rgb::ZERO { product } else { product * density.at(point) }
        })
    }

    /// Whether its density is the same everywhere.
    pub fn is_uniform(&self) -> bool {
        self.densities.is_empty()
    }

    /// Whether it does nothing to light anywhere.
    pub fn is_nothing(&self) -> bool {
        let acts = [self.emission, self.scattering, self.extinction].iter().any(|c| *c != Rgb::ZERO);
        !acts || self.uniform == Rgb::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seen against the light, along it, and across.
    fn check(phase: Phase, expected: [f64; 3]) {
        let found = [1.0, -1.0, 0.0].map(|cosine| phase.at(cosine));
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() < 1.6e-4, "{phase:?} {found:?}"));
    }

    #[test]
    fn phase_functions_are_those_of_povray() {
        check(Phase::Isotropic, [1.0; 3]);
        check(Phase::Hazy, [5.76654, 0.57664, 0.59693]);
        check(Phase::Rayleigh, [1.59869, 1.59869, 0.79942]);
        check(Phase::HenyeyGreenstein(0.3), [2.65309, 0.41413, 0.79973]);
    }
}
