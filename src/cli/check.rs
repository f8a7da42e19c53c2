//! `whitted check`: reads and compiles a scene, renders nothing.

use super::scene_arguments::SceneArguments;
use super::{ERROR, messages};
use crate::compile::Queries;
use crate::eval;
use std::process::ExitCode;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
}

/// Reads the scene and shows what was found.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let scene = &arguments.scene;
    let (width, height) = super::render::DEFAULT_SIZE;
    match eval::evaluate(&scene.scene, &scene.reading(width, height), &scene.host(), &Queries::default()) {
        Ok(read) => {
            scene.messages.show(&read.warnings, &read.sources);
            let wanted = scene.messages.wanted(&read.warnings);
            let found = messages::count(&wanted).unwrap_or_else(|| "no complaints".into());
            scene.messages.remark(format_args!("{}: {found}", scene.scene.display()));
            ExitCode::SUCCESS
        }
        Err(failed) => {
            scene.messages.show(&failed.diagnostics, &failed.sources);
            ExitCode::from(ERROR)
        }
    }
}
