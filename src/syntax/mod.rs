//! Text to tokens, files as runs of tokens that know where their blocks end, and the grammar of expressions.
//!
//! ```text
//! bytes -> tokens, in pieces (a lexer by hand; grammar/tokens.pest specifies it) -> Source
//! ```
//!
//! In this language directives and macro calls may stand between any two tokens: a brace
//! may open in one branch of an `#if` and close in another, an expression may be cut by
//! an `#include`, and what a name means (number, object, macro, array) is known only
//! when it is met. A tree of a whole file made beforehand would hold for few files. So the
//! lexer stops at tokens, each made once however often a loop runs, with words already
//! turned into integers and numbers into floats; the evaluator reads blocks from them by
//! recursive descent, and expressions by one grammar, whatever is built of them ([`expression`]).
//!
//! Three things are more than tokens. Expressions that stand whole become trees when
//! they are met again ([`formula`]), which makes loops several times faster. Literal
//! vectors separated by commas are one token of any length, so that a mesh costs its text
//! and nothing else ([`vectors`]). And directives know where their branch ends, so that
//! skipping and leaving loops jumps ([`Source::branch_end`]).

pub mod built_in;
mod directive;
mod dump;
pub mod expression;
pub mod formula;
mod keyword;
mod lexer;
mod memo;
mod numbers;
mod source;
mod text;
mod token;
pub mod vectors;
mod words;

pub use directive::Directive;
pub use dump::{dump_tokens, dump_tree};
pub use keyword::Keyword;
pub(crate) use numbers::number;
pub use source::{Piece, Position, Source};
pub use text::Text;
pub use token::{Malformed, Token, TokenKind};
pub use words::{Symbol, Words};
