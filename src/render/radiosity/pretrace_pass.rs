//! Which rays of the camera look for places before the picture is made.
//!
//! Source: radiosity facts, section 6 (measured).

use crate::compiled::radiosity::Radiosity;
use crate::render::film::Block;
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
    /// Image positions of the rays through a block, the number of which counts in the whole picture.
    pub(in crate::render) fn positions(&self, block: &Block, number: usize) -> Vec<[f64; 2]> {
        let step = self.step;
        let amount = (0.5 * step).min(1.0);
        let mut jitter = Jitter::of(self.number, number);
        let multiples = |from: usize, n: usize| {
            let first = (from as f64 / step).ceil() as usize;
            (first..).map(move |i| i as f64 * step).take_while(move |x| *x < (from + n) as f64)
        };
        let mut found = Vec::new();
        for y in multiples(block.y, block.height) {
            for x in multiples(block.x, block.width) {
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
///
/// Source: Matsumoto, Nishimura, "Mersenne Twister", ACM Transactions on Modeling and Computer Simulation 8 (1), 1998;
/// seed 5489 is that of their program.
fn numbers() -> Vec<f64> {
    const N: usize = 624;
    let mut state = vec![5489u32];
    for i in 1..N as u32 {
        let last = state[i as usize - 1];
        state.push(1_812_433_253_u32.wrapping_mul(last ^ (last >> 30)).wrapping_add(i));
    }
    // Each word follows from three before it, for ever.
    for i in N..N + PERIOD {
        let mixed = (state[i - N] & 0x8000_0000) | (state[i - N + 1] & 0x7fff_ffff);
        let twist = if mixed & 1 == 0 { 0 } else { 0x9908_b0df };
        state.push(state[i - N + 397] ^ (mixed >> 1) ^ twist);
    }
    let tempered = |mut y: u32| {
        y ^= y >> 11;
        y ^= (y << 7) & 0x9d2c_5680;
        y ^= (y << 15) & 0xefc6_0000;
        y ^ (y >> 18)
    };
    state[N..].iter().map(|y| 2.0 * f64::from(tempered(*y)) / 4_294_967_296.0 - 1.0).collect()
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
        let block = Block { x: 32, y: 0, width: 32, height: 10 };
        let found = pass.positions(&block, 1);
        assert_eq!(found.len(), 8 * 3);
        assert!(found.iter().all(|[x, y]| (32.0..66.0).contains(x) && (-0.5..14.0).contains(y)), "{found:?}");
    }
}
