//! The `whitted` program.

use std::process::ExitCode;

mod huge_pages;

#[global_allocator]
static ALLOCATOR: huge_pages::HugePages = huge_pages::HugePages;

fn main() -> ExitCode {
    /// Address space, of which only what is used costs anything: scenes may nest deeply, and each level takes a few
    /// hundred bytes when it is dropped.
    const STACK: usize = 256 << 20;
    huge_pages::prepare();
    stacker::grow(STACK, whitted::cli::run)
}
