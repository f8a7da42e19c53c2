//! `whitted compare`: how much two pictures differ.

use super::fail;
use crate::imaging::{Difference, Encoding, Metadata, Verdict, compare, heatmap, read_exr, read_exr_figures, save};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Reference picture
    reference: PathBuf,
    /// Picture to judge
    image: PathBuf,
    /// Write a picture of where they differ
    #[arg(long, value_name = "FILE.png")]
    heatmap: Option<PathBuf>,
    /// Worst verdict that still counts as agreement
    #[arg(long, value_enum, default_value_t = Tolerance::Same)]
    tolerance: Tolerance,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Tolerance {
    /// 99.5 % of pixels within 2 of 255, mean at most 0.25
    Same,
    /// 98 % of pixels within 8 of 255, mean at most 1
    Close,
    /// 90 % of pixels within 24 of 255, mean at most 6
    Alike,
}

/// Compares and prints the figures; exit code 0 within tolerance, 1 otherwise, 2 for errors.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let (reference, image) = match (read_exr(&arguments.reference), read_exr(&arguments.image)) {
        (Ok(reference), Ok(image)) => (reference, image),
        (Err(error), _) | (_, Err(error)) => return fail(error),
    };
    let difference = match compare(&reference, &image) {
        Ok(difference) => difference,
        Err(error) => return fail(error),
    };
    if let Some(path) = &arguments.heatmap {
        let encoding = Encoding::default();
        let written = heatmap(&reference, &image).and_then(|map| save(path, &map, &Metadata::default(), &encoding));
        if let Err(error) = written {
            return fail(error);
        }
    }
    // A closed pipe is no reason to fail: the exit code says the same.
    let said = table(&difference) + &claims(&arguments.reference) + &claims(&arguments.image);
    let _ = std::io::stdout().write_all(said.as_bytes());
    let limit = match arguments.tolerance {
        Tolerance::Same => Verdict::Same,
        Tolerance::Close => Verdict::Close,
        Tolerance::Alike => Verdict::Alike,
    };
    if difference.verdict() <= limit { ExitCode::SUCCESS } else { ExitCode::from(1) }
}

/// What a picture says of its own error, if it does.
fn claims(file: &Path) -> String {
    // Whoever can be read as a picture has a header; one without figures claims nothing.
    let figures = read_exr_figures(file).unwrap_or_default();
    let figure = |name: &str| figures.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let (Some(error), Some(doubt)) = (figure("whitted:errorEstimate"), figure("whitted:errorUncertainty")) else {
        return String::new();
    };
    format!("claims         {error:.6} ± {doubt:.6} ({})\n", file.display())
}

fn table(difference: &Difference) -> String {
    let percent = difference.within.map(|w| 100.0 * w);
    format!(
        "verdict        {:?}\nmean           {:.4} of 255 (sRGB)\nRMSE           {:.6} (linear)\nrelative RMSE  {:.6}\n\
         within 2       {:.3} %\nwithin 8       {:.3} %\nwithin 24      {:.3} %\nFLIP           {:.5}\n\
         worst pixel    {:.6} (linear) at {},{}\n",
        difference.verdict(),
        difference.mean_display,
        difference.rmse,
        difference.relative_rmse,
        percent[0],
        percent[1],
        percent[2],
        difference.flip,
        difference.worst.error,
        difference.worst.x,
        difference.worst.y
    )
}
