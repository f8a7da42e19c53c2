//! What a file says about which picture it holds, whatever its kind.

use super::{FileKind, Metadata};

/// The name of the remark; behind it stands a number of 32 hexadecimal digits.
pub const MARK: &str = "whitted:picture";

const DIGITS: usize = 32;

/// Bytes between the name and the number in any kind of file: a type, a size, punctuation.
const GAP: usize = 16;

/// What the bytes of a file say about which picture it is.
pub fn mark_of(bytes: &[u8]) -> Option<String> {
    let start = bytes.windows(MARK.len()).position(|window| window == MARK.as_bytes())? + MARK.len();
    let near = &bytes[start..bytes.len().min(start + GAP + DIGITS)];
    let digits = near.windows(DIGITS).find(|window| window.iter().all(u8::is_ascii_hexdigit))?;
    String::from_utf8(digits.to_vec()).ok()
}

/// With the mark, in kinds of files whose encoders leave remarks out.
pub(super) fn marked(kind: FileKind, mut bytes: Vec<u8>, metadata: &Metadata) -> Vec<u8> {
    let Some((name, number)) = metadata.notes.iter().find(|(name, _)| *name == MARK) else { return bytes };
    let remark = format!("{name} {number}");
    match kind {
        FileKind::Jpeg => insert(&mut bytes, 2, &jpeg_comment(&remark)),
        FileKind::Hdr => {
            let behind_first_line = bytes.iter().position(|byte| *byte == b'\n').map_or(0, |at| at + 1);
            insert(&mut bytes, behind_first_line, format!("# {remark}\n").as_bytes());
        }
        FileKind::Tga { .. } => {
            // The identification of an image follows the header, whose first byte is its length.
            bytes[0] = remark.len() as u8;
            insert(&mut bytes, TGA_HEADER, remark.as_bytes());
        }
        FileKind::Bmp => mark_bmp(&mut bytes, &remark),
        FileKind::Exr | FileKind::Png | FileKind::Ppm => {}
    }
    bytes
}

const TGA_HEADER: usize = 18;

fn insert(bytes: &mut Vec<u8>, at: usize, more: &[u8]) {
    bytes.splice(at..at, more.iter().copied());
}

/// Source: ITU-T T.81, section B.2.4.5.
fn jpeg_comment(remark: &str) -> Vec<u8> {
    let length = (remark.len() + 2) as u16;
    [&[0xff, 0xfe][..], &length.to_be_bytes(), remark.as_bytes()].concat()
}

/// Between the headers and the pixels, whose place and the size of the whole stand in the file's header.
fn mark_bmp(bytes: &mut Vec<u8>, remark: &str) {
    const SIZE: usize = 2;
    const START: usize = 10;
    let number = |bytes: &[u8], at: usize| u32::from_le_bytes(std::array::from_fn(|i| bytes[at + i]));
    // Pixels stay where computers like them.
    let room = remark.len().next_multiple_of(4);
    let start = number(bytes, START) as usize;
    for at in [SIZE, START] {
        let moved = number(bytes, at) + room as u32;
        bytes[at..at + 4].copy_from_slice(&moved.to_le_bytes());
    }
    insert(bytes, start, format!("{remark:room$}").as_bytes());
}

#[cfg(test)]
mod tests {
    use super::super::{Encoding, Picture, save};
    use super::*;

    #[test]
    fn every_kind_of_file_says_what_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let number = "0123456789abcdef0123456789abcdef";
        let metadata = Metadata { notes: vec![(MARK, number.into())], ..Metadata::default() };
        let picture = Picture::filled(5, 3, [0.5, 0.25, 1.0, 1.0]);
        for name in ["a.exr", "a.png", "a.ppm", "a.tga", "a.bmp", "a.jpg", "a.hdr"] {
            let path = folder.path().join(name);
            save(&path, &picture, &metadata, &Encoding::default()).unwrap();
            assert_eq!(mark_of(&std::fs::read(&path).unwrap()).as_deref(), Some(number), "{name}");
            if name != "a.exr" {
                assert_eq!(image::open(&path).unwrap().to_rgb8().dimensions(), (5, 3), "{name}");
            }
        }
    }

    #[test]
    fn other_files_say_nothing() {
        assert_eq!(mark_of(b"hi"), None);
        assert_eq!(mark_of(b"whitted:picture whitted:picture"), None);
    }
}
