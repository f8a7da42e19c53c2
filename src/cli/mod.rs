//! The command line: what was typed, what it means, one file for each command.
//!
//! Data goes to standard output, messages to standard error. Exit codes: 0 for success, 1 for
//! pictures that differ, 2 for errors.

mod check;
mod compare;
mod dump;
mod expand;
mod explain;
mod frames;
mod include_dirs;
mod language;
mod messages;
mod picture_files;
mod povray;
mod progress;
mod render;
mod report;
mod scene_arguments;
mod stability;
mod trace;

use clap::{Parser, Subcommand};
use std::ffi::OsString;
use std::io::{self, Write as _};
use std::path::PathBuf;
use std::process::ExitCode;

/// Exit code of an error.
const ERROR: u8 = 2;

/// A ray tracer that reads POV-Ray 3.7 scenes and writes HDR OpenEXR.
#[derive(Debug, Parser)]
#[command(version, about, max_term_width = 100)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Render a scene to a picture
    Render(Box<render::Arguments>),
    /// Read a scene and say what is wrong with it, without rendering
    Check(check::Arguments),
    /// Print what a stage makes of a scene, as text
    Dump(dump::Arguments),
    /// Write a scene without its macros, loops and includes, as one text for this program and for POV-Ray
    Expand(expand::Arguments),
    /// Tell how one pixel comes about: each ray, what it meets in which space, layers, lights, rays that go on
    Trace(trace::Arguments),
    /// Tell how much two EXR pictures differ
    Compare(compare::Arguments),
    /// List blocks and functions of the scene language, or what one takes
    Language(language::Arguments),
    /// Measure error against run time on ladders of settings, and show it on a page
    Report(report::Arguments),
    /// Take POV-Ray's arguments, as a program called `povray` does
    Povray(povray::Arguments),
    /// Drive scenes to extremes until pictures break, and print how far that is
    Stability(stability::Arguments),
}

/// Runs the program with the process's own arguments.
pub fn run() -> ExitCode {
    let mut given = std::env::args_os();
    if given.next().is_some_and(|name| povray::is_called_povray(&name)) {
        return povray::run_with(&given.collect::<Vec<_>>());
    }
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version are no errors; a closed pipe is nobody's fault.
            let _ = error.print();
            if error.use_stderr() {
                hint_at_dashes(std::env::args_os().skip(1));
            }
            return if error.use_stderr() { ExitCode::from(ERROR) } else { ExitCode::SUCCESS };
        }
    };
    match arguments.command {
        Command::Render(arguments) => render::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Dump(arguments) => dump::run(&arguments),
        Command::Expand(arguments) => expand::run(&arguments),
        Command::Trace(arguments) => trace::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Language(arguments) => language::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Povray(arguments) => povray::run(&arguments),
        Command::Stability(arguments) => stability::run(&arguments),
    }
}

/// Says how to name a scene that looks like an option, if that may be what went wrong.
fn hint_at_dashes(arguments: impl Iterator<Item = OsString>) {
    if let Some(scene) = dashed_scene(arguments) {
        let scene = scene.display();
        messages::line(format_args!(
            "hint: the name of a scene that begins with a dash stands last, behind '--', or with its folder:\n      \
             whitted render -- {scene}\n      whitted render ./{scene}"
        ));
    }
}

/// The first argument in the place of an option that is the name of a scene.
fn dashed_scene(arguments: impl Iterator<Item = OsString>) -> Option<PathBuf> {
    let mut options = arguments.take_while(|argument| argument != "--").map(PathBuf::from);
    options.find(|name| {
        let is_scene = name.extension().is_some_and(|e| e.eq_ignore_ascii_case("pov")) || name.is_file();
        name.as_os_str().as_encoded_bytes().starts_with(b"-") && is_scene
    })
}

/// Writes text to standard output.
fn print(text: &str) -> ExitCode {
    match io::stdout().write_all(text.as_bytes()) {
        // A closed pipe is nobody's fault.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => fail(error),
        _ => ExitCode::SUCCESS,
    }
}

/// Says what went wrong; nothing else can be done.
fn fail(message: impl std::fmt::Display) -> ExitCode {
    messages::line(format_args!("error: {message}"));
    ExitCode::from(ERROR)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    fn check(line: &str, accepted: bool) {
        assert_eq!(Arguments::try_parse_from(line.split(' ')).is_ok(), accepted, "{line}");
    }

    #[test]
    fn scenes_with_dashes_are_hinted_at() {
        let found = |line: &str| dashed_scene(line.split(' ').map(OsString::from));
        assert_eq!(found("render -0.5_a.pov -W 9"), Some("-0.5_a.pov".into()));
        assert_eq!(found("render -W 9 -a.POV"), Some("-a.POV".into()));
        assert_eq!(found("render -W 9 -- -0.5_a.pov"), None);
        assert_eq!(found("render -W x a.pov"), None);
    }

    #[test]
    fn commands_take_their_options() {
        check("whitted render a.pov --width 160 --height 120 --antialias off --threads 1 --include x", true);
        check("whitted render a.pov --antialias 1,0.3,3 --output b.exr", true);
        check("whitted render a.pov --antialias 3,0.3,3", false);
        check("whitted render a.pov --antialias 1,0.3,30", false);
        check(
            "whitted render a.pov --frames 1-10 --clocks 0,2 --cyclic --shutter 0.5 --samples 8 --resume --bits 16 --format png",
            true,
        );
        check("whitted render a.pov --frames 3-2", false);
        check("whitted render a.pov --clocks 0,2", false);
        check("whitted render a.pov --bits 4", false);
        check("whitted povray +W8 -H6 --version a.pov", true);
        check("whitted render a.pov --width 0", false);
        check("whitted render", false);
        check("whitted compare a.exr b.exr --heatmap c.png", true);
        check("whitted check a.pov --include x --include y", true);
        check("whitted check a.pov --limit steps=5 --no-warn range --message-format json --embedded-includes", true);
        check("whitted check a.pov --limit step=5", false);
        check("whitted check a.pov --no-warn rnage", false);
        check("whitted dump a.pov --stage tokens", true);
        check("whitted dump a.pov --stage rays", false);
        check("whitted language", true);
        check("whitted language blob component", true);
        check("whitted report a.pov b.pov --against povray --runs 5 -t 2 -W 320 -H 240 -o out -I x", true);
        check("whitted report a.pov --reference a.exr --override max_trace_level=9 -o out", true);
        check("whitted report a.pov --override max_trace=9 -o out", false);
        check("whitted report a.pov", false);
        check("whitted report a.pov --against blender -o out", false);
    }
}
