//! Mandelbrot, Julia and magnet sets in the plane of x and y.
//!
//! Source: section 7 of the pattern facts (measured).

use crate::math::{DVec2, DVec3};

/// Which set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FractalSet {
    /// z^n + c from z = c, the point.
    Mandel,
    /// z^n + c from the point.
    Julia(DVec2),
    /// Magnetic model 1 or 2 from 0, with c the point.
    MagnetMandel(u8),
    /// Magnetic model 1 or 2 from the point.
    MagnetJulia(u8, DVec2),
}

/// How a point is coloured: the kind of the language, and its factor.
#[derive(Clone, Copy, Debug)]
pub struct Coloring {
    /// Number after `exterior` or `interior`.
    pub kind: u32,
    /// Its factor.
    pub factor: f64,
}

/// A fractal pattern.
#[derive(Clone, Debug)]
pub struct Fractal {
    /// Which set.
    pub set: FractalSet,
    /// Power of the iteration.
    pub exponent: u32,
    /// Most iterations.
    pub iterations: u32,
    /// Where the iteration escapes.
    pub exterior: Coloring,
    /// Where it does not.
    pub interior: Coloring,
}

fn mul(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

fn div(a: DVec2, b: DVec2) -> DVec2 {
    mul(a, DVec2::new(b.x, -b.y)) / b.length_squared()
}

fn power(z: DVec2, n: u32) -> DVec2 {
    (1..n).fold(z, |p, _| mul(p, z))
}

/// One step of the magnetic models.
fn magnet(model: u8, z: DVec2, c: DVec2) -> DVec2 {
    let one = DVec2::X;
    let (c1, c2) = (c - one, c - 2.0 * one);
    let quotient = if model == 1 {
        div(mul(z, z) + c1, 2.0 * z + c2)
    } else {
        let (z2, c12) = (mul(z, z), mul(c1, c2));
        div(mul(z2, z) + 3.0 * mul(c1, z) + c12, 3.0 * z2 + 3.0 * mul(c2, z) + c12 + one)
    };
    mul(quotient, quotient)
}

impl Fractal {
    /// The value at a point.
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let point = DVec2::new(p.x, p.y);
        let (mut z, c) = match self.set {
            FractalSet::Mandel => (point, point),
            FractalSet::Julia(c) | FractalSet::MagnetJulia(_, c) => (point, c),
            FractalSet::MagnetMandel(_) => (DVec2::ZERO, point),
        };
        // POV-Ray's stand-in for the start of the sets that start at 0.
        let mut smallest = if let FractalSet::MagnetMandel(_) = self.set { 10_000.0 } else { z.length_squared() };
        for k in 0..self.iterations {
            let escaped;
            match self.set {
                FractalSet::MagnetMandel(model) | FractalSet::MagnetJulia(model, _) => {
                    z = magnet(model, z, c);
                    // Bounds of the two attractors, infinity and 1.
                    escaped = z.length_squared() > 10_000.0 || (z - DVec2::X).length_squared() < 1e-4;
                }
                _ => {
                    z = power(z, self.exponent) + c;
                    escaped = z.length_squared() > 4.0;
                }
            }
            smallest = smallest.min(z.length_squared());
            if escaped {
                return self.outside(z, k);
            }
        }
        self.inside(z, smallest)
    }

    fn outside(&self, z: DVec2, k: u32) -> f64 {
        let Coloring { kind, factor } = self.exterior;
        let k = f64::from(k);
        match kind {
            1 => k / f64::from(self.iterations),
            6 => z.length() * factor,
            7 if factor >= 1.0 => (k % factor.floor()) / factor,
            8 => (k % (1.0 + factor).floor()) / factor,
            _ => self.common(kind, factor, z),
        }
    }

    fn inside(&self, z: DVec2, smallest: f64) -> f64 {
        let Coloring { kind, factor } = self.interior;
        match kind {
            1 => smallest.sqrt() * factor,
            6 => z.x * z.x + z.y * z.y * factor, // without parentheses, as in POV-Ray
            _ => self.common(kind, factor, z),
        }
    }

    fn common(&self, kind: u32, factor: f64, z: DVec2) -> f64 {
        match kind {
            0 => factor,
            2 => z.x * factor,
            3 => z.y * factor,
            4 => z.x * z.x * factor,
            5 => z.y * z.y * factor,
            _ => 0.0,
        }
    }
}
