//! From a scene's name to finished files: one configuration, a session that outlives it, an observer.
//!
//! A [`Job`] holds everything that a picture depends on. A [`Session`] owns what several jobs share, its threads first
//! of all, and takes them through the stages: read, compile, render, write.

mod animation;
mod exposure;
mod identity;
mod library;
mod light_files;
mod outcome;
mod projection;
mod recipe;
mod sequence;
mod session;
mod settings;
mod shelf;
mod state;

pub use animation::{Animation, single, six_digits};
pub use exposure::Exposure;
pub use identity::Identity;
pub use light_files::LightFiles;
pub use outcome::{Explanation, Outcome, Ready, Timings};
pub use sequence::measured_in_order;
pub use session::Session;
pub use settings::{Job, Keeping, Output, PATIENCE};
pub use state::Earlier;
