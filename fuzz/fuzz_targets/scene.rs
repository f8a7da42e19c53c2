//! Any bytes, read as a scene file and compiled: a world or messages, never a panic, and soon.
//!
//! `fuzz/run SECONDS` starts it with our own scenes as corpus and the language's words as dictionary.

#![no_main]

mod limits;

use libfuzzer_sys::fuzz_target;
use limits::LIMITS;
use whitted::compile::{self, Queries};
use whitted::eval::{self, Host as _, Memory, Options};

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
