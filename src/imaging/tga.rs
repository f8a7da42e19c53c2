//! Targa files of 24 and 32 bits, top row first.
//!
//! Source: Truevision TGA File Format Specification, version 2.0, 1991: header, packets of run-length coded pictures.

use std::iter;

/// Pixels that a packet holds at most.
const LONGEST: usize = 128;

/// The bytes of a file; `values` are rows of red, green, blue and perhaps opacity.
pub(super) fn encode(
    [width, height]: [u32; 2],
    values: &[u8],
    has_alpha: bool,
    packed: bool,
) -> Result<Vec<u8>, String> {
    let [width, height] = [width, height].map(u16::try_from);
    let (Ok(width @ 1..), Ok(height @ 1..)) = (width, height) else {
        return Err("a TGA picture has 1 to 65535 pixels along each side".into());
    };
    let (n_channels, alpha_bits) = if has_alpha { (4, 8) } else { (3, 0) };
    let mut bytes = vec![0, 0, if packed { 10 } else { 2 }, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    bytes.extend([width, height].iter().flat_map(|size| size.to_le_bytes()));
    const TOP_FIRST: u8 = 0x20;
    bytes.extend([8 * n_channels as u8, TOP_FIRST | alpha_bits]);
    let mut pixels = values.to_vec();
    pixels.chunks_exact_mut(n_channels).for_each(|pixel| pixel.swap(0, 2));
    if packed {
        // A packet must not go on in the next row; many readers have no room for that.
        pixels.chunks(usize::from(width) * n_channels).for_each(|row| pack(row, n_channels, &mut bytes));
    } else {
        bytes.extend(pixels);
    }
    Ok(bytes)
}

/// Packets of equal pixels, and of different ones between them.
fn pack(row: &[u8], n_channels: usize, bytes: &mut Vec<u8>) {
    let pixels: Vec<&[u8]> = row.chunks_exact(n_channels).collect();
    let repeats = |from: usize| pixels.get(from + 1) == Some(&pixels[from]);
    let mut start = 0;
    while start < pixels.len() {
        let equal = repeats(start);
        let goes_on =
            |end: &usize| *end < pixels.len() && (if equal { pixels[*end] == pixels[start] } else { !repeats(*end) });
        let n =
            iter::successors(Some(start + 1), |end| Some(end + 1)).take_while(goes_on).take(LONGEST - 1).count() + 1;
        const EQUAL: u8 = 0x80;
        bytes.push((n - 1) as u8 | if equal { EQUAL } else { 0 });
        pixels[start..if equal { start + 1 } else { start + n }].iter().for_each(|pixel| bytes.extend(*pixel));
        start += n;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every packet of a row of grey pixels: whether they are equal, and how many.
    fn check(row: &[u8], expected: &[(bool, usize)]) {
        let values: Vec<u8> = row.iter().flat_map(|value| [*value; 3]).collect();
        let mut bytes = Vec::new();
        pack(&values, 3, &mut bytes);
        let (mut found, mut unpacked, mut rest) = (Vec::new(), Vec::new(), &bytes[..]);
        while let Some((head, pixels)) = rest.split_first() {
            let (equal, n) = (head & 0x80 != 0, usize::from(head & 0x7f) + 1);
            found.push((equal, n));
            let (taken, left) = pixels.split_at(if equal { 3 } else { 3 * n });
            unpacked.extend(if equal { taken.repeat(n) } else { taken.to_vec() });
            rest = left;
        }
        assert_eq!((found, unpacked), (expected.to_vec(), values));
    }

    #[test]
    fn rows_are_packed() {
        check(&[1], &[(false, 1)]);
        check(&[1, 2, 3], &[(false, 3)]);
        check(&[1, 1, 2, 3, 3, 3], &[(true, 2), (false, 1), (true, 3)]);
        check(&[7; 300], &[(true, 128), (true, 128), (true, 44)]);
        let different: Vec<u8> = (0..200).collect();
        check(&different, &[(false, 128), (false, 72)]);
    }

    #[test]
    fn packets_end_with_their_row() {
        let bytes = encode([4, 3], &[9; 36], false, true).unwrap();
        assert_eq!(bytes[18..], [0x83, 9, 9, 9].repeat(3));
        assert!(encode([70_000, 1], &[], false, true).is_err() && encode([0, 1], &[], false, false).is_err());
    }
}
