//! Section 15 of the pattern facts: every pattern at six points.

use super::*;

/// The last digits of the largest sums of sines and products; POV-Ray's own sums are no better.
const TOLERANCE: f64 = 1e-12;
/// Two units in the last place of a single-precision value below 1: colours are that.
const SINGLE: f64 = 1.2e-7;

#[test]
fn patterns_have_povrays_values() {
    let rows = include_str!("values.txt").lines().filter(|line| !line.starts_with('#'));
    for row in rows {
        let (pattern, expected) = row.split_once(" | ").expect("a pattern and its values");
        let tolerance = if pattern.starts_with("pigment_pattern") { SINGLE } else { TOLERANCE };
        let found = values("#version 3.7;", pattern, &POINTS);
        let expected: Vec<f64> = expected.split(' ').map(|value| value.parse().expect("a value")).collect();
        check(pattern, &found, &expected, tolerance);
    }
}

#[test]
fn lists_have_povrays_indices() {
    for (pattern, items, expected) in [
        ("hexagon", 3, [2, 2, 0, 0, 2, 0]),
        ("square", 4, [0, 0, 0, 1, 3, 2]),
        ("triangular", 6, [1, 5, 1, 3, 3, 2]),
        ("cubic", 6, [5, 1, 2, 2, 1, 2]),
    ] {
        let list: String = (0..items).map(|i| format!("pigment{{rgb {i}}} ")).collect();
        for (point, index) in POINTS.into_iter().zip(expected) {
            let found = color(&format!("{pattern} {list}"), point)[0];
            check(&format!("{pattern} at {point:?}"), &[found], &[f64::from(index)], 0.0);
        }
    }
}

/// Tilings and pavements at a point that lies on no edge, with six digits.
#[test]
fn tilings_are_found_by_name() {
    for (pattern, expected) in [
        ("tiling 2", 0.39282),
        ("tiling 17", 0.436047),
        ("tiling 24", 0.8),
        ("tiling 25", 0.333334),
        ("tiling 26", 0.309327),
        ("tiling 27", 0.663681),
        ("pavement", 0.978461),
        ("pavement number_of_sides 4 number_of_tiles 4 pattern 3", 0.6),
        ("pavement number_of_sides 3 number_of_tiles 4 pattern 2 exterior 1 form 2", 0.115877),
        ("pavement number_of_sides 6 number_of_tiles 5 pattern 22 interior 1 form 1", 1.0),
    ] {
        let found = color(&format!("{pattern} color_map{{[0 rgb 0][1 rgb 1]}}"), POINTS[0]);
        check(pattern, &found[..1], &[expected], 1e-6);
    }
}
