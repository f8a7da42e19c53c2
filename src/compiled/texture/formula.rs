//! The formulas of patterns: here those that need neither noise nor tables.

use super::{Context, InnerTurbulence, Pattern, PatternKind, Pigment, crackle, noise_formula};
use crate::math::noise::{noise, noise_of_points, turbulence, turbulence_of_points, vector_noise};
use crate::math::{DVec3, LANES, Points, Uv, each_lane, floor, fraction, gray, modulo, round};
use std::f64::consts::{PI, TAU};

/// POV-Ray's offset that keeps exact borders on the upper cell.
const CELL_OFFSET: f64 = 1e-10;
/// Height of a triangle of side 1.
const TRIANGLE_HEIGHT: f64 = 0.866_025_403_784_438_6;

/// The raw value, before frequency and wave.
#[inline(always)]
pub(super) fn value(pattern: &Pattern, p: DVec3, context: &Context) -> f64 {
    match &pattern.kind {
        PatternKind::None => 0.0,
        PatternKind::Boxed => boxed(p),
        PatternKind::Bozo(generator) | PatternKind::Bumps(generator) => noise(*generator, p),
        PatternKind::Checker => checker(p),
        PatternKind::Gradient(direction) => wrapped(p.dot(*direction)),
        PatternKind::Onion => onion(p),
        PatternKind::Planar => planar(p),
        PatternKind::Spherical => spherical(p),
        _ => elaborate(pattern, p.x, p.y, p.z, context),
    }
}

/// The raw values at four points, each with its surface coordinates, of a pattern that does not see normals.
pub(super) fn values(pattern: &Pattern, points: &Points, uvs: &[Uv; LANES]) -> [f64; LANES] {
    match &pattern.kind {
        PatternKind::Agate { generator, octaves, amount } => {
            let turbulences = turbulence_of_points(*generator, *octaves, points);
            each_lane(|i| noise_formula::agate(*amount, turbulences[i], points.lane(i)))
        }
        PatternKind::Boxed => points.map(boxed),
        PatternKind::Bozo(generator) | PatternKind::Bumps(generator) => noise_of_points(*generator, points),
        PatternKind::Checker => points.map(checker),
        PatternKind::Dents(generator) => {
            let noises = noise_of_points(*generator, points);
            each_lane(|i| dents(noises[i]))
        }
        PatternKind::Gradient(direction) => points.map(|p| wrapped(p.dot(*direction))),
        PatternKind::Granite(generator) => noise_formula::granite_of_points(*generator, points),
        PatternKind::Marble(inner) => with_turbulence(inner.as_deref(), points, noise_formula::marble),
        PatternKind::Spiral1(arms, inner) => {
            with_turbulence(inner.as_deref(), points, |shift, p| noise_formula::spiral(*arms, shift, p))
        }
        PatternKind::Spiral2(arms, inner) => {
            with_turbulence(inner.as_deref(), points, |shift, p| noise_formula::double_spiral(*arms, shift, p))
        }
        PatternKind::Wood(Some(inner)) => noise_formula::wood_of_points(inner, points),
        PatternKind::Wrinkles(generator) => noise_formula::wrinkles_of_points(*generator, points),
        PatternKind::Onion => points.map(onion),
        PatternKind::Planar => points.map(planar),
        PatternKind::Spherical => points.map(spherical),
        PatternKind::Pigment(pigment) => {
            let colors = pigment.colors_or_clear(points, uvs);
            each_lane(|i| f64::from(gray(colors[i].rgb)))
        }
        _ => {
            let context = Context::default();
            let mut values = [0.0; LANES];
            for (i, raw) in values.iter_mut().enumerate() {
                *raw = value(pattern, points.lane(i), &context);
            }
            values
        }
    }
}

/// The values of a formula into which turbulence enters as a number.
#[inline(always)]
fn with_turbulence(
    inner: Option<&InnerTurbulence>,
    points: &Points,
    formula: impl Fn(f64, DVec3) -> f64,
) -> [f64; LANES] {
    let shifts = inner.map_or([0.0; LANES], |t| t.scalar_of_points(points));
    each_lane(|i| formula(shifts[i], points.lane(i)))
}

/// The raw value of a formula that is worth a call, at (x, y, z): a point would go through memory, where it is
/// written number by number and read in pairs, for which the processor waits. Formulas that are short are inlined for
/// the same reason.
#[inline(never)]
fn elaborate(pattern: &Pattern, x: f64, y: f64, z: f64, context: &Context) -> f64 {
    // One for each formula: so none of them goes through memory for the sake of another.
    let p = || DVec3::new(x, y, z);
    let shift = |inner: &Option<Box<InnerTurbulence>>| inner.as_ref().map_or(0.0, |t| t.scalar(p()));
    match &pattern.kind {
        PatternKind::Agate { generator, octaves, amount } => {
            noise_formula::agate(*amount, turbulence(*generator, *octaves, p()), p())
        }
        PatternKind::Aoi => angle_of_incidence(context),
        PatternKind::Brick { size, mortar, limit } => brick(p(), *size, *mortar, *limit),
        PatternKind::Cells => crackle::cells(p()),
        PatternKind::Crackle(crackle) => crackle.value(p()),
        PatternKind::Cubic => cubic(p()),
        PatternKind::Cylindrical => falling(x.hypot(z)),
        PatternKind::Density(file) => file.value(p()),
        PatternKind::Dents(generator) => dents(noise(*generator, p())),
        PatternKind::Fractal(fractal) => fractal.value(x, y),
        PatternKind::Function(f) => wrapped(f.at(p())),
        PatternKind::Granite(generator) => noise_formula::granite(*generator, p()),
        PatternKind::Hexagon => hexagon(x, z),
        PatternKind::Image(image, mapping) => image.pattern_value(mapping, p()),
        PatternKind::Leopard => noise_formula::leopard(p()),
        PatternKind::Marble(inner) => noise_formula::marble(shift(inner), p()),
        PatternKind::Material(image, mapping, n) => image.material_index(mapping, p(), *n) as f64,
        PatternKind::Object(solid) => f64::from(u8::from(solid.contains(p()))),
        PatternKind::Pavement(pavement) => pavement.value(p()),
        PatternKind::Pigment(pigment) => gray_at(pigment, p(), context),
        PatternKind::Quilted(control) => noise_formula::quilted(*control, p()),
        PatternKind::Radial => radial(p()),
        PatternKind::Ripples(sources) => sources.ripples(pattern.frequency, pattern.phase, p()),
        PatternKind::Slope(slope) => slope.value(p(), context),
        PatternKind::Spiral1(arms, inner) => noise_formula::spiral(*arms, shift(inner), p()),
        PatternKind::Spiral2(arms, inner) => noise_formula::double_spiral(*arms, shift(inner), p()),
        PatternKind::Square => square(p()),
        PatternKind::Tiling(tiling) => tiling.value(p()),
        PatternKind::Triangular => triangular(x, z),
        PatternKind::Waves(sources) => sources.waves(pattern.frequency, pattern.phase, p()),
        PatternKind::Wood(inner) => noise_formula::wood(inner.as_deref(), p()),
        PatternKind::Wrinkles(generator) => noise_formula::wrinkles(*generator, p()),
        PatternKind::None
        | PatternKind::Boxed
        | PatternKind::Bozo(_)
        | PatternKind::Bumps(_)
        | PatternKind::Checker
        | PatternKind::Gradient(_)
        | PatternKind::Onion
        | PatternKind::Planar
        | PatternKind::Spherical => value(pattern, p(), context),
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
    normal.dot(context.direction).clamp(-1.0, 1.0).acos() / PI
}

fn gray_at(pigment: &Pigment, p: DVec3, context: &Context) -> f64 {
    f64::from(gray(pigment.color_or_clear(p, context).rgb))
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
        let brick = PatternKind::brick(DVec3::new(8.0, 3.0, 4.5), f64::from((0.5 - 2e-10) as f32));
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
