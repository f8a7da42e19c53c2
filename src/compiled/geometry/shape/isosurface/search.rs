//! One ray's search for the surface.
//!
//! The ray is halved until a piece is as short as `accuracy`. POV-Ray leaves a piece out if its
//! ends lie so high that the value cannot come down between them at `max_gradient`: too low a
//! number makes holes. With guarantee, a piece is left out only if bounds of value and slope
//! along the whole of it rule a surface out, and pieces shorter than `accuracy` are looked into,
//! too, so that a sheet of any thinness is found. The points of halving are the same.

use super::{CAP, Isosurface, SKIPPED, SURFACE};
use crate::function::{Enclosure, EnclosureSlots, Interval, Slots};
use crate::math::Ray;

/// Pieces that one search may look at with guarantee. A ray that runs within the surface can be
/// halved for ever without an answer; the few it takes anywhere else are below a thousand. Beyond
/// this, `max_gradient` is believed.
const MOST_PIECES: u32 = 1 << 11;

/// Pieces shorter than `accuracy` that one search may look at between samples: three for each of the
/// 50 halvings that a number has bits for, and as much again for a second place.
const MOST_FINE_PIECES: u32 = 300;

/// Halvings of a piece shorter than `accuracy` across which the value may jump, such as where an angle starts anew. However
/// short it is, bounds hold all that lies between both sides of the jump, and prove nothing.
const MOST_HALVINGS_OF_A_JUMP: u32 = 8;

/// Pieces that one search may look at in all, where functions of which little is known stay as good as zero for long.
const MOST_LOOKS: u32 = 1 << 20;

/// A ray's search for hits.
pub(super) struct Search<'a> {
    surface: &'a Isosurface,
    ray: &'a Ray,
    /// Length of the ray's direction.
    speed: f64,
    /// Ray parameter at which halving stops.
    accuracy: f64,
    /// What is as good as zero is up to this steep where a ray leaves the surface.
    vicinity: f64,
    /// Steepest slope as far as is known.
    gradient: f64,
    /// -1 while the ray is inside.
    sign: f64,
    /// Nothing behind this matters.
    beyond: f64,
    slots: Slots,
    enclosures: EnclosureSlots,
    /// Pieces that may still be looked at with guarantee.
    pieces_left: u32,
    fine_pieces_left: u32,
    looks_left: u32,
    /// Steepest slope met between two samples.
    steepest: f64,
    /// Whether `max_gradient` would have lost a hit.
    lost: bool,
}

/// A stretch of the ray with the signed values at its ends.
#[derive(Clone, Copy)]
struct Stretch {
    low: f64,
    high: f64,
    at_low: f64,
    at_high: f64,
    /// Most that the value can change from end to end, if `max_gradient` is right.
    bound: f64,
    /// Whether POV-Ray's search comes here.
    believed: bool,
    /// Before the first and after the second nothing is below zero, as bounds along a longer stretch say.
    clear: (f64, f64),
}

impl Stretch {
    fn length(&self) -> f64 {
        self.high - self.low
    }

    /// Whether the ends lie so low that POV-Ray looks between them; not for NaN.
    fn may_fall(&self) -> bool {
        self.at_low + self.at_high < self.bound
    }
}

/// What bounds along a stretch say about the signed value.
enum Course {
    /// Nowhere below zero.
    Above,
    /// Nowhere rising, and below zero at the end; with the steepest slope.
    Falling(f64),
    Unknown,
    /// Not even whether the value jumps.
    Jumping,
}

/// Where the chord between two samples meets zero.
pub(super) fn meets_zero(low: (f64, f64), high: (f64, f64)) -> f64 {
    low.0 + (high.0 - low.0) * (low.1 / (low.1 - high.1))
}

impl<'a> Search<'a> {
    /// For a ray that is in the container between `start` and `end`.
    pub(super) fn new(surface: &'a Isosurface, ray: &'a Ray, [start, end]: [f64; 2], beyond: f64) -> Self {
        let speed = ray.direction.length();
        let accuracy = surface.accuracy_along(ray, [start, end]);
        Self {
            surface,
            ray,
            speed,
            accuracy,
            vicinity: 4.0 * surface.accuracy.max(accuracy * speed),
            gradient: surface.max_gradient,
            sign: 1.0,
            beyond,
            slots: Slots::new(),
            enclosures: EnclosureSlots::new(),
            pieces_left: if surface.guaranteed { MOST_PIECES } else { 0 },
            fine_pieces_left: MOST_FINE_PIECES,
            looks_left: MOST_LOOKS,
            steepest: 0.0,
            lost: false,
        }
    }

    /// Leaves word of what was found out.
    pub(super) fn finish(self) {
        self.surface.notes.add(self.steepest, self.lost);
    }

    fn value(&mut self, t: f64) -> f64 {
        self.surface.value(self.ray.at(t), &mut self.slots)
    }

    /// Calls `found` with every hit until it returns true.
    pub(super) fn run(&mut self, start: f64, end: f64, mut found: impl FnMut(f64, u32) -> bool) {
        let (accuracy, far) = (self.accuracy, end);
        let (mut low, mut count) = (start, 0);
        if !self.surface.open {
            // A hit on the container counts only if anything is left to search.
            let mut caps: [Option<f64>; 2] = [None; 2];
            if start > accuracy {
                if self.value(start) < 0.0 {
                    caps[0] = Some(start);
                    count = 1;
                    self.sign = -1.0;
                }
            } else {
                let value = self.value(start);
                if self.is_near_zero(value, start) {
                    low = SKIPPED * accuracy;
                    self.turn_at(low);
                }
                caps[1] = (self.value(end) < 0.0).then_some(end);
            }
            if far - low.min(far) < accuracy || caps.into_iter().flatten().any(|t| found(t, CAP)) {
                return;
            }
        }
        low = low.min(far);
        if far - low < accuracy {
            return;
        }
        if low < accuracy && self.sign > 0.0 {
            let value = self.value(low).abs();
            if self.is_near_zero(value, low) {
                low = SKIPPED * accuracy;
                self.turn_at(low);
            }
        }
        while count < self.surface.max_trace {
            let Some(root) = self.first_root(low, far) else { return };
            low = root + SKIPPED * accuracy;
            if found(root, SURFACE) || far - low < accuracy {
                return;
            }
            self.sign = -self.sign;
            count += 1;
        }
    }

    /// Whether a value at `t` may belong to the surface that the ray leaves.
    fn is_near_zero(&mut self, value: f64, t: f64) -> bool {
        if value < self.gradient * self.vicinity {
            return true;
        }
        // Where `max_gradient` is too low, the true slope of the first steps counts.
        let least = value * self.speed / self.vicinity;
        let met = |slope: Interval| slope.is_bounded() && slope.magnitude() > least;
        self.surface.guaranteed && met(self.enclose(t, t + SKIPPED * self.accuracy).slope)
    }

    /// Starts inside if the function says so there.
    fn turn_at(&mut self, t: f64) {
        if self.value(t) < 0.0 {
            self.sign = -1.0;
        }
    }

    /// Where the signed value first falls below zero.
    fn first_root(&mut self, low: f64, high: f64) -> Option<f64> {
        if let Some([limit, _, factor]) = self.surface.evaluate
            && self.gradient > limit
        {
            self.gradient *= factor;
        }
        let (at_low, at_high) = (self.value(low), self.value(high));
        if self.surface.open && self.sign * at_low < 0.0 {
            self.sign = -self.sign;
        }
        let bound = self.gradient * self.speed * (high - low);
        let (at_low, at_high) = (at_low * self.sign, at_high * self.sign);
        self.halve(Stretch { low, high, at_low, at_high, bound, believed: true, clear: (low, high) })
    }

    /// Halves until the stretch is as short as `accuracy`; NaN ends POV-Ray's search there.
    fn halve(&mut self, mut s: Stretch) -> Option<f64> {
        if s.low >= self.beyond || self.looks_left == 0 {
            return None;
        }
        self.looks_left -= 1;
        self.note_slope(&mut s);
        if s.length() < self.accuracy {
            return self.end_of(s);
        }
        s.believed &= s.may_fall();
        if self.pieces_left > 0 {
            if s.high <= s.clear.0 || s.low >= s.clear.1 {
                return None;
            }
            self.pieces_left -= 1;
            match self.course(&mut s) {
                Course::Above => return None,
                // What `max_gradient` would lose has to be judged on the way.
                Course::Falling(slope) if s.believed && -slope <= self.gradient * self.speed => {
                    return Some(self.leap(s).unwrap_or_else(|| self.bisect(s)));
                }
                Course::Falling(_) => return Some(self.bisect(s)),
                Course::Unknown | Course::Jumping => {}
            }
        } else if !s.may_fall() {
            return None;
        }
        let (near, far) = self.halves(s)?;
        self.halve(near).or_else(|| self.halve(far))
    }

    /// Keeps the steepest slope, and adapts the bound where the file asks for it.
    fn note_slope(&mut self, s: &mut Stretch) {
        let slope = (s.at_high - s.at_low).abs() / (self.speed * s.length());
        self.steepest = self.steepest.max(slope);
        if let Some([_, reserve, _]) = self.surface.evaluate
            && self.gradient < reserve * slope
        {
            self.gradient = reserve * reserve * slope;
            s.bound = self.gradient * self.speed * s.length();
        }
    }

    /// Both halves; neighbouring numbers have no middle, however small the accuracy.
    fn halves(&mut self, s: Stretch) -> Option<(Stretch, Stretch)> {
        let middle = 0.5 * (s.low + s.high);
        if middle <= s.low || middle >= s.high {
            return None;
        }
        let (at_middle, bound) = (self.value(middle) * self.sign, 0.5 * s.bound);
        let near = Stretch { high: middle, at_high: at_middle, bound, ..s };
        Some((near, Stretch { low: middle, at_low: at_middle, bound, ..s }))
    }

    /// The hit of a stretch that is as short as `accuracy`: its far end, as in POV-Ray, or a thin
    /// sheet between its ends.
    fn end_of(&mut self, s: Stretch) -> Option<f64> {
        if s.at_high < 0.0 {
            self.lost |= !s.believed;
            return Some(s.high);
        }
        if self.pieces_left == 0 || s.at_low < 0.0 {
            return None;
        }
        let root = self.look_between(s, MOST_HALVINGS_OF_A_JUMP)?;
        self.lost = true;
        Some(root)
    }

    /// A point below zero between two samples that are not; so many more halvings may be of a jump.
    fn look_between(&mut self, mut s: Stretch, halvings: u32) -> Option<f64> {
        if self.fine_pieces_left == 0 {
            return None;
        }
        let halvings = match self.course(&mut s) {
            Course::Above | Course::Falling(_) => return None,
            Course::Unknown => halvings,
            Course::Jumping => halvings.checked_sub(1)?,
        };
        self.fine_pieces_left -= 1;
        let (near, far) = self.halves(s)?;
        if near.at_high < 0.0 {
            return Some(near.high);
        }
        self.look_between(near, halvings).or_else(|| self.look_between(far, halvings))
    }

    /// The point of halving behind the only change of a stretch that falls.
    fn bisect(&mut self, mut s: Stretch) -> f64 {
        while s.length() >= self.accuracy {
            s.believed &= s.may_fall();
            let Some((near, far)) = self.halves(s) else { break };
            s = if near.at_high < 0.0 { near } else { far };
        }
        self.lost |= !s.believed;
        s.high
    }

    /// As [`bisect`](Self::bisect) with fewer samples: a few false positions foretell the way, and two
    /// samples prove it right.
    fn leap(&mut self, s: Stretch) -> Option<f64> {
        let (mut low, mut high) = ((s.low, s.at_low), (s.high, s.at_high));
        for _ in 0..3 {
            let t = meets_zero(low, high);
            if !(low.0 < t && t < high.0) {
                return None;
            }
            let at = self.value(t) * self.sign;
            if at < 0.0 { high = (t, at) } else { low = (t, at) }
        }
        let root = meets_zero(low, high);
        let (mut first, mut last) = (s.low, s.high);
        while last - first >= self.accuracy {
            let middle = 0.5 * (first + last);
            if middle < root { first = middle } else { last = middle }
        }
        let right = self.value(first) * self.sign >= 0.0 && self.value(last) * self.sign < 0.0;
        right.then_some(last)
    }

    /// Bounds of the unsigned value and its slope between two parameters.
    fn enclose(&mut self, low: f64, high: f64) -> Enclosure {
        let t = Interval { low, high };
        let coordinate = |axis: usize| {
            let (o, d) = (self.ray.origin[axis], Interval::point(self.ray.direction[axis]));
            Enclosure { value: Interval::point(o) + t * d, slope: d }
        };
        self.surface.function.enclose_in(&[0, 1, 2].map(coordinate), &mut self.enclosures)
    }

    /// What is certain between the ends of a stretch.
    fn course(&mut self, s: &mut Stretch) -> Course {
        let enclosed = self.enclose(s.low, s.high);
        let value = enclosed.value - Interval::point(self.surface.threshold);
        let (value, slope) = if self.sign < 0.0 { (-value, -enclosed.slope) } else { (value, enclosed.slope) };
        if value.low > 0.0 {
            return Course::Above;
        }
        if slope.high <= 0.0 {
            return if s.at_high < 0.0 { Course::Falling(slope.low) } else { Course::Above };
        }
        if slope.low >= 0.0 {
            return if s.at_low < 0.0 { Course::Unknown } else { Course::Above };
        }
        // Falling from one end and rising to the other, both as steeply as can be, the value comes
        // down to this at least.
        let (fall, rise) = (slope.low, slope.high);
        let lowest = (s.at_low * rise - s.at_high * fall + fall * rise * s.length()) / (rise - fall);
        if lowest > 0.0 {
            return Course::Above;
        }
        s.clear.0 = s.clear.0.max(s.low - s.at_low / fall);
        s.clear.1 = s.clear.1.min(s.high - s.at_high / rise);
        if enclosed.slope.is_bounded() { Course::Unknown } else { Course::Jumping }
    }
}
