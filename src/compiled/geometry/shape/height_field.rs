//! Heights over a grid.

use super::mesh::MeshTree;
use super::{LocalSurface, Mesh, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Transform};
use std::sync::Arc;

/// A height field in grid units: cells of size 1 in x and z, heights 0 to 65535 in y.
#[derive(Debug)]
pub(crate) struct HeightGrid {
    /// Vertices across and deep.
    pub(crate) width: usize,
    pub(crate) depth: usize,
    /// By row of z, then x.
    pub(crate) heights: Vec<u16>,
    /// Nothing below this, in grid units.
    pub(crate) water: f64,
    /// Interpolated normals, or none.
    pub(crate) smooth: bool,
    /// The two triangles of each cell; whole numbers are exact in single precision.
    pub(crate) tree: Arc<MeshTree>,
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
}

/// A height field with the linear part of its place, in which normals are interpolated.
#[derive(Clone, Debug)]
pub(crate) struct HeightField {
    pub(crate) grid: Arc<HeightGrid>,
    /// Takes grid units to the group's space, where normals are averaged.
    pub(crate) group_from_grid: Box<Transform>,
}

impl HeightGrid {
    fn height(&self, i: usize, k: usize) -> f64 {
        f64::from(self.heights[k.min(self.depth - 1) * self.width + i.min(self.width - 1)])
    }

    /// The average of up to four upward normals around a vertex, in grid units, truncated to
    /// 1/32767 as POV-Ray stores it.
    fn vertex_normal(&self, i: usize, k: usize) -> DVec3 {
        let here = self.height(i, k);
        let rise = |di: isize, dk: isize| {
            let (x, z) = (i as isize + di, k as isize + dk);
            let inside = x >= 0 && z >= 0 && (x as usize) < self.width && (z as usize) < self.depth;
            inside.then(|| self.height(x as usize, z as usize) - here)
        };
        let mut sum = DVec3::ZERO;
        for (dx, dz) in [(1, 1), (-1, 1), (-1, -1), (1, -1)] {
            if let (Some(a), Some(b)) = (rise(dx, 0), rise(0, dz)) {
                sum += DVec3::new(-a * dx as f64, 1.0, -b * dz as f64).normalize();
            }
        }
        (sum.normalize_or(DVec3::Y) * 32767.0).trunc()
    }

    /// Lower end of the box: the water level or the lowest height, with POV-Ray's margin.
    fn floor(&self) -> f64 {
        self.lowest.max(self.water) - 0.001
    }
}

impl HeightField {
    fn mesh(&self) -> Mesh {
        Mesh { tree: Arc::clone(&self.grid.tree), inside_vector: None }
    }

    fn above_water(&self, ray: &Ray, t: f64) -> bool {
        ray.origin.y + t * ray.direction.y >= self.grid.floor()
    }
}

impl Primitive for HeightField {
    fn bounds(&self) -> Bounds {
        let g = &self.grid;
        let top = DVec3::new((g.width - 1) as f64, g.highest + 0.001, (g.depth - 1) as f64);
        Bounds { min: DVec3::new(0.0, g.floor(), 0.0), max: top }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let first = out.len();
        self.mesh().crossings(ray, range, out);
        let mut kept = first;
        for i in first..out.len() {
            if self.above_water(ray, out[i].t) {
                out[kept] = out[i];
                kept += 1;
            }
        }
        out.truncate(kept);
    }

    fn intersect(&self, ray: &Ray, mut range: Range) -> Option<ShapeHit> {
        let mesh = self.mesh();
        loop {
            let hit = mesh.intersect(ray, range)?;
            if self.above_water(ray, hit.t) {
                return Some(hit);
            }
            range.min = hit.t;
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        let g = &self.grid;
        let over = p.x >= 0.0 && p.x < (g.width - 1) as f64 && p.z >= 0.0 && p.z < (g.depth - 1) as f64;
        if !over || p.y >= g.highest + 0.001 {
            return false;
        }
        let (i, k) = (p.x as usize, p.z as usize);
        let (x, z) = (p.x - i as f64, p.z - k as f64);
        let corner = |a: usize, b: usize| g.height(i + a, k + b).max(g.floor());
        let (h10, h01) = (corner(1, 0), corner(0, 1));
        let plane = if x + z <= 1.0 {
            let h00 = corner(0, 0);
            h00 + x * (h10 - h00) + z * (h01 - h00)
        } else {
            let h11 = corner(1, 1);
            h11 + (1.0 - x) * (h01 - h11) + (1.0 - z) * (h10 - h11)
        };
        p.y < g.floor() || p.y < plane
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let mut surface = self.mesh().surface(ray, t, part);
        if surface.normal.y < 0.0 {
            surface.normal = -surface.normal;
        }
        surface.uv = None;
        let g = &self.grid;
        if g.smooth {
            let p = surface.point;
            let (i, k) = (p.x.clamp(0.0, (g.width - 2) as f64) as usize, p.z.clamp(0.0, (g.depth - 2) as f64) as usize);
            let f = DVec2::new(p.x - i as f64, p.z - k as f64);
            // Each corner's normal counts with unit length where the field stands.
            let place = &self.group_from_grid;
            let corner = |a: usize, b: usize| place.normal(g.vertex_normal(i + a, k + b)).normalize_or(DVec3::Y);
            let near = corner(0, 0) * (1.0 - f.x) + corner(1, 0) * f.x;
            let far = corner(0, 1) * (1.0 - f.x) + corner(1, 1) * f.x;
            surface.shading_normal = Some(place.inverse_normal(near * (1.0 - f.y) + far * f.y));
        }
        surface
    }
}
