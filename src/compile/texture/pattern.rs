//! Patterns: warps in the order in which a point passes them, formulas with folded constants.

use super::{Refusal, TextureCompiler};
use crate::compile::function::Functions;
use crate::compile::geometry::compile_object_sharing;
use crate::compiled::geometry::Geometry;
use crate::compiled::texture::{
    Around, BlackHole, Coloring, Crackle, DensityFile, Fractal, FractalSet, InnerTurbulence, Pattern, PatternKind,
    Pavement, Slope, SlopeAxis, Tiling, Warp, Wave, WaveSources,
};
use crate::function::Translate as _;
use crate::math::DVec3;
use crate::math::noise::{NoiseGenerator, Octaves};
use crate::omission::Omission;
use crate::scene;
use std::sync::Arc;

impl TextureCompiler<'_> {
    /// Compiles a pattern with its warps.
    ///
    /// # Errors
    /// As [`texture`](Self::texture).
    pub fn pattern(&mut self, pattern: &scene::Pattern) -> Result<Pattern, Refusal> {
        let is_needed =
            |w: &&scene::Warp| !is_identity(w) || !self.ledger.omits(Omission::IdentityWarps, size_of::<Warp>());
        let mut warps: Vec<Warp> = pattern.warps.iter().rev().filter(is_needed).map(warp).collect();
        let kind = self.kind(pattern)?;
        // Marble and wood take the turbulence into their formula; all others move the point.
        if let Some(turbulence) = &pattern.turbulence
            && turbulence.amount != DVec3::ZERO
            && !matches!(kind, PatternKind::Marble(_) | PatternKind::Wood(_))
        {
            warps.push(warp(&scene::Warp::Turbulence(*turbulence)));
        }
        Ok(Pattern {
            kind,
            warps: warps.into(),
            wave: wave(pattern.wave),
            frequency: f64::from(pattern.frequency),
            phase: f64::from(pattern.phase),
        })
    }

    fn kind(&mut self, pattern: &scene::Pattern) -> Result<PatternKind, Refusal> {
        use scene::PatternKind as S;
        let generator = self.generator(pattern);
        let inner = || {
            let t = pattern.turbulence.filter(|t| t.amount != DVec3::ZERO)?;
            Some(Box::new(InnerTurbulence { amount: t.amount, octaves: octaves(&t), generator }))
        };
        Ok(match &pattern.kind {
            S::None | S::Average | S::Uv => PatternKind::None,
            S::Agate { turbulence } => PatternKind::Agate {
                generator,
                octaves: octaves(&pattern.turbulence.unwrap_or_default()),
                amount: f64::from(*turbulence),
            },
            S::Aoi => PatternKind::Aoi,
            S::Boxed => PatternKind::Boxed,
            S::Bozo | S::Spotted => PatternKind::Bozo(generator),
            S::Bumps => PatternKind::Bumps(generator),
            S::Brick { size, mortar } => PatternKind::brick(*size, *mortar),
            S::Cells => PatternKind::Cells,
            S::Checker => PatternKind::Checker,
            S::Crackle { form, metric, offset, solid } => PatternKind::Crackle(Box::new(Crackle {
                form: *form,
                metric: *metric,
                offset: *offset,
                solid: solid.then_some(generator),
            })),
            S::Cubic => PatternKind::Cubic,
            S::Cylindrical => PatternKind::Cylindrical,
            S::DensityFile { span, interpolation, data, .. } => {
                let read = DensityFile::new(data, *interpolation);
                PatternKind::Density(Arc::new(read.map_err(|wrong| Refusal::from(wrong).at(*span))?))
            }
            S::Dents => PatternKind::Dents(generator),
            S::Function(function) => PatternKind::Function(self.functions.function(function)?),
            S::Gradient(direction) => PatternKind::Gradient(direction.normalize_or_zero()),
            S::Granite => PatternKind::Granite(generator),
            S::Hexagon => PatternKind::Hexagon,
            S::Image(picture) => PatternKind::Image(self.value_picture(&picture.0)?, mapping_of(&picture.1)),
            S::Julia { .. } | S::Magnet { .. } | S::Mandel { .. } => {
                PatternKind::Fractal(Box::new(fractal(&pattern.kind)?))
            }
            S::Leopard => PatternKind::Leopard,
            S::Marble => PatternKind::Marble(inner()),
            S::Material(picture) => PatternKind::Material(self.value_picture(&picture.0)?, mapping_of(&picture.1), 0),
            S::Object(object) => PatternKind::Object(Arc::new(solid(object, &self.functions)?)),
            S::Onion => PatternKind::Onion,
            S::Pavement { span, sides, tiles, pattern, interior, exterior, form } => {
                let pavement = Pavement::new(*sides, *tiles, *pattern, [*interior, *exterior, *form]);
                let wanted = || {
                    let wrong =
                        format!("there is no pavement of {tiles} tiles with {sides} sides in pattern {pattern}");
                    Refusal::from(wrong).at(*span)
                };
                PatternKind::Pavement(pavement.ok_or_else(wanted)?)
            }
            S::Pigment(pigment) => PatternKind::Pigment(Arc::new(self.pigment(pigment)?)),
            S::Planar => PatternKind::Planar,
            S::Quilted { control0, control1 } => PatternKind::Quilted([f64::from(*control0), f64::from(*control1)]),
            S::Radial => PatternKind::Radial,
            S::Ripples => PatternKind::Ripples(self.wave_sources()),
            S::Slope { direction, low, high, altitude } => {
                PatternKind::Slope(Box::new(slope(direction, [*low, *high], altitude)))
            }
            S::Spherical => PatternKind::Spherical,
            S::Spiral1(arms) => PatternKind::Spiral1(f64::from(*arms), inner()),
            S::Spiral2(arms) => PatternKind::Spiral2(f64::from(*arms), inner()),
            S::Square => PatternKind::Square,
            S::Tiling(n) => {
                let tiling = Tiling::new(*n).ok_or_else(|| format!("there is no tiling {n}"))?;
                PatternKind::Tiling(Arc::new(tiling))
            }
            S::Triangular => PatternKind::Triangular,
            S::Waves => PatternKind::Waves(self.wave_sources()),
            S::Wood => PatternKind::Wood(inner()),
            S::Wrinkles => PatternKind::Wrinkles(generator),
        })
    }

    /// The pattern's own noise generator, or the scene's.
    fn generator(&self, pattern: &scene::Pattern) -> NoiseGenerator {
        match pattern.noise_generator.unwrap_or(self.settings.noise_generator()) {
            1 => NoiseGenerator::Original,
            3 => NoiseGenerator::Perlin,
            _ => NoiseGenerator::Corrected,
        }
    }

    fn wave_sources(&mut self) -> Arc<WaveSources> {
        Arc::clone(self.waves.get_or_insert_with(|| Arc::new(WaveSources::new(self.settings.number_of_waves))))
    }
}

/// The object of an object pattern.
fn solid(object: &Arc<scene::Object>, functions: &Functions) -> Result<Geometry, Refusal> {
    compile_object_sharing(object, functions).map_err(|errors| match errors.into_iter().next() {
        Some(error) => Refusal { span: error.span, message: format!("in an object pattern: {}", error.message) },
        None => "this object cannot serve as a pattern".into(),
    })
}

fn octaves(t: &scene::Turbulence) -> Octaves {
    Octaves { count: t.octaves, lambda: t.lambda, omega: t.omega }
}

fn fractal(kind: &scene::PatternKind) -> Result<Fractal, Refusal> {
    use scene::PatternKind as S;
    let coloring = |c: &scene::FractalColoring| Coloring { kind: c.kind, factor: c.factor };
    let (set, exponent, iterations, exterior, interior) = match kind {
        S::Julia { c, iterations, exponent, exterior, interior } => {
            (FractalSet::Julia((*c).into()), *exponent, iterations, exterior, interior)
        }
        S::Mandel { iterations, exponent, exterior, interior } => {
            (FractalSet::Mandel, *exponent, iterations, exterior, interior)
        }
        S::Magnet { kind, c, iterations, exterior, interior } => {
            let model = *kind as u8;
            let set = match c {
                Some(c) => FractalSet::MagnetJulia(model, (*c).into()),
                None => FractalSet::MagnetMandel(model),
            };
            (set, 2, iterations, exterior, interior)
        }
        _ => return Err("this pattern is no fractal".into()),
    };
    let (exterior, interior) = (coloring(exterior), coloring(interior));
    Ok(Fractal { set, exponent, iterations: *iterations, exterior, interior })
}

fn slope(direction: &scene::SlopeDirection, range: [f64; 2], altitude: &Option<(DVec3, f64, f64)>) -> Slope {
    let (axis, length) = match direction {
        scene::SlopeDirection::Vector(v) => (SlopeAxis::Direction(v.normalize_or_zero()), v.length()),
        scene::SlopeDirection::PointAt(q) => (SlopeAxis::Towards(*q), 1.0),
    };
    let altitude = match altitude {
        None => None,
        Some((up, low, high)) => {
            let total = length + up.length();
            Some((length / total, up.normalize_or_zero(), [*low, *high]))
        }
    };
    Slope { axis, range, altitude }
}

pub(super) fn mapping_of(mapping: &scene::ImageMapping) -> crate::compiled::texture::Mapping {
    use crate::compiled::texture::MapType;
    crate::compiled::texture::Mapping {
        map_type: match mapping.map_type {
            scene::MapType::Planar => MapType::Planar,
            scene::MapType::Spherical => MapType::Spherical,
            scene::MapType::Cylindrical => MapType::Cylindrical,
            scene::MapType::Torus => MapType::Torus,
        },
        once: mapping.once,
        interpolate: mapping.interpolate,
        repeat: mapping.repeat,
        offset: mapping.offset,
        use_index: mapping.use_index == Some(true),
        use_alpha: mapping.use_alpha,
    }
}

fn is_identity(warp: &scene::Warp) -> bool {
    matches!(warp, scene::Warp::Transform(t) if t.is_identity())
}

fn warp(warp: &scene::Warp) -> Warp {
    use scene::Warp as S;
    let around = |shape, orientation: &DVec3, dist_exp: &f64| Warp::Around {
        shape,
        orientation: *orientation,
        dist_exp: *dist_exp,
    };
    match warp {
        S::Transform(t) => Warp::affine(t.inverse_affine()),
        S::Repeat { axis, width, offset, flip } => Warp::Repeat {
            axis: *axis,
            width: *width,
            offset: *offset,
            flip: [flip.x != 0.0, flip.y != 0.0, flip.z != 0.0],
        },
        S::Turbulence(t) => Warp::Turbulence { amount: t.amount, octaves: octaves(t) },
        S::BlackHole(hole) => black_hole(hole),
        S::Cylindrical { orientation, dist_exp } => around(Around::Cylinder, orientation, dist_exp),
        S::Spherical { orientation, dist_exp } => around(Around::Sphere, orientation, dist_exp),
        S::Toroidal { orientation, dist_exp, major_radius } => {
            around(Around::Torus(*major_radius), orientation, dist_exp)
        }
        S::Planar { orientation, distance } => Warp::Planar { orientation: *orientation, distance: *distance },
        S::Cubic => Warp::Cubic,
    }
}

/// Repeated holes keep inside their blocks, as POV-Ray makes them.
fn black_hole(hole: &scene::BlackHole) -> Warp {
    let (mut center, mut repeat) = (hole.center, hole.repeat);
    if let Some(repeat) = &mut repeat {
        let shift = hole.turbulence.unwrap_or(DVec3::ZERO);
        for i in 0..3 {
            if repeat[i] > 0.0 {
                center[i] = center[i].max(hole.radius);
                repeat[i] = repeat[i].max(center[i] + hole.radius + shift[i]);
            }
        }
    }
    // Other types than 0 do nothing.
    let radius = if hole.kind == 0 { hole.radius } else { 0.0 };
    Warp::BlackHole(Box::new(BlackHole {
        center,
        radius,
        strength: hole.strength,
        falloff: hole.falloff,
        inverse: hole.inverse,
        repeat,
        turbulence: hole.turbulence,
    }))
}

fn wave(wave: scene::Wave) -> Wave {
    match wave {
        scene::Wave::Ramp => Wave::Ramp,
        scene::Wave::Triangle => Wave::Triangle,
        scene::Wave::Sine => Wave::Sine,
        scene::Wave::Scallop => Wave::Scallop,
        scene::Wave::Cubic => Wave::Cubic,
        scene::Wave::Poly(exponent) => Wave::Poly(f64::from(exponent)),
    }
}
