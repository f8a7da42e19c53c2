//! The primitives, each canonical in its own space, behind one enum.
//!
//! Each answers: where are its bounds, which crossings does a ray have, is a point inside, and
//! what does the surface look like at a hit.

mod blob;
mod cone;
mod container;
mod cuboid;
mod height_field;
mod isosurface;
mod julia;
mod lathe;
mod mesh;
mod outline;
mod ovus;
mod parametric;
mod plane;
mod polygon;
mod polynomial;
mod prism;
mod quadric;
mod sor;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
mod torus;
mod triangle;

pub(crate) use blob::{Blob, BlobPart, Core};
pub(crate) use cone::Cone;
pub(crate) use container::Container;
pub(crate) use cuboid::Cuboid;
pub(crate) use height_field::{HeightField, HeightGrid};
pub(crate) use isosurface::{Isosurface, SearchNotes};
pub(crate) use julia::{Julia, JuliaFunction};
pub(crate) use lathe::Lathe;
pub(crate) use mesh::{Mesh, MeshData, MeshTree};
pub(crate) use outline::Segment;
pub(crate) use ovus::Ovus;
pub(crate) use parametric::Parametric;
pub(crate) use plane::{Disc, PLANE_BOUNDARY, Plane};
pub(crate) use polygon::Polygon;
pub(crate) use polynomial::Polynomial;
pub(crate) use prism::{Outline, Prism};
pub(crate) use quadric::Quadric;
pub(crate) use sor::{Sor, SorSegment};
pub(crate) use sphere::Sphere;
pub(crate) use sphere_sweep::{SphereSweep, SweepSegment};
pub(crate) use superellipsoid::Superellipsoid;
pub(crate) use torus::Torus;
pub(crate) use triangle::{SmoothTriangle, Triangle};

use crate::math::{Bounds, DVec3, Range, Ray, Uv, gamma};
use smallvec::SmallVec;

/// One crossing of a ray with a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShapeHit {
    /// Ray parameter.
    pub(crate) t: f64,
    /// Face, segment or the like; the shape's own affair.
    pub(crate) part: u32,
}

/// Crossings in the order in which the shape records them: of equal ones the last counts.
pub(crate) type ShapeHits = SmallVec<[ShapeHit; 8]>;

/// The surface at a hit, in the shape's own space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LocalSurface {
    /// The point, moved onto the surface.
    pub(crate) point: DVec3,
    /// Bound of its distance from the true surface.
    pub(crate) error: f64,
    /// Outward normal, any length.
    pub(crate) normal: DVec3,
    /// Interpolated normal where that differs, any length.
    pub(crate) shading_normal: Option<DVec3>,
    /// Surface coordinates where the shape has its own.
    pub(crate) uv: Option<Uv>,
    /// How far behind the surface the hit itself lies, as a ray parameter, where the shape is only found roughly.
    pub(crate) depth: f64,
}

impl LocalSurface {
    /// Without interpolation and surface coordinates.
    fn plain(point: DVec3, error: f64, normal: DVec3) -> Self {
        Self { point, error, normal, shading_normal: None, uv: None, depth: 0.0 }
    }
}

/// What every primitive can do, in its own space. Directions need not be unit vectors.
pub(crate) trait Primitive {
    /// A box that holds the whole surface; may be infinite.
    fn bounds(&self) -> Bounds;

    /// Appends all crossings strictly inside `range`, in no particular order.
    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits);

    /// Whether the point is inside; on the boundary as POV-Ray decides it for the shape.
    fn contains(&self, point: DVec3) -> bool;

    /// Whether the point is inside of the shape turned inside out; on the boundary of some shapes neither is true.
    fn excludes(&self, point: DVec3) -> bool {
        !self.contains(point)
    }

    /// The surface where `ray` crosses `part` at `t`.
    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface;

    /// The nearest crossing; of equal ones the last recorded.
    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let mut hits = ShapeHits::new();
        self.crossings(ray, range, &mut hits);
        nearest_of(hits)
    }

    /// The part of a range outside of which no point of the ray is inside, by [`contains`](Self::contains) with all
    /// its rounding; errs on the side of more. Only for shapes that bounds do not hold as well.
    fn span(&self, _ray: &Ray, range: Range) -> Range {
        range
    }

    /// Whether [`span`](Self::span) says anything.
    fn has_span(&self) -> bool {
        false
    }

    /// Whether its crossings are found as soon as those of a ray with a box.
    fn is_quick(&self) -> bool {
        false
    }

    /// Whether all points between two crossings of a line are inside.
    fn is_convex(&self) -> bool {
        false
    }

    /// Whether that holds, and both crossings of a line are found together.
    fn is_chordal(&self) -> bool {
        false
    }

    /// Whether there is any crossing.
    fn occluded(&self, ray: &Ray, range: Range) -> bool {
        self.intersect(ray, range).is_some()
    }
}

/// Declares the enum of all shapes and its dispatch by `match`.
macro_rules! shapes {
    ($($name:ident($type:ty),)*) => {
        /// Any primitive.
        #[derive(Clone, Debug)]
        pub(crate) enum Shape { $($name($type),)* }

        impl Shape {
            /// What it is called.
            pub(crate) fn name(&self) -> &'static str {
                match self { $(Self::$name(_) => stringify!($name),)* }
            }
        }

        impl Primitive for Shape {
            fn bounds(&self) -> Bounds {
                match self { $(Self::$name(s) => s.bounds(),)* }
            }
            fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
                match self { $(Self::$name(s) => s.crossings(ray, range, out),)* }
            }
            fn contains(&self, point: DVec3) -> bool {
                match self { $(Self::$name(s) => s.contains(point),)* }
            }
            fn excludes(&self, point: DVec3) -> bool {
                match self { $(Self::$name(s) => s.excludes(point),)* }
            }
            fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
                match self { $(Self::$name(s) => s.surface(ray, t, part),)* }
            }
            fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
                match self { $(Self::$name(s) => s.intersect(ray, range),)* }
            }
            fn occluded(&self, ray: &Ray, range: Range) -> bool {
                match self { $(Self::$name(s) => s.occluded(ray, range),)* }
            }
            fn span(&self, ray: &Ray, range: Range) -> Range {
                match self { $(Self::$name(s) => s.span(ray, range),)* }
            }
            fn has_span(&self) -> bool {
                match self { $(Self::$name(s) => s.has_span(),)* }
            }
            fn is_quick(&self) -> bool {
                match self { $(Self::$name(s) => s.is_quick(),)* }
            }
            fn is_convex(&self) -> bool {
                match self { $(Self::$name(s) => s.is_convex(),)* }
            }
            fn is_chordal(&self) -> bool {
                match self { $(Self::$name(s) => s.is_chordal(),)* }
            }
        }
    };
}

shapes! {
    Sphere(Sphere),
    Cuboid(Cuboid),
    Plane(Plane),
    Disc(Disc),
    Cone(Cone),
    Torus(Torus),
    Ovus(Box<Ovus>),
    Quadric(Box<Quadric>),
    Polynomial(Polynomial),
    Superellipsoid(Superellipsoid),
    Polygon(Polygon),
    HeightField(HeightField),
    Blob(Blob),
    Prism(Prism),
    Lathe(Lathe),
    Sor(Sor),
    Triangle(Box<Triangle>),
    SmoothTriangle(Box<SmoothTriangle>),
    Mesh(Mesh),
    Isosurface(Box<Isosurface>),
    Julia(Box<Julia>),
    SphereSweep(SphereSweep),
    Parametric(Box<Parametric>),
}

impl<P: Primitive> Primitive for Box<P> {
    fn bounds(&self) -> Bounds {
        (**self).bounds()
    }
    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        (**self).crossings(ray, range, out);
    }
    fn contains(&self, point: DVec3) -> bool {
        (**self).contains(point)
    }
    fn excludes(&self, point: DVec3) -> bool {
        (**self).excludes(point)
    }
    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        (**self).surface(ray, t, part)
    }
    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        (**self).intersect(ray, range)
    }
    fn occluded(&self, ray: &Ray, range: Range) -> bool {
        (**self).occluded(ray, range)
    }
    fn span(&self, ray: &Ray, range: Range) -> Range {
        (**self).span(ray, range)
    }
    fn has_span(&self) -> bool {
        (**self).has_span()
    }
    fn is_quick(&self) -> bool {
        (**self).is_quick()
    }
    fn is_convex(&self) -> bool {
        (**self).is_convex()
    }
    fn is_chordal(&self) -> bool {
        (**self).is_chordal()
    }
}

/// The nearest of some crossings; of equal ones the last recorded.
fn nearest_of(hits: ShapeHits) -> Option<ShapeHit> {
    hits.into_iter().reduce(|best, hit| if hit.t <= best.t { hit } else { best })
}

/// POV-Ray's least distance of a hit; here in the shape's own units, not in the world's. It matters for shapes that are
/// found by a rough search: a ray that leaves one often meets it again at once, for no reason but that; POV-Ray then
/// sees nothing of the shape.
const NEAREST: f64 = 1e-4;

/// The same as a ray parameter.
fn nearest(ray: &Ray) -> f64 {
    NEAREST / ray.direction.length()
}

/// Moves a point onto an implicit surface along its gradient, and bounds what is left.
///
/// `sample` gives value, gradient and the sum of the magnitudes of all terms.
fn onto_surface(mut p: DVec3, sample: impl Fn(DVec3) -> (f64, DVec3, f64)) -> (DVec3, f64, DVec3) {
    // Newton's step doubles the digits; the second cleans up after far away hits.
    for _ in 0..2 {
        let (value, gradient, _) = sample(p);
        let step = gradient * (value / gradient.length_squared());
        if step.is_finite() {
            p -= step;
        }
    }
    let (_, gradient, magnitude) = sample(p);
    let slope = gradient.length();
    // Evaluation here and in the next intersection test: a dozen roundings of each term, at most.
    let noise = gamma(64) * magnitude / slope;
    let error = if noise.is_finite() { noise } else { gamma(64) * p.abs().max_element() };
    (p, error, gradient)
}

/// A ray with a unit direction and its origin moved near the shape, for forms that cancel when
/// seen from far away; `t` of the original is `(s + start) / speed`.
#[derive(Clone, Copy, Debug)]
struct NearRay {
    origin: DVec3,
    direction: DVec3,
    /// Distance from the original origin to this one.
    start: f64,
    /// Length of the original direction.
    speed: f64,
}

impl NearRay {
    /// Moves the origin to the point closest to `center`, unless it is within `reach` of it:
    /// a nearby origin stays exact, so that a ray leaving the surface knows its side.
    fn new(ray: &Ray, center: DVec3, reach: f64) -> Self {
        let speed = ray.direction.length();
        let direction = ray.direction / speed;
        let offset = center - ray.origin;
        let start = if offset.length_squared() <= reach * reach { 0.0 } else { offset.dot(direction) };
        Self { origin: ray.origin + direction * start, direction, start, speed }
    }

    /// The parameter range along this ray.
    fn range(&self, range: Range) -> Range {
        Range { min: range.min * self.speed - self.start, max: range.max * self.speed - self.start }
    }

    /// Back to the original parameter.
    fn t(&self, s: f64) -> f64 {
        (s + self.start) / self.speed
    }
}
