//! A Whitted-style recursive ray tracer for POV-Ray 3.7 scenes.
//!
//! Data moves one way, and a module knows those before it in this list, never those behind it:
//!
//! 1. [`omission`], [`math`], [`diag`], [`imaging`], [`function`]: what may be left out, vectors and noise, places and
//!    messages, picture files, programs of `function {}` blocks; all stand beside the way.
//! 2. [`syntax`]: text to tokens, once for each file; the one grammar of expressions.
//! 3. [`scene`]: what a file describes, as plain data in POV-Ray's words; [`eval`] runs the tokens and makes it, with blocks
//!    described as tables ([`eval::blocks::described`]).
//! 4. [`compiled`]: what rays meet, in the field's words; [`compile`] makes it, and refuses what is wrong.
//! 5. [`render`]: from camera rays to pixels; cannot fail.
//! 6. [`job`]: one configuration, a session that owns what pictures share, an observer.
//! 7. [`measure`]: child processes and what they cost, plots; [`report`]: error against run time; [`stability`]: how far
//!    scenes can be driven before a picture breaks. Both make pictures over and over, by this program and by POV-Ray.
//! 8. [`cli`]: arguments to a job; the only part that prints.
//!
//! ```
//! use whitted::eval::Memory;
//! use whitted::job::{Job, Session};
//! use whitted::render::Unobserved;
//! let scene = "#version 3.7; camera { location -3*z look_at 0 } light_source { -9*z, 1 } sphere { 0, 1 pigment { rgb x } }";
//! let job = Job { scene: "ball.pov".into(), ..Job::default() };
//! let outcome = Session::new(1).render(&job, &Memory::new([("ball.pov", scene)]), &Unobserved).unwrap();
//! let middle = outcome.picture.pixel(160, 120);
//! assert!(middle[0] > 0.5 && middle[1] == 0.0);
//! ```
//!
//! `ARCHITECTURE.md` tells the way of one ray, function by function, and why things are as they are.

pub mod cli;
pub mod compile;
pub mod compiled;
pub mod diag;
pub mod eval;
pub mod expanded;
pub mod function;
pub mod imaging;
pub mod job;
pub mod math;
pub mod measure;
pub mod omission;
pub mod render;
pub mod report;
pub mod scene;
pub mod stability;
mod stack;
pub mod syntax;
