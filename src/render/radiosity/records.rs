//! Records by where they count.
//!
//! POV-Ray files each record in a cell of an octree and sees it from within twice the cell, which at deeper bounces leaves
//! some out that would count. The same boxes are cut here into cells of grids shifted by half a cell, one grid for each
//! size in use: a point asks one cell of each.
//!
//! Source: radiosity facts, section 5 (measured).

use super::record::{Blend, Question, Record};
use crate::math::DVec3;
use crate::render::random::mixed;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

/// By how much POV-Ray shifts coordinates before it looks for cells.
const SHIFT: f64 = 1e7;

/// How many times smaller the boxes of deeper records are.
const DEEPER: f64 = 8.0;

/// Exponents of sizes of cells; what is beyond is taken for the end.
const SIZES: std::ops::RangeInclusive<i32> = -60..=60;

/// All records, by depth.
#[derive(Debug, Default)]
pub(in crate::render) struct Records {
    depths: Vec<Depth>,
}

/// Records of one depth.
#[derive(Debug, Default)]
struct Depth {
    records: Vec<Record>,
    /// Exponents of cell sizes in use, in order.
    sizes: SmallVec<[i32; 16]>,
    /// Records by size and cell. That a number may stand for two cells does no harm: distance decides.
    cells: FxHashMap<u64, Vec<Entry>>,
}

/// What decides most often that a record does not count, where it is looked for.
#[derive(Clone, Copy, Debug)]
struct Entry {
    point: DVec3,
    mean_distance: f32,
    /// Among the records.
    index: u32,
}

impl Records {
    /// Files a record; `reach` is how far it counts at most: its mean distance times the error bound there.
    pub(in crate::render) fn add(&mut self, depth: u32, record: Record, reach: f64) {
        let depth = depth as usize;
        if self.depths.len() <= depth {
            self.depths.resize_with(depth + 1, Depth::default);
        }
        let reach = if depth == 0 { reach } else { reach / DEEPER };
        self.depths[depth].add(record, reach);
    }

    /// Adds what the records of a depth say.
    pub(in crate::render) fn blend(&self, depth: u32, asked: &Question, into: &mut Blend) {
        if let Some(depth) = self.depths.get(depth as usize) {
            depth.blend(asked, into);
        }
    }

    /// Those of each depth in the order in which they were filed.
    pub(in crate::render) fn by_depth(&self) -> impl Iterator<Item = &[Record]> {
        self.depths.iter().map(|depth| &depth.records[..])
    }

    /// Forgets everything; room is kept.
    pub(in crate::render) fn clear(&mut self) {
        for depth in &mut self.depths {
            depth.records.clear();
            depth.sizes.clear();
            depth.cells.clear();
        }
    }
}

impl Depth {
    fn add(&mut self, record: Record, reach: f64) {
        let index = self.records.len() as u32;
        let entry = Entry { point: record.point, mean_distance: record.mean_distance, index };
        let size = box_size(record.point, reach);
        if let Err(at) = self.sizes.binary_search(&size) {
            self.sizes.insert(at, size);
        }
        let cell = cell_of(record.point, size);
        for corner in 0..8 {
            let part = [0, 1, 2].map(|axis| cell[axis].wrapping_add(corner >> axis & 1));
            self.cells.entry(key(size, part)).or_default().push(entry);
        }
        self.records.push(record);
    }

    fn blend(&self, asked: &Question, into: &mut Blend) {
        for size in &self.sizes {
            let half = 0.5 * f64::from(*size).exp2();
            let part = cell_of(asked.point + DVec3::splat(half), *size);
            for entry in self.cells.get(&key(*size, part)).into_iter().flatten() {
                if !asked.is_within(entry.point, entry.mean_distance) {
                    continue;
                }
                let record = &self.records[entry.index as usize];
                if let Some(weight) = record.weight(asked) {
                    into.add(record.light, weight);
                }
            }
        }
    }
}

/// Exponent of the size of the cell in which a record is filed: the smallest that holds the point and whose double, about
/// its middle, holds all that is within `reach` along the axes.
fn box_size(point: DVec3, reach: f64) -> i32 {
    let first = (2.0 * reach).log2().floor().clamp(f64::from(*SIZES.start()), f64::from(*SIZES.end())) as i32;
    let holds = |size: &i32| {
        let side = f64::from(*size).exp2();
        let middle = cell_of(point, *size).map(|i| (i as f64 + 0.5) * side - SHIFT);
        (point - DVec3::from(middle)).abs().max_element() + reach <= side
    };
    (first..*SIZES.end()).find(holds).unwrap_or(*SIZES.end())
}

/// Which cell of a size holds a point.
fn cell_of(point: DVec3, size: i32) -> [i64; 3] {
    let cells_per_unit = f64::from(-size).exp2();
    // What is too large for a number of a cell goes into the last.
    point.to_array().map(|x| ((x + SHIFT) * cells_per_unit).floor() as i64)
}

fn key(size: i32, cell: [i64; 3]) -> u64 {
    cell.iter().fold(i64::from(size) as u64, |hash, index| mixed(hash ^ *index as u64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    /// A record counts wherever it can at depth 0, at any size and place.
    #[test]
    fn nothing_near_is_lost() {
        for (k, scale) in [1e-3, 0.7, 1.0, 40.0, 1e4].into_iter().enumerate() {
            for i in 0..50 {
                let unit = |n: u64| (mixed(100 * k as u64 + 10 * i + n) >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
                let point = scale * DVec3::new(unit(0), unit(1), unit(2));
                let mean = scale * 0.1;
                let record = Record {
                    point,
                    normal: DVec3::Y,
                    mean_distance: mean as f32,
                    nearest: mean as f32,
                    toward_nearest: DVec3::ZERO,
                    light: Rgb::ONE,
                    quality: 1.0,
                };
                let mut records = Records::default();
                records.add(0, record, mean);
                let along = DVec3::new(unit(3), 0.0, unit(4)).normalize();
                let asks = |distance: f64| {
                    let point = point + distance * mean * along;
                    let asked = Question { point, normal: DVec3::Y, error: 1.0, is_smooth: false };
                    let mut blend = Blend::default();
                    records.blend(0, &asked, &mut blend);
                    blend.weight()
                };
                assert!((asks(0.9) - 0.1).abs() < 1e-5 && asks(1.1) == 0.0, "{scale} {i}: {}", asks(0.9));
            }
        }
    }
}
