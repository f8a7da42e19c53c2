//! Frames and their clocks.

use crate::eval;

/// An animation: frames, and how the clock runs through them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Animation {
    /// The first frame's number.
    pub initial_frame: u32,
    /// The last frame's number, at least the first's.
    pub final_frame: u32,
    /// `clock` in the first frame.
    pub initial_clock: f64,
    /// `clock` in the last frame; of a cyclic animation, in the one behind it, which is the first again.
    pub final_clock: f64,
    /// Whether the last frame is followed by the first.
    pub cyclic: bool,
}

impl Animation {
    /// What the scene takes for the last frame: of a cyclic animation the one that is left out.
    ///
    /// Source: command line facts, section 5.
    pub fn last_seen(&self) -> u32 {
        self.final_frame.saturating_add(u32::from(self.cyclic))
    }

    /// By how much the clock goes on from frame to frame; 0 if there is only one.
    pub fn clock_delta(&self) -> f64 {
        let steps = f64::from(self.last_seen().saturating_sub(self.initial_frame));
        if steps > 0.0 { (self.final_clock - self.initial_clock) / steps } else { 0.0 }
    }

    /// The clock of a frame, which may lie outside of the animation.
    pub fn clock(&self, frame: u32) -> f64 {
        self.initial_clock + (f64::from(frame) - f64::from(self.initial_frame)) * self.clock_delta()
    }

    /// Lets a scene see itself as a frame.
    pub fn show(&self, frame: u32, reading: &mut eval::Options) {
        let [initial, last, number] = [self.initial_frame, self.last_seen(), frame].map(f64::from);
        reading.clock = single(self.clock(frame));
        reading.animated = true;
        reading.animation = [
            initial,
            last,
            number,
            six_digits(self.initial_clock),
            six_digits(self.final_clock),
            six_digits(self.clock_delta()),
        ];
    }

    /// Digits of a frame's number in file names.
    pub fn digits(&self) -> usize {
        self.last_seen().to_string().len()
    }
}

/// As scenes see a clock: in single precision. Source: command line facts, section 5.
pub fn single(clock: f64) -> f64 {
    f64::from(clock as f32)
}

/// As scenes see other numbers from outside. Source: command line facts, section 5.
pub fn six_digits(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FOUR: Animation =
        Animation { initial_frame: 1, final_frame: 3, initial_clock: 0.0, final_clock: 1.0, cyclic: true };

    fn check(animation: Animation, frame: u32, clock: f64, seen: [f64; 6]) {
        let mut reading = eval::Options::default();
        animation.show(frame, &mut reading);
        assert_eq!((reading.clock, reading.animation), (clock, seen), "frame {frame} of {animation:?}");
    }

    #[test]
    fn scenes_see_what_they_see_in_povray() {
        check(FOUR, 2, 0.3333333432674408, [1.0, 4.0, 2.0, 0.0, 1.0, 0.333333]);
        let plain = Animation { cyclic: false, ..FOUR };
        check(plain, 2, 0.5, [1.0, 3.0, 2.0, 0.0, 1.0, 0.5]);
        check(plain, 9, 4.0, [1.0, 3.0, 9.0, 0.0, 1.0, 0.5]);
        let one = Animation { initial_frame: 5, final_frame: 5, initial_clock: 0.25, ..plain };
        check(one, 5, 0.25, [5.0, 5.0, 5.0, 0.25, 1.0, 0.0]);
    }

    #[test]
    fn numbers_are_as_long_as_the_last() {
        assert_eq!(Animation { final_frame: 9, ..FOUR }.digits(), 2);
        assert_eq!(Animation { final_frame: 9, cyclic: false, ..FOUR }.digits(), 1);
    }

    #[test]
    fn numbers_lose_digits() {
        assert_eq!(six_digits(12.3456789), 12.3457);
        assert_eq!(six_digits(-123456789.0), -123457000.0);
        assert!(single(0.123456789012) != 0.123456789012);
    }
}
