//! Splines: curves through time-stamped vectors.

use crate::math::DVec3;

/// How a spline runs between its knots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum SplineKind {
    #[default]
    Linear,
    Quadratic,
    Cubic,
    Natural,
}

/// A declared spline.
#[derive(Clone, Debug, Default)]
pub struct Spline {
    kind: SplineKind,
    width: usize,
    knots: Vec<(f64, [f64; 5])>,
}

impl Spline {
    /// No knots yet.
    pub fn new(kind: SplineKind) -> Self {
        Self { kind, ..Self::default() }
    }

    /// The kind it was declared with.
    pub fn kind(&self) -> SplineKind {
        self.kind
    }

    /// Changes how it runs between its knots.
    pub fn set_kind(&mut self, kind: SplineKind) {
        self.kind = kind;
    }

    /// The largest number of components of any knot.
    pub fn width(&self) -> usize {
        self.width
    }

    /// How many knots there are.
    pub fn len(&self) -> usize {
        self.knots.len()
    }

    /// Whether there are no knots.
    pub fn is_empty(&self) -> bool {
        self.knots.is_empty()
    }

    /// The knots in order: where they are, and the value there.
    pub fn knots(&self) -> &[(f64, [f64; 5])] {
        &self.knots
    }

    /// Adds a knot, kept sorted by `t`.
    ///
    /// A repeated `t` replaces the earlier value, except that a value repeating the
    /// currently largest `t` (with two or more knots) is ignored, as in POV-Ray.
    pub fn insert(&mut self, t: f64, value: [f64; 5], width: usize) {
        self.width = self.width.max(width);
        let at = self.knots.partition_point(|k| k.0 < t);
        match self.knots.get_mut(at) {
            Some(knot) if knot.0 == t => {
                if at + 1 < self.knots.len() || self.knots.len() < 2 {
                    self.knots[at].1 = value;
                }
            }
            _ => self.knots.insert(at, (t, value)),
        }
    }

    /// The value at `t`; components past the width are 0. Without knots: zeros.
    pub fn at(&self, t: f64) -> [f64; 5] {
        self.at_as(t, self.kind)
    }

    /// The value at `t` as if the spline had been declared with another kind.
    ///
    /// Source: measured rules, function facts, section 4.
    pub fn at_as(&self, t: f64, kind: SplineKind) -> [f64; 5] {
        let k = &self.knots;
        let Some(last) = k.len().checked_sub(1) else { return [0.0; 5] };
        if last == 0 {
            return k[0].1;
        }
        if kind == SplineKind::Cubic {
            return self.cubic(t);
        }
        if t <= k[0].0 {
            return k[0].1;
        }
        if t >= k[last].0 {
            return k[last].1;
        }
        let i = k.partition_point(|knot| knot.0 < t).clamp(1, last);
        match kind {
            SplineKind::Quadratic if last > 1 => self.quadratic(t, i.max(2)),
            SplineKind::Natural => self.natural(t, i),
            _ => {
                let u = (t - k[i - 1].0) / (k[i].0 - k[i - 1].0);
                each(|c| k[i - 1].1[c] + (k[i].1[c] - k[i - 1].1[c]) * u)
            }
        }
    }

    /// The parabola through the three knots that end with `i`.
    fn quadratic(&self, t: f64, i: usize) -> [f64; 5] {
        let [a, b, c] = [&self.knots[i - 2], &self.knots[i - 1], &self.knots[i]];
        let wa = (t - b.0) * (t - c.0) / ((a.0 - b.0) * (a.0 - c.0));
        let wb = (t - a.0) * (t - c.0) / ((b.0 - a.0) * (b.0 - c.0));
        let wc = (t - a.0) * (t - b.0) / ((c.0 - a.0) * (c.0 - b.0));
        each(|n| a.1[n] * wa + b.1[n] * wb + c.1[n] * wc)
    }

    /// Catmull-Rom-like Hermite curve between the inner knots, constant outside of them.
    fn cubic(&self, t: f64) -> [f64; 5] {
        let k = &self.knots;
        let last = k.len() - 1;
        if last == 1 {
            return each(|c| (k[0].1[c] + k[1].1[c]) / 2.0);
        }
        if t <= k[1].0 {
            return k[1].1;
        }
        if t > k[last - 1].0 {
            return k[last - 1].1;
        }
        let i = k.partition_point(|knot| knot.0 < t).clamp(2, last - 1);
        let a = i - 1;
        let step = k[i].0 - k[a].0;
        let u = (t - k[a].0) / step;
        let (u2, u3) = (u * u, u * u * u);
        each(|c| {
            let slope = |j: usize| (k[j + 1].1[c] - k[j].1[c]) / (k[j + 1].0 - k[j].0);
            let m0 = step * (slope(a - 1) + slope(a)) / 2.0;
            let m1 = step * (slope(a) + slope(i)) / 2.0;
            k[a].1[c] * (2.0 * u3 - 3.0 * u2 + 1.0)
                + k[i].1[c] * (3.0 * u2 - 2.0 * u3)
                + m0 * (u3 - 2.0 * u2 + u)
                + m1 * (u3 - u2)
        })
    }

    /// The natural cubic spline's segment that ends with knot `i`.
    fn natural(&self, t: f64, i: usize) -> [f64; 5] {
        let k = &self.knots;
        let second = self.second_derivatives();
        let h = k[i].0 - k[i - 1].0;
        let (a, b) = ((k[i].0 - t) / h, (t - k[i - 1].0) / h);
        each(|c| {
            a * k[i - 1].1[c]
                + b * k[i].1[c]
                + ((a * a * a - a) * second[i - 1][c] + (b * b * b - b) * second[i][c]) * h * h / 6.0
        })
    }

    /// Second derivatives at the knots, zero at both ends (tridiagonal system, Thomas algorithm).
    fn second_derivatives(&self) -> Vec<[f64; 5]> {
        let k = &self.knots;
        let n = k.len();
        let mut second = vec![[0.0; 5]; n];
        let mut above = vec![0.0; n];
        for i in 1..n - 1 {
            let (h0, h1) = (k[i].0 - k[i - 1].0, k[i + 1].0 - k[i].0);
            let pivot = 2.0 * (h0 + h1) - h0 * above[i - 1];
            above[i] = h1 / pivot;
            second[i] = each(|c| {
                let bend = (k[i + 1].1[c] - k[i].1[c]) / h1 - (k[i].1[c] - k[i - 1].1[c]) / h0;
                (6.0 * bend - h0 * second[i - 1][c]) / pivot
            });
        }
        for i in (1..n - 1).rev() {
            second[i] = each(|c| second[i][c] - above[i] * second[i + 1][c]);
        }
        second
    }

    /// The first three components at `t`.
    pub fn point(&self, t: f64) -> DVec3 {
        let v = self.at(t);
        DVec3::new(v[0], v[1], v[2])
    }
}

/// Five components by their index.
fn each(f: impl Fn(usize) -> f64) -> [f64; 5] {
    std::array::from_fn(f)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(kind: SplineKind, knots: &[(f64, f64)], t: f64, expected: f64) {
        let mut spline = Spline::new(kind);
        for &(t, v) in knots {
            spline.insert(t, [v, 0.0, 0.0, 0.0, 0.0], 1);
        }
        let got = spline.at(t)[0];
        assert!((got - expected).abs() < 1e-14, "{kind:?} at {t}: {got}, expected {expected}");
    }

    /// Measured with POV-Ray 3.7.0.10; function facts, section 4.
    #[test]
    fn probes() {
        let s = [(0.0, 1.0), (0.5, 3.0), (1.25, -1.0), (2.0, 2.0), (3.0, 5.0)];
        check(SplineKind::Natural, &s, 0.2, 2.232622950819672);
        check(SplineKind::Natural, &s, 1.6, -0.347414693381906);
        check(SplineKind::Cubic, &s, 0.2, 3.0);
        check(SplineKind::Cubic, &s, 0.8, 1.568);
        check(SplineKind::Cubic, &s, 2.5, 2.0);
        check(SplineKind::Quadratic, &s, 0.2, 2.248);
        check(SplineKind::Quadratic, &s, 0.8, 2.408);
        check(SplineKind::Linear, &s, 1.6, 0.4);
        check(SplineKind::Linear, &s, -9.0, 1.0);
        check(SplineKind::Natural, &s, 9.0, 5.0);
        check(SplineKind::Cubic, &[(0.0, 1.0), (1.0, 3.0)], 0.3, 2.0);
    }

    #[test]
    fn repeated_times_replace_all_but_the_largest() {
        let s = [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0), (1.0, 20.0), (2.0, 30.0), (0.0, 10.0)];
        for (t, v) in [(0.0, 10.0), (1.0, 20.0), (2.0, 3.0)] {
            check(SplineKind::Linear, &s, t, v);
        }
    }
}
