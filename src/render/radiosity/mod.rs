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
mod known_light;
mod pretrace_pass;
mod record;
mod records;

pub(super) use directions::about;
pub(super) use gathering::{Gathering, Phase};
pub use known_light::KnownLight;
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
    /// Before anything was gathered but what is known already.
    pub(super) fn new(settings: &'w Radiosity, known: Option<&KnownLight>) -> Self {
        let mut records = Records::default();
        for (depth, record) in known.into_iter().flat_map(KnownLight::records) {
            records.add(*depth, *record, settings.reach(*depth, record.mean_distance));
        }
        Self { settings, directions: Directions::new(settings.directions), records }
    }

    /// All that was found beside what was known, and that as it came.
    pub(super) fn known_light(&self, before: Option<&KnownLight>) -> KnownLight {
        let mut all = before.cloned().unwrap_or_default();
        for (depth, records) in (0..).zip(self.records.by_depth()) {
            // What was known was filed first.
            let n_known = before.map_or(0, |known| known.records().iter().filter(|(at, _)| *at == depth).count());
            records[n_known..].iter().for_each(|record| all.add(depth, *record));
        }
        all
    }
}
