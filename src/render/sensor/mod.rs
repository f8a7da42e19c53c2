//! The light through image positions: camera rays, one by one or with their neighbours.

mod neighbours;
mod position;
mod told;

pub(super) use neighbours::{at_grid, at_positions};
pub(super) use position::{at_lens_point, look};
pub(super) use told::told_at;
