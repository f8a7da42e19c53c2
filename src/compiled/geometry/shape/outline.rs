//! Flat curves made of polynomial pieces, for prisms, text and lathes.

use crate::math::{DVec2, Roots, roots_in};

/// A piece of a curve: coefficients of both coordinates, rising powers of w in 0 ..= 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    pub(crate) x: [f64; 4],
    pub(crate) y: [f64; 4],
}

impl Segment {
    /// From vectors by power.
    pub(crate) fn new(c: [DVec2; 4]) -> Self {
        Self { x: c.map(|c| c.x), y: c.map(|c| c.y) }
    }

    /// A straight line.
    pub(crate) fn line(a: DVec2, b: DVec2) -> Self {
        Self::new([a, b - a, DVec2::ZERO, DVec2::ZERO])
    }

    /// POV-Ray's quadratic spline from `p1` to `p2`. Source: freeform facts, section 6.
    pub(crate) fn quadratic(p0: DVec2, p1: DVec2, p2: DVec2) -> Self {
        Self::new([p1, 0.5 * (p2 - p0), 0.5 * p0 - p1 + 0.5 * p2, DVec2::ZERO])
    }

    /// Catmull-Rom from `p1` to `p2`.
    pub(crate) fn cubic([p0, p1, p2, p3]: [DVec2; 4]) -> Self {
        Self::new([p1, 0.5 * (p2 - p0), p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3, 0.5 * (-p0 + 3.0 * p1 - 3.0 * p2 + p3)])
    }

    /// Bézier cubic.
    pub(crate) fn bezier([p0, p1, p2, p3]: [DVec2; 4]) -> Self {
        Self::new([p0, 3.0 * (p1 - p0), 3.0 * (p0 - 2.0 * p1 + p2), p3 - p0 + 3.0 * (p1 - p2)])
    }

    /// The point at `w`.
    pub(crate) fn at(&self, w: f64) -> DVec2 {
        let h = |c: &[f64; 4]| ((c[3] * w + c[2]) * w + c[1]) * w + c[0];
        DVec2::new(h(&self.x), h(&self.y))
    }

    /// The derivative at `w`.
    pub(crate) fn slope(&self, w: f64) -> DVec2 {
        let h = |c: &[f64; 4]| (3.0 * c[3] * w + 2.0 * c[2]) * w + c[1];
        DVec2::new(h(&self.x), h(&self.y))
    }

    /// Where a combination of both coordinates and a constant vanishes.
    pub(crate) fn zeros(&self, x: f64, y: f64, constant: f64) -> Roots {
        let mut c: [f64; 4] = std::array::from_fn(|i| x * self.x[i] + y * self.y[i]);
        c[0] += constant;
        roots_in(&c, 0.0, 1.0)
    }

    /// Lower and upper corner of a box around it: ends and turning points.
    pub(crate) fn bounds(&self) -> [DVec2; 2] {
        let mut box_ = [self.at(0.0).min(self.at(1.0)), self.at(0.0).max(self.at(1.0))];
        for c in [&self.x, &self.y] {
            for w in roots_in(&[c[1], 2.0 * c[2], 3.0 * c[3]], 0.0, 1.0) {
                box_ = [box_[0].min(self.at(w)), box_[1].max(self.at(w))];
            }
        }
        box_
    }

    /// Whether the piece crosses the horizontal line to the right of `p` an odd number of times. `bounds` are its own.
    ///
    /// Whether the whole count is odd follows from the ends alone, each held by its upper side, so that
    /// pieces that meet in a point count it once.
    pub(crate) fn crosses_right_of(&self, p: DVec2, bounds: &[DVec2; 2]) -> bool {
        let [min, max] = bounds;
        if p.y < min.y || p.y > max.y || p.x >= max.x {
            // All of it is on one side of the line, or to the left; rounding keeps the ends from saying otherwise.
            return false;
        }
        let (a, b) = (self.at(0.0).y > p.y, self.at(1.0).y > p.y);
        if p.x < min.x {
            return a != b;
        }
        let roots = self.zeros(0.0, 1.0, -p.y);
        let mut inner: Roots = roots.iter().copied().filter(|w| *w > 0.0 && *w < 1.0).collect();
        if inner.len() % 2 != usize::from(a != b) {
            // A crossing at one end that rounding put on the wrong side.
            let end = |w: &f64| w.min(1.0 - w);
            match inner.iter().enumerate().min_by(|x, y| end(x.1).total_cmp(&end(y.1))).map(|(i, w)| (i, end(w))) {
                Some((i, distance)) if distance < 1e-9 => {
                    inner.remove(i);
                }
                _ => inner.push(if (self.at(0.0).y - p.y).abs() < (self.at(1.0).y - p.y).abs() { 0.0 } else { 1.0 }),
            }
        }
        inner.iter().filter(|w| self.at(**w).x > p.x).count() % 2 == 1
    }
}

/// The box around some boxes.
pub(super) fn around(hulls: &[[DVec2; 2]]) -> [DVec2; 2] {
    let grown = |[min, max]: [DVec2; 2], b: &[DVec2; 2]| [min.min(b[0]), max.max(b[1])];
    hulls.iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], grown)
}

/// Whether an odd number of crossings of pieces, each with its box, lies to the right of a point.
pub(super) fn odd_right_of(segments: &[Segment], hulls: &[[DVec2; 2]], p: DVec2) -> bool {
    segments.iter().zip(hulls).fold(false, |odd, (segment, hull)| odd != segment.crosses_right_of(p, hull))
}
