//! Hypercomplex numbers x + iy + jz + kw with i² = j² = -1, ij = k, k² = 1.
//!
//! They are pairs of complex numbers that multiply separately, so every complex function has
//! its hypercomplex form. Source: Davenport, A Commutative Hypercomplex Algebra with Associated
//! Function Theory, 1996.

use super::JuliaFunction as F;
use crate::math::{DVec2, DVec4};

/// A complex number: real part in x, imaginary part in y.
type Complex = DVec2;

/// A hypercomplex number, taken apart: real and imaginary parts of both complex numbers, which SIMD lanes hold.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    real: DVec2,
    imaginary: DVec2,
}

impl From<DVec4> for Pair {
    #[inline]
    fn from(q: DVec4) -> Self {
        Self { real: DVec2::new(q.x - q.w, q.x + q.w), imaginary: DVec2::new(q.y + q.z, q.y - q.z) }
    }
}

impl From<Pair> for DVec4 {
    #[inline]
    fn from(Pair { real: r, imaginary: i }: Pair) -> Self {
        Self::new(0.5 * (r.x + r.y), 0.5 * (i.x + i.y), 0.5 * (i.x - i.y), 0.5 * (r.y - r.x))
    }
}

impl From<[f64; 4]> for Pair {
    /// From both real parts and both imaginary parts.
    #[inline]
    fn from([r0, r1, i0, i1]: [f64; 4]) -> Self {
        Self { real: DVec2::new(r0, r1), imaginary: DVec2::new(i0, i1) }
    }
}

impl Pair {
    /// Both real parts and both imaginary parts.
    pub(super) fn to_array(self) -> [f64; 4] {
        [self.real.x, self.real.y, self.imaginary.x, self.imaginary.y]
    }

    #[inline]
    pub(super) fn times(self, o: Self) -> Self {
        Self {
            real: self.real * o.real - self.imaginary * o.imaginary,
            imaginary: self.real * o.imaginary + self.imaginary * o.real,
        }
    }

    #[inline]
    pub(super) fn plus(self, o: Self) -> Self {
        Self { real: self.real + o.real, imaginary: self.imaginary + o.imaginary }
    }

    /// The squared length of the four coordinates.
    #[inline]
    pub(super) fn norm(self) -> f64 {
        0.5 * (self.real * self.real + self.imaginary * self.imaginary).element_sum()
    }

    #[inline]
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self { real: self.real * factor, imaginary: self.imaginary * factor }
    }

    pub(super) fn negated(self) -> Self {
        Self { real: -self.real, imaginary: -self.imaginary }
    }

    /// The function of both parts.
    #[inline]
    pub(super) fn apply(self, function: F) -> Self {
        // By far the most frequent ones, and short.
        if matches!(function, F::Sqr | F::Cube) {
            return self.times(self);
        }
        let Self { real: r, imaginary: i } = self;
        let (a, b) = (complex(function, Complex::new(r.x, i.x)), complex(function, Complex::new(r.y, i.y)));
        Self { real: DVec2::new(a.x, b.x), imaginary: DVec2::new(a.y, b.y) }
    }
}

#[inline]
fn times(a: Complex, b: Complex) -> Complex {
    Complex::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

fn over(a: Complex, b: Complex) -> Complex {
    times(a, Complex::new(b.x, -b.y)) / b.length_squared()
}

/// The principal logarithm.
fn log(z: Complex) -> Complex {
    Complex::new(z.length().ln(), z.y.atan2(z.x))
}

/// The square root with a real part that is not negative.
fn root(z: Complex) -> Complex {
    Complex::from_angle(0.5 * z.y.atan2(z.x)) * z.length().sqrt()
}

fn exp(z: Complex) -> Complex {
    Complex::from_angle(z.y) * z.x.exp()
}

/// i z.
fn turned(z: Complex) -> Complex {
    Complex::new(-z.y, z.x)
}

/// 1 - z. The sign of a zero is POV-Ray's: on the cut it chooses the branch.
fn one_less(z: Complex) -> Complex {
    Complex::new(1.0 - z.x, -z.y)
}

/// POV-Ray's exponent below which a power is 0.
const LEAST_EXPONENT: f64 = -690.0;

/// A complex function, its branches as in POV-Ray.
fn complex(function: F, z: Complex) -> Complex {
    let (x, y) = (z.x, z.y);
    let square = times(z, z);
    match function {
        // POV-Ray's hypercomplex `cube` iterates the square, too.
        F::Sqr | F::Cube => square,
        F::Exp => exp(z),
        F::Ln => log(z),
        F::Sin => Complex::new(x.sin() * y.cosh(), x.cos() * y.sinh()),
        F::Cos => Complex::new(x.cos() * y.cosh(), -x.sin() * y.sinh()),
        F::Sinh => Complex::new(x.sinh() * y.cos(), x.cosh() * y.sin()),
        F::Cosh => Complex::new(x.cosh() * y.cos(), x.sinh() * y.sin()),
        F::Tan => Complex::new((2.0 * x).sin(), (2.0 * y).sinh()) / ((2.0 * x).cos() + (2.0 * y).cosh()),
        F::Tanh => Complex::new((2.0 * x).sinh(), (2.0 * y).sin()) / ((2.0 * x).cosh() + (2.0 * y).cos()),
        F::Asin => -turned(log(turned(z) + root(one_less(square)))),
        F::Acos => -turned(log(z + root(square - Complex::X))),
        F::Asinh => log(z + root(square + Complex::X)),
        F::Acosh => log(z + root(square - Complex::X)),
        F::Atanh => atanh(z),
        F::Atan => atan(z),
        F::Reciprocal => over(Complex::X, z),
        F::Pwr(a, b) => power(z, Complex::new(a, b)),
    }
}

fn atanh(z: Complex) -> Complex {
    if z.x == 0.0 { Complex::new(0.0, z.y.atan()) } else { 0.5 * log(over(Complex::X + z, one_less(z))) }
}

fn atan(z: Complex) -> Complex {
    if z.y == 0.0 {
        return Complex::new(z.x.atan(), 0.0);
    }
    if z.x == 0.0 {
        return turned(atanh(Complex::new(z.y, 0.0)));
    }
    turned(log(over(Complex::X - turned(z), Complex::X + turned(z)))) * 0.5
}

fn power(z: Complex, exponent: Complex) -> Complex {
    if z == Complex::ZERO {
        return Complex::ZERO;
    }
    let e = times(exponent, log(z));
    if e.x < LEAST_EXPONENT { Complex::ZERO } else { exp(e) }
}
