//! A rectangle of pixels cut into blocks, each of which one thread works on.

use crate::render::options::Region;

/// Side of a block in pixels: POV-Ray's default, on which antialiasing method 1 depends.
pub const BLOCK: usize = 32;

/// A rectangle of pixels that is worked on at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::render) struct Block {
    pub(in crate::render) x: usize,
    pub(in crate::render) y: usize,
    pub(in crate::render) width: usize,
    pub(in crate::render) height: usize,
}

/// A window cut along the lines of the full picture's blocks; blocks come row by row.
pub(in crate::render) fn blocks(window: &Region) -> Vec<Block> {
    let cuts = |from: usize, to: usize| {
        let inner = (from / BLOCK + 1..).map(|i| i * BLOCK).take_while(move |cut| *cut < to);
        let starts: Vec<usize> = std::iter::once(from).chain(inner).filter(|cut| *cut < to).collect();
        let ends: Vec<usize> = starts.iter().skip(1).copied().chain([to]).collect();
        starts.into_iter().zip(ends).collect::<Vec<_>>()
    };
    let columns = cuts(window.left, window.right);
    let rows = cuts(window.top, window.bottom);
    let block = |(y, bottom): (usize, usize)| {
        columns.iter().map(move |&(x, right)| Block { x, y, width: right - x, height: bottom - y })
    };
    rows.into_iter().flat_map(block).collect()
}

/// The pixels of each of a window's blocks, row by row, among all of the window.
pub(in crate::render) fn rows_of<'p, G>(blocks: &[Block], window: &Region, all: &'p mut [G]) -> Vec<Vec<&'p mut [G]>> {
    let mut parts: Vec<Vec<&mut [G]>> = blocks.iter().map(|block| Vec::with_capacity(block.height)).collect();
    for (y, mut row) in (window.top..).zip(all.chunks_mut(window.width().max(1))) {
        let first = blocks.partition_point(|block| block.y + block.height <= y);
        let end = blocks.partition_point(|block| block.y <= y);
        for (block, part) in blocks[first..end].iter().zip(&mut parts[first..end]) {
            let (own, rest) = row.split_at_mut(block.width);
            part.push(own);
            row = rest;
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(window: Region, n: usize) {
        let blocks = blocks(&window);
        assert_eq!(blocks.len(), n);
        let mut all = vec![0u8; window.width() * window.height()];
        let parts = rows_of(&blocks, &window, &mut all);
        for (block, rows) in blocks.iter().zip(parts) {
            assert!(rows.len() == block.height && rows.iter().all(|row| row.len() == block.width), "{block:?}");
            rows.into_iter().flatten().for_each(|pixel| *pixel += 1);
        }
        assert!(all.iter().all(|pixel| *pixel == 1), "{window:?}");
    }

    #[test]
    fn blocks_cover_every_pixel_once() {
        check(Region { left: 0, top: 0, right: 75, bottom: 50 }, 6);
        check(Region { left: 10, top: 20, right: 50, bottom: 33 }, 4);
        check(Region { left: 33, top: 40, right: 34, bottom: 41 }, 1);
    }
}
