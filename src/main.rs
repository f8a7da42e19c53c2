//! The `whitted` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    whitted::cli::run()
}
