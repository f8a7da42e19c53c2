//! Which frames of an animation are rendered.
//!
//! Source: command line facts, section 5.

use super::settings::Settings;
use crate::job::Animation;

/// The animation that settings ask for, and the numbers of the frames to render; `None` for a single picture.
pub(super) fn frames(settings: &Settings) -> Option<(Animation, Vec<u32>)> {
    let given = [settings.initial_frame, settings.final_frame];
    if given == [None; 2] || given.iter().all(|frame| frame.is_none_or(|frame| frame == 0)) {
        return None;
    }
    let number = |frame: i64| frame.clamp(0, i64::from(u32::MAX)) as u32;
    let initial_frame = number(settings.initial_frame.unwrap_or(1));
    let final_frame = number(settings.final_frame.unwrap_or(1)).max(initial_frame);
    let Settings { initial_clock, final_clock, cyclic, .. } = *settings;
    let animation = Animation { initial_frame, final_frame, initial_clock, final_clock, cyclic };
    let [from, to] = settings.subset;
    let first = from.map_or(initial_frame, |v| in_subset(&animation, v)).max(initial_frame);
    let last = to.map_or(final_frame, |v| in_subset(&animation, v)).max(first);
    let step = usize::try_from(settings.step).unwrap_or(1).max(1);
    Some((animation, (first..=last).step_by(step).collect()))
}

/// A number below 1 is a part of all frames, which are counted without the first one's number.
fn in_subset(animation: &Animation, value: f64) -> u32 {
    if value < 1.0 { (value.max(0.0) * f64::from(count(animation))) as u32 } else { value as u32 }
}

/// How many frames a part is taken of; a cyclic animation has one more here.
fn count(animation: &Animation) -> u32 {
    animation.last_seen() - animation.initial_frame + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(frames_given: [i64; 2], subset: [Option<f64>; 2], cyclic: bool, step: i64, expected: &[u32]) {
        let [initial_frame, final_frame] = frames_given.map(Some);
        let settings = Settings { initial_frame, final_frame, subset, cyclic, step, ..Settings::default() };
        let found = frames(&settings).map_or_else(Vec::new, |(_, frames)| frames);
        assert_eq!(found, expected, "{frames_given:?} {subset:?}");
    }

    #[test]
    fn frames_are_those_of_povray() {
        check([1, 3], [None; 2], false, 1, &[1, 2, 3]);
        check([5, 3], [None; 2], false, 1, &[5]);
        check([1, -1], [None; 2], false, 1, &[1]);
        check([0, 0], [None; 2], false, 1, &[]);
        check([1, 3], [Some(5.0), Some(9.0)], false, 1, &[5, 6, 7, 8, 9]);
        check([1, 5], [Some(2.0), None], false, 2, &[2, 4]);
        check([1, 5], [Some(4.0), Some(2.0)], false, 0, &[4]);
        for (start, expected) in [(0.25, 2), (0.5, 5), (0.05, 1), (0.99, 9)] {
            check([1, 10], [Some(start), Some(1.0)], false, 1, &[expected]);
        }
        check([3, 12], [Some(0.5), Some(1.0)], false, 1, &[5]);
        check([10, 20], [Some(0.6), Some(1.0)], false, 1, &[10]);
        check([1, 9], [Some(0.5), Some(1.0)], true, 1, &[5]);
    }
}
