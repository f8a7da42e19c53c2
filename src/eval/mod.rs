//! Tokens to scene.
#![allow(unused_variables, dead_code)]

pub mod blocks;
mod host;
mod tokens;
mod value;

pub use host::{Host, Stream};
pub use value::{Array, Macro, Number, Value};

use crate::diag::{Diagnostic, SourceResult, Span};
use crate::math::{Color, DVec2, DVec3, DVec4, Rgb, Transform};
use crate::scene::{GeometryQueries, Scene};
use crate::syntax::{Keyword, Token};
use std::path::PathBuf;
use std::rc::Rc;

/// Reads a scene.
pub struct Evaluator<'h> {
    pub(super) scene: Scene,
    pub(super) defaults: blocks::Defaults,
    pub(super) host: &'h dyn Host,
    pub(super) queries: &'h (dyn GeometryQueries + Sync),
    ahead: Option<Token>,
    warnings: Vec<Diagnostic>,
    /// Language version in hundredths.
    pub(super) version: u32,
}

#[allow(missing_docs, dead_code, unused_variables, clippy::missing_errors_doc)]
impl Evaluator<'_> {
    pub fn declared(&mut self) -> SourceResult<Option<Value>> {
        self.expected("x")
    }
    pub fn take_declared<T>(&mut self, pick: impl Fn(&Value) -> Option<T>) -> SourceResult<Option<T>> {
        self.expected("x")
    }
    pub fn starts_expression(&mut self) -> SourceResult<bool> {
        self.expected("x")
    }
    pub fn float(&mut self) -> SourceResult<f64> {
        self.expected("x")
    }
    pub fn integer(&mut self) -> SourceResult<i64> {
        self.expected("x")
    }
    pub fn vector2(&mut self) -> SourceResult<DVec2> {
        self.expected("x")
    }
    pub fn vector(&mut self) -> SourceResult<DVec3> {
        self.expected("x")
    }
    pub fn vector4(&mut self) -> SourceResult<DVec4> {
        self.expected("x")
    }
    /// Any number of components, as a declaration takes it.
    pub fn any_expression(&mut self) -> SourceResult<Number> {
        self.expected("x")
    }
    pub fn starts_color(&mut self) -> SourceResult<bool> {
        self.expected("x")
    }
    pub fn color(&mut self) -> SourceResult<Color> {
        self.expected("x")
    }
    pub fn rgb_only(&mut self, what: &str) -> SourceResult<Rgb> {
        self.expected("x")
    }
    pub fn starts_string(&mut self) -> SourceResult<bool> {
        self.expected("x")
    }
    pub fn string(&mut self) -> SourceResult<Rc<str>> {
        self.expected("x")
    }
    /// A string in which a backslash is itself: file names.
    pub fn file_name(&mut self) -> SourceResult<Rc<str>> {
        self.expected("x")
    }
    pub fn optional_bool(&mut self) -> SourceResult<bool> {
        self.expected("x")
    }
    pub fn vector_list(&mut self, n: usize) -> SourceResult<Vec<DVec3>> {
        self.expected("x")
    }
    pub fn vector2_list(&mut self, n: usize) -> SourceResult<Vec<DVec2>> {
        self.expected("x")
    }
    pub fn transformation(&mut self) -> SourceResult<Option<Transform>> {
        self.expected("x")
    }
    /// The items of `transform { … }`, after its keyword.
    pub fn transform_block(&mut self) -> SourceResult<Transform> {
        self.expected("x")
    }
    pub fn error<T>(&self, span: Span, message: impl Into<String>) -> SourceResult<T> {
        Err(vec![Diagnostic::error(span, message)])
    }
    /// "expected WHAT, found …" at the peeked token.
    pub fn expected<T>(&mut self, what: &str) -> SourceResult<T> {
        let span = self.span();
        self.error(span, format!("expected {what}"))
    }
    pub fn warn(&mut self, span: Span, message: impl Into<String>) {
        self.warnings.push(Diagnostic::warning(span, message));
    }
    pub fn warn_once(&mut self, key: &'static str, span: Span, message: impl Into<String>) {
        self.warnings.push(Diagnostic::warning(span, message));
    }
    /// Where the peeked token stands.
    pub fn span(&mut self) -> Span {
        Span::default()
    }
    /// Search path of the language facts, section 12.
    pub fn find_file(&mut self, name: &str, extensions: &[&str]) -> Option<PathBuf> {
        None
    }
    pub fn keyword(&mut self) -> SourceResult<Option<Keyword>> {
        self.expected("x")
    }
}
