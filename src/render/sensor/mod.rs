//! The light through image positions: camera rays, one by one or with their neighbours.

mod neighbours;
mod position;

pub(super) use neighbours::{at_grid, at_positions};
pub(super) use position::{at_lens_point, look};
