//! The built-in functions that `functions.inc` declares as `internal(N)`.
//!
//! Formulas and their probe values: section 6 of the function facts. Parameters after
//! x, y and z are `p[0]`, `p[1]`, …

mod fractal;
mod polynomial;
mod solid;

use super::enclosure::Enclosure;
use super::int32;
use super::interval::Interval;
use super::number::Number;
use crate::math::DVec3;
use crate::math::noise::{NoiseGenerator, noise};
use std::sync::{Arc, OnceLock};

/// An internal function by number.
#[derive(Clone, Debug)]
pub struct Internal {
    number: u32,
    /// The scene's noise, for `f_noise3d`.
    generator: NoiseGenerator,
    /// Spectrum of `f_ridged_mf`, made at the first call and kept, as in POV-Ray.
    spectrum: Arc<OnceLock<Vec<f64>>>,
}

/// How many parameters each function takes after x, y and z.
#[rustfmt::skip]
const N_EXTRA: [u8; 79] = [
    5, 5, 5, 5, 2, 2, 5, 4, 2, 1, // 0
    4, 1, 1, 1, 1, 6, 6, 3, 1, 4, // 10
    3, 6, 1, 1, 10, 7, 7, 1, 1, 6, // 20
    1, 3, 4, 3, 6, 1, 1, 4, 1, 6, // 30
    5, 1, 1, 1, 4, 1, 3, 0, 1, 1, // 40
    7, 5, 6, 1, 1, 1, 3, 0, 6, 6, // 50
    4, 1, 5, 4, 6, 1, 4, 7, 2, 0, // 60
    2, 3, 1, 1, 2, 6, 0, 0, 1, // 70
];

/// Most parameters that any function takes.
const MAX_EXTRA: usize = 10;

/// The point, or bounds of points, and the parameters of a call.
struct Call<N> {
    x: N,
    y: N,
    z: N,
    p: [f64; MAX_EXTRA],
}

impl Internal {
    /// The function with this number; `None` where POV-Ray has none.
    pub fn new(number: u32, generator: NoiseGenerator) -> Option<Self> {
        (number <= 78).then(|| Self { number, generator, spectrum: Arc::default() })
    }

    /// Which of them it is.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The noise that it was declared with.
    pub fn generator(&self) -> NoiseGenerator {
        self.generator
    }

    /// Tells what was declared once from the same function declared again: each declaration keeps numbers of its own.
    pub fn identity(&self) -> usize {
        Arc::as_ptr(&self.spectrum) as usize
    }

    /// How many parameters follow x, y and z.
    pub fn n_extra(&self) -> usize {
        N_EXTRA[self.number as usize].into()
    }

    /// The value; missing arguments count as 0.
    pub fn eval(&self, args: &[f64]) -> f64 {
        let at = |i: usize| args.get(i).copied().unwrap_or(0.0);
        let c = Call { x: at(0), y: at(1), z: at(2), p: std::array::from_fn(|i| at(i + 3)) };
        match self.number {
            18 => c.enneper(),
            27 | 28 => c.hexagon(self.number == 28),
            29 | 58 => c.fractal_noise(self.number),
            59 => c.ridged(&self.spectrum),
            76 => noise(self.generator, c.point()),
            77 => 0.0, // reserved
            78 => noise(noise_argument(c.p[0]), c.point()),
            number => c.formula(number),
        }
    }

    /// Bounds over arguments within bounds. Parameters after the point must be known.
    pub fn enclose(&self, args: &[Enclosure]) -> Enclosure {
        if matches!(self.number, 76 | 78) {
            return Enclosure { value: Interval::EITHER, slope: Interval::WHOLE };
        }
        let at = |i: usize| args.get(i).copied().unwrap_or(Enclosure::constant(0.0));
        let known = (0..self.n_extra()).all(|i| at(i + 3).value.single().is_some());
        if !known || !self.is_enclosable() {
            return Enclosure::WHOLE;
        }
        let p = std::array::from_fn(|i| at(i + 3).value.low);
        Call { x: at(0), y: at(1), z: at(2), p }.formula(self.number)
    }

    /// Whether its enclosures close in on its values: not for noise, and not for the few that are
    /// pieced together.
    pub fn is_enclosable(&self) -> bool {
        !matches!(self.number, 18 | 27 | 28 | 29 | 58 | 59 | 76..=78)
    }
}

/// The generator that a function's noise argument chooses; 0 is 1.
fn noise_argument(v: f64) -> NoiseGenerator {
    match int32(v) as i64 & 3 {
        2 => NoiseGenerator::Corrected,
        3 => NoiseGenerator::Perlin,
        _ => NoiseGenerator::Original,
    }
}

fn square(v: f64) -> f64 {
    v * v
}

impl<N: Number> Call<N> {
    /// Squared distance from the origin.
    fn q(&self) -> N {
        self.x.squared() + self.y.squared() + self.z.squared()
    }

    /// Squared distance from the y axis.
    fn s(&self) -> N {
        self.x.squared() + self.z.squared()
    }

    /// Every function that is one formula everywhere.
    fn formula(&self, number: u32) -> N {
        match number {
            0..=3 | 15 | 21 | 34 | 39 | 50 | 67 | 75 => self.plane_curve(number),
            4 | 5 | 8 | 11..=14 | 16 | 20 | 22 | 23 | 30 | 31 | 33 | 35..=38 | 41..=46 => self.clamped(number),
            48 | 49 | 54..=56 | 65 | 66 | 71..=74 => self.clamped(number),
            _ => self.distance(number),
        }
    }
}

impl Call<f64> {
    fn point(&self) -> DVec3 {
        DVec3::new(self.x, self.y, self.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(number: u32, args: &[f64]) -> f64 {
        Internal::new(number, NoiseGenerator::Corrected).expect("known number").eval(args)
    }

    /// The probe column of the facts' table: all at (0.3, 0.5, -0.7) with the same parameters.
    #[test]
    fn table_matches_the_binary() {
        let args = [0.3, 0.5, -0.7, 0.9, 0.7, 0.8, 0.6, 1.2, 0.4, 1.3, 0.5, 1.1, 0.3];
        #[rustfmt::skip]
        let expected = [
            0.2105192908, -0.02617080165, -0.1785155286, 0.01510096058, -0.58194, -0.43731, -0.019382272,
            -0.2178814531, -10.0, 0.4232124598, 0.1287391664, -0.41031, -0.5418, -1.89909, -0.2736, -0.03555810948,
            -0.715561209, 0.7134423593, 0.01763279453, -0.7955215458, 0.4122, -0.7350125399, -0.6612615, -0.0794925,
            -0.8795951663, 0.5615773106, -0.009606437723, 0.5830127019, 0.009807621135, 0.3384885448, 10.0, -0.7866,
            0.1417514476, -0.686736, -0.2632668351, -1.6324083, -0.26244, 0.018018, -0.59229, -0.189092499,
            0.2683281573, -0.21042, -1.6938, -1.89909, -0.838692, -0.072, -0.15651, 0.9898427726, -0.46737, 0.64899,
            -0.2186941105, -0.8384226894, 10000.0, 1.196960852, 0.22662, 0.6588, -0.18234, 0.9110433579,
            0.1329852301, 0.2005173528, 0.368856754, 0.01104335791, 0.8120864083, -0.02659267027, 0.1110433579,
            -0.07569, -0.30384, -0.06280036228, 0.1844834558, 2.736700867, -0.1811928673, 0.60696, -3.3795, 0.1395,
            0.054, 0.4135201558,
        ];
        for (number, expected) in expected.into_iter().enumerate() {
            let got = value(number as u32, &args);
            assert!(
                (got - expected).abs() <= 6e-10 * expected.abs().max(0.1),
                "internal({number}): {got} for {expected}"
            );
        }
    }

    #[test]
    fn further_probes_match_the_binary() {
        let check = |number: u32, args: &[f64], expected: f64| {
            let got = value(number, args);
            assert!(
                (got - expected).abs() <= 4e-15 * expected.abs().max(1.0),
                "internal({number}): {got} for {expected}"
            );
        };
        let p = [0.3, 0.5, -0.7];
        let with = |extra: &[f64]| p.iter().chain(extra).copied().collect::<Vec<_>>();
        check(29, &with(&[0.5, 2.1, 4.5, 0.6, 1.0, 2.0]), 1.3143883121480904);
        check(58, &with(&[2.1, 3.5, 0.4, 0.6, 0.7, 2.0]), -0.47469712911981954);
        check(59, &with(&[0.5, 2.1, 4.5, 0.9, 1.5, 3.0]), 0.9738322826992785);
        check(25, &with(&[2.0, 3.0, 0.4, 0.6, 1.0, 0.5, 25.0]), -0.02745484212173649);
        check(26, &with(&[2.0, 3.0, 0.4, 0.6, 1.0, 0.5, 25.0]), 0.8787977503553016);
        check(64, &with(&[0.3, 0.1, 2.0, 0.0, 0.0, 0.5]), 0.4000075579054032);
        check(52, &with(&[3.0, 0.5, 0.1, 0.2, 0.0, 0.0]), 0.4563231909925269);
        check(1, &with(&[1.0, 10.0, -1.0, 2.0, 30.0]), 0.0563);
        check(8, &with(&[0.001, 0.7]), -0.17392899301002152);
        check(30, &with(&[0.0001]), 0.23328340520000013);
        check(18, &[0.3, 0.5, 0.1, 1.0], 0.1749273964334705);
        check(9, &[0.0, 0.2, 0.0, 1.0], 0.03842363432524021);
        check(40, &[-1.3, 0.1, 2.2, 0.5, 0.7, 1.0, 0.2, 1.0], 0.10704662693192729);
        check(68, &[0.0, 0.0, 0.0, 0.5, 0.5], 1.0);
        check(61, &[3.0, 2.0, 3.0, 1.0], 3.690_415_759_823_43);
    }

    #[test]
    fn the_spectrum_of_ridged_noise_is_made_once() {
        let ridged = Internal::new(59, NoiseGenerator::Corrected).expect("known number");
        let near = |got: f64, expected: f64| assert!((got - expected).abs() < 4e-15, "{got} for {expected}");
        near(ridged.eval(&[0.3, 0.4, 0.5, 1.0, 2.0, 4.0, 1.0, 2.0, 2.0]), 1.4108201539577447);
        near(ridged.eval(&[0.3, 0.4, 0.5, 0.2, 2.0, 4.0, 1.0, 2.0, 2.0]), 1.4108201539577447);
    }
}
