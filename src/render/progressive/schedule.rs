//! When to stop, and what the next round is to be.

use super::accuracy::Accuracy;
use super::allocation::{Noise, Plan};
use super::pixel::Pixel;
use crate::render::film::Gather;
use crate::render::observer::Observer;
use crate::render::options::Target;
use std::time::{Duration, Instant};

/// Share of the target that a round aims at: who aims at the middle misses half of the time.
const AIM: f64 = 0.9;
/// Chance that a picture is said to have reached its target and has not.
const RISK: f64 = 0.05;
/// Share of the time left that a round takes if something can be had for it, so that there is time to look again, and the
/// most that it may take.
const SHARES: [f64; 2] = [0.5, 0.95];
/// Share of what a round may bring with which a higher limit is as good.
const NEARLY: f64 = 0.9;
/// Share of all samples so far below which a round is not worth its bookkeeping.
const WORTHWHILE: f64 = 0.01;
/// The highest limit that is thought of: what a sample is worth in the hardest of pixels.
const FIRST_LIMIT: f64 = 16.0;
/// How many limits are looked at, each a quarter of the one before: the last is beyond single precision.
const N_LIMITS: i32 = 30;

/// What is known after a round.
pub(super) struct State {
    pub(super) accuracy: Accuracy,
    pub(super) noise: Noise,
    /// What expected errors are to be multiplied by.
    pub(super) factor: f64,
    /// Samples that make the picture.
    pub(super) samples: u64,
}

/// Why no more samples are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The error is small enough.
    Reached,
    /// No sample is worth taking any more.
    Exhausted,
    /// The time is over.
    Time,
    /// All rounds that were asked for are done.
    Rounds,
    /// The observer stopped it.
    Cancelled,
}

/// Chooses the limit of the next round.
pub(super) struct Schedule<'t> {
    target: &'t Target,
    start: Instant,
    /// Mean squared error of the first round.
    first: f64,
}

impl<'t> Schedule<'t> {
    /// From the first round on.
    pub(super) fn new(target: &'t Target, start: Instant, first: &State) -> Self {
        Self { target, start, first: first.accuracy.mean_square }
    }

    /// The limit after these rounds, or why there is none.
    pub(super) fn next<G: Gather>(&self, pixels: &[Pixel<G>], state: &State, rounds: &[f64]) -> Result<f64, End> {
        if let Some(known) = &self.target.rounds {
            return known.get(rounds.len()).copied().ok_or(End::Rounds);
        }
        if self.target.error.is_some_and(|error| state.accuracy.upper_rmse(deviations(rounds.len())) <= error) {
            return Err(End::Reached);
        }
        let outlook = Outlook::new(&state.noise, pixels);
        let mut limit = 0.0_f64;
        if let Some(error) = self.target.error {
            // As far below the target as the estimate is uncertain.
            let Accuracy { mean_square, deviation } = state.accuracy;
            let margin = 1.0 + deviations(rounds.len() + 1) * (deviation / mean_square).clamp(0.0, 1.0);
            let aim = AIM * error * error / margin * pixels.len() as f64 / state.factor;
            let reaches = |plan: &Plan| plan.samples > 0 && plan.squared_errors <= aim;
            let plans = outlook.around(reaches);
            let most = plans.iter().rev().find(|plan| plan.samples > 0);
            limit = plans.iter().find(|plan| reaches(plan)).or(most).ok_or(End::Exhausted)?.limit;
        }
        if let Some(time) = self.target.time {
            limit = limit.max(self.affordable(time, state, &outlook)?);
        }
        Ok(limit)
    }

    /// The lowest limit whose samples can be taken in the time that is left, at the pace so far.
    fn affordable<G: Gather>(&self, time: Duration, state: &State, outlook: &Outlook<'_, G>) -> Result<f64, End> {
        if outlook.coarse.iter().all(|plan| plan.samples == 0) {
            return Err(End::Exhausted);
        }
        let spent = self.start.elapsed();
        let left = time.saturating_sub(spent).as_secs_f64();
        let pace = state.samples as f64 / spent.as_secs_f64();
        for share in SHARES {
            let room = share * left * pace;
            let plans = outlook.around(|plan| plan.samples as f64 > room);
            let fits = |plan: &&Plan| plan.samples as f64 <= room;
            let most = plans.iter().rev().find(fits).map_or(0.0, |plan| plan.samples as f64);
            if most > WORTHWHILE * state.samples as f64 {
                // As a round multiplies samples by four at most, far lower limits may bring no more than this one.
                let best = plans.iter().find(|plan| plan.samples as f64 >= NEARLY * most);
                return best.map(|plan| plan.limit).ok_or(End::Time);
            }
        }
        Err(End::Time)
    }

    /// Tells the observer how far the way to the target is done.
    pub(super) fn tell(&self, observer: &dyn Observer, state: &State) {
        const ALL: f64 = 1000.0;
        let by_error = self.target.error.map_or(0.0, |error| {
            let way = |mean_square: f64| (mean_square.max(0.0).sqrt() / error).max(1.0).ln();
            1.0 - way(state.accuracy.mean_square) / way(self.first).max(f64::MIN_POSITIVE)
        });
        let by_time = self.target.time.map_or(0.0, |time| self.start.elapsed().as_secs_f64() / time.as_secs_f64());
        let done = by_error.max(by_time).clamp(0.0, 1.0);
        observer.advanced((done * ALL) as usize, ALL as usize);
    }
}

/// What the next round would bring, by its limit.
struct Outlook<'a, G> {
    noise: &'a Noise,
    pixels: &'a [Pixel<G>],
    /// At all limits that make sense, from high to low in steps of four.
    coarse: Vec<Plan>,
}

impl<'a, G: Gather> Outlook<'a, G> {
    fn new(noise: &'a Noise, pixels: &'a [Pixel<G>]) -> Self {
        let limits: Vec<f64> = (0..N_LIMITS).map(|k| FIRST_LIMIT * (-2.0 * f64::from(k)).exp2()).collect();
        Self { noise, pixels, coarse: noise.plans(pixels, &limits) }
    }

    /// All plans, with small steps from the last that is not yet `enough` to the first that is.
    fn around(&self, enough: impl Fn(&Plan) -> bool) -> Vec<Plan> {
        let mut plans = self.coarse.clone();
        if let Some(first) = plans.iter().position(enough).filter(|first| *first > 0) {
            // Each is a sixth more samples.
            let above = plans[first - 1].limit;
            let fine: Vec<f64> = (1..4).map(|k| above * (-0.5 * f64::from(k)).exp2()).collect();
            plans.splice(first..first, self.noise.plans(self.pixels, &fine));
        }
        plans
    }
}

/// How many standard deviations keep the risk small that one of the looks after each round ends the rendering wrongly:
/// the risk is halved from look to look.
fn deviations(looks_before: usize) -> f64 {
    let risk = RISK * (-1.0 - looks_before as f64).exp2();
    // A normal variable is above z with a chance of at most exp(-z²/2) / 2.
    (-2.0 * (2.0 * risk).ln()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn margins_grow_from_look_to_look() {
        // The normal distribution's own, for risks of 1/40 and 1/1280, are 1.96 and 3.16.
        let (first, sixth) = (deviations(0), deviations(5));
        assert!((1.96..2.6).contains(&first) && (3.16..3.7).contains(&sixth), "{first} {sixth}");
    }
}
