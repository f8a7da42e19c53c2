//! The aperiodic tilings of Penrose: a point descends through inflations to its tile.
//!
//! Every step decides by a line which smaller tile holds the point, and enlarges that tile to
//! the old size. Source: the tables of section 9 of the pattern facts (measured).

use super::tiling::POV_EDGE;
use crate::math::DVec2;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// The golden ratio.
const PHI: f64 = 1.618_033_988_749_895;

/// Which tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Penrose {
    /// Pentagons, stars, boats and diamonds (25).
    Pentagons,
    /// Kites and darts (26).
    Kites,
    /// Two rhombs (27).
    Rhombs,
}

fn degrees(d: f64) -> f64 {
    d.to_radians()
}

/// Every direction that a line of these tilings has, worked out once.
static DIRECTIONS: LazyLock<Directions> = LazyLock::new(|| {
    Directions(std::array::from_fn(|i| {
        let angle = degrees(f64::from(STEP_DEG * (i as i32 - ZERO_STEPS)));
        (DVec2::from_angle(angle), angle.tan())
    }))
});

/// Between neighbouring directions.
const STEP_DEG: i32 = 18;
/// The direction of x among them.
const ZERO_STEPS: i32 = 9;

/// Unit vectors and slopes of the directions from -162 to 180 degrees.
struct Directions([(DVec2, f64); 20]);

impl Directions {
    /// A multiple of 18 degrees.
    #[inline(always)]
    fn at(&self, angle_deg: i32) -> (DVec2, f64) {
        self.0[(angle_deg / STEP_DEG + ZERO_STEPS) as usize % self.0.len()]
    }

    /// Turned counter-clockwise.
    #[inline(always)]
    fn turn(&self, p: DVec2, angle_deg: i32) -> DVec2 {
        self.at(angle_deg).0.rotate(p)
    }

    /// Distance to the line through (q, 0) in a direction.
    #[inline(always)]
    fn line(&self, p: DVec2, q: f64, angle_deg: i32) -> f64 {
        self.at(angle_deg).0.perp_dot(p - DVec2::new(q, 0.0)).abs()
    }

    /// Whether the point lies below the line through (q, 0) in a direction.
    #[inline(always)]
    fn below(&self, p: DVec2, q: f64, angle_deg: i32) -> bool {
        p.y < (p.x - q) * self.at(angle_deg).1
    }

    /// Into the sector of 72 degrees about the positive x axis, upper half.
    #[inline(always)]
    fn folded(&self, p: DVec2) -> DVec2 {
        let upper = DVec2::new(p.x, p.y.abs());
        let left_of = |angle_deg: i32| self.at(angle_deg).0.perp_dot(upper) > 0.0;
        let turned = if left_of(108) {
            self.turn(upper, -144)
        } else if left_of(36) {
            self.turn(upper, -72)
        } else {
            upper
        };
        DVec2::new(turned.x, turned.y.abs())
    }
}

impl Penrose {
    /// Tiling 25, 26 or 27.
    pub fn new(n: u32) -> Option<Self> {
        [Self::Pentagons, Self::Kites, Self::Rhombs].get(n.checked_sub(25)? as usize).copied()
    }

    /// The value at a point of the plane.
    pub(super) fn value(self, p: DVec2) -> f64 {
        // POV-Ray's own limit of the origin.
        if p.length() <= 1e-10 {
            return 1.0;
        }
        let directions = &*DIRECTIONS;
        match self {
            Self::Pentagons => PENTAGON.value(directions.folded(p)),
            Self::Kites => kites(directions, directions.folded(p), false),
            Self::Rhombs => kites(directions, directions.folded(p / PHI), true),
        }
    }
}

fn kites(directions: &Directions, p: DVec2, rhombs: bool) -> f64 {
    let n = ((p.x + p.y * directions.at(18).1).ln() / (PHI * PHI).ln()).ceil().max(0.0) as i32;
    let corner = directions.at(36).0;
    let mut p = p * PHI.powi(-2 * n);
    if n % 2 == 1 {
        p = directions.turn(p, -36);
    }
    let mut kite = true;
    for _ in 0..2 * n {
        p.y = p.y.abs();
        let (moved, next) = match (kite, directions.below(p, 1.0 / PHI, if kite { 144 } else { 108 })) {
            (true, true) => (p, false),
            (true, false) => (directions.turn(p - corner, 108), true),
            (false, true) => (directions.turn(p, -36), true),
            (false, false) => (directions.turn(p - DVec2::X, -144), false),
        };
        p = moved * PHI;
        kite = next;
    }
    p.y = p.y.abs();
    // The slope factors are POV-Ray's rounded ones; a margin keeps the two kinds apart.
    let line = |q: f64, angle_deg: i32| directions.line(p, q, angle_deg);
    let low = |w: f64, m: f64| (0.5 - w * m / 2.0).clamp(0.0, 0.5 - 1e-6);
    let high = |w: f64, m: f64| (1.0 - w * m / 2.0).max(0.5 + 1e-6);
    match (rhombs, kite) {
        (false, true) => low(4.46, line(0.0, 36).min(line(1.0, 108))),
        (false, false) => high(4.46, p.y.min(line(1.0, 144))),
        (true, true) if directions.below(p, 1.0 / PHI, 72) => high(5.55, line(1.0 / PHI, 72).min(line(1.0, 108))),
        (true, true) => low(5.55, p.y.min(line(1.0 / PHI, 72))),
        (true, false) => low(5.55, line(0.0, 36).min(line(1.0, 144))),
    }
}

/// Where a point of the pentagon tiling stands: shapes in their two or three positions.
#[derive(Clone, Copy)]
enum State {
    A,
    B0,
    B1,
    C0,
    C1,
    S,
    T0,
    T1,
    D0,
    D1,
}

/// Lengths of a pentagon of side 1: circumradius, apothem, half a diagonal's height.
struct Pentagon {
    c: f64,
    a: f64,
    d: f64,
    /// The height of a corner.
    h: f64,
    directions: &'static Directions,
}

static PENTAGON: LazyLock<Pentagon> = LazyLock::new(Pentagon::new);

impl Pentagon {
    fn new() -> Self {
        let c = 1.0 / (2.0 * (PI / 5.0).sin());
        let a = 1.0 / (2.0 * (PI / 5.0).tan());
        Self { c, a, d: c * degrees(72.0).cos(), h: c * degrees(72.0).sin(), directions: &DIRECTIONS }
    }

    /// One inflation; the new point is still to be enlarged.
    fn step(&self, state: State, p: DVec2) -> (DVec2, State) {
        let Self { c, a, d, h, directions } = *self;
        let turn = |p: DVec2, angle_deg: i32| directions.turn(p, angle_deg);
        let below = |p: DVec2, q: f64, angle_deg: i32| directions.below(p, q, angle_deg);
        let lower = |x: f64, y: f64| DVec2::new(x, y);
        let onto_c0 = |p: DVec2| (lower(-p.x - d, p.y - h), State::C0);
        match state {
            State::A => {
                let p = directions.folded(p);
                if p.y < (p.x - a) * directions.at(54).1 + 0.5 {
                    (lower(p.x - a - d / PHI, p.y), State::B0)
                } else {
                    (turn(p, -36), State::S)
                }
            }
            State::B0 if below(p, -c, 18) => (lower(p.x + c - c / (PHI * PHI), p.y), State::D0),
            State::B0 => onto_c0(turn(p, -36)),
            State::B1 if below(p, c / (PHI * PHI), 54) => (lower(p.x - c, p.y), State::A),
            State::B1 if below(p, c / (PHI * PHI), 162) => (lower(-p.x, p.y), State::D1),
            State::B1 => (turn(p, 108) + lower(c / PHI, 0.0), State::B1),
            State::C0 if p.x < -d => (turn(p, -144) - lower(c, 0.0), State::B0),
            State::C0 if p.y > (p.x - c / (PHI * PHI)) * directions.at(126).1 => onto_c0(turn(p, 36)),
            State::C0 => (p, State::T0),
            State::C1 if p.x > d / (PHI * PHI) => (lower(-p.x + d / (PHI * PHI) + a / PHI, p.y), State::B1),
            State::C1 => (p, State::T1),
            State::S if p.x < a / PHI => (p, State::A),
            State::S => (lower(-p.x + 2.0 * a / PHI, p.y), State::C1),
            State::T1 if p.x > -PHI * d => (lower(-p.x, p.y), State::A),
            State::T1 => (p + lower(c, 0.0), State::C1),
            State::T0 => (turn(p, 72) + lower(c, 0.0), State::C1),
            State::D1 => (p, State::A),
            State::D0 => (p, State::C1),
        }
    }

    /// Kind and distance to the nearest side, at the last level.
    fn tile(&self, state: State, p: DVec2) -> (f64, f64) {
        let Self { c, a, d, directions, .. } = *self;
        let folded = |p: DVec2| directions.folded(p);
        let line = |p: DVec2, q: f64, angle_deg: i32| directions.line(p, q, angle_deg);
        match state {
            State::A => (0.0, (folded(p).x - a).abs()),
            State::B0 | State::B1 => (1.0, (folded(p).x - a).abs()),
            State::C0 | State::C1 => (2.0, (folded(p).x - a).abs()),
            State::S => (3.0, line(p, PHI * c, 162)),
            State::T0 | State::T1 => {
                let mirrored = folded(DVec2::new(-p.x, p.y));
                (4.0, (p.x - d / PHI).abs().min(line(mirrored, PHI * c, 162)))
            }
            State::D0 | State::D1 => (5.0, line(p, -c / PHI, 18)),
        }
    }

    /// The value at a point of the first sector.
    fn value(&self, p: DVec2) -> f64 {
        let n = ((2.0 * p.x * self.directions.at(36).1).ln() / PHI.powi(4).ln()).ceil().max(0.0) as i32;
        let mut p = p * PHI.powi(-4 * n);
        let mut state = State::A;
        for _ in 0..4 * n {
            p.y = p.y.abs();
            let (moved, next) = self.step(state, p);
            p = moved * PHI;
            state = next;
        }
        p.y = p.y.abs();
        let (kind, m) = self.tile(state, p);
        let rise = (1.0 - 5.55 * m / PHI).max(0.0);
        ((kind + rise) / 6.0).clamp(kind / 6.0 + POV_EDGE, (kind + 1.0) / 6.0 - POV_EDGE)
    }
}
