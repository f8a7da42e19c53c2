//! What several pictures share, and the way of each through the stages.

use super::exposure::Mean;
use super::identity::Noting;
use super::library::{Library, Remembering};
use super::projection::projection;
use super::recipe::recipe;
use super::state::{self, Earlier, State};
use super::{Explanation, Identity, Job, Keeping, Outcome, Output, Ready, Timings};
use crate::compile::geometry::Watched;
use crate::compile::{self, Compiled, Functions, Queries};
use crate::compiled::World;
use crate::compiled::camera::Camera;
use crate::eval::{self, Evaluated, Failed, Host};
use crate::expanded;
use crate::imaging::{self, Curve, Encoding, ImageError, Metadata};
use crate::math::DVec3;
use crate::render::{self, Observer, Options, Progress, Rendered, Statistics, Target};
use rayon::ThreadPool;
use std::path::Path;

/// Room for deep recursion through glass, which needs more than the usual stack.
const STACK: usize = 64 << 20;

/// Threads, and what else outlives a picture.
#[derive(Debug)]
pub struct Session {
    /// None where the system gives no threads: then the common ones must do.
    pool: Option<ThreadPool>,
    /// Files that the last scene read.
    library: Library,
}

impl Session {
    /// With so many threads; 0 for one for each core.
    pub fn new(threads: usize) -> Self {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build().ok();
        Self { pool, library: Library::default() }
    }

    /// How many threads work on a picture.
    pub fn threads(&self) -> usize {
        self.pool.as_ref().map_or_else(rayon::current_num_threads, ThreadPool::current_num_threads)
    }

    /// From a scene file to a world: all that can go wrong with a scene goes wrong here.
    ///
    /// # Errors
    /// What is wrong with the scene, with the files needed to show it (large ones must be
    /// [restored](crate::diag::SourceMap::restored)).
    pub fn compile(&self, scene: &Path, reading: &eval::Options, host: &dyn Host) -> Result<Ready, Box<Failed>> {
        let mut timings = Timings::default();
        self.library.begin_scene();
        let functions = Functions::sharing(&self.library.pictures);
        let host = Remembering { host, library: &self.library };
        let host = Noting::new(&host);
        // On this thread, whose heap grows in large pages.
        let read = timings.time("read", || expanded::evaluate(scene, reading, &host, &Queries::sharing(&functions)));
        let Evaluated { scene: description, mut warnings, mut sources } = read?;
        sources.release_large();
        match timings
            .time("compile", || self.on_all_threads(|| compile::compile_with(&description, &functions, reading.keep)))
        {
            Ok(Compiled { world, warnings: more, watched, ledger }) => {
                warnings.extend(more);
                Ok(Ready { world, watched, ledger, warnings, sources, timings, digest: host.digest() })
            }
            Err(errors) => {
                warnings.extend(errors);
                Err(Box::new(Failed { diagnostics: warnings, sources }))
            }
        }
    }

    /// A picture of a world, on all threads.
    pub fn picture(&self, world: &World, options: &Options, observer: &dyn Observer) -> Rendered {
        self.on_all_threads(|| render::render(world, options, observer))
    }

    /// How a pixel of a world comes about.
    pub fn tell(&self, world: &World, options: &Options, pixel: [usize; 2]) -> render::Told {
        self.on_all_threads(|| render::tell(world, options, pixel))
    }

    fn on_all_threads<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// From a scene file to a picture.
    ///
    /// # Errors
    /// Those of [`compile`](Self::compile).
    pub fn render(&self, job: &Job, host: &dyn Host, observer: &dyn Observer) -> Result<Outcome, Box<Failed>> {
        let ready = self.compile(&job.scene, &job.reading, host)?;
        Ok(self.develop(job, ready, observer))
    }

    /// From a scene that is ready to a picture.
    pub fn develop(&self, job: &Job, ready: Ready, observer: &dyn Observer) -> Outcome {
        let (job, light_warnings) = job.with_known_light();
        let job = &*job;
        let identity = Identity::new(job, &ready.digest);
        let (state, earlier) = state_of(job, identity).map_or((None, Earlier::Nothing), |(s, e)| (Some(s), e));
        let Ready { world, watched, ledger, mut warnings, sources, mut timings, .. } = ready;
        let mut options = job.rendering.clone();
        if let Some(time) = options.target.as_mut().and_then(|target| target.time.as_mut()) {
            *time = time.saturating_sub(timings.total());
        }
        let keeping = state.as_ref().map(|state| state::Keeping { observer, state });
        let observer = keeping.as_ref().map_or(observer, |keeping| keeping as &dyn Observer);
        let rendered = timings.time("render", || self.picture(&world, &options, observer));
        warnings.extend(light_warnings);
        warnings.extend(watched.iter().filter_map(Watched::warning));
        let metadata = Metadata {
            software: concat!("whitted ", env!("CARGO_PKG_VERSION")).into(),
            scene: job.scene.display().to_string(),
            options: recipe(job),
            camera: describe(&world.camera),
            projection: projection(&world.camera),
            rays: rendered.statistics.rays(),
            figures: figures(&rendered, job.rendering.target.as_ref()),
            notes: notes(&rendered, identity),
        };
        let Rendered { picture, complete, progress, statistics, light } = rendered;
        let explanation = Explanation { found: world.summary(), ledger, rays: statistics };
        let display_values = world.settings.display_values;
        let working = world.settings.transfer.curve();
        Outcome {
            picture,
            metadata,
            display_values,
            working,
            complete,
            progress,
            warnings,
            sources,
            timings,
            explanation,
            earlier,
            light,
            state,
        }
    }

    /// From a scene file to the mean of pictures at the moments of the job's exposure, in linear light.
    ///
    /// # Errors
    /// Those of [`compile`](Self::compile), of the first moment that has any.
    pub fn expose(&self, job: &Job, host: &dyn Host, observer: &dyn Observer) -> Result<Outcome, Box<Failed>> {
        let moment = |clock: f64| -> Result<(Outcome, Identity), Box<Failed>> {
            let mut moment = Job { keeping: Keeping::Nothing, ..job.clone() };
            moment.reading.clock = clock;
            let ready = self.compile(&moment.scene, &moment.reading, host)?;
            let identity = Identity::new(job, &ready.digest);
            Ok((self.develop(&moment, ready, observer), identity))
        };
        let mut clocks = job.exposure.clocks(job.reading.clock);
        let (first, identity) = moment(clocks.next().unwrap_or(job.reading.clock))?;
        let mut mean = Mean::new(first, identity);
        for clock in clocks {
            mean.add(moment(clock)?.0);
        }
        let mut outcome = mean.outcome();
        outcome.metadata.options = recipe(job);
        Ok(outcome)
    }

    /// Writes a job's files, each whole or not at all.
    ///
    /// # Errors
    /// When one cannot be written; those before it are there.
    pub fn write(&self, outcome: &mut Outcome, job: &Job) -> Result<(), ImageError> {
        let Outcome { picture, metadata, display_values, working, timings, state, light, .. } = outcome;
        let save = |output: &Output| {
            let curve = if *display_values { Curve::Srgb } else { output.encoding.curve };
            let encoding = Encoding { curve, working: *working, ..output.encoding };
            imaging::save_as(&output.file, output.kind, picture, metadata, &encoding)
        };
        let save = || job.outputs.iter().try_for_each(save);
        let written =
            timings.time("write", || self.on_all_threads(save)).and_then(|()| job.light.write(light.as_ref()));
        // A picture that could not be written can still be, from its pieces.
        if let Some(state) = state.as_ref().filter(|_| written.is_ok()) {
            state.discard();
        }
        written
    }

    /// Whether the job's file is there already: `None` without one, else whether it says that it is the same picture.
    /// Then nothing stays beside it of a run that was killed between writing it and clearing up.
    pub fn is_made(&self, job: &Job, ready: &Ready) -> Option<bool> {
        let file = job.marked_file()?;
        let bytes = std::fs::read(file).ok().filter(|bytes| !bytes.is_empty())?;
        let is_made = imaging::mark_of(&bytes).as_deref()
            == Some(&*Identity::new(&job.with_known_light().0, &ready.digest).to_string());
        if is_made {
            imaging::sweep(file);
            let _ = std::fs::remove_file(state::state_file(file));
        }
        Some(is_made)
    }
}

/// The pieces of a picture, and what an earlier run had left of them.
fn state_of(job: &Job, identity: Identity) -> Option<(State, Earlier)> {
    if job.keeping == Keeping::Resuming {
        job.outputs.iter().for_each(|output| imaging::sweep(&output.file));
    }
    let path = state::state_file(job.kept_beside()?);
    Some(State::open(path, identity, job.keeping == Keeping::Resuming, job.patience))
}

/// What the file says in words: which picture it is, and how one with a target came about.
fn notes(rendered: &Rendered, identity: Identity) -> Vec<(&'static str, String)> {
    let rounds = rendered.progress.iter().map(|progress| ("whitted:rounds", progress.recipe()));
    std::iter::once((imaging::MARK, identity.to_string())).chain(rounds).collect()
}

/// What the file says in numbers: rays by kind and, of a picture with a target, how far it came.
fn figures(rendered: &Rendered, target: Option<&Target>) -> Vec<(String, f64)> {
    let mut figures = rays_by_kind(&rendered.statistics);
    let mut note = |name: &str, value: f64| figures.push((format!("whitted:{name}"), value));
    if let Some(Progress { accuracy, samples, .. }) = &rendered.progress {
        note("errorEstimate", accuracy.rmse());
        note("errorUncertainty", accuracy.uncertainty());
        note("samples", *samples as f64);
    }
    if let Some(Target { error, time, seed, .. }) = target {
        note("seed", *seed as f64);
        error.iter().for_each(|error| note("errorTarget", *error));
        time.iter().for_each(|time| note("timeBudget", time.as_secs_f64()));
    }
    figures
}

/// As a file's header names them.
fn rays_by_kind(rays: &Statistics) -> Vec<(String, f64)> {
    let kinds = [
        ("camera", rays.camera_rays),
        ("transmitted", rays.transmitted_rays),
        ("reflected", rays.reflected_rays),
        ("shadow", rays.shadow_rays),
    ];
    kinds.map(|(kind, n)| (format!("whitted:{kind}Rays"), n as f64)).into()
}

fn describe(camera: &Camera) -> String {
    let vector = |v: DVec3| format!("<{}, {}, {}>", v.x, v.y, v.z);
    format!(
        "{} location {} direction {} right {} up {}",
        camera.projection.name(),
        vector(camera.location),
        vector(camera.direction),
        vector(camera.right),
        vector(camera.up)
    )
}
