//! Affine maps that carry their inverse along.

use super::{Bounds, DAffine3, DMat3, DVec3, Ray};

/// An invertible affine map, with its inverse.
///
/// Named for what it turns into what: a variable `parent_from_local` takes local
/// points to the parent's space through [`point`](Self::point), and rays back down
/// through [`inverse_ray`](Self::inverse_ray). Columns are images of the axes, so
/// POV-Ray's row-vector matrix is the transpose of ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    forward: DAffine3,
    backward: DAffine3,
}

/// A matrix that has no inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularMatrix;

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self { forward: DAffine3::IDENTITY, backward: DAffine3::IDENTITY };

    /// Moves points by `offset`; vectors stay.
    pub fn translation(offset: DVec3) -> Self {
        Self { forward: DAffine3::from_translation(offset), backward: DAffine3::from_translation(-offset) }
    }

    /// Scales along the axes. A zero component must have been replaced before (POV-Ray makes it 1).
    pub fn scaling(factors: DVec3) -> Self {
        Self { forward: DAffine3::from_scale(factors), backward: DAffine3::from_scale(factors.recip()) }
    }

    /// Rotates about x, then y, then z, in degrees, by the left-hand rule (y to z, z to x, x to y).
    pub fn rotation_deg(angles: DVec3) -> Self {
        let about = |axis: usize, degrees: f64| {
            // Quarter turns are exact, as scenes that build on them expect.
            let (sin, cos) = match degrees.rem_euclid(360.0) {
                0.0 => (0.0, 1.0),
                90.0 => (1.0, 0.0),
                180.0 => (0.0, -1.0),
                270.0 => (-1.0, 0.0),
                _ => degrees.to_radians().sin_cos(),
            };
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut columns = [DVec3::X, DVec3::Y, DVec3::Z];
            columns[i][i] = cos;
            columns[i][j] = sin;
            columns[j][i] = -sin;
            columns[j][j] = cos;
            DMat3::from_cols(columns[0], columns[1], columns[2])
        };
        let linear = about(2, angles.z) * about(1, angles.y) * about(0, angles.x);
        Self { forward: DAffine3::from_mat3(linear), backward: DAffine3::from_mat3(linear.transpose()) }
    }

    /// From the images of the three axes and of the origin.
    ///
    /// # Errors
    /// [`SingularMatrix`] when the axes' images do not span space, or anything is not finite.
    pub fn from_columns(x: DVec3, y: DVec3, z: DVec3, origin: DVec3) -> Result<Self, SingularMatrix> {
        let forward = DAffine3 { matrix3: DMat3::from_cols(x, y, z), translation: origin };
        let backward = forward.inverse();
        if forward.is_finite() && backward.is_finite() { Ok(Self { forward, backward }) } else { Err(SingularMatrix) }
    }

    /// A turn or mirroring about the origin, whose inverse is its transpose; `None` for anything else.
    pub fn turning(linear: DMat3) -> Option<Self> {
        /// Far above the rounding of turns, however many were put together, and far below any turn that is none.
        const ROUNDING: f64 = 1e-9;
        let rest = linear.transpose() * linear - DMat3::IDENTITY;
        let is_turn = rest.to_cols_array().iter().all(|v| v.abs() < ROUNDING);
        let (forward, backward) = (DAffine3::from_mat3(linear), DAffine3::from_mat3(linear.transpose()));
        is_turn.then_some(Self { forward, backward })
    }

    /// From both ways, as they were found before.
    ///
    /// # Errors
    /// [`SingularMatrix`] when one is not finite, or so far from the inverse of the other that it cannot have been.
    pub fn from_both_ways(forward: DAffine3, backward: DAffine3) -> Result<Self, SingularMatrix> {
        let known = Self { forward, backward };
        let mut refined = backward;
        let fits = forward.is_finite() && backward.is_finite() && refine(&forward, &mut refined).is_some();
        if fits { Ok(known) } else { Err(SingularMatrix) }
    }

    /// First `self`, then `next`: the order in which a scene file writes them.
    ///
    /// However many are put together, each way stays the inverse of the other to the last bits: what a ray meets on its
    /// way down must be where it leaves on its way up.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        if self.is_identity() {
            return *next;
        }
        if next.is_identity() {
            return *self;
        }
        let both = self.then_once(next);
        // Translations round alike on both ways.
        let only_move = self.forward.matrix3 == DMat3::IDENTITY && next.forward.matrix3 == DMat3::IDENTITY;
        if only_move { both } else { both.settled() }
    }

    /// The same where speed counts and no more is put together: errors of both ways are on their own.
    #[must_use]
    pub(crate) fn then_once(&self, next: &Self) -> Self {
        Self { forward: next.forward * self.forward, backward: self.backward * next.backward }
    }

    /// With the way back made anew from the way there, by a step of Newton's iteration: it squares what is left of
    /// forward · backward - 1, which is worked out in twice the precision.
    ///
    /// Source: Higham, Accuracy and Stability of Numerical Algorithms, sections 12.1 and 14.5.
    fn settled(self) -> Self {
        /// Its square is below the rounding of the result.
        const SMALL: f64 = 1e-8;
        let Self { forward, mut backward } = self;
        let mut rest = refine(&forward, &mut backward);
        if rest.is_none() {
            // Too far off for the iteration: stretches have cancelled each other that are as large as 1/rounding.
            backward = forward.inverse();
            rest = refine(&forward, &mut backward);
        }
        if rest.is_some_and(|rest| rest > SMALL) {
            refine(&forward, &mut backward);
        }
        // What has no inverse at all keeps the one that it was put together from.
        Self { forward, backward: if backward.is_finite() { backward } else { self.backward } }
    }

    /// The map the other way round.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { forward: self.backward, backward: self.forward }
    }

    /// Whether nothing moves, exactly.
    pub fn is_identity(&self) -> bool {
        self.forward == DAffine3::IDENTITY
    }

    /// The linear part: columns are the images of the axes.
    pub fn linear(&self) -> DMat3 {
        self.forward.matrix3
    }

    /// The inverse alone.
    pub fn inverse_affine(&self) -> DAffine3 {
        self.backward
    }

    /// The linear part of the inverse.
    pub fn inverse_linear(&self) -> DMat3 {
        self.backward.matrix3
    }

    /// The image of the origin.
    pub fn origin(&self) -> DVec3 {
        self.forward.translation
    }

    /// Carries a point forward.
    pub fn point(&self, p: DVec3) -> DVec3 {
        self.forward.transform_point3(p)
    }

    /// Carries a displacement forward.
    pub fn vector(&self, v: DVec3) -> DVec3 {
        self.forward.transform_vector3(v)
    }

    /// Carries a surface normal forward, by the inverse transpose; not normalised.
    pub fn normal(&self, n: DVec3) -> DVec3 {
        let m = &self.backward.matrix3;
        DVec3::new(m.x_axis.dot(n), m.y_axis.dot(n), m.z_axis.dot(n))
    }

    /// Carries a point backward.
    pub fn inverse_point(&self, p: DVec3) -> DVec3 {
        self.backward.transform_point3(p)
    }

    /// Carries a displacement backward.
    pub fn inverse_vector(&self, v: DVec3) -> DVec3 {
        self.backward.transform_vector3(v)
    }

    /// Carries a surface normal backward, by the transpose; not normalised.
    pub fn inverse_normal(&self, n: DVec3) -> DVec3 {
        let m = &self.forward.matrix3;
        DVec3::new(m.x_axis.dot(n), m.y_axis.dot(n), m.z_axis.dot(n))
    }

    /// Carries a ray backward, from the parent's space to the local one; `t` keeps its meaning.
    pub fn inverse_ray(&self, ray: &Ray) -> Ray {
        Ray { origin: self.inverse_point(ray.origin), direction: self.inverse_vector(ray.direction) }
    }

    /// The box around the image of a box.
    pub fn bounds(&self, local: &Bounds) -> Bounds {
        local.transformed(self)
    }
}

/// Squares the error of `backward` as the inverse of `forward`, and tells what it was; does nothing if it is near 1.
fn refine(forward: &DAffine3, backward: &mut DAffine3) -> Option<f64> {
    let f = &forward.matrix3;
    let rows = [f.row(0), f.row(1), f.row(2)];
    // What is missing of a column's image.
    let missing = |column: DVec3, wanted: DVec3, moved: DVec3| {
        let coordinate = |i: usize| {
            let row = rows[i];
            -accurate_sum([(row.x, column.x), (row.y, column.y), (row.z, column.z), (moved[i], 1.0), (wanted[i], -1.0)])
        };
        DVec3::new(coordinate(0), coordinate(1), coordinate(2))
    };
    let b = &backward.matrix3;
    let rest = DMat3::from_cols(
        missing(b.x_axis, DVec3::X, DVec3::ZERO),
        missing(b.y_axis, DVec3::Y, DVec3::ZERO),
        missing(b.z_axis, DVec3::Z, DVec3::ZERO),
    );
    // Of a matrix whose columns sum up to less than one the powers vanish. No number is no such sum.
    let sums = [rest.x_axis, rest.y_axis, rest.z_axis].map(|column| column.abs().element_sum());
    if !sums.iter().all(|sum| *sum < 0.5) {
        return None;
    }
    let moved = missing(backward.translation, DVec3::ZERO, forward.translation);
    *backward = DAffine3 { matrix3: *b + *b * rest, translation: backward.translation + *b * moved };
    Some(sums[0].max(sums[1]).max(sums[2]))
}

/// A sum of products as if worked out in twice the precision, then rounded.
///
/// Source: Ogita, Rump, Oishi, Accurate sum and dot product, 2005, algorithm 5.3.
fn accurate_sum<const N: usize>(products: [(f64, f64); N]) -> f64 {
    let (mut sum, mut rest) = (0.0_f64, 0.0_f64);
    for (a, b) in products {
        let product = a * b;
        rest += a.mul_add(b, -product);
        let next = sum + product;
        let part = next - sum;
        rest += (sum - (next - part)) + (product - part);
        sum = next;
    }
    sum + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Probes of the language facts, section 16: extents of the box <0,0,0>,<1,2,3>.
    fn check(transform: &Transform, min: [f64; 3], max: [f64; 3]) {
        let moved = transform.bounds(&Bounds::from_corners(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0)));
        assert!((moved.min - DVec3::from(min)).abs().max_element() < 1e-12, "{moved:?}");
        assert!((moved.max - DVec3::from(max)).abs().max_element() < 1e-12, "{moved:?}");
    }

    #[test]
    fn transforms_compose_in_written_order() {
        let (quarter, shift) = (Transform::rotation_deg(DVec3::Z * 90.0), Transform::translation(DVec3::X));
        check(&quarter, [-2.0, 0.0, 0.0], [0.0, 1.0, 3.0]);
        check(&shift.then(&quarter), [-2.0, 1.0, 0.0], [0.0, 2.0, 3.0]);
        check(&quarter.then(&shift), [-1.0, 0.0, 0.0], [1.0, 1.0, 3.0]);
        check(&shift.then(&quarter).inverse(), [-1.0, -1.0, 0.0], [1.0, 0.0, 3.0]);
        check(&Transform::rotation_deg(DVec3::splat(90.0)), [0.0, 0.0, -1.0], [3.0, 2.0, 0.0]);
    }

    #[test]
    fn normals_stay_perpendicular_to_the_surface() {
        let t =
            Transform::scaling(DVec3::new(1.0, 2.0, 5.0)).then(&Transform::rotation_deg(DVec3::new(10.0, 20.0, 30.0)));
        let (tangent, normal) = (DVec3::new(1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 0.3));
        assert!(t.vector(tangent).dot(t.normal(normal)).abs() < 1e-14);
        assert!((t.inverse_normal(t.normal(normal)) - normal).length() < 1e-14);
    }

    #[test]
    fn ways_there_and_back_stay_inverse_however_many_are_put_together() {
        let rest = |t: &Transform| {
            let p = DVec3::new(0.3, -0.7, 0.9);
            (t.inverse_point(t.point(p)) - p).abs().max_element()
        };
        let turn = Transform::rotation_deg(DVec3::new(7.0, 11.0, 2.52));
        let step = turn.then(&Transform::translation(DVec3::new(0.3, -0.1, 0.2)));
        let many = (0..10_000).fold(Transform::IDENTITY, |all, _| all.then(&step));
        assert!(rest(&many) < 1e-12, "{}", rest(&many));
        let slanted = |s: f64| turn.then(&Transform::scaling(DVec3::new(s, 1.0, 1.0))).then(&turn.inverse());
        for exponent in 1..=12 {
            let stretch = 10f64.powi(exponent);
            let back = slanted(stretch).then(&slanted(1.0 / stretch));
            assert!(rest(&back) < 1e-14, "10^{exponent}: {}", rest(&back));
        }
    }

    #[test]
    fn sums_are_as_good_as_in_twice_the_precision() {
        assert_eq!(accurate_sum([(1e16, 1.0), (0.1, 0.1), (-1e16, 1.0)]), 0.1 * 0.1);
        let step = f64::EPSILON;
        assert_eq!(accurate_sum([(1.0 + step, 1.0 - step), (-1.0, 1.0)]), -step * step);
    }

    #[test]
    fn singular_matrices_are_refused() {
        assert_eq!(Transform::from_columns(DVec3::X, DVec3::X, DVec3::Z, DVec3::ZERO), Err(SingularMatrix));
    }
}
