//! Triangles, and the watertight test that meshes share.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec3, Range, Ray, gamma};

/// A ray prepared for triangles: space is sheared so that the ray runs along one axis.
///
/// Two triangles that share an edge compute the same products for it, with the sign turned, so no
/// ray slips between them; edges and corners belong to both.
/// Source: Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2013.
#[derive(Clone, Copy, Debug)]
pub(super) struct TriangleRay {
    origin: DVec3,
    direction: DVec3,
    axes: [usize; 3],
    /// The origin's coordinates along `axes`.
    sheared_origin: [f64; 3],
    shear: [f64; 2],
}

impl TriangleRay {
    #[inline]
    pub(super) fn new(ray: &Ray) -> Self {
        let d = ray.direction;
        let along = d.abs().max_position();
        let axes = [(along + 1) % 3, (along + 2) % 3, along];
        let shear = [d[axes[0]] / d[along], d[axes[1]] / d[along]];
        let sheared_origin = axes.map(|axis| ray.origin[axis]);
        Self { origin: ray.origin, direction: d, axes, sheared_origin, shear }
    }

    /// Ray parameter of the crossing, anywhere on the line.
    #[inline]
    pub(super) fn crossing<T: Into<f64> + Copy>(&self, corners: [&[T; 3]; 3]) -> Option<f64> {
        let [a, b, c] = corners;
        surrounds([self.flat(a), self.flat(b), self.flat(c)]).then(|| self.reach(corners)).flatten()
    }

    /// A corner as the ray sees it: beside the line, in the plane across it. Coordinates are read from memory by axis,
    /// which is why they come as arrays.
    #[inline]
    pub(super) fn flat<T: Into<f64> + Copy>(&self, p: &[T; 3]) -> [f64; 2] {
        let [x, y, along] = self.axes;
        let depth = p[along].into() - self.sheared_origin[2];
        let flat = [p[x].into() - self.sheared_origin[0], p[y].into() - self.sheared_origin[1]];
        [flat[0] - self.shear[0] * depth, flat[1] - self.shear[1] * depth]
    }

    /// Ray parameter of the crossing with a triangle that the line goes through.
    ///
    /// It comes from the plane, whose sign is right for an origin off the plane by more than the
    /// rounding of the corners; the weights would lose that near the surface.
    #[inline]
    pub(super) fn reach<T: Into<f64> + Copy>(&self, corners: [&[T; 3]; 3]) -> Option<f64> {
        let [a, b, c] = corners.map(|p| DVec3::from(p.map(Into::into)) - self.origin);
        let normal = (b - a).cross(c - a);
        let t = normal.dot(a) / normal.dot(self.direction);
        t.is_finite().then_some(t)
    }
}

/// Whether the line goes through the triangle of these flat corners, or its edges.
#[inline]
pub(super) fn surrounds([a, b, c]: [[f64; 2]; 3]) -> bool {
    let u = c[0] * b[1] - c[1] * b[0];
    let v = a[0] * c[1] - a[1] * c[0];
    let w = b[0] * a[1] - b[1] * a[0];
    !((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0))
}

/// Barycentric weights of a point in the plane of a triangle, and the point moved into the plane.
pub(super) fn locate(point: DVec3, [a, b, c]: [DVec3; 3]) -> (DVec3, DVec3) {
    let normal = (b - a).cross(c - a);
    let squared = normal.length_squared();
    let point = point - normal * ((point - a).dot(normal) / squared);
    let weight_b = (point - a).cross(c - a).dot(normal) / squared;
    let weight_c = (b - a).cross(point - a).dot(normal) / squared;
    (point, DVec3::new(1.0 - weight_b - weight_c, weight_b, weight_c))
}

/// Bound of a located point's error: products of edges over their square, rounded a dozen times.
pub(super) fn corner_error([a, b, c]: [DVec3; 3]) -> f64 {
    gamma(16) * a.abs().max(b.abs()).max(c.abs()).max_element()
}

/// A flat triangle with corners in its parent's space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    pub(crate) vertices: [DVec3; 3],
    /// Raw normal; not always that of the order of corners.
    pub(crate) normal: DVec3,
}

impl Primitive for Triangle {
    fn bounds(&self) -> Bounds {
        Bounds::around(self.vertices)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        out.extend(self.intersect(ray, range));
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let t = TriangleRay::new(ray).crossing(self.vertices.each_ref().map(AsRef::as_ref))?;
        range.contains(t).then_some(ShapeHit { t, part: 0 })
    }

    fn contains(&self, _p: DVec3) -> bool {
        false
    }

    fn surface(&self, ray: &Ray, t: f64, _part: u32) -> LocalSurface {
        let (point, _) = locate(ray.at(t), self.vertices);
        LocalSurface::plain(point, corner_error(self.vertices), self.normal)
    }
}

/// A triangle with a normal at each corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SmoothTriangle {
    pub(crate) flat: Triangle,
    pub(crate) normals: [DVec3; 3],
}

impl Primitive for SmoothTriangle {
    fn bounds(&self) -> Bounds {
        self.flat.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        self.flat.crossings(ray, range, out);
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        self.flat.intersect(ray, range)
    }

    fn contains(&self, _p: DVec3) -> bool {
        false
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let (_, weights) = locate(ray.at(t), self.flat.vertices);
        let [a, b, c] = self.normals;
        let shading_normal = Some(a * weights.x + b * weights.y + c * weights.z);
        LocalSurface { shading_normal, ..self.flat.surface(ray, t, part) }
    }
}
