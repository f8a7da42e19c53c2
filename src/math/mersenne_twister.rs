//! The random numbers behind POV-Ray's tables: MT19937.

const N: usize = 624;
const M: usize = 397;

/// The generator of Matsumoto and Nishimura (1998) with its standard seed, 5489.
#[derive(Clone, Debug)]
pub struct MersenneTwister {
    state: [u32; N],
    next: usize,
}

impl Default for MersenneTwister {
    fn default() -> Self {
        let mut state = [5489; N];
        for i in 1..N {
            let previous = state[i - 1];
            state[i] = 1_812_433_253_u32.wrapping_mul(previous ^ (previous >> 30)).wrapping_add(i as u32);
        }
        Self { state, next: N }
    }
}

impl MersenneTwister {
    /// The next 32 bits.
    pub fn next_u32(&mut self) -> u32 {
        if self.next == N {
            self.twist();
        }
        let mut y = self.state[self.next];
        self.next += 1;
        y ^= y >> 11;
        y ^= (y << 7) & 0x9d2c_5680;
        y ^= (y << 15) & 0xefc6_0000;
        y ^ (y >> 18)
    }

    /// The next number in 0..1.
    pub fn next_f64(&mut self) -> f64 {
        f64::from(self.next_u32()) / 4_294_967_296.0
    }

    fn twist(&mut self) {
        for i in 0..N {
            let y = (self.state[i] & 0x8000_0000) | (self.state[(i + 1) % N] & 0x7fff_ffff);
            let flip = if y & 1 == 0 { 0 } else { 0x9908_b0df };
            self.state[i] = self.state[(i + M) % N] ^ (y >> 1) ^ flip;
        }
        self.next = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_standard() {
        let mut random = MersenneTwister::default();
        assert_eq!(random.next_u32(), 3_499_211_612);
        // The ten thousandth number is what the C++ standard asks of this generator.
        let last = (0..9_999).map(|_| random.next_u32()).last();
        assert_eq!(last, Some(4_123_659_995));
    }
}
