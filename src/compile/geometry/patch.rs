//! Bézier patches, split into triangles as POV-Ray does.
//!
//! Source: freeform facts, section 5.

use super::POV_TINY;
use crate::compiled::geometry::MeshData;
use crate::math::{DVec2, DVec3};
use crate::scene::BicubicPatch;

type Points = [[DVec3; 4]; 4];

/// A part of the parameter square: lower and upper (u, v).
#[derive(Clone, Copy)]
struct Part {
    points: Points,
    low: DVec2,
    high: DVec2,
}

/// Halves a row of control points. Source: de Casteljau.
fn halves([a, b, c, d]: [DVec3; 4]) -> ([DVec3; 4], [DVec3; 4]) {
    let (ab, bc, cd) = (0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + d));
    let (abc, bcd) = (0.5 * (ab + bc), 0.5 * (bc + cd));
    let middle = 0.5 * (abc + bcd);
    ([a, ab, abc, middle], [middle, bcd, cd, d])
}

fn transposed(p: &Points) -> Points {
    std::array::from_fn(|i| std::array::from_fn(|j| p[j][i]))
}

impl Part {
    /// Halves in v, along each row.
    fn split_v(&self) -> [Self; 2] {
        let rows = self.points.map(halves);
        let middle = 0.5 * (self.low.y + self.high.y);
        [
            Self { points: rows.map(|r| r.0), high: DVec2::new(self.high.x, middle), ..*self },
            Self { points: rows.map(|r| r.1), low: DVec2::new(self.low.x, middle), ..*self },
        ]
    }

    /// Halves in u, across the rows.
    fn split_u(&self) -> [Self; 2] {
        let columns = transposed(&self.points).map(halves);
        let middle = 0.5 * (self.low.x + self.high.x);
        [
            Self { points: transposed(&columns.map(|c| c.0)), high: DVec2::new(middle, self.high.y), ..*self },
            Self { points: transposed(&columns.map(|c| c.1)), low: DVec2::new(middle, self.low.y), ..*self },
        ]
    }

    /// Whether all control points are nearer than `flatness` to the plane of three corners.
    fn is_flat(&self, flatness: f64) -> bool {
        let p = &self.points;
        // POV-Ray's thresholds for corners that coincide or stand in a line; of a small patch, in units of its size.
        let diagonal = p[3][3].distance(p[0][0]).max(p[0][3].distance(p[3][0]));
        let second = if p[0][3].distance(p[0][0]) < POV_TINY * diagonal.min(1.0) { p[3][3] } else { p[0][3] };
        let (u, v) = (second - p[0][0], p[3][0] - p[0][0]);
        let normal = u.cross(v);
        if normal.length_squared() <= POV_TINY * u.length_squared() * v.length_squared() {
            return false;
        }
        let normal = normal.normalize();
        p.iter().flatten().all(|q| (*q - p[0][0]).dot(normal).abs() < flatness)
    }
}

/// Value and derivative of the cubic Bernstein polynomials.
fn bernstein(t: f64) -> ([f64; 4], [f64; 4]) {
    let s = 1.0 - t;
    (
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
        [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t],
    )
}

/// The patch's normal; <1, 0, 0> where an edge has collapsed, as in POV-Ray.
fn normal(p: &Points, at: DVec2) -> DVec3 {
    let ((bu, du), (bv, dv)) = (bernstein(at.x), bernstein(at.y));
    let sum = |a: &[f64; 4], b: &[f64; 4]| {
        let mut total = DVec3::ZERO;
        for i in 0..4 {
            for j in 0..4 {
                total += p[i][j] * (a[i] * b[j]);
            }
        }
        total
    };
    let (u, v) = (sum(&du, &bv), sum(&bu, &dv));
    let n = u.cross(v);
    if n.length_squared() <= POV_TINY * u.length_squared() * v.length_squared() { DVec3::X } else { n.normalize() }
}

/// Triangles of a patch whose control points have their final size.
pub(super) fn tessellate(patch: &BicubicPatch, flatness: f64, points: &Points) -> MeshData {
    let mut mesh = MeshData { normal_indices: None, ..MeshData::default() };
    let whole = Part { points: *points, low: DVec2::ZERO, high: DVec2::ONE };
    // Deeper than any file asks for would only repeat numbers.
    let (u_steps, v_steps) = (patch.u_steps.min(10), patch.v_steps.min(10));
    let mut waiting = vec![(whole, 0)];
    while let Some((part, depth)) = waiting.pop() {
        let (in_u, in_v) = (depth < u_steps, depth < v_steps);
        if !(in_u || in_v) || part.is_flat(flatness) {
            add_leaf(patch, points, &part, &mut mesh);
            continue;
        }
        let across: Vec<Part> = if in_u { part.split_u().into() } else { vec![part] };
        for half in across {
            if in_v {
                waiting.extend(half.split_v().map(|p| (p, depth + 1)));
            } else {
                waiting.push((half, depth + 1));
            }
        }
    }
    mesh
}

/// Two triangles of a part's corners.
fn add_leaf(patch: &BicubicPatch, points: &Points, part: &Part, mesh: &mut MeshData) {
    let first = mesh.vertices.len() as u32;
    let p = &part.points;
    let (low, high) = (part.low, part.high);
    let corners =
        [(p[0][0], low), (p[0][3], DVec2::new(low.x, high.y)), (p[3][3], high), (p[3][0], DVec2::new(high.x, low.y))];
    for (point, at) in corners {
        mesh.vertices.push(point.as_vec3().to_array());
        mesh.normals.push(normal(points, at).as_vec3().to_array());
        let [s0, s1, s2, s3] = patch.uv_corners;
        let (start, end) = (s0.lerp(s1, at.y), s3.lerp(s2, at.y));
        mesh.uvs.push(start.lerp(end, at.x));
    }
    for triangle in [[0, 1, 2], [0, 2, 3]] {
        let face = triangle.map(|i| first + i);
        mesh.faces.push(face);
        mesh.uv_indices.push(face);
    }
}
