//! `whitted check`: reads and compiles a scene, renders nothing.

use super::scene_arguments::SceneArguments;
use super::{ERROR, messages};
use crate::job::{Ready, Session};
use std::process::ExitCode;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
}

/// Reads and compiles the scene and shows all that rendering it would say.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let scene = &arguments.scene;
    let (width, height) = super::render::DEFAULT_SIZE;
    match Session::new(0).compile(&scene.scene, &scene.reading(width, height), &scene.host()) {
        Ok(Ready { warnings, sources, .. }) => {
            scene.how.messages.show(&warnings, &sources);
            let wanted = scene.how.messages.wanted(&warnings);
            let found = messages::count(&wanted).unwrap_or_else(|| "no complaints".into());
            scene.how.messages.remark(format_args!("{}: {found}", scene.scene.display()));
            ExitCode::SUCCESS
        }
        Err(failed) => {
            scene.how.messages.show(&failed.diagnostics, &failed.sources);
            ExitCode::from(ERROR)
        }
    }
}
