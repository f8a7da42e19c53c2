//! Four doubles at a time: SIMD lanes where the processor has them, found at run time.
//!
//! Sums and products are never fused, so that the bits are the same on every processor.

use bytemuck::cast;
use pulp::{Scalar256b, Simd, f64x4, m64x4, u64x4};

/// Four doubles at once, as the processor has them.
pub(crate) trait Lanes: Simd<f64s = f64x4, u64s = u64x4, m64s = m64x4> {
    /// Rounds towards zero.
    fn truncate(self, v: f64x4) -> f64x4;

    /// The columns of four rows.
    fn columns(self, rows: [&[f64; 4]; 4]) -> [f64x4; 4];

    /// Whether all bits are zero.
    fn is_zero(self, v: u64x4) -> bool;
}

impl Lanes for Scalar256b {
    #[inline(always)]
    fn truncate(self, f64x4(a, b, c, d): f64x4) -> f64x4 {
        // From 2^52 on every number is whole. Calls of the C library are what this saves.
        let truncate = |v: f64| if v.abs() < (1_u64 << 52) as f64 { v as i64 as f64 } else { v };
        f64x4(truncate(a), truncate(b), truncate(c), truncate(d))
    }

    #[inline(always)]
    fn columns(self, [a, b, c, d]: [&[f64; 4]; 4]) -> [f64x4; 4] {
        let column = |i: usize| f64x4(a[i], b[i], c[i], d[i]);
        [column(0), column(1), column(2), column(3)]
    }

    #[inline(always)]
    fn is_zero(self, u64x4(a, b, c, d): u64x4) -> bool {
        a | b | c | d == 0
    }
}

#[cfg(target_arch = "x86_64")]
impl Lanes for pulp::x86::V3 {
    #[inline(always)]
    fn truncate(self, v: f64x4) -> f64x4 {
        self.truncate_f64x4(v)
    }

    #[inline(always)]
    fn columns(self, [a, b, c, d]: [&[f64; 4]; 4]) -> [f64x4; 4] {
        let [even, odd] = [halves::<0>(self, a, c), halves::<0>(self, b, d)];
        let [even_2, odd_2] = [halves::<2>(self, a, c), halves::<2>(self, b, d)];
        [
            cast(self.avx._mm256_unpacklo_pd(even, odd)),
            cast(self.avx._mm256_unpackhi_pd(even, odd)),
            cast(self.avx._mm256_unpacklo_pd(even_2, odd_2)),
            cast(self.avx._mm256_unpackhi_pd(even_2, odd_2)),
        ]
    }

    #[inline(always)]
    fn is_zero(self, v: u64x4) -> bool {
        self.avx._mm256_testz_si256(cast(v), cast(v)) == 1
    }
}

/// Entries `I` and `I + 1` of two rows.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn halves<const I: usize>(simd: pulp::x86::V3, low: &[f64; 4], high: &[f64; 4]) -> std::arch::x86_64::__m256d {
    let low = simd.avx._mm256_castpd128_pd256(cast([low[I], low[I + 1]]));
    simd.avx._mm256_insertf128_pd::<1>(low, cast([high[I], high[I + 1]]))
}

/// Work on lanes, whatever they are.
pub(crate) trait Work {
    /// What comes of it.
    type Output;

    /// Does it; to be inlined always, as everything that it calls: closures and iterators would not be compiled for the
    /// processor at hand.
    fn run<S: Lanes>(self, simd: S) -> Self::Output;
}

/// Does the work with AVX2 where the processor has it.
pub(crate) fn dispatch<W: Work>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return simd.vectorize(
            #[inline(always)]
            || work.run(simd),
        );
    }
    work.run(Scalar256b)
}
