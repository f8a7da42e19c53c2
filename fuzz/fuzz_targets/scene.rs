//! Any bytes, read as a scene file and compiled: a world or messages, never a panic, and soon.
//!
//! `fuzz/run SECONDS` starts it with our own scenes as corpus and the language's words as dictionary.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitted::compile::{self, Queries};
use whitted::eval::{self, Host as _, Limits, Memory, Options};

/// Small enough that the dearest scene within them takes a fraction of a second.
const LIMITS: Limits = Limits {
    steps: 1_000,
    objects: 500,
    parts: 5_000,
    array_elements: 5_000,
    string_bytes: 10_000,
    include_depth: 6,
    macro_depth: 60,
    nesting: 80,
};

fuzz_target!(|text: &[u8]| {
    let host = Memory::default();
    if host.append("a.pov".as_ref(), text).is_err() {
        return;
    }
    let options = Options { limits: LIMITS, ..Options::default() };
    match eval::evaluate("a.pov".as_ref(), &options, &host, &Queries::default()) {
        Ok(read) => drop(compile::compile(&read.scene)),
        Err(failed) => failed.diagnostics.iter().for_each(|d| drop(d.render(&failed.sources, false))),
    }
});
