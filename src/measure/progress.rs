//! How far a report has come.

use std::cell::Cell;

/// Told how a report comes along.
pub trait Watcher {
    /// What is done now.
    fn begins(&self, what: &str);
    /// So much of the work is behind; both in the same unit, about as long as it takes.
    fn advanced(&self, done: f64, of: f64);
}

/// Adds up what is done.
pub(crate) struct Progress<'w> {
    watcher: &'w dyn Watcher,
    done: Cell<f64>,
    of: f64,
}

impl<'w> Progress<'w> {
    pub(crate) fn new(watcher: &'w dyn Watcher, of: f64) -> Self {
        Self { watcher, done: Cell::new(0.0), of }
    }

    pub(crate) fn begins(&self, what: &str) {
        self.watcher.begins(what);
    }

    /// Something of that weight is done, or will not be.
    pub(crate) fn add(&self, weight: f64) {
        self.done.set(self.done.get() + weight);
        self.watcher.advanced(self.done.get().min(self.of), self.of);
    }
}
