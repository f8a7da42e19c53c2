//! In the place of POV-Ray: its arguments, INI files, names of files, messages and exit codes.
//!
//! Two tables say what there is: [`keys`] holds every key of INI files with what is done about it, [`switches`] what each
//! switch stands for. [`reader`] takes arguments and files through both to [`settings`]; [`run`] makes jobs of those.
//! How all of it behaves was measured: `docs/povray/command-line.md`.

mod console;
mod created_ini;
mod frames;
mod keys;
mod names;
mod progress;
mod reader;
mod report;
mod run;
mod scene_host;
mod settings;
mod switches;
mod values;
mod words;

use super::messages::line;
use reader::{Reader, Refusal, initial_file};
use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::ExitCode;

/// Exit code of whatever goes wrong.
const FAILED: u8 = 1;
/// Exit code of a run that was interrupted.
const CANCELLED: i32 = 2;

/// What was typed.
#[derive(Debug, clap::Args)]
#[command(disable_help_flag = true, disable_version_flag = true)]
pub(super) struct Arguments {
    /// POV-Ray's switches, KEY=VALUE, INI files and the scene, as its manual has them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    arguments: Vec<OsString>,
}

/// Whether the program was called by POV-Ray's name.
pub(super) fn is_called_povray(name: &OsStr) -> bool {
    Path::new(name).file_stem().is_some_and(|stem| stem.eq_ignore_ascii_case("povray"))
}

/// Runs with the arguments behind `whitted povray`.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    run_with(&arguments.arguments)
}

/// Runs with POV-Ray's arguments.
pub(super) fn run_with(arguments: &[OsString]) -> ExitCode {
    if let Some(text) = arguments.iter().find_map(|argument| answer(argument.to_str()?)) {
        line(text);
        return ExitCode::SUCCESS;
    }
    let (initial, complaint) = initial_file();
    complaint.iter().for_each(|complaint| line(format_args!("povray: {complaint}")));
    match Reader::read(arguments, initial) {
        Ok(reading) if reading.settings.scene.is_none() => refuse(arguments, "No input file provided", None),
        Ok(reading) if reading.settings.asks_for_impossible_grey() => {
            let reason = "only PNG and PPM files can be grey".into();
            let refusal = Refusal { place: "Grayscale_Output".into(), reason, hint: None };
            refuse(arguments, "Unsupported combination of options", Some(&refusal))
        }
        Ok(reading) => run::run(&reading),
        Err(refusal) => refuse(arguments, "Failed to parse command-line option", Some(&refusal)),
    }
}

/// What is said to questions about the program.
fn answer(argument: &str) -> Option<&'static str> {
    match argument {
        "--version" | "-version" | "--V" => Some(concat!(
            "whitted ",
            env!("CARGO_PKG_VERSION"),
            " in the place of POV-Ray 3.7\n\nSupported image formats: png ppm tga bmp jpeg openexr hdr"
        )),
        "--help" | "-help" | "-h" | "-?" => Some(HELP),
        _ => None,
    }
}

const HELP: &str = "usage: povray [+/-]SWITCH... [KEY=VALUE]... [FILE.ini[SECTION]]... SCENE.pov

This is whitted in the place of POV-Ray 3.7. The most common switches:
  +Iname +Oname +Lfolder +HIname      scene, picture, library, header
  +Wn +Hn +FN +FE +FP +FT +FJ +UA     size, kind of picture, transparency
  +A0.3 +AM2 +R3 +J0.5 +Q9            antialiasing, quality
  +Kn +KFFn +KFIn +KC +SFn +EFn       clock, animation
  +SCn +ECn +SRn +ERn                 part of the picture
  +C +WTn -V -GA +GFfile +GIfile      go on, threads, messages
All switches and keys, and what is done about each: docs/moving-from-povray.md.";

/// As POV-Ray says it, and then which option it is.
fn refuse(arguments: &[OsString], reason: &str, refusal: Option<&Refusal>) -> ExitCode {
    let typed: Vec<_> = arguments.iter().map(|argument| argument.to_string_lossy()).collect();
    line(format_args!("Problem with option setting\npovray {}\n{reason}", typed.join(" ")));
    if let Some(Refusal { place, reason, hint }) = refusal {
        line(format_args!("error: {place}: {reason}"));
        hint.iter().for_each(|hint| line(format_args!("hint: {hint}")));
    }
    ExitCode::from(FAILED)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_decides() {
        for (name, expected) in [("povray", true), ("/usr/bin/povray", true), ("POVRAY.EXE", true), ("whitted", false)]
        {
            assert_eq!(is_called_povray(name.as_ref()), expected, "{name}");
        }
    }

    #[test]
    fn the_table_for_those_who_move_is_complete() {
        let table = include_str!("../../../docs/moving-from-povray.md");
        let words: Vec<&str> = table.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').collect();
        for key in keys::KEYS {
            assert!(words.contains(&key.name), "{}", key.name);
        }
        for switch in switches::SWITCHES {
            // A letter in the place of a value may follow.
            let known = |word: &&str| {
                word.strip_prefix(switch.letters).is_some_and(|rest| ["", "n", "name", "folder", "xx"].contains(&rest))
            };
            assert!(words.iter().any(known), "+{}", switch.letters);
        }
    }
}
