//! From settings to pictures.

use super::console::{Console, Streams};
use super::progress::Progress;
use super::reader::Reading;
use super::scene_host::SceneHost;
use super::settings::{Settings, Sort};
use super::{CANCELLED, FAILED, created_ini, frames, names};
use crate::cli::messages::line;
use crate::cli::{include_dirs, scene_arguments::days_since_2000};
use crate::eval::{self, Disk, Reach};
use crate::imaging::{pause_writing, write_whole};
use crate::job::{Animation, Job, Outcome, Output, Ready, Session, in_order, single};
use crate::render::Options;
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What all frames have in common.
struct Run<'r> {
    settings: &'r Settings,
    scene: PathBuf,
    /// The scene's text, if it came through standard input.
    piped: Option<Vec<u8>>,
    rendering: Options,
    animation: Option<Animation>,
    frames: Vec<u32>,
    session: Session,
    streams: Streams,
}

const PARSING: &str = "==== [Parsing...] ==========================================================\n";
const RENDERING: &str = "==== [Rendering...] ========================================================\n";

/// Renders what was asked for.
pub(super) fn run(reading: &Reading) -> ExitCode {
    reading.notes.iter().for_each(|note| line(format_args!("note: {note}")));
    match Run::prepare(reading) {
        Ok(run) => {
            stop_on_signals();
            let done = run.all_frames();
            line(if done { "POV-Ray finished" } else { "Render failed" });
            if done { ExitCode::SUCCESS } else { ExitCode::from(FAILED) }
        }
        Err(message) => {
            line(format_args!("{message}\nRender failed"));
            ExitCode::from(FAILED)
        }
    }
}

/// Ends the program at once; what is being written becomes whole before.
fn stop_on_signals() {
    let _ = ctrlc::set_handler(|| {
        let _whole = pause_writing();
        // Progress has left its line open.
        let _ = std::io::stderr()
            .write_all(b"\nFatal error in renderer: Frontend halted render.\nRender cancelled by user\n");
        std::process::exit(CANCELLED);
    });
}

impl<'r> Run<'r> {
    /// Finds out everything that needs no scene.
    fn prepare(reading: &'r Reading) -> Result<Self, String> {
        let settings = &reading.settings;
        let rendering = settings.rendering()?;
        let named = settings.scene.as_deref().unwrap_or(Path::new(""));
        let scene = names::scene(named, &settings.library).map_err(|name| {
            format!(
                "Possible Parse Error: Cannot find file '{name}', even after trying to append file type extension.\n\
                 Parse Error: Cannot open input file.\nFatal error in parser: Cannot parse input."
            )
        })?;
        let (animation, frames) = frames::frames(settings).map_or((None, vec![0]), |(a, frames)| (Some(a), frames));
        let folder = folder_of(&names::picture(settings, None));
        if settings.to_file && !folder.is_dir() {
            return Err(format!("Cannot create render state output file.\nThere is no folder '{}'.", folder.display()));
        }
        if settings.continues && settings.to_file && settings.output.as_deref().is_some_and(names::is_standard_output) {
            return Err("Cannot continue trace if output to STDOUT or STDERR is specified.".into());
        }
        let streams = Streams::open(settings, folder_of(named).as_path())?;
        let session = Session::new(settings.threads as usize);
        if let Some(file) = &settings.create_ini {
            let text = created_ini::created_ini(reading, session.threads());
            write_whole(file, text.as_bytes()).map_err(|error| error.to_string())?;
        }
        let piped = (scene == Path::new(names::STANDARD_INPUT)).then(standard_input).transpose()?;
        Ok(Self { settings, scene, piped, rendering, animation, frames, session, streams })
    }

    /// Whether all of them were made. The first shows how many at once make use of all cores.
    fn all_frames(&self) -> bool {
        let (n, mut done) = (self.frames.len(), 0);
        let first = Console::new(&self.streams, false);
        let (made, at_once) = self.frame(0, &first);
        done += usize::from(made);
        let work = |i: usize| {
            let console = Console::new(&self.streams, at_once > 1);
            let (made, _) = self.frame(i + 1, &console);
            (made, console)
        };
        in_order(n - 1, at_once, work, |_, (made, console)| {
            console.tell_all();
            done += usize::from(made);
            true
        });
        if done < n && n > 1 {
            line(format_args!("{} of {n} frames were not made", n - done));
        }
        done == n
    }

    /// Makes a frame: whether that went well, and how many of its like keep all cores busy.
    fn frame(&self, i: usize, console: &Console<'_>) -> (bool, usize) {
        let number = self.animation.map(|animation| (self.frames[i], animation.digits()));
        if let Some((frame, _)) = number {
            let last = self.animation.map_or(0, |animation| animation.final_frame);
            console.say(Sort::Render, format!("Rendering frame {frame} of {last}\n"));
        }
        console.plain(PARSING);
        let job = self.job(i, number);
        let host = SceneHost { disk: self.disk(), piped: self.piped.as_deref(), console };
        let ready = match self.session.compile(&job.scene, &job.reading, &host) {
            Ok(ready) => ready,
            Err(failed) => {
                console.show(&failed.diagnostics, &failed.sources);
                console.plain("Fatal error in parser: Cannot parse input.\n");
                return (false, 1);
            }
        };
        console.show(&ready.warnings, &ready.sources);
        console.plain(RENDERING);
        let mut outcome = self.picture(&job, ready, console);
        match self.session.write(&mut outcome, &job.outputs) {
            Ok(()) => {
                console.say(Sort::Statistics, statistics(&outcome));
                (true, outcome.timings.at_once(self.session.threads(), &self.rendering))
            }
            Err(error) => {
                console.say(Sort::Fatal, format!("Cannot open file. {error}\n"));
                (false, 1)
            }
        }
    }

    fn picture(&self, job: &Job, mut ready: Ready, console: &Console<'_>) -> Outcome {
        let window = self.rendering.window();
        // Those are told already.
        ready.warnings.clear();
        let progress = Progress::new(console, self.settings.verbose, window.width() * window.height());
        let mut outcome = self.session.develop(job, ready, &progress);
        progress.finish();
        console.show(&outcome.warnings, &outcome.sources);
        // POV-Ray's files have the full size, whatever part is rendered.
        if self.rendering.region.is_some() {
            outcome.picture = outcome.picture.completed();
        }
        outcome
    }

    fn job(&self, i: usize, number: Option<(u32, usize)>) -> Job {
        let settings = self.settings;
        let output =
            Output { file: names::picture(settings, number), kind: settings.kind, encoding: settings.encoding() };
        Job {
            scene: self.scene.clone(),
            reading: self.reading(i),
            rendering: self.rendering.clone(),
            outputs: if settings.to_file { vec![output] } else { Vec::new() },
        }
    }

    fn reading(&self, i: usize) -> eval::Options {
        let settings = self.settings;
        let mut reading = eval::Options {
            include_dirs: self.library(),
            header: settings.header.clone(),
            version: settings.version,
            declarations: settings.declarations.clone(),
            clock: single(settings.clock.unwrap_or(0.0)),
            animated: settings.clock.is_some(),
            image_width: self.rendering.width as u32,
            image_height: self.rendering.height as u32,
            now: days_since_2000(),
            ..eval::Options::default()
        };
        if let Some(animation) = self.animation {
            animation.show(self.frames[i], &mut reading);
        }
        reading
    }

    /// Folders to search: those of the settings, those of an installed POV-Ray, that of the scene.
    fn library(&self) -> Vec<PathBuf> {
        let mut folders = include_dirs::search_path(&self.settings.library, false);
        folders.push(folder_of(&self.scene));
        folders
    }

    /// Programs rely on it that a scene may write in the folder where it is rendered.
    fn disk(&self) -> Disk {
        let reach = Reach {
            scene: self.scene.clone(),
            include: include_dirs::search_path(&self.settings.library, false),
            write: vec![".".into()],
            home: std::env::home_dir(),
            ..Reach::default()
        };
        Disk::new(&reach, |_, _| {})
    }
}

fn folder_of(file: &Path) -> PathBuf {
    file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned()
}

fn standard_input() -> Result<Vec<u8>, String> {
    let mut text = Vec::new();
    std::io::stdin().lock().read_to_end(&mut text).map_err(|error| format!("cannot read standard input: {error}"))?;
    Ok(text)
}

/// What it took, in POV-Ray's words as far as they fit.
fn statistics(outcome: &Outcome) -> String {
    let [width, height] = outcome.picture.full;
    let mut text = format!("Render Statistics\nImage Resolution {width} x {height}\nRays: {}\n", outcome.metadata.rays);
    for (stage, time) in &outcome.timings.0 {
        text += &format!("  {stage:8} {:9.3} seconds\n", time.as_secs_f64());
    }
    text
}
