//! What every command that measures needs: child processes and their cost, the machine, plots, and how far it has come.

mod machine;
mod process;
mod program;
mod progress;

pub(crate) mod number;
pub(crate) mod plot;

pub use machine::{Machine, povray_version};
pub use process::{Invocation, Run};
pub use program::{Caller, Program, Task};
pub(crate) use progress::Progress;
pub use progress::Watcher;

/// The style of pages with plots, by day and by night.
pub(crate) const STYLE: &str = include_str!("style.css");
