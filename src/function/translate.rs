//! Functions of a scene become functions that can be called: the same operations on other things.

use super::program::{Callee, Op, Program};
use super::{Function, FunctionBody};
use std::sync::Arc;

/// Gives what stands for each thing and function that functions call.
pub trait Translate<T, U> {
    /// Why something cannot be called.
    type Error;

    /// What stands for a pigment or pattern.
    ///
    /// # Errors
    /// What is wrong with it.
    fn external(&self, external: &Arc<T>) -> Result<Arc<U>, Self::Error>;

    /// What stands for a function: its [translation](Function::translated), made once for all that call it.
    ///
    /// # Errors
    /// What is wrong with something that it calls.
    fn function(&self, function: &Arc<Function<T>>) -> Result<Arc<Function<U>>, Self::Error>;
}

impl<T> Function<T> {
    /// The same function of what `translate` gives for what it calls.
    ///
    /// # Errors
    /// The first of `translate`.
    pub fn translated<U, X: Translate<T, U> + ?Sized>(&self, translate: &X) -> Result<Function<U>, X::Error> {
        let body = match &self.body {
            FunctionBody::Program(program) => FunctionBody::Program(program.translated(translate)?),
            FunctionBody::Internal(internal) => FunctionBody::Internal(internal.clone()),
            FunctionBody::External(external) => FunctionBody::External(translate.external(external)?),
            FunctionBody::Spline(spline) => FunctionBody::Spline(Arc::clone(spline)),
            FunctionBody::Transform(transform) => FunctionBody::Transform(*transform),
        };
        Ok(Function { n_parameters: self.n_parameters, body })
    }
}

impl<T> Program<T> {
    fn translated<U, X: Translate<T, U> + ?Sized>(&self, translate: &X) -> Result<Program<U>, X::Error> {
        let ops = self.ops().iter().map(|op| op.translated(translate)).collect::<Result<_, _>>()?;
        Ok(Program::new(ops, self.result()))
    }
}

impl<T> Op<T> {
    fn translated<U, X: Translate<T, U> + ?Sized>(&self, translate: &X) -> Result<Op<U>, X::Error> {
        Ok(match self {
            Self::Constant(value) => Op::Constant(*value),
            Self::Argument(index) => Op::Argument(*index),
            Self::Unary(f, a) => Op::Unary(*f, *a),
            Self::Binary(f, a, b) => Op::Binary(*f, *a, *b),
            Self::Select(slots) => Op::Select(*slots),
            Self::Call { callee, arguments, component, repeats } => {
                let callee = match callee {
                    Callee::Function(function) => Callee::Function(translate.function(function)?),
                    Callee::External(external) => Callee::External(translate.external(external)?),
                    Callee::Spline(spline) => Callee::Spline(Arc::clone(spline)),
                    Callee::Internal(internal) => Callee::Internal(internal.clone()),
                };
                Op::Call { callee, arguments: arguments.clone(), component: *component, repeats: *repeats }
            }
            Self::Fold { product, from, to, body, arguments } => {
                let (body, arguments) = (Arc::new(body.translated(translate)?), arguments.clone());
                Op::Fold { product: *product, from: *from, to: *to, body, arguments }
            }
        })
    }
}
