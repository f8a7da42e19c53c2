//! Which things cover a pixel, and how much of it.

use smallvec::SmallVec;

/// Shares of a pixel by index; what is missing to 1 is background.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::render) struct Coverage(SmallVec<[(u32, f32); 2]>);

impl Coverage {
    /// One thing everywhere.
    pub(in crate::render) fn all(index: u32) -> Self {
        Self(smallvec::smallvec![(index, 1.0)])
    }

    /// Adds a share of one thing.
    pub(in crate::render) fn add(&mut self, index: u32, share: f32) {
        match self.0.iter_mut().find(|(i, _)| *i == index) {
            Some((_, sum)) => *sum += share,
            None => self.0.push((index, share)),
        }
    }

    /// Adds all shares of another, weighted.
    pub(in crate::render) fn add_scaled(&mut self, other: &Self, weight: f32) {
        other.0.iter().for_each(|(index, share)| self.add(*index, weight * share));
    }

    /// Weights all shares.
    pub(in crate::render) fn scale(&mut self, weight: f32) {
        self.0.iter_mut().for_each(|(_, share)| *share *= weight);
    }

    /// The shares, largest first; equal ones by index.
    pub(in crate::render) fn ranked(&self) -> Vec<(u32, f32)> {
        let mut ranked = self.0.to_vec();
        ranked.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        ranked
    }
}
