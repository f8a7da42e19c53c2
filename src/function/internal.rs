//! The built-in functions that `functions.inc` declares as `internal(N)`.
//!
//! Formulas and their probe values: section 6 of the function facts. Parameters after
//! x, y and z are `p[0]`, `p[1]`, …

use super::int32;
use crate::math::DVec3;
use crate::math::noise::{NoiseGenerator, noise};
use std::f64::consts::{PI, TAU};
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

/// Stands for 0 where an angle about the y axis would be undefined, as in POV-Ray.
const POV_OFF_AXIS: f64 = 1e-6;

/// The point and the parameters of a call.
struct Call {
    x: f64,
    y: f64,
    z: f64,
    p: [f64; MAX_EXTRA],
}

impl Internal {
    /// The function with this number; `None` where POV-Ray has none.
    pub fn new(number: u32, generator: NoiseGenerator) -> Option<Self> {
        (number <= 78).then(|| Self { number, generator, spectrum: Arc::default() })
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
            0..=3 | 15 | 21 | 34 | 39 | 50 | 67 | 75 => c.plane_curve(self.number),
            4 | 5 | 8 | 11..=14 | 16 | 18 | 20 | 22 | 23 | 30 | 31 | 33 | 35..=38 | 41..=46 => c.clamped(self.number),
            48 | 49 | 54..=56 | 65 | 66 | 71..=74 => c.clamped(self.number),
            29 | 58 => c.fractal_noise(self.number),
            59 => c.ridged(&self.spectrum),
            76 => noise(self.generator, c.point()),
            78 => noise(noise_argument(c.p[0]), c.point()),
            _ => c.distance(self.number),
        }
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

fn cube(v: f64) -> f64 {
    v * v * v
}

/// Length of (u, v) in the norm that `c` chooses: round, square, or a superellipse between.
fn superellipse(u: f64, v: f64, c: f64) -> f64 {
    if c == 1.0 {
        (u * u + v * v).sqrt()
    } else if c == 0.0 {
        u.abs().max(v.abs())
    } else {
        (u.abs().powf(2.0 / c) + v.abs().powf(2.0 / c)).powf(c / 2.0)
    }
}

/// Remainder in 0..2 pi.
fn turn(angle: f64) -> f64 {
    let r = angle % TAU;
    if r < 0.0 { r + TAU } else { r }
}

impl Call {
    fn point(&self) -> DVec3 {
        DVec3::new(self.x, self.y, self.z)
    }

    /// Squared distance from the origin.
    fn q(&self) -> f64 {
        self.x * self.x + self.y * self.y + self.z * self.z
    }

    /// Squared distance from the y axis.
    fn s(&self) -> f64 {
        self.x * self.x + self.z * self.z
    }

    /// The plane point of a curve that may be revolved about y: switch, offset and angle start at `p[i]`.
    fn revolved(&self, i: usize) -> (f64, f64) {
        let [switch, offset, angle_deg] = [self.p[i], self.p[i + 1], self.p[i + 2]];
        if switch <= 0.0 {
            return (self.x, self.y);
        }
        let r = self.s().sqrt() - offset;
        if angle_deg == 0.0 {
            return (r, self.y);
        }
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        (r * cos - self.y * sin, r * sin + self.y * cos)
    }

    /// Plane curves, extruded or revolved.
    fn plane_curve(&self, number: u32) -> f64 {
        let p = &self.p;
        let first = match number {
            0..=3 => 2,
            50 | 67 => 4,
            _ => 3,
        };
        let (x, y) = self.revolved(first);
        let (x2, y2) = (x * x, y * y);
        let field = match number {
            0 => x.abs() * x2 - x2 + y2,
            1 => -(2.0 * x2 * x2 - 3.0 * x2 * y + y2 - 2.0 * y * y2 + y2 * y2),
            2 => -(x2 * x2 + x2 * y2 - 2.0 * x2 * y - x * y2 + y2),
            3 => -(square(x2 + y2) + 3.0 * x2 * y - y * y2),
            15 => -(x2 * (x2 - square(p[1])) - y2 * (y2 - square(p[2]))),
            21 => -(y2 * (1.0 + (p[2] - 4.0 * p[1]) * x) + x2 * (1.0 + p[2])),
            34 => -(y2 - square(p[2]) * x2 * x2 + p[1] * cube(p[2]) * x2),
            39 => -(y2 - square(p[1]) * square(p[2]) * x2 + square(p[2]) * x2 * x2),
            50 => -(y2 - p[1] * square(p[3]) * x * x2 - p[2] * square(p[3]) * x2 * x2),
            67 => -((p[2] - x) * y2 - square(p[3]) * x2 * (p[1] + x)),
            _ => square(p[1]) * y + x2 * y - p[2],
        };
        let limit = if number <= 3 { p[1] } else { 10.0 };
        let sign = if number == 75 { -1.0 } else { 1.0 };
        limit.min((p[0] * sign * field).max(-limit))
    }

    /// Polynomial surfaces: `p[0]` times the field, kept between -10 and 10.
    fn clamped(&self, number: u32) -> f64 {
        let field = if matches!(number, 8 | 16 | 31 | 35 | 46 | 71) {
            self.long_polynomial(number)
        } else {
            self.polynomial(number)
        };
        10.0_f64.min((self.p[0] * field).max(-10.0))
    }

    fn polynomial(&self, number: u32) -> f64 {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let (x2, y2, z2, q, s) = (x * x, y * y, z * z, self.q(), self.s());
        match number {
            4 => y2 * (square(p[1]) - s) - square(s + 2.0 * p[1] * y - square(p[1])),
            5 => p[1] * s * y - q * q,
            11 => x2 * z2 - y,
            12 => -(x * x2 - y * y2 - z),
            13 | 43 => {
                z2 * x2 - z2 * z2 - 2.0 * z * x2 + 2.0 * z * z2 + x2
                    - z2
                    - square(x2 - z)
                    - y2 * y2
                    - 2.0 * x2 * y2
                    - y2 * z2
                    + 2.0 * y2 * z
                    + y2
            }
            14 => -(x2 * x2 + 2.0 * x2 * z2 - 0.36 * x2 - y2 * y2 + 0.25 * y2 + z2 * z2),
            18 => {
                // Kept from dividing by 0; the square below keeps the true z, as in POV-Ray.
                let zeta = if z.abs() < 0.2 { 0.2 } else { z };
                let a = (y2 - x2) / (2.0 * zeta) + 2.0 * z2 / 9.0;
                let b = (y2 - x2) / (4.0 * zeta);
                -(cube(a) - 6.0 * square(b))
            }
            20 => (y2 + z2) * (1.0 + (p[2] - 4.0 * p[1]) * x) + x2 * (1.0 + p[2]),
            22 => 0.5 * x2 * x2 * x + 0.5 * x2 * x2 - y2 - z2,
            23 => -(cube(2.0 * x2 + y2 + z2 - 1.0) - 0.1 * x2 * z * z2 - y2 * z * z2),
            30 => -(4.0 * cube(q - 13.0) + 27.0 * square(3.0 * x2 + y2 - 4.0 * z2 - 12.0)),
            33 => -(y2 + z2 - square(p[2]) * x2 * x2 + square(p[1]) * square(p[2]) * x2),
            36 => -(x2 * x2 + y2 * y2 + z2 * z2 - q - x2 * y2 - x2 * z2 - y2 * z2 + 1.0),
            37 => {
                -(x2 * x2 + y2 * y2 + z2 * z2 + p[1] * q + p[2] * (x2 * y2 + x2 * z2 + y2 * z2) + p[3] * x * y * z
                    - 1.0)
            }
            38 => -(x2 * x2 - x2 + y2 + z2),
            41 => -(4.0 * x2 * q - y2 * (1.0 - y2 - z2)),
            42 => -(y * y2 + z * z2 - 6.0 * y * z),
            44 => -(square(q + square(p[1])) - p[3] * square(p[1]) * s - square(p[2])),
            45 => y - s,
            48 => x2 * x2 + y2 * y2 + z2 * z2 - q,
            49 => x2 * x2 - x * x2 + y2 + z2,
            54 => -(x2 * x2 + z2 * z2 - y),
            55 => -(x2 * x2 - z2 * z2 - y),
            56 => -(s * y2 + square(p[2]) * s - square(p[1]) * square(p[2])),
            65 => -(x2 * y2 + x2 * z2 + y2 * z2 + x * y * z),
            66 => -((p[2] - x) * (y2 + z2) - square(p[3]) * x2 * (p[1] + x)),
            72 => {
                let t = y2 + z2;
                -(4.0 * (x2 * x2 + t * t) + 17.0 * x2 * t - 20.0 * q + 17.0)
            }
            73 => -(x2 - y * z2),
            _ => -(p[1] * (y - 1.0) + s * y),
        }
    }

    fn long_polynomial(&self, number: u32) -> f64 {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let (x2, y2, z2, q, s) = (x * x, y * y, z * z, self.q(), self.s());
        let (a, b) = (square(p[1]), square(p[2]));
        match number {
            8 => {
                let (w, t, r2) = (1.0 - z, x2 + y2, 2.0_f64.sqrt());
                let inner = 27.0 * t * t - 24.0 * z2 * t + 36.0 * r2 * y * z * (y2 - 3.0 * x2) + 4.0 * z2 * z2;
                let outer = -81.0 * t * t - 72.0 * z2 * t + 108.0 * r2 * x * z * (x2 - 3.0 * y2) + 4.0 * z2 * z2;
                p[1] * (64.0 * cube(w) * cube(z) - 48.0 * w * w * z2 * (3.0 * t + 2.0 * z2)
                    + 12.0 * w * z * inner
                    + (9.0 * t - 2.0 * z2) * outer)
            }
            16 => {
                let [aa, bb, cc, dd, k] = [p[1], p[2], p[3], p[4], p[5]];
                let kappa = k * k;
                let mu = bb * bb - dd * dd - square(cc + aa);
                let nu = bb * bb - dd * dd - square(cc - aa);
                let line = cc * x + dd * y;
                let spread = (aa * aa + bb * bb - cc * cc - dd * dd) * (2.0 * line - kappa) - 4.0 * dd * bb * bb * y;
                -(mu * nu * q * q
                    + 2.0 * kappa * q * spread
                    + 4.0 * kappa * kappa * line * (line - kappa)
                    + 4.0 * kappa * kappa * aa * aa * y2
                    + square(kappa * kappa))
            }
            31 => {
                -(x2 * x2 + 2.0 * x2 * y2 - 2.0 * x2 * z2 - 2.0 * (a + b) * x2 + y2 * y2 - 2.0 * y2 * z2
                    + 2.0 * (a - b) * y2
                    + z2 * z2
                    + 2.0 * (a + b) * z2
                    + square(a - b))
            }
            35 => {
                let m = q - 2.0 * y - 1.0;
                -((q + 2.0 * y - 1.0) * (m * m - 8.0 * z2) + 16.0 * x * z * m)
            }
            46 => {
                -(x2 * x2 + 2.0 * x2 * y2 - 2.0 * x2 * z - (a + b) * x2 + y2 * y2 - 2.0 * y2 * z
                    + (a - b) * y2
                    + z2
                    + (a + b) * z
                    + square(a - b))
            }
            _ => -(q * q - 2.0 * (a + b) * s + 2.0 * (a - b) * y2 + square(a - b)),
        }
    }

    /// Blobs, distances and coordinates: neither scaled nor clamped.
    fn distance(&self, number: u32) -> f64 {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let (q, s) = (self.q(), self.s());
        match number {
            6 => {
                let h = p[0] / 2.0;
                let near = |x: f64, r: f64| (r * r * (x * x + y * y + z * z)).min(1.0);
                let (a, b) = (near(x + h, p[2]), near(x - h, p[4]));
                -(p[1] * square(1.0 - a) + p[3] * square(1.0 - b))
            }
            7 => p[3] - p[2] * ((-p[1] * q).exp() + (-p[1] * (square(x - p[0]) + y * y + z * z)).exp()),
            9 => self.comma(),
            10 | 19 | 32 | 62 => self.ellipsoids(number),
            17 => (square(p[0] * x) + square(p[1] * y) + square(p[2] * z)).sqrt(),
            24 => self.helical_torus(),
            25 => self.helix1(),
            26 => {
                let theta = p[1] * y;
                let (sin, cos) = theta.sin_cos();
                let (a, b) = (x - p[3] * cos, z - p[3] * sin);
                superellipse(a * cos + b * sin, b * cos - a * sin, p[5]) - p[2]
            }
            27 | 28 => self.hexagon(number == 28),
            40 => self.mesh(),
            47 => s.sqrt().atan2(y),
            51 => s.sqrt() - (p[0] + y * (p[1] + y * (p[2] + y * (p[3] + y * p[4])))).max(-5.0),
            52 => self.polytubes(),
            53 => self.quantum(),
            57 => q.sqrt(),
            60 => self.rounded_box(),
            61 => q.sqrt() - p[0],
            63 => y - p[0] * (p[1] * x).cos() * (p[2] * z).cos() * (-p[3] * s).exp(),
            64 => self.spiral(),
            68 => {
                let round = x.abs().powf(2.0 / p[0]) + y.abs().powf(2.0 / p[0]);
                1.0 - (round.powf(p[0] / p[1]) + z.abs().powf(2.0 / p[1])).powf(p[1] / 2.0)
            }
            69 => x.atan2(z),
            70 => (square(s.sqrt() - p[0]) + y * y).sqrt() - p[1],
            _ => 0.0, // 77 is reserved
        }
    }

    fn comma(&self) -> f64 {
        let (y, a) = (self.y, self.p[0]);
        let x = if self.x == 0.0 && self.z == 0.0 { 1e-4 } else { self.x }; // POV-Ray's step off the axis
        let z = self.z;
        let theta = z.atan2(x);
        let r = (square(x + a / 4.0) + z * z).sqrt();
        let u = z.min(a / 2.0 * (theta / 2.0).cos() - (square(r - 0.75 * a) + y * y).sqrt());
        -u.max(a / 2.0 - (square(x - a / 2.0) + y * y + z * z).sqrt())
    }

    fn ellipsoids(&self, number: u32) -> f64 {
        let (x2, y2, z2, p) = (self.x * self.x, self.y * self.y, self.z * self.z, &self.p);
        let e1 = (-p[1] * (p[0] * x2 + p[0] * y2 + z2)).exp();
        let e2 = (-p[1] * (p[0] * x2 + y2 + p[0] * z2)).exp();
        let e3 = (-p[1] * (x2 + p[0] * y2 + p[0] * z2)).exp();
        match number {
            10 => p[3] - p[2] * e1.max(e2).max(e3),
            19 => p[3] - p[2] * (e1 + e2 + e3),
            32 => p[3] - p[2] * e1.min(e2).min(e3),
            _ => p[2] * (e1 + e2 + e3 - p[4] * (-p[3] * self.q()).exp()),
        }
    }

    fn helical_torus(&self) -> f64 {
        let (y, p) = (self.y, &self.p);
        let rho = self.s().sqrt();
        let x = if self.x == 0.0 && self.z == 0.0 { POV_OFF_AXIS } else { self.x };
        let (phi, omega) = (x.atan2(self.z), (rho - p[0]).atan2(y));
        let r = (square(rho - p[0]) + y * y).sqrt();
        let theta = turn(phi * p[1] + omega * p[2]) - PI;
        let g = (p[7] * (theta * p[8]).atan2(r - p[5]) + phi * p[9]).cos() * p[3] + p[4];
        let tube = (square(r - p[5]) + p[6] * theta * theta).sqrt().min(r + p[5]);
        -(p[4] + p[5] - p[0] - rho).max(g - tube)
    }

    fn helix1(&self) -> f64 {
        let p = &self.p;
        let rho = self.s().sqrt();
        let x = if self.x == 0.0 && self.z == 0.0 { POV_OFF_AXIS } else { self.x };
        let theta = turn(p[0] * self.z.atan2(x) + p[0] * p[1] * self.y);
        let (mut u, mut v) = (rho - p[3], (theta - PI) / (p[0] * p[1] * p[4]));
        if p[5] != 1.0 && p[6] != 0.0 {
            let (sin, cos) = p[6].to_radians().sin_cos();
            (u, v) = (u * cos - v * sin, u * sin + v * cos);
        }
        -p[2] + (p[3] + rho).min(superellipse(u, v, p[5]))
    }

    fn hexagon(&self, along_y: bool) -> f64 {
        let half = 3.0_f64.sqrt() / 2.0;
        let (mut a, mut b) = ((self.x.abs() % (2.0 * half) - half).abs(), (self.y.abs() % 3.0 - 1.5).abs());
        if a * a + b * b > square(half - a) + square(1.5 - b) {
            (a, b) = (half - a, 1.5 - b);
        }
        match (b.atan2(a) < PI / 6.0, along_y) {
            (true, false) => a,
            (false, false) => a / 2.0 + half * b,
            (true, true) => b,
            (false, true) => (b / 2.0 - half * a).abs(),
        }
    }

    fn mesh(&self) -> f64 {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let wave = |t: f64, w: f64| p[2] * (t.rem_euclid(2.0 * w) - w).abs();
        let (u, v) = (p[3] * (PI * z / p[1]).cos(), p[3] * (PI * x / p[0]).cos());
        let thread = |t: f64, d: f64| (t * t + p[4] * p[4] * d * d).sqrt();
        thread(wave(x, p[0]), y - u)
            .min(thread(wave(x - p[0], p[0]), y + u))
            .min(thread(wave(z, p[1]), y + v))
            .min(thread(wave(z - p[1], p[1]), y - v))
    }

    fn polytubes(&self) -> f64 {
        let (y, p) = (self.y, &self.p);
        let r = p[1] + y * (p[2] + y * (p[3] + y * (p[4] + y * p[5])));
        (0..int32(p[0]).max(0.0) as u32)
            .map(|i| {
                let (sin, cos) = (TAU * f64::from(i) / p[0]).sin_cos();
                (square(self.x - r * sin) + square(self.z - r * cos)).sqrt()
            })
            .fold(10_000.0, f64::min) // POV-Ray's value for no tube at all
    }

    fn quantum(&self) -> f64 {
        let x = if self.x == 0.0 && self.z == 0.0 { POV_OFF_AXIS } else { self.x };
        let s = x * x + self.z * self.z;
        let r = 2.0 * (s + self.y * self.y).sqrt();
        let c = s.sqrt().atan2(self.y).cos();
        let t = r * r * (-0.333_333_33 * r).exp() * (3.0 * c * c - 1.0);
        (12.0 - t * t) / 10.0
    }

    fn rounded_box(&self) -> f64 {
        let p = &self.p;
        let beyond = |c: f64, half: f64| (c.abs() - (half - p[0])).max(0.0);
        let d = DVec3::new(beyond(self.x, p[1]), beyond(self.y, p[2]), beyond(self.z, p[3]));
        d.length() - p[0] - 1e-6 // POV-Ray's own offset
    }

    fn spiral(&self) -> f64 {
        let (y, p) = (self.y, &self.p);
        let rho = self.s().sqrt();
        let x = if self.x == 0.0 && self.z == 0.0 { POV_OFF_AXIS } else { self.x };
        let u = (rho + p[0] * self.z.atan2(x) / TAU) % p[0] - p[0] / 2.0;
        let r = self.q().sqrt();
        -(p[2] - r).min(p[1] - superellipse(u, y, p[5]).min(r))
    }

    /// `f_hetero_mf` and `f_ridge`.
    fn fractal_noise(&self, number: u32) -> f64 {
        let p = &self.p;
        let generator = noise_argument(p[5]);
        let at = |f: f64| noise(generator, self.point() * f);
        if number == 29 {
            let term = |i: i32| (2.0 * at(p[1].powi(i)) - 1.0 + p[3]) * p[1].powf(-p[0]).powi(i);
            let mut sum = 2.0 * at(1.0) - 1.0 + p[3];
            let mut i = 1;
            while f64::from(i) < p[2] {
                sum += term(i) * sum.powi(int32(p[4]).max(0.0) as i32);
                i += 1;
            }
            let rest = p[2] - int32(p[2]);
            return if rest == 0.0 { sum } else { sum + rest * sum * term(i) };
        }
        let ridge = |f: f64| (at(f) - p[4]).abs() / p[4].max(1.0 - p[4]) - p[3];
        let (mut value, mut total) = (ridge(1.0), 1.0);
        let whole = int32(p[1]).max(0.0) as i32;
        let mut add = |i: i32, share: f64| {
            let weight = p[2].powi(i - 1) * share;
            value += weight * ridge(p[0].powi(i - 1));
            total += weight;
        };
        (2..=whole).for_each(|i| add(i, 1.0));
        let rest = p[1] - f64::from(whole);
        if rest != 0.0 {
            add(whole.max(1) + 1, rest);
        }
        value / (p[3].max(1.0 - p[3]) * total)
    }

    fn ridged(&self, spectrum: &OnceLock<Vec<f64>>) -> f64 {
        let p = &self.p;
        let generator = noise_argument(p[5]);
        let fold = |f: f64| square(p[3] - (2.0 * noise(generator, self.point() * f) - 1.0).abs());
        let n = p[2].clamp(0.0, 64.0).ceil() as i32; // octaves beyond are far below rounding
        let weights = spectrum.get_or_init(|| (0..=n).map(|i| p[1].powi(i).powf(-p[0])).collect());
        let mut signal = fold(1.0);
        let mut result = signal;
        for i in 1..n {
            let gain = (p[4] * signal).clamp(0.0, 1.0);
            signal = fold(p[1].powi(i)) * gain;
            // POV-Ray reads past its table where a later call has more octaves; we go on with fresh weights.
            let weight = weights.get(i as usize).copied().unwrap_or_else(|| p[1].powi(i).powf(-p[0]));
            result += weight * signal;
        }
        result
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
