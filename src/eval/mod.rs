//! Tokens to scene: scopes, directives, macros, expressions.
//!
//! The evaluator pulls tokens from a stack of cursors and runs every directive
//! and macro call it meets on the way, so a block parser sees only what is left: the
//! scene as it would stand without any directive. One token is held back; the
//! rule for where a directive waits until the value before it is complete
//! (language facts, section 15) is the `hold` argument of `Evaluator::fill`.
//!
//! It owns five parts that know nothing of each other: the `feed` gives tokens, `names` say what words stand for, the
//! `budget` counts what is used up, the `report` keeps what is said, and the `world` is what lies outside. That touches no
//! disk and prints nothing: everything comes through [`Host`].
//!
//! ```
//! use whitted::eval::{Memory, NoQueries, Options, evaluate};
//! let host = Memory::new([("a.pov", "#version 3.7; #debug concat(\"sum \", str(1 + 2, 0, 0))")]);
//! let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries).unwrap();
//! assert_eq!(read.scene.settings.version, 370);
//! assert_eq!(host.messages(), "sum 3");
//! ```

mod advice;
mod arguments;
mod arrays;
pub mod blocks;
mod budget;
mod colors;
mod conditions;
mod data_file;
mod declarations;
mod directives;
mod disk;
mod expressions;
mod feed;
mod files;
mod float_functions;
mod formulas;
mod geometry_functions;
mod host;
mod includes;
mod loops;
mod macro_results;
mod macros;
mod messages;
mod names;
mod operands;
mod options;
mod printf;
mod random;
mod recovery;
mod report;
mod standard_includes;
mod statements;
mod strings;
mod tokens;
mod transforms;
mod unused;
mod value;
mod vector_functions;
mod vector_lists;
mod walk;
mod world;

#[cfg(test)]
mod formula_probes;
#[cfg(test)]
mod probes;

pub use disk::{Disk, Reach};
pub use host::{Host, Kept, Memory, NoQueries, Status, Stream};
pub use options::{Limits, Options, Overrides};
pub use printf::date_time;
pub use standard_includes::{standard_include, standard_include_names};
pub use value::{Array, Macro, Number, Value};

use crate::diag::{Diagnostic, SourceMap, SourceResult, Span, Topic};
use crate::scene::{Finish, Gamma, GeometryQueries, Scene, Settings};
use crate::syntax::{Position, Source, TokenKind};
use budget::Budget;
use directives::Block;
use feed::{Cursor, Feed, Role};
use names::{Names, Place};
use report::Report;
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;
use world::World;

/// A scene that was read, with what was said about it.
#[derive(Debug)]
pub struct Evaluated {
    /// What the file describes.
    pub scene: Scene,
    /// Everything worth mentioning.
    pub warnings: Vec<Diagnostic>,
    /// The files that were read, to show the warnings.
    pub sources: SourceMap,
}

/// Why a scene could not be read.
#[derive(Debug)]
pub struct Failed {
    /// At least one error, and the warnings before it.
    pub diagnostics: Vec<Diagnostic>,
    /// The files that were read, to show them.
    pub sources: SourceMap,
}

/// Reads a scene.
pub struct Evaluator<'h> {
    pub(super) scene: Scene,
    #[allow(dead_code, reason = "read by the block parsers")]
    pub(super) defaults: blocks::Defaults,
    pub(super) queries: &'h dyn GeometryQueries,
    pub(super) options: &'h Options,
    /// Language version in hundredths, as `#version` last set it; at the start that of the options, else 370.
    pub(super) version: u32,
    /// Whether a `#version` was met.
    pub(super) version_given: bool,
    /// What comes next.
    feed: Feed,
    /// What names stand for.
    names: Names,
    /// What is used up.
    budget: Budget,
    /// What is said.
    report: Report,
    /// What lies outside.
    world: World<'h>,
    open_blocks: Vec<Block>,
    /// Inside a declared value or an argument, outside any bracket.
    bare: bool,
    /// Parentheses around the current expression (for version 1.0).
    parentheses: usize,
    /// A `#switch` that waits for its first `#case`.
    case_wanted: bool,
    random: random::Streams,
    /// The finish that was written last.
    last_finish: Option<Arc<Finish>>,
    /// The directive whose block an error kept from being opened.
    unopened: Option<Span>,
    /// `utf8` strings, from a byte order mark or `charset`.
    pub(super) utf8: bool,
}

/// Reads the scene in `path` and everything it includes.
///
/// Runs on a large stack of its own, since blocks may nest deeply; on the caller's thread, because the system's
/// allocator serves the first thread best.
///
/// # Errors
/// What is wrong with the scene, with the files needed to show it.
pub fn evaluate(
    path: &Path,
    options: &Options,
    host: &dyn Host,
    queries: &dyn GeometryQueries,
) -> Result<Evaluated, Box<Failed>> {
    let text = host.read(path).map_err(|e| {
        let why = format!("cannot read {}: {e}", path.display());
        let diagnostics = vec![Diagnostic::error(Span::default(), why).without_place()];
        Box::new(Failed { diagnostics, sources: SourceMap::default() })
    })?;
    evaluate_text(path, text, options, host, queries)
}

/// The same for a text that was read already.
///
/// # Errors
/// Those of [`evaluate`].
pub fn evaluate_text(
    path: &Path,
    text: Vec<u8>,
    options: &Options,
    host: &dyn Host,
    queries: &dyn GeometryQueries,
) -> Result<Evaluated, Box<Failed>> {
    /// Address space, of which only what is used costs anything.
    const STACK: usize = 512 << 20;
    stacker::grow(STACK, || Evaluator::new(options, host, queries).run(path, text))
}

impl<'h> Evaluator<'h> {
    fn new(options: &'h Options, host: &'h dyn Host, queries: &'h dyn GeometryQueries) -> Self {
        Self {
            scene: Scene::default(),
            defaults: blocks::Defaults::default(),
            queries,
            options,
            version: options.version.unwrap_or(370),
            version_given: false,
            feed: Feed::default(),
            names: Names::default(),
            budget: Budget::new(options.limits),
            report: Report::default(),
            world: World::new(host, &options.include_dirs),
            open_blocks: Vec::new(),
            bare: false,
            parentheses: 0,
            case_wanted: false,
            random: random::Streams::default(),
            last_finish: None,
            unopened: None,
            utf8: false,
        }
    }

    fn run(mut self, path: &Path, text: Vec<u8>) -> Result<Evaluated, Box<Failed>> {
        let read = self.read_scene(path, text);
        let (warnings, sources) = self.report.into_warnings();
        match read {
            Ok(()) => Ok(Evaluated { scene: self.scene, warnings, sources }),
            Err(mut errors) => {
                let mut diagnostics = warnings;
                diagnostics.append(&mut errors);
                Err(Box::new(Failed { diagnostics, sources }))
            }
        }
    }

    fn read_scene(&mut self, path: &Path, text: Vec<u8>) -> SourceResult<()> {
        self.utf8 = text.starts_with(b"\xef\xbb\xbf");
        let source = self.take_in(path, text)?;
        self.declare_given(path);
        self.feed.push(Cursor::new(source, (Position::default(), None), Role::Main));
        if let Some(header) = &self.options.header {
            self.open_include(&header.to_string_lossy(), Span::default())?;
        }
        loop {
            let start = self.feed.next_position();
            let goes_on = match self.statement() {
                Ok(goes_on) => goes_on,
                Err(errors) => self.recover(start, errors),
            };
            if !goes_on {
                break;
            }
        }
        let errors = self.report.take_errors();
        if !errors.is_empty() {
            return Err(errors);
        }
        self.check_radiosity()?;
        self.finish();
        Ok(())
    }

    /// Reads one object, block or directive of the scene; false at its end.
    fn statement(&mut self) -> SourceResult<bool> {
        if self.peek()?.kind == TokenKind::End {
            return Ok(false);
        }
        if !self.hashless_directive()? && !self.scene_item()? {
            return self.expected("an object, a block or a directive");
        }
        Ok(true)
    }

    /// The version by which gamma and backgrounds go: a scene that never says one counts as 3.62.
    pub(super) fn effective_version(&self) -> u32 {
        let unstated = || self.options.version.unwrap_or(Settings::default().version);
        if self.version_given { self.version } else { unstated() }
    }

    /// What holds for the scene as a whole once all of it is read.
    fn finish(&mut self) {
        let (settings, overrides) = (&mut self.scene.settings, &self.options.overrides);
        settings.max_parts = self.options.limits.parts;
        settings.max_trace_level = overrides.max_trace_level.unwrap_or(settings.max_trace_level);
        settings.adc_bailout = overrides.adc_bailout.unwrap_or(settings.adc_bailout);
        let version = self.effective_version();
        self.scene.settings.version = version;
        if !self.version_given && self.options.version.is_none() {
            self.warn_once(
                Topic::Version,
                Span::default(),
                "this scene has no #version, so rules from before version 3.7 hold; start it with '#version 3.7;'",
            );
        }
        if !self.defaults.gamma_given && version.max(self.options.version.unwrap_or(0)) >= 370 {
            // A version among the options counts here even where the scene goes below it.
            self.scene.settings.gamma = Gamma::implied(370);
            self.report.remark(
                Topic::Version,
                "assumed_gamma is not given, so 1.0 is taken; 'global_settings { assumed_gamma 1.0 }' says so",
            );
        }
        self.scene.unused = unused::unused(&self.names, self.options.keep);
        if self.scene.objects.is_empty() {
            self.report.remark(Topic::Geometry, "there are no objects in this scene");
        }
    }

    /// Registers the text of a file.
    fn take_in(&mut self, path: &Path, text: Vec<u8>) -> SourceResult<Rc<Source>> {
        let too_long = u32::try_from(text.len()).is_err();
        let text = self.world.text(path, text);
        let file = self.report.add(path.display().to_string(), text.bytes());
        if too_long {
            return self.error(Span { file, start: 0, end: 0 }, "files above four gigabytes cannot be read");
        }
        Ok(Rc::new(Source::new(file, text)))
    }

    /// Declares what exists before the first line: image size, frame numbers, `Declare=`.
    fn declare_given(&mut self, path: &Path) {
        let o = self.options;
        let frames = ["initial_frame", "final_frame", "frame_number", "initial_clock", "final_clock", "clock_delta"];
        let mut floats: Vec<(&str, f64)> = frames.into_iter().zip(o.animation).collect();
        floats.push(("image_width", f64::from(o.image_width)));
        floats.push(("image_height", f64::from(o.image_height)));
        floats.extend(o.declarations.iter().map(|(name, value)| (name.as_str(), *value)));
        for (name, value) in floats {
            let symbol = self.names.words.intern(name);
            self.names.bind(Names::GLOBAL, symbol, Place::new(Value::Float(value)));
        }
        let symbol = self.names.words.intern("input_file_name");
        let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        self.names.bind(Names::GLOBAL, symbol, Place::new(Value::String(name.into())));
    }
}
