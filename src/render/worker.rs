//! What one thread owns while it renders.

use super::options::Options;
use super::path::Path;
use super::prepare::Prepared;
use super::statistics::Statistics;
use crate::compiled::World;
use crate::compiled::geometry::{Hit, Scratch};

/// Buffers and counts of one thread, and what it shares with the others.
#[derive(Debug)]
pub(super) struct Worker<'w> {
    pub(super) prepared: &'w Prepared<'w>,
    pub(super) scratch: Scratch,
    pub(super) statistics: Statistics,
}

impl<'w> Worker<'w> {
    pub(super) fn new(prepared: &'w Prepared<'w>) -> Self {
        Self { prepared, scratch: Scratch::default(), statistics: Statistics::default() }
    }

    pub(super) fn world(&self) -> &'w World {
        self.prepared.world
    }

    pub(super) fn options(&self) -> &'w Options {
        self.prepared.options
    }

    /// The nearest hit of a path.
    #[inline(always)]
    pub(super) fn intersect(&mut self, path: &Path) -> Option<Hit> {
        self.prepared.world.geometry.intersect(&path.ray, path.range, path.kind, &mut self.scratch)
    }

    /// The counts so far, which start anew.
    pub(super) fn take_statistics(&mut self) -> Statistics {
        std::mem::take(&mut self.statistics)
    }
}
