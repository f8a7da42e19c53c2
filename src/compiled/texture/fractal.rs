//! Mandelbrot, Julia and magnet sets in the plane of x and y.
//!
//! Source: section 7 of the pattern facts (measured).

use crate::math::DVec2;

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

fn square(z: DVec2) -> DVec2 {
    DVec2::new(z.x * z.x - z.y * z.y, (z.x + z.x) * z.y)
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

/// Whether a point is out of the disc that holds the Mandelbrot and Julia sets.
fn leaves_disc(z: DVec2) -> bool {
    z.length_squared() > 4.0
}

/// Whether a point is drawn to one of the attractors of the magnetic models, infinity and 1.
fn is_attracted(z: DVec2) -> bool {
    /// POV-Ray's thresholds, squared distances both.
    const POV_FAR: f64 = 10_000.0;
    const POV_NEAR: f64 = 1e-4;
    z.length_squared() > POV_FAR || (z - DVec2::X).length_squared() < POV_NEAR
}

/// How an orbit ended.
struct Orbit {
    /// The last point.
    end: DVec2,
    /// The step that escaped.
    escape: Option<u32>,
    /// Smallest squared length on the way.
    smallest: f64,
}

impl Orbit {
    /// Follows a point for `n` steps or until it escapes; `smallest` counts as its own squared length.
    ///
    /// Points that stay are mostly drawn into a cycle, and by the finite number of digits soon repeat to the last
    /// of them: of all steps that remain only a part of the cycle has to be gone.
    /// Source: Brent, An Improved Monte Carlo Factorization Algorithm, 1980, section 2.
    #[inline]
    fn follow(
        mut z: DVec2,
        mut smallest: f64,
        n: u32,
        step: impl Fn(DVec2) -> DVec2,
        escapes: impl Fn(DVec2) -> bool,
    ) -> Self {
        /// Steps from one look for a cycle to the next.
        const STRIDE: u32 = 8;
        let (mut mark, mut marked_at, mut k) = (z, 0, 0);
        while k < n {
            for _ in 0..STRIDE.min(n - k) {
                z = step(z);
                let norm = z.length_squared();
                smallest = if norm < smallest { norm } else { smallest };
                if escapes(z) {
                    return Self { end: z, escape: Some(k), smallest };
                }
                k += 1;
            }
            if z == mark {
                let end = (0..(n - k) % (k - marked_at)).fold(z, |z, _| step(z));
                return Self { end, escape: None, smallest };
            }
            if k >= 2 * marked_at {
                (mark, marked_at) = (z, k);
            }
        }
        Self { end: z, escape: None, smallest }
    }
}

impl Fractal {
    /// The value at (x, y) of every plane.
    pub(super) fn value(&self, x: f64, y: f64) -> f64 {
        let p = DVec2::new(x, y);
        if self.interior.kind == 0 && self.is_deep_inside(p) {
            return self.interior.factor;
        }
        let Orbit { end, escape, smallest } = self.orbit(p);
        match escape {
            Some(k) => self.outside(end, k),
            None => self.inside(end, smallest),
        }
    }

    /// Whether a point lies in the cardioid or the largest disc of the Mandelbrot set, whose orbits are known to stay.
    ///
    /// Source: Douady and Hubbard, Etude dynamique des polynomes complexes, 1984.
    fn is_deep_inside(&self, p: DVec2) -> bool {
        /// Nearer to the rim orbits are followed: deeper inside every step shrinks errors by a millionth at least, so
        /// that roundings of 1e-16 never add up to more than 1e-10 and lead nothing out.
        const RIM: f64 = 1e-6;
        if (self.set, self.exponent) != (FractalSet::Mandel, 2) {
            return false;
        }
        let (x, y2) = (p.x - 0.25, p.y * p.y);
        let q = x * x + y2;
        let in_cardioid = q * (q + x) - 0.25 * y2 < -RIM;
        let in_disc = (p.x + 1.0) * (p.x + 1.0) + y2 - 0.0625 < -RIM;
        in_cardioid | in_disc
    }

    fn orbit(&self, p: DVec2) -> Orbit {
        /// POV-Ray's stand-in for the start of the sets that start at 0.
        const FAR: f64 = 10_000.0;
        let (n, norm) = (self.iterations, p.length_squared());
        match (self.set, self.exponent) {
            (FractalSet::Mandel, 2) => Orbit::follow(p, norm, n, |z| square(z) + p, leaves_disc),
            (FractalSet::Mandel, e) => Orbit::follow(p, norm, n, |z| power(z, e) + p, leaves_disc),
            (FractalSet::Julia(c), 2) => Orbit::follow(p, norm, n, |z| square(z) + c, leaves_disc),
            (FractalSet::Julia(c), e) => Orbit::follow(p, norm, n, |z| power(z, e) + c, leaves_disc),
            (FractalSet::MagnetMandel(model), _) => {
                Orbit::follow(DVec2::ZERO, FAR, n, |z| magnet(model, z, p), is_attracted)
            }
            (FractalSet::MagnetJulia(model, c), _) => Orbit::follow(p, norm, n, |z| magnet(model, z, c), is_attracted),
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_orbit_leads_out_of_the_inside() {
        let plain = Coloring { kind: 0, factor: 0.5 };
        let set = Fractal { set: FractalSet::Mandel, exponent: 2, iterations: 2000, exterior: plain, interior: plain };
        let grid = (0..=250)
            .flat_map(|i| (-125..=125).map(move |j| DVec2::new(0.01 * f64::from(i) - 2.0, 0.01 * f64::from(j))));
        let inside: Vec<_> = grid.filter(|p| set.is_deep_inside(*p)).collect();
        // The areas of the cardioid and of the disc, 3/8 pi and pi/16, in squares of the grid.
        assert!((inside.len() as f64 - 1.374e4).abs() < 100.0, "{}", inside.len());
        assert!(inside.iter().all(|p| set.orbit(*p).escape.is_none()));
    }
}
