//! Camera rays that are neighbours in the picture.
//!
//! Most neighbours meet the same texture, at points so near each other that patterns are evaluated for all of them at
//! once, one in each SIMD lane. Four rays are followed to what they meet; then they are shaded one by one as ever, but
//! the colours of pigments come for all four together, when the first of them asks. No bit changes by it.

use super::camera::RawRay;
use super::gather::Gather;
use super::ray::Path;
use super::tracer::{Tracer, lookup, nothing};
use crate::compiled::geometry::{Hit, Surface, TextureId};
use crate::compiled::texture::{Layer, Texture};
use crate::math::{Color, DVec3, LANES, Points, Uv, each_lane};
use smallvec::SmallVec;
use std::cell::OnceCell;

/// A camera ray and what it met. It refers to the one before, so that everything stays where it was made.
struct Sight<'s> {
    before: Option<&'s Sight<'s>>,
    position: [f64; 2],
    path: &'s Path,
    hit: &'s Hit,
    surface: &'s Surface,
}

/// Four points of one texture, and what colours its layers have there.
pub(super) struct Neighbours<'w> {
    layers: &'w [Layer],
    points: Points,
    uvs: [Uv; LANES],
    /// By layer, as far as they have been asked for.
    colors: SmallVec<[OnceCell<[Option<Color>; LANES]>; 1]>,
}

/// One of four neighbours.
#[derive(Clone, Copy)]
pub(super) struct Neighbour<'p> {
    all: &'p Neighbours<'p>,
    lane: usize,
}

impl Neighbour<'_> {
    /// The colour of a layer, by its index, if it is one that is found for all four at once.
    pub(super) fn color(self, layer: usize) -> Option<Option<Color>> {
        let Neighbours { layers, points, uvs, colors } = self.all;
        let Layer { pigment, side_by_side: true, .. } = &layers[layer] else { return None };
        Some(colors[layer].get_or_init(|| pigment.colors(points, uvs))[self.lane])
    }
}

impl<'w> Tracer<'w> {
    /// The light through image positions.
    pub(super) fn camera_rays<G: Gather>(&mut self, positions: &[[f64; 2]]) -> Vec<G> {
        let mut found = Vec::with_capacity(positions.len());
        positions.chunks(LANES).for_each(|some| self.follow_some(some, &mut found));
        found
    }

    /// The light through a grid of image positions, row by row, the first of which is given.
    pub(super) fn camera_grid<G: Gather>(&mut self, columns: usize, rows: usize, [left, top]: [f64; 2]) -> Vec<G> {
        let mut grid = vec![G::default(); columns * rows];
        let mut found = Vec::with_capacity(LANES);
        // Squares are nearer together than rows are.
        for j in (0..rows).step_by(2) {
            let (y, height) = (top + j as f64, (rows - j).min(2));
            for i in (0..columns).step_by(2) {
                let (x, width) = (left + i as f64, (columns - i).min(2));
                let square = [[x, y], [x + 1.0, y], [x, y + 1.0], [x + 1.0, y + 1.0]];
                match (width, height) {
                    (2, 2) => self.follow_some(&square, &mut found),
                    (1, 2) => self.follow_some(&[square[0], square[2]], &mut found),
                    _ => self.follow_some(&square[..width], &mut found),
                }
                for (k, found) in found.drain(..).enumerate() {
                    grid[(j + k / width) * columns + i + k % width] = found;
                }
            }
        }
        grid
    }

    /// Adds the light through at most four image positions.
    fn follow_some<G: Gather>(&mut self, positions: &[[f64; 2]], found: &mut Vec<G>) {
        if self.side_by_side && positions.len() == LANES {
            self.follow_all(positions, None, found);
        } else {
            found.extend(positions.iter().map(|[x, y]| self.camera_ray::<G>(*x, *y)));
        }
    }

    /// Follows the rays through image positions, and shades them when all of them have met something.
    fn follow_all<G: Gather>(&mut self, positions: &[[f64; 2]], before: Option<&Sight<'_>>, found: &mut Vec<G>) {
        let Some((position, others)) = positions.split_first() else { return self.shade_all(before, found) };
        let camera = &self.world.camera;
        let [x, y] = *position;
        let Some(raw) = RawRay::through(camera, x, y, self.options.width, self.options.height) else {
            self.shade_all(before, found);
            found.push(nothing());
            return others.iter().for_each(|[x, y]| found.push(self.camera_ray(*x, *y)));
        };
        let path = self.camera_path(raw.finish(camera), f64::INFINITY);
        let Some(hit) = self.world.geometry.intersect(&path.ray, path.range, path.kind, &mut self.scratch) else {
            self.shade_all(before, found);
            self.start_at(x, y);
            found.push(self.seen(&path, None, None));
            return others.iter().for_each(|[x, y]| found.push(self.camera_ray(*x, *y)));
        };
        let surface = self.world.geometry.surface(&path.ray, &hit);
        let sight = Sight { before, position: *position, path: &path, hit: &hit, surface: &surface };
        self.follow_all(others, Some(&sight), found);
    }

    fn shade_all<G: Gather>(&mut self, last: Option<&Sight<'_>>, found: &mut Vec<G>) {
        let mut sights: SmallVec<[&Sight<'_>; LANES]> = std::iter::successors(last, |sight| sight.before).collect();
        sights.reverse();
        let neighbours = self.neighbours(&sights);
        for (lane, sight) in sights.iter().enumerate() {
            let [x, y] = sight.position;
            self.start_at(x, y);
            let neighbour = neighbours.as_ref().map(|all| Neighbour { all, lane });
            found.push(self.seen(sight.path, Some((sight.hit, sight.surface)), neighbour));
        }
    }

    /// What four hits have in common, if that is worth anything.
    fn neighbours(&self, sights: &[&Sight<'_>]) -> Option<Neighbours<'w>> {
        let [first, others @ ..] = sights else { return None };
        let texture = first.only_texture()?;
        if sights.len() != LANES || others.iter().any(|other| other.only_texture() != Some(texture)) {
            return None;
        }
        let Texture::Layers(layers) = self.world.texture(texture) else { return None };
        if !layers.iter().any(|layer| layer.side_by_side) {
            return None;
        }
        Some(Neighbours {
            layers,
            points: each_lane(|i| sights[i].lookup(self)).into(),
            uvs: each_lane(|i| sights[i].surface.uv),
            colors: layers.iter().map(|_| OnceCell::new()).collect(),
        })
    }
}

impl Sight<'_> {
    /// The texture that shows, where it is no more than one.
    fn only_texture(&self) -> Option<TextureId> {
        match &*self.surface.textures {
            [only] => Some(only.texture),
            _ => None,
        }
    }

    /// Where the first texture is looked up.
    fn lookup(&self, tracer: &Tracer<'_>) -> DVec3 {
        let first = self.surface.textures.first();
        first.map_or(DVec3::ZERO, |seen| lookup(tracer.world, self.surface, self.hit, seen).0)
    }
}
