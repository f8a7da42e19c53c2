//! Heights over a grid.
//!
//! Two triangles stand on each cell. They are never stored: a pyramid of the lowest and highest
//! height over ever larger squares of cells leads a ray to the cells that it may meet.
//! Source of the pyramid: Tevs, Ihrke, Seidel, Maximum Mipmaps for Fast, Accurate, and Scalable
//! Dynamic Height Field Rendering, 2008.

use super::triangle::{TriangleRay, corner_error, locate, surrounds};
use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Transform, gamma, greater, lesser};
use glam::Vec3;
use smallvec::SmallVec;
use std::ops::ControlFlow;
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
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
    /// From single cells to one square around all.
    pyramid: Vec<Level>,
}

/// Height ranges over squares of 2^n cells a side.
#[derive(Debug)]
struct Level {
    width: usize,
    depth: usize,
    /// Lowest and highest, by row of z, then x.
    ranges: Vec<[u16; 2]>,
}

impl Level {
    /// Two by two squares become one.
    fn halved(&self) -> Self {
        let (width, depth) = (self.width.div_ceil(2), self.depth.div_ceil(2));
        let range = |n: usize| {
            let (i, k) = (n % width * 2, n / width * 2);
            let four = [(i, k), (i + 1, k), (i, k + 1), (i + 1, k + 1)];
            let inside = four.iter().filter(|(i, k)| *i < self.width && *k < self.depth);
            inside.map(|(i, k)| self.ranges[k * self.width + i]).fold([u16::MAX, 0], around)
        };
        Self { width, depth, ranges: (0..width * depth).map(range).collect() }
    }
}

fn around(a: [u16; 2], b: [u16; 2]) -> [u16; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// Squares that a ray has yet to go through: the parameter at which it enters their boxes, their level and their place
/// there. The next one is the last.
type Waiting = SmallVec<[(f64, u8, u32, u32); 64]>;

/// A ray on its way down the pyramid of a grid.
struct Descent<'g> {
    grid: &'g HeightGrid,
    origin: DVec3,
    direction: DVec3,
    /// Reciprocals of the direction.
    inverse: DVec3,
    /// What boxes are wider by.
    pad: f64,
    /// Along x and z, which of two neighbours the ray meets first.
    near: [usize; 2],
    prepared: TriangleRay,
    /// Crossings lie beyond.
    t_min: f64,
    floor: f64,
}

impl<'g> Descent<'g> {
    fn new(grid: &'g HeightGrid, ray: &Ray, t_min: f64) -> Self {
        let (origin, direction) = (ray.origin, ray.direction);
        let size = DVec3::new(grid.width as f64, grid.highest, grid.depth as f64);
        Self {
            grid,
            origin,
            direction,
            inverse: DVec3::from(direction.to_array().map(|d| (1.0 / d).abs().min(STEEPEST).copysign(d))),
            // Triangles round products of coordinates this large: boxes have to be wider than that.
            pad: gamma(64) * origin.abs().max(size).max_element(),
            near: [usize::from(direction.x < 0.0), usize::from(direction.z < 0.0)],
            prepared: TriangleRay::new(ray),
            t_min,
            floor: grid.floor(),
        }
    }

    /// When the ray is between two planes perpendicular to an axis.
    #[inline(always)]
    fn between(&self, axis: usize, low: f64, high: f64) -> Range {
        let at = |plane: f64| (plane - self.origin[axis]) * self.inverse[axis];
        let (a, b) = (at(low - self.pad), at(high + self.pad));
        Range { min: lesser(a, b), max: greater(a, b) }
    }

    /// Adds the quarters of a square that the ray meets, the farthest first.
    #[inline(always)]
    fn quarters(&self, n: u8, i: usize, k: usize, t_max: f64, waiting: &mut Waiting) {
        let below = &self.grid.pyramid[usize::from(n) - 1];
        let halves = |axis: usize, at: usize| {
            let [a, b, c] = [2 * at, 2 * at + 1, 2 * at + 2].map(|at| (at << (n - 1)) as f64);
            [self.between(axis, a, b), self.between(axis, b, c)]
        };
        let (halves_x, halves_z) = (halves(0, i), halves(2, k));
        for (x, z) in [(1, 1), (0, 1), (1, 0), (0, 0)] {
            let (x, z) = (x ^ self.near[0], z ^ self.near[1]);
            let (i, k) = (2 * i + x, 2 * k + z);
            if i >= below.width || k >= below.depth {
                continue;
            }
            let [low, high] = below.ranges[k * below.width + i].map(f64::from);
            let (across, up, deep) = (halves_x[x], self.between(1, low, high), halves_z[z]);
            let enter = greater(greater(across.min, deep.min), greater(up.min, self.t_min));
            let leave = lesser(lesser(across.max, deep.max), lesser(up.max, t_max));
            if enter <= leave && high >= self.floor {
                waiting.push((enter, n - 1, i as u32, k as u32));
            }
        }
    }

    /// Crossings with the two faces of a cell.
    #[inline(always)]
    fn faces(
        &self,
        number: usize,
        t_max: &mut f64,
        found: &mut impl FnMut(f64, usize, &mut f64) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let cell = self.grid.cell(number);
        let flat = cell.each_ref().map(|corner| self.prepared.flat(corner));
        for (face, corners) in (2 * number..).zip(FACES) {
            if surrounds(corners.map(|corner| flat[corner]))
                && let Some(t) = self.prepared.reach(corners.map(|corner| &cell[corner]))
                && self.t_min < t
                && t < *t_max
                && self.origin.y + t * self.direction.y >= self.floor
            {
                found(t, face, t_max)?;
            }
        }
        ControlFlow::Continue(())
    }
}

/// A height field with the linear part of its place, in which normals are interpolated.
#[derive(Clone, Debug)]
pub(crate) struct HeightField {
    pub(crate) grid: Arc<HeightGrid>,
    /// Takes grid units to the group's space, where normals are averaged.
    pub(crate) group_from_grid: Box<Transform>,
}

/// What stops reciprocals of directions along an axis, so that a product with a distance of 0 is 0.
const STEEPEST: f64 = 1e300;

/// Corners of a cell's two faces, split from (i+1, k) to (i, k+1).
const FACES: [[usize; 3]; 2] = [[0, 1, 2], [3, 2, 1]];

impl HeightGrid {
    /// From at least two by two heights, by row of z, then x.
    pub(crate) fn new(width: usize, heights: Vec<u16>, water: f64, smooth: bool) -> Self {
        let depth = heights.len() / width;
        let cell = |n: usize| {
            let first = n / (width - 1) * width + n % (width - 1);
            let four = [first, first + 1, first + width, first + width + 1];
            four.into_iter().map(|i| [heights[i]; 2]).fold([u16::MAX, 0], around)
        };
        let (across, deep) = (width - 1, depth - 1);
        let mut pyramid = vec![Level { width: across, depth: deep, ranges: (0..across * deep).map(cell).collect() }];
        while let Some(level) = pyramid.last().filter(|level| level.ranges.len() > 1) {
            pyramid.push(level.halved());
        }
        let [lowest, highest] = pyramid.last().map_or([0; 2], |top| top.ranges[0]).map(f64::from);
        Self { width, depth, heights, water, smooth, lowest, highest, pyramid }
    }

    /// Corners of a cell: (i, k), (i+1, k), (i, k+1) and (i+1, k+1). Whole numbers, exact in single precision.
    fn cell(&self, cell: usize) -> [[f32; 3]; 4] {
        let across = self.width - 1;
        let (i, k) = (cell % across, cell / across);
        let at = |i: usize, k: usize| [i as f32, f32::from(self.heights[k * self.width + i]), k as f32];
        [at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)]
    }

    /// Corners of a face.
    fn corners(&self, face: usize) -> [[f32; 3]; 3] {
        let cell = self.cell(face / 2);
        FACES[face % 2].map(|corner| cell[corner])
    }

    /// Every crossing above the floor, with its face, from near cells to far ones. `found` may lower
    /// the end of the range.
    fn walk(
        &self,
        ray: &Ray,
        range: Range,
        mut found: impl FnMut(f64, usize, &mut f64) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let descent = Descent::new(self, ray, range.min);
        let mut t_max = range.max;
        let mut waiting: Waiting = SmallVec::new();
        waiting.push((range.min, self.pyramid.len() as u8 - 1, 0, 0));
        while let Some((enter, n, i, k)) = waiting.pop() {
            if enter > t_max {
                continue;
            }
            let (i, k) = (i as usize, k as usize);
            if n == 0 {
                descent.faces(k * self.pyramid[0].width + i, &mut t_max, &mut found)?;
            } else {
                descent.quarters(n, i, k, t_max, &mut waiting);
            }
        }
        ControlFlow::Continue(())
    }

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
    fn walk(&self, ray: &Ray, range: Range, found: impl FnMut(f64, usize, &mut f64) -> ControlFlow<()>) {
        let _: ControlFlow<()> = self.grid.walk(ray, range, found);
    }
}

impl Primitive for HeightField {
    fn bounds(&self) -> Bounds {
        let g = &self.grid;
        let top = DVec3::new((g.width - 1) as f64, g.highest + 0.001, (g.depth - 1) as f64);
        Bounds { min: DVec3::new(0.0, g.floor(), 0.0), max: top }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        self.walk(ray, range, |t, face, _| {
            out.push(ShapeHit { t, part: face as u32 });
            ControlFlow::Continue(())
        });
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let mut best = None;
        self.walk(ray, range, |t, face, t_max| {
            *t_max = t;
            best = Some(ShapeHit { t, part: face as u32 });
            ControlFlow::Continue(())
        });
        best
    }

    fn occluded(&self, ray: &Ray, range: Range) -> bool {
        self.grid.walk(ray, range, |_, _, _| ControlFlow::Break(())).is_break()
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
        let g = &self.grid;
        let corners = g.corners(part as usize).map(|c| Vec3::from(c).as_dvec3());
        let (point, _) = locate(ray.at(t), corners);
        let [a, b, c] = corners;
        let mut surface = LocalSurface::plain(point, corner_error(corners), (c - a).cross(b - a));
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
