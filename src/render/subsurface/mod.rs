//! What materials do with light below their surfaces.
//!
//! A [`Material`] says how far light gets, and how much of it comes out where; [`sampling`] where to look for light that
//! comes in. Looking is the business of `transport`, since it needs all of it.
//!
//! Source: H. W. Jensen, S. R. Marschner, M. Levoy, P. Hanrahan, "A Practical Model for Subsurface Light Transport",
//! SIGGRAPH 2001; docs/povray/subsurface.md (measured) for every rule.

mod material;
mod sampling;

pub(super) use material::Material;
pub(super) use sampling::{Depths, Directions, Roulette};
