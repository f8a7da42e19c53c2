//! The points of all cubes that touch one, kept for the next points that are asked about.
//!
//! Points that follow each other mostly lie in the same cube or beside it. So each thread keeps the points around
//! some cubes, and measures all their distances at once in SIMD lanes, which takes less time than choosing. What is
//! kept depends on the cube alone: it changes how soon an answer comes and no bit of it.

use super::{NEIGHBOURS, Nearest, RANDOM, TOUCHING};
use crate::math::DVec3;
use crate::math::lanes::{Lanes, Work, dispatch};
use crate::math::noise::lattice_hash;
use bytemuck::{cast, cast_ref};
use pulp::f64x4;
use std::cell::RefCell;

/// Lanes for all points and one place that stays empty.
const GROUPS: usize = TOUCHING.div_ceil(4);

/// Cubes kept along an axis: a block of cubes finds room without any of them taking another's place.
const BLOCK: usize = 4;

thread_local! {
    static KNOWN: RefCell<Vec<Touching>> = const { RefCell::new(Vec::new()) };
}

/// Points around a cube, by axis, in the order of [`NEIGHBOURS`].
#[derive(Clone)]
struct Touching {
    corner: DVec3,
    coordinates: [[f64x4; GROUPS]; 3],
}

/// What a coordinate's difference adds to the power of a distance.
#[derive(Clone, Copy)]
pub(super) enum Share {
    Absolute,
    Square,
}

impl Share {
    #[inline(always)]
    fn of<S: Lanes>(self, simd: S, d: f64x4) -> f64x4 {
        match self {
            Self::Absolute => simd.abs_f64s(d),
            Self::Square => simd.mul_f64s(d, d),
        }
    }
}

/// The nearest of the points in the cubes that touch the one at `corner`, which holds `p`; where it is if `with_point`.
pub(super) fn nearest(p: DVec3, corner: DVec3, share: Share, with_point: bool) -> Nearest {
    KNOWN.with_borrow_mut(|known| {
        if known.is_empty() {
            // No corner equals what is not a number.
            let unknown = Touching { corner: DVec3::NAN, coordinates: [[f64x4(0.0, 0.0, 0.0, 0.0); GROUPS]; 3] };
            known.resize(BLOCK.pow(3), unknown);
        }
        let [i, j, k] = corner.to_array().map(|c| c as i64 as usize % BLOCK);
        let around = &mut known[(i * BLOCK + j) * BLOCK + k];
        if around.corner != corner {
            *around = Touching::new(corner);
        }
        dispatch(Search { around, p, share, with_point })
    })
}

impl Touching {
    fn new(corner: DVec3) -> Self {
        let mut coordinates = [[f64::INFINITY; 4 * GROUPS]; 3];
        for (i, offset) in NEIGHBOURS[..TOUCHING].iter().enumerate() {
            let cube = corner + DVec3::from(offset.map(|o| f64::from(o) - 2.0));
            let [x, y, z] = cube.to_array().map(|c| c as i64);
            let hash = lattice_hash(x, y, z);
            for axis in 0..3 {
                coordinates[axis][i] = cube[axis] + RANDOM[hash + axis];
            }
        }
        Self { corner, coordinates: coordinates.map(cast) }
    }
}

/// A search among the points around a cube.
struct Search<'t> {
    around: &'t Touching,
    p: DVec3,
    share: Share,
    with_point: bool,
}

impl Work for Search<'_> {
    type Output = Nearest;

    #[inline(always)]
    fn run<S: Lanes>(self, simd: S) -> Nearest {
        let Self { around, p, share, with_point } = self;
        let (px, py, pz) = (simd.splat_f64s(p.x), simd.splat_f64s(p.y), simd.splat_f64s(p.z));
        let [xs, ys, zs] = &around.coordinates;
        let mut all = [simd.splat_f64s(0.0); GROUPS];
        let mut smallest = [simd.splat_f64s(f64::INFINITY); 3];
        for (i, powers) in all.iter_mut().enumerate() {
            let x = share.of(simd, simd.sub_f64s(xs[i], px));
            let y = share.of(simd, simd.sub_f64s(ys[i], py));
            let z = share.of(simd, simd.sub_f64s(zs[i], pz));
            *powers = simd.add_f64s(simd.add_f64s(x, y), z);
            let [first, second, third] = smallest;
            let above_first = simd.max_f64s(first, *powers);
            let above_second = simd.max_f64s(second, above_first);
            smallest =
                [simd.min_f64s(first, *powers), simd.min_f64s(second, above_first), simd.min_f64s(third, above_second)];
        }
        let [first, second, third]: [[f64; 4]; 3] = cast(smallest);
        let powers = merged(
            merged([first[0], second[0], third[0]], [first[1], second[1], third[1]]),
            merged([first[2], second[2], third[2]], [first[3], second[3], third[3]]),
        );
        if !with_point {
            return Nearest { point: p, powers };
        }
        let all: &[f64; 4 * GROUPS] = cast_ref(&all);
        let mut index = 0;
        while index + 1 < TOUCHING && all[index] != powers[0] {
            index += 1;
        }
        let at = |column: &[f64; 4 * GROUPS]| column[index];
        let point = DVec3::new(at(cast_ref(xs)), at(cast_ref(ys)), at(cast_ref(zs)));
        Nearest { point, powers }
    }
}

/// The three smallest of two rising runs of three.
#[inline(always)]
fn merged([a1, a2, a3]: [f64; 3], [b1, b2, b3]: [f64; 3]) -> [f64; 3] {
    [a1.min(b1), a1.max(b1).min(a2.min(b2)), a1.max(b2).min(a2.max(b1)).min(a3.min(b3))]
}
