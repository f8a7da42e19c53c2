//! The stages in order, timed: read, compile, render.

use crate::compile::geometry::Watched;
use crate::compile::{self, Compiled, Queries};
use crate::diag::{Diagnostic, SourceMap};
use crate::eval::{self, Evaluated, Failed, Host};
use crate::imaging::{Metadata, Picture};
use crate::render::{self, Options, Progress};
use std::path::Path;
use std::time::{Duration, Instant};

/// How long each stage took, in order.
#[derive(Clone, Debug, Default)]
pub struct Timings(pub Vec<(&'static str, Duration)>);

impl Timings {
    /// Runs a stage and notes its time.
    pub fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        self.0.push((stage, start.elapsed()));
        result
    }
}

/// A finished picture with all that was found out on the way.
#[derive(Debug)]
pub struct Outcome {
    /// The picture, linear light.
    pub picture: Picture,
    /// What its file should say.
    pub metadata: Metadata,
    /// Everything worth mentioning.
    pub warnings: Vec<Diagnostic>,
    /// The files that were read, to show the warnings; large ones must be [restored](SourceMap::restored).
    pub sources: SourceMap,
    /// Time of each stage.
    pub timings: Timings,
}

/// A scene that is ready to be rendered.
#[derive(Debug)]
pub struct Ready {
    /// What rays meet.
    pub compiled: Compiled,
    /// Everything worth mentioning; those of [`Compiled`] have moved here.
    pub warnings: Vec<Diagnostic>,
    /// The files that were read, to show the warnings; large ones must be [restored](SourceMap::restored).
    pub sources: SourceMap,
    /// Time of each stage.
    pub timings: Timings,
}

/// From a scene file to a world: all that can go wrong with a scene goes wrong here.
///
/// # Errors
/// What is wrong with the scene, with the files needed to show it (large ones must be
/// [restored](SourceMap::restored)).
pub fn compile_file(scene: &Path, reading: &eval::Options, host: &dyn Host) -> Result<Ready, Box<Failed>> {
    let mut timings = Timings::default();
    let Evaluated { scene: description, mut warnings, mut sources } =
        timings.time("read", || eval::evaluate(scene, reading, host, &Queries::default()))?;
    sources.release_large();
    match timings.time("compile", || compile::compile(&description)) {
        Ok(mut compiled) => {
            warnings.append(&mut compiled.warnings);
            Ok(Ready { compiled, warnings, sources, timings })
        }
        Err(errors) => {
            warnings.extend(errors);
            Err(Box::new(Failed { diagnostics: warnings, sources }))
        }
    }
}

/// From a scene file to a picture.
///
/// # Errors
/// Those of [`compile_file`].
pub fn render_file(
    scene: &Path,
    reading: &eval::Options,
    options: &Options,
    host: &dyn Host,
    progress: Progress<'_>,
) -> Result<Outcome, Box<Failed>> {
    let Ready { compiled, mut warnings, sources, mut timings } = compile_file(scene, reading, host)?;
    let Compiled { world, watched, .. } = compiled;
    let rendered = timings.time("render", || render::render(&world, options, progress));
    warnings.extend(watched.iter().filter_map(Watched::warning));
    let metadata = Metadata {
        software: concat!("whitted ", env!("CARGO_PKG_VERSION")).into(),
        scene: scene.display().to_string(),
        camera: describe(&world.camera),
        rays: rendered.statistics.rays(),
    };
    Ok(Outcome { picture: rendered.picture, metadata, warnings, sources, timings })
}

fn describe(camera: &crate::compiled::camera::Camera) -> String {
    let vector = |v: crate::math::DVec3| format!("<{}, {}, {}>", v.x, v.y, v.z);
    format!(
        "{} location {} direction {} right {} up {}",
        camera.projection.name(),
        vector(camera.location),
        vector(camera.direction),
        vector(camera.right),
        vector(camera.up)
    )
}
