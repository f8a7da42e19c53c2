//! Vectors of length 1.

use super::DVec3;

/// A vector in the same direction with length 1, also where the square of its length is out of range; `None` without a
/// direction.
pub fn unit(v: DVec3) -> Option<DVec3> {
    if v.length_squared().is_normal() { v.try_normalize() } else { (v / v.abs().max_element()).try_normalize() }
}
