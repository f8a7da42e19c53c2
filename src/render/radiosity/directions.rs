//! Where the rays of samples go.
//!
//! Source: radiosity facts, section 4 (measured).

use crate::math::DVec3;
use std::f64::consts::TAU;

/// Cosine of the angle from the y axis within which directions are taken as they are.
const UPRIGHT: f64 = 0.999;

/// Part along z above which a normal is turned about y instead.
const NEAR_Z: f64 = 0.9;

/// Cosine-weighted directions about the y axis that follow each other evenly: whatever is taken in turn is spread well.
#[derive(Debug)]
pub(in crate::render) struct Directions {
    n: u32,
    /// The first of them.
    known: Vec<DVec3>,
}

/// How many directions are worked out once; what scenes have beyond is worked out each time.
const MOST_KNOWN: u32 = 1 << 14;

impl Directions {
    /// So many, from the Halton sequence.
    pub(in crate::render) fn new(n: u32) -> Self {
        Self { n, known: (1..=n.min(MOST_KNOWN)).map(direction).collect() }
    }

    /// Number `i`, and so on from the start.
    pub(in crate::render) fn get(&self, i: u32) -> DVec3 {
        let i = i % self.n;
        self.known.get(i as usize).copied().unwrap_or_else(|| direction(i + 1))
    }

    /// How many there are before they start again.
    pub(in crate::render) fn len(&self) -> u32 {
        self.n
    }
}

fn direction(i: u32) -> DVec3 {
    let (square, turn) = (radical_inverse(i, 2), TAU * radical_inverse(i, 3));
    let radius = square.sqrt();
    DVec3::new(radius * turn.cos(), (1.0 - square).sqrt(), radius * turn.sin())
}

/// The digits of a number behind the point, in reverse order.
///
/// Source: Halton, "Algorithm 247: Radical-inverse quasi-random point sequence", Communications of the ACM 7 (12), 1964.
fn radical_inverse(mut i: u32, base: u32) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0 / f64::from(base));
    while i > 0 {
        value += f64::from(i % base) * digit;
        i /= base;
        digit /= f64::from(base);
    }
    value
}

/// Turns a direction about the y axis into one about a unit normal.
pub(in crate::render) fn about(normal: DVec3, direction: DVec3) -> DVec3 {
    if normal.y > UPRIGHT {
        return direction;
    }
    if normal.y < -UPRIGHT {
        return -direction;
    }
    let reference = if normal.z.abs() > NEAR_Z { DVec3::Y } else { DVec3::Z };
    let x = normal.cross(reference).normalize_or(DVec3::X);
    let z = x.cross(normal).normalize_or(DVec3::Z);
    direction.x * x + direction.y * normal + direction.z * z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_cosine_weighted() {
        let n = 1600;
        let directions = Directions::new(n);
        let mean: DVec3 = (0..n).map(|i| directions.get(i)).sum::<DVec3>() / f64::from(n);
        assert!((mean - DVec3::new(0.0, 2.0 / 3.0, 0.0)).length() < 2e-3, "{mean}");
        assert_eq!(directions.get(0), directions.get(n));
    }

    #[test]
    fn directions_turn_with_the_normal() {
        let up = DVec3::new(0.6, 0.8, 0.0);
        for normal in [DVec3::Y, -DVec3::Y, DVec3::X, DVec3::Z, -DVec3::Z, DVec3::new(1.0, 2.0, -3.0).normalize()] {
            let turned = about(normal, up);
            assert!((turned.dot(normal) - 0.8).abs() < 1e-12 && (turned.length() - 1.0).abs() < 1e-12, "{normal}");
        }
    }
}
