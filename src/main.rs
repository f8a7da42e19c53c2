//! The `whitted` program.

use std::process::ExitCode;

mod huge_pages;

#[global_allocator]
static ALLOCATOR: huge_pages::HugePages = huge_pages::HugePages;

fn main() -> ExitCode {
    huge_pages::prepare();
    whitted::cli::run()
}
