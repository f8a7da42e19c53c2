//! Real roots of polynomials in one variable: the one place for them.
//!
//! Quadratics are solved in closed form without cancellation. Everything higher is written in
//! the Bernstein basis of the interval that matters; Descartes' rule isolates roots by
//! subdivision, and a bracketed Newton iteration polishes each. That finds every root in the
//! interval whatever the degree, with errors proportional to the coefficients' own.
//!
//! ```
//! use whitted::math::{quadratic_roots, roots_in};
//! assert_eq!(quadratic_roots(1.0, -3.0, 2.0), Some([1.0, 2.0]));
//! let roots = roots_in(&[-6.0, 11.0, -6.0, 1.0], 0.0, 2.5); // (t - 1)(t - 2)(t - 3)
//! assert!(roots.len() == 2 && (roots[0] - 1.0).abs() < 1e-14 && (roots[1] - 2.0).abs() < 1e-14);
//! ```

use super::gamma;
use smallvec::SmallVec;

/// Highest degree: POV-Ray's `poly` ends at 35.
pub const MAX_DEGREE: usize = 35;

/// Roots in rising order; a double root counts twice.
pub type Roots = SmallVec<[f64; 8]>;

/// x * y and its rounding error, exactly. Source: Dekker 1971, with Veltkamp's splitting.
fn two_product(x: f64, y: f64) -> (f64, f64) {
    const SPLIT: f64 = 134_217_729.0; // 2^27 + 1
    let halves = |v: f64| {
        let c = SPLIT * v;
        let high = c - (c - v);
        (high, v - high)
    };
    let product = x * y;
    let ((xh, xl), (yh, yl)) = (halves(x), halves(y));
    (product, ((xh * yh - product) + xh * yl + xl * yh) + xl * yl)
}

/// b² - ac, to nearly full precision also where the two nearly cancel.
///
/// Source: Kahan, On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic, 2004.
#[inline]
pub fn discriminant(a: f64, b: f64, c: f64) -> f64 {
    let (p, q) = (b * b, a * c);
    let d = p - q;
    // Without cancellation the plain difference is as good.
    if 3.0 * d.abs() >= p + q.abs() {
        return d;
    }
    let (p, dp) = two_product(b, b);
    let (q, dq) = two_product(a, c);
    let exact = (p - q) + (dp - dq);
    if exact.is_finite() { exact } else { d }
}

/// Both roots of a t² + b t + c in rising order; a lone root of the linear case comes twice.
///
/// `None` without real roots, or when `a` and `b` vanish.
/// Source: Press et al., Numerical Recipes, section 5.6.
#[inline]
pub fn quadratic_roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let half = 0.5 * b;
    let d = discriminant(a, half, c);
    if d < 0.0 || d.is_nan() {
        return None;
    }
    let q = -(half + d.sqrt().copysign(half));
    let (t0, t1) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    match (a != 0.0 && t0.is_finite(), t1.is_finite()) {
        (true, true) => Some(if t0 <= t1 { [t0, t1] } else { [t1, t0] }),
        // The far root left for infinity: what remains is the linear case.
        (false, true) if q != 0.0 => Some([t1, t1]),
        _ => None,
    }
}

/// Value and slope at `t`; coefficients rise with the power.
#[inline]
fn horner(coefficients: &[f64], t: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * t + c, slope * t + value))
}

/// Bernstein coefficients of a polynomial over one interval, in units of the original parameter, with room for `N`.
#[derive(Clone, Copy)]
struct Piece<const N: usize> {
    b: [f64; N],
    low: f64,
    high: f64,
}

impl<const N: usize> Piece<N> {
    /// How often the coefficients change sign: as many roots inside, or fewer by an even number.
    #[inline(always)]
    fn sign_changes(&self, n: usize) -> u32 {
        let (mut negative, mut zero) = (0_u64, 0_u64);
        for (i, b) in self.b[..n + 1].iter().enumerate() {
            negative |= u64::from(*b < 0.0) << i;
            zero |= u64::from(*b == 0.0) << i;
        }
        if zero == 0 {
            return ((negative ^ (negative >> 1)) & ((1 << n) - 1)).count_ones();
        }
        let signs = (0..=n).filter(|i| zero >> i & 1 == 0).map(|i| negative >> i & 1);
        signs
            .fold((0, None), |(changes, last), sign| (changes + u32::from(last.is_some_and(|s| s != sign)), Some(sign)))
            .0
    }

    /// A bound of the second derivative: that of a polynomial whose Bernstein coefficients are second differences.
    #[inline(always)]
    fn curvature(&self, n: usize) -> f64 {
        let width = self.high - self.low;
        let bend = |i: usize| (self.b[i] - 2.0 * self.b[i + 1] + self.b[i + 2]).abs();
        (0..n - 1).map(bend).fold(0.0, f64::max) * (n * (n - 1)) as f64 / (width * width)
    }

    /// Halves the interval. Source: de Casteljau's algorithm.
    #[inline(always)]
    fn split(&self, n: usize) -> (Self, Self) {
        let middle = 0.5 * self.low + 0.5 * self.high;
        let mut left = Self { high: middle, ..*self };
        let mut right = Self { low: middle, ..*self };
        for i in 0..n + 1 {
            left.b[i] = right.b[0];
            for j in 0..n - i {
                right.b[j] = 0.5 * (right.b[j] + right.b[j + 1]);
            }
        }
        (left, right)
    }
}

/// All roots of a polynomial (coefficients rising with the power) in `low ..= high`.
///
/// Works on finite intervals; an empty or infinite one gives nothing. Roots of even multiplicity
/// that cannot be told from a near miss within rounding are reported, twice.
pub fn roots_in(coefficients: &[f64], low: f64, high: f64) -> Roots {
    let mut roots = Roots::new();
    let n = match coefficients.iter().rposition(|c| *c != 0.0) {
        Some(n) if n <= MAX_DEGREE && low <= high && (high - low).is_finite() => n,
        _ => return roots,
    };
    let mut keep = |t: f64| {
        if low <= t && t <= high {
            roots.push(t);
        }
    };
    match n {
        0 => {}
        1 => keep(-coefficients[0] / coefficients[1]),
        2 => {
            if let Some([a, b]) = quadratic_roots(coefficients[2], coefficients[1], coefficients[0]) {
                keep(a);
                keep(b);
            }
        }
        // The degrees of most shapes, for each of which there is a program of its own.
        3 => isolate::<4>(coefficients, low, high, &mut roots),
        4 => isolate::<5>(coefficients, low, high, &mut roots),
        5 => isolate::<6>(coefficients, low, high, &mut roots),
        6 => isolate::<7>(coefficients, low, high, &mut roots),
        _ => isolate::<{ MAX_DEGREE + 1 }>(&coefficients[..n + 1], low, high, &mut roots),
    }
    roots
}

/// The degree of a polynomial for which there is room for `N` coefficients: a constant but for the largest room, which
/// holds all higher degrees.
#[inline(always)]
fn degree<const N: usize>(coefficients: &[f64]) -> usize {
    if N <= MAX_DEGREE { N - 1 } else { coefficients.len() - 1 }
}

/// Finds the roots of a polynomial.
#[inline(never)]
fn isolate<const N: usize>(coefficients: &[f64], low: f64, high: f64, roots: &mut Roots) {
    let n = degree::<N>(coefficients);
    let coefficients = &coefficients[..n + 1];
    let whole = Piece::<N> { b: bernstein(coefficients, n, low, high), low, high };
    let scale = whole.b[..n + 1].iter().fold(0.0, |m: f64, b| m.max(b.abs()));
    if !scale.is_finite() {
        return;
    }
    // Conversion and halving are convex combinations: n roundings each, of numbers up to `scale`.
    let noise = gamma(4 * n as u32 + 4) * scale;
    // What most rays meet, without a search.
    match whole.sign_changes(n) {
        0 if scale > 0.0 && !might_touch(&whole.b[..n + 1], noise) => {}
        1 => roots.push(polish(coefficients, &whole, n)),
        _ => subdivide(Search { coefficients, noise, contact_end: f64::NEG_INFINITY, roots }, whole),
    }
}

/// Subdivides until each piece holds no root or one.
#[inline(never)]
fn subdivide<const N: usize>(mut search: Search<'_>, whole: Piece<N>) {
    // 53 halvings reach neighbouring numbers; each level leaves one piece waiting.
    let mut waiting: SmallVec<[Piece<N>; 2]> = SmallVec::new();
    let mut next = Some(whole);
    while let Some(piece) = next {
        next = match search.settle(&piece) {
            Some((left, right)) => {
                waiting.push(right);
                Some(left)
            }
            None => waiting.pop(),
        };
    }
    search.roots.sort_unstable_by(f64::total_cmp);
}

/// A search for roots in pieces from left to right.
struct Search<'a> {
    coefficients: &'a [f64],
    /// What cannot be told from zero.
    noise: f64,
    /// Where the last contact ends.
    contact_end: f64,
    roots: &'a mut Roots,
}

impl Search<'_> {
    /// Notes the roots of a piece, or returns its halves.
    #[inline(always)]
    fn settle<const N: usize>(&mut self, piece: &Piece<N>) -> Option<(Piece<N>, Piece<N>)> {
        let (n, noise) = (degree::<N>(self.coefficients), self.noise);
        let changes = piece.sign_changes(n);
        if changes == 1 {
            self.roots.push(polish(self.coefficients, piece, n));
            return None;
        }
        let middle = 0.5 * piece.low + 0.5 * piece.high;
        let atom = middle <= piece.low || middle >= piece.high;
        if atom || piece.b[..n + 1].iter().all(|b| b.abs() <= noise) {
            // Nothing here can be told from zero: a crossing, or a contact, which counts twice.
            // The piece on its right may look the same, but is not another.
            if piece.low > self.contact_end && (changes > 0 || !atom) {
                self.roots.push(middle);
                self.roots.extend(changes.is_multiple_of(2).then_some(middle));
            }
            self.contact_end = piece.high;
            return None;
        }
        if changes == 0 && !might_touch(&piece.b[..n + 1], noise) {
            return None;
        }
        let (left, right) = piece.split(n);
        let parted = left.sign_changes(n) == 0 && right.sign_changes(n) == 0;
        if right.b[0] == 0.0 || parted && right.b[0].abs() <= noise {
            // Neither half counts a root on their common end.
            self.roots.push(middle);
            self.roots.extend((left.b[n - 1] * right.b[1] > 0.0).then_some(middle));
            if parted {
                return None;
            }
        }
        Some((left, right))
    }
}

/// Whether a piece without sign change dips to zero within the noise between its ends.
fn might_touch(b: &[f64], noise: f64) -> bool {
    let n = b.len() - 1;
    b[1..n].iter().any(|c| c.abs() <= noise) && b[0].abs() > noise && b[n].abs() > noise
}

/// Reciprocals of the binomial coefficients of `n`, which is less than `N`.
const fn inverse_binomials<const N: usize>(n: usize) -> [f64; N] {
    let (mut inverses, mut binomial, mut i) = ([1.0; N], 1.0, 0);
    while i <= n {
        inverses[i] = 1.0 / binomial;
        binomial *= (n - i) as f64 / (i + 1) as f64;
        i += 1;
    }
    inverses
}

/// Bernstein coefficients over [low, high] from powers.
#[inline(always)]
fn bernstein<const N: usize>(coefficients: &[f64], n: usize, low: f64, high: f64) -> [f64; N] {
    let mut b = [0.0; N];
    b[..n + 1].copy_from_slice(coefficients);
    // Taylor shift to `low`, then scale to the unit interval, which pieces of curves have from the start.
    if low != 0.0 {
        for i in 0..n {
            for j in (i..n).rev() {
                b[j] += low * b[j + 1];
            }
        }
    }
    let width = high - low;
    if width != 1.0 {
        let mut power = 1.0;
        for c in &mut b[..n + 1] {
            *c *= power;
            power *= width;
        }
    }
    // Powers to Bernstein: divide by the binomials, then sum differences.
    let inverses = if n + 1 == N { const { inverse_binomials::<N>(N - 1) } } else { inverse_binomials::<N>(n) };
    for i in 1..n {
        b[i] *= inverses[i];
    }
    for i in 1..n + 1 {
        for j in (i..n + 1).rev() {
            b[j] += b[j - 1];
        }
    }
    b
}

/// The one root in a piece: Newton's method, kept inside a shrinking bracket, from about where the chord between the
/// ends meets zero.
///
/// Source: Press et al., Numerical Recipes, section 9.4 (`rtsafe`).
#[inline(always)]
fn polish<const N: usize>(coefficients: &[f64], piece: &Piece<N>, n: usize) -> f64 {
    let (mut low, mut high, first, last) = (piece.low, piece.high, piece.b[0], piece.b[n]);
    let curvature = piece.curvature(n);
    let rising = last > first;
    // Not next to an end that may be another root but for rounding.
    let share = (first / (first - last)).clamp(0.125, 0.875);
    let mut t = low + (high - low) * share;
    // Bisection alone ends after about 60 rounds for neighbouring exponents; Newton needs few.
    for _ in 0..100 {
        let (value, slope) = horner(coefficients, t);
        if value == 0.0 {
            break;
        }
        if (value > 0.0) == rising {
            high = t;
        } else {
            low = t;
        }
        let newton = t - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * low + 0.5 * high };
        // Steps below one unit in the last place change nothing.
        let (step, unit) = ((next - t).abs(), f64::EPSILON * 0.5 * t.abs());
        // So does the next step of Newton's method, whose error is f'' / 2 f' times the square of the one before, here
        // with twice the bound of it.
        if step <= unit || next == newton && curvature * step * step <= unit * slope.abs() {
            return next;
        }
        t = next;
    }
    t
}

/// A bound of the absolute value of every root, infinite for constants.
///
/// Source: Fujiwara 1916: 2 max |a(n-k) / a(n)|^(1/k).
pub fn root_bound(coefficients: &[f64]) -> f64 {
    let Some(n) = coefficients.iter().rposition(|c| *c != 0.0) else { return f64::INFINITY };
    let leading = coefficients[n];
    let term = |k: usize| {
        let ratio = (coefficients[n - k] / leading).abs();
        if ratio == 0.0 { 0.0 } else { (ratio.ln() / k as f64).exp() }
    };
    // Rounded up: logarithm and exponential are good to a few units in the last place.
    2.0 * (1..=n).map(term).fold(0.0, f64::max) * (1.0 + gamma(64))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Multiplies out the roots, looks for them between `low` and `high`, compares.
    fn check(expected: &[f64], low: f64, high: f64, tolerance: f64) {
        let mut coefficients = vec![1.0];
        for r in expected {
            let mut next = vec![0.0; coefficients.len() + 1];
            for (i, c) in coefficients.iter().enumerate() {
                next[i + 1] += c;
                next[i] -= r * c;
            }
            coefficients = next;
        }
        let found = roots_in(&coefficients, low, high);
        let inside: Vec<f64> = expected.iter().copied().filter(|r| (low..=high).contains(r)).collect();
        assert_eq!(found.len(), inside.len(), "{found:?} for {inside:?}");
        for (f, e) in found.iter().zip(&inside) {
            assert!((f - e).abs() <= tolerance * e.abs().max(1e-300), "{f} for {e}");
        }
    }

    #[test]
    fn roots_of_every_degree() {
        check(&[1.0, 2.0, 3.0], 0.0, 10.0, 1e-13);
        check(&[-4.0, 0.5, 2.0, 7.0], 0.0, 10.0, 1e-13);
        check(&[1e-6, 2e-6, 3e-6, 5e-6], 0.0, 1e-5, 1e-12);
        check(&[1e6, 2e6, 3e6, 5e6], 0.0, 1e7, 1e-12);
        check(&[0.1, 0.2, 0.4, 0.5, 0.7, 0.9], 0.0, 1.0, 1e-9);
        check(&[1.0, 1.0 + 1e-5, 3.0], 0.0, 10.0, 1e-8);
        check(&[], 0.0, 1.0, 0.0);
    }

    #[test]
    fn a_contact_counts_twice() {
        let found = roots_in(&[1.0, 0.0, -2.0, 0.0, 1.0], -5.0, 0.3); // (t² - 1)²
        assert_eq!(found.len(), 2);
        // A double root is only known to the square root of the rounding error.
        assert!(found.iter().all(|t| (t + 1.0).abs() < 1e-6), "{found:?}");
    }

    #[test]
    fn quadratics_do_not_cancel() {
        let [near, far] = quadratic_roots(1.0, -1e9, 1.0).unwrap();
        assert!((near - 1e-9).abs() < 1e-24 && (far - 1e9).abs() < 1e-6);
        assert_eq!(quadratic_roots(0.0, 2.0, -4.0), Some([2.0, 2.0]));
        assert_eq!(quadratic_roots(1.0, 0.0, 1.0), None);
        assert_eq!(quadratic_roots(0.0, 0.0, 1.0), None);
    }
}
