//! `whitted expand`: a scene without macros, loops and includes, as one text.

use super::frames::{clocks, range};
use super::scene_arguments::SceneArguments;
use super::{ERROR, fail};
use crate::compile::Queries;
use crate::expanded::{self, Style};
use crate::imaging::write_whole;
use crate::job::Animation;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// File to write [default: standard output]
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// `image_width` as the scene sees it
    #[arg(long, short = 'W', default_value_t = 800, value_parser = clap::value_parser!(u32).range(1..=65535))]
    width: u32,
    /// `image_height` as the scene sees it
    #[arg(long, short = 'H', default_value_t = 600, value_parser = clap::value_parser!(u32).range(1..=65535))]
    height: u32,
    /// The scene as it is in this frame of an animation
    #[arg(long, value_name = "N")]
    frame: Option<u32>,
    /// First and last frame of the animation [default: those of a single frame]
    #[arg(long, value_name = "A-B", value_parser = range, requires = "frame")]
    frames: Option<(u32, u32)>,
    /// Values of `clock` in the first and in the last frame [default: 0,1]
    #[arg(long, value_name = "FROM,TO", value_parser = clocks, requires = "frame")]
    clocks: Option<(f64, f64)>,
    /// The last frame is followed by the first
    #[arg(long, requires = "frame")]
    cyclic: bool,
    /// Copy pictures, fonts and density files that the scene refers to into this folder, and call them by their bare
    /// names, as somebody finds them who reads the text there
    #[arg(long, value_name = "DIR")]
    collect: Option<PathBuf>,
    /// Say in comments where each object was written, and which macro calls led there
    #[arg(long)]
    origins: bool,
}

/// Writes the text, whole or not at all.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let scene = &arguments.scene;
    let mut reading = scene.reading(arguments.width as usize, arguments.height as usize);
    reading.origins = arguments.origins;
    if let Some(frame) = arguments.frame {
        let (initial_frame, final_frame) = arguments.frames.unwrap_or((frame, frame));
        let (initial_clock, final_clock) = arguments.clocks.unwrap_or((0.0, 1.0));
        let cyclic = arguments.cyclic;
        Animation { initial_frame, final_frame, initial_clock, final_clock, cyclic }.show(frame, &mut reading);
    }
    let read = match expanded::evaluate(&scene.scene, &reading, &scene.host(), &Queries::default()) {
        Ok(read) => read,
        Err(failed) => {
            scene.how.messages.show(&failed.diagnostics, &failed.sources);
            return ExitCode::from(ERROR);
        }
    };
    scene.how.messages.show(&read.warnings, &read.sources);
    let files = Files { collected: arguments.collect.is_some(), names: RefCell::default() };
    let file_name = |path: &Path| files.name(path);
    let origins = arguments.origins.then_some(&read.sources);
    let text = expanded::text(&read.scene, &Style { file_name: &file_name, origins });
    if let Some(folder) = &arguments.collect
        && let Err((file, error)) = files.copy(folder)
    {
        return fail(format_args!("cannot copy {}: {error}", file.display()));
    }
    let output = arguments.output.as_deref().unwrap_or(Path::new("-"));
    match write_whole(output, text.as_bytes()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(error),
    }
}

/// The files that a scene refers to.
struct Files {
    /// They are copied, and called by names that are theirs alone.
    collected: bool,
    names: RefCell<BTreeMap<PathBuf, String>>,
}

impl Files {
    /// What a file is called: its full name, since the text may be read from anywhere, or that of its copy.
    fn name(&self, path: &Path) -> String {
        if !self.collected {
            return std::path::absolute(path).unwrap_or_else(|_| path.to_owned()).display().to_string();
        }
        let mut names = self.names.borrow_mut();
        if let Some(known) = names.get(path) {
            return known.clone();
        }
        let bare = path.file_name().map_or_else(|| "file".into(), |name| name.to_string_lossy().into_owned());
        let is_taken = |name: &str| names.values().any(|known| known == name);
        let numbered = (2..).map(|n| format!("{n}_{bare}"));
        let name = std::iter::once(bare.clone()).chain(numbered).find(|name| !is_taken(name)).unwrap_or(bare);
        names.insert(path.to_owned(), name.clone());
        name
    }

    /// Copies what was named.
    fn copy(&self, folder: &Path) -> Result<(), (PathBuf, io::Error)> {
        std::fs::create_dir_all(folder).map_err(|error| (folder.to_owned(), error))?;
        for (path, name) in self.names.borrow().iter() {
            std::fs::copy(path, folder.join(name)).map_err(|error| (path.clone(), error))?;
        }
        Ok(())
    }
}
