//! A Whitted-style recursive ray tracer for POV-Ray 3.7 scenes.

pub mod cli;
pub mod compile;
pub mod compiled;
pub mod diag;
pub mod eval;
pub mod function;
pub mod imaging;
pub mod job;
pub mod math;
pub mod render;
pub mod scene;
mod stack;
pub mod syntax;
