//! Orbits of several points of a ray at once, in SIMD lanes.
//!
//! A step of an orbit waits for the one before it, so that a processor follows eight orbits in little more time than
//! one. Where steps along a ray are the smallest ones, the next points are known ahead; where a stretch is halved, there
//! are few that can be next. Every answer has the bits that it would have by itself.

use super::hypercomplex::Pair;
use super::{Julia, JuliaFunction, LEAST_APPROACH, MOST_STEPS};
use crate::math::Ray;
use crate::math::lanes::{Lanes, Work, dispatch};
use bytemuck::{cast, cast_ref};
use pulp::{f64x4, m64x4};

/// How many orbits are followed together.
pub(super) const AHEAD: usize = 8;

/// Vectors of lanes for them.
const VECTORS: usize = AHEAD / 4;

/// A number of each orbit.
type Each = [f64; AHEAD];

/// The same in vectors.
type Vectors = [f64x4; VECTORS];

/// An answer for points that are inside: no step from them is known but the smallest.
const INSIDE: f64 = -1.0;

/// An answer for points outside, the step from which was not asked for.
const OUTSIDE: f64 = 0.0;

/// Whether no orbit is left that has not escaped.
#[inline(always)]
fn all(escaped: [m64x4; VECTORS]) -> bool {
    let masks: [u64; AHEAD] = cast(escaped);
    let mut common = u64::MAX;
    for mask in masks {
        common &= mask;
    }
    common == u64::MAX
}

/// Where the orbits of points of a ray start.
#[derive(Clone, Copy)]
struct Starts<'a> {
    julia: &'a Julia,
    ray: &'a Ray,
    distances: &'a Each,
}

impl Starts<'_> {
    /// The coordinates of a vector of them.
    #[inline(always)]
    fn of<S: Lanes>(self, simd: S, vector: usize) -> [f64x4; 4] {
        let distances: &Vectors = cast_ref(self.distances);
        let (o, d) = (self.ray.origin.to_array(), self.ray.direction.to_array());
        let slice = self.julia.slice.to_array();
        let mut start = [simd.splat_f64s(0.0); 4];
        for axis in 0..3 {
            let way = simd.mul_f64s(simd.splat_f64s(d[axis]), distances[vector]);
            start[axis] = simd.add_f64s(simd.splat_f64s(o[axis]), way);
            start[3] = simd.add_f64s(start[3], simd.mul_f64s(simd.splat_f64s(slice[axis]), start[axis]));
        }
        start[3] = simd.add_f64s(start[3], simd.splat_f64s(self.julia.slice_offset));
        start
    }
}

/// Which points are inside of a quaternion set.
struct FollowQuaternions<'a>(Starts<'a>);

impl Work for FollowQuaternions<'_> {
    type Output = Each;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> Each {
        let julia = self.0.julia;
        let is_cube = matches!(julia.function, JuliaFunction::Cube);
        let (two, three) = (simd.splat_f64s(2.0), simd.splat_f64s(3.0));
        let (escape, parameter) = (simd.splat_f64s(julia.escape()), julia.parameter.to_array());
        let mut points = [[two; 4]; VECTORS];
        for (vector, start) in points.iter_mut().enumerate() {
            *start = self.0.of(simd, vector);
        }
        let mut escaped = [simd.greater_than_f64s(two, three); VECTORS];
        for _ in 0..julia.n_iterations {
            for vector in 0..VECTORS {
                let [r, x, y, z] = points[vector];
                let (rr, xx) = (simd.mul_f64s(r, r), simd.mul_f64s(x, x));
                let (yy, zz) = (simd.mul_f64s(y, y), simd.mul_f64s(z, z));
                let square = simd.add_f64s(simd.add_f64s(simd.add_f64s(rr, xx), yy), zz);
                // What is not a number stays.
                escaped[vector] = simd.or_m64s(escaped[vector], simd.greater_than_f64s(square, escape));
                // The square or cube: a real part, and a factor of the rest.
                let rest = simd.add_f64s(simd.add_f64s(xx, yy), zz);
                let (real, factor) = if is_cube {
                    let real = simd.mul_f64s(r, simd.sub_f64s(rr, simd.mul_f64s(three, rest)));
                    (real, simd.sub_f64s(simd.mul_f64s(simd.mul_f64s(three, r), r), rest))
                } else {
                    (simd.sub_f64s(rr, rest), simd.mul_f64s(two, r))
                };
                let image = [real, simd.mul_f64s(x, factor), simd.mul_f64s(y, factor), simd.mul_f64s(z, factor)];
                for axis in 0..4 {
                    points[vector][axis] = simd.add_f64s(simd.splat_f64s(parameter[axis]), image[axis]);
                }
            }
            if all(escaped) {
                break;
            }
        }
        answers(simd, escaped, [simd.splat_f64s(OUTSIDE); VECTORS])
    }
}

/// Those for orbits that escaped, and for the others.
#[inline(always)]
fn answers<S: Lanes>(simd: S, escaped: [m64x4; VECTORS], mut steps: Vectors) -> Each {
    for vector in 0..VECTORS {
        steps[vector] = simd.select_f64s(escaped[vector], steps[vector], simd.splat_f64s(INSIDE));
    }
    cast(steps)
}

/// Which points are inside of a hypercomplex set of the square and, where `STEPS` are wanted, how far the next sample
/// may be from the others.
struct FollowPairs<'a, const STEPS: bool>(Starts<'a>);

impl<const STEPS: bool> Work for FollowPairs<'_, STEPS> {
    type Output = Each;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> Each {
        let starts = self.0;
        let julia = starts.julia;
        let parameter = Pair::from(julia.parameter).to_array();
        let (half, one) = (simd.splat_f64s(0.5), simd.splat_f64s(1.0));
        let escape = simd.splat_f64s(julia.escape());
        // Coordinates as in `Pair`.
        let (mut points, mut squares) = ([[one; 4]; VECTORS], [one; VECTORS]);
        for (vector, start) in points.iter_mut().enumerate() {
            let [x, y, z, w] = starts.of(simd, vector);
            let xy = simd.add_f64s(simd.mul_f64s(x, x), simd.mul_f64s(y, y));
            squares[vector] = simd.add_f64s(simd.add_f64s(xy, simd.mul_f64s(z, z)), simd.mul_f64s(w, w));
            *start = [simd.sub_f64s(x, w), simd.add_f64s(x, w), simd.add_f64s(y, z), simd.sub_f64s(y, z)];
        }
        let mut products = points;
        // Of the last point in the gradient: see `Julia::hypercomplex_gradient`.
        let mut scales = [simd.splat_f64s(julia.gradient_scale(0)); VECTORS];
        let mut escaped = [simd.greater_than_f64s(half, one); VECTORS];
        for step in 0..julia.n_iterations {
            for vector in 0..VECTORS {
                let [r0, r1, i0, i1] = points[vector];
                let (rr0, rr1) = (simd.mul_f64s(r0, r0), simd.mul_f64s(r1, r1));
                let (ii0, ii1) = (simd.mul_f64s(i0, i0), simd.mul_f64s(i1, i1));
                let square = simd.add_f64s(simd.add_f64s(rr0, ii0), simd.add_f64s(rr1, ii1));
                // That of the first point is known from its coordinates.
                if step > 0 {
                    squares[vector] = simd.mul_f64s(half, square);
                }
                // Orbits that escape stop there. What is not a number stays.
                let outside = simd.greater_than_f64s(squares[vector], escape);
                escaped[vector] = outside;
                if STEPS && step > 0 {
                    let [p0, p1, q0, q1] = products[vector];
                    let product = [
                        simd.sub_f64s(simd.mul_f64s(p0, r0), simd.mul_f64s(q0, i0)),
                        simd.sub_f64s(simd.mul_f64s(p1, r1), simd.mul_f64s(q1, i1)),
                        simd.add_f64s(simd.mul_f64s(p0, i0), simd.mul_f64s(q0, r0)),
                        simd.add_f64s(simd.mul_f64s(p1, i1), simd.mul_f64s(q1, r1)),
                    ];
                    for axis in 0..4 {
                        products[vector][axis] = simd.select_f64s(outside, products[vector][axis], product[axis]);
                    }
                }
                let scale = simd.splat_f64s(julia.gradient_scale(step + 1));
                scales[vector] = simd.select_f64s(outside, scales[vector], scale);
                let (ri0, ri1) = (simd.mul_f64s(r0, i0), simd.mul_f64s(r1, i1));
                let image = [
                    simd.sub_f64s(rr0, ii0),
                    simd.sub_f64s(rr1, ii1),
                    simd.add_f64s(ri0, ri0),
                    simd.add_f64s(ri1, ri1),
                ];
                for axis in 0..4 {
                    let next = simd.add_f64s(image[axis], simd.splat_f64s(parameter[axis]));
                    points[vector][axis] = simd.select_f64s(outside, points[vector][axis], next);
                }
            }
            if all(escaped) {
                break;
            }
        }
        let mut steps = [simd.splat_f64s(OUTSIDE); VECTORS];
        for vector in 0..VECTORS {
            if STEPS {
                let product = coordinates(simd, products[vector]);
                let mut last = coordinates(simd, points[vector]);
                for coordinate in &mut last {
                    *coordinate = simd.mul_f64s(*coordinate, scales[vector]);
                }
                steps[vector] = step(simd, julia, squares[vector], [product, last], starts.ray);
            }
        }
        answers(simd, escaped, steps)
    }
}

/// Four coordinates from those of a [`Pair`].
#[inline(always)]
fn coordinates<S: Lanes>(simd: S, [r0, r1, i0, i1]: [f64x4; 4]) -> [f64x4; 4] {
    let half = simd.splat_f64s(0.5);
    [
        simd.mul_f64s(half, simd.add_f64s(r0, r1)),
        simd.mul_f64s(half, simd.add_f64s(i0, i1)),
        simd.mul_f64s(half, simd.sub_f64s(i0, i1)),
        simd.mul_f64s(half, simd.sub_f64s(r1, r0)),
    ]
}

/// `Julia::hypercomplex_step` in lanes, from the squared length of an orbit's end, its product and its scaled end.
#[inline(always)]
fn step<S: Lanes>(simd: S, julia: &Julia, square: f64x4, [d, n]: [[f64x4; 4]; 2], ray: &Ray) -> f64x4 {
    let [j, k, l] = [simd.neg_f64s(d[1]), simd.neg_f64s(d[2]), simd.neg_f64s(d[3])];
    let rows = [d, [j, d[0], l, d[2]], [k, l, d[0], d[1]]];
    let direction = ray.direction.to_array();
    let mut along = simd.splat_f64s(0.0);
    for axis in 0..3 {
        let mut slope = simd.mul_f64s(rows[axis][0], n[0]);
        for i in 1..4 {
            slope = simd.add_f64s(slope, simd.mul_f64s(rows[axis][i], n[i]));
        }
        along = simd.add_f64s(along, simd.mul_f64s(slope, simd.splat_f64s(direction[axis])));
    }
    let approach = simd.mul_f64s(simd.splat_f64s(-2.0), along);
    let smallest = simd.splat_f64s(julia.smallest_step);
    let least = simd.mul_f64s(smallest, approach);
    let approaches = simd.greater_than_f64s(approach, simd.splat_f64s(LEAST_APPROACH));
    let most = simd.mul_f64s(simd.splat_f64s(MOST_STEPS), least);
    let usual = simd.and_m64s(simd.less_than_f64s(least, square), simd.less_than_f64s(square, most));
    simd.select_f64s(simd.and_m64s(approaches, usual), simd.div_f64s(square, approach), smallest)
}

/// How functions are followed in lanes.
#[derive(Clone, Copy)]
enum Form {
    Quaternions,
    Pairs,
}

impl Form {
    /// `None` for functions that have none.
    fn of(julia: &Julia) -> Option<Self> {
        match (julia.function, julia.hypercomplex) {
            (_, false) => Some(Self::Quaternions),
            (JuliaFunction::Sqr | JuliaFunction::Cube, true) => Some(Self::Pairs),
            _ => None,
        }
    }
}

/// Which points of a ray are inside, by POV-Ray's inside test.
pub(super) struct Insides<'a> {
    julia: &'a Julia,
    ray: &'a Ray,
    distances: &'a Each,
    answers: Option<Each>,
}

impl<'a> Insides<'a> {
    pub(super) fn new(julia: &'a Julia, ray: &'a Ray, distances: &'a Each) -> Self {
        let starts = Starts { julia, ray, distances };
        let answers = Form::of(julia).map(|form| match form {
            Form::Quaternions => dispatch(FollowQuaternions(starts)),
            Form::Pairs => dispatch(FollowPairs::<false>(starts)),
        });
        Self { julia, ray, distances, answers }
    }

    pub(super) fn is_inside(&self, i: usize) -> bool {
        match &self.answers {
            Some(answers) => answers[i] == INSIDE,
            None => self.julia.inside(self.ray.at(self.distances[i])),
        }
    }
}

/// Samples along a ray.
pub(super) struct Ahead<'a> {
    julia: &'a Julia,
    ray: &'a Ray,
    form: Option<Form>,
    /// Points that were looked at, and what was found.
    distances: Each,
    answers: Each,
    /// The one after the last that was asked for; [`AHEAD`] where nobody has looked.
    next: usize,
    /// Whether the last step was the smallest.
    slow: bool,
}

impl<'a> Ahead<'a> {
    pub(super) fn new(julia: &'a Julia, ray: &'a Ray) -> Self {
        let form = Form::of(julia);
        Self { julia, ray, form, distances: [0.0; AHEAD], answers: [OUTSIDE; AHEAD], next: AHEAD, slow: false }
    }

    /// Whether the point at a distance is inside, and how far the next one may be.
    #[inline]
    pub(super) fn sample(&mut self, s: f64) -> (bool, f64) {
        if self.distances.get(self.next) != Some(&s) {
            self.next = AHEAD;
            if let Some(form) = self.form.filter(|_| self.slow) {
                self.look(form, s);
            }
        }
        let answer = self.answers.get(self.next).map_or(OUTSIDE, |step| *step);
        self.next = (self.next + 1).min(AHEAD);
        let smallest = self.julia.smallest_step;
        let sample = if answer == INSIDE {
            (true, smallest)
        } else if answer == OUTSIDE {
            self.julia.sample(self.ray.at(s), self.ray.direction)
        } else {
            (false, answer)
        };
        self.slow = sample.1 <= smallest;
        sample
    }

    /// Looks at the point at a distance and at those that follow if all steps are the smallest.
    fn look(&mut self, form: Form, s: f64) {
        self.distances[0] = s;
        for i in 1..AHEAD {
            self.distances[i] = self.distances[i - 1] + self.julia.smallest_step;
        }
        let starts = Starts { julia: self.julia, ray: self.ray, distances: &self.distances };
        self.answers = match form {
            Form::Quaternions => dispatch(FollowQuaternions(starts)),
            Form::Pairs => dispatch(FollowPairs::<true>(starts)),
        };
        self.next = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DVec3, DVec4};

    /// Samples rays through a set: lanes must say what each orbit says by itself, to the bit.
    fn check(function: JuliaFunction, hypercomplex: bool, parameter: DVec4) {
        let radius = Julia::radius_of(parameter, hypercomplex);
        let (slice, slice_offset) = (DVec3::new(0.1, -0.2, 0.05), 0.01);
        let julia = Julia {
            parameter,
            hypercomplex,
            radius,
            function,
            n_iterations: 7,
            smallest_step: 0.02,
            slice,
            slice_offset,
        };
        let (mut known, mut inside) = (0, 0);
        for i in 0..100 {
            let across = DVec3::new(0.02 * f64::from(i) - 1.0, 0.3, -2.0);
            let ray = Ray::new(across, (DVec3::new(0.1, 0.2, 0.0) - across).normalize());
            let mut ahead = Ahead::new(&julia, &ray);
            let mut s = 0.0;
            while s < 4.0 {
                let sample = ahead.sample(s);
                assert_eq!(sample, julia.sample(ray.at(s), ray.direction), "{function:?} {ray:?} {s}");
                known += usize::from(ahead.next < AHEAD);
                inside += usize::from(sample.0);
                s += sample.1.max(julia.smallest_step);
            }
            let distances = std::array::from_fn(|k| 1.0 + 0.3 * k as f64);
            let insides = Insides::new(&julia, &ray, &distances);
            for (k, s) in distances.into_iter().enumerate() {
                assert_eq!(insides.is_inside(k), julia.inside(ray.at(s)), "{function:?} {ray:?} {s}");
            }
        }
        assert!(known > 1000 && inside > 500, "{known} samples ahead, {inside} of all inside");
    }

    #[test]
    fn lanes_say_what_orbits_say_by_themselves() {
        check(JuliaFunction::Sqr, false, DVec4::new(-0.083, 0.0, -0.83, -0.025));
        check(JuliaFunction::Cube, false, DVec4::new(-0.54, 0.57, 0.0, -0.37));
        check(JuliaFunction::Sqr, true, DVec4::new(0.2, 0.1, 0.59, -0.2));
        check(JuliaFunction::Cube, true, DVec4::new(-0.162, 0.163, 0.56, -0.599));
    }
}
