//! From settings to pictures.

use super::console::{Console, Streams};
use super::progress::Progress;
use super::reader::Reading;
use super::scene_host::SceneHost;
use super::settings::{Settings, Sort};
use super::{CANCELLED, FAILED, created_ini, frames, names, report};
use crate::cli::messages::line;
use crate::cli::{include_dirs, scene_arguments::days_since_2000};
use crate::eval::{self, Disk, Reach};
use crate::imaging::{check_writable, pause_writing, write_whole};
use crate::job::{
    Animation, Earlier, Exposure, Job, Keeping, Outcome, Output, PATIENCE, Ready, Session, measured_in_order, single,
};
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

const OTHER_STATE: &str =
    "Warning: the state file is that of another picture (other scene, files or options) and is not used\n";

/// Renders what was asked for.
pub(super) fn run(reading: &Reading) -> ExitCode {
    reading.notes.iter().for_each(|note| line(format_args!("note: {note}")));
    match Run::prepare(reading) {
        Ok(run) => {
            stop_on_signals();
            Console::new(&run.streams, false)
                .say(Sort::Render, report::options(&run.scene, run.settings, &run.rendering));
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
        // What cannot be written is better known before than after hours of work.
        if settings.to_file {
            let number = animation.map(|animation| (frames[0], animation.digits()));
            check_writable(&names::picture(settings, number))
                .map_err(|error| format!("Cannot create render state output file.\n{error}"))?;
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

    /// Whether all of them were made. A frame that fails is no reason to leave out the others.
    fn all_frames(&self) -> bool {
        let (n, mut done) = (self.frames.len(), 0);
        let work = |i: usize, is_alone: bool| {
            let console = Console::new(&self.streams, !is_alone);
            let (made, at_once) = self.frame(i, &console);
            ((made, console), at_once)
        };
        measured_in_order(n, work, |_, (made, console)| {
            console.tell_all();
            done += usize::from(made);
            true
        });
        if done < n && n > 1 {
            line(format_args!("{} of {n} frames were not made", n - done));
        }
        done == n
    }

    /// Makes a frame: whether it is there now, and, if it was made, how many of its like keep all cores busy.
    fn frame(&self, i: usize, console: &Console<'_>) -> (bool, Option<usize>) {
        let number = self.animation.map(|animation| (self.frames[i], animation.digits()));
        let job = self.job(i, number);
        if let Some(animation) = self.animation {
            console.say(Sort::Render, format!("Rendering frame {} of {}\n", self.frames[i], animation.final_frame));
        }
        console.plain(PARSING);
        let host = SceneHost { disk: self.disk(), piped: self.piped.as_deref(), console };
        let ready = match self.session.compile(&job.scene, &job.reading, &host) {
            Ok(ready) => ready,
            Err(failed) => {
                console.show(&failed.diagnostics, &failed.sources);
                console.plain("Fatal error in parser: Cannot parse input.\n");
                return (false, None);
            }
        };
        console.show(&ready.warnings, &ready.sources);
        if self.is_made(&job, &ready, console) {
            return (true, None);
        }
        console.plain(RENDERING);
        let mut outcome = self.picture(&job, ready, console);
        match self.session.write(&mut outcome, &job) {
            Ok(()) => {
                console.say(Sort::Statistics, report::statistics(&outcome));
                (true, Some(outcome.at_once(self.session.threads(), &job)))
            }
            Err(error) => {
                console.say(Sort::Fatal, format!("Cannot open file. {error}\n"));
                (false, None)
            }
        }
    }

    /// Whether the picture that is to be gone on with is finished.
    fn is_made(&self, job: &Job, ready: &Ready, console: &Console<'_>) -> bool {
        let made = self.settings.continues.then(|| self.session.is_made(job, ready)).flatten();
        match made {
            Some(true) => console.say(Sort::Render, "File already rendered and continue requested; skipping.\n"),
            Some(false) => {
                let file = job.outputs.first().map_or(Path::new(""), |output| &output.file);
                let why = "is not the picture of this scene with these options, as far as it says, and is made anew";
                console.say(Sort::Warning, format!("Warning: '{}' {why}\n", file.display()));
            }
            None => {}
        }
        made == Some(true)
    }

    fn picture(&self, job: &Job, mut ready: Ready, console: &Console<'_>) -> Outcome {
        let window = self.rendering.window();
        // Those are told already.
        ready.warnings.clear();
        let progress = Progress::new(console, self.settings.verbose, window.width() * window.height());
        let mut outcome = self.session.develop(job, ready, &progress);
        progress.finish();
        match outcome.earlier {
            Earlier::Nothing => {}
            Earlier::Other => console.say(Sort::Warning, OTHER_STATE),
            Earlier::Pieces(n) => console.say(Sort::Render, format!("Continued: {n} pieces were there already\n")),
        }
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
            exposure: Exposure::default(),
            keeping: if settings.continues { Keeping::Resuming } else { Keeping::New },
            patience: PATIENCE,
            light: settings.light_files(),
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
