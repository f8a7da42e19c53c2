//! The pixels of an EXR file: blocks of scan lines, ZIP compressed.
//!
//! The `exr` crate packs with a deflate of its own, which was a tenth of the time of a picture of 100,000 objects.
//! Here `flate2` packs as small in half that time, on the threads that are there. Source: OpenEXR file layout, scan
//! line blocks; its technical introduction, ZIP.

use exr::block::chunk::{Chunk, CompressedBlock, CompressedScanLineBlock};
use exr::prelude::Text;
use flate2::{Compress, Compression, FlushCompress};
use half::f16;
use rayon::prelude::*;
use std::borrow::Cow;

/// Scan lines that are compressed together, as the format has it for ZIP.
const BLOCK_LINES: usize = 16;
/// Of nine, the one that makes files as small as others do; less takes half the time, for files a tenth larger.
const LEVEL: Compression = Compression::new(4);

/// One value for each pixel, row by row, under a name.
#[derive(Debug)]
pub(super) struct Channel<'p> {
    pub(super) name: Text,
    pub(super) samples: Samples<'p>,
}

/// The values of a channel.
#[derive(Debug)]
pub(super) enum Samples<'p> {
    Half(Vec<f16>),
    Float(Cow<'p, [f32]>),
}

impl Samples<'_> {
    /// Adds values as the file has them.
    fn append(&self, span: std::ops::Range<usize>, bytes: &mut Vec<u8>) {
        match self {
            Self::Half(values) => bytes.extend(values[span].iter().flat_map(|v| v.to_le_bytes())),
            Self::Float(values) => bytes.extend(values[span].iter().flat_map(|v| v.to_le_bytes())),
        }
    }
}

/// All blocks of the file's part of that number from the top, compressed; `top` is the first line's coordinate.
///
/// Channels are in the order of their names, and each holds width x height values.
pub(super) fn blocks(part: usize, channels: &[Channel<'_>], [width, height]: [usize; 2], top: i32) -> Vec<Chunk> {
    let starts: Vec<usize> = (0..height).step_by(BLOCK_LINES).collect();
    let block = |&start: &usize| {
        let mut bytes = Vec::new();
        for line in start..(start + BLOCK_LINES).min(height) {
            channels.iter().for_each(|c| c.samples.append(line * width..(line + 1) * width, &mut bytes));
        }
        let packed = packed(&bytes).unwrap_or(bytes);
        let block = CompressedScanLineBlock { y_coordinate: top + start as i32, compressed_pixels_le: packed };
        Chunk { layer_index: part, compressed_block: CompressedBlock::ScanLine(block) }
    };
    // A single worker would only need memory of its own.
    if rayon::current_num_threads() > 1 {
        starts.par_iter().map(block).collect()
    } else {
        starts.iter().map(block).collect()
    }
}

/// The bytes of a block in fewer; `None` where that cannot be: then the format takes them as they are.
fn packed(bytes: &[u8]) -> Option<Vec<u8>> {
    // Bytes of like meaning stand together, so that most differ little from the one before.
    let (first, second) = (bytes.iter().step_by(2), bytes.iter().skip(1).step_by(2));
    let sorted: Vec<u8> = first.chain(second).copied().collect();
    let mut differences = Vec::with_capacity(sorted.len());
    differences.extend(sorted.first());
    differences.extend(sorted.windows(2).map(|pair| pair[1].wrapping_sub(pair[0]).wrapping_add(128)));
    let mut packed = Vec::with_capacity(bytes.len());
    let status = Compress::new(LEVEL, true).compress_vec(&differences, &mut packed, FlushCompress::Finish).ok()?;
    (status == flate2::Status::StreamEnd && packed.len() < bytes.len()).then_some(packed)
}
