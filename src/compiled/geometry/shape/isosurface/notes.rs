//! What rays find out about an isosurface while the picture is made.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Collected by all threads; only sums that do not depend on their order.
#[derive(Debug, Default)]
pub(crate) struct SearchNotes {
    /// Steepest slope between two samples, as the bits of a number that is not negative: these are
    /// in the numbers' order.
    steepest: AtomicU64,
    lost: AtomicBool,
}

impl SearchNotes {
    /// Notes one ray's search: its steepest slope, and whether `max_gradient` would have lost a hit.
    pub(crate) fn add(&self, slope: f64, lost: bool) {
        if slope.to_bits() > self.steepest.load(Ordering::Relaxed) && slope.is_finite() {
            self.steepest.fetch_max(slope.to_bits(), Ordering::Relaxed);
        }
        if lost && !self.lost.load(Ordering::Relaxed) {
            self.lost.store(true, Ordering::Relaxed);
        }
    }

    /// The steepest slope that any ray met.
    pub(crate) fn steepest(&self) -> f64 {
        f64::from_bits(self.steepest.load(Ordering::Relaxed))
    }

    /// Whether a search that believes `max_gradient` would have lost surface.
    pub(crate) fn lost(&self) -> bool {
        self.lost.load(Ordering::Relaxed)
    }
}
