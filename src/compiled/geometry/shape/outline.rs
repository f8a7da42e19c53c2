//! Flat curves made of polynomial pieces, for prisms, text and lathes.

use crate::math::{DVec2, Roots, gamma, roots_in};

/// A piece of a curve: coefficients of both coordinates, rising powers of w in 0 ..= 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    pub(crate) x: [f64; 4],
    pub(crate) y: [f64; 4],
    /// Where it ends: the very point at which the next piece begins, once they are [joined](join).
    pub(crate) end: DVec2,
}

/// How uncertain the places of roots on a piece are, in units of the piece, by trial with millions of rays.
pub(super) const ROOT_ERROR: f64 = gamma(1024);

/// Makes pieces that meet but for rounding meet in the same point, also where an outline closes.
pub(super) fn join(segments: &mut [Segment]) {
    let mut first = 0;
    for i in 0..segments.len() {
        let end = segments[i].end;
        // A dozen roundings of coefficients of a few times the points.
        let meets = |start: DVec2| (start - end).abs().max_element() <= gamma(128) * segments[i].size();
        let next = segments.get(i + 1).map(Segment::start).filter(|start| meets(*start));
        match next {
            Some(start) => segments[i].end = start,
            None => {
                let start = segments[first].start();
                if meets(start) {
                    segments[i].end = start;
                }
                first = i + 1;
            }
        }
    }
}

/// Makes the roots of a function over a piece agree with its values at the piece's two ends, of which neighbours have the
/// same: an odd number of roots where only one of them is above zero. So a root on a common end is neither lost nor
/// found twice.
#[inline(always)]
pub(super) fn settle(roots: &mut Roots, ends: [f64; 2], [first, last]: [f64; 2]) {
    if (roots.len() % 2 == 1) != ((first > 0.0) != (last > 0.0)) {
        repair(roots, ends, first.abs() < last.abs());
    }
}

/// Rounding put a root on the wrong side of the end where the function is as good as zero: takes it away, or adds it.
#[cold]
fn repair(roots: &mut Roots, [from, to]: [f64; 2], at_first: bool) {
    let end = if at_first { from } else { to };
    let distance = |w: f64| (w - end).abs();
    match (0..roots.len()).min_by(|a, b| distance(roots[*a]).total_cmp(&distance(roots[*b]))) {
        Some(i) if distance(roots[i]) <= ROOT_ERROR * (to - from) => {
            roots.remove(i);
        }
        _ => roots.insert(if at_first { 0 } else { roots.len() }, end),
    }
}

impl Segment {
    /// From vectors by power.
    pub(crate) fn new(c: [DVec2; 4]) -> Self {
        let end = ((c[3] + c[2]) + c[1]) + c[0];
        Self { x: c.map(|c| c.x), y: c.map(|c| c.y), end }
    }

    /// Where it begins.
    pub(crate) fn start(&self) -> DVec2 {
        DVec2::new(self.x[0], self.y[0])
    }

    /// The largest coefficient.
    fn size(&self) -> f64 {
        self.x.iter().chain(&self.y).fold(0.0, |size, c| size.max(c.abs()))
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
        let mut roots = roots_in(&c, 0.0, 1.0);
        // The first coefficient is what the end of the piece before has, to the last bit.
        settle(&mut roots, [0.0, 1.0], [c[0], (x * self.end.x + y * self.end.y) + constant]);
        roots
    }

    /// Lower and upper corner of a box around it: ends and turning points.
    pub(crate) fn bounds(&self) -> [DVec2; 2] {
        let mut box_ = [self.start().min(self.end), self.start().max(self.end)];
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
        let (a, b) = (self.start().y > p.y, self.end.y > p.y);
        if p.x < min.x {
            return a != b;
        }
        self.zeros(0.0, 1.0, -p.y).iter().filter(|w| self.at(**w).x > p.x).count() % 2 == 1
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
