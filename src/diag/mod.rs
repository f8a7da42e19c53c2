//! Where text came from and what is wrong with it.
//!
//! ```
//! use whitted::diag::{Diagnostic, SourceMap, Span};
//! let mut sources = SourceMap::default();
//! let file = sources.add("a.pov", std::sync::Arc::new(b"spere { 0 1 }".to_vec()));
//! let wrong = Diagnostic::error(Span { file, start: 0, end: 5 }, "unknown name 'spere'");
//! assert!(wrong.render(&sources, false).contains("a.pov:1:1"));
//! ```

mod diagnostic;
mod render;
mod source_map;
mod suggest;
mod topic;

pub use diagnostic::{Diagnostic, Severity, SourceResult};
pub use source_map::{Excerpt, FileId, LineColumn, SourceFile, SourceMap, Span, Visit, Way};
pub use suggest::{completed, nearest};
pub use topic::Topic;
