//! Which rays of the camera look for places before the picture is made.
//!
//! Source: radiosity facts, section 6 (measured).

use crate::compiled::radiosity::Radiosity;
use crate::math::MersenneTwister;
use std::ops::Range;
use std::sync::LazyLock;

/// POV-Ray's share by which a whole number of halvings makes one pass less.
const WHOLE: f64 = 1e-10;

/// One look over the whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct PretracePass {
    /// Which, from 0.
    pub(in crate::render) number: usize,
    /// Pixels from ray to ray.
    pub(in crate::render) step: f64,
}

/// All passes over a picture of this size, each finer than the one before.
///
/// POV-Ray makes 251 of pictures of up to 3 pixels; here there is none.
pub(in crate::render) fn passes(radiosity: &Radiosity, width: usize, height: usize) -> Vec<PretracePass> {
    let size = width.max(height) as f64;
    let [start, end] = radiosity.pretrace.map(|share| share * size);
    let end = end.max(1.0);
    let n = ((start / end).log2() + 1.0 - WHOLE).floor() + 1.0;
    let pass = |number: usize| PretracePass { number, step: (start / (number as f64).exp2()).max(end) };
    (0..n.max(0.0) as usize).map(pass).collect()
}

impl PretracePass {
    /// Image positions of the rays through a block of pixels, the number of which counts in the whole picture.
    pub(in crate::render) fn positions(&self, [columns, rows]: [Range<usize>; 2], number: usize) -> Vec<[f64; 2]> {
        let step = self.step;
        let amount = (0.5 * step).min(1.0);
        let mut jitter = Jitter::of(self.number, number);
        let multiples = |within: &Range<usize>| {
            let (first, end) = ((within.start as f64 / step).ceil() as usize, within.end as f64);
            (first..).map(move |i| i as f64 * step).take_while(move |x| *x < end)
        };
        let mut found = Vec::new();
        for y in multiples(&rows) {
            for x in multiples(&columns) {
                let middle = 0.5 * (step - 1.0);
                let dy = amount * jitter.next();
                let dx = amount * jitter.next();
                found.push([x + middle + dx, y + middle + dy]);
            }
        }
        found
    }
}

/// Numbers from -1 to 1 that belong to a block and a pass.
struct Jitter(usize);

impl Jitter {
    fn of(pass: usize, block: usize) -> Self {
        Self(17 * (pass + 1) + 13 * block + 1)
    }

    fn next(&mut self) -> f64 {
        static NUMBERS: LazyLock<Vec<f64>> = LazyLock::new(numbers);
        let number = NUMBERS[self.0 % NUMBERS.len()];
        self.0 += 1;
        number
    }
}

/// How many numbers there are before they start again.
const PERIOD: usize = 2047;

/// POV-Ray's numbers: the first of the Mersenne twister.
fn numbers() -> Vec<f64> {
    let mut twister = MersenneTwister::default();
    (0..PERIOD).map(|_| 2.0 * twister.next_f64() - 1.0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_mersenne_twister() {
        let found: Vec<f64> = numbers()[..3].iter().map(|n| (0.5 * n + 0.5) * 1e6).map(f64::round).collect();
        assert_eq!(found, [814_724.0, 135_477.0, 905_792.0]);
    }

    #[test]
    fn passes_cover_each_block_once() {
        let pass = PretracePass { number: 0, step: 4.0 };
        let found = pass.positions([32..64, 0..10], 1);
        assert_eq!(found.len(), 8 * 3);
        assert!(found.iter().all(|[x, y]| (32.0..66.0).contains(x) && (-0.5..14.0).contains(y)), "{found:?}");
    }
}
