//! Image positions that are neighbours in the picture.
//!
//! Most neighbours meet the same texture, or the sky, at points so near each other that patterns are evaluated for all of
//! them at once, one in each SIMD lane. Four rays are followed to what they meet; then they are shaded one by one as ever,
//! but the colours of pigments come for all four together, when the first of them asks. No bit changes by it.

use super::position::{at_position, nothing, path};
use crate::compiled::geometry::{Hit, Surface, TextureId};
use crate::compiled::texture::Texture;
use crate::math::{LANES, Points, Uv, each_lane};
use crate::render::camera::RawRay;
use crate::render::environment;
use crate::render::film::Gather;
use crate::render::path::Path;
use crate::render::random::Random;
use crate::render::shade::{Known, Lane, Lanes, TextureSpace, texture_space};
use crate::render::transport::{escaped, reflected};
use crate::render::worker::Worker;
use smallvec::SmallVec;

/// A camera ray and what it met. It refers to the one before, so that everything stays where it was made.
struct Encounter<'s> {
    before: Option<&'s Encounter<'s>>,
    path: &'s Path,
    met: Met<'s>,
}

/// What a camera ray met.
enum Met<'s> {
    /// A surface with a single texture.
    Surface { hit: &'s Hit, surface: &'s Surface, texture: TextureId, space: TextureSpace<'s> },
    /// The sky.
    Sky,
}

/// The light through image positions.
pub(in crate::render) fn at_positions<G: Gather>(worker: &mut Worker<'_>, positions: &[[f64; 2]]) -> Vec<G> {
    let mut found = Vec::with_capacity(positions.len());
    positions.chunks(LANES).for_each(|some| at_some(worker, some, &mut found));
    found
}

/// The light through a grid of image positions, row by row, the first of which is given.
pub(in crate::render) fn at_grid<G: Gather>(
    worker: &mut Worker<'_>,
    columns: usize,
    rows: usize,
    [left, top]: [f64; 2],
) -> Vec<G> {
    let mut grid = vec![G::default(); columns * rows];
    let mut found = Vec::with_capacity(LANES);
    // Squares are nearer together than rows are.
    for j in (0..rows).step_by(2) {
        let (y, height) = (top + j as f64, (rows - j).min(2));
        for i in (0..columns).step_by(2) {
            let (x, width) = (left + i as f64, (columns - i).min(2));
            let square = [[x, y], [x + 1.0, y], [x, y + 1.0], [x + 1.0, y + 1.0]];
            match (width, height) {
                (2, 2) => at_some(worker, &square, &mut found),
                (1, 2) => at_some(worker, &[square[0], square[2]], &mut found),
                _ => at_some(worker, &square[..width], &mut found),
            }
            for (k, found) in found.drain(..).enumerate() {
                grid[(j + k / width) * columns + i + k % width] = found;
            }
        }
    }
    grid
}

/// Adds the light through at most four image positions.
fn at_some<G: Gather>(worker: &mut Worker<'_>, positions: &[[f64; 2]], found: &mut Vec<G>) {
    if worker.prepared.side_by_side && positions.len() == LANES {
        at_all(worker, positions, None, found);
    } else {
        at_each(worker, positions, found);
    }
}

/// Adds the light through image positions, one by one.
fn at_each<G: Gather>(worker: &mut Worker<'_>, positions: &[[f64; 2]], found: &mut Vec<G>) {
    positions.iter().for_each(|position| found.push(at_position(worker, *position)));
}

/// Follows the rays through image positions, and shades them together if all meet the same texture and that pays.
fn at_all<G: Gather>(
    worker: &mut Worker<'_>,
    positions: &[[f64; 2]],
    before: Option<&Encounter<'_>>,
    found: &mut Vec<G>,
) {
    let Some((&[x, y], others)) = positions.split_first() else { return shade_four(worker, before, found) };
    let (world, options) = (worker.world(), worker.options());
    let Some(raw) = RawRay::through(&world.camera, x, y, options.width, options.height) else {
        return part(worker, before, nothing(), others, found);
    };
    let path = path(worker, raw.finish(&world.camera), f64::INFINITY, Random::at(x, y));
    let Some(hit) = worker.intersect(&path) else {
        let encounter = Encounter { before, path: &path, met: Met::Sky };
        if world.features.side_by_side_sky && before.is_none_or(|before| matches!(before.met, Met::Sky)) {
            return at_all(worker, others, Some(&encounter), found);
        }
        let light = shade(worker, &encounter, None);
        return part(worker, before, light, others, found);
    };
    let surface = world.geometry.surface(&path.ray, &hit);
    let only = match &*surface.textures {
        [only] => Some(only).filter(|only| world.texture(only.texture).is_side_by_side()),
        _ => None,
    };
    let Some(only) = only.filter(|only| before.is_none_or(|before| before.shows(only.texture))) else {
        let light = sample(reflected(worker, &path, &hit, &surface, None));
        return part(worker, before, light, others, found);
    };
    let mut room = None;
    let space = texture_space(world, &surface, &hit, only, &mut room);
    let met = Met::Surface { hit: &hit, surface: &surface, texture: only.texture, space };
    at_all(worker, others, Some(&Encounter { before, path: &path, met }), found);
}

/// Goes on one by one from a ray that has nothing in common with those before, and brought back some light.
fn part<G: Gather>(
    worker: &mut Worker<'_>,
    before: Option<&Encounter<'_>>,
    light: G,
    others: &[[f64; 2]],
    found: &mut Vec<G>,
) {
    shade_each(worker, before, found);
    found.push(light);
    at_each(worker, others, found);
}

/// Adds the light of fewer than four encounters, or of such as have nothing in common.
fn shade_each<G: Gather>(worker: &mut Worker<'_>, last: Option<&Encounter<'_>>, found: &mut Vec<G>) {
    if let Some(last) = last {
        shade_each(worker, last.before, found);
        found.push(shade(worker, last, None));
    }
}

/// The light of an encounter.
fn shade<G: Gather>(worker: &mut Worker<'_>, encounter: &Encounter<'_>, lane: Option<Lane<'_>>) -> G {
    let path = encounter.path;
    sample(match encounter.met {
        Met::Surface { hit, surface, space, .. } => reflected(worker, path, hit, surface, Some(Known { space, lane })),
        Met::Sky => escaped(worker, path, environment::radiance(worker.world(), worker.options(), path)),
    })
}

/// What one camera ray brought back.
fn sample<G: Gather>(mut light: G) -> G {
    light.note_sample();
    light
}

/// Adds the light of four encounters with one texture or with the sky.
fn shade_four<G: Gather>(worker: &mut Worker<'_>, last: Option<&Encounter<'_>>, found: &mut Vec<G>) {
    let [Some(d), Some(c), Some(b), Some(a)] = backwards(last) else { return shade_each(worker, last, found) };
    let four = [a, b, c, d];
    let Met::Surface { texture, .. } = a.met else { return shade_skies(worker, four, found) };
    let Texture::Layers(layers) = worker.world().texture(texture) else { return shade_each(worker, last, found) };
    let place = |i: usize| match four[i].met {
        Met::Surface { surface, space, .. } => (space.point, surface.uv),
        Met::Sky => Default::default(),
    };
    let places = each_lane(place);
    let lanes = Lanes::new(layers, each_lane(|i| places[i].0), each_lane(|i| places[i].1));
    for (lane, encounter) in four.into_iter().enumerate() {
        found.push(shade(worker, encounter, Some(lanes.lane(lane))));
    }
}

/// Adds the light of four rays that see the sky.
fn shade_skies<G: Gather>(worker: &mut Worker<'_>, four: [&Encounter<'_>; LANES], found: &mut Vec<G>) {
    let (world, options) = (worker.world(), worker.options());
    let Some(sky) = &world.atmosphere.sky else { return };
    let points = Points::from(each_lane(|i| sky.sky_from_world.point(four[i].path.ray.direction)));
    let uvs = [Uv::default(); LANES];
    let colors: SmallVec<[_; 2]> = sky.pigments.iter().rev().map(|p| p.colors(&points, &uvs)).collect();
    for (lane, Encounter { path, .. }) in four.into_iter().enumerate() {
        let light = environment::radiance_of(world, options, path, sky, colors.iter().map(|lanes| lanes[lane]));
        found.push(sample(escaped(worker, path, light)));
    }
}

impl Encounter<'_> {
    /// Whether a texture is the only one that shows.
    fn shows(&self, texture: TextureId) -> bool {
        matches!(self.met, Met::Surface { texture: own, .. } if own == texture)
    }
}

/// Four encounters, the last one first.
fn backwards<'s>(last: Option<&'s Encounter<'s>>) -> [Option<&'s Encounter<'s>>; LANES] {
    let next = |encounter: Option<&'s Encounter<'s>>| encounter.and_then(|encounter| encounter.before);
    let (second, third) = (next(last), next(next(last)));
    [last, second, third, next(third)]
}
