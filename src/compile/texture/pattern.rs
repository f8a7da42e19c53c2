//! Patterns: warps in the order in which a point passes them, formulas with folded constants.

use super::{Refusal, TextureCompiler};
use crate::compiled::texture::{Pattern, PatternKind, Warp, Wave};
use crate::math::DVec3;
use crate::scene;
use std::sync::Arc;

impl TextureCompiler<'_> {
    /// Compiles a pattern with its warps.
    ///
    /// # Errors
    /// As [`texture`](Self::texture).
    pub fn pattern(&mut self, pattern: &scene::Pattern) -> Result<Pattern, Refusal> {
        let warps = pattern.warps.iter().rev().filter(|w| !is_identity(w));
        let mut warps = warps.map(warp).collect::<Result<Vec<_>, _>>()?;
        let kind = self.kind(pattern)?;
        if let Some(turbulence) = &pattern.turbulence
            && turbulence.amount != DVec3::ZERO
        {
            warps.push(warp(&scene::Warp::Turbulence(*turbulence))?);
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
        Ok(match &pattern.kind {
            S::None | S::Average => PatternKind::None,
            S::Boxed => PatternKind::Boxed,
            // POV-Ray takes twice its border offset off the mortar.
            S::Brick { size, mortar } => {
                PatternKind::Brick { size: *size, mortar: f64::from((f64::from(*mortar) - 2e-10) as f32) }
            }
            S::Checker => PatternKind::Checker,
            S::Cubic => PatternKind::Cubic,
            S::Cylindrical => PatternKind::Cylindrical,
            S::Function(function) => PatternKind::Function(Arc::clone(function)),
            S::Gradient(direction) => PatternKind::Gradient(direction.normalize()),
            S::Hexagon => PatternKind::Hexagon,
            S::Image(picture) => PatternKind::Image(self.value_picture(&picture.0)?, mapping_of(&picture.1)),
            S::Leopard => PatternKind::Leopard,
            S::Material(picture) => PatternKind::Material(self.value_picture(&picture.0)?, mapping_of(&picture.1), 0),
            S::Onion => PatternKind::Onion,
            S::Pigment(pigment) => PatternKind::Pigment(Arc::new(self.pigment(pigment)?)),
            S::Planar => PatternKind::Planar,
            S::Radial => PatternKind::Radial,
            S::Spherical => PatternKind::Spherical,
            S::Square => PatternKind::Square,
            S::Triangular => PatternKind::Triangular,
            other => return Err(format!("the pattern `{}` is not supported yet", name(other))),
        })
    }
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

fn warp(warp: &scene::Warp) -> Result<Warp, Refusal> {
    Ok(match warp {
        scene::Warp::Transform(t) => Warp::Affine(t.inverse()),
        scene::Warp::Repeat { axis, width, offset, flip } => Warp::Repeat {
            axis: *axis,
            width: *width,
            offset: *offset,
            flip: [flip.x != 0.0, flip.y != 0.0, flip.z != 0.0],
        },
        other => {
            let name = match other {
                scene::Warp::Turbulence(_) => "turbulence",
                scene::Warp::BlackHole(_) => "black_hole",
                scene::Warp::Cylindrical { .. } => "cylindrical",
                scene::Warp::Spherical { .. } => "spherical",
                scene::Warp::Toroidal { .. } => "toroidal",
                scene::Warp::Planar { .. } => "planar",
                scene::Warp::Cubic => "cubic",
                _ => "this kind of",
            };
            return Err(format!("`{name}` as a warp is not supported yet"));
        }
    })
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

/// The first word of the kind's debug text, in lower case: its keyword or nearly so.
fn name(kind: &scene::PatternKind) -> String {
    let text = format!("{kind:?}");
    let word = text.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
    word.to_lowercase()
}
