//! Light sources as a vertex meets them: what is in the way, and what a layer makes of what arrives.

mod area;
mod direct;
mod visibility;

pub(super) use direct::{ArrivingLight, direct_light};
pub(super) use visibility::light_through;
