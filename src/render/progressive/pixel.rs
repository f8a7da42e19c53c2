//! What is known of a pixel: sums over two independent streams of samples.

use crate::compiled::Transfer;
use crate::math::Rgb;
use crate::render::film::Gather;

/// Sums over the samples of a pixel.
#[derive(Clone, Debug, Default)]
pub(super) struct Pixel<G> {
    /// Samples in each of the two streams.
    n: u32,
    sums: [G; 2],
    /// Sum of the squared distances of all samples from their mean: of working values, mean over the channels.
    spread: f32,
}

impl<G: Gather> Pixel<G> {
    /// Samples in each of the two streams.
    pub(super) fn n(&self) -> u32 {
        self.n
    }

    /// The mean of all samples.
    pub(super) fn mean(&self) -> G {
        let mut sum = self.sums[0].clone();
        sum.add_scaled(&self.sums[1], 1.0);
        sum.scaled(0.5 / self.n.max(1) as f32)
    }

    /// The mean of all samples, in working values.
    pub(super) fn working(&self) -> Rgb {
        self.total() / (2 * self.n.max(1)) as f32
    }

    /// Linear light of the pixel.
    pub(super) fn light(&self, transfer: Transfer) -> Rgb {
        linear(transfer, self.working())
    }

    /// Linear light of each stream by itself.
    pub(super) fn halves(&self, transfer: Transfer) -> [Rgb; 2] {
        [0, 1].map(|half| linear(transfer, self.sums[half].light().rgb / self.n.max(1) as f32))
    }

    /// Variance of a single sample, in working values, with its degrees of freedom.
    pub(super) fn variance(&self) -> (f32, f32) {
        let freedom = (2 * self.n.max(1) - 1) as f32;
        (self.spread / freedom, freedom)
    }

    /// Adds as many samples of the one stream as of the other.
    pub(super) fn extend(&mut self, first: &[G], second: &[G]) {
        debug_assert_eq!(first.len(), second.len());
        let mut n = 2 * self.n;
        for (half, samples) in [first, second].into_iter().enumerate() {
            for sample in samples {
                if n > 0 {
                    // Welford's update keeps its digits where samples hardly differ.
                    let distance = sample.light().rgb - self.total() / n as f32;
                    self.spread += distance.dot(distance) / 3.0 * (n as f32 / (n + 1) as f32);
                }
                self.sums[half].add_scaled(sample, 1.0);
                n += 1;
            }
        }
        self.n += first.len() as u32;
    }

    fn total(&self) -> Rgb {
        self.sums[0].light().rgb + self.sums[1].light().rgb
    }
}

/// Linear light of working values.
pub(super) fn linear(transfer: Transfer, rgb: Rgb) -> Rgb {
    Rgb::new(transfer.linear(rgb.x), transfer.linear(rgb.y), transfer.linear(rgb.z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::radiance::Radiance;

    fn samples(values: &[f32]) -> Vec<Radiance> {
        values.iter().map(|v| Radiance::opaque(Rgb::splat(*v))).collect()
    }

    #[test]
    fn sums_say_mean_halves_and_variance() {
        let mut pixel = Pixel::<Radiance>::default();
        pixel.extend(&samples(&[1.0]), &samples(&[2.0]));
        pixel.extend(&samples(&[3.0, 2.0]), &samples(&[6.0, 4.0]));
        assert_eq!((pixel.n(), pixel.light(Transfer::Linear)), (3, Rgb::splat(3.0)));
        assert_eq!(pixel.halves(Transfer::Linear), [Rgb::splat(2.0), Rgb::splat(4.0)]);
        // Distances -2, -1, 0, -1, 3, 1 from the mean.
        let (variance, freedom) = pixel.variance();
        assert!((variance - 16.0 / 5.0).abs() < 1e-6 && freedom == 5.0, "{variance} {freedom}");
    }
}
