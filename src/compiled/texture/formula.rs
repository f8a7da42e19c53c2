//! The formulas of patterns: which is which, and those that need neither noise nor tables.

use super::lookup::{AtPoint, AtPoints, Lookup};
use super::noise_formula::{GRANITE_OCTAVES, GRANITE_SCALE, WRINKLES_OCTAVES};
use super::{Context, InnerTurbulence, Pattern, PatternKind, crackle, noise_formula};
use crate::math::noise::{noise, vector_noise};
use crate::math::{DVec3, LANES, Points, Uv, floor, fraction, modulo, round};
use std::f64::consts::{PI, TAU};

/// POV-Ray's offset that keeps exact borders on the upper cell.
pub(super) const CELL_OFFSET: f64 = 1e-10;
/// Height of a triangle of side 1.
const TRIANGLE_HEIGHT: f64 = 0.866_025_403_784_438_6;

/// The raw value, before frequency and wave. Formulas that are short are inlined.
#[inline(always)]
pub(super) fn value(pattern: &Pattern, p: DVec3, context: &Context) -> f64 {
    match &pattern.kind {
        PatternKind::None => 0.0,
        PatternKind::Boxed => boxed(p),
        PatternKind::Bozo(generator) | PatternKind::Bumps(generator) => noise(*generator, p),
        PatternKind::Checker => checker(p),
        PatternKind::Gradient(direction) => gradient(p, *direction),
        PatternKind::Onion => onion(p),
        PatternKind::Planar => planar(p),
        PatternKind::Spherical => spherical(p),
        _ => elaborate(pattern, p.x, p.y, p.z, context),
    }
}

/// The raw value of a formula that is worth a call.
#[inline(never)]
fn elaborate(pattern: &Pattern, x: f64, y: f64, z: f64, context: &Context) -> f64 {
    raw(pattern, AtPoint { x, y, z, context })
}

/// The raw values at four points, each with its surface coordinates, of a pattern that does not see normals.
pub(super) fn values(pattern: &Pattern, points: &Points, uvs: &[Uv; LANES]) -> [f64; LANES] {
    raw(pattern, AtPoints { points, uvs })
}

/// The raw value wherever a pattern is looked up.
#[inline(always)]
fn raw<L: Lookup>(pattern: &Pattern, at: L) -> L::Values {
    match &pattern.kind {
        PatternKind::None => at.map(|_| 0.0),
        PatternKind::Agate { generator, octaves, amount } => {
            at.map_turbulence(*generator, *octaves, |turbulence, p| noise_formula::agate(*amount, turbulence, p))
        }
        PatternKind::Aoi => at.map_context(|_, context| angle_of_incidence(context)),
        PatternKind::Boxed => at.map(boxed),
        PatternKind::Bozo(generator) | PatternKind::Bumps(generator) => at.map_noise(*generator, |noise| noise),
        PatternKind::Brick { size, mortar, limit } => at.map(|p| brick(p, *size, *mortar, *limit)),
        PatternKind::Cells => at.map(crackle::cells),
        PatternKind::Checker => at.map(checker),
        PatternKind::Crackle(crackle) => at.map(|p| crackle.value(p)),
        PatternKind::Cubic => at.map(cubic),
        PatternKind::Cylindrical => at.map(|p| falling(p.x.hypot(p.z))),
        PatternKind::Density(file) => at.map(|p| file.value(p)),
        PatternKind::Dents(generator) => at.map_noise(*generator, dents),
        PatternKind::Fractal(fractal) => at.map(|p| fractal.value(p.x, p.y)),
        PatternKind::Function(f) => at.map(|p| wrapped(f.at(p))),
        PatternKind::Gradient(direction) => at.map(|p| gradient(p, *direction)),
        PatternKind::Granite(generator) => at.map_halving::<GRANITE_OCTAVES>(*generator, GRANITE_SCALE, 1.0, |noise| {
            noise_formula::granite(*generator, noise)
        }),
        PatternKind::Hexagon => at.map(|p| hexagon(p.x, p.z)),
        PatternKind::Image(image, mapping) => at.map(|p| image.pattern_value(mapping, p)),
        PatternKind::Leopard => at.map_sines(noise_formula::leopard),
        PatternKind::Marble(inner) => shifted(at, inner.as_deref(), noise_formula::marble),
        PatternKind::Material(image, mapping, n) => at.map(|p| image.material_index(mapping, p, *n) as f64),
        PatternKind::Object(solid) => at.map(|p| f64::from(u8::from(solid.contains(p)))),
        PatternKind::Onion => at.map(onion),
        PatternKind::Pavement(pavement) => at.map(|p| pavement.value(p)),
        PatternKind::Pigment(pigment) => at.map_pigment(pigment),
        PatternKind::Planar => at.map(planar),
        PatternKind::Quilted(control) => at.map(|p| noise_formula::quilted(*control, p)),
        PatternKind::Radial => at.map(radial),
        PatternKind::Ripples(sources) => at.map(|p| sources.ripples(pattern.frequency, pattern.phase, p)),
        PatternKind::Slope(slope) => at.map_context(|p, context| slope.value(p, context)),
        PatternKind::Spherical => at.map(spherical),
        PatternKind::Spiral1(arms, inner) => {
            shifted(at, inner.as_deref(), |shift, p| noise_formula::spiral(*arms, shift, p))
        }
        PatternKind::Spiral2(arms, inner) => {
            shifted(at, inner.as_deref(), |shift, p| noise_formula::double_spiral(*arms, shift, p))
        }
        PatternKind::Square => at.map(square),
        PatternKind::Tiling(tiling) => at.map(|p| tiling.value(p)),
        PatternKind::Triangular => at.map(|p| triangular(p.x, p.z)),
        PatternKind::Waves(sources) => at.map(|p| sources.waves(pattern.frequency, pattern.phase, p)),
        PatternKind::Wood(None) => at.map(|p| p.x.hypot(p.y)),
        PatternKind::Wood(Some(inner)) => at.map_turbulent_sines(
            inner.octaves,
            |turbulence, p| noise_formula::wobble(inner.amount, turbulence, p),
            noise_formula::wobbling_wood,
        ),
        PatternKind::Wrinkles(generator) => {
            at.map_halving::<WRINKLES_OCTAVES>(*generator, 1.0, 0.5, |noise| noise_formula::wrinkles(*generator, noise))
        }
    }
}

/// The value of a formula into which turbulence enters as a number, if there is any.
#[inline(always)]
fn shifted<L: Lookup>(at: L, inner: Option<&InnerTurbulence>, formula: impl Fn(f64, DVec3) -> f64) -> L::Values {
    match inner {
        Some(inner) => {
            at.map_turbulence(inner.generator, inner.octaves, |turbulence, p| formula(inner.amount.x * turbulence, p))
        }
        None => at.map(|p| formula(0.0, p)),
    }
}

impl Pattern {
    /// The native displacement of a unit normal at a warped point, for patterns that have one beside their value.
    pub(super) fn bump(&self, p: DVec3) -> Option<DVec3> {
        Some(match &self.kind {
            PatternKind::Bumps(_) => vector_noise(p),
            PatternKind::Dents(generator) => dents(noise(*generator, p)) * vector_noise(p),
            PatternKind::Wrinkles(_) => noise_formula::wrinkles_bump(p),
            PatternKind::Quilted(control) => noise_formula::quilted_bump(*control, p),
            PatternKind::Ripples(sources) => sources.ripples_bump(self.frequency, self.phase, p),
            PatternKind::Waves(sources) => sources.waves_bump(self.frequency, self.phase, p),
            _ => return None,
        })
    }
}

/// Dents: noise of which only the heights stand out.
fn dents(noise: f64) -> f64 {
    noise.powi(3)
}

fn boxed(p: DVec3) -> f64 {
    falling(p.abs().max_element())
}

fn gradient(p: DVec3, direction: DVec3) -> f64 {
    wrapped(p.dot(direction))
}

fn onion(p: DVec3) -> f64 {
    fraction(p.length())
}

fn planar(p: DVec3) -> f64 {
    falling(p.y.abs())
}

fn spherical(p: DVec3) -> f64 {
    falling(p.length())
}

/// 1 in the middle, 0 from distance 1 on.
fn falling(distance: f64) -> f64 {
    if distance <= 1.0 { 1.0 - distance } else { 0.0 }
}

/// Values above 1 start again; the sign stays.
fn wrapped(v: f64) -> f64 {
    if v > 1.0 { fraction(v) } else { v }
}

fn angle_of_incidence(context: &Context) -> f64 {
    let normal = context.shading_normal().normalize_or_zero();
    if normal == DVec3::ZERO {
        return 0.0; // not on a surface
    }
    normal.dot(context.direction).clamp(-1.0, 1.0).acos() / PI
}

fn checker(p: DVec3) -> f64 {
    let q = p + CELL_OFFSET;
    modulo(floor(q.x) + floor(q.y) + floor(q.z), 2.0)
}

fn square(p: DVec3) -> f64 {
    let odd = |v: f64| modulo(floor(v), 2.0) == 1.0;
    let along_z = f64::from(u8::from(odd(p.z)));
    if odd(p.x) { 3.0 - along_z } else { along_z }
}

/// Index of the dominant direction: +x, +y, +z, -x, -y, -z; the first one wins ties.
pub(super) fn cubic(p: DVec3) -> f64 {
    let largest = p.abs().max_element();
    [p.x, p.y, p.z, -p.x, -p.y, -p.z].iter().position(|v| *v >= largest).unwrap_or(0) as f64
}

fn radial(p: DVec3) -> f64 {
    // POV-Ray's own limit for the axis.
    if p.x.abs() < 0.001 && p.z.abs() < 0.001 { 0.25 } else { 0.25 + (p.x.atan2(p.z) + PI) / TAU }
}

/// Regular hexagons of side 1 with flat sides towards z, centres (1.5 a, h b) for even a + b.
fn hexagon(x: f64, z: f64) -> f64 {
    let first = floor(x / 1.5);
    let center = |a: f64| {
        // The nearest b of the same parity as a.
        let b = 2.0 * round((z / TRIANGLE_HEIGHT - a) * 0.5) + a;
        ((x - 1.5 * a).powi(2) + (z - TRIANGLE_HEIGHT * b).powi(2), (b - 3.0 * a) * 0.5)
    };
    let (near, far) = (center(first), center(first + 1.0));
    let index = if near.0 <= far.0 { near.1 } else { far.1 };
    modulo(index, 3.0)
}

/// Triangles of side 1, six colours; period 3 in x, twice the height in z.
fn triangular(x: f64, z: f64) -> f64 {
    let z = z.rem_euclid(2.0 * TRIANGLE_HEIGHT);
    let upper = z >= TRIANGLE_HEIGHT;
    let z = if upper { 2.0 * TRIANGLE_HEIGHT - z } else { z };
    let slant = z * 0.5 / TRIANGLE_HEIGHT;
    let a = floor(x - slant);
    let index = if x + slant <= a + 1.0 { -2.0 * a } else { 1.0 + 2.0 * (a + 1.0) };
    let index = modulo(index, 6.0);
    if upper { 5.0 - index } else { index }
}

/// 0 in the mortar, 1 in a brick.
fn brick(p: DVec3, size: DVec3, mortar: f64, limit: DVec3) -> f64 {
    let q = (p + mortar + CELL_OFFSET) / size;
    let even_course = fraction(q.y * 0.5) <= 0.5;
    let (x, z) = if even_course { (q.x, q.z + 0.5) } else { (q.x + 0.5, q.z) };
    // All three are asked: which of them says no is a matter of chance, and a wrong guess costs more.
    let in_mortar = (fraction(q.y) <= limit.y) | (fraction(x) <= limit.x) | (fraction(z) <= limit.z);
    if in_mortar { 0.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(kind: PatternKind, points: &[([f64; 3], f64)]) {
        for (p, expected) in points {
            let found = value(&Pattern::of(kind.clone()), DVec3::from(*p), &Context::default());
            assert!((found - expected).abs() < 1e-9, "{kind:?} at {p:?}: {found} instead of {expected}");
        }
    }

    #[test]
    fn block_borders_lie_where_povray_puts_them() {
        let edge = 1.0 - 1e-11;
        let checker =
            [([0.5; 3], 0.0), ([-0.5, 0.5, 0.5], 1.0), ([edge, 0.5, 0.5], 1.0), ([1.0 - 1e-9, 0.5, 0.5], 0.0)];
        check(PatternKind::Checker, &checker);
        let brick = PatternKind::brick(DVec3::new(8.0, 3.0, 4.5), 0.5);
        let bricks = [
            ([-0.5, 0.1, 0.1], 0.0),
            ([0.0, -0.5, 0.0], 0.0),
            ([0.0; 3], 1.0),
            ([0.0, 2.5, 0.0], 0.0),
            ([0.0, 2.499, 0.0], 1.0),
        ];
        check(brick, &bricks);
        check(PatternKind::Radial, &[([0.0, 0.0, 1.0], 0.75), ([1.0, 0.0, 0.0], 1.0), ([-1.0, 0.0, 0.0], 0.5)]);
        check(PatternKind::Square, &[([0.5, 0.0, 0.5], 0.0), ([0.5, 0.0, 1.5], 1.0), ([1.5, 0.0, 0.5], 3.0)]);
        check(PatternKind::Cubic, &[([1.0, 1.0, 0.0], 0.0), ([0.0, -2.0, 1.0], 4.0)]);
    }

    #[test]
    fn tilings_of_the_plane_follow_their_rules() {
        check(PatternKind::Hexagon, &[([0.0; 3], 0.0), ([1.5, 0.0, TRIANGLE_HEIGHT], 2.0)]);
        check(PatternKind::Triangular, &[([0.5, 0.0, 0.1], 0.0), ([1.5, 0.0, 0.1], 4.0), ([1.0, 0.0, 0.1], 3.0)]);
    }
}
