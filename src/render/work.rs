//! Work on a window block by block, on all threads, in an order that leaves no trace.

use super::film::{Block, blocks, rows_of};
use super::observer::Observer;
use super::options::Region;
use super::prepare::Prepared;
use super::statistics::Statistics;
use super::worker::Worker;
use rayon::prelude::*;

/// What all blocks have in common.
pub(super) struct Work<'a> {
    pub(super) prepared: &'a Prepared<'a>,
    pub(super) observer: &'a dyn Observer,
}

impl Work<'_> {
    /// Lets `fill` work on each block of a window, whose rows it gets.
    ///
    /// Once the observer cancels, blocks stay as they are.
    pub(super) fn each_block<T: Send>(
        &self,
        window: &Region,
        all: &mut [T],
        fill: impl Fn(&mut Worker<'_>, &Block, &mut [&mut [T]]) + Sync,
    ) -> Statistics {
        let blocks = blocks(window);
        let parts = rows_of(&blocks, window, all);
        let one = |worker: &mut Worker<'_>, (block, mut rows): (&Block, Vec<&mut [T]>)| {
            if !self.observer.cancels() {
                fill(worker, block, &mut rows);
            }
            worker.take_statistics()
        };
        let counts: Vec<Statistics> =
            blocks.par_iter().zip(parts).map_init(|| Worker::new(self.prepared), one).collect();
        counts.into_iter().fold(Statistics::default(), Statistics::plus)
    }
}
