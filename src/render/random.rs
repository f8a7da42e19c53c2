//! Random numbers that belong to a camera ray, not to a thread.

/// A stream of numbers that starts anew for each camera ray.
///
/// Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators" (SplitMix64),
/// OOPSLA 2014.
#[derive(Clone, Debug, Default)]
pub(super) struct Random {
    state: u64,
}

impl Random {
    /// The stream of the ray through an image position.
    pub(super) fn at(x: f64, y: f64) -> Self {
        let mut stream = Self { state: x.to_bits() };
        let mixed = stream.next();
        Self { state: mixed ^ y.to_bits().rotate_left(32) }
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in 0..1, 53 bits.
    pub(super) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_even_and_repeat_for_the_same_ray() {
        let mut stream = Random::at(3.0, 4.5);
        let numbers: Vec<f64> = (0..10_000).map(|_| stream.unit()).collect();
        let mean = numbers.iter().sum::<f64>() / 10_000.0;
        // Standard deviation of this mean is 0.003.
        assert!((mean - 0.5).abs() < 0.015, "{mean}");
        assert_eq!(Random::at(3.0, 4.5).unit(), numbers[0]);
        assert_ne!(Random::at(4.5, 3.0).unit(), numbers[0]);
    }
}
