//! Where text came from and what is wrong with it.

mod diagnostic;
mod source_map;

pub use diagnostic::{Diagnostic, Severity, SourceResult};
pub use source_map::{FileId, Span};
