//! How far a quadric reaches inside a box: cones, hyperboloids and tubes that planes cut off are finite.
//!
//! On the surface `Σ (s x² + l x) + c = 0` each coordinate's own part is what the parts of the others leave, so their
//! ranges over the box bound it; inside, where the sum is not positive, they bound it from above. Old scenes build
//! turned wood of such pieces; without bounds every ray would have to try each.

use super::half_spaces::HalfSpace;
use crate::compiled::geometry::{Primitive, Quadric, Shape as Compiled, padded};
use crate::math::{Bounds, DMat3, DVec3, gamma};

/// Part of the box in which the surface of a primitive, or its surface and inside, can be.
///
/// Space: the primitive's group. Anything but a quadric along the axes gives back the box.
pub(super) fn within(primitive: &Primitive, around: &Bounds, surface_only: bool) -> Bounds {
    let Compiled::Quadric(quadric) = &primitive.shape else { return *around };
    if quadric.products != DVec3::ZERO || (primitive.inverse && !surface_only) {
        return *around;
    }
    // Group space from local space, axis by axis: g = scale * x + origin.
    let (scale, origin) = match &primitive.group_from_local {
        None => (DVec3::ONE, DVec3::ZERO),
        Some(place) => {
            let m = place.linear();
            let scale = DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z);
            if m != DMat3::from_diagonal(scale) {
                return *around;
            }
            (scale, place.origin())
        }
    };
    let reach = reach(quadric, scale, origin, around, surface_only);
    if reach.is_empty() { Bounds::EMPTY } else { padded(reach) }
}

/// Where the surface of a primitive, or its surface and inside, can be among half-spaces of its group, however the two
/// are turned to each other.
///
/// Anything but a quadric along axes of its own is everywhere.
pub(super) fn among(primitive: &Primitive, half_spaces: &[HalfSpace], surface_only: bool) -> Bounds {
    let Compiled::Quadric(quadric) = &primitive.shape else { return Bounds::INFINITE };
    if quadric.products != DVec3::ZERO || (primitive.inverse && !surface_only) {
        return Bounds::INFINITE;
    }
    let local = |h: &HalfSpace| match &primitive.group_from_local {
        None => Cut { normal: h.normal, distance: h.distance, doubt: 0.0 },
        Some(place) => {
            let (normal, shift) = (place.linear().transpose() * h.normal, h.normal.dot(place.origin()));
            let doubt = gamma(16) * (h.distance.abs() + (h.normal * place.origin()).abs().element_sum());
            let length = normal.length();
            Cut { normal: normal / length, distance: (h.distance - shift) / length, doubt: doubt / length }
        }
    };
    let cuts: Vec<Cut> = half_spaces.iter().map(local).collect();
    let mut around = Bounds::INFINITE;
    // Planes cut the quadric, which then is less wide where others cut it.
    for _ in 0..3 {
        around = reach(quadric, DVec3::ONE, DVec3::ZERO, &around, surface_only);
        around = cuts.iter().fold(around, |around, cut| cut.applied(around));
    }
    if around.is_empty() || !around.is_finite() {
        return Bounds::INFINITE;
    }
    // What normals are turned by rounding moves their planes by that part of how far away they cut.
    let slack = Cut::FLAT * around.min.abs().max(around.max.abs()).max_element();
    let around = padded(Bounds { min: around.min - slack, max: around.max + slack });
    padded(primitive.group_from_local.as_ref().map_or(around, |place| place.bounds(&around)))
}

/// Points with `normal` · p <= `distance`, up to a doubt about the distance; the normal is a unit vector.
#[derive(Clone, Copy)]
struct Cut {
    normal: DVec3,
    distance: f64,
    doubt: f64,
}

impl Cut {
    /// Coordinates of a normal up to this are but rounding of one along an axis.
    const FLAT: f64 = gamma(64);

    /// What it leaves of a box.
    fn applied(&self, mut around: Bounds) -> Bounds {
        let least = |axis: usize| {
            let n = self.normal[axis];
            if n.abs() <= Self::FLAT { 0.0 } else { (n * around.min[axis]).min(n * around.max[axis]) }
        };
        let least = [least(0), least(1), least(2)];
        for axis in 0..3 {
            let (n, rest) = (self.normal[axis], least[(axis + 1) % 3] + least[(axis + 2) % 3]);
            let slack = self.doubt + gamma(16) * (self.distance.abs() + rest.abs());
            let end = (self.distance - rest + slack) / n;
            if n.abs() <= Self::FLAT || !end.is_finite() {
                continue;
            }
            if n > 0.0 {
                around.max[axis] = around.max[axis].min(end);
            } else {
                around.min[axis] = around.min[axis].max(end);
            }
        }
        around
    }
}

/// Part of the box in which the surface of a quadric, or its surface and inside, can be, scaled and then moved; without
/// room for rounding.
fn reach(quadric: &Quadric, scale: DVec3, origin: DVec3, around: &Bounds, surface_only: bool) -> Bounds {
    let part = |axis: usize| Part {
        square: quadric.squares[axis] / (scale[axis] * scale[axis]),
        linear: quadric.linear[axis] / scale[axis],
        origin: origin[axis],
    };
    let parts = [part(0), part(1), part(2)];
    let mut reach = *around;
    // The second round uses what the first has found.
    for axis in [0, 1, 2, 0, 1, 2] {
        let (mut low, mut high, mut size) = (quadric.constant, quadric.constant, quadric.constant.abs());
        for other in (0..3).filter(|other| *other != axis) {
            let (from, to) = parts[other].range(reach.min[other], reach.max[other]);
            (low, high, size) = (low + from, high + to, size + from.abs().max(to.abs()));
        }
        // Rounding of the sums, with room to spare.
        let slack = if size.is_finite() { gamma(64) * size } else { 0.0 };
        let mut found = parts[axis].at_most(-low + slack);
        if surface_only {
            let turned = Part { square: -parts[axis].square, linear: -parts[axis].linear, ..parts[axis] };
            let other = turned.at_most(high + slack);
            found = (found.0.max(other.0), found.1.min(other.1));
        }
        reach.min[axis] = reach.min[axis].max(found.0);
        reach.max[axis] = reach.max[axis].min(found.1);
    }
    reach
}

/// One coordinate's part of the sum: `square x² + linear x` with `x` from an origin.
#[derive(Clone, Copy)]
struct Part {
    square: f64,
    linear: f64,
    origin: f64,
}

impl Part {
    /// Smallest and largest value between two coordinates, which may be infinite.
    fn range(&self, min: f64, max: f64) -> (f64, f64) {
        if min > max {
            return (f64::INFINITY, f64::NEG_INFINITY);
        }
        let value = |x: f64| {
            if x.is_finite() {
                (self.square * x + self.linear) * x
            } else if self.square != 0.0 {
                self.square * f64::INFINITY
            } else if self.linear != 0.0 {
                self.linear * x
            } else {
                0.0
            }
        };
        let (a, b) = (value(min - self.origin), value(max - self.origin));
        let (mut low, mut high) = (a.min(b), a.max(b));
        if self.square != 0.0 {
            let vertex = -0.5 * self.linear / self.square;
            if (min - self.origin..=max - self.origin).contains(&vertex) {
                let extreme = value(vertex);
                (low, high) = (low.min(extreme), high.max(extreme));
            }
        }
        (low, high)
    }

    /// The coordinates between which the value is at most `limit`.
    fn at_most(&self, limit: f64) -> (f64, f64) {
        const ALL: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);
        const NONE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);
        if limit == f64::INFINITY || limit.is_nan() || self.square < 0.0 {
            return ALL;
        }
        if self.square == 0.0 {
            let edge = limit / self.linear;
            return match self.linear {
                l if l > 0.0 => (f64::NEG_INFINITY, edge + self.origin),
                l if l < 0.0 => (edge + self.origin, f64::INFINITY),
                _ => ALL,
            };
        }
        let discriminant = self.linear * self.linear + 4.0 * self.square * limit;
        if discriminant < 0.0 {
            return NONE;
        }
        let half = 0.5 * discriminant.sqrt() / self.square * (1.0 + gamma(16));
        let middle = -0.5 * self.linear / self.square;
        let slack = gamma(16) * (middle.abs() + self.origin.abs());
        (middle - half - slack + self.origin, middle + half + slack + self.origin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled::geometry::{AppearanceId, Quadric};
    use crate::math::Transform;

    /// A quadric along the axes, in the box, moved up by 2 and made twice as wide.
    fn check(squares: [f64; 3], constant: f64, surface_only: bool, around: [[f64; 3]; 2], expected: [[f64; 3]; 2]) {
        let quadric = Quadric::new(squares.into(), DVec3::ZERO, DVec3::ZERO, constant, false);
        let place =
            Transform::scaling(DVec3::new(2.0, 1.0, 2.0)).then(&Transform::translation(DVec3::new(0.0, 2.0, 0.0)));
        let primitive = Primitive {
            shape: Compiled::Quadric(Box::new(quadric)),
            group_from_local: Some(Box::new(place)),
            inverse: false,
            uv_from_group: None,
            appearance: AppearanceId::default(),
        };
        let around = Bounds { min: around[0].into(), max: around[1].into() };
        let found = within(&primitive, &around, surface_only);
        for (found, expected) in [(found.min, expected[0]), (found.max, expected[1])] {
            for axis in 0..3 {
                let same = found[axis] == expected[axis] || (found[axis] - expected[axis]).abs() < 1e-12;
                assert!(same, "{found} instead of {expected:?}");
            }
        }
    }

    const INF: f64 = f64::INFINITY;

    #[test]
    fn planes_cut_quadrics_to_size() {
        let slab = [[-INF, 0.0, -INF], [INF, 5.0, INF]];
        // A cone: at y = 5 and y = 0 its radius is 3 and 2, twice as wide.
        check([1.0, -1.0, 1.0], 0.0, false, slab, [[-6.0, 0.0, -6.0], [6.0, 5.0, 6.0]]);
        // A hyperboloid: sqrt(1 + 9) wide at its widest.
        let wide = 2.0 * 10f64.sqrt();
        check([1.0, -1.0, 1.0], -1.0, true, slab, [[-wide, 0.0, -wide], [wide, 5.0, wide]]);
        // A tube needs no planes across its axis.
        let all = [[-INF; 3], [INF; 3]];
        check([1.0, 0.0, 1.0], -1.0, false, all, [[-2.0, -INF, -2.0], [2.0, INF, 2.0]]);
        // Around a hyperboloid of two sheets nothing is bounded, but between its tips there is no surface.
        check([1.0, -1.0, 1.0], 1.0, true, all, all);
        let gap = [[-1.0, 1.5, -1.0], [1.0, 2.5, 1.0]];
        check([1.0, -1.0, 1.0], 1.0, false, gap, [[INF; 3], [-INF; 3]]);
    }

    /// A quadric along the axes and half-spaces, turned together: the box around what they leave, tightly.
    fn check_turned(squares: [f64; 3], linear: f64, constant: f64, planes: [[f64; 4]; 2], expected: [[f64; 3]; 2]) {
        let place = Transform::rotation_deg(DVec3::new(20.0, 130.0, -40.0))
            .then(&Transform::translation(DVec3::new(3.0, -500.0, 70.0)));
        let linear = DVec3::new(0.0, linear, 0.0);
        let quadric = Quadric::new(squares.into(), DVec3::ZERO, linear, constant, false);
        let primitive = Primitive {
            shape: Compiled::Quadric(Box::new(quadric)),
            group_from_local: Some(Box::new(place)),
            inverse: false,
            uv_from_group: None,
            appearance: AppearanceId::default(),
        };
        let turned = planes.map(|[x, y, z, distance]| {
            let normal = DVec3::new(x, y, z);
            let (unit, length) = (place.normal(normal).normalize(), normal.length_squared());
            HalfSpace { normal: unit, distance: unit.dot(place.point(normal * (distance / length))) }
        });
        let found = among(&primitive, &turned, false);
        let expected = Bounds { min: expected[0].into(), max: expected[1].into() };
        if !expected.is_finite() {
            assert_eq!(found, Bounds::INFINITE);
            return;
        }
        let expected = place.bounds(&expected);
        assert!(found.min.cmple(expected.min).all() && found.max.cmpge(expected.max).all(), "{found:?} {expected:?}");
        let excess = (expected.min - found.min).max(found.max - expected.max).max_element();
        assert!(excess < 1e-9, "{found:?} {expected:?}");
    }

    #[test]
    fn turned_quadrics_are_closed_by_planes() {
        let slab = [[0.0, 1.0, 0.0, 2.0], [0.0, -1.0, 0.0, 1.0]];
        // A tube, a cone, and a bowl that needs one plane only.
        check_turned([1.0, 0.0, 1.0], 0.0, -1.0, slab, [[-1.0, -1.0, -1.0], [1.0, 2.0, 1.0]]);
        check_turned([1.0, -1.0, 1.0], 0.0, 0.0, slab, [[-2.0, -1.0, -2.0], [2.0, 2.0, 2.0]]);
        check_turned(
            [1.0, 0.0, 1.0],
            -1.0,
            0.0,
            [slab[0]; 2],
            [[-f64::sqrt(2.0), 0.0, -f64::sqrt(2.0)], [f64::sqrt(2.0), 2.0, f64::sqrt(2.0)]],
        );
        // A slanted plane closes a tube at its highest point.
        let slanted = [[0.6, 0.8, 0.0, 0.8], [0.0, -1.0, 0.0, 1.0]];
        check_turned([1.0, 0.0, 1.0], 0.0, -1.0, slanted, [[-1.0, -1.0, -1.0], [1.0, 1.75, 1.0]]);
        // A tube and a cone that are left open.
        check_turned([1.0, 0.0, 1.0], 0.0, -1.0, [slab[0]; 2], [[-INF; 3], [INF; 3]]);
        check_turned([1.0, -1.0, 1.0], 0.0, 0.0, [slab[0]; 2], [[-INF; 3], [INF; 3]]);
    }
}
