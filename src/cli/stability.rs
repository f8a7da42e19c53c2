//! `whitted stability`: how far scenes can be driven before a picture breaks.

use super::fail;
use super::progress::progress_bar;
use super::render::duration;
use super::report::{Bar, Rival};
use super::scene_arguments::days_since_2000;
use crate::eval::date_time;
use crate::measure::Caller;
use crate::stability::{self, Family, Plan};
use std::io::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Families of the catalogue, by how their names begin, or files [default: the whole catalogue]
    #[arg(value_name = "FAMILY")]
    families: Vec<String>,
    /// Folder for stability.md, stability.html, stability.csv and stability.json
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Another program that is driven as far
    #[arg(long, value_enum, value_name = "PROGRAM")]
    against: Option<Rival>,
    /// Where POV-Ray is
    #[arg(long, value_name = "PROGRAM", default_value = "povray")]
    povray: PathBuf,
    /// How long a picture may take before it is given up
    #[arg(long, value_name = "TIME", default_value = "30s", value_parser = duration)]
    timeout: Duration,
    /// Print what there is in the catalogue, and do nothing else
    #[arg(long)]
    list: bool,
}

/// Sweeps the families and prints the table.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let plan = match plan(arguments) {
        Ok(plan) => plan,
        Err(why) => return fail(why),
    };
    if arguments.list {
        let line = |family: &Family| format!("{:24}{}\n", family.name, family.about);
        return say(&plan.families.iter().map(line).collect::<String>());
    }
    let bar = Bar(progress_bar("{bar:40} {percent:>3} %  {prefix}\n{wide_msg}"));
    let made = stability::make(plan, &bar);
    bar.0.finish_and_clear();
    let findings = match made {
        Ok(findings) => findings,
        Err(why) => return fail(why),
    };
    if let Some(folder) = &arguments.output
        && let Err(error) = stability::write(&findings, folder)
    {
        return fail(error);
    }
    say(&stability::text(&findings))
}

/// Writes to standard output; that nobody reads it any more is nobody's fault.
fn say(text: &str) -> ExitCode {
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::SUCCESS
}

fn plan(arguments: &Arguments) -> Result<Plan, String> {
    let own = std::env::current_exe().map_err(|error| format!("this program does not find itself: {error}"))?;
    let mut families = Vec::new();
    for name in &arguments.families {
        families.extend(stability::named(name)?);
    }
    if arguments.families.is_empty() {
        families.extend(stability::catalog());
    }
    let typed: Vec<String> = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    Ok(Plan {
        families,
        whitted: Caller { program: own, arguments: ["--embedded-includes", "--no-warn", "all"].map(Into::into).into() },
        povray: arguments
            .against
            .map(|Rival::Povray| Caller { program: arguments.povray.clone(), arguments: Vec::new() }),
        limit: arguments.timeout,
        origin: [date_time(days_since_2000(), "%Y-%m-%d"), format!("whitted {}", typed.join(" "))],
    })
}
