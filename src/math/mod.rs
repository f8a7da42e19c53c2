//! Vectors, transforms, rays, bounds, polynomial roots and their error bounds.
//!
//! Geometry is `f64` throughout; colours are `f32`, as in POV-Ray.
//!
//! ```
//! use whitted::math::{DVec3, Transform};
//! let turned = Transform::rotation_deg(DVec3::new(0.0, 0.0, 90.0)).then(&Transform::translation(DVec3::X));
//! assert!((turned.point(DVec3::X) - DVec3::new(1.0, 1.0, 0.0)).length() < 1e-15);
//! ```

mod bounds;
mod color;
mod error_bound;
mod floor;
pub(crate) mod lanes;
mod lattice;
mod lattice_points;
mod mersenne_twister;
pub mod noise;
mod noise_table;
mod order;
mod points;
mod power;
mod ray;
mod roots;
pub(crate) mod sine;
mod transform;
mod unit;
mod uv;

pub use bounds::Bounds;
pub use color::{Color, Rgb, gray};
pub use error_bound::{dot_error, gamma, transformed_point_error};
pub use floor::{floor, floor_small, fraction, modulo, round, round_to_even};
pub use glam::{DAffine3, DMat3, DVec2, DVec3, DVec4};
pub use mersenne_twister::MersenneTwister;
pub use order::{greater, lesser};
pub use points::{LANES, Points, each_lane};
pub use power::power;
pub use ray::{Range, Ray};
pub use roots::{MAX_DEGREE, Roots, discriminant, quadratic_roots, root_bound, roots_in};
pub use transform::{SingularMatrix, Transform};
pub use unit::unit;
pub use uv::{Uv, full_turn_angle, spherical_uv};
