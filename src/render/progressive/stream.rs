//! Image positions of a pixel's samples: points that fill the pixel evenly however many are taken.
//!
//! Each stream is a Sobol (0,2)-sequence, scrambled as Owen proposed, with a seed of its own: any two are independent,
//! so what two streams of one pixel differ by tells how far their mean is from the truth. (The error of a sequence that
//! is not randomised cannot be estimated from itself.)
//!
//! Source: A. B. Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995; B. Burley, "Practical Hash-based Owen
//! Scrambling", JCGT 9 (4), 2020, with N. Vegdahl's constants for the mixing.

use crate::render::random::mixed as hashed;

/// Which of a pixel's independent streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Half of the samples that make the pixel: 0 or 1.
    Picture(u8),
    /// Half of those that check it: 0 or 1.
    Audit(u8),
}

/// A randomised sequence of points in the unit square, and of others beside them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stream {
    /// Of the pixel whose samples these are.
    x: f64,
    y: f64,
    seed: u64,
}

impl Stream {
    /// A stream of the pixel in column `x` of row `y`; pictures of different seeds have nothing in common.
    pub(super) fn new(seed: u64, x: usize, y: usize, purpose: Purpose) -> Self {
        let number = match purpose {
            Purpose::Picture(half) => u64::from(half),
            Purpose::Audit(half) => 2 + u64::from(half),
        };
        Self { x: x as f64, y: y as f64, seed: hashed(hashed(seed) ^ (x as u64) << 34 ^ (y as u64) << 4 ^ number) }
    }

    /// Image position number `i`, within half a pixel of the pixel's centre.
    pub(super) fn position(self, i: u32) -> [f64; 2] {
        let [u, v] = self.point(i);
        [self.x + u - 0.5, self.y + v - 0.5]
    }

    fn point(self, i: u32) -> [f64; 2] {
        net(i, self.seed)
    }

    /// Another point beside it, which is spread as evenly: a place on the lens.
    pub(super) fn second_point(self, i: u32) -> [f64; 2] {
        let seed = hashed(self.seed);
        // The order of the points is another, so that a sample's two have nothing to do with one another.
        net(scrambled(i, seed as u32), hashed(seed))
    }
}

/// Whether a pixel is among those that are audited: one in [`AUDITED`].
pub(super) fn is_audited(x: usize, y: usize) -> bool {
    hashed(hashed(x as u64) ^ y as u64).is_multiple_of(AUDITED)
}

/// One pixel in so many is sampled once more to check the rest.
const AUDITED: u64 = 16;

/// Point `i` of the scrambled (0,2)-sequence of a seed.
fn net(i: u32, seed: u64) -> [f64; 2] {
    let unit = |bits: u32| (f64::from(bits) + 0.5) / 4_294_967_296.0;
    // The first coordinate is the index with its bits mirrored, and scrambling starts by mirroring them.
    let first = mixed(i, seed as u32).reverse_bits();
    [unit(first), unit(scrambled(sobol(i), (seed >> 32) as u32))]
}

/// The second coordinate of Sobol's sequence.
fn sobol(mut i: u32) -> u32 {
    let (mut bits, mut direction) = (0, 1u32 << 31);
    while i > 0 {
        if i & 1 == 1 {
            bits ^= direction;
        }
        i >>= 1;
        direction ^= direction >> 1;
    }
    bits
}

/// Exchanges halves, quarters, eighths … of 0..1, each by a throw of its own.
fn scrambled(bits: u32, seed: u32) -> u32 {
    mixed(bits.reverse_bits(), seed).reverse_bits()
}

/// A permutation in which a bit depends on lower ones alone.
fn mixed(mut bits: u32, seed: u32) -> u32 {
    bits ^= bits.wrapping_mul(0x3d20_adea);
    bits = bits.wrapping_add(seed);
    bits = bits.wrapping_mul((seed >> 16) | 1);
    bits ^= bits.wrapping_mul(0x0552_6c56);
    bits ^ bits.wrapping_mul(0x53a2_2864)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every box of area 1/n holds one of the first n points, n a power of two: what makes a (0,2)-sequence.
    fn check(points: impl Fn(u32) -> [f64; 2]) {
        for log in 0..=8 {
            for columns in (0..=log).map(|k| 1u32 << k) {
                let (n, rows) = (1u32 << log, (1u32 << log) / columns);
                let mut found = vec![0; n as usize];
                for [x, y] in (0..n).map(&points) {
                    found[((x * f64::from(columns)) as u32 * rows + (y * f64::from(rows)) as u32) as usize] += 1;
                }
                assert!(found.iter().all(|count| *count == 1), "{n} points in {columns} columns");
            }
        }
    }

    #[test]
    fn points_are_spread_over_all_boxes() {
        for half in 0..2 {
            let stream = Stream::new(3, 17, 4, Purpose::Picture(half));
            check(|i| stream.point(i));
            check(|i| stream.second_point(i));
        }
    }

    #[test]
    fn streams_are_independent() {
        // Correlations of first points over many pixels: their standard deviation is 1/sqrt(n).
        let n = 10_000;
        let centred = |x, purpose| Stream::new(0, x, 7, purpose).point(0)[0] - 0.5;
        let [a, b, c] = [Purpose::Picture(0), Purpose::Picture(1), Purpose::Audit(0)];
        for (p, q, shift) in [(a, b, 0), (a, c, 0), (a, a, 1), (b, c, 0)] {
            let sum: f64 = (0..n).map(|x| 12.0 * centred(x, p) * centred(x + shift, q)).sum();
            assert!((sum / n as f64).abs() < 0.04, "{p:?} {q:?} {sum}");
        }
    }

    #[test]
    fn one_pixel_in_sixteen_is_audited() {
        let n = (0..200).flat_map(|y| (0..200).map(move |x| is_audited(x, y))).filter(|audited| *audited).count();
        assert!((2300..2700).contains(&n), "{n}");
    }
}
