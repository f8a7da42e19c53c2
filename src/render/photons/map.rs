//! Photons by place: a balanced tree without pointers.
//!
//! The middle of a part of the list splits it: what lies before it is not above it along its axis, what lies behind is not
//! below. Source: J. L. Bentley, "Multidimensional Binary Search Trees Used for Associative Searching", Communications of
//! the ACM 18 (9), 1975.

use super::photon::Photon;
use crate::math::DVec3;
use std::collections::BinaryHeap;

/// Parts with fewer photons are sorted by the thread that has split them.
const SHARED_WORK: usize = 1 << 14;

/// So many photons are looked at one by one: to go on in halves would take longer.
const FEW: usize = 8;

/// Flattening of the ball in which photons are looked for, along the normal, at its distance of one scene unit.
///
/// Source: photon facts, section 5.
const FLATTENING: f64 = 16.0;

/// All photons.
#[derive(Debug, Default)]
pub(in crate::render) struct PhotonMap {
    photons: Vec<Photon>,
    /// How far around a point they are looked for; none where no light would show.
    pub(super) radius: Option<f64>,
}

/// A place around which photons are looked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Around {
    pub(super) point: DVec3,
    /// The ball is flattened along this unit direction, if at all.
    pub(super) normal: DVec3,
}

/// The nearest photons of those that were looked at.
#[derive(Clone, Debug, Default)]
pub(super) struct Nearest {
    /// The farthest is at hand.
    found: BinaryHeap<Candidate>,
    /// How many are kept.
    most: usize,
    /// Square of the distance within which they count.
    reach: f64,
}

/// A photon and the square of its distance.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    squared: f64,
    index: u32,
}

// Of those at one distance the index decides, so that no order of search shows.
impl Ord for Candidate {
    #[inline]
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.squared.total_cmp(&other.squared).then(self.index.cmp(&other.index))
    }
}

impl PartialOrd for Candidate {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

impl Nearest {
    /// Starts anew.
    pub(super) fn begin(&mut self, most: usize, radius: f64) {
        self.found.clear();
        (self.most, self.reach) = (most, radius * radius);
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.found.len()
    }

    /// Square of the radius of the ball that holds them: that in which they were looked for, unless it held too many.
    pub(super) fn reach(&self) -> f64 {
        self.reach
    }

    /// In no order that means anything, but always the same.
    pub(super) fn indices(&self) -> impl Iterator<Item = u32> {
        self.found.iter().map(|candidate| candidate.index)
    }

    #[inline]
    fn offer(&mut self, squared: f64, index: u32) {
        if squared >= self.reach {
            return;
        }
        let candidate = Candidate { squared, index };
        if self.found.len() < self.most {
            self.found.push(candidate);
            return;
        }
        if let Some(mut farthest) = self.found.peek_mut()
            && candidate < *farthest
        {
            *farthest = candidate;
        }
        self.reach = self.found.peek().map_or(self.reach, |farthest| farthest.squared);
    }
}

impl PhotonMap {
    /// Sorts photons; the same map for the same list, however many threads help.
    pub(in crate::render) fn new(mut photons: Vec<Photon>) -> Self {
        sort(&mut photons);
        Self { photons, radius: None }
    }

    /// How many there are.
    pub(in crate::render) fn len(&self) -> usize {
        self.photons.len()
    }

    pub(super) fn photon(&self, index: u32) -> &Photon {
        &self.photons[index as usize]
    }

    /// Offers all photons near a place that may be among the nearest.
    pub(super) fn search(&self, around: &Around, nearest: &mut Nearest) {
        self.search_part(0, self.photons.len(), around, nearest);
    }

    #[inline]
    fn offer(&self, place: usize, around: &Around, nearest: &mut Nearest) {
        let offset = self.photons[place].position() - around.point;
        let squared = offset.length_squared();
        // The flattened distance is the longer one.
        if squared < nearest.reach {
            let flattened = 1.0 + FLATTENING * around.normal.dot(offset).abs();
            nearest.offer(squared * flattened, place as u32);
        }
    }

    fn search_part(&self, first: usize, end: usize, around: &Around, nearest: &mut Nearest) {
        if end - first <= FEW {
            (first..end).for_each(|place| self.offer(place, around, nearest));
            return;
        }
        let middle = first.midpoint(end - 1);
        let photon = &self.photons[middle];
        let axis = usize::from(photon.axis);
        let beyond = around.point[axis] - f64::from(photon.coordinate(photon.axis));
        let (near, far) =
            if beyond < 0.0 { ((first, middle), (middle + 1, end)) } else { ((middle + 1, end), (first, middle)) };
        self.search_part(near.0, near.1, around, nearest);
        self.offer(middle, around, nearest);
        // The flattened distance is the longer one.
        if beyond * beyond < nearest.reach {
            self.search_part(far.0, far.1, around, nearest);
        }
    }
}

fn sort(part: &mut [Photon]) {
    if part.len() < 2 {
        return;
    }
    let axis = widest_axis(part);
    let middle = (part.len() - 1) / 2;
    part.select_nth_unstable_by(middle, |a, b| a.coordinate(axis).total_cmp(&b.coordinate(axis)));
    part[middle].axis = axis;
    let (before, rest) = part.split_at_mut(middle);
    let behind = &mut rest[1..];
    if behind.len() < SHARED_WORK {
        sort(before);
        sort(behind);
    } else {
        rayon::join(|| sort(before), || sort(behind));
    }
}

fn widest_axis(part: &[Photon]) -> u8 {
    let mut sides = [(f32::INFINITY, f32::NEG_INFINITY); 3];
    for photon in part {
        for (axis, side) in (0..).zip(&mut sides) {
            let x = photon.coordinate(axis);
            *side = (side.0.min(x), side.1.max(x));
        }
    }
    let [x, y, z] = sides.map(|(low, high)| high - low);
    if x >= y && x >= z { 0 } else { 1 + u8::from(z > y) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;
    use crate::render::random::mixed;

    fn unit(n: u64) -> f64 {
        (mixed(n) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn some(n: u64) -> Vec<Photon> {
        let position = |i: u64| DVec3::new(unit(3 * i), 0.1 * unit(3 * i + 1), unit(3 * i + 2));
        (0..n).filter_map(|i| Photon::new(position(i), Rgb::ONE, DVec3::Y)).collect()
    }

    #[test]
    fn what_is_found_is_what_is_near() {
        let photons = some(20_000);
        let map = PhotonMap::new(photons.clone());
        let mut nearest = Nearest::default();
        for k in 0..50 {
            let point = DVec3::new(unit(900_000 + k), 0.05, unit(910_000 + k));
            let around = Around { point, normal: if k % 2 == 0 { DVec3::Y } else { DVec3::ZERO } };
            let squared = |photon: &Photon| {
                let offset = photon.position() - point;
                offset.length_squared() * (1.0 + FLATTENING * around.normal.dot(offset).abs())
            };
            let mut all: Vec<f64> = photons.iter().map(squared).collect();
            all.sort_by(f64::total_cmp);
            for radius in [0.01, 0.03, 0.2] {
                nearest.begin(40, radius);
                map.search(&around, &mut nearest);
                let within = all.iter().filter(|d| **d < radius * radius).count();
                assert_eq!(nearest.len(), within.min(40), "{k} {radius}");
                let reach = if within > 40 { all[39] } else { radius * radius };
                assert_eq!(nearest.reach(), reach, "{k} {radius}");
            }
        }
    }

    #[test]
    fn threads_do_not_show() {
        let sorted = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| PhotonMap::new(some(100_000)).photons)
        };
        assert!(sorted(1) == sorted(7));
    }
}
