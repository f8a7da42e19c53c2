//! What one thread owns while it renders.

use super::options::Options;
use super::path::Path;
use super::photons::Nearby;
use super::prepare::Prepared;
use super::radiosity::{Gathering, Phase};
use super::statistics::Statistics;
use crate::compiled::World;
use crate::compiled::geometry::{Hit, Scratch};
use crate::compiled::subsurface::Subsurface;
use crate::compiled::texture::Finish;
use crate::math::Rgb;

/// Buffers and counts of one thread, and what it shares with the others.
#[derive(Debug)]
pub(super) struct Worker<'w> {
    pub(super) prepared: &'w Prepared<'w>,
    pub(super) scratch: Scratch,
    pub(super) statistics: Statistics,
    /// Of light between surfaces.
    pub(super) gathering: Gathering,
    /// Photons around a point.
    pub(super) nearby: Nearby,
}

impl<'w> Worker<'w> {
    pub(super) fn new(prepared: &'w Prepared<'w>) -> Self {
        Self {
            prepared,
            scratch: Scratch::default(),
            statistics: Statistics::default(),
            gathering: Gathering::default(),
            nearby: Nearby::default(),
        }
    }

    pub(super) fn world(&self) -> &'w World {
        self.prepared.world
    }

    pub(super) fn options(&self) -> &'w Options {
        self.prepared.options
    }

    /// Weight below which a path ends.
    #[inline]
    pub(super) fn adc_bailout(&self, path: &Path) -> f32 {
        match &self.prepared.radiosity {
            Some(radiosity) if path.bounce > 0 => radiosity.settings.adc_bailout as f32,
            _ => self.prepared.world.settings.adc_bailout,
        }
    }

    /// Level from which on a path goes no farther.
    #[inline]
    pub(super) fn max_level(&self, path: &Path) -> u32 {
        let most = self.prepared.world.settings.max_trace_level;
        self.prepared.radiosity.as_ref().map_or(most, |radiosity| radiosity.settings.max_level(path.bounce, most))
    }

    /// What a surface with this finish gives without any light.
    #[inline]
    pub(super) fn own_light(&self, finish: &Finish) -> Rgb {
        match &self.prepared.radiosity {
            Some(radiosity) if radiosity.settings.replaces_ambient => finish.emission,
            _ => finish.own_light,
        }
    }

    /// Whether fog, rainbows and media lie on a path.
    #[inline]
    pub(super) fn has_air(&self, path: &Path) -> bool {
        let passes = || path.bounce == 0 || self.prepared.radiosity.as_ref().is_some_and(|r| r.settings.media);
        self.prepared.has_air && passes()
    }

    /// How light below surfaces is sampled, where it counts at the end of a path.
    #[inline]
    pub(super) fn subsurface(&self, path: &Path) -> Option<&'w Subsurface> {
        let seen = || path.bounce == 0 || self.prepared.radiosity.as_ref().is_some_and(|r| r.settings.subsurface);
        self.prepared.subsurface.filter(|_| seen())
    }

    /// Whether it matters what lights give at the end of a path: where only places are looked for, it does not.
    #[inline]
    pub(super) fn wants_lights(&self, path: &Path) -> bool {
        (path.bounce > 0 || self.gathering.phase == Phase::Picture) && !path.kind.is_photon()
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
