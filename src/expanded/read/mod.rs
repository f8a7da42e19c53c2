//! A text of the expanded language as a scene: pest makes the tree, and the tree is taken apart.

mod appearance;
mod functions;
mod implicit;
mod lights;
mod meshes;
mod objects;
mod outlines;
mod patterns;
mod pictures;
mod pigments;
mod reader;
mod scan;
mod settings;
mod shapes;
mod surroundings;
mod transforms;
mod tree;

use crate::diag::{Diagnostic, FileId, SourceMap, Span};
use crate::eval::{Evaluated, Failed, Host, Options};
use crate::scene::GeometryQueries;
use pest::Parser as _;
use pest::error::{ErrorVariant, InputLocation};
use reader::Reader;
use std::path::Path;
use std::sync::Arc;
use tree::{Rule, SceneParser};

/// Reads an expanded scene; it is data, and runs nothing.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub(super) fn evaluate(
    path: &Path,
    text: Vec<u8>,
    options: &Options,
    host: &dyn Host,
    queries: &dyn GeometryQueries,
) -> Result<Evaluated, Box<Failed>> {
    /// Address space, of which only what is used costs anything.
    const STACK: usize = 1 << 30;
    let mut sources = SourceMap::default();
    let bytes = Arc::new(text);
    sources.add(path.display().to_string(), Arc::clone(&bytes));
    let scene = stacker::grow(STACK, || {
        let text = checked(&bytes, options)?;
        let tree = SceneParser::parse(Rule::scene, text).map_err(|error| Box::new(unparsed(&error, text)))?;
        let mut reader = Reader::new(path, options, host, queries);
        tree.into_iter().try_for_each(|scene| reader.scene(scene))?;
        Ok(reader.scene)
    });
    match scene {
        Ok(scene) => Ok(Evaluated { scene, warnings: Vec::new(), sources }),
        Err(error) => {
            let error: Box<Diagnostic> = error;
            Err(Box::new(Failed { diagnostics: vec![*error], sources }))
        }
    }
}

/// Deepest nesting of braces and parentheses: pest calls itself for each, and needs some 10 KB of stack for it.
const MAX_NESTING: usize = 20_000;

/// The bytes as text, if they are, and if nothing nests too deeply for a parser that calls itself.
fn checked<'t>(bytes: &'t [u8], options: &Options) -> Result<&'t str, Box<Diagnostic>> {
    let at = |start: usize| Span { file: FileId(0), start: start as u32, end: start as u32 + 1 };
    let text = std::str::from_utf8(bytes).map_err(|error| {
        Box::new(Diagnostic::error(at(error.valid_up_to()), "this is no UTF-8: an expanded scene is plain text"))
    })?;
    if u32::try_from(bytes.len()).is_err() {
        return Err(Box::new(Diagnostic::error(at(0), "files above four gigabytes cannot be read")));
    }
    let limit = options.limits.nesting.min(MAX_NESTING);
    let mut depth = 0_usize;
    for (i, byte) in bytes.iter().enumerate() {
        match byte {
            b'{' | b'(' | b'[' => depth += 1,
            b'}' | b')' | b']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > limit {
            let message = format!("more than {limit} levels of braces and parentheses");
            return Err(Box::new(Diagnostic::error(at(i), message)));
        }
    }
    Ok(text)
}

/// What pest says of a text that the grammar does not take.
fn unparsed(error: &pest::error::Error<Rule>, text: &str) -> Diagnostic {
    let start = match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    };
    let length = text[start..].split(|c: char| !c.is_alphanumeric() && c != '_').next().map_or(0, str::len).max(1);
    let span = Span { file: FileId(0), start: start as u32, end: (start + length).min(text.len()) as u32 };
    let expected = match &error.variant {
        ErrorVariant::ParsingError { positives, .. } => one_of(positives),
        ErrorVariant::CustomError { message } => message.clone(),
    };
    Diagnostic::error(span, format!("expected {expected}")).hint(
        "an expanded scene has no expressions and no directives but #version, #declare and #default; \
         without its first line it is read as any other scene",
    )
}

/// Most alternatives that are told.
const MAX_TOLD: usize = 8;

/// Names of rules, as people say them.
fn one_of(rules: &[Rule]) -> String {
    let mut names: Vec<String> = rules.iter().map(|rule| name(*rule)).collect();
    names.sort();
    names.dedup();
    let more = names.len() > MAX_TOLD;
    names.truncate(MAX_TOLD);
    match names.split_last() {
        None => "something else".to_owned(),
        Some(_) if more => format!("{} and so on", names.join(", ")),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}

fn name(rule: Rule) -> String {
    match rule {
        Rule::EOI => "the end".into(),
        Rule::identifier => "a declared name".into(),
        Rule::number | Rule::literal => "a number".into(),
        Rule::vector => "a vector".into(),
        Rule::string | Rule::file => "a string in quotes".into(),
        Rule::switch => "'on' or 'off'".into(),
        Rule::color => "a colour".into(),
        Rule::cube => "box".into(),
        Rule::version => "'#version'".into(),
        Rule::polynomial => "poly".into(),
        Rule::known_object => "object".into(),
        Rule::variable => "a variable".into(),
        rule => format!("{rule:?}").trim_end_matches("_word").replace('_', " "),
    }
}
