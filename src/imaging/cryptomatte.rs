//! Mattes by name: Cryptomatte layers, as compositing programs read them.
//!
//! Each name becomes a number, the bits of an `f32`; each pixel holds the numbers of what covers it with the
//! shares, largest first, two to a layer. The header says what the numbers mean. Source: Friedman and Jones,
//! "Fully automatic id mattes with support for motion blur and transparency", and the Cryptomatte specification,
//! version 1.2.0.

use super::Layer;
use std::collections::BTreeMap;

/// Things that a pixel can tell apart; more layers than three are unusual.
const RANKS: usize = 6;

/// The layers `name00`, `name01`, … for the shares of each pixel, largest first.
///
/// What an index stands for is asked once for each that shows.
pub fn cryptomatte(name: &str, pixels: &[Vec<(u32, f32)>], label: impl Fn(u32) -> String) -> Vec<Layer> {
    let mut labels: BTreeMap<u32, (String, u32)> = BTreeMap::new();
    for (index, _) in pixels.iter().flatten() {
        labels.entry(*index).or_insert_with(|| {
            let label = label(*index);
            let id = id(&label);
            (label, id)
        });
    }
    let value = |pixel: &[(u32, f32)], rank: usize, second: bool| match pixel.get(rank) {
        Some((_, share)) if second => *share,
        Some((index, _)) => f32::from_bits(labels.get(index).map_or(0, |(_, id)| *id)),
        None => 0.0,
    };
    let channel = |rank: usize, second: bool| pixels.iter().map(|p| value(p, rank, second)).collect();
    let mut layers: Vec<Layer> = (0..RANKS / 2)
        .map(|i| {
            let channels = [("R", 0, false), ("G", 0, true), ("B", 1, false), ("A", 1, true)];
            let channels = channels.map(|(c, rank, second)| (c.to_owned(), channel(2 * i + rank, second)));
            Layer { name: format!("{name}{i:02}"), is_color: false, channels: channels.into(), attributes: Vec::new() }
        })
        .collect();
    let key = &format!("{:08x}", murmur3(name.as_bytes()))[..7];
    let attribute = |what: &str, text: String| (format!("cryptomatte/{key}/{what}"), text);
    layers[0].attributes = vec![
        attribute("name", name.to_owned()),
        attribute("hash", "MurmurHash3_32".into()),
        attribute("conversion", "uint32_to_float32".into()),
        attribute("manifest", manifest(labels.values())),
    ];
    layers
}

/// Names and numbers as JSON.
fn manifest<'a>(labels: impl Iterator<Item = &'a (String, u32)>) -> String {
    let entries: Vec<String> = labels.map(|(label, id)| format!("{}:\"{id:08x}\"", quoted(label))).collect();
    format!("{{{}}}", entries.join(","))
}

fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted += &format!("\\u{:04x}", c as u32),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// The number of a name: its hash, with an exponent that is a number's and not that of NaN, infinity or nothing.
fn id(name: &str) -> u32 {
    let hash = murmur3(name.as_bytes());
    if matches!((hash >> 23) & 255, 0 | 255) { hash ^ (1 << 23) } else { hash }
}

/// MurmurHash3, 32 bits, seed 0. Source: Appleby's public-domain definition.
fn murmur3(bytes: &[u8]) -> u32 {
    let scramble = |k: u32| k.wrapping_mul(0xcc9e_2d51).rotate_left(15).wrapping_mul(0x1b87_3593);
    let little = |chunk: &[u8]| chunk.iter().rev().fold(0u32, |k, b| (k << 8) | u32::from(*b));
    let chunks = bytes.chunks_exact(4);
    let rest = little(chunks.remainder());
    let mut hash =
        chunks.fold(0u32, |h, c| (h ^ scramble(little(c))).rotate_left(13).wrapping_mul(5).wrapping_add(0xe654_6b64));
    hash ^= scramble(rest) ^ bytes.len() as u32;
    hash = (hash ^ (hash >> 16)).wrapping_mul(0x85eb_ca6b);
    hash = (hash ^ (hash >> 13)).wrapping_mul(0xc2b2_ae35);
    hash ^ (hash >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expected: u32) {
        assert_eq!(murmur3(text.as_bytes()), expected, "{text}");
    }

    #[test]
    fn hashes_are_murmurs() {
        // Published test vectors of MurmurHash3_x86_32 with seed 0.
        check("", 0);
        check("test", 0xba6b_d213);
        check("Hello, world!", 0xc036_3e43);
        check("The quick brown fox jumps over the lazy dog", 0x2e4f_f723);
    }

    #[test]
    fn pixels_hold_names_and_shares() {
        let pixels = [vec![(4, 0.75), (9, 0.25)], vec![]];
        let layers = cryptomatte("CryptoObject", &pixels, |index| format!("thing \"{index}\""));
        assert_eq!(
            layers.iter().map(|l| l.name.as_str()).collect::<Vec<_>>(),
            ["CryptoObject00", "CryptoObject01", "CryptoObject02"]
        );
        let first: Vec<f32> = layers[0].channels.iter().map(|(_, values)| values[0]).collect();
        assert_eq!((first[1], first[3]), (0.75, 0.25));
        assert_eq!(first[0].to_bits(), id("thing \"4\""));
        assert!(layers.iter().flat_map(|l| &l.channels).all(|(_, values)| values[1] == 0.0));
        let manifest = &layers[0].attributes[3];
        assert_eq!(manifest.0, "cryptomatte/3ae39a5/manifest");
        assert!(manifest.1.starts_with("{\"thing \\\"4\\\"\":\""), "{}", manifest.1);
    }

    #[test]
    fn ids_are_ordinary_numbers() {
        for i in 0..10_000 {
            let value = f32::from_bits(id(&format!("object.{i}")));
            assert!(value.is_normal(), "{i}");
        }
    }
}
