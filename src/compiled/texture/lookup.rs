//! Where a pattern is looked up: at a point or at four. Formulas are written once for both.

use super::{Context, Pigment};
use crate::math::noise::{
    NoiseGenerator, Octaves, noise, noise_of_points, noises, noises_of_points, turbulence, turbulence_of_points,
    vector_turbulence, vector_turbulence_of_points,
};
use crate::math::sine::sines_of;
use crate::math::{DVec3, LANES, Points, Uv, each_lane, gray};

/// A point or four.
pub(super) trait Lookup: Copy {
    /// As many values.
    type Values;

    /// The values of a formula.
    fn map(self, formula: impl Fn(DVec3) -> f64) -> Self::Values;

    /// The values of a formula that looks at more than the point.
    fn map_context(self, formula: impl Fn(DVec3, &Context) -> f64) -> Self::Values;

    /// The values of a formula of a noise.
    fn map_noise(self, generator: NoiseGenerator, formula: impl Fn(f64) -> f64) -> Self::Values;

    /// The sums of terms of noises at `scale` times the point, at twice that and so on. The first term counts `weight`
    /// times, every other half as much as the one before.
    fn map_halving<const COUNT: usize>(
        self,
        generator: NoiseGenerator,
        scale: f64,
        weight: f64,
        term: impl Fn(f64) -> f64,
    ) -> Self::Values;

    /// The values of a formula of turbulence and the point.
    fn map_turbulence(
        self,
        generator: NoiseGenerator,
        octaves: Octaves,
        formula: impl Fn(f64, DVec3) -> f64,
    ) -> Self::Values;

    /// The values of a formula of turbulence as a vector and the point.
    fn map_vector_turbulence(self, octaves: Octaves, formula: impl Fn(DVec3, DVec3) -> f64) -> Self::Values;

    /// The values of a formula of the sines of the coordinates.
    fn map_sines(self, formula: impl Fn([f64; 3]) -> f64) -> Self::Values;

    /// How light a pigment is.
    fn map_pigment(self, pigment: &Pigment) -> Self::Values;
}

/// A point. By coordinates: as a vector it would go through memory, where it is written number by number and read in
/// pairs, for which the processor waits.
#[derive(Clone, Copy)]
pub(super) struct AtPoint<'c> {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) z: f64,
    pub(super) context: &'c Context,
}

impl AtPoint<'_> {
    #[inline(always)]
    fn point(self) -> DVec3 {
        DVec3::new(self.x, self.y, self.z)
    }
}

impl Lookup for AtPoint<'_> {
    type Values = f64;

    #[inline(always)]
    fn map(self, formula: impl Fn(DVec3) -> f64) -> f64 {
        formula(self.point())
    }

    #[inline(always)]
    fn map_context(self, formula: impl Fn(DVec3, &Context) -> f64) -> f64 {
        formula(self.point(), self.context)
    }

    #[inline(always)]
    fn map_noise(self, generator: NoiseGenerator, formula: impl Fn(f64) -> f64) -> f64 {
        formula(noise(generator, self.point()))
    }

    #[inline(always)]
    fn map_halving<const COUNT: usize>(
        self,
        generator: NoiseGenerator,
        scale: f64,
        mut weight: f64,
        term: impl Fn(f64) -> f64,
    ) -> f64 {
        let mut sum = 0.0;
        for noise in noises::<COUNT>(generator, scale * self.point(), 2.0) {
            sum += weight * term(noise);
            weight *= 0.5;
        }
        sum
    }

    #[inline(always)]
    fn map_turbulence(self, generator: NoiseGenerator, octaves: Octaves, formula: impl Fn(f64, DVec3) -> f64) -> f64 {
        formula(turbulence(generator, octaves, self.point()), self.point())
    }

    #[inline(always)]
    fn map_vector_turbulence(self, octaves: Octaves, formula: impl Fn(DVec3, DVec3) -> f64) -> f64 {
        formula(vector_turbulence(octaves, self.point()), self.point())
    }

    #[inline(always)]
    fn map_sines(self, formula: impl Fn([f64; 3]) -> f64) -> f64 {
        let [x, y, z, _] = sines_of([self.x, self.y, self.z, 0.0]);
        formula([x, y, z])
    }

    #[inline(always)]
    fn map_pigment(self, pigment: &Pigment) -> f64 {
        f64::from(gray(pigment.color_or_clear(self.point(), self.context).rgb))
    }
}

/// Four points with their surface coordinates; nothing else is known of their contexts.
#[derive(Clone, Copy)]
pub(super) struct AtPoints<'p> {
    pub(super) points: &'p Points,
    pub(super) uvs: &'p [Uv; LANES],
}

impl Lookup for AtPoints<'_> {
    type Values = [f64; LANES];

    #[inline(always)]
    fn map(self, formula: impl Fn(DVec3) -> f64) -> [f64; LANES] {
        self.points.map(formula)
    }

    #[inline(always)]
    fn map_context(self, formula: impl Fn(DVec3, &Context) -> f64) -> [f64; LANES] {
        each_lane(|i| formula(self.points.lane(i), &Context { uv: self.uvs[i], ..Context::default() }))
    }

    #[inline(always)]
    fn map_noise(self, generator: NoiseGenerator, formula: impl Fn(f64) -> f64) -> [f64; LANES] {
        let noises = noise_of_points(generator, self.points);
        each_lane(|i| formula(noises[i]))
    }

    #[inline(always)]
    fn map_halving<const COUNT: usize>(
        self,
        generator: NoiseGenerator,
        scale: f64,
        mut weight: f64,
        term: impl Fn(f64) -> f64,
    ) -> [f64; LANES] {
        let scaled = self.points.map_coordinates(|_, c| scale * c);
        let mut sums = [0.0; LANES];
        for noises in noises_of_points::<COUNT>(generator, &scaled, 2.0) {
            sums = each_lane(|i| sums[i] + weight * term(noises[i]));
            weight *= 0.5;
        }
        sums
    }

    #[inline(always)]
    fn map_turbulence(
        self,
        generator: NoiseGenerator,
        octaves: Octaves,
        formula: impl Fn(f64, DVec3) -> f64,
    ) -> [f64; LANES] {
        let turbulences = turbulence_of_points(generator, octaves, self.points);
        each_lane(|i| formula(turbulences[i], self.points.lane(i)))
    }

    #[inline(always)]
    fn map_vector_turbulence(self, octaves: Octaves, formula: impl Fn(DVec3, DVec3) -> f64) -> [f64; LANES] {
        let turbulences = vector_turbulence_of_points(octaves, self.points);
        each_lane(|i| formula(turbulences.lane(i), self.points.lane(i)))
    }

    #[inline(always)]
    fn map_sines(self, formula: impl Fn([f64; 3]) -> f64) -> [f64; LANES] {
        let along = |axis| sines_of(self.points.along(axis));
        let (x, y, z) = (along(0), along(1), along(2));
        each_lane(|i| formula([x[i], y[i], z[i]]))
    }

    #[inline(always)]
    fn map_pigment(self, pigment: &Pigment) -> [f64; LANES] {
        let colors = pigment.colors(self.points, self.uvs);
        each_lane(|i| f64::from(gray(colors[i].rgb)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{InnerTurbulence, Pattern, PatternKind, Warp, Wave, WaveSources};
    use super::*;
    use std::sync::Arc;

    /// A pattern's values at four points are those at each.
    fn check(pattern: &Pattern) {
        for step in [0.0, 0.01, 3.7] {
            let points = Points::from(each_lane(|i| DVec3::new(0.3, -1.7, 20.2) + i as f64 * step * DVec3::ONE));
            let context = Context { uv: Uv::Around(DVec3::new(1.0, 2.0, 3.0)), ..Context::default() };
            let found = pattern.values_at_warped(&pattern.warp_points(&points), &[context.uv; LANES]);
            assert_eq!(found, points.map(|p| pattern.value(p, &context)), "{pattern:?}");
        }
    }

    #[test]
    fn four_points_have_the_values_of_each() {
        let generator = NoiseGenerator::Corrected;
        let octaves = Octaves { count: 6, lambda: 2.0, omega: 0.5 };
        let inner = || Some(Box::new(InnerTurbulence { amount: DVec3::new(0.3, 0.4, 0.5), octaves, generator }));
        let kinds = [
            PatternKind::None,
            PatternKind::Agate { generator, octaves, amount: 0.7 },
            PatternKind::Boxed,
            PatternKind::Bozo(generator),
            PatternKind::brick(DVec3::new(0.8, 0.3, 0.45), 0.1),
            PatternKind::Cells,
            PatternKind::Checker,
            PatternKind::Cubic,
            PatternKind::Cylindrical,
            PatternKind::Dents(generator),
            PatternKind::Gradient(DVec3::Y),
            PatternKind::Granite(NoiseGenerator::Original),
            PatternKind::Granite(generator),
            PatternKind::Granite(NoiseGenerator::Perlin),
            PatternKind::Hexagon,
            PatternKind::Leopard,
            PatternKind::Marble(inner()),
            PatternKind::Onion,
            PatternKind::Planar,
            PatternKind::Quilted([1.0, 0.5]),
            PatternKind::Radial,
            PatternKind::Ripples(Arc::new(WaveSources::new(10))),
            PatternKind::Spherical,
            PatternKind::Spiral1(3.0, None),
            PatternKind::Spiral2(2.0, inner()),
            PatternKind::Square,
            PatternKind::Triangular,
            PatternKind::Waves(Arc::new(WaveSources::new(3))),
            PatternKind::Wood(None),
            PatternKind::Wood(inner()),
            PatternKind::Wrinkles(generator),
        ];
        let scaling = || Warp::Scaling { factor: DVec3::new(1.0, 0.5, -2.0), offset: DVec3::X };
        let turbulence = || Warp::Turbulence { amount: DVec3::splat(0.4), octaves };
        for kind in kinds {
            let plain = Pattern::of(kind);
            check(&plain);
            check(&Pattern { frequency: 1.7, phase: -0.3, wave: Wave::Triangle, ..plain.clone() });
            check(&Pattern { warps: [scaling()].into(), frequency: 0.5, ..plain.clone() });
            check(&Pattern { warps: [scaling(), turbulence(), Warp::Cubic].into(), ..plain });
        }
    }
}
