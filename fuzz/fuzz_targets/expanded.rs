//! Any bytes, read as an expanded scene and compiled: a world or messages, never a panic; what is read is written as text
//! that is read as the same text again.

#![no_main]

mod limits;

use libfuzzer_sys::fuzz_target;
use limits::LIMITS;
use whitted::compile::{self, Queries};
use whitted::eval::{Memory, Options};
use whitted::expanded::{self, MARK, Style};

fuzz_target!(|text: &[u8]| {
    let options = Options { limits: LIMITS, ..Options::default() };
    let read = |text: Vec<u8>| {
        let host = Memory::default().with("a.pov", text);
        expanded::evaluate("a.pov".as_ref(), &options, &host, &Queries::default())
    };
    match read([MARK.as_bytes(), b"\n#version 3.7;\n", text].concat()) {
        Ok(first) => {
            drop(compile::compile(&first.scene));
            let written = expanded::text(&first.scene, &Style::default());
            if let Ok(second) = read(written.clone().into_bytes()) {
                assert_eq!(expanded::text(&second.scene, &Style::default()), written);
            }
        }
        Err(failed) => failed.diagnostics.iter().for_each(|d| drop(d.render(&failed.sources, false))),
    }
});
