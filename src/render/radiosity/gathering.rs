//! What a thread knows while light between surfaces is gathered.

use super::record::Record;
use super::records::Records;

/// What samples are taken for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::render) enum Phase {
    /// A coarse pass before the picture: many records are wanted at a point.
    Pretrace,
    /// The last pass before the picture, through each pixel: the rules are those of the picture, and samples are kept.
    Completion,
    /// The picture: what is missing is found for one place and kept no longer than that takes.
    #[default]
    Picture,
}

/// Samples in the making, and what was found by this thread since all threads last shared what they know.
#[derive(Debug, Default)]
pub(in crate::render) struct Gathering {
    pub(in crate::render) phase: Phase,
    /// Records of this thread's block.
    pub(in crate::render) records: Records,
    /// The same in the order in which they were found, with their depth and reach, for all threads.
    pub(in crate::render) found: Vec<(u32, Record, f64)>,
    /// Number of the next direction, by depth.
    pub(in crate::render) next: Vec<u32>,
    /// How well light of the next bounce is known, for the ray that is on its way.
    pub(in crate::render) quality: f32,
    /// How often light was asked for at what the camera sees, and with how much known in all.
    pub(in crate::render) asked: u32,
    pub(in crate::render) known: f64,
}

impl Gathering {
    /// Starts anew, with directions from these on.
    pub(in crate::render) fn begin(&mut self, phase: Phase, first: impl Iterator<Item = u32>) {
        self.phase = phase;
        self.records.clear();
        self.found.clear();
        self.next.clear();
        self.next.extend(first);
        (self.asked, self.known) = (0, 0.0);
    }

    /// The number of the next direction at a depth.
    pub(in crate::render) fn next_direction(&mut self, depth: u32) -> u32 {
        let depth = depth as usize;
        if self.next.len() <= depth {
            self.next.resize(depth + 1, 0);
        }
        let number = self.next[depth];
        self.next[depth] = number.wrapping_add(1);
        number
    }

    /// Keeps a record.
    pub(in crate::render) fn keep(&mut self, depth: u32, record: Record, reach: f64) {
        self.records.add(depth, record, reach);
        if self.phase != Phase::Picture {
            self.found.push((depth, record, reach));
        }
    }
}
