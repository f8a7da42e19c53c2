//! The aperiodic tilings of Penrose: a point descends through inflations to its tile.
//!
//! Every step decides by a line which smaller tile holds the point, and enlarges that tile to
//! the old size. Source: the tables of section 9 of the pattern facts (measured).

use crate::math::DVec2;
use std::f64::consts::PI;

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

/// Turned counter-clockwise.
fn turn(p: DVec2, angle_deg: f64) -> DVec2 {
    DVec2::from_angle(degrees(angle_deg)).rotate(p)
}

/// Distance to the line through (q, 0) in a direction.
fn line(p: DVec2, q: f64, angle_deg: f64) -> f64 {
    DVec2::from_angle(degrees(angle_deg)).perp_dot(p - DVec2::new(q, 0.0)).abs()
}

/// Whether the point lies below the line through (q, 0) in a direction.
fn below(p: DVec2, q: f64, angle_deg: f64) -> bool {
    p.y < (p.x - q) * degrees(angle_deg).tan()
}

/// Into the sector of 72 degrees about the positive x axis, upper half.
fn folded(p: DVec2) -> DVec2 {
    let sector = degrees(72.0);
    let angle = p.y.atan2(p.x);
    let angle = (angle - sector * (angle / sector).round()).abs();
    p.length() * DVec2::new(angle.cos(), angle.sin())
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
        match self {
            Self::Pentagons => pentagons(folded(p)),
            Self::Kites => kites(folded(p), false),
            Self::Rhombs => kites(folded(p / PHI), true),
        }
    }
}

fn kites(p: DVec2, rhombs: bool) -> f64 {
    let n = ((p.x + p.y * degrees(18.0).tan()).ln() / (PHI * PHI).ln()).ceil().max(0.0) as i32;
    let mut p = p * PHI.powi(-2 * n);
    if n % 2 == 1 {
        p = turn(p, -36.0);
    }
    let mut kite = true;
    for _ in 0..2 * n {
        p.y = p.y.abs();
        let (moved, next) = match (kite, below(p, 1.0 / PHI, if kite { 144.0 } else { 108.0 })) {
            (true, true) => (p, false),
            (true, false) => (turn(p - DVec2::new(degrees(36.0).cos(), degrees(36.0).sin()), 108.0), true),
            (false, true) => (turn(p, -36.0), true),
            (false, false) => (turn(p - DVec2::X, -144.0), false),
        };
        p = moved * PHI;
        kite = next;
    }
    p.y = p.y.abs();
    // The slope factors are POV-Ray's rounded ones; a margin keeps the two kinds apart.
    let low = |w: f64, m: f64| (0.5 - w * m / 2.0).clamp(0.0, 0.5 - 1e-6);
    let high = |w: f64, m: f64| (1.0 - w * m / 2.0).max(0.5 + 1e-6);
    match (rhombs, kite) {
        (false, true) => low(4.46, line(p, 0.0, 36.0).min(line(p, 1.0, 108.0))),
        (false, false) => high(4.46, p.y.min(line(p, 1.0, 144.0))),
        (true, true) if below(p, 1.0 / PHI, 72.0) => high(5.55, line(p, 1.0 / PHI, 72.0).min(line(p, 1.0, 108.0))),
        (true, true) => low(5.55, p.y.min(line(p, 1.0 / PHI, 72.0))),
        (true, false) => low(5.55, line(p, 0.0, 36.0).min(line(p, 1.0, 144.0))),
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
}

impl Pentagon {
    fn new() -> Self {
        let c = 1.0 / (2.0 * (PI / 5.0).sin());
        Self { c, a: 1.0 / (2.0 * (PI / 5.0).tan()), d: c * degrees(72.0).cos() }
    }

    /// One inflation; the new point is still to be enlarged.
    fn step(&self, state: State, p: DVec2) -> (DVec2, State) {
        let Self { c, a, d } = *self;
        let lower = |x: f64, y: f64| DVec2::new(x, y);
        let onto_c0 = |p: DVec2| (lower(-p.x - d, p.y - c * degrees(72.0).sin()), State::C0);
        match state {
            State::A => {
                let p = folded(p);
                if p.y < (p.x - a) * degrees(54.0).tan() + 0.5 {
                    (lower(p.x - a - d / PHI, p.y), State::B0)
                } else {
                    (turn(p, -36.0), State::S)
                }
            }
            State::B0 if below(p, -c, 18.0) => (lower(p.x + c - c / (PHI * PHI), p.y), State::D0),
            State::B0 => onto_c0(turn(p, -36.0)),
            State::B1 if below(p, c / (PHI * PHI), 54.0) => (lower(p.x - c, p.y), State::A),
            State::B1 if below(p, c / (PHI * PHI), 162.0) => (lower(-p.x, p.y), State::D1),
            State::B1 => (turn(p, 108.0) + lower(c / PHI, 0.0), State::B1),
            State::C0 if p.x < -d => (turn(p, -144.0) - lower(c, 0.0), State::B0),
            State::C0 if p.y > (p.x - c / (PHI * PHI)) * degrees(126.0).tan() => onto_c0(turn(p, 36.0)),
            State::C0 => (p, State::T0),
            State::C1 if p.x > d / (PHI * PHI) => (lower(-p.x + d / (PHI * PHI) + a / PHI, p.y), State::B1),
            State::C1 => (p, State::T1),
            State::S if p.x < a / PHI => (p, State::A),
            State::S => (lower(-p.x + 2.0 * a / PHI, p.y), State::C1),
            State::T1 if p.x > -PHI * d => (lower(-p.x, p.y), State::A),
            State::T1 => (p + lower(c, 0.0), State::C1),
            State::T0 => (turn(p, 72.0) + lower(c, 0.0), State::C1),
            State::D1 => (p, State::A),
            State::D0 => (p, State::C1),
        }
    }

    /// Kind and distance to the nearest side, at the last level.
    fn tile(&self, state: State, p: DVec2) -> (f64, f64) {
        let Self { c, a, d } = *self;
        match state {
            State::A => (0.0, (folded(p).x - a).abs()),
            State::B0 | State::B1 => (1.0, (folded(p).x - a).abs()),
            State::C0 | State::C1 => (2.0, (folded(p).x - a).abs()),
            State::S => (3.0, line(p, PHI * c, 162.0)),
            State::T0 | State::T1 => {
                let mirrored = folded(DVec2::new(-p.x, p.y));
                (4.0, (p.x - d / PHI).abs().min(line(mirrored, PHI * c, 162.0)))
            }
            State::D0 | State::D1 => (5.0, line(p, -c / PHI, 18.0)),
        }
    }
}

fn pentagons(p: DVec2) -> f64 {
    let shape = Pentagon::new();
    let n = ((2.0 * p.x * degrees(36.0).tan()).ln() / PHI.powi(4).ln()).ceil().max(0.0) as i32;
    let mut p = p * PHI.powi(-4 * n);
    let mut state = State::A;
    for _ in 0..4 * n {
        p.y = p.y.abs();
        let (moved, next) = shape.step(state, p);
        p = moved * PHI;
        state = next;
    }
    p.y = p.y.abs();
    let (kind, m) = shape.tile(state, p);
    let rise = (1.0 - 5.55 * m / PHI).max(0.0);
    ((kind + rise) / 6.0).clamp(kind / 6.0 + 1e-6, (kind + 1.0) / 6.0 - 1e-6)
}
