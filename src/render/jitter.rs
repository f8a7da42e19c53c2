//! POV-Ray's deterministic displacements of samples.
//!
//! Source: section 3.3 of the camera facts (measured).

use std::sync::LazyLock;

/// A shuffle of 0..4096 by a linear congruential generator.
static SHUFFLE: LazyLock<Vec<u16>> = LazyLock::new(|| {
    let mut table: Vec<u16> = (0..4096).collect();
    let mut state = 0u32;
    for i in (0..4096).rev() {
        state = state.wrapping_mul(1_812_433_253).wrapping_add(12345);
        table.swap(i, ((state >> 16) & 0x7fff) as usize % 4096);
    }
    table
});

/// The table of the reflected CRC-16 (polynomial 0xA001), as numbers in -1/2..1/2 of six decimals.
static OFFSETS: LazyLock<Vec<f64>> = LazyLock::new(|| {
    (0..256u16)
        .map(|byte| {
            let crc = (0..8).fold(byte, |c, _| if c & 1 == 1 { (c >> 1) ^ 0xa001 } else { c >> 1 });
            let value = f64::from(crc % 32768) / 32768.0 - 0.5;
            f64::from(((value * 1e6).round() / 1e6) as f32)
        })
        .collect()
});

/// The shuffle at an index modulo 4096; negative indices count as two's complement.
pub(super) fn shuffled(index: i64) -> i64 {
    i64::from(SHUFFLE[(index & 4095) as usize])
}

/// Displacement in the unit square around 0 of a sample meant for a position.
pub(super) fn jitter(x: f64, y: f64) -> [f64; 2] {
    let number = |a: f64, b: f64| {
        let mixed = shuffled((a * x).trunc() as i64) ^ (b * y).trunc() as i64;
        OFFSETS[(shuffled(mixed & 4095) & 255) as usize]
    };
    [number(1021.0, 1019.0), number(1019.0, 1021.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn displacements_stay_in_the_unit_square_and_spread() {
        let mut sum = [0.0; 2];
        for i in 0..1000 {
            let [a, b] = jitter(f64::from(i) * 0.37 - 20.0, f64::from(i % 31) * 1.7 - 3.0);
            assert!(a.abs() <= 0.5 && b.abs() <= 0.5);
            sum = [sum[0] + a, sum[1] + b];
        }
        // A thousand uniform numbers have a mean of standard deviation 0.009.
        assert!(sum.iter().all(|s| (s / 1000.0).abs() < 0.05), "{sum:?}");
    }
}
