//! The command line: what was typed, what it means, one file for each command.
//!
//! Data goes to standard output, messages to standard error. Exit codes: 0 for success, 1 for
//! pictures that differ, 2 for errors.

mod check;
mod compare;
mod dump;
mod include_dirs;
mod messages;
mod render;
mod scene_arguments;

use clap::{Parser, Subcommand};
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
    Render(render::Arguments),
    /// Read a scene and say what is wrong with it, without rendering
    Check(check::Arguments),
    /// Print what a stage makes of a scene, as text
    Dump(dump::Arguments),
    /// Tell how much two EXR pictures differ
    Compare(compare::Arguments),
}

/// Runs the program with the process's own arguments.
pub fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version are no errors; a closed pipe is nobody's fault.
            let _ = error.print();
            return if error.use_stderr() { ExitCode::from(ERROR) } else { ExitCode::SUCCESS };
        }
    };
    match arguments.command {
        Command::Render(arguments) => render::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Dump(arguments) => dump::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
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
    fn commands_take_their_options() {
        check("whitted render a.pov --width 160 --height 120 --antialias off --threads 1 --include x", true);
        check("whitted render a.pov --antialias 1,0.3,3 --output b.exr", true);
        check("whitted render a.pov --antialias 3,0.3,3", false);
        check("whitted render a.pov --antialias 1,0.3,30", false);
        check("whitted render a.pov --width 0", false);
        check("whitted render", false);
        check("whitted compare a.exr b.exr --heatmap c.png", true);
        check("whitted check a.pov --include x --include y", true);
        check("whitted check a.pov --limit steps=5 --no-warn range --message-format json --embedded-includes", true);
        check("whitted check a.pov --limit step=5", false);
        check("whitted check a.pov --no-warn rnage", false);
        check("whitted dump a.pov --stage tokens", true);
        check("whitted dump a.pov --stage rays", false);
    }
}
