//! Light between surfaces: what is known of it, and where from.
//!
//! A [`Record`] is the light that falls on one place from everywhere; it is valid nearby, too. [`Records`] finds those that
//! help at a point, and mixes them. [`directions`] says where the rays of a sample go, [`PretracePass`] which rays of the
//! camera look for places before the picture is made. Taking samples is the business of `transport`, since it needs all of it.
//!
//! Source: G. Ward, F. Rubinstein, R. Clear, "A Ray Tracing Solution for Diffuse Interreflection", SIGGRAPH 1988, for the
//! idea; docs/povray/radiosity.md (measured) for every rule.

mod directions;
mod gathering;
mod pretrace_pass;
mod record;
mod records;

pub(super) use directions::about;
pub(super) use gathering::{Gathering, Phase};
pub(super) use pretrace_pass::{PretracePass, passes};
pub(super) use record::{Blend, Question, Record};

use crate::compiled::radiosity::Radiosity;
use directions::Directions;
use records::Records;

/// What all threads know: settings, directions, and records that do not change while rays are on their way.
#[derive(Debug)]
pub(super) struct Shared<'w> {
    pub(super) settings: &'w Radiosity,
    pub(super) directions: Directions,
    pub(super) records: Records,
}

impl<'w> Shared<'w> {
    /// Before anything was gathered.
    pub(super) fn new(settings: &'w Radiosity) -> Self {
        Self { settings, directions: Directions::new(settings.directions), records: Records::default() }
    }
}
