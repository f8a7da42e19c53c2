//! `whitted dump`: what a stage makes of a scene, as text.

use super::scene_arguments::SceneArguments;
use super::{ERROR, explain, fail, print};
use crate::compile::{self, Queries};
use crate::diag::SourceMap;
use crate::eval::Host as _;
use crate::expanded;
use crate::syntax;
use std::process::ExitCode;
use std::sync::Arc;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// The stage after which to stop
    #[arg(long, value_enum)]
    stage: Stage,
}

/// After which stage.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Stage {
    /// The scene file's own tokens, one on a line
    Tokens,
    /// The scene file's directives with the lines they reach over
    Tree,
    /// What the scene describes once every directive has run, in the expanded language
    Scene,
    /// The graph as rays meet it: groups, instances, solids, places, boxes and textures, and what was left out
    Compiled,
}

/// Prints the text, or the errors.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let text = match arguments.stage {
        Stage::Tokens => file(arguments, syntax::dump_tokens),
        Stage::Tree => file(arguments, syntax::dump_tree),
        Stage::Scene | Stage::Compiled => scene(arguments),
    };
    match text {
        Ok(text) => print(&text),
        Err(code) => code,
    }
}

/// The text of the scene file alone.
fn file(arguments: &Arguments, dump: fn(&syntax::Source, &SourceMap) -> String) -> Result<String, ExitCode> {
    let path = &arguments.scene.scene;
    let text = arguments.scene.host().read(path).map_err(|error| fail(format_args!("{}: {error}", path.display())))?;
    let text = Arc::new(syntax::Text::new(text));
    let mut sources = SourceMap::default();
    let file = sources.add(path.display().to_string(), Arc::clone(text.bytes()));
    Ok(dump(&syntax::Source::new(file, text), &sources))
}

/// The scene, evaluated and perhaps compiled.
fn scene(arguments: &Arguments) -> Result<String, ExitCode> {
    let scene = &arguments.scene;
    let (width, height) = super::render::DEFAULT_SIZE;
    let show = |diagnostics: &[_], sources: &_| {
        scene.how.messages.show(diagnostics, sources);
        ExitCode::from(ERROR)
    };
    let read = expanded::evaluate(&scene.scene, &scene.reading(width, height), &scene.host(), &Queries::default())
        .map_err(|failed| show(&failed.diagnostics, &failed.sources))?;
    if matches!(arguments.stage, Stage::Scene) {
        return Ok(expanded::text(&read.scene, &expanded::Style::default()));
    }
    let compiled = compile::compile(&read.scene).map_err(|errors| show(&errors, &read.sources))?;
    let left_out = explain::omissions(&compiled.ledger);
    Ok(compiled.world.dump() + left_out.trim_start() + if left_out.is_empty() { "" } else { "\n" })
}
