//! Where surfaces given by functions are looked for.

use crate::math::{Bounds, DVec3, Ray, quadratic_roots};

/// A box or a sphere.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Container {
    Box(Bounds),
    Sphere { center: DVec3, radius: f64 },
}

impl Container {
    /// The box around it.
    pub(crate) fn bounds(&self) -> Bounds {
        match self {
            Self::Box(bounds) => *bounds,
            Self::Sphere { center, radius } => {
                let half = DVec3::splat(radius.abs());
                Bounds { min: *center - half, max: *center + half }
            }
        }
    }

    /// Whether a length of a ray's parameter, so many times as long in here, is a good part of the container. Only what has
    /// been made smaller can get there.
    pub(super) fn is_coarse(&self, length: f64, speed: f64) -> bool {
        /// Parts of a container that can be told apart, at least.
        const FEWEST_PARTS: f64 = 64.0;
        speed > 1.0 && length * speed * FEWEST_PARTS > self.bounds().size().max_element()
    }

    /// Whether the point is inside or on the boundary.
    pub(super) fn contains(&self, p: DVec3) -> bool {
        match self {
            Self::Box(bounds) => bounds.contains(p),
            Self::Sphere { center, radius } => p.distance_squared(*center) <= radius * radius,
        }
    }

    /// Where the whole line of a ray is inside; `None` if it passes by.
    pub(super) fn interval(&self, ray: &Ray) -> Option<(f64, f64)> {
        let (low, high) = match self {
            Self::Box(bounds) => slabs(bounds, ray),
            Self::Sphere { center, radius } => {
                let (o, d) = (ray.origin - *center, ray.direction);
                let [low, high] =
                    quadratic_roots(d.length_squared(), 2.0 * o.dot(d), o.length_squared() - radius * radius)?;
                (low, high)
            }
        };
        (low <= high && (high - low).is_finite()).then_some((low, high))
    }

    /// Outward normal of the boundary near a point on it, with the point moved onto it.
    pub(super) fn boundary(&self, p: DVec3) -> (DVec3, DVec3) {
        match self {
            Self::Box(bounds) => {
                let faces = (0..3).flat_map(|axis| [(axis, bounds.min[axis], -1.0), (axis, bounds.max[axis], 1.0)]);
                let miss = |(axis, at, _): &(usize, f64, f64)| (p[*axis] - at).abs();
                let nearest = faces.min_by(|a, b| miss(a).total_cmp(&miss(b)));
                let (axis, at, side) = nearest.unwrap_or((0, p.x, 1.0));
                let mut on_face = p;
                on_face[axis] = at;
                (on_face, DVec3::AXES[axis] * side)
            }
            Self::Sphere { center, radius } => {
                let normal = (p - *center).normalize_or(DVec3::X);
                (*center + normal * *radius, normal)
            }
        }
    }
}

/// The part of a line between the three pairs of faces; empty (low above high) where there is none.
fn slabs(bounds: &Bounds, ray: &Ray) -> (f64, f64) {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        if d == 0.0 {
            if o < bounds.min[axis] || o > bounds.max[axis] {
                return (f64::INFINITY, f64::NEG_INFINITY);
            }
            continue;
        }
        let (t0, t1) = ((bounds.min[axis] - o) / d, (bounds.max[axis] - o) / d);
        low = low.max(t0.min(t1));
        high = high.min(t0.max(t1));
    }
    (low, high)
}
