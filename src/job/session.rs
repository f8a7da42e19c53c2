//! What several pictures share, and the way of each through the stages.

use super::library::{Library, Remembering};
use super::{Explanation, Job, Outcome, Output, Ready, Timings};
use crate::compile::geometry::Watched;
use crate::compile::{self, Compiled, Functions, Queries};
use crate::compiled::World;
use crate::compiled::camera::Camera;
use crate::eval::{self, Evaluated, Failed, Host};
use crate::imaging::{self, ImageError, Metadata};
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
        // On this thread, whose heap grows in large pages.
        let read = timings.time("read", || eval::evaluate(scene, reading, &host, &Queries::sharing(&functions)));
        let Evaluated { scene: description, mut warnings, mut sources } = read?;
        sources.release_large();
        match timings.time("compile", || self.on_all_threads(|| compile::compile_with(&description, &functions, reading.keep))) {
            Ok(Compiled { world, warnings: more, watched, ledger }) => {
                warnings.extend(more);
                Ok(Ready { world, watched, ledger, warnings, sources, timings })
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
        let Ready { world, watched, ledger, mut warnings, sources, mut timings } = ready;
        let mut options = job.rendering.clone();
        if let Some(time) = options.target.as_mut().and_then(|target| target.time.as_mut()) {
            *time = time.saturating_sub(timings.total());
        }
        let rendered = timings.time("render", || self.picture(&world, &options, observer));
        warnings.extend(watched.iter().filter_map(Watched::warning));
        let metadata = Metadata {
            software: concat!("whitted ", env!("CARGO_PKG_VERSION")).into(),
            scene: job.scene.display().to_string(),
            camera: describe(&world.camera),
            rays: rendered.statistics.rays(),
            figures: figures(&rendered, job.rendering.target.as_ref()),
            notes: rendered.progress.iter().map(|progress| ("whitted:rounds", progress.recipe())).collect(),
        };
        let Rendered { picture, complete, progress, statistics } = rendered;
        let explanation = Explanation { found: world.summary(), ledger, rays: statistics };
        Ok(Outcome { picture, metadata, complete, progress, warnings, sources, timings, explanation })
    }

    /// Writes a picture's files, each whole or not at all.
    ///
    /// # Errors
    /// When one cannot be written; those before it are there.
    pub fn write(&self, outcome: &mut Outcome, outputs: &[Output]) -> Result<(), ImageError> {
        let Outcome { picture, metadata, timings, .. } = outcome;
        let save = || outputs.iter().try_for_each(|o| imaging::save(&o.file, picture, metadata, o.encoding));
        timings.time("write", || self.on_all_threads(save))
    }
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
