//! Camera rays that are neighbours in the picture.
//!
//! Most neighbours meet the same texture, at points so near each other that patterns are evaluated for all of them at
//! once, one in each SIMD lane (`math::points`). Rays are sent and shaded one by one as ever; only the colours of
//! pigments come for four points together, when the first of them asks. No bit changes by it.

use super::camera::RawRay;
use super::gather::Gather;
use super::ray::Path;
use super::tracer::{Tracer, context_at, lookup, nothing};
use crate::compiled::geometry::{Hit, Surface, TextureId};
use crate::compiled::texture::{Context, Layer, Texture};
use crate::math::{Color, LANES, Points};
use smallvec::SmallVec;
use std::cell::OnceCell;

/// A camera ray and what it met.
struct Sight {
    path: Path,
    met: Option<(Hit, Surface)>,
}

/// Four points of one texture, and what colours its layers have there.
pub(super) struct Neighbours<'w> {
    layers: &'w [Layer],
    points: Points,
    contexts: [Context; LANES],
    /// By layer, as far as they have been asked for.
    colors: SmallVec<[OnceCell<[Option<Color>; LANES]>; 2]>,
}

/// One of four neighbours.
#[derive(Clone, Copy)]
pub(super) struct Neighbour<'p> {
    pub(super) all: &'p Neighbours<'p>,
    pub(super) lane: usize,
}

impl Neighbour<'_> {
    /// The colour of a layer, by its index, if it is one that is found for all four at once.
    pub(super) fn color(self, layer: usize) -> Option<Option<Color>> {
        let Neighbours { layers, points, contexts, colors } = self.all;
        let Layer { pigment, side_by_side: true, .. } = &layers[layer] else { return None };
        let colors = colors[layer].get_or_init(|| pigment.colors(points, contexts.each_ref()));
        Some(colors[self.lane])
    }
}

impl<'w> Tracer<'w> {
    /// The light through image positions.
    pub(super) fn camera_rays<G: Gather>(&mut self, positions: impl IntoIterator<Item = [f64; 2]>) -> Vec<G> {
        let mut positions = positions.into_iter();
        let mut found = Vec::with_capacity(positions.size_hint().0);
        loop {
            let some: SmallVec<[[f64; 2]; LANES]> = positions.by_ref().take(LANES).collect();
            match <[[f64; 2]; LANES]>::try_from(&*some) {
                Ok(four) if self.side_by_side => self.four_camera_rays(four, &mut found),
                _ if some.is_empty() => return found,
                _ => found.extend(some.iter().map(|[x, y]| self.camera_ray::<G>(*x, *y))),
            }
        }
    }

    fn four_camera_rays<G: Gather>(&mut self, positions: [[f64; 2]; LANES], found: &mut Vec<G>) {
        let sights = positions.map(|position| self.sight(position));
        let neighbours = self.neighbours(&sights);
        for (lane, (sight, [x, y])) in sights.iter().zip(positions).enumerate() {
            self.start_at(x, y);
            found.push(match sight {
                Some(Sight { path, met }) => {
                    let neighbour = neighbours.as_ref().map(|all| Neighbour { all, lane });
                    let met = met.as_ref().map(|(hit, surface)| (hit, surface));
                    self.seen(path, met, neighbour)
                }
                None => nothing(),
            });
        }
    }

    /// Sends the camera ray through an image position.
    fn sight(&mut self, [x, y]: [f64; 2]) -> Option<Sight> {
        let camera = &self.world.camera;
        let raw = RawRay::through(camera, x, y, self.options.width, self.options.height)?;
        let path = self.camera_path(raw.finish(camera), f64::INFINITY);
        let hit = self.world.geometry.intersect(&path.ray, path.range, path.kind, &mut self.scratch);
        let met = hit.map(|hit| (hit, self.world.geometry.surface(&path.ray, &hit)));
        Some(Sight { path, met })
    }

    /// What four hits have in common, if that is worth anything.
    fn neighbours(&self, sights: &[Option<Sight>; LANES]) -> Option<Neighbours<'w>> {
        let [a, b, c, d] = sights.each_ref().map(|sight| sight.as_ref()?.only_texture());
        if a.is_none() || b != a || c != a || d != a {
            return None;
        }
        let Texture::Layers(layers) = self.world.texture(a?) else { return None };
        if !layers.iter().any(|layer| layer.side_by_side) {
            return None;
        }
        let place = |sight: &Option<Sight>| {
            let Sight { path, met: Some((hit, surface)) } = sight.as_ref()? else { return None };
            let context = context_at(surface, path.ray.direction);
            let (point, _) = lookup(self.world, surface, &context, hit, surface.textures.first()?);
            Some((point, context))
        };
        let [Some(a), Some(b), Some(c), Some(d)] = sights.each_ref().map(place) else { return None };
        Some(Neighbours {
            layers,
            points: [a.0, b.0, c.0, d.0].into(),
            contexts: [a.1, b.1, c.1, d.1],
            colors: layers.iter().map(|_| OnceCell::new()).collect(),
        })
    }
}

impl Sight {
    /// The texture that shows, where it is no more than one.
    fn only_texture(&self) -> Option<TextureId> {
        match &*self.met.as_ref()?.1.textures {
            [only] => Some(only.texture),
            _ => None,
        }
    }
}
