//! Rounding error bounds, as functions of the numbers at hand.
//!
//! Source: Higham, Accuracy and Stability of Numerical Algorithms, section 3.1; Pharr, Jakob,
//! Humphreys, Physically Based Rendering, 3rd ed., section 3.9.
//!
//! ```
//! use whitted::math::gamma;
//! assert!(gamma(3) > 3.0 * f64::EPSILON / 2.0);
//! ```

use super::{DMat3, DVec3, Transform};

/// Bound of the relative error after `n` roundings: n u / (1 - n u) with u = 2^-53.
pub const fn gamma(n: u32) -> f64 {
    let nu = n as f64 * (f64::EPSILON / 2.0);
    nu / (1.0 - nu)
}

/// The largest stretch of any axis by more than its true norm: the largest absolute row sum.
fn row_sum_norm(m: &DMat3) -> f64 {
    (m.x_axis.abs() + m.y_axis.abs() + m.z_axis.abs()).max_element()
}

/// Bound of a point's distance from where it should be, after it went through `parent_from_local`.
///
/// `error` bounds it before. Covers the rounding of the map itself (three products, three sums a
/// coordinate) and that of the way back, which the next ray from this point will take.
pub fn transformed_point_error(parent_from_local: &Transform, point_local: DVec3, error: f64) -> f64 {
    let (forward, backward) = (parent_from_local.linear(), parent_from_local.inverse_linear());
    let stretch = row_sum_norm(&forward);
    let reach = stretch * point_local.abs().max_element() + parent_from_local.origin().abs().max_element();
    let way_back = row_sum_norm(&backward) * reach;
    // sqrt(3) turns a bound of each coordinate into one of the length.
    1.7321 * (stretch * error + gamma(6) * reach + stretch * gamma(6) * way_back)
}

/// Bound of the error of `a.dot(b)` for exact inputs: six roundings at most.
pub fn dot_error(a: DVec3, b: DVec3) -> f64 {
    gamma(6) * a.abs().dot(b.abs())
}
