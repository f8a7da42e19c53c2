//! POV-Ray's two ways of smoothing edges, a block of pixels at a time.
//!
//! Source: section 3 of the camera facts (measured, sample counts included).

use super::blocks::Block;
use super::gather::Gather;
use super::jitter::jitter;
use super::ray::Radiance;
use super::tracer::Tracer;
use crate::math::Rgb;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

/// How edges are smoothed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Antialias {
    /// Which of the two ways.
    pub method: Method,
    /// Difference of neighbours from which a pixel is refined, 0 to 1.
    pub threshold: f64,
    /// Samples along an edge, or levels of subdivision; 1 to 9.
    pub depth: u32,
    /// Amount of jitter, 0 to 1.
    pub jitter: f64,
}

/// The two ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Method 1: pixels that differ from a neighbour get a grid of samples.
    Grid,
    /// Method 2: pixels whose corners differ are quartered, again and again.
    Adaptive,
}

/// Exponent of POV-Ray's `Antialias_Gamma`, in whose space colours are compared.
const COMPARE_GAMMA: f32 = 2.5;

impl Antialias {
    /// Where a sample meant for a position is taken.
    fn displaced(&self, x: f64, y: f64) -> [f64; 2] {
        if self.jitter == 0.0 {
            return [x, y];
        }
        let cells = match self.method {
            Method::Grid => f64::from(self.depth),
            Method::Adaptive => f64::from((1u32 << self.depth) + 1),
        };
        let [dx, dy] = jitter(x, y);
        [x + self.jitter / cells * dx, y + self.jitter / cells * dy]
    }

    /// Samples meant for some positions.
    fn samples<G: Gather>(&self, tracer: &mut Tracer<'_>, positions: impl Iterator<Item = [f64; 2]>) -> Vec<G> {
        let displaced: SmallVec<[[f64; 2]; 9]> = positions.map(|[x, y]| self.displaced(x, y)).collect();
        tracer.camera_rays(&displaced)
    }

    fn differ(&self, tracer: &Tracer<'_>, a: &Radiance, b: &Radiance) -> bool {
        let transfer = tracer.world.settings.transfer;
        let display = |v: f32| transfer.linear(v).max(0.0).powf(1.0 / COMPARE_GAMMA);
        let distance = |a: Rgb, b: Rgb| {
            (display(a.x) - display(b.x)).abs()
                + (display(a.y) - display(b.y)).abs()
                + (display(a.z) - display(b.z)).abs()
        };
        // Most neighbours agree exactly, and powers are dear.
        if a == b {
            return self.threshold <= 0.0;
        }
        f64::from(distance(a.rgb, b.rgb) + (a.transparency - b.transparency).abs()) >= self.threshold
    }

    /// Renders a block, row by row.
    pub(super) fn block<G: Gather>(&self, tracer: &mut Tracer<'_>, block: &Block) -> Vec<G> {
        match self.method {
            Method::Grid => self.grid_block(tracer, block),
            Method::Adaptive => self.adaptive_block(tracer, block),
        }
    }

    fn grid_block<G: Gather>(&self, tracer: &mut Tracer<'_>, block: &Block) -> Vec<G> {
        let Block { x: left, y: top, width, height } = *block;
        // One column and one row more, for the helpers on the left and above; they are never refined.
        let stride = width + 1;
        let mut pixels = vec![G::default(); stride * (height + 1)];
        let mut refined = vec![false; pixels.len()];
        (0..stride).for_each(|i| refined[i] = true);
        let (x, y) = (left as f64, top as f64);
        let above: Vec<_> = (0..width).map(|i| [x + i as f64, y - 1.0]).collect();
        pixels.splice(1..stride, tracer.camera_rays(&above));
        let beside: Vec<_> = (0..height).map(|j| [x - 1.0, y + j as f64]).collect();
        let inside = tracer.camera_grid(width, height, [x, y]);
        for ((row, first), others) in
            pixels.chunks_mut(stride).skip(1).zip(tracer.camera_rays(&beside)).zip(inside.chunks(width))
        {
            row[0] = first;
            row[1..].clone_from_slice(others);
        }
        for j in 1..=height {
            let y = (top + j) as f64 - 1.0;
            refined[j * stride] = true;
            for i in 1..stride {
                let x = (left + i) as f64 - 1.0;
                let at = j * stride + i;
                let neighbours = [(at - 1, x - 1.0, y), (at - stride, x, y - 1.0)];
                let differs =
                    neighbours.map(|(other, ..)| self.differ(tracer, &pixels[at].light(), &pixels[other].light()));
                for ((other, x, y), _) in neighbours.into_iter().zip(differs).filter(|(_, d)| *d) {
                    self.refine(tracer, &mut pixels[other], &mut refined[other], x, y);
                }
                if differs[0] || differs[1] {
                    self.refine(tracer, &mut pixels[at], &mut refined[at], x, y);
                }
            }
        }
        (1..=height).flat_map(|j| pixels[j * stride + 1..(j + 1) * stride].to_vec()).collect()
    }

    /// Adds a grid of samples to a pixel's centre, once.
    fn refine<G: Gather>(&self, tracer: &mut Tracer<'_>, pixel: &mut G, refined: &mut bool, x: f64, y: f64) {
        if std::mem::replace(refined, true) {
            return;
        }
        let n = self.depth;
        let offset = |i: u32| -0.5 + 1.0 / f64::from(2 * n) + f64::from(i) / f64::from(n);
        let mut sum = std::mem::take(pixel);
        let grid = (0..n * n).map(|k| [x + offset(k % n), y + offset(k / n)]);
        self.samples(tracer, grid).iter().for_each(|sample| sum.add_scaled(sample, 1.0));
        *pixel = sum.scaled(1.0 / (n * n + 1) as f32);
    }

    fn adaptive_block<G: Gather>(&self, tracer: &mut Tracer<'_>, block: &Block) -> Vec<G> {
        let Block { x: left, y: top, width, height } = *block;
        let stride = width + 1;
        let corners: Vec<G> = tracer.camera_grid(stride, height + 1, [left as f64 - 0.5, top as f64 - 0.5]);
        let mut pixels = Vec::with_capacity(width * height);
        let mut known = FxHashMap::default();
        for j in 0..height {
            for i in 0..width {
                known.clear();
                let at = j * stride + i;
                let four = [at, at + 1, at + stride, at + stride + 1].map(|i| corners[i].clone());
                let square = Square {
                    x: (left + i) as f64 - 0.5,
                    y: (top + j) as f64 - 0.5,
                    place: [0, 0],
                    level: self.depth - 1,
                };
                let mut pixel = self.subdivide(tracer, &square, &four, &mut known);
                pixel.recount(four.iter().chain(known.values()));
                pixels.push(pixel);
            }
        }
        pixels
    }

    /// Mean over a square of a pixel, from its corners (top left, top right, bottom left, bottom right).
    fn subdivide<G: Gather>(
        &self,
        tracer: &mut Tracer<'_>,
        square: &Square,
        corners: &[G; 4],
        known: &mut FxHashMap<[u32; 2], G>,
    ) -> G {
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        if square.level == 0
            || !pairs.iter().any(|(a, b)| self.differ(tracer, &corners[*a].light(), &corners[*b].light()))
        {
            let mut mean = G::default();
            corners.iter().for_each(|c| mean.add_scaled(c, 0.25));
            return mean;
        }
        let half = 1u32 << (square.level - 1);
        // The finest grid has 2^(depth - 1) cells along an edge.
        let cell = 1.0 / f64::from(1u32 << (self.depth - 1));
        let places = [[0, 1], [1, 0], [2, 1], [1, 2], [1, 1]]
            .map(|[dx, dy]: [u32; 2]| [square.place[0] + dx * half, square.place[1] + dy * half]);
        let new: SmallVec<[[u32; 2]; 5]> = places.into_iter().filter(|place| !known.contains_key(place)).collect();
        let position = |[i, j]: &[u32; 2]| [square.x + f64::from(*i) * cell, square.y + f64::from(*j) * cell];
        known.extend(new.iter().copied().zip(self.samples(tracer, new.iter().map(position))));
        let [left, top, right, bottom, middle] = places.map(|place| known[&place].clone());
        let quarters = [
            ([0, 0], [&corners[0], &top, &left, &middle]),
            ([1, 0], [&top, &corners[1], &middle, &right]),
            ([0, 1], [&left, &middle, &corners[2], &bottom]),
            ([1, 1], [&middle, &right, &bottom, &corners[3]]),
        ];
        let mut mean = G::default();
        for (shift, corners) in quarters {
            let corners = corners.map(G::clone);
            let place = [square.place[0] + shift[0] * half, square.place[1] + shift[1] * half];
            let quarter = Square { place, level: square.level - 1, ..*square };
            mean.add_scaled(&self.subdivide(tracer, &quarter, &corners, known), 0.25);
        }
        mean
    }
}

/// Part of a pixel.
#[derive(Clone, Copy)]
struct Square {
    /// Upper left corner of the pixel.
    x: f64,
    y: f64,
    /// Upper left corner of the part, in cells of the finest grid.
    place: [u32; 2],
    /// Halvings that are left.
    level: u32,
}
