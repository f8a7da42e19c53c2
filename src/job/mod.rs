//! From a scene's name to finished files: one configuration, a session that outlives it, an observer.
//!
//! A [`Job`] holds everything that a picture depends on. A [`Session`] owns what several jobs share, its threads first
//! of all, and takes them through the stages: read, compile, render, write.

mod library;
mod outcome;
mod session;
mod settings;
mod shelf;

pub use outcome::{Explanation, Outcome, Ready, Timings};
pub use session::Session;
pub use settings::{Job, Output};
