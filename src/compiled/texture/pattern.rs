//! A pattern: how a point is moved, its formula, and the wave over the value.

use super::{
    Blend, Crackle, DensityFile, Fractal, InnerTurbulence, Mapping, Pavement, Pick, Pigment, Raster, Slope, Tiling,
    Warp, WaveSources, formula,
};
use crate::compiled::Function;
use crate::compiled::geometry::Geometry;
use crate::math::noise::{NoiseGenerator, Octaves};
use crate::math::{DVec3, LANES, Points, Uv, each_lane, fraction, power, round_to_even};
use std::sync::Arc;

/// A value for each point.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// The formula.
    pub kind: PatternKind,
    /// Steps of the lookup point, in the order in which it passes them.
    pub warps: Box<[Warp]>,
    /// Shape of the value over one period.
    pub wave: Wave,
    /// Multiplies the value; 0 leaves it as it is.
    pub frequency: f64,
    /// Added to the value.
    pub phase: f64,
}

/// The value's shape over one period.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub enum Wave {
    #[default]
    Ramp,
    Triangle,
    Sine,
    Scallop,
    Cubic,
    Poly(f64),
}

/// The formulas; constants are folded in.
#[derive(Clone, Debug, Default)]
#[allow(missing_docs)]
pub enum PatternKind {
    /// Only carries warps; the value is 0.
    #[default]
    None,
    Agate {
        generator: NoiseGenerator,
        octaves: Octaves,
        amount: f64,
    },
    Aoi,
    Boxed,
    Bozo(NoiseGenerator),
    /// Bozo with bumps of its own.
    Bumps(NoiseGenerator),
    /// Made by [`PatternKind::brick`].
    Brick {
        size: DVec3,
        mortar: f64,
        limit: DVec3,
    },
    Cells,
    Checker,
    Crackle(Box<Crackle>),
    Cubic,
    Cylindrical,
    Density(Arc<DensityFile>),
    Dents(NoiseGenerator),
    Fractal(Box<Fractal>),
    Function(Arc<Function>),
    /// Unit direction.
    Gradient(DVec3),
    Granite(NoiseGenerator),
    Hexagon,
    /// `image_pattern`.
    Image(Arc<Raster>, Mapping),
    Leopard,
    /// `material_map` with its number of textures.
    Material(Arc<Raster>, Mapping, usize),
    Marble(Option<Box<InnerTurbulence>>),
    /// 1 inside a solid, 0 outside.
    Object(Arc<Geometry>),
    Onion,
    Pavement(Pavement),
    Pigment(Arc<Pigment>),
    Planar,
    /// Control values.
    Quilted([f64; 2]),
    Radial,
    Ripples(Arc<WaveSources>),
    Slope(Box<Slope>),
    Spherical,
    /// Number of arms.
    Spiral1(f64, Option<Box<InnerTurbulence>>),
    /// Number of arms.
    Spiral2(f64, Option<Box<InnerTurbulence>>),
    Square,
    Tiling(Arc<Tiling>),
    Triangular,
    Waves(Arc<WaveSources>),
    Wood(Option<Box<InnerTurbulence>>),
    Wrinkles(NoiseGenerator),
}

/// What a pattern may ask about beside the point: where on which surface, seen from where.
#[derive(Clone, Copy, Debug, Default)]
pub struct Context {
    /// Surface coordinates.
    pub uv: Uv,
    /// Unit geometric normal in world space, on the side of the ray.
    pub normal: DVec3,
    /// Unit perturbed normal in world space, where there is one already.
    pub perturbed_normal: DVec3,
    /// Unit direction of the ray.
    pub direction: DVec3,
    /// World position.
    pub point: DVec3,
}

impl Context {
    /// The perturbed normal, or the geometric one before any bump; zero away from surfaces.
    pub fn shading_normal(&self) -> DVec3 {
        if self.perturbed_normal == DVec3::ZERO { self.normal } else { self.perturbed_normal }
    }

    /// A lookup at (u, v, 0).
    pub fn uv_point(&self) -> DVec3 {
        self.uv.lookup_point()
    }
}

impl PatternKind {
    /// Bricks of a size that includes the mortar's width, which fills a brick up to its share of it.
    pub fn brick(size: DVec3, mortar: f32) -> Self {
        // POV-Ray takes twice its border offset off the mortar, in single precision.
        let mortar = f64::from((f64::from(mortar) - 2.0 * formula::CELL_OFFSET) as f32);
        Self::Brick { size, mortar, limit: DVec3::splat(mortar) / size }
    }

    /// Whether noise is part of the formula.
    fn is_noisy(&self) -> bool {
        match self {
            Self::Agate { .. }
            | Self::Bozo(_)
            | Self::Bumps(_)
            | Self::Dents(_)
            | Self::Granite(_)
            | Self::Wrinkles(_) => true,
            Self::Marble(inner) | Self::Spiral1(_, inner) | Self::Spiral2(_, inner) | Self::Wood(inner) => {
                inner.is_some()
            }
            Self::Pigment(pigment) => pigment.has(&Pattern::is_noisy),
            _ => false,
        }
    }

    /// Whether the value depends on the normal.
    pub fn sees_normals(&self) -> bool {
        match self {
            Self::Aoi | Self::Slope(_) => true,
            Self::Pigment(pigment) => pigment.sees_normals(),
            _ => false,
        }
    }
}

impl Pattern {
    /// The bare formula: no warps, ramp wave, frequency 1.
    pub fn of(kind: PatternKind) -> Self {
        Self { kind, warps: Box::default(), wave: Wave::Ramp, frequency: 1.0, phase: 0.0 }
    }

    /// Whether noise is needed for a value.
    pub(super) fn is_noisy(&self) -> bool {
        self.kind.is_noisy() || self.warps.iter().any(|warp| matches!(warp, Warp::Turbulence { .. }))
    }

    /// Carries a point from the space that contains the pattern to that of the formula.
    #[inline(always)]
    pub fn warp(&self, point: DVec3) -> DVec3 {
        let moved = match &*self.warps {
            [] => point,
            [warp] => warp.apply(point),
            warps => warps.iter().fold(point, |p, warp| warp.apply(p)),
        };
        moved.clamp(DVec3::splat(-POV_FARTHEST), DVec3::splat(POV_FARTHEST))
    }

    /// [`warp`](Self::warp) for four points.
    pub fn warp_points(&self, points: &Points) -> Points {
        let limited = |c: f64| {
            let c = if c > -POV_FARTHEST { c } else { -POV_FARTHEST };
            if c < POV_FARTHEST { c } else { POV_FARTHEST }
        };
        if let [Warp::Scaling { factor, offset }] = &*self.warps {
            return points.map_coordinates(|axis, c| limited(factor[axis] * c + offset[axis]));
        }
        let mut moved = *points;
        for warp in &self.warps {
            moved = warp.apply_to_points(&moved);
        }
        moved.map_coordinates(|_, c| limited(c))
    }

    /// The value at a point of the containing space.
    #[inline]
    pub fn value(&self, point: DVec3, context: &Context) -> f64 {
        self.value_at_warped(self.warp(point), context)
    }

    /// The value at a point that [`warp`](Self::warp) gave.
    #[inline(always)]
    pub fn value_at_warped(&self, point: DVec3, context: &Context) -> f64 {
        let raw = formula::value(self, point, context);
        shape(raw, self.frequency, self.phase, self.wave)
    }

    /// The values at four points that [`warp_points`](Self::warp_points) gave, each with its surface coordinates, if the
    /// pattern does not [see normals](PatternKind::sees_normals).
    pub fn values_at_warped(&self, points: &Points, uvs: &[Uv; LANES]) -> [f64; LANES] {
        let raw = formula::values(self, points, uvs);
        let as_they_are = self.frequency == 0.0 || (self.frequency == 1.0 && self.phase == 0.0);
        let values = if as_they_are { raw } else { each_lane(|i| raw[i] * self.frequency + self.phase) };
        // Most values need no more.
        if matches!(self.wave, Wave::Ramp) && values.iter().all(|v| (0.0..POV_PERIOD).contains(v)) {
            return values;
        }
        raw.map(|raw| shape(raw, self.frequency, self.phase, self.wave))
    }

    /// What stands at a point that [`warp`](Self::warp) gave.
    #[inline(always)]
    pub fn pick_at_warped<'a, T>(&self, items: &'a Blend<T>, warped: DVec3, context: &Context) -> Pick<'a, T> {
        let value = if let Blend::Average(_) = items { 0.0 } else { self.value_at_warped(warped, context) };
        items.pick(value)
    }

    /// What stands at a point, and the warped point.
    #[inline(always)]
    pub fn pick<'a, T>(&self, items: &'a Blend<T>, point: DVec3, context: &Context) -> (Pick<'a, T>, DVec3) {
        let warped = self.warp(point);
        (self.pick_at_warped(items, warped, context), warped)
    }
}

/// POV-Ray's own limit for coordinates.
const POV_FARTHEST: f64 = 1e17;

/// POV-Ray's period of a value: a little more than 1, so that 1 itself stays.
const POV_PERIOD: f64 = 1.000_01;

/// The upper 26 bits of the period's mantissa, and the rest of it: products with whole numbers below 2^25 are exact.
const PERIOD_PARTS: [f64; 2] = {
    let upper = f64::from_bits(POV_PERIOD.to_bits() & (u64::MAX << 27));
    [upper, POV_PERIOD - upper]
};

/// The remainder by the period, with the value's sign, exactly.
#[inline(always)]
fn remainder(v: f64) -> f64 {
    let size = v.abs();
    if size < POV_PERIOD {
        return v;
    }
    if size >= f64::from(1 << 24) {
        return v % POV_PERIOD;
    }
    // The nearest quotient may be one too high; no difference rounds, as each is a multiple of 2^-52 and less than 2.
    let quotient = round_to_even(size * (1.0 / POV_PERIOD));
    let rest = size - quotient * PERIOD_PARTS[0] - quotient * PERIOD_PARTS[1];
    (if rest < 0.0 { rest + POV_PERIOD } else { rest }).copysign(v)
}

/// Frequency, phase and wave, as in section 2 of the pattern facts; the odd modulus is measured.
#[inline(always)]
fn shape(raw: f64, frequency: f64, phase: f64, wave: Wave) -> f64 {
    let v = if frequency == 0.0 { raw } else { raw * frequency + phase };
    // Most values need no more.
    if wave == Wave::Ramp && (0.0..POV_PERIOD).contains(&v) {
        return v;
    }
    waved(if frequency == 0.0 { v } else { remainder(v) }, wave)
}

/// The wave at a value that is within the period, but for its sign.
#[inline(never)]
fn waved(v: f64, wave: Wave) -> f64 {
    let v = if v < 0.0 { fraction(v) } else { v };
    match wave {
        Wave::Ramp => v,
        Wave::Triangle => 1.0 - (2.0 * fraction(v) - 1.0).abs(),
        Wave::Sine => (1.0 + (std::f64::consts::TAU * v).sin()) * 0.5,
        Wave::Scallop => (std::f64::consts::PI * v).sin().abs(),
        Wave::Cubic => v * v * (3.0 - 2.0 * v),
        Wave::Poly(exponent) => power(v, exponent),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(pattern: &Pattern, expected: [f64; 3]) {
        // P1, P3 and P5 of section 15 of the pattern facts.
        let points = [DVec3::new(0.3, 0.7, -1.2), DVec3::new(0.125, -0.25, 0.5), DVec3::new(-250.75, 1003.3, -87.6)];
        for (point, expected) in points.into_iter().zip(expected) {
            let found = pattern.value(point, &Context::default());
            assert!((found - expected).abs() < 1e-7, "{pattern:?} at {point}: {found} instead of {expected}");
        }
    }

    #[test]
    fn waves_are_those_of_povray() {
        let onion = || Pattern::of(PatternKind::Onion);
        check(&onion(), [0.4212670404, 0.5728219619, 0.8632918164]);
        let sine = Pattern { frequency: 1.5, phase: f64::from(0.3f32), wave: Wave::Sine, ..onion() };
        check(&sine, [0.2925279685, 0.9208508976, 0.2191461058]);
        check(&Pattern { wave: Wave::Scallop, ..onion() }, [0.9695654014, 0.9739444968, 0.4163993797]);
        check(&Pattern { wave: Wave::Cubic, ..onion() }, [0.3828766727, 0.6084605875, 0.949042531]);
        check(&Pattern { wave: Wave::Poly(2.5), ..onion() }, [0.1151844105, 0.2483414148, 0.6924589934]);
        let backward = Pattern { frequency: f64::from(-1.7f32), wave: Wave::Triangle, ..onion() };
        check(&backward, [0.5676920226, 0.052405275, 0.9351722581]);
    }

    #[test]
    fn remainders_are_those_of_the_library() {
        let near = |v: f64| [v.next_down(), v, v.next_up()];
        let whole = (0..5).chain((0..23).map(|i| 1 << i)).chain([12_345_678, 16_777_047, 16_777_048, 16_777_215]);
        let periods = whole.map(|n| f64::from(n) * POV_PERIOD).chain([0.3, 1.5, 7.9, 1e4 / 3.0, 1e9, f64::INFINITY]);
        for v in periods.flat_map(near).flat_map(|v| [v, -v]) {
            assert_eq!(remainder(v).to_bits() << 1, (v % POV_PERIOD).to_bits() << 1, "{v}");
        }
    }

    #[test]
    fn formulas_are_those_of_povray() {
        check(&Pattern::of(PatternKind::Checker), [0.0, 1.0, 0.0]);
        check(&Pattern::of(PatternKind::Leopard), [0.0000065857, 0.0141369177, 0.0000008785]);
        check(&Pattern::of(PatternKind::Radial), [0.2110004348, 0.7889895652, 0.4465084422]);
        let gradient = DVec3::new(1.0, 2.0, 3.0).normalize();
        check(&Pattern::of(PatternKind::Gradient(gradient)), [0.4922036404, 0.3006688972, 0.0343972373]);
        let brick = PatternKind::brick(DVec3::new(8.0, 3.0, 4.5), 0.5);
        check(&Pattern { frequency: 0.0, ..Pattern::of(brick) }, [1.0, 0.0, 1.0]);
    }
}
