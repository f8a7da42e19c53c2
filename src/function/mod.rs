//! `function { … }`: what can be called with numbers while reading a scene and while rendering.

mod spline;

pub use spline::{Spline, SplineKind};

use crate::math::Transform;
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
    /// A pigment, a pattern or a spline.
    External(Arc<dyn Callable>),
    /// `transform { … }`: carries a point.
    Transform(Transform),
}

impl Function {
    /// How many numbers a call gives.
    pub fn width(&self) -> usize {
        match &self.body {
            FunctionBody::External(callable) => callable.width(),
            FunctionBody::Transform(_) => 3,
        }
    }

    /// The value at `args`, of which there must be [`n_parameters`](Self::n_parameters).
    pub fn call(&self, args: &[f64]) -> [f64; 5] {
        match &self.body {
            FunctionBody::External(callable) => callable.call(args),
            FunctionBody::Transform(transform) => {
                let component = |i: usize| args.get(i).copied().unwrap_or(0.0);
                let p = transform.point(crate::math::DVec3::new(component(0), component(1), component(2)));
                [p.x, p.y, p.z, 0.0, 0.0]
            }
        }
    }
}
