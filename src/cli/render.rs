//! `whitted render`: a scene file in, a picture out.

use super::picture_files::Files;
use super::progress::{Bar, end_on_interrupt, progress_bar, stop_on_interrupt};
use super::scene_arguments::SceneArguments;
use super::{ERROR, explain, fail, frames, messages};
use crate::imaging::{FileKind, check_writable};
use crate::job::{Earlier, Exposure, Job, Keeping, LightFiles, Outcome, Output, PATIENCE, Session};
use crate::render::{Antialias, End, ImageLayer, Method, Options, Progress, Region, Target};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// The size that an installed POV-Ray's own settings give: 800 x 600.
pub(super) const DEFAULT_SIZE: (usize, usize) = (800, 600);

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Picture to write: .exr, .png, .ppm, .tga, .bmp, .jpg or .hdr, or - for standard output.
    /// Without it, the scene's name with .exr, and a preview beside it
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Also write a picture to look at; without a name, beside the output with .png
    #[arg(long, value_name = "FILE.png", num_args = 0..=1, default_missing_value = "")]
    preview: Option<PathBuf>,
    /// Pixels across [default: 800, or 4/3 of the height]
    #[arg(long, short = 'W', value_parser = size)]
    width: Option<usize>,
    /// Pixels down [default: 600, or 3/4 of the width]
    #[arg(long, short = 'H', value_parser = size)]
    height: Option<usize>,
    /// Smooth edges: off, or METHOD,THRESHOLD,DEPTH[,JITTER] as POV-Ray's +AM, +A, +R, +J
    #[arg(long, short, value_parser = antialias, default_value = "off", value_name = "HOW")]
    antialias: Option<Setting>,
    /// Take samples until the root mean square error of the picture is surely below E, in linear light
    /// over pixels and channels
    #[arg(long, value_parser = positive, value_name = "E", conflicts_with = "antialias")]
    target_error: Option<f64>,
    /// Take samples for so long, reading the scene included: 30s, 5m, 1.5h
    #[arg(long, value_parser = duration, value_name = "TIME", conflicts_with = "antialias")]
    time_budget: Option<Duration>,
    /// Take the samples of a picture that was made to a target again: what its header calls whitted:rounds
    #[arg(long, value_parser = rounds, value_name = "LIST", conflicts_with_all = ["antialias", "target_error", "time_budget"])]
    rounds: Option<Rounds>,
    /// Number that chooses the samples' places of a picture with a target
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Worker threads, 0 for one for each core
    #[arg(long, short, default_value_t = 0)]
    threads: usize,
    /// 0 to 9, as POV-Ray's +Q
    #[arg(long, short, default_value_t = 9, value_parser = clap::value_parser!(u8).range(0..=9))]
    quality: u8,
    /// Write an alpha channel; the background is transparent
    #[arg(long)]
    alpha: bool,
    /// Write EXR colours in single instead of half precision
    #[arg(long)]
    float: bool,
    #[command(flatten)]
    files: Files,
    /// Render a part of the picture: columns X0 to X1 and rows Y0 to Y1 from the upper left corner at 0,0,
    /// X1 and Y1 not included. Its pixels are those of the whole picture; an EXR file keeps its place
    #[arg(long, value_parser = region, value_name = "X0,Y0,X1,Y1")]
    region: Option<Region>,
    /// Write layers into the EXR file: all, or a list of Z, P, N, Ng, albedo, emission, direct, indirect, caustics, subsurface, reflection,
    /// refraction, background, atmosphere, media, samples, variance, CryptoObject and CryptoMaterial
    #[arg(long, value_parser = layers, value_name = "LIST")]
    layers: Option<Layers>,
    /// Say what the scene has, what of it is left out because the picture does not need it, and which rays it took
    #[arg(long)]
    explain: bool,
    /// Go on with a picture, or with the frames of an animation, where an interrupted run has left off: what is finished
    /// is kept in OUTPUT.whitted-state, and taken if it belongs to the same picture. Of pictures with layers only
    /// finished frames are
    #[arg(long, conflicts_with_all = ["target_error", "time_budget", "rounds"])]
    resume: bool,
    /// Take light between surfaces from FILE, as an earlier picture of the scene has left it; what is missing is found. POV-Ray's
    /// files (+RFO) are taken, too
    #[arg(long, value_name = "FILE")]
    radiosity_from: Option<PathBuf>,
    /// Write the light between surfaces that is known after the picture to FILE; it may be that of --radiosity-from, which
    /// grows from frame to frame
    #[arg(long, value_name = "FILE")]
    radiosity_to: Option<PathBuf>,
    #[command(flatten)]
    animation: frames::Frames,
    /// Say how long each stage took
    #[arg(long)]
    timings: bool,
}

/// Antialiasing as typed; `off` is a setting, too.
#[derive(Clone, Copy, Debug)]
struct Setting(Option<Antialias>);

/// Layers as typed.
#[derive(Clone, Debug)]
struct Layers(Vec<ImageLayer>);

/// Limits of rounds as typed.
#[derive(Clone, Debug)]
struct Rounds(Vec<f64>);

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "expected a number")?;
    if number.is_finite() && number > 0.0 { Ok(number) } else { Err("must be above 0".into()) }
}

pub(super) fn duration(text: &str) -> Result<Duration, String> {
    let (digits, unit) = text.split_at(text.trim_end_matches(|c: char| c.is_ascii_alphabetic()).len());
    let seconds = match unit {
        "" | "s" => 1.0,
        "m" | "min" => 60.0,
        "h" => 3600.0,
        _ => return Err(format!("'{unit}' is no unit of time: s, m or h")),
    };
    Duration::try_from_secs_f64(seconds * positive(digits)?).map_err(|_| "is too long".into())
}

fn rounds(text: &str) -> Result<Rounds, String> {
    let limits = text.split(',').map(str::trim).filter(|limit| !limit.is_empty());
    Ok(Rounds(limits.map(positive).collect::<Result<_, _>>()?))
}

fn layers(text: &str) -> Result<Layers, String> {
    if text == "all" {
        return Ok(Layers(ImageLayer::ALL.to_vec()));
    }
    let mut layers = Vec::new();
    for name in text.split(',').map(str::trim) {
        let layer = ImageLayer::named(name).ok_or_else(|| {
            let names = ImageLayer::ALL.map(ImageLayer::name).join(", ");
            format!("'{name}' is none of all, {names}")
        })?;
        if !layers.contains(&layer) {
            layers.push(layer);
        }
    }
    Ok(Layers(layers))
}

fn region(text: &str) -> Result<Region, String> {
    let numbers: Vec<usize> = text
        .split(',')
        .map(|part| part.trim().parse().map_err(|_| format!("'{part}' is not a number of pixels")))
        .collect::<Result<_, _>>()?;
    let &[left, top, right, bottom] = numbers.as_slice() else { return Err("expected X0,Y0,X1,Y1".into()) };
    if left >= right || top >= bottom {
        return Err("X1 and Y1 must be greater than X0 and Y0".into());
    }
    Ok(Region { left, top, right, bottom })
}

pub(super) fn size(text: &str) -> Result<usize, String> {
    // POV-Ray takes fractional sizes from some exporters and cuts them.
    let size = text.parse::<f64>().map_err(|_| "expected a number of pixels")?.trunc();
    if (1.0..=65_536.0).contains(&size) { Ok(size as usize) } else { Err("must be 1 to 65536".into()) }
}

fn antialias(text: &str) -> Result<Setting, String> {
    if text == "off" {
        return Ok(Setting(None));
    }
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let number = |i: usize, name: &str, range: std::ops::RangeInclusive<f64>| -> Result<f64, String> {
        let value: f64 = parts[i].parse().map_err(|_| format!("{name} '{}' is not a number", parts[i]))?;
        let (low, high) = (range.start(), range.end());
        if range.contains(&value) { Ok(value) } else { Err(format!("{name} must be {low} to {high}")) }
    };
    if !(3..=4).contains(&parts.len()) {
        return Err("expected off or METHOD,THRESHOLD,DEPTH[,JITTER]".into());
    }
    Ok(Setting(Some(Antialias {
        method: if number(0, "METHOD", 1.0..=2.0)? < 2.0 { Method::Grid } else { Method::Adaptive },
        threshold: number(1, "THRESHOLD", 0.0..=1.0)?,
        depth: number(2, "DEPTH", 1.0..=9.0)? as u32,
        jitter: if parts.len() == 4 { number(3, "JITTER", 0.0..=1.0)? } else { 0.0 },
        gamma: Antialias::GAMMA,
    })))
}

impl Arguments {
    fn options(&self) -> Options {
        let (width, height) = match (self.width, self.height) {
            (Some(width), Some(height)) => (width, height),
            (Some(width), None) => (width, (width * 3 / 4).max(1)),
            (None, Some(height)) => ((height * 4 / 3).max(1), height),
            (None, None) => DEFAULT_SIZE,
        };
        let antialias = self.antialias.and_then(|setting| setting.0);
        Options {
            width,
            height,
            antialias,
            target: self.target(),
            quality: self.quality,
            alpha: self.alpha,
            region: self.region,
            layers: self.layers.as_ref().map_or_else(Vec::new, |layers| layers.0.clone()),
            ..Options::default()
        }
    }

    fn target(&self) -> Option<Target> {
        let Self { target_error: error, time_budget: time, seed, .. } = *self;
        let rounds = self.rounds.as_ref().map(|rounds| rounds.0.clone());
        (error.is_some() || time.is_some() || rounds.is_some()).then_some(Target { error, time, seed, rounds })
    }

    /// The picture's file, and that of its preview, or which of them has no kind.
    fn outputs(&self) -> Result<Vec<Output>, String> {
        let (output, preview) = self.named_files();
        let encoding = self.files.encoding(self.float);
        let unknown =
            |file: &Path| format!("{}: unknown kind of picture: use {}", file.display(), FileKind::EXTENSIONS);
        let kind = self.files.kind(&output).ok_or_else(|| unknown(&output))?;
        let mut outputs = vec![Output { file: output, kind, encoding }];
        if let Some(file) = preview {
            let kind = FileKind::of(&file).ok_or_else(|| unknown(&file))?;
            outputs.push(Output { file, kind, encoding });
        }
        Ok(outputs)
    }

    fn named_files(&self) -> (PathBuf, Option<PathBuf>) {
        let output = self.output.clone().unwrap_or_else(|| self.scene.scene.with_extension("exr"));
        let beside = || {
            let name = if output == Path::new("-") { &self.scene.scene } else { &output };
            name.with_extension("png")
        };
        let preview = match &self.preview {
            Some(named) if named.as_os_str().is_empty() => Some(beside()),
            Some(named) => Some(named.clone()),
            None if self.output.is_none() => Some(beside()),
            None => None,
        };
        (output, preview)
    }
}

/// Renders and writes the picture.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let outputs = match arguments.outputs() {
        Ok(outputs) => outputs,
        Err(message) => return fail(message),
    };
    let options = arguments.options();
    let window = options.window();
    if options.region.is_some_and(|region| region != window) {
        return fail(format_args!("--region reaches beyond the picture of {} x {}", options.width, options.height));
    }
    // What cannot be written is better known before than after hours of work.
    if let Some(error) = outputs.iter().find_map(|output| check_writable(&output.file).err()) {
        return fail(error);
    }
    if !options.layers.is_empty() && outputs[0].kind != FileKind::Exr {
        return fail(format_args!("{}: only EXR files have layers", outputs[0].file.display()));
    }
    let animation = arguments.animation.animation();
    let exposure = animation.map_or_else(Exposure::default, |animation| arguments.animation.exposure(&animation));
    let job = Job {
        scene: arguments.scene.scene.clone(),
        reading: arguments.scene.reading(options.width, options.height),
        rendering: options.clone(),
        outputs,
        exposure,
        keeping: if arguments.resume { Keeping::Resuming } else { Keeping::New },
        patience: PATIENCE,
        light: LightFiles { from: arguments.radiosity_from.clone(), to: arguments.radiosity_to.clone() },
    };
    if let Some(animation) = animation {
        return frames::run(&arguments.scene, &job, &animation, arguments.threads);
    }
    let session = Session::new(arguments.threads);
    let bar = progress_bar("{bar:40} {percent:>3} %  {elapsed_precise} elapsed, {eta_precise} left  {msg}");
    let stopped = match &job.rendering.target {
        Some(_) => Some(stop_on_interrupt()),
        None => {
            end_on_interrupt();
            None
        }
    };
    let bar = Bar { bar, stopped };
    let result = session.render(&job, &arguments.scene.host(), &bar);
    bar.bar.finish_and_clear();
    let mut outcome = match result {
        Ok(outcome) => outcome,
        Err(failed) => {
            arguments.scene.how.messages.show(&failed.diagnostics, &failed.sources);
            return ExitCode::from(ERROR);
        }
    };
    arguments.scene.how.messages.show(&outcome.warnings, &outcome.sources);
    say_what_was_left(&outcome.earlier);
    if !outcome.complete {
        return fail("stopped before every pixel was seen; nothing is written");
    }
    if let Err(error) = session.write(&mut outcome, &job) {
        return fail(error);
    }
    if std::io::stderr().is_terminal() {
        let named = job.outputs.iter().filter(|output| output.file != Path::new("-"));
        named.for_each(|output| messages::line(format_args!("wrote {}", output.file.display())));
    }
    if let Some(progress) = &outcome.progress {
        messages::line(format_args!("{}", summary(progress, &options)));
    }
    if arguments.explain {
        explain::show(&outcome.explanation);
    }
    if arguments.timings {
        show_timings(&outcome);
    }
    ExitCode::SUCCESS
}

/// What `--resume` has found.
fn say_what_was_left(earlier: &Earlier) {
    match earlier {
        Earlier::Nothing => {}
        Earlier::Other => {
            messages::line("warning: what is kept beside the picture belongs to another one and is not used")
        }
        Earlier::Pieces(n) => messages::line(format_args!("{n} finished pieces were there already")),
    }
}

/// What was reached, and what it cost.
fn summary(progress: &Progress, options: &Options) -> String {
    let Progress { accuracy, samples, end, .. } = progress;
    let window = options.window();
    let mean = *samples as f64 / (window.width() * window.height()) as f64;
    let why = match end {
        End::Reached => "as asked for",
        End::Exhausted => "no pixel is worth more samples",
        End::Time => "the time is over",
        End::Rounds => "all rounds are done",
        End::Cancelled => "stopped",
    };
    format!("error {:.3e} ± {:.0e} ({mean:.1} samples a pixel; {why})", accuracy.rmse(), accuracy.uncertainty())
}

fn show_timings(outcome: &Outcome) {
    for (stage, time) in &outcome.timings.0 {
        messages::line(format_args!("{stage:8} {:9.3} s", time.as_secs_f64()));
    }
    let rays = outcome.metadata.rays as f64;
    let rate = rays / outcome.timings.of("render").as_secs_f64() / 1e6;
    messages::line(format_args!("rays     {rays:9.0} ({rate:.2} million a second)"));
}
