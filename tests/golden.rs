//! Every scene under `golden/` against POV-Ray's picture of it: a trial per file.
//!
//! A failing trial leaves the expected and actual pictures and a heat map of their difference
//! in `target/golden/`.

use libtest_mimic::{Arguments, Failed, Trial};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use whitted::eval::{self, Disk, Reach};
use whitted::imaging::{self, Encoding, Metadata};
use whitted::job::{Job, Session};
use whitted::render::{Antialias, Method, Options, Unobserved};

/// What stands in `NAME.toml`.
#[derive(Deserialize)]
struct Recipe {
    width: usize,
    height: usize,
    /// POV-Ray's switches beyond the size.
    options: Vec<String>,
    tolerance: Tolerance,
    /// A file of an installed POV-Ray without which the trial is skipped.
    needs: Option<String>,
    /// A feature that we do not have yet; the trial is skipped.
    unsupported: Option<String>,
}

/// How far pictures may be apart.
#[derive(Deserialize)]
struct Tolerance {
    /// Least share of pixels within 2 of 255.
    within2: f64,
    /// Largest mean difference, in 255ths.
    mean: f64,
}

/// Where Debian and others put what comes with POV-Ray.
const INSTALLED: &str = "/usr/share/povray-3.7/include";

fn main() {
    let arguments = Arguments::from_args();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let mut scenes = Vec::new();
    find_scenes(&root, &mut scenes);
    scenes.sort();
    assert!(!scenes.is_empty(), "no scene below {}", root.display());
    let trials = scenes.into_iter().map(|scene| trial(&root, scene)).collect();
    libtest_mimic::run(&arguments, trials).exit();
}

fn find_scenes(folder: &Path, scenes: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        if path.is_dir() {
            find_scenes(&path, scenes);
        } else if path.extension().is_some_and(|e| e == "pov") {
            scenes.push(path);
        }
    }
}

fn trial(root: &Path, scene: PathBuf) -> Trial {
    let name = scene.with_extension("").strip_prefix(root).unwrap_or(&scene).display().to_string();
    let recipe = std::fs::read_to_string(scene.with_extension("toml"))
        .map_err(|e| e.to_string())
        .and_then(|text| toml::from_str::<Recipe>(&text).map_err(|e| e.to_string()));
    let missing = |file: &String| !Path::new(INSTALLED).join(file).exists();
    let skipped = recipe.as_ref().is_ok_and(|r| r.unsupported.is_some() || r.needs.as_ref().is_some_and(missing));
    Trial::test(name.clone(), move || compare(&scene, &recipe?, &name)).with_ignored_flag(skipped)
}

fn compare(scene: &Path, recipe: &Recipe, name: &str) -> Result<(), Failed> {
    let reading = eval::Options { include_dirs: vec![INSTALLED.into()], ..eval::Options::default() };
    let reach = Reach { scene: scene.to_owned(), include: reading.include_dirs.clone(), ..Reach::default() };
    let host = Disk::new(&reach, |_, _| {});
    let job = Job { scene: scene.to_owned(), reading, rendering: options(recipe)?, ..Job::default() };
    let outcome = Session::new(0)
        .render(&job, &host, &Unobserved)
        .map_err(|failed| failed.diagnostics.iter().map(|d| format!("{}\n", d.message)).collect::<String>())?;
    let expected_path = scene.with_extension("exr");
    let expected = imaging::read_exr(&expected_path)?;
    let difference = imaging::compare(&expected, &outcome.picture)?;
    let Tolerance { within2, mean } = recipe.tolerance;
    if difference.finite && difference.within[0] >= within2 && difference.mean_display <= mean {
        return Ok(());
    }
    let left = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden").join(name);
    std::fs::create_dir_all(&left)?;
    let encoding = Encoding { float: true, ..Encoding::default() };
    let save = |file: &str, picture| imaging::save(&left.join(file), picture, &Metadata::default(), &encoding);
    save("expected.png", &expected)?;
    save("actual.exr", &outcome.picture)?;
    save("actual.png", &outcome.picture)?;
    save("difference.png", &imaging::heatmap(&expected, &outcome.picture)?)?;
    Err(format!(
        "{:.2} % of pixels within 2 of 255 (wanted {:.2} %), mean difference {:.3} (wanted {mean}); see {}",
        100.0 * difference.within[0],
        100.0 * within2,
        difference.mean_display,
        left.display()
    )
    .into())
}

/// POV-Ray's switches as our options; one that is not known here fails the trial.
fn options(recipe: &Recipe) -> Result<Options, String> {
    let mut options = Options { width: recipe.width, height: recipe.height, ..Options::default() };
    let mut antialias =
        Antialias { method: Method::Grid, threshold: 0.3, depth: 3, jitter: 0.0, gamma: Antialias::GAMMA };
    for switch in &recipe.options {
        let number = |prefix: &str| switch.trim_start_matches(prefix).parse().map_err(|_| format!("odd {switch}"));
        match switch.as_str() {
            "+UA" => options.alpha = true,
            "-J" => antialias.jitter = 0.0,
            "+AM1" => antialias.method = Method::Grid,
            "+AM2" => antialias.method = Method::Adaptive,
            s if s.starts_with("+A") => {
                antialias.threshold = number("+A")?;
                options.antialias = Some(antialias);
            }
            s if s.starts_with("+R") => antialias.depth = number("+R")? as u32,
            other => return Err(format!("the harness does not know the switch {other}")),
        }
    }
    options.antialias = options.antialias.map(|a| Antialias { threshold: a.threshold, ..antialias });
    Ok(options)
}
