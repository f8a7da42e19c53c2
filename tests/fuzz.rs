//! Mutated scenes: reading and compiling any text gives a scene or messages, never a panic, and soon.
//!
//! The mutations follow from the number of the case alone, so that each can be had again. A long run:
//! `FUZZ_CASES=1000000 FUZZ_FIRST=5000 cargo test --release --test fuzz`. A case that breaks is written to
//! `target/fuzz/`; once mended it moves to `tests/regressions/`.

use rayon::prelude::*;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use whitted::compile::{self, Queries};
use whitted::eval::{self, Host as _, Limits, Memory, Options};

/// Far above what a case takes with these limits, on a machine with other things to do.
const PATIENCE: Duration = Duration::from_secs(20);
const LIMITS: Limits = Limits {
    steps: 5_000,
    objects: 2_000,
    parts: 20_000,
    array_elements: 20_000,
    string_bytes: 20_000,
    include_depth: 8,
    macro_depth: 100,
    nesting: 100,
};

/// Numbers by George Marsaglia's xorshift, for mutations that are the same everywhere.
struct Dice(u64);

impl Dice {
    fn new(case: u64) -> Self {
        // Neighbouring cases must differ in many bits.
        let mut dice = Self((case + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        dice.below(2);
        dice
    }

    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % n.max(1)
    }
}

/// Words, numbers and single signs; blanks and comments go.
fn tokens(text: &[u8]) -> Vec<&[u8]> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let start = at;
        let word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.' | b'#');
        if text[at..].starts_with(b"//") {
            at += text[at..].iter().take_while(|b| **b != b'\n').count();
            continue;
        }
        let length = text[at..].iter().take_while(|b| word(b)).count();
        at += length.max(1);
        if !text[start].is_ascii_whitespace() {
            found.push(&text[start..at]);
        }
    }
    found
}

/// What numbers and brackets are exchanged for.
const ODDITIES: [&[u8]; 26] = [
    b"0",
    b"-1",
    b"1e300",
    b"-1e-300",
    b"1e400",
    b"1/0",
    b"65536",
    b"4294967296",
    b"<0,0,0>",
    b"<1e200,-1,0>",
    b"{",
    b"}",
    b"(",
    b")",
    b"[",
    b"]",
    b",",
    b";",
    b"\"",
    b"#end",
    b"#else",
    b"#if (0)",
    b"#while (1)",
    b"inverse",
    b"x",
    b"/*",
];

fn mutate(corpus: &[Vec<u8>], case: u64) -> Vec<u8> {
    let mut dice = Dice::new(case);
    let scene = &corpus[dice.below(corpus.len())];
    let mut words = tokens(scene);
    let other = tokens(&corpus[dice.below(corpus.len())]);
    for _ in 0..=dice.below(6) {
        let (at, length) = (dice.below(words.len()), 1 + dice.below(8));
        let end = (at + length).min(words.len());
        match dice.below(8) {
            0 => drop(words.drain(at..end)),
            1 => words.splice(end..end, words[at..end].to_vec()).for_each(drop),
            2 if !other.is_empty() => {
                let from = dice.below(other.len());
                let part = &other[from..(from + length * 4).min(other.len())];
                words.splice(at..at, part.iter().copied()).for_each(drop);
            }
            3 if !words.is_empty() => {
                let with = dice.below(words.len());
                words.swap(at, with);
            }
            4 => words.truncate(at),
            5 if !other.is_empty() && !words.is_empty() => words[at] = other[dice.below(other.len())],
            6 => words.insert(at, ODDITIES[dice.below(ODDITIES.len())]),
            _ if !words.is_empty() => words[at] = ODDITIES[dice.below(ODDITIES.len())],
            _ => {}
        }
    }
    let mut text = words.join(&b' ');
    if dice.below(4) == 0 && !text.is_empty() {
        let at = dice.below(text.len());
        text[at] ^= 1 << dice.below(8);
    }
    text
}

/// Reads and compiles a text; why it must not be so, if it breaks.
fn outcome(text: &[u8]) -> Result<(), String> {
    let start = Instant::now();
    let work = || {
        let host = Memory::default();
        let _ = host.append("a.pov".as_ref(), text);
        let options = Options { limits: LIMITS, ..Options::default() };
        match eval::evaluate("a.pov".as_ref(), &options, &host, &Queries::default()) {
            Err(failed) => failed.diagnostics.iter().map(|d| d.render(&failed.sources, false).len()).sum::<usize>(),
            Ok(read) => compile::compile(&read.scene).map_or(0, |compiled| compiled.world.textures.len()),
        }
    };
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| "it panics".to_owned())?;
    let taken = start.elapsed();
    if taken > PATIENCE { Err(format!("it takes {:.1} s", taken.as_secs_f64())) } else { Ok(()) }
}

fn files(folders: &[&str]) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found: Vec<PathBuf> = Vec::new();
    for folder in folders {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        found.extend(entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|e| e == "pov" || e == "inc")));
    }
    found.sort();
    found.into_iter().filter_map(|path| fs::read(&path).ok().map(|text| (path, text))).collect()
}

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(default)
}

#[test]
fn mutated_scenes_give_a_scene_or_messages() {
    let scenes = files(&["golden", "examples", "tests/wrong", "tests/includes", "tests/regressions"]);
    let corpus: Vec<Vec<u8>> = scenes.into_iter().map(|(_, text)| text).filter(|text| text.len() < 20_000).collect();
    assert!(corpus.len() > 50, "only {} scenes were found", corpus.len());
    let (first, count) = (setting("FUZZ_FIRST", 0), setting("FUZZ_CASES", 3_000));
    let broken: Vec<String> = (first..first + count)
        .into_par_iter()
        .filter_map(|case| {
            let text = mutate(&corpus, case);
            let why = outcome(&text).err()?;
            let kept = Path::new("target/fuzz").join(format!("{case}.pov"));
            let written = fs::create_dir_all("target/fuzz").and_then(|()| fs::write(&kept, &text));
            Some(format!("{} ({}): {why}", kept.display(), if written.is_ok() { "kept" } else { "lost" }))
        })
        .collect();
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn inputs_that_once_broke_are_answered() {
    for (path, text) in files(&["tests/regressions"]) {
        assert_eq!(outcome(&text), Ok(()), "{}", path.display());
    }
}
