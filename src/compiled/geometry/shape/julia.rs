//! Slices through four-dimensional Julia sets.
//!
//! POV-Ray's stepping is kept, because a fractal has no other surface than the one that its
//! steps find (function facts, section 11). Source of the step lengths: Hart, Sandin, Kauffman,
//! Ray Tracing Deterministic 3-D Fractals, 1989.

use super::{LocalSurface, NearRay, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, DVec4, Range, Ray, gamma, quadratic_roots};
use ahead::{AHEAD, Ahead, Insides};
use hypercomplex::Pair;
use remembered::Remembered;
use smallvec::SmallVec;

mod ahead;
mod hypercomplex;
mod remembered;

/// What is iterated; all but the first two only on hypercomplex numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) enum JuliaFunction {
    Sqr,
    Cube,
    Exp,
    Ln,
    Sin,
    Asin,
    Cos,
    Acos,
    Tan,
    Atan,
    Sinh,
    Asinh,
    Cosh,
    Acosh,
    Tanh,
    Atanh,
    Reciprocal,
    Pwr(f64, f64),
}

/// The points whose orbit under q -> f(q) + c stays near the origin.
#[derive(Clone, Debug)]
pub(crate) struct Julia {
    /// c.
    pub(crate) parameter: DVec4,
    pub(crate) hypercomplex: bool,
    /// Of the sphere around the set, by [`radius_of`](Self::radius_of).
    pub(crate) radius: f64,
    pub(crate) function: JuliaFunction,
    pub(crate) n_iterations: usize,
    /// Least distance between samples along a ray.
    pub(crate) smallest_step: f64,
    /// The fourth coordinate of a point p is `slice · p + slice_offset`.
    pub(crate) slice: DVec3,
    pub(crate) slice_offset: f64,
}

/// POV-Ray's length at which the search between two samples ends.
const FINEST: f64 = 1e-7;

/// POV-Ray's slope of half a squared length against a ray up to which hypercomplex sets are approached by the smallest
/// steps, and how many of these the others may have.
const LEAST_APPROACH: f64 = 2e-8;
const MOST_STEPS: f64 = 30.0;

/// POV-Ray's slack of the escape radius.
const ESCAPE_SLACK: f64 = 1e-7;

/// q₀, q₁, … of one point.
type Orbit = SmallVec<[DVec4; 24]>;

/// What happens along a ray.
#[derive(Clone, Copy)]
enum Event {
    /// This point was looked at to find the next step.
    Sample(DVec3),
    /// This point was looked at between two samples.
    Test(DVec3),
    /// Inside and outside meet at this ray parameter.
    Change(f64),
}

/// What POV-Ray's estimates want to know of a hypercomplex orbit.
struct HyperOrbit {
    last: Pair,
    /// Squared length of the last point: that of the first from its coordinates, as rays come in where it is all but the escape radius.
    norm: f64,
    /// Of the derivatives, as POV-Ray has them, of all steps; of none, the last point.
    product: Pair,
    steps: usize,
}

impl HyperOrbit {
    fn new(start: DVec4) -> Self {
        let norm = start.length_squared();
        let start = Pair::from(start);
        Self { last: start, norm, product: start, steps: 0 }
    }
}

impl Julia {
    /// Radius of the sphere around a set with such a parameter.
    pub(crate) fn radius_of(parameter: DVec4, hypercomplex: bool) -> f64 {
        if hypercomplex { 4.0 } else { (1.0 + parameter.length() + ESCAPE_SLACK).min(2.0) }
    }

    /// Squared length at which an orbit has escaped.
    fn escape(&self) -> f64 {
        let squared = self.radius * self.radius;
        if self.hypercomplex { squared } else { squared + ESCAPE_SLACK }
    }

    #[inline]
    fn start(&self, p: DVec3) -> DVec4 {
        p.extend(self.slice.dot(p) + self.slice_offset)
    }

    /// Where POV-Ray's inside test starts: for most functions z is mistaken for y.
    fn tested_start(&self, p: DVec3) -> DVec4 {
        let polynomial = matches!(self.function, JuliaFunction::Sqr | JuliaFunction::Cube | JuliaFunction::Reciprocal);
        self.start(if polynomial { p } else { p.with_z(p.y) })
    }

    /// Square or cube of a quaternion with its real part first.
    #[inline]
    fn power(&self, q: DVec4) -> DVec4 {
        let (real, vector) = (q.x, DVec3::new(q.y, q.z, q.w));
        let squared = vector.length_squared();
        let (r, v) = match self.function {
            JuliaFunction::Cube => (real * (real * real - 3.0 * squared), vector * (3.0 * real * real - squared)),
            _ => (real * real - squared, vector * (2.0 * real)),
        };
        DVec4::new(r, v.x, v.y, v.z)
    }

    /// Whether the orbit of `start` stays within the escape radius.
    fn stays(&self, start: DVec4) -> bool {
        // NaN stays, too.
        let escape = self.escape();
        if self.hypercomplex {
            let (mut q, c) = (Pair::from(start), Pair::from(self.parameter));
            let mut norm = start.length_squared();
            for _ in 0..self.n_iterations {
                if norm > escape {
                    return false;
                }
                q = q.apply(self.function).plus(c);
                norm = q.norm();
            }
        } else {
            let mut q = start;
            for _ in 0..self.n_iterations {
                if q.length_squared() > escape {
                    return false;
                }
                q = self.parameter + self.power(q);
            }
        }
        true
    }

    fn inside(&self, p: DVec3) -> bool {
        self.stays(self.tested_start(p))
    }

    /// Whether a sample is inside, and how far the next one may be.
    #[inline]
    fn sample(&self, p: DVec3, direction: DVec3) -> (bool, f64) {
        let (start, escape) = (self.start(p), self.escape());
        if !self.hypercomplex {
            return self.quaternion_sample(start, escape);
        }
        let mut orbit = HyperOrbit::new(start);
        for _ in 0..self.n_iterations {
            if orbit.norm > escape {
                return (false, self.hypercomplex_step(&orbit, direction));
            }
            self.follow(&mut orbit);
        }
        (true, self.smallest_step)
    }

    /// One step of a hypercomplex orbit.
    #[inline(always)]
    fn follow(&self, orbit: &mut HyperOrbit) {
        let image = orbit.last.apply(self.function);
        let slope = self.slope(orbit.last, image);
        orbit.product = if orbit.steps == 0 { orbit.last } else { orbit.product.times(slope) };
        orbit.last = image.plus(self.parameter.into());
        orbit.norm = orbit.last.norm();
        orbit.steps += 1;
    }

    /// What POV-Ray takes for the derivative at a point with such an image.
    #[inline(always)]
    fn slope(&self, q: Pair, image: Pair) -> Pair {
        match self.function {
            JuliaFunction::Sqr | JuliaFunction::Cube => q,
            JuliaFunction::Reciprocal => image.times(image).negated(),
            _ => image,
        }
    }

    /// The estimate of a quaternion's distance needs no more of its orbit than the product of lengths.
    fn quaternion_sample(&self, mut q: DVec4, escape: f64) -> (bool, f64) {
        let degree: f64 = if matches!(self.function, JuliaFunction::Cube) { 3.0 } else { 2.0 };
        let (mut squares, mut power) = (1.0, 1.0);
        for _ in 0..self.n_iterations {
            let n = q.length_squared();
            squares *= n;
            power *= degree;
            if n > escape {
                return (false, (n / squares).sqrt() * n.ln() / power);
            }
            q = self.parameter + self.power(q);
        }
        (true, self.smallest_step)
    }

    fn hypercomplex_step(&self, orbit: &HyperOrbit, direction: DVec3) -> f64 {
        let last = orbit.last.scaled(self.gradient_scale(orbit.steps));
        let (n, approach) = (orbit.norm, -2.0 * hypercomplex_gradient(orbit.product, last).dot(direction));
        let least = self.smallest_step * approach;
        if approach > LEAST_APPROACH && least < n && n < MOST_STEPS * least { n / approach } else { self.smallest_step }
    }

    /// What stands before the last point in the gradient after some steps.
    fn gradient_scale(&self, steps: usize) -> f64 {
        // Powers of two up to the largest number.
        if matches!(self.function, JuliaFunction::Sqr) { 2f64.powi(steps.clamp(1, 1 << 10) as i32) } else { 1.0 }
    }

    /// Gradient of half the squared length of an orbit's end, along x, y and z.
    fn quaternion_gradient(&self, orbit: &Orbit) -> DVec3 {
        let Some((last, before)) = orbit.split_last() else { return DVec3::X };
        let slope = |axis: DVec4| before.iter().fold(axis, |d, q| self.power_slope(*q, d)).dot(*last);
        DVec3::new(slope(DVec4::X), slope(DVec4::Y), slope(DVec4::Z))
    }

    /// The derivative of [`power`](Self::power) at `q` along `d`.
    fn power_slope(&self, q: DVec4, d: DVec4) -> DVec4 {
        let (x, v) = (q.x, DVec3::new(q.y, q.z, q.w));
        let (dx, dv) = (d.x, DVec3::new(d.y, d.z, d.w));
        let (r, w) = match self.function {
            JuliaFunction::Cube => (
                3.0 * (x * x - v.length_squared()) * dx - 6.0 * x * v.dot(dv),
                dv * (3.0 * x * x - v.length_squared()) + v * (6.0 * x * dx - 2.0 * v.dot(dv)),
            ),
            _ => (2.0 * (x * dx - v.dot(dv)), (dv * x + v * dx) * 2.0),
        };
        DVec4::new(r, w.x, w.y, w.z)
    }

    /// Tells what happens along a ray until `tell` returns true for a change.
    #[inline(always)]
    fn march(&self, ray: &Ray, range: Range, mut tell: impl FnMut(Event) -> bool) {
        let speed = ray.direction.length();
        let unit = Ray::new(ray.origin, ray.direction / speed);
        // From so far away that a place on the ray is less certain than the length at which a search ends, a nearer
        // origin serves as well.
        let reach = FINEST / f64::EPSILON;
        let near = NearRay::new(&unit, DVec3::ZERO, reach);
        let (unit, start) = (Ray::new(near.origin, unit.direction), near.start);
        let Some([enter, leave]) = self.passage(&unit, start != 0.0) else { return };
        let end = leave.min(range.max * speed - start);
        if leave + start < FINEST {
            return;
        }
        let (mut s, mut ahead) = (enter.max(FINEST - start), Ahead::new(self, &unit));
        tell(Event::Sample(unit.at(s)));
        let (mut inside, mut step) = ahead.sample(s);
        if inside {
            s += 2.0 * FINEST;
            tell(Event::Sample(unit.at(s)));
            (inside, step) = ahead.sample(s);
        }
        while s <= end {
            // Also where the estimate is not a number.
            let length = if step > self.smallest_step { step } else { self.smallest_step };
            let next = s + length;
            if next > leave || next <= s {
                return;
            }
            tell(Event::Sample(unit.at(next)));
            let (now_inside, next_step) = ahead.sample(next);
            if now_inside != inside {
                let change = self.change(&unit, s, length, inside, |s| {
                    tell(Event::Test(unit.at(s)));
                });
                if tell(Event::Change((change + start) / speed)) {
                    return;
                }
            }
            (s, step, inside) = (next, next_step, now_inside);
        }
    }

    /// Where a ray with unit direction enters and leaves the sphere around the set.
    ///
    /// The first sample lies there, and by its last digit is inside or not: so POV-Ray's own form is used, as long as
    /// what cancels in it is less than the length at which a search ends.
    fn passage(&self, ray: &Ray, moved: bool) -> Option<[f64; 2]> {
        let toward = -ray.origin.dot(ray.direction);
        let (away, squared) = (ray.origin.length_squared(), self.radius * self.radius);
        if moved || away * f64::EPSILON > FINEST {
            return quadratic_roots(1.0, -2.0 * toward, away - squared);
        }
        let half = (toward * toward - (away - squared)).sqrt();
        (!half.is_nan()).then_some([toward - half, toward + half])
    }

    /// Halves a step until the change is found, and ends on its inner side.
    #[inline(always)]
    fn change(&self, ray: &Ray, mut s: f64, mut length: f64, inside: bool, mut tested: impl FnMut(f64)) -> f64 {
        while length > FINEST {
            let distances = halvings(s, length);
            let insides = Insides::new(self, ray, &distances);
            let mut node = 1;
            while node < AHEAD && length > FINEST {
                length *= 0.5;
                tested(distances[node]);
                let beyond = insides.is_inside(node) == inside;
                if beyond {
                    s = distances[node];
                }
                node = 2 * node + usize::from(beyond);
            }
        }
        if inside { s } else { s + length }
    }
}

/// POV-Ray's estimate of the direction in which the last point of an orbit grows, from the product of its derivatives.
fn hypercomplex_gradient(product: Pair, last: Pair) -> DVec3 {
    let (d, n) = (DVec4::from(product), DVec4::from(last));
    DVec3::new(d.dot(n), DVec4::new(-d.y, d.x, -d.w, d.z).dot(n), DVec4::new(-d.z, -d.w, d.x, d.y).dot(n))
}

/// Where a stretch is halved, and its halves, and theirs: after entry n comes 2n on its near side, 2n + 1 on its far one.
fn halvings(s: f64, mut length: f64) -> [f64; AHEAD] {
    let (mut middles, mut starts) = ([s; AHEAD], [s; AHEAD]);
    for node in 1..AHEAD {
        if node.is_power_of_two() {
            length *= 0.5;
        }
        middles[node] = starts[node] + length;
        if 2 * node < AHEAD {
            (starts[2 * node], starts[2 * node + 1]) = (starts[node], middles[node]);
        }
    }
    middles
}

impl Primitive for Julia {
    fn bounds(&self) -> Bounds {
        let half = DVec3::splat(self.radius);
        Bounds { min: -half, max: half }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let nearest = super::nearest(ray);
        self.march(ray, range, |event| {
            if let Event::Change(t) = event {
                out.extend((t > nearest && range.contains(t)).then_some(ShapeHit { t, part: 0 }));
            }
            false
        });
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let (mut hit, nearest) = (None, super::nearest(ray));
        self.march(ray, range, |event| {
            if let Event::Change(t) = event {
                hit = (t > nearest && range.contains(t)).then_some(ShapeHit { t, part: 0 });
            }
            matches!(event, Event::Change(_))
        });
        hit
    }

    fn contains(&self, p: DVec3) -> bool {
        self.inside(p)
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let p = ray.at(t);
        let gradient = if self.hypercomplex {
            Remembered::at(self, ray, t).gradient()
        } else {
            // Orbits that escape by the last digit have no more to say.
            let goes_on = |norm: f64| norm <= 4.0 * self.escape();
            let mut q = self.start(p);
            let mut orbit = Orbit::from_elem(q, 1);
            while orbit.len() <= self.n_iterations && goes_on(q.length_squared()) {
                q = self.parameter + self.power(q);
                orbit.push(q);
            }
            self.quaternion_gradient(&orbit)
        };
        let usable = gradient.is_finite() && gradient != DVec3::ZERO;
        // Not the depth of the search: rays start where POV-Ray starts them, and the least distance does the rest.
        LocalSurface::plain(p, gamma(32) * self.radius, if usable { gradient } else { DVec3::X })
    }
}
