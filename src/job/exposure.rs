//! Pictures of moving things: the mean over the time that the shutter is open.

use super::animation::single;
use super::{Identity, Outcome};
use crate::imaging::MARK;

/// The moments at which a picture is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// By how much `clock` goes on while the shutter is open.
    pub span: f64,
    /// How many pictures are taken, at least one.
    pub samples: u32,
}

impl Default for Exposure {
    /// One picture, at the job's own clock.
    fn default() -> Self {
        Self { span: 0.0, samples: 1 }
    }
}

impl Exposure {
    /// Whether there is anything to take the mean of.
    pub fn is_a_moment(&self) -> bool {
        *self == Self::default()
    }

    /// The clocks of all pictures, each in the middle of its share of the span.
    pub(super) fn clocks(self, start: f64) -> impl Iterator<Item = f64> {
        let samples = self.samples.max(1);
        (0..samples).map(move |i| single(start + self.span * (f64::from(i) + 0.5) / f64::from(samples)))
    }
}

/// Pictures that come one after the other, and their sum.
pub(super) struct Mean {
    /// The first one, with what all have said.
    outcome: Outcome,
    sum: Vec<[f64; 4]>,
    n: f64,
}

impl Mean {
    /// With the first picture, and the identity of the whole.
    pub(super) fn new(mut outcome: Outcome, identity: Identity) -> Self {
        let mark = outcome.metadata.notes.iter_mut().find(|(name, _)| *name == MARK);
        mark.into_iter().for_each(|(_, text)| *text = identity.to_string());
        let sum = outcome.picture.pixels.iter().map(|pixel| pixel.map(f64::from)).collect();
        Self { outcome, sum, n: 1.0 }
    }

    pub(super) fn add(&mut self, other: Outcome) {
        let Outcome { picture, metadata, complete, timings, .. } = other;
        for (sum, pixel) in self.sum.iter_mut().zip(&picture.pixels) {
            sum.iter_mut().zip(pixel).for_each(|(sum, value)| *sum += f64::from(*value));
        }
        self.n += 1.0;
        self.outcome.complete &= complete;
        self.outcome.metadata.rays += metadata.rays;
        self.outcome.timings.0.extend(timings.0);
        for (name, value) in metadata.figures {
            let own = self.outcome.metadata.figures.iter_mut().find(|(own, _)| *own == name);
            own.into_iter().for_each(|(_, own)| *own += value);
        }
    }

    pub(super) fn outcome(self) -> Outcome {
        let Self { mut outcome, sum, n } = self;
        outcome.picture.pixels = sum.iter().map(|pixel| pixel.map(|value| (value / n) as f32)).collect();
        outcome
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eval::Memory;
    use crate::job::{Job, Session};
    use crate::render::Unobserved;

    #[test]
    fn moments_lie_in_the_middle_of_their_shares() {
        let clocks = |span: f64, samples: u32| Exposure { span, samples }.clocks(2.0).collect::<Vec<_>>();
        assert_eq!((clocks(1.0, 2), clocks(-1.0, 1), clocks(0.0, 1)), (vec![2.25, 2.75], vec![1.5], vec![2.0]));
    }

    #[test]
    fn pictures_are_means_in_linear_light() {
        let scene = "#version 3.7; global_settings { assumed_gamma 2.2 } background { rgb clock }";
        let exposure = Exposure { span: 1.0, samples: 4 };
        let job = Job { scene: "a.pov".into(), exposure, ..Job::default() };
        let outcome =
            Session::new(1).expose(&job, &Memory::new([("a.pov", scene)]), &Unobserved).expect("a right scene");
        let expected = [0.125_f64, 0.375, 0.625, 0.875].iter().map(|clock| clock.powf(2.2)).sum::<f64>() / 4.0;
        assert!((f64::from(outcome.picture.pixels[9][1]) - expected).abs() < 1e-6);
        assert_eq!(outcome.metadata.rays, 4 * 320 * 240);
    }
}
