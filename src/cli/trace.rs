//! `whitted trace`: how one pixel comes about, ray by ray.

use super::scene_arguments::SceneArguments;
use super::{ERROR, fail};
use crate::imaging::write_whole;
use crate::job::{Ready, Session};
use crate::render::Options;
use std::path::Path;
use std::process::ExitCode;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Column and row, the upper left pixel being 0,0
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pixel: [usize; 2],
    /// Pixels across
    #[arg(long, short = 'W', default_value_t = super::render::DEFAULT_SIZE.0)]
    width: usize,
    /// Pixels down
    #[arg(long, short = 'H', default_value_t = super::render::DEFAULT_SIZE.1)]
    height: usize,
}

fn pixel(text: &str) -> Result<[usize; 2], String> {
    let (x, y) = text.split_once(',').ok_or("expected X,Y")?;
    let number = |text: &str| text.trim().parse::<usize>().map_err(|_| format!("'{text}' is not a pixel's number"));
    Ok([number(x)?, number(y)?])
}

/// Prints the walk and the pixel's value.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let (scene, options) = (&arguments.scene, options(arguments));
    let [x, y] = arguments.pixel;
    if x >= options.width || y >= options.height {
        return fail(format_args!("pixel {x},{y} lies outside of a picture of {} x {}", options.width, options.height));
    }
    let session = Session::new(0);
    match session.compile(&scene.scene, &scene.reading(options.width, options.height), &scene.host()) {
        Ok(Ready { world, warnings, sources, .. }) => {
            scene.how.messages.show(&warnings, &sources);
            let told = session.tell(&world, &options, arguments.pixel);
            let [red, green, blue, _] = told.pixel;
            let text = format!("{}pixel {x},{y} in linear light: {red} {green} {blue}\n", told.text);
            write_whole(Path::new("-"), text.as_bytes()).map_or_else(fail, |()| ExitCode::SUCCESS)
        }
        Err(failed) => {
            scene.how.messages.show(&failed.diagnostics, &failed.sources);
            ExitCode::from(ERROR)
        }
    }
}

fn options(arguments: &Arguments) -> Options {
    Options { width: arguments.width.max(1), height: arguments.height.max(1), antialias: None, ..Options::default() }
}
