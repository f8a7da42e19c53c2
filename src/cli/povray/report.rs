//! What is said about a picture before and after it is made, in POV-Ray's words as far as they fit.

use super::names;
use super::settings::Settings;
use crate::job::Outcome;
use crate::render::{Method, Options};
use std::path::Path;

/// What will be done.
pub(super) fn options(scene: &Path, settings: &Settings, rendering: &Options) -> String {
    let Options { width, height, quality, .. } = *rendering;
    let window = rendering.window();
    let output =
        if settings.to_file { names::picture(settings, None).display().to_string() } else { "Disabled".into() };
    let antialias = rendering.antialias.as_ref().map_or_else(
        || "Off".to_owned(),
        |a| {
            let method = if a.method == Method::Grid { 1 } else { 2 };
            format!("On  (Method {method}, Threshold {:.3}, Depth {}, Jitter {:.2})", a.threshold, a.depth, a.jitter)
        },
    );
    format!(
        "Parser Options\n  Input file: {}\nImage Output Options\n  Image resolution.....{width} by {height} \
         (rows {} to {}, columns {} to {}).\n  Output file..........{output}\nRender Options\n  Quality: {quality:2}\n  \
         Antialiasing.........{antialias}\n",
        scene.display(),
        window.top + 1,
        window.bottom,
        window.left + 1,
        window.right,
    )
}

/// What it took.
pub(super) fn statistics(outcome: &Outcome) -> String {
    let [width, height] = outcome.picture.full;
    let mut text = format!("Render Statistics\nImage Resolution {width} x {height}\nRays: {}\n", outcome.metadata.rays);
    for (stage, time) in &outcome.timings.0 {
        text += &format!("  {stage:8} {:9.3} seconds\n", time.as_secs_f64());
    }
    text
}
