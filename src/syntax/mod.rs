//! Text to tokens.

mod directive;
mod keyword;
mod names;
mod token;

pub use directive::Directive;
pub use keyword::Keyword;
pub use names::{Names, Symbol};
pub use token::{Token, TokenKind};
