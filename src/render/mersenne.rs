//! The Mersenne twister, for the one place where POV-Ray's own random numbers decide what a picture shows.
//!
//! Source: Matsumoto, Nishimura, "Mersenne Twister", ACM TOMACS 8 (1998); seeded as in their 2002 revision.

/// Words of state.
const N: usize = 624;
/// Distance of the words that are mixed.
const M: usize = 397;

/// MT19937 with seed 5489.
pub(super) struct MersenneTwister {
    state: Vec<u32>,
    next: usize,
}

impl MersenneTwister {
    pub(super) fn new() -> Self {
        let mut state = vec![5489u32];
        for i in 1..N as u32 {
            let last = state[i as usize - 1];
            state.push((last ^ (last >> 30)).wrapping_mul(1_812_433_253).wrapping_add(i));
        }
        Self { state, next: N }
    }

    fn twist(&mut self) {
        for i in 0..N {
            let joined = (self.state[i] & 0x8000_0000) | (self.state[(i + 1) % N] & 0x7fff_ffff);
            let odd = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            self.state[i] = self.state[(i + M) % N] ^ (joined >> 1) ^ odd;
        }
        self.next = 0;
    }

    /// The next number, all 32 bits even.
    pub(super) fn next(&mut self) -> u32 {
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

    /// The next number in 0..1, as POV-Ray divides it.
    pub(super) fn unit(&mut self) -> f64 {
        f64::from(self.next()) / 4_294_967_296.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(skip: usize, expected: u32) {
        let mut twister = MersenneTwister::new();
        (0..skip).for_each(|_| {
            twister.next();
        });
        assert_eq!(twister.next(), expected);
    }

    #[test]
    fn numbers_are_the_published_ones() {
        check(0, 3_499_211_612);
        // The C++ standard requires this one of `std::mt19937`.
        check(9_999, 4_123_659_995);
    }
}
