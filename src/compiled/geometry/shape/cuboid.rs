//! `box`: axis-aligned between two corners.

use super::{LocalSurface, Primitive, ShapeHit, ShapeHits};
use crate::math::{Bounds, DVec2, DVec3, Range, Ray, Uv, gamma};

/// An axis-aligned box; no thickness is fine. Parts: twice the axis, plus one for the upper face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cuboid {
    pub(crate) min: DVec3,
    pub(crate) max: DVec3,
}

impl Cuboid {
    /// Entry and exit anywhere on the line, or nothing where neither is in range.
    ///
    /// Where a ray meets an edge, the face whose axis the direction follows more wins, as in
    /// POV-Ray; its tie threshold of 1e-6 in t becomes a rounding bound here.
    fn crossing_pair(&self, ray: &Ray, range: Range) -> Option<(ShapeHit, ShapeHit)> {
        let (o, d) = (ray.origin, ray.direction);
        let (below, above) = ((self.min - o) / d, (self.max - o) / d);
        let turned = d.cmplt(DVec3::ZERO);
        let (mut near, mut far) = (DVec3::select(turned, above, below), DVec3::select(turned, below, above));
        for axis in 0..3 {
            if d[axis] == 0.0 {
                if o[axis] < self.min[axis] || o[axis] > self.max[axis] {
                    return None;
                }
                (near[axis], far[axis]) = (f64::NEG_INFINITY, f64::INFINITY);
            }
        }
        // Most rays pass by: by more than ties below can turn.
        let (first, last) = (near.max_element().max(range.min), far.min_element().min(range.max));
        if first - last > gamma(16) * (first.abs() + last.abs()) {
            return None;
        }
        let (enter, leave) = (near.max_element(), far.min_element());
        let (enter_axis, leave_axis) = (only_near(near, enter), only_near(far, leave));
        if let (Some(enter_axis), Some(leave_axis)) = (enter_axis, leave_axis) {
            let turned = turned.bitmask();
            let enter = ShapeHit { t: enter, part: 2 * enter_axis + (turned >> enter_axis & 1) };
            let leave = ShapeHit { t: leave, part: 2 * leave_axis + (!turned >> leave_axis & 1) };
            return (enter.t <= leave.t).then_some((enter, leave));
        }
        Self::crossing_pair_at_edge(d, near, far)
    }

    /// The same where a ray may meet an edge, from where it meets the faces along each axis.
    #[inline(never)]
    fn crossing_pair_at_edge(d: DVec3, near: DVec3, far: DVec3) -> Option<(ShapeHit, ShapeHit)> {
        let mut enter = (f64::NEG_INFINITY, 0, 0.0);
        let mut leave = (f64::INFINITY, 0, 0.0);
        for axis in 0..3 {
            let along = d[axis].abs();
            if along == 0.0 {
                continue;
            }
            let part = 2 * axis as u32;
            let (near_part, far_part) = if d[axis] > 0.0 { (part, part + 1) } else { (part + 1, part) };
            let tie = |a: f64, b: f64| b.is_finite() && (a - b).abs() <= gamma(6) * (a.abs() + b.abs());
            if tie(near[axis], enter.0) {
                enter = if along > enter.2 { (enter.0, near_part, along) } else { enter };
            } else if near[axis] > enter.0 {
                enter = (near[axis], near_part, along);
            }
            if tie(far[axis], leave.0) {
                leave = if along > leave.2 { (leave.0, far_part, along) } else { leave };
            } else if far[axis] < leave.0 {
                leave = (far[axis], far_part, along);
            }
        }
        let hits = (ShapeHit { t: enter.0, part: enter.1 }, ShapeHit { t: leave.0, part: leave.1 });
        (enter.0 <= leave.0 && leave.0.is_finite()).then_some(hits)
    }

    /// The unfolded-cube coordinates of the shape facts, section 3.2.
    fn uv(&self, point: DVec3, part: u32) -> DVec2 {
        let size = self.max - self.min;
        let p = (point - self.min) / DVec3::select(size.cmpeq(DVec3::ZERO), DVec3::ONE, size);
        let (third, side) = (1.0 / 3.0, 1.0 / 3.0 + p.y / 3.0);
        match part {
            0 => DVec2::new(p.z / 4.0, side),
            1 => DVec2::new(0.75 - p.z / 4.0, side),
            2 => DVec2::new(0.25 + p.x / 4.0, p.z * third),
            3 => DVec2::new(0.25 + p.x / 4.0, 1.0 - p.z * third),
            4 => DVec2::new(1.0 - p.x / 4.0, side),
            _ => DVec2::new(0.25 + p.x / 4.0, side),
        }
    }
}

/// The axis of the only number that is as near to `t`, which is one of them, as ties are to each other, or nearly so.
#[inline(always)]
fn only_near(numbers: DVec3, t: f64) -> Option<u32> {
    let close = (numbers - t).abs().cmple(DVec3::splat(gamma(16) * t.abs())).bitmask();
    (close.count_ones() == 1).then_some(close.trailing_zeros())
}

impl Primitive for Cuboid {
    fn bounds(&self) -> Bounds {
        Bounds { min: self.min, max: self.max }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut ShapeHits) {
        let Some((enter, leave)) = self.crossing_pair(ray, range) else { return };
        for hit in [enter, leave] {
            if range.contains(hit.t) {
                out.push(hit);
            }
        }
    }

    fn intersect(&self, ray: &Ray, range: Range) -> Option<ShapeHit> {
        let (enter, leave) = self.crossing_pair(ray, range)?;
        // A box without thickness is entered and left at once; the last counts.
        let hit = if range.contains(enter.t) && enter.t < leave.t { enter } else { leave };
        range.contains(hit.t).then_some(hit)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn is_chordal(&self) -> bool {
        true
    }

    fn is_quick(&self) -> bool {
        true
    }

    fn contains(&self, p: DVec3) -> bool {
        self.bounds().contains(p)
    }

    fn surface(&self, ray: &Ray, t: f64, part: u32) -> LocalSurface {
        let (axis, upper) = ((part / 2) as usize, part % 2 == 1);
        let mut point = ray.at(t).clamp(self.min, self.max);
        point[axis] = if upper { self.max[axis] } else { self.min[axis] };
        let mut normal = DVec3::ZERO;
        normal[axis] = if upper { 1.0 } else { -1.0 };
        // The point lies in the face exactly; what remains is the next ray's own rounding.
        let error = gamma(2) * self.min.abs().max(self.max.abs()).max_element();
        LocalSurface { uv: Some(Uv::At(self.uv(point, part))), ..LocalSurface::plain(point, error, normal) }
    }
}
