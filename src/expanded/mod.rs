//! The expanded language: what is left of POV-Ray's when every directive has run.

mod read;
pub mod write;

pub use write::{Style, text};

use crate::eval::{self, Evaluated, Failed, Host, Options};
use crate::scene::GeometryQueries;
use std::path::Path;

/// The first line of an expanded scene.
pub const MARK: &str = "// whitted: expanded scene, format 1";

/// Whether a text says in its first line that it is an expanded scene.
pub fn is_expanded(text: &[u8]) -> bool {
    text.strip_prefix(MARK.as_bytes()).is_some_and(|rest| matches!(rest.first(), None | Some(b'\n' | b'\r')))
}

/// Reads a scene of either language: an expanded one by its grammar, any other by running it.
///
/// # Errors
/// What is wrong with it, with the files needed to show it.
pub fn evaluate(
    path: &Path,
    options: &Options,
    host: &dyn Host,
    queries: &dyn GeometryQueries,
) -> Result<Evaluated, Box<Failed>> {
    match host.read(path) {
        // What a header includes is a program.
        Ok(text) if is_expanded(&text) && options.header.is_none() => {
            read::evaluate(path, text, options, host, queries)
        }
        Ok(text) => eval::evaluate_text(path, text, options, host, queries),
        // Says why it cannot be read.
        Err(_) => eval::evaluate(path, options, host, queries),
    }
}
