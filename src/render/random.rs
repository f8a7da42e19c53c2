//! Random numbers that belong to what they decide, not to the order in which decisions are made.
//!
//! A number is a pure function of the image position, the sample there, the way of the ray from the camera to the
//! vertex, and the [`Dimension`] of the decision. So any order of work, and any number of threads, gives the same bits.

use crate::math::DVec3;

/// Where random choices are made: a vertex on the way of one camera ray.
///
/// Source of the mixing function: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators" (SplitMix64),
/// OOPSLA 2014.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Random(u64);

/// What a number decides at a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) enum Dimension {
    /// `crand` of a finish under a light.
    Crand { light: usize },
    /// Where a sample of an area light lies in its cell, along one of the two axes.
    AreaLight { light: usize, cell: usize, axis: u8 },
    /// `jitter` of a rainbow.
    Rainbow(usize),
    /// Where directions of radiosity start.
    Direction,
    /// Where a sample of a medium lies, by its number along the ray.
    Medium(u32),
    /// By how much a lattice of directions or depths below a surface is shifted along one of its axes.
    Shift(u8),
    /// Whether a sample that counts for little is looked at.
    Roulette,
}

/// How a path goes on from a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) enum Branch {
    /// One of several camera rays through an image position.
    Sample(usize),
    /// An entry of a texture map, or a texture of several at one place.
    Texture(usize),
    /// A layer of a texture, uppermost first.
    Layer(usize),
    /// The mirror image in a layer.
    Reflection(usize),
    /// Through the surface; one of the bands of dispersed light.
    Transmission(u32),
    /// A ray that gathers light for radiosity, or a depth at which some do.
    Gathered(u32),
    /// To a sample in a medium, by its number along the ray.
    Medium(u32),
    /// One of the ways of light below a surface, or a sample of it.
    Below(u32),
}

impl Random {
    /// The choices of the ray through an image position.
    pub(super) fn at(x: f64, y: f64) -> Self {
        // Positions have few digits, which stand in the upper halves of the bits.
        Self(mixed(x.to_bits() ^ y.to_bits().rotate_left(32)))
    }

    /// The choices in one of several textures at a place; most places have one, which costs nothing.
    pub(super) fn texture(self, index: usize) -> Self {
        if index == 0 { self } else { self.branch(Branch::Texture(index)) }
    }

    /// The choices farther down a path.
    #[must_use]
    pub(super) fn branch(self, branch: Branch) -> Self {
        let (kind, index) = match branch {
            Branch::Sample(i) => (1, i as u64),
            Branch::Texture(i) => (2, i as u64),
            Branch::Layer(i) => (3, i as u64),
            Branch::Reflection(i) => (4, i as u64),
            Branch::Transmission(i) => (5, i.into()),
            Branch::Gathered(i) => (6, i.into()),
            Branch::Medium(i) => (8, i.into()),
            Branch::Below(i) => (9, i.into()),
        };
        Self(mixed(self.0 ^ (kind << 56 | index)))
    }

    /// The choices along a straight way in a direction.
    #[must_use]
    pub(super) fn toward(self, direction: DVec3) -> Self {
        let [x, y, z] = direction.to_array().map(f64::to_bits);
        Self(mixed(self.0 ^ mixed(x ^ y.rotate_left(21) ^ z.rotate_left(42))))
    }

    /// Uniform in 0..1, 53 bits.
    pub(super) fn unit(self, dimension: Dimension) -> f64 {
        let code = match dimension {
            Dimension::Crand { light } => 1 << 60 | light as u64,
            Dimension::AreaLight { light, cell, axis } => {
                (2 + u64::from(axis)) << 60 | (light as u64 & 0x0fff_ffff) << 32 | cell as u64
            }
            Dimension::Rainbow(i) => 4 << 60 | i as u64,
            Dimension::Direction => 5 << 60,
            Dimension::Medium(i) => 6 << 60 | u64::from(i),
            Dimension::Shift(axis) => 7 << 60 | u64::from(axis),
            Dimension::Roulette => 8 << 60,
        };
        (mixed(self.0 ^ mixed(code)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A number that has nothing visible in common with its seed.
pub(super) fn mixed(seed: u64) -> u64 {
    let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of one kind are uniform: their mean and their mean square are those of 0..1.
    fn check(numbers: impl Fn(usize) -> f64) {
        let n = 10_000;
        let mean = (0..n).map(&numbers).sum::<f64>() / n as f64;
        let square = (0..n).map(|i| numbers(i).powi(2)).sum::<f64>() / n as f64;
        // Standard deviations of these are 0.003.
        assert!((mean - 0.5).abs() < 0.015 && (square - 1.0 / 3.0).abs() < 0.015, "{mean} {square}");
    }

    #[test]
    fn numbers_are_even_in_every_argument() {
        let start = Random::at(3.0, 4.5);
        let crand = |random: Random| random.unit(Dimension::Crand { light: 0 });
        check(|i| crand(Random::at(i as f64, 4.5)));
        check(|i| crand(Random::at(3.0, i as f64)));
        check(|i| crand(start.branch(Branch::Sample(i))));
        check(|i| crand(start.branch(Branch::Reflection(i))));
        check(|i| start.unit(Dimension::Crand { light: i }));
        check(|i| start.unit(Dimension::AreaLight { light: i / 100, cell: i % 100, axis: 1 }));
    }

    #[test]
    fn a_number_depends_on_nothing_but_its_arguments() {
        let number = |x: f64, y: f64| Random::at(x, y).branch(Branch::Layer(1)).unit(Dimension::Rainbow(2));
        assert_eq!(number(1.0, 2.0), number(1.0, 2.0));
        assert_ne!(number(1.0, 2.0), number(2.0, 1.0));
    }
}
