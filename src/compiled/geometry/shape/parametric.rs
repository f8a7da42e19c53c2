//! A surface given by three functions of u and v.
//!
//! POV-Ray's search is kept, because its results depend on it: a rectangle of the parameters is
//! dropped if `max_gradient` says that its box misses the ray, and the first one as small as
//! `accuracy` is the hit (function facts, section 10).

use super::container::Container;
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::compiled::Function;
use crate::function::{FunctionBody, Slots};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv, gamma};
use std::sync::Arc;

/// (x, y, z) of (u, v); without an inside.
#[derive(Clone, Debug)]
pub(crate) struct Parametric {
    /// x, y and z.
    pub(crate) functions: [Arc<Function>; 3],
    pub(crate) min: DVec2,
    pub(crate) max: DVec2,
    pub(crate) container: Container,
    pub(crate) accuracy: f64,
    /// What the file states as the steepest slope.
    pub(crate) max_gradient: f64,
}

/// POV-Ray's component of a unit direction below which a ray is parallel to an axis' planes.
const PARALLEL: f64 = 1e-10;

/// A place on the surface.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    uv: DVec2,
}

/// Values of one function at (low, low), (low, high), (high, low), (high, high) of (u, v).
type Corners = [f64; 4];

/// A rectangle of the parameters.
#[derive(Clone, Copy)]
struct Rectangle {
    min: DVec2,
    max: DVec2,
}

impl Parametric {
    fn value(&self, axis: usize, u: f64, v: f64, slots: &mut Slots) -> f64 {
        let function = &self.functions[axis];
        match &function.body {
            FunctionBody::Program(program) => program.eval_in(&[u, v], slots),
            _ => function.call(&[u, v])[0],
        }
    }

    fn point(&self, u: f64, v: f64) -> DVec3 {
        let mut slots = Slots::new();
        DVec3::from(std::array::from_fn(|axis| self.value(axis, u, v, &mut slots)))
    }

    /// The nearest place that POV-Ray finds.
    fn find(&self, ray: &Ray) -> Option<Place> {
        let (start, end) = self.container.interval(ray)?;
        // POV-Ray's accuracy is a ray parameter, too, which may be more than a shape that has been made smaller.
        let speed = ray.direction.length();
        let speed = if self.container.is_coarse(self.accuracy, speed) { speed } else { 1.0 };
        let start = match self.container {
            _ if start == end => 0.0,
            Container::Box(_) => start.max(0.0),
            // As in POV-Ray: a sphere is searched behind the ray's origin, too.
            Container::Sphere { .. } => start,
        } + 4.0 * self.accuracy / speed;
        if start > end {
            return None;
        }
        let parallel = PARALLEL * ray.direction.length();
        let mut search = Search { surface: self, ray, speed, parallel, start, end, best: None, slots: Slots::new() };
        let whole = Rectangle { min: self.min, max: self.max };
        let (min, max) = (self.min, self.max);
        search.visit(whole, |search, axis| {
            [(min.x, min.y), (min.x, max.y), (max.x, min.y), (max.x, max.y)]
                .map(|(u, v)| self.value(axis, u, v, &mut search.slots))
        });
        search.best.filter(|place| place.t < end)
    }

    /// Bounds of a function over a rectangle, shifted by `accuracy` as in POV-Ray.
    fn bounds_of(&self, corners: &Corners, size: DVec2) -> (f64, f64) {
        let c = corners.map(|f| f - self.accuracy);
        let between = |length: f64, a: f64, b: f64| {
            let excess = (0.5 * (self.max_gradient * length - (a - b).abs())).max(0.0);
            (a.min(b) - excess, a.max(b) + excess)
        };
        let (low, high) = (between(size.y, c[0], c[1]), between(size.y, c[2], c[3]));
        (between(size.x, low.0, high.0).0, between(size.x, low.1, high.1).1)
    }
}

/// A ray's search.
struct Search<'a> {
    surface: &'a Parametric,
    ray: &'a Ray,
    speed: f64,
    parallel: f64,
    start: f64,
    end: f64,
    best: Option<Place>,
    slots: Slots,
}

impl Search<'_> {
    /// Searches a rectangle; `corners` gives the values of a function at its corners, asked for
    /// only as far as needed.
    fn visit(&mut self, r: Rectangle, mut corners: impl FnMut(&mut Self, usize) -> Corners) {
        let size = r.max - r.min;
        let best = self.best.map_or(f64::INFINITY, |place| place.t);
        let mut known = [[0.0; 4]; 3];
        let mut slabs = [(f64::NEG_INFINITY, f64::INFINITY); 3];
        let (mut last, mut longest) = (None, 0.0f64);
        for axis in 0..3 {
            known[axis] = corners(self, axis);
            let (low, high) = self.surface.bounds_of(&known[axis], size);
            let (o, d) = (self.ray.origin[axis], self.ray.direction[axis]);
            if d.abs() <= self.parallel {
                if !(low <= o && o <= high) {
                    return;
                }
                continue;
            }
            let (a, b) = ((high - o) / d, (low - o) / d);
            let (enter, leave) = (a.min(b), a.max(b));
            let apart = slabs[..axis].iter().any(|(from, to)| enter > *to || leave < *from);
            if enter.is_nan() || enter > self.end || leave < self.start || enter > best || apart {
                return;
            }
            slabs[axis] = (enter, leave);
            (last, longest) = (Some(enter), longest.max(leave - enter));
        }
        let middle = 0.5 * (r.min + r.max);
        let wide = size.x >= size.y;
        let (low, at, high) = if wide { (r.min.x, middle.x, r.max.x) } else { (r.min.y, middle.y, r.max.y) };
        // Neighbouring numbers have no middle, however small the accuracy.
        if (longest * self.speed).min(size.max_element()) < self.surface.accuracy || at <= low || at >= high {
            if let Some(t) = last.filter(|t| self.start < *t && *t < best) {
                self.best = Some(Place { t, uv: r.min });
            }
            return;
        }
        self.halve(r, middle, wide, &known);
    }

    /// Searches the lower half, then the upper one; both share the values on the cut.
    fn halve(&mut self, r: Rectangle, middle: DVec2, wide: bool, known: &[Corners; 3]) {
        let mut cut: [Option<[f64; 2]>; 3] = [None; 3];
        for upper in [false, true] {
            let mut half = r;
            let side = if upper { &mut half.min } else { &mut half.max };
            if wide {
                side.x = middle.x
            } else {
                side.y = middle.y
            }
            self.visit(half, |search, axis| {
                let [a, b] = *cut[axis].get_or_insert_with(|| {
                    let ends = if wide {
                        [(middle.x, r.min.y), (middle.x, r.max.y)]
                    } else {
                        [(r.min.x, middle.y), (r.max.x, middle.y)]
                    };
                    ends.map(|(u, v)| search.surface.value(axis, u, v, &mut search.slots))
                });
                let k = &known[axis];
                match (wide, upper) {
                    (true, false) => [k[0], k[1], a, b],
                    (true, true) => [a, b, k[2], k[3]],
                    (false, false) => [k[0], a, k[2], b],
                    (false, true) => [a, k[1], b, k[3]],
                }
            });
        }
    }
}

impl Primitive for Parametric {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        out.extend(self.intersect(ray, range));
    }

    /// At most one hit. As in POV-Ray the whole line counts in a sphere, so that a ray that starts on the surface
    /// finds itself there, and nothing else.
    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let place = self.find(ray)?;
        (place.t > super::nearest(ray) && range.contains(place.t)).then_some(ShapeHit { t: place.t, part: 0 })
    }

    fn contains(&self, _p: DVec3) -> bool {
        false
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let p = ray.at(t);
        // The same search as before: hits carry no coordinates.
        let uv = self.find(ray).map_or(self.min, |place| place.uv);
        let here = self.point(uv.x, uv.y);
        let along_u = self.point(uv.x + self.accuracy, uv.y) - here;
        let along_v = self.point(uv.x, uv.y + self.accuracy) - here;
        let normal = along_u.cross(along_v);
        let normal = if normal.is_finite() && normal != DVec3::ZERO { normal } else { DVec3::X };
        LocalSurface { uv: Some(Uv::At(uv)), ..LocalSurface::plain(p, gamma(32) * p.abs().max_element(), normal) }
    }
}
