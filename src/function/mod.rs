//! `function { … }`: what can be called with numbers while reading a scene and while rendering.

mod enclosure;
mod internal;
mod interval;
mod number;
mod program;
mod spline;
mod translate;

pub use enclosure::{Enclosure, EnclosureSlots};
pub use internal::Internal;
pub use interval::Interval;
pub use program::{Binary, Callee, Op, Program, ProgramBuilder, Slot, Slots, Unary, int32};
pub use spline::{Spline, SplineKind};
pub use translate::Translate;

use crate::math::{DVec3, Transform};
use std::fmt::Debug;
use std::sync::Arc;

/// What functions call that this module does not know: pigments and patterns.
///
/// In a scene they are data, which nobody can call by itself; in a compiled one they are [`Callable`].
pub trait External: Clone + Debug + Send + Sync {
    /// How many numbers come back (1 for patterns, 5 for pigments).
    fn width(&self) -> usize;
}

/// Something external that takes numbers and gives one to five numbers.
pub trait Callable: External {
    /// The value at `args`; components past `width` are 0.
    fn call(&self, args: &[f64]) -> [f64; 5];
}

/// Who knows how to call what is external.
pub trait Caller<T> {
    /// What it gives for these arguments; components past its width are 0.
    fn call(&self, external: &Arc<T>, args: &[f64]) -> [f64; 5];
}

/// Calls what can be called by itself.
#[derive(Clone, Copy, Debug)]
pub struct Direct;

impl<T: Callable> Caller<T> for Direct {
    #[inline]
    fn call(&self, external: &Arc<T>, args: &[f64]) -> [f64; 5] {
        external.call(args)
    }
}

/// A declared function, which may call things of type `T`.
#[derive(Clone, Debug)]
pub struct Function<T> {
    /// How many arguments a call takes.
    pub n_parameters: usize,
    /// What it does.
    pub body: FunctionBody<T>,
}

/// The sorts of function.
#[derive(Clone, Debug)]
pub enum FunctionBody<T> {
    /// An expression.
    Program(Program<T>),
    /// `internal(N)`.
    Internal(Internal),
    /// A pigment or a pattern.
    External(Arc<T>),
    /// A spline.
    Spline(Arc<Spline>),
    /// `transform { … }`: carries a point.
    Transform(Transform),
}

impl<T: External> Function<T> {
    /// How many numbers a call returns.
    pub fn width(&self) -> usize {
        match &self.body {
            FunctionBody::Program(_) | FunctionBody::Internal(_) => 1,
            FunctionBody::External(e) => e.width(),
            FunctionBody::Spline(s) => s.width(),
            FunctionBody::Transform(_) => 3,
        }
    }

    /// The value, where `caller` calls what is external; components past the width are 0, missing arguments count as 0.
    pub fn call_by(&self, args: &[f64], caller: &(impl Caller<T> + ?Sized)) -> [f64; 5] {
        match &self.body {
            FunctionBody::Program(p) => [p.eval_by(args, &mut p.slots(), caller), 0.0, 0.0, 0.0, 0.0],
            FunctionBody::Internal(i) => [i.eval(args), 0.0, 0.0, 0.0, 0.0],
            FunctionBody::External(e) => caller.call(e, args),
            FunctionBody::Spline(s) => s.at(args.first().copied().unwrap_or(0.0)),
            FunctionBody::Transform(t) => {
                let at = |i: usize| args.get(i).copied().unwrap_or(0.0);
                let p = t.point(DVec3::new(at(0), at(1), at(2)));
                [p.x, p.y, p.z, 0.0, 0.0]
            }
        }
    }
}

impl<T: Callable> Function<T> {
    /// The value; components past the width are 0, missing arguments count as 0.
    pub fn call(&self, args: &[f64]) -> [f64; 5] {
        self.call_by(args, &Direct)
    }

    /// As [`at`](Self::at), with working memory to use again for the next call.
    pub fn at_in(&self, p: DVec3, slots: &mut Slots) -> f64 {
        match &self.body {
            FunctionBody::Program(program) => program.eval_by(&[p.x, p.y, p.z], slots, &Direct),
            _ => self.at(p),
        }
    }

    /// The first returned number at a point: what patterns and isosurfaces ask for.
    pub fn at(&self, p: DVec3) -> f64 {
        self.call(&[p.x, p.y, p.z])[0]
    }
}
