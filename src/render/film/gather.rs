//! What is brought back along a camera ray: light alone, or light with what layers need.
//!
//! The code that shades the first hit and sums up samples is written once over [`Gather`] and compiled
//! twice: with [`Radiance`] everything but the light falls away, so that a picture without layers pays
//! nothing; with [`Detail`] the light is summed in the same order, so that its bits are the same.

use super::coverage::Coverage;
use crate::compiled::geometry::Surface;
use crate::math::{DVec3, Rgb};
use crate::render::medium::Airlight;
use crate::render::radiance::{Mix, Radiance};

/// Where light comes from, as seen at the first surface; all terms add up to the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::render) enum Term {
    /// Ambient light and emission of the surface.
    Emission,
    /// Diffuse light and highlights from light sources.
    Direct,
    /// Light from other surfaces and the sky, gathered by radiosity.
    Indirect,
    /// Light that photons have brought by way of glass and mirrors.
    Caustics,
    /// Light that comes from below the surface.
    Subsurface,
    /// Mirrored light, total reflection included.
    Reflection,
    /// Light that comes through the surface, bent or not.
    Refraction,
    /// Sky and background where nothing is met.
    Background,
    /// Light that fog and rainbows add; the other terms are weakened by them.
    Atmosphere,
    /// Light that media give off or scatter; the other terms are weakened by them.
    Media,
}

/// How many terms there are.
pub(in crate::render) const N_TERMS: usize = Term::Media as usize + 1;

/// Something that light is gathered in.
pub(in crate::render) trait Gather: Mix + Clone + Send + Sync {
    /// The light itself.
    fn light(&self) -> Radiance;
    /// All of it in four numbers, if it is no more than that.
    fn stored(&self) -> Option<[f32; 4]> {
        None
    }
    /// The inverse of [`stored`](Self::stored).
    fn restored(_: [f32; 4]) -> Option<Self> {
        None
    }
    /// Adds light of one term.
    fn add(&mut self, term: Term, light: Radiance);
    /// Adds a surface's own and direct light behind a filter.
    fn add_own(&mut self, filter: Rgb, emission: Rgb, direct: Rgb);
    /// Carries everything so far through what lies on the way; what is added there is of one term.
    fn pass(&mut self, term: Term, air: &Airlight);
    /// Notes the normal that shades, towards the viewer, and the colour that counts as the surface's own.
    fn note_shading(&mut self, normal: DVec3, albedo: Rgb);
    /// Notes the first hit of a camera ray.
    fn note_hit(&mut self, surface: &Surface, length: f64, facing: DVec3);
    /// Notes that this is one camera ray.
    fn note_sample(&mut self);
    /// Sets the number of samples where sums have counted some several times.
    fn count(&mut self, n: u32);
    /// Counts samples anew, those of all parts.
    fn recount<'a>(&mut self, parts: impl Iterator<Item = &'a Self>)
    where
        Self: 'a;
}

impl Gather for Radiance {
    fn light(&self) -> Radiance {
        *self
    }

    fn stored(&self) -> Option<[f32; 4]> {
        Some([self.rgb.x, self.rgb.y, self.rgb.z, self.transparency])
    }

    fn restored([r, g, b, transparency]: [f32; 4]) -> Option<Self> {
        Some(Self { rgb: Rgb::new(r, g, b), transparency })
    }

    fn add(&mut self, _: Term, light: Radiance) {
        self.rgb += light.rgb;
        self.transparency += light.transparency;
    }

    fn add_own(&mut self, filter: Rgb, emission: Rgb, direct: Rgb) {
        self.rgb += filter * (emission + direct);
    }

    fn pass(&mut self, _: Term, air: &Airlight) {
        self.rgb = air.transmittance * self.rgb + air.radiance;
        self.transparency *= air.transparency;
    }

    fn note_shading(&mut self, _: DVec3, _: Rgb) {}

    fn note_hit(&mut self, _: &Surface, _: f64, _: DVec3) {}

    fn note_sample(&mut self) {}

    fn count(&mut self, _: u32) {}

    fn recount<'a>(&mut self, _: impl Iterator<Item = &'a Self>) {}
}

/// Light with everything that layers show.
#[derive(Clone, Debug, Default)]
pub(in crate::render) struct Detail {
    light: Radiance,
    terms: [Rgb; N_TERMS],
    /// Of the nearest sample.
    nearest: Option<Nearest>,
    /// Sums of unit vectors, world space, towards the viewer.
    normal: DVec3,
    geometric_normal: DVec3,
    albedo: Rgb,
    samples: u32,
    /// Mean of the squares of the samples.
    squares: Rgb,
    /// By index of object and texture.
    objects: Coverage,
    materials: Coverage,
}

/// Where a camera ray ended.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Nearest {
    /// Along the ray.
    pub(in crate::render) length: f64,
    /// World space.
    pub(in crate::render) point: DVec3,
}

impl Detail {
    /// The light of one term.
    pub(in crate::render) fn term(&self, term: Term) -> Rgb {
        self.terms[term as usize]
    }

    /// The nearest place that any sample met.
    pub(in crate::render) fn nearest(&self) -> Option<Nearest> {
        self.nearest
    }

    /// Mean shading normal; shorter than 1 where samples differ or miss.
    pub(in crate::render) fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Mean normal of the surface itself.
    pub(in crate::render) fn geometric_normal(&self) -> DVec3 {
        self.geometric_normal
    }

    /// Mean colour of the surface.
    pub(in crate::render) fn albedo(&self) -> Rgb {
        self.albedo
    }

    /// Camera rays that were sent for this.
    pub(in crate::render) fn samples(&self) -> u32 {
        self.samples
    }

    /// How far the samples are from their mean: the mean square of their distance, in working values.
    pub(in crate::render) fn variance(&self) -> Rgb {
        (self.squares - self.light.rgb * self.light.rgb).max(Rgb::ZERO)
    }

    /// Shares of frame-level objects.
    pub(in crate::render) fn objects(&self) -> &Coverage {
        &self.objects
    }

    /// Shares of textures.
    pub(in crate::render) fn materials(&self) -> &Coverage {
        &self.materials
    }
}

impl Mix for Detail {
    fn add_scaled(&mut self, other: &Self, weight: f32) {
        self.light.add_scaled(&other.light, weight);
        self.terms.iter_mut().zip(&other.terms).for_each(|(a, b)| *a += weight * *b);
        self.normal += f64::from(weight) * other.normal;
        self.geometric_normal += f64::from(weight) * other.geometric_normal;
        self.albedo += weight * other.albedo;
        self.samples += other.samples;
        self.squares += weight * other.squares;
        self.objects.add_scaled(&other.objects, weight);
        self.materials.add_scaled(&other.materials, weight);
        let nearer = |n: &Nearest| other.nearest.is_none_or(|o| n.length <= o.length);
        self.nearest = self.nearest.filter(nearer).or(other.nearest);
    }

    fn scaled(mut self, weight: f32) -> Self {
        self.light = self.light.scaled(weight);
        self.terms.iter_mut().for_each(|term| *term *= weight);
        self.normal *= f64::from(weight);
        self.geometric_normal *= f64::from(weight);
        self.albedo *= weight;
        self.squares *= weight;
        self.objects.scale(weight);
        self.materials.scale(weight);
        self
    }
}

impl Gather for Detail {
    fn light(&self) -> Radiance {
        self.light
    }

    fn add(&mut self, term: Term, light: Radiance) {
        self.light.add(term, light);
        self.terms[term as usize] += light.rgb;
    }

    fn add_own(&mut self, filter: Rgb, emission: Rgb, direct: Rgb) {
        self.light.add_own(filter, emission, direct);
        self.terms[Term::Emission as usize] += filter * emission;
        self.terms[Term::Direct as usize] += filter * direct;
    }

    fn pass(&mut self, term: Term, air: &Airlight) {
        self.light.pass(term, air);
        self.terms.iter_mut().for_each(|term| *term *= air.transmittance);
        self.terms[term as usize] += air.radiance;
    }

    fn note_shading(&mut self, normal: DVec3, albedo: Rgb) {
        self.normal = normal;
        self.albedo = albedo;
    }

    fn note_hit(&mut self, surface: &Surface, length: f64, facing: DVec3) {
        let side = if surface.geometric_normal.dot(facing) < 0.0 { -1.0 } else { 1.0 };
        self.geometric_normal = side * surface.geometric_normal;
        self.nearest = Some(Nearest { length, point: surface.point });
        self.objects = Coverage::all(surface.object.number());
        let total: f32 = surface.textures.iter().map(|t| t.weight).sum();
        for seen in &surface.textures {
            self.materials.add(seen.texture.number(), seen.weight / total);
        }
    }

    fn note_sample(&mut self) {
        self.samples = 1;
        self.squares = self.light.rgb * self.light.rgb;
    }

    fn count(&mut self, n: u32) {
        self.samples = n;
    }

    fn recount<'a>(&mut self, parts: impl Iterator<Item = &'a Self>) {
        self.samples = parts.map(|part| part.samples).sum();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(distance: f64, object: u32) -> Detail {
        let mut sample = Detail::default();
        sample.add_own(Rgb::splat(0.5), Rgb::X, Rgb::Y);
        sample.add(Term::Reflection, Radiance { rgb: Rgb::Z, transparency: 0.25 });
        sample.nearest = Some(Nearest { length: distance, point: distance * DVec3::Z });
        sample.objects = Coverage::all(object);
        sample.note_sample();
        sample
    }

    fn check(detail: &Detail, nearest: f64, shares: &[(u32, f32)], samples: u32) {
        assert_eq!(detail.nearest.map(|n| n.length), Some(nearest));
        assert_eq!(detail.objects.ranked(), shares);
        assert_eq!(detail.samples, samples);
        let sum: Rgb = detail.terms.iter().sum();
        assert!((sum - detail.light.rgb).abs().max_element() < 1e-6, "{detail:?}");
    }

    #[test]
    fn samples_mix_by_weight_and_the_nearest_gives_the_depth() {
        let mut sum = sample(5.0, 3);
        check(&sum, 5.0, &[(3, 1.0)], 1);
        sum.add_scaled(&sample(2.0, 4), 1.0);
        sum.add_scaled(&sample(7.0, 4), 1.0);
        sum.add_scaled(&Detail::default(), 1.0);
        let mut mean = sum.scaled(0.25);
        check(&mean, 2.0, &[(4, 0.5), (3, 0.25)], 3);
        mean.pass(Term::Atmosphere, &Airlight { transmittance: Rgb::splat(0.5), radiance: Rgb::X, transparency: 0.5 });
        check(&mean, 2.0, &[(4, 0.5), (3, 0.25)], 3);
        // Of light and darkness in equal shares both are half of the light off.
        let dark = Detail::default();
        let mut mixed = sample(1.0, 1).scaled(0.5);
        mixed.add_scaled(&dark, 0.5);
        assert_eq!(mixed.variance(), 0.25 * sample(1.0, 1).light().rgb * sample(1.0, 1).light().rgb);
        let parts = [sample(1.0, 1), sample(1.0, 1)];
        mean.recount(parts.iter());
        assert_eq!(mean.samples(), 2);
    }
}
