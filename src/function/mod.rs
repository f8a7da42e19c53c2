//! `function { … }`: what can be called with numbers while reading a scene and while rendering.

mod enclosure;
mod internal;
mod interval;
mod number;
mod program;
mod spline;

pub use enclosure::{Enclosure, EnclosureSlots};
pub use internal::Internal;
pub use interval::Interval;
pub use program::{Binary, Callee, Op, Program, ProgramBuilder, Slot, Slots, Unary, int32};
pub use spline::{Spline, SplineKind};

use crate::math::{DVec3, Transform};
use std::fmt::Debug;
use std::sync::Arc;

/// Anything that takes numbers and gives one to five numbers.
///
/// Pigments and patterns become callable through this trait, so that this module
/// need not know them.
pub trait Callable: Send + Sync + Debug {
    /// How many numbers come back (1 for patterns, 5 for pigments).
    fn width(&self) -> usize;
    /// The value at `args`; components past `width` are 0.
    fn call(&self, args: &[f64]) -> [f64; 5];
}

/// A declared function.
#[derive(Clone, Debug)]
pub struct Function {
    /// How many arguments a call takes.
    pub n_parameters: usize,
    /// What it does.
    pub body: FunctionBody,
}

/// The sorts of function.
#[derive(Clone, Debug)]
pub enum FunctionBody {
    /// An expression.
    Program(Program),
    /// `internal(N)`.
    Internal(Internal),
    /// A pigment, a pattern or a spline.
    External(Arc<dyn Callable>),
    /// `transform { … }`: carries a point.
    Transform(Transform),
}

impl Function {
    /// How many numbers a call returns.
    pub fn width(&self) -> usize {
        match &self.body {
            FunctionBody::Program(_) | FunctionBody::Internal(_) => 1,
            FunctionBody::External(e) => e.width(),
            FunctionBody::Transform(_) => 3,
        }
    }

    /// The value; components past the width are 0, missing arguments count as 0.
    pub fn call(&self, args: &[f64]) -> [f64; 5] {
        match &self.body {
            FunctionBody::Program(p) => [p.eval(args), 0.0, 0.0, 0.0, 0.0],
            FunctionBody::Internal(i) => [i.eval(args), 0.0, 0.0, 0.0, 0.0],
            FunctionBody::External(e) => e.call(args),
            FunctionBody::Transform(t) => {
                let at = |i: usize| args.get(i).copied().unwrap_or(0.0);
                let p = t.point(DVec3::new(at(0), at(1), at(2)));
                [p.x, p.y, p.z, 0.0, 0.0]
            }
        }
    }

    /// As [`at`](Self::at), with working memory to use again for the next call.
    pub fn at_in(&self, p: DVec3, slots: &mut Slots) -> f64 {
        match &self.body {
            FunctionBody::Program(program) => program.eval_in(&[p.x, p.y, p.z], slots),
            _ => self.at(p),
        }
    }

    /// The first returned number at a point: what patterns and isosurfaces ask for.
    pub fn at(&self, p: DVec3) -> f64 {
        self.call(&[p.x, p.y, p.z])[0]
    }
}

impl Callable for Spline {
    fn width(&self) -> usize {
        Self::width(self)
    }

    fn call(&self, args: &[f64]) -> [f64; 5] {
        self.at(args.first().copied().unwrap_or(0.0))
    }
}
