//! Camera rays that are neighbours in the picture.
//!
//! Most neighbours meet the same texture, at points so near each other that patterns are evaluated for all of them at
//! once, one in each SIMD lane. Four rays are followed to what they meet; then they are shaded one by one as ever, but
//! the colours of pigments come for all four together, when the first of them asks. No bit changes by it.

use super::camera::RawRay;
use super::gather::Gather;
use super::ray::Path;
use super::tracer::{Only, TextureSpace, Tracer, nothing, texture_space};
use crate::compiled::geometry::{Hit, Surface, TextureId};
use crate::compiled::texture::{Layer, Texture};
use crate::math::{Color, LANES, Points, Uv};
use smallvec::SmallVec;
use std::cell::OnceCell;

/// A camera ray and what it met. It refers to the one before, so that everything stays where it was made.
struct Sight<'s, 'w> {
    before: Option<&'s Sight<'s, 'w>>,
    position: [f64; 2],
    path: &'s Path,
    hit: &'s Hit,
    surface: &'s Surface,
    /// The only texture that shows.
    texture: TextureId,
    space: &'s TextureSpace<'w>,
}

/// Four points of one texture, and what colours its layers have there.
pub(super) struct Neighbours<'w> {
    layers: &'w [Layer],
    points: Points,
    uvs: [Uv; LANES],
    /// By layer, as far as they have been asked for.
    colors: SmallVec<[OnceCell<[Color; LANES]>; 1]>,
}

/// One of four neighbours.
#[derive(Clone, Copy)]
pub(super) struct Neighbour<'p> {
    all: &'p Neighbours<'p>,
    lane: usize,
}

impl Neighbour<'_> {
    /// The colour of a layer, by its index, if it is one that is found for all four at once.
    #[inline(always)]
    pub(super) fn color(self, layer: usize) -> Option<Color> {
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
            self.follow_each(positions, found);
        }
    }

    /// Follows the rays through image positions, and shades them together if all meet the same texture and that pays.
    fn follow_all<G: Gather>(&mut self, positions: &[[f64; 2]], before: Option<&Sight<'_, 'w>>, found: &mut Vec<G>) {
        let Some((position, others)) = positions.split_first() else { return self.shade_four(before, found) };
        let world = self.world;
        let [x, y] = *position;
        let raw = RawRay::through(&world.camera, x, y, self.options.width, self.options.height);
        let Some(raw) = raw else {
            self.shade_each(before, found);
            found.push(nothing());
            return self.follow_each(others, found);
        };
        let path = self.camera_path(raw.finish(&world.camera), f64::INFINITY);
        let Some(hit) = world.geometry.intersect(&path.ray, path.range, path.kind, &mut self.scratch) else {
            self.shade_each(before, found);
            self.start_at(x, y);
            found.push(self.seen(&path, None, None));
            return self.follow_each(others, found);
        };
        let surface = world.geometry.surface(&path.ray, &hit);
        let only = match &*surface.textures {
            [only] => Some(only).filter(|only| world.side_by_side[only.texture.0 as usize]),
            _ => None,
        };
        let Some(only) = only.filter(|only| before.is_none_or(|before| before.texture == only.texture)) else {
            self.shade_each(before, found);
            self.start_at(x, y);
            found.push(self.seen(&path, Some((&hit, &surface)), None));
            return self.follow_each(others, found);
        };
        let space = texture_space(world, &surface, &hit, only);
        let (position, texture) = (*position, only.texture);
        let sight = Sight { before, position, path: &path, hit: &hit, surface: &surface, texture, space: &space };
        self.follow_all(others, Some(&sight), found);
    }

    fn follow_each<G: Gather>(&mut self, positions: &[[f64; 2]], found: &mut Vec<G>) {
        positions.iter().for_each(|[x, y]| found.push(self.camera_ray(*x, *y)));
    }

    fn shade_each<G: Gather>(&mut self, last: Option<&Sight<'_, 'w>>, found: &mut Vec<G>) {
        if let Some(last) = last {
            self.shade_each(last.before, found);
            found.push(self.shade_sight(last, None));
        }
    }

    fn shade_four<G: Gather>(&mut self, last: Option<&Sight<'_, 'w>>, found: &mut Vec<G>) {
        let [Some(d), Some(c), Some(b), Some(a)] = before(last) else { return self.shade_each(last, found) };
        let Texture::Layers(layers) = self.world.texture(a.texture) else { return self.shade_each(last, found) };
        let all = Neighbours {
            layers,
            points: [a.space.point, b.space.point, c.space.point, d.space.point].into(),
            uvs: [a.surface.uv, b.surface.uv, c.surface.uv, d.surface.uv],
            colors: layers.iter().map(|_| OnceCell::new()).collect(),
        };
        for (lane, sight) in [a, b, c, d].into_iter().enumerate() {
            found.push(self.shade_sight(sight, Some(Neighbour { all: &all, lane })));
        }
    }

    fn shade_sight<G: Gather>(&mut self, sight: &Sight<'_, 'w>, neighbour: Option<Neighbour<'_>>) -> G {
        let [x, y] = sight.position;
        self.start_at(x, y);
        self.seen(sight.path, Some((sight.hit, sight.surface)), Some(Only { space: sight.space, neighbour }))
    }
}

/// Four sights, the last one first.
fn before<'s, 'w>(last: Option<&'s Sight<'s, 'w>>) -> [Option<&'s Sight<'s, 'w>>; LANES] {
    let next = |sight: Option<&'s Sight<'s, 'w>>| sight.and_then(|sight| sight.before);
    let (second, third) = (next(last), next(next(last)));
    [last, second, third, next(third)]
}
