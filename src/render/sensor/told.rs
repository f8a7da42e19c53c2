//! The ray through an image position, told step by step.

use super::position::{at_position, path};
use crate::compiled::camera::Projection;
use crate::render::camera::RawRay;
use crate::render::radiance::Radiance;
use crate::render::random::Random;
use crate::render::transport::{Story, told};
use crate::render::worker::Worker;

/// The light through an image position, and how it comes about. Of cameras that send many rays through one, that through
/// the middle of the lens is told.
pub(in crate::render) fn told_at(worker: &mut Worker<'_>, [x, y]: [f64; 2]) -> (Radiance, String) {
    let (camera, options) = (&worker.world().camera, worker.options());
    let mut story = Story::default();
    let is_mesh = matches!(camera.projection, Projection::Mesh(_));
    let ray = if is_mesh { None } else { RawRay::through(camera, x, y, options.width, options.height) };
    let Some(raw) = ray else {
        story.line(if is_mesh { "rays of a mesh camera are not told" } else { "the camera sends no ray through here" });
        return (at_position(worker, [x, y]), story.text);
    };
    let along = path(worker, raw.finish(camera), f64::INFINITY, Random::at(x, y));
    let light = told(worker, &along, "camera", &mut story);
    if worker.prepared.lens.is_some() {
        story.line("this is the ray through the middle of the lens; the pixel is the mean over the lens");
        return (at_position(worker, [x, y]), story.text);
    }
    (light, story.text)
}
