//! Light sources as a vertex meets them: what is in the way, and what a layer makes of what arrives.

mod area;
mod caustics;
mod direct;
mod visibility;

pub(super) use caustics::Caustics;
pub(super) use direct::{ArrivingLight, direct_light};
pub(super) use visibility::{light_through, surface_transmittance};
