//! Camera rays that are neighbours in the picture.
//!
//! Most neighbours meet the same texture, or the sky, at points so near each other that patterns are evaluated for all of
//! them at once, one in each SIMD lane. Four rays are followed to what they meet; then they are shaded one by one as ever,
//! but the colours of pigments come for all four together, when the first of them asks. No bit changes by it.

use super::camera::RawRay;
use super::gather::Gather;
use super::ray::Path;
use super::tracer::{Only, TextureSpace, Tracer, nothing, texture_space};
use crate::compiled::geometry::{Hit, Surface, TextureId};
use crate::compiled::texture::{Layer, Texture};
use crate::math::{Color, LANES, Points, Uv, each_lane};
use smallvec::SmallVec;
use std::cell::OnceCell;

/// A camera ray and what it met. It refers to the one before, so that everything stays where it was made.
struct Sight<'s, 'w> {
    before: Option<&'s Sight<'s, 'w>>,
    position: [f64; 2],
    path: &'s Path,
    met: Met<'s, 'w>,
}

/// What a camera ray met.
enum Met<'s, 'w> {
    /// A surface with a single texture.
    Surface { hit: &'s Hit, surface: &'s Surface, texture: TextureId, space: &'s TextureSpace<'w> },
    /// The sky.
    Sky,
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
        let Some(raw) = raw else { return self.part(before, nothing(), others, found) };
        let path = self.camera_path(raw.finish(&world.camera), f64::INFINITY);
        let Some(hit) = world.geometry.intersect(&path.ray, path.range, path.kind, &mut self.scratch) else {
            if self.sky_side_by_side && before.is_none_or(|before| matches!(before.met, Met::Sky)) {
                let sight = Sight { before, position: *position, path: &path, met: Met::Sky };
                return self.follow_all(others, Some(&sight), found);
            }
            self.start_at(x, y);
            let light = self.seen(&path, None, None);
            return self.part(before, light, others, found);
        };
        let surface = world.geometry.surface(&path.ray, &hit);
        let only = match &*surface.textures {
            [only] => Some(only).filter(|only| world.texture(only.texture).is_side_by_side()),
            _ => None,
        };
        let Some(only) = only.filter(|only| before.is_none_or(|before| before.shows(only.texture))) else {
            self.start_at(x, y);
            let light = self.seen(&path, Some((&hit, &surface)), None);
            return self.part(before, light, others, found);
        };
        let space = texture_space(world, &surface, &hit, only);
        let met = Met::Surface { hit: &hit, surface: &surface, texture: only.texture, space: &space };
        self.follow_all(others, Some(&Sight { before, position: *position, path: &path, met }), found);
    }

    /// Goes on one by one from a ray that has nothing in common with those before, and brought back some light.
    fn part<G: Gather>(&mut self, before: Option<&Sight<'_, 'w>>, light: G, others: &[[f64; 2]], found: &mut Vec<G>) {
        self.shade_each(before, found);
        found.push(light);
        self.follow_each(others, found);
    }

    /// Adds the light through image positions, one by one.
    fn follow_each<G: Gather>(&mut self, positions: &[[f64; 2]], found: &mut Vec<G>) {
        positions.iter().for_each(|[x, y]| found.push(self.camera_ray(*x, *y)));
    }

    /// Adds the light of fewer than four sights, or of such as have nothing in common.
    fn shade_each<G: Gather>(&mut self, last: Option<&Sight<'_, 'w>>, found: &mut Vec<G>) {
        if let Some(last) = last {
            self.shade_each(last.before, found);
            found.push(self.shade_sight(last, None));
        }
    }

    /// The light of a sight.
    fn shade_sight<G: Gather>(&mut self, sight: &Sight<'_, 'w>, neighbour: Option<Neighbour<'_>>) -> G {
        let [x, y] = sight.position;
        self.start_at(x, y);
        match sight.met {
            Met::Surface { hit, surface, space, .. } => {
                self.seen(sight.path, Some((hit, surface)), Some(Only { space, neighbour }))
            }
            Met::Sky => self.seen(sight.path, None, None),
        }
    }

    /// Adds the light of four sights of one texture or of the sky.
    fn shade_four<G: Gather>(&mut self, last: Option<&Sight<'_, 'w>>, found: &mut Vec<G>) {
        let [Some(d), Some(c), Some(b), Some(a)] = before(last) else { return self.shade_each(last, found) };
        let four = [a, b, c, d];
        let Met::Surface { texture, .. } = a.met else { return self.shade_skies(four, found) };
        let Texture::Layers(layers) = self.world.texture(texture) else { return self.shade_each(last, found) };
        let place = |i: usize| match four[i].met {
            Met::Surface { surface, space, .. } => (space.point, surface.uv),
            Met::Sky => Default::default(),
        };
        let places = each_lane(place);
        let all = Neighbours {
            layers,
            points: each_lane(|i| places[i].0).into(),
            uvs: each_lane(|i| places[i].1),
            colors: layers.iter().map(|_| OnceCell::new()).collect(),
        };
        for (lane, sight) in four.into_iter().enumerate() {
            found.push(self.shade_sight(sight, Some(Neighbour { all: &all, lane })));
        }
    }

    /// Adds the light of four sights of the sky.
    fn shade_skies<G: Gather>(&mut self, four: [&Sight<'_, 'w>; LANES], found: &mut Vec<G>) {
        let Some(sky) = &self.world.atmosphere.sky else { return };
        let points = Points::from(each_lane(|i| sky.sky_from_world.point(four[i].path.ray.direction)));
        let uvs = [Uv::default(); LANES];
        let colors: SmallVec<[_; 2]> = sky.pigments.iter().rev().map(|p| p.colors(&points, &uvs)).collect();
        for (lane, Sight { position: [x, y], path, .. }) in four.into_iter().enumerate() {
            self.start_at(*x, *y);
            let light = self.sky_of(sky, path, colors.iter().map(|lanes| lanes[lane]));
            found.push(self.seen_sky(path, light));
        }
    }
}

impl Sight<'_, '_> {
    /// Whether a texture is the only one that shows.
    fn shows(&self, texture: TextureId) -> bool {
        matches!(self.met, Met::Surface { texture: own, .. } if own == texture)
    }
}

/// Four sights, the last one first.
fn before<'s, 'w>(last: Option<&'s Sight<'s, 'w>>) -> [Option<&'s Sight<'s, 'w>>; LANES] {
    let next = |sight: Option<&'s Sight<'s, 'w>>| sight.and_then(|sight| sight.before);
    let (second, third) = (next(last), next(next(last)));
    [last, second, third, next(third)]
}
