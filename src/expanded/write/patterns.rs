//! Patterns with their modifiers and warps.

use super::number::{double, float, vector, vector2};
use super::pictures::file_name;
use super::writer::Writer;
use crate::math::{DVec2, DVec3};
use crate::scene::{BlackHole, FractalColoring, Pattern, PatternKind, SlopeDirection, Turbulence, Warp, Wave};
use std::path::Path;

impl Writer<'_> {
    /// A pattern with all that changes it; `items` writes what a block pattern chooses from, behind its word.
    pub(super) fn pattern(&mut self, pattern: &Pattern, items: impl FnOnce(&mut Self)) {
        self.pattern_kind(&pattern.kind, items);
        self.pattern_modifiers(pattern);
    }

    /// The word, its parameters and items.
    fn pattern_kind(&mut self, kind: &PatternKind, items: impl FnOnce(&mut Self)) {
        match kind {
            PatternKind::Object(object) => {
                self.open("object");
                self.object(object);
                items(self);
                return self.close();
            }
            PatternKind::Pigment(pigment) => {
                self.open("pigment_pattern");
                self.pigment_content(pigment);
                self.close();
            }
            PatternKind::Function(function) => self.plain_function(function, &["x", "y", "z"]),
            PatternKind::Image(image) => self.image_block("image_pattern", &image.0, &image.1),
            PatternKind::None | PatternKind::Material(_) | PatternKind::Uv => {}
            _ => self.line(plain_kind(self.style.file_name, kind)),
        }
        items(self);
    }

    fn pattern_modifiers(&mut self, pattern: &Pattern) {
        let Pattern { kind, wave, frequency, phase, noise_generator, turbulence, warps } = pattern;
        if let Some(parameters) = block_parameters(kind) {
            self.line(parameters);
        }
        let fresh = Pattern::new(kind.clone());
        let mut words = Vec::new();
        if *wave != fresh.wave {
            words.push(wave_word(*wave));
        }
        if frequency.to_bits() != fresh.frequency.to_bits() {
            words.push(format!("frequency {}", float(*frequency)));
        }
        if phase.to_bits() != 0 {
            words.push(format!("phase {}", float(*phase)));
        }
        if let Some(generator) = noise_generator {
            words.push(format!("noise_generator {generator}"));
        }
        if let Some(turbulence) = turbulence {
            words.push(turbulence_words(turbulence));
        }
        if !words.is_empty() {
            self.line(words.join(" "));
        }
        for warp in warps {
            self.warp(warp);
        }
    }

    fn warp(&mut self, warp: &Warp) {
        let text = match warp {
            Warp::Transform(transform) => return self.transform(transform),
            Warp::Turbulence(turbulence) => turbulence_words(turbulence),
            Warp::Repeat { axis, width, offset, flip } => {
                let step = ["<W, 0, 0>", "<0, W, 0>", "<0, 0, W>"][*axis].replace('W', &float(*width));
                let mut text = format!("repeat {step}");
                push_vector_unless(&mut text, "offset", *offset, DVec3::ZERO);
                push_vector_unless(&mut text, "flip", *flip, DVec3::ZERO);
                text
            }
            Warp::BlackHole(hole) => black_hole(hole),
            Warp::Cylindrical { orientation, dist_exp } => {
                format!("cylindrical orientation {} dist_exp {}", vector(*orientation), double(*dist_exp))
            }
            Warp::Spherical { orientation, dist_exp } => {
                format!("spherical orientation {} dist_exp {}", vector(*orientation), double(*dist_exp))
            }
            Warp::Toroidal { orientation, dist_exp, major_radius } => {
                let (orientation, dist_exp) = (vector(*orientation), double(*dist_exp));
                let radius = double(*major_radius);
                format!("toroidal orientation {orientation} dist_exp {dist_exp} major_radius {radius}")
            }
            Warp::Planar { orientation, distance } => format!("planar {}, {}", vector(*orientation), double(*distance)),
            Warp::Cubic => "cubic".to_owned(),
        };
        self.line(format_args!("warp {{ {text} }}"));
    }
}

/// `on` or `off`.
pub(super) fn switch(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

/// `turbulence` with all that belongs to it.
pub(super) fn turbulence_words(turbulence: &Turbulence) -> String {
    let Turbulence { amount, octaves, omega, lambda } = *turbulence;
    let (omega, lambda) = (float(omega), float(lambda));
    format!("turbulence {} octaves {octaves} omega {omega} lambda {lambda}", vector(amount))
}

fn push_vector_unless(text: &mut String, word: &str, value: DVec3, default: DVec3) {
    if value != default {
        *text += &format!(" {word} {}", vector(value));
    }
}

fn black_hole(hole: &BlackHole) -> String {
    let BlackHole { center, radius, strength, falloff, inverse, kind, repeat, turbulence } = *hole;
    let mut text = format!("black_hole {}, {}", vector(center), double(radius));
    text += &format!(" strength {} falloff {}", double(strength), double(falloff));
    if inverse {
        text += " inverse";
    }
    if kind != 0 {
        text += &format!(" type {kind}");
    }
    if let Some(repeat) = repeat {
        text += &format!(" repeat {}", vector(repeat));
    }
    if let Some(turbulence) = turbulence {
        text += &format!(" turbulence {}", vector(turbulence));
    }
    text
}

fn wave_word(wave: Wave) -> String {
    match wave {
        Wave::Ramp => "ramp_wave".into(),
        Wave::Triangle => "triangle_wave".into(),
        Wave::Sine => "sine_wave".into(),
        Wave::Scallop => "scallop_wave".into(),
        Wave::Cubic => "cubic_wave".into(),
        Wave::Poly(exponent) => format!("poly_wave {}", float(exponent)),
    }
}

/// Parameters of a block pattern stand behind its items.
fn block_parameters(kind: &PatternKind) -> Option<String> {
    match kind {
        PatternKind::Brick { size, mortar } => Some(format!("brick_size {} mortar {}", vector(*size), float(*mortar))),
        _ => None,
    }
}

/// The word and the parameters of a pattern without braces.
fn plain_kind(name: &dyn Fn(&Path) -> String, kind: &PatternKind) -> String {
    use PatternKind as K;
    match kind {
        K::Agate { turbulence } => format!("agate agate_turb {}", float(*turbulence)),
        K::Crackle { form, metric, offset, solid } => {
            let (metric, offset) = (double(*metric), double(*offset));
            let solid = if *solid { " solid" } else { "" };
            format!("crackle form {} metric {metric} offset {offset}{solid}", vector(*form))
        }
        K::DensityFile { span: _, path, interpolation, data: _ } => {
            format!("density_file df3 {} interpolate {interpolation}", file_name(&name(path)))
        }
        K::Gradient(direction) => format!("gradient {}", vector(*direction)),
        K::Julia { c, iterations, exponent, exterior, interior } => {
            let c = vector2(DVec2::from(*c));
            format!("julia {c}, {iterations} exponent {exponent} {}", colorings(exterior, interior))
        }
        K::Magnet { kind, c: None, iterations, exterior, interior } => {
            format!("magnet {kind} mandel {iterations} {}", colorings(exterior, interior))
        }
        K::Magnet { kind, c: Some(c), iterations, exterior, interior } => {
            let c = vector2(DVec2::from(*c));
            format!("magnet {kind} julia {c}, {iterations} {}", colorings(exterior, interior))
        }
        K::Mandel { iterations, exponent, exterior, interior } => {
            format!("mandel {iterations} exponent {exponent} {}", colorings(exterior, interior))
        }
        K::Pavement { span: _, sides, tiles, pattern, interior, exterior, form } => format!(
            "pavement number_of_sides {sides} number_of_tiles {tiles} pattern {pattern} interior {interior} \
             exterior {exterior} form {form}"
        ),
        K::Quilted { control0, control1 } => {
            format!("quilted control0 {} control1 {}", float(*control0), float(*control1))
        }
        K::Slope { direction, low, high, altitude } => slope(direction, [*low, *high], altitude),
        K::Spiral1(arms) => format!("spiral1 {arms}"),
        K::Spiral2(arms) => format!("spiral2 {arms}"),
        K::Tiling(number) => format!("tiling {number}"),
        _ => word(kind).into(),
    }
}

/// The word of a pattern that takes no parameters; those of others stand beside them.
fn word(kind: &PatternKind) -> &'static str {
    use PatternKind as K;
    match kind {
        K::Aoi => "aoi",
        K::Average => "average",
        K::Boxed => "boxed",
        K::Bozo => "bozo",
        K::Spotted => "spotted",
        K::Bumps => "bumps",
        K::Brick { .. } => "brick",
        K::Cells => "cells",
        K::Checker => "checker",
        K::Cubic => "cubic",
        K::Cylindrical => "cylindrical",
        K::Dents => "dents",
        K::Granite => "granite",
        K::Hexagon => "hexagon",
        K::Leopard => "leopard",
        K::Marble => "marble",
        K::Onion => "onion",
        K::Planar => "planar",
        K::Radial => "radial",
        K::Ripples => "ripples",
        K::Spherical => "spherical",
        K::Square => "square",
        K::Triangular => "triangular",
        K::Waves => "waves",
        K::Wood => "wood",
        K::Wrinkles => "wrinkles",
        K::None | K::Uv | K::Agate { .. } | K::Crackle { .. } | K::DensityFile { .. } | K::Function(_) => "",
        K::Gradient(_) | K::Image(_) | K::Julia { .. } | K::Magnet { .. } | K::Mandel { .. } | K::Material(_) => "",
        K::Object(_) | K::Pavement { .. } | K::Pigment(_) | K::Quilted { .. } | K::Slope { .. } => "",
        K::Spiral1(_) | K::Spiral2(_) | K::Tiling(_) => "",
    }
}

fn colorings(exterior: &FractalColoring, interior: &FractalColoring) -> String {
    let one = |c: &FractalColoring| format!("{}, {}", c.kind, double(c.factor));
    format!("exterior {} interior {}", one(exterior), one(interior))
}

fn slope(direction: &SlopeDirection, range: [f64; 2], altitude: &Option<(DVec3, f64, f64)>) -> String {
    let pair = |[low, high]: [f64; 2]| match [low, high] {
        [0.0, 0.0] => String::new(),
        _ => format!(", {}, {}", double(low), double(high)),
    };
    let mut text = match direction {
        SlopeDirection::Vector(direction) => format!("slope {{ {}", vector(*direction)),
        SlopeDirection::PointAt(point) => format!("slope {{ point_at {}", vector(*point)),
    };
    text += &pair(range);
    if let Some((axis, low, high)) = altitude {
        text += &format!(" altitude {}{}", vector(*axis), pair([*low, *high]));
    }
    text + " }"
}
