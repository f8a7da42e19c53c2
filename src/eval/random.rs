//! `seed` and `rand`.

/// Streams of random numbers, by the order of their creation.
///
/// Source: language facts, section 7; the numbers are POV-Ray's own.
#[derive(Debug, Default)]
pub(super) struct Streams(Vec<u32>);

impl Streams {
    /// A new stream; its number.
    pub(super) fn seed(&mut self, seed: f64) -> f64 {
        self.0.push(super::float_functions::int32(seed) as u32);
        (self.0.len() - 1) as f64
    }

    /// The next number of a stream, from 0 to 1 with both; `None` if there is no such stream.
    pub(super) fn next(&mut self, stream: f64) -> Option<f64> {
        // Negative and NaN become 0, so look at the sign first.
        let state = if stream > -1.0 { self.0.get_mut(stream as usize)? } else { return None };
        *state = state.wrapping_mul(1_812_433_253).wrapping_add(12345);
        Some(f64::from(*state) / f64::from(u32::MAX))
    }

    /// How many streams there are.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }
}
