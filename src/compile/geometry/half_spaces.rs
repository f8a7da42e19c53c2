//! The box around what half-spaces leave: planes that close a solid bound it, however they are turned.
//!
//! Along each axis the farthest point is the answer of a linear programme in three unknowns. Its dual is walked by
//! the simplex method: three half-spaces with weights that add up to the axis. Whatever three it ends with are a
//! proof of a bound, so that rounding and an early end cost tightness and never correctness.
//! Source: Chvátal, Linear Programming, 1983, chapter 10 (the dual simplex method).

use super::quadric_reach;
use crate::compiled::geometry::{Geometry, Node, NodeId, NodeKind, Operation, PLANE_BOUNDARY, Shape, padded};
use crate::math::{Bounds, DVec3, gamma};
use glam::DMat3;

/// All points with `normal` · p <= `distance`; the normal is a unit vector.
#[derive(Clone, Copy, Debug)]
pub(super) struct HalfSpace {
    pub(super) normal: DVec3,
    pub(super) distance: f64,
}

/// So many half-spaces of nested parts are taken in beside those of the children themselves.
const MOST_NESTED: usize = 64;

/// Makes a node's boxes as small as the planes among its parts and clips allow.
pub(super) fn tighten(geometry: &Geometry, node: &mut Node) {
    let mut around = Vec::new();
    if let NodeKind::Csg { operation: Operation::Intersection, children, .. } = &node.kind {
        children.iter().for_each(|child| collect(geometry, *child, &mut around));
    }
    node.clips.iter().for_each(|clip| collect(geometry, *clip, &mut around));
    close_quadrics(geometry, node, &around);
    let is_slanted = |h: &HalfSpace| !DVec3::AXES.contains(&h.normal.abs());
    if !around.iter().any(is_slanted) {
        // The boxes of the parts say the same.
        return;
    }
    let within = |own: &Bounds, others: &[HalfSpace]| {
        let all: Vec<_> = others.iter().copied().chain(sides(own)).collect();
        own.intersection(&padded(bounds(&all)))
    };
    node.extent = within(&node.extent, &around);
    if let NodeKind::Primitive(p) = node.kind
        && let Shape::Plane(plane) = &geometry.primitives[p].shape
    {
        around.extend([plane.normal, -plane.normal].map(|normal| {
            let distance = normal.dot(plane.normal) * plane.distance + PLANE_BOUNDARY;
            HalfSpace { normal, distance }
        }));
    }
    node.bounds = within(&node.bounds, &around);
}

/// Makes an open node's boxes as small as its quadrics allow among half-spaces.
fn close_quadrics(geometry: &Geometry, node: &mut Node, around: &[HalfSpace]) {
    if node.extent.is_finite() && node.bounds.is_finite() {
        return;
    }
    match &node.kind {
        NodeKind::Primitive(p) => {
            let among = |surface_only| quadric_reach::among(&geometry.primitives[*p], around, surface_only);
            node.extent = node.extent.intersection(&among(false));
            node.bounds = node.bounds.intersection(&among(true));
        }
        NodeKind::Csg { operation: Operation::Intersection, children, .. } => {
            for child in children {
                if let NodeKind::Primitive(p) = geometry.nodes[*child].kind {
                    let among = quadric_reach::among(&geometry.primitives[p], around, false);
                    node.extent = node.extent.intersection(&among);
                }
            }
            // What survives is within all parts.
            node.bounds = node.bounds.intersection(&node.extent);
        }
        NodeKind::Csg { .. } => {}
    }
}

/// Half-spaces in which a node is inside, as far as planes and boxes say so.
fn collect(geometry: &Geometry, id: NodeId, around: &mut Vec<HalfSpace>) {
    let node = &geometry.nodes[id];
    match &node.kind {
        NodeKind::Primitive(p) => match &geometry.primitives[*p].shape {
            Shape::Plane(plane) => {
                around.push(HalfSpace { normal: plane.normal, distance: plane.distance + PLANE_BOUNDARY });
            }
            _ => around.extend(sides(&node.extent)),
        },
        NodeKind::Csg { operation: Operation::Intersection, children, .. }
            if !node.extent.is_finite() && around.len() < MOST_NESTED =>
        {
            children.iter().for_each(|child| collect(geometry, *child, around));
        }
        NodeKind::Csg { .. } => around.extend(sides(&node.extent)),
    }
    if !node.extent.is_finite() && around.len() < MOST_NESTED {
        node.clips.iter().for_each(|clip| collect(geometry, *clip, around));
    }
}

/// The finite sides of a box that is not empty.
fn sides(b: &Bounds) -> impl Iterator<Item = HalfSpace> {
    let pairs = DVec3::AXES.into_iter().zip(b.min.to_array().into_iter().zip(b.max.to_array()));
    let both = pairs.flat_map(|(axis, (min, max))| {
        [HalfSpace { normal: axis, distance: max }, HalfSpace { normal: -axis, distance: -min }]
    });
    both.filter(|side| side.distance.is_finite())
}

/// A proof that `direction` · p <= `value` + `doubt` · |p| (largest coordinate) for all p in some half-spaces.
#[derive(Clone, Copy, Debug)]
struct Proof {
    value: f64,
    doubt: f64,
}

/// A box around all points that are in all half-spaces; infinite if they leave a direction open.
pub(super) fn bounds(half_spaces: &[HalfSpace]) -> Bounds {
    let upper = DVec3::AXES.map(|axis| farthest(half_spaces, axis));
    let lower = DVec3::AXES.map(|axis| farthest(half_spaces, -axis));
    let (mut value, mut doubt) = (0.0_f64, 0.0_f64);
    for proof in upper.iter().chain(&lower) {
        let Some(proof) = proof else { return Bounds::INFINITE };
        (value, doubt) = (value.max(proof.value), doubt.max(proof.doubt));
    }
    // The largest coordinate is at most value + doubt times itself.
    let largest = value / (1.0 - doubt);
    let end = |proof: Option<Proof>| proof.map_or(f64::INFINITY, |p| p.value + p.doubt * largest);
    Bounds { min: DVec3::from(lower.map(|proof| -end(proof))), max: DVec3::from(upper.map(end)) }
}

/// How far points in all half-spaces reach along a direction of unit length; `None` for no end.
fn farthest(half_spaces: &[HalfSpace], direction: DVec3) -> Option<Proof> {
    /// Doubt beyond which a proof is none: some of its weight lies on the far ends that only start the search.
    const MOST_DOUBT: f64 = 1e-6;
    let scale = half_spaces.iter().fold(f64::MIN_POSITIVE, |most, h| most.max(h.distance.abs()));
    let mut basis = Basis::far_off(direction, scale);
    // More steps than this are a sign of going in a circle.
    for _ in 0..4 * half_spaces.len() + 8 {
        let Some(next) = basis.improved(half_spaces, direction, scale) else { break };
        basis = next;
    }
    let proof = basis.proof(direction);
    (proof.doubt < MOST_DOUBT).then_some(proof)
}

/// Three half-spaces whose normals span space, with weights of at least zero that make them add up to a direction.
#[derive(Clone, Copy, Debug)]
struct Basis {
    members: [HalfSpace; 3],
    /// Members that are none of the solid's.
    artificial: [bool; 3],
}

impl Basis {
    /// Far ends in all directions, in units of all distances.
    const FAR: f64 = 1e6;

    fn far_off(direction: DVec3, scale: f64) -> Self {
        let towards = |axis: DVec3| if axis.dot(direction) < 0.0 { -axis } else { axis };
        let members = DVec3::AXES.map(|axis| HalfSpace { normal: towards(axis), distance: Self::FAR * scale });
        Self { members, artificial: [true; 3] }
    }

    /// Columns are the normals; a direction becomes weights.
    fn weights_from_direction(&self) -> DMat3 {
        let [a, b, c] = self.members.map(|h| h.normal);
        DMat3::from_cols(a, b, c).inverse()
    }

    /// With the half-space that cuts off most of what this one leaves farthest; `None` at the end.
    fn improved(&self, half_spaces: &[HalfSpace], direction: DVec3, scale: f64) -> Option<Self> {
        /// What is cut off by less, in units of all distances, is left to rounding; so are slopes.
        const NOTHING: f64 = 1e-13;
        let inverse = self.weights_from_direction();
        let corner = inverse.transpose() * DVec3::from(self.members.map(|h| h.distance));
        let cut = |h: &HalfSpace| h.normal.dot(corner) - h.distance;
        let entering = half_spaces.iter().max_by(|a, b| cut(a).total_cmp(&cut(b)))?;
        let most = cut(entering);
        if most.is_nan() || most <= NOTHING * scale {
            return None;
        }
        let (weights, shares) = (inverse * direction, inverse * entering.normal);
        let candidates = (0..3).filter(|i| shares[*i] > NOTHING.sqrt());
        let ratio = |i: &usize| weights[*i].max(0.0) / shares[*i];
        let leaving = candidates.min_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
        let mut next = *self;
        next.members[leaving] = *entering;
        next.artificial[leaving] = false;
        Some(next)
    }

    /// What it proves.
    fn proof(&self, direction: DVec3) -> Proof {
        let weights = self.weights_from_direction() * direction;
        let mut proof = Proof { value: 0.0, doubt: 0.0 };
        let (mut sum, mut total, mut terms) = (DVec3::ZERO, 0.0, 0.0);
        for (i, h) in self.members.iter().enumerate() {
            let weight = if self.artificial[i] { 0.0 } else { weights[i].max(0.0) };
            proof.value += weight * h.distance;
            sum += weight * h.normal;
            terms += weight * h.distance.abs();
            total += weight;
        }
        proof.value += gamma(16) * terms;
        // What the weights leave of the direction, and what inside tests and sums round by.
        let rest = (direction - sum).abs().element_sum();
        proof.doubt = rest + gamma(64) * (1.0 + total);
        // NaN, of normals that do not span space, proves nothing.
        if proof.doubt.is_nan() || proof.value.is_nan() {
            proof.doubt = f64::INFINITY;
        }
        proof
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{MersenneTwister, Transform};

    /// A box's sides, turned: the box around its corners, tightly.
    fn check(half_spaces: &[HalfSpace], corners: &[DVec3]) {
        let expected = Bounds::around(corners.iter().copied());
        let found = bounds(half_spaces);
        let slack = 1e-9 * expected.min.abs().max(expected.max.abs()).max_element();
        assert!(found.min.cmple(expected.min).all() && found.max.cmpge(expected.max).all(), "{found:?} {expected:?}");
        assert!((expected.min - found.min).max_element() <= slack, "{found:?} {expected:?}");
        assert!((found.max - expected.max).max_element() <= slack, "{found:?} {expected:?}");
    }

    fn moved(place: &Transform, half_spaces: impl Iterator<Item = HalfSpace>) -> Vec<HalfSpace> {
        let one = |h: HalfSpace| {
            let normal = place.normal(h.normal).normalize();
            HalfSpace { normal, distance: normal.dot(place.point(h.normal * h.distance)) }
        };
        half_spaces.map(one).collect()
    }

    #[test]
    fn turned_planes_close_a_solid() {
        let mut twister = MersenneTwister::default();
        let mut random = || 2.0 * twister.next_f64() - 1.0;
        for i in 0..200 {
            let mut vector = || DVec3::new(random(), random(), random());
            let unit = Bounds { min: DVec3::NEG_ONE, max: DVec3::new(2.0, 1e-3, 1.0) };
            let turn = Transform::rotation_deg(vector() * 360.0)
                .then(&Transform::translation(vector() * 10f64.powi(i % 7 - 3)));
            let corner = |k: usize| {
                let pick = |axis: usize| if k >> axis & 1 == 0 { unit.min[axis] } else { unit.max[axis] };
                turn.point(DVec3::new(pick(0), pick(1), pick(2)))
            };
            let corners: Vec<_> = (0..8).map(corner).collect();
            check(&moved(&turn, sides(&unit)), &corners);
        }
    }

    #[test]
    fn an_open_solid_has_no_bounds() {
        let turn = Transform::rotation_deg(DVec3::new(20.0, 30.0, 40.0));
        let open = Bounds { min: DVec3::NEG_ONE, max: DVec3::new(1.0, 1.0, f64::INFINITY) };
        assert_eq!(bounds(&moved(&turn, sides(&open))), Bounds::INFINITE);
        assert_eq!(bounds(&[]), Bounds::INFINITE);
    }

    #[test]
    fn a_sphere_of_planes_is_bounded_tightly() {
        let n = 500;
        let on_sphere = |i: usize| {
            let (z, angle) = (1.0 - (2 * i + 1) as f64 / f64::from(n), 2.4 * i as f64);
            let r = (1.0 - z * z).sqrt();
            DVec3::new(r * angle.cos(), r * angle.sin(), z)
        };
        let around: Vec<_> = (0..n as usize).map(|i| HalfSpace { normal: on_sphere(i), distance: 1.0 }).collect();
        let found = bounds(&around);
        assert!(found.min.cmple(DVec3::NEG_ONE).all() && found.max.cmpge(DVec3::ONE).all(), "{found:?}");
        assert!(found.max.max_element() < 1.05 && found.min.min_element() > -1.05, "{found:?}");
    }
}
