//! POV-Ray's two ways of smoothing edges, a block of pixels at a time.
//!
//! Source: section 3 of the camera facts (measured, sample counts included).

use super::enough::{Compared, Contrast};
use super::film::{BLOCK, Block, Gather};
use super::jitter::jitter;
use super::options::{Antialias, Method, Options, Region};
use super::sensor::at_positions;
use super::worker::Worker;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

/// The samples that are taken in any case: a grid of image positions, one pixel apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Base<'o> {
    antialias: Option<&'o Antialias>,
    /// The first position.
    origin: [f64; 2],
    columns: usize,
    rows: usize,
}

impl<'o> Base<'o> {
    /// Pixel centres for a picture as it is, with those left and above that decide whether a pixel is refined; corners
    /// of pixels for [`Method::Adaptive`].
    pub(super) fn of(options: &'o Options) -> Self {
        let window = options.window();
        let antialias = options.antialias.as_ref();
        let (origin, end) = match antialias.map(|antialias| antialias.method) {
            None => ([window.left as f64, window.top as f64], [window.right, window.bottom]),
            Some(Method::Adaptive) => {
                ([window.left as f64 - 0.5, window.top as f64 - 0.5], [window.right + 1, window.bottom + 1])
            }
            Some(Method::Grid) => {
                let start = |from: usize| (from / BLOCK * BLOCK) as f64 - 1.0;
                let last = |to: usize, size: usize| end_of_decisions((to.max(1) - 1) / BLOCK * BLOCK, to, size);
                let end = [last(window.right, options.width), last(window.bottom, options.height)];
                ([start(window.left), start(window.top)], end)
            }
        };
        let count = |end: usize, origin: f64| (end as f64 - origin).max(0.0) as usize;
        Self { antialias, origin, columns: count(end[0], origin[0]), rows: count(end[1], origin[1]) }
    }

    /// The grid as a window of its own.
    pub(super) fn window(&self) -> Region {
        Region { left: 0, top: 0, right: self.columns, bottom: self.rows }
    }

    /// The image position of a place of the grid.
    pub(super) fn position(&self, column: usize, row: usize) -> [f64; 2] {
        [self.origin[0] + column as f64, self.origin[1] + row as f64]
    }

    /// How edges are smoothed, if these samples are not the picture.
    pub(super) fn antialias(&self) -> Option<&'o Antialias> {
        self.antialias
    }

    /// Samples of the grid and pixels that follow.
    pub(super) fn n_steps(&self, window: &Region) -> usize {
        self.columns * self.rows + self.antialias.map_or(0, |_| window.width() * window.height())
    }

    /// A part of the grid that starts at an image position, row by row.
    fn part<'s, G>(
        &self,
        samples: &'s [G],
        [x, y]: [f64; 2],
        columns: usize,
        rows: usize,
    ) -> impl Iterator<Item = &'s [G]> + use<'s, G> {
        let (left, top, stride) = ((x - self.origin[0]) as usize, (y - self.origin[1]) as usize, self.columns);
        (top..top + rows).map(move |row| &samples[row * stride + left..row * stride + left + columns])
    }
}

/// Where pixels end that can refine one before `to`, in a block that starts at `from`.
fn end_of_decisions(from: usize, to: usize, size: usize) -> usize {
    (to + 1).min(from + BLOCK).min(size)
}

impl Antialias {
    /// The pixels of a block, row by row, from the samples of the base grid.
    pub(super) fn block<G: Gather>(
        &self,
        worker: &mut Worker<'_>,
        base: &Base<'_>,
        samples: &[G],
        block: &Block,
    ) -> Vec<G> {
        match self.method {
            Method::Grid => self.grid_block(worker, base, samples, block),
            Method::Adaptive => self.adaptive_block(worker, base, samples, block),
        }
    }

    fn contrast(&self, worker: &Worker<'_>) -> Contrast {
        Contrast { threshold: self.threshold, exponent: self.exponent(), transfer: worker.world().settings.transfer }
    }

    /// Where a sample meant for a position is taken.
    fn displaced(&self, [x, y]: [f64; 2]) -> [f64; 2] {
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

    /// Pixels above and to the left decide whether one is refined, and so do its neighbours on the right and below.
    fn grid_block<G: Gather>(&self, worker: &mut Worker<'_>, base: &Base<'_>, samples: &[G], block: &Block) -> Vec<G> {
        let contrast = self.contrast(worker);
        let (left, top) = (block.x / BLOCK * BLOCK, block.y / BLOCK * BLOCK);
        let options = worker.options();
        let width = end_of_decisions(left, block.x + block.width, options.width) - left;
        let height = end_of_decisions(top, block.y + block.height, options.height) - top;
        // One column and one row more, for the helpers on the left and above; they are never refined.
        let (x, y) = (left as f64 - 1.0, top as f64 - 1.0);
        let stride = width + 1;
        let mut pixels = base.part(samples, [x, y], stride, height + 1).collect::<Vec<_>>().concat();
        let mut compared: Vec<Compared> = pixels.iter().map(|pixel| pixel.light().into()).collect();
        let mut refined: Vec<bool> = (0..pixels.len()).map(|at| at < stride || at % stride == 0).collect();
        let position = |at: usize| [x + (at % stride) as f64, y + (at / stride) as f64];
        for at in (stride..pixels.len()).filter(|at| at % stride != 0) {
            let neighbours = [at - 1, at - stride];
            let differs = neighbours.map(|other| contrast.differ(&compared[at], &compared[other]));
            let both = neighbours.into_iter().zip(differs).filter(|(_, differs)| *differs).map(|(other, _)| other);
            for at in both.chain((differs[0] || differs[1]).then_some(at)) {
                if !std::mem::replace(&mut refined[at], true) {
                    pixels[at] = self.refined(worker, std::mem::take(&mut pixels[at]), position(at));
                    compared[at] = pixels[at].light().into();
                }
            }
        }
        let inside = |start: usize, from: usize, n: usize| start - from + 1..start - from + 1 + n;
        let (rows, columns) = (inside(block.y, top, block.height), inside(block.x, left, block.width));
        rows.flat_map(|row| pixels[row * stride..][columns.clone()].to_vec()).collect()
    }

    /// A pixel's centre and a grid of samples around it.
    fn refined<G: Gather>(&self, worker: &mut Worker<'_>, center: G, [x, y]: [f64; 2]) -> G {
        let n = self.depth;
        let offset = |i: u32| -0.5 + 1.0 / f64::from(2 * n) + f64::from(i) / f64::from(n);
        let wanted: SmallVec<[[f64; 2]; 9]> =
            (0..n * n).map(|k| self.displaced([x + offset(k % n), y + offset(k / n)])).collect();
        // Of an odd grid without jitter the middle is the centre, which is known.
        let positions: SmallVec<[[f64; 2]; 9]> = wanted.iter().copied().filter(|at| *at != [x, y]).collect();
        let mut found = at_positions::<G>(worker, &positions).into_iter();
        let mut sum = center.clone();
        let mut traced = 1;
        for at in &wanted {
            if *at == [x, y] {
                sum.add_scaled(&center, 1.0);
            } else if let Some(sample) = found.next() {
                sum.add_scaled(&sample, 1.0);
                traced += 1;
            }
        }
        let mut mean = sum.scaled(1.0 / (n * n + 1) as f32);
        mean.count(traced);
        mean
    }

    fn adaptive_block<G: Gather>(
        &self,
        worker: &mut Worker<'_>,
        base: &Base<'_>,
        samples: &[G],
        block: &Block,
    ) -> Vec<G> {
        let Block { x: left, y: top, width, height } = *block;
        let corner = [left as f64 - 0.5, top as f64 - 0.5];
        let rows: Vec<&[G]> = base.part(samples, corner, width + 1, height + 1).collect();
        let mut pixels = Vec::with_capacity(width * height);
        let mut known = FxHashMap::default();
        for (j, two) in rows.windows(2).enumerate() {
            for i in 0..width {
                known.clear();
                let four = [&two[0][i], &two[0][i + 1], &two[1][i], &two[1][i + 1]].map(G::clone);
                let square =
                    Square { x: corner[0] + i as f64, y: corner[1] + j as f64, place: [0, 0], level: self.depth - 1 };
                let mut pixel = self.subdivide(worker, &square, &four, &mut known);
                pixel.recount(four.iter().chain(known.values()));
                pixels.push(pixel);
            }
        }
        pixels
    }

    /// Mean over a square of a pixel, from its corners (top left, top right, bottom left, bottom right).
    fn subdivide<G: Gather>(
        &self,
        worker: &mut Worker<'_>,
        square: &Square,
        corners: &[G; 4],
        known: &mut FxHashMap<[u32; 2], G>,
    ) -> G {
        let contrast = self.contrast(worker);
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        let compared = corners.each_ref().map(|corner| Compared::from(corner.light()));
        let differ = |(a, b): &(usize, usize)| contrast.differ(&compared[*a], &compared[*b]);
        if square.level == 0 || !pairs.iter().any(differ) {
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
        let positions: SmallVec<[[f64; 2]; 5]> = new.iter().map(|place| self.displaced(position(place))).collect();
        known.extend(new.iter().copied().zip(at_positions(worker, &positions)));
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
            mean.add_scaled(&self.subdivide(worker, &quarter, &corners, known), 0.25);
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
