//! The colours that a pattern shows where a pigment names none.
//!
//! Source: section 11 of the pattern facts (measured).

use super::{MapEntry, PatternKind as K};
use crate::math::{Color, Rgb};

const BLACK: [f32; 3] = [0.0, 0.0, 0.0];
const WHITE: [f32; 3] = [1.0, 1.0, 1.0];
const RED: [f32; 3] = [1.0, 0.0, 0.0];
const GREEN: [f32; 3] = [0.0, 1.0, 0.0];
const BLUE: [f32; 3] = [0.0, 0.0, 1.0];
const YELLOW: [f32; 3] = [1.0, 1.0, 0.0];
const CYAN: [f32; 3] = [0.0, 1.0, 1.0];
const MAGENTA: [f32; 3] = [1.0, 0.0, 1.0];

/// The entries of a pattern's own map; those of a block pattern stand at 0, 1, 2 and so on.
pub fn default_colors(kind: &K) -> Vec<MapEntry<Color>> {
    match kind {
        K::Checker | K::Object(_) => list(&[BLUE, GREEN]),
        K::Hexagon => list(&[BLUE, GREEN, RED]),
        K::Square => list(&[RED, GREEN, BLUE, YELLOW]),
        K::Triangular | K::Cubic => list(&[RED, GREEN, BLUE, YELLOW, CYAN, MAGENTA]),
        K::Brick { .. } => list(&[[0.5, 0.5, 0.5], [0.6, 0.15, 0.15]]),
        K::Bozo => map(&[(0.4, WHITE), (0.4, GREEN), (0.6, GREEN), (0.6, BLUE), (0.8, BLUE), (0.8, RED)]),
        K::Agate { .. } => map(&[
            (0.0, WHITE),
            (0.5, [0.95, 0.75, 0.5]),
            (0.5, [0.9, 0.7, 0.5]),
            (0.6, [0.9, 0.7, 0.4]),
            (0.6, [1.0, 0.7, 0.4]),
            (1.0, [0.6, 0.3, 0.0]),
        ]),
        K::Marble => map(&[(0.0, [0.9, 0.8, 0.8]), (0.9, [0.9, 0.08, 0.08]), (0.9, BLACK)]),
        K::Wood => map(&[(0.6, [0.666, 0.312, 0.2]), (0.6, [0.4, 0.1333, 0.066])]),
        K::Mandel { exponent: 2, .. } => {
            map(&[(0.001, BLACK), (0.001, CYAN), (0.012, YELLOW), (0.015, MAGENTA), (0.1, CYAN)])
        }
        K::Radial => map(&[(0.0, CYAN), (0.333, YELLOW), (0.666, MAGENTA), (1.0, CYAN)]),
        _ => map(&[(0.0, BLACK), (1.0, WHITE)]),
    }
}

fn list(colors: &[[f32; 3]]) -> Vec<MapEntry<Color>> {
    colors.iter().enumerate().map(|(i, color)| MapEntry { value: i as f32, item: opaque(*color) }).collect()
}

fn map(entries: &[(f32, [f32; 3])]) -> Vec<MapEntry<Color>> {
    entries.iter().map(|(value, color)| MapEntry { value: *value, item: opaque(*color) }).collect()
}

fn opaque(rgb: [f32; 3]) -> Color {
    Color { rgb: Rgb::from(rgb), ..Color::BLACK }
}
