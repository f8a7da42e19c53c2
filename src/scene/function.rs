//! Functions, and what they call: pigments and patterns.

use super::{Pattern, Pigment, Settings};
use crate::function::{self, External};
use std::sync::Arc;

/// A declared function.
pub type Function = function::Function<PointFunction>;

/// `function { pigment … }` or `function { pattern … }`.
#[derive(Clone, Debug)]
pub struct PointFunction {
    /// What it gives the colour or the value of.
    pub source: PointSource,
    /// The settings that held where it was declared.
    pub settings: Arc<Settings>,
}

/// What has a colour or a value at each point.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum PointSource {
    Pigment(Pigment),
    Pattern(Pattern),
}

impl External for PointFunction {
    fn width(&self) -> usize {
        match self.source {
            PointSource::Pigment(_) => 5,
            PointSource::Pattern(_) => 1,
        }
    }
}
