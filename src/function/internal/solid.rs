//! Blobs, distances and coordinates: neither scaled nor clamped.

use super::{Call, Number, int32, square};
use std::f64::consts::{PI, TAU};

/// Stands for 0 where an angle about the y axis would be undefined, as in POV-Ray.
const POV_OFF_AXIS: f64 = 1e-6;

/// The same for `f_comma`.
const POV_OFF_COMMA_AXIS: f64 = 1e-4;

/// Length of (u, v) in the norm that `c` chooses: round, square, or a superellipse between.
fn superellipse<N: Number>(u: N, v: N, c: f64) -> N {
    if c == 1.0 {
        (u.squared() + v.squared()).sqrt()
    } else if c == 0.0 {
        u.abs().max(v.abs())
    } else {
        (u.abs().powf(2.0 / c) + v.abs().powf(2.0 / c)).powf(c / 2.0)
    }
}

impl<N: Number> Call<N> {
    pub(super) fn distance(&self, number: u32) -> N {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let (q, s) = (self.q(), self.s());
        match number {
            6 => self.blob(),
            7 => {
                let away = (x - p[0]).squared() + y.squared() + z.squared();
                -(((q * -p[1]).exp() + (away * -p[1]).exp()) * p[2]) + p[3]
            }
            9 => self.comma(),
            10 | 19 | 32 | 62 => self.ellipsoids(number),
            17 => ((x * p[0]).squared() + (y * p[1]).squared() + (z * p[2]).squared()).sqrt(),
            24 => self.helical_torus(),
            25 => self.helix1(),
            26 => {
                let theta = y * p[1];
                let (sin, cos) = (theta.sin(), theta.cos());
                let (a, b) = (x - cos * p[3], z - sin * p[3]);
                superellipse(a * cos + b * sin, b * cos - a * sin, p[5]) - p[2]
            }
            40 => self.mesh(),
            47 => s.sqrt().atan2(y),
            51 => {
                let radius = y * (y * (y * (y * p[4] + p[3]) + p[2]) + p[1]) + p[0];
                s.sqrt() - radius.max(N::constant(-5.0))
            }
            52 => self.polytubes(),
            53 => self.quantum(),
            57 => q.sqrt(),
            60 => self.rounded_box(),
            61 => q.sqrt() - p[0],
            63 => y - (x * p[1]).cos() * p[0] * (z * p[2]).cos() * (s * -p[3]).exp(),
            64 => self.spiral(),
            68 => {
                let round = x.abs().powf(2.0 / p[0]) + y.abs().powf(2.0 / p[0]);
                -(round.powf(p[0] / p[1]) + z.abs().powf(2.0 / p[1])).powf(p[1] / 2.0) + 1.0
            }
            69 => x.atan2(z),
            _ => ((s.sqrt() - p[0]).squared() + y.squared()).sqrt() - p[1],
        }
    }

    fn blob(&self) -> N {
        let p = &self.p;
        let h = p[0] / 2.0;
        let near = |x: N, r: f64| ((x.squared() + self.y.squared() + self.z.squared()) * (r * r)).min(N::constant(1.0));
        let (a, b) = (near(self.x + h, p[2]), near(self.x - h, p[4]));
        -((-a + 1.0).squared() * p[1] + (-b + 1.0).squared() * p[3])
    }

    fn comma(&self) -> N {
        let (y, z, a) = (self.y, self.z, self.p[0]);
        let x = self.x.off_axis(z, POV_OFF_COMMA_AXIS);
        let theta = z.atan2(x);
        let r = ((x + a / 4.0).squared() + z.squared()).sqrt();
        let tail = (theta / 2.0).cos() * (a / 2.0) - ((r - 0.75 * a).squared() + y.squared()).sqrt();
        let head = -((x - a / 2.0).squared() + y.squared() + z.squared()).sqrt() + a / 2.0;
        -z.min(tail).max(head)
    }

    fn ellipsoids(&self, number: u32) -> N {
        let (x2, y2, z2, p) = (self.x.squared(), self.y.squared(), self.z.squared(), &self.p);
        let e1 = ((x2 * p[0] + y2 * p[0] + z2) * -p[1]).exp();
        let e2 = ((x2 * p[0] + y2 + z2 * p[0]) * -p[1]).exp();
        let e3 = ((x2 + y2 * p[0] + z2 * p[0]) * -p[1]).exp();
        match number {
            10 => -(e1.max(e2).max(e3) * p[2]) + p[3],
            19 => -((e1 + e2 + e3) * p[2]) + p[3],
            32 => -(e1.min(e2).min(e3) * p[2]) + p[3],
            _ => (e1 + e2 + e3 - (self.q() * -p[3]).exp() * p[4]) * p[2],
        }
    }

    fn helical_torus(&self) -> N {
        let (y, p) = (self.y, &self.p);
        let rho = self.s().sqrt();
        let x = self.x.off_axis(self.z, POV_OFF_AXIS);
        let (phi, omega) = (x.atan2(self.z), (rho - p[0]).atan2(y));
        let r = ((rho - p[0]).squared() + y.squared()).sqrt();
        let theta = (phi * p[1] + omega * p[2]).positive_remainder(TAU) - PI;
        let g = ((theta * p[8]).atan2(r - p[5]) * p[7] + phi * p[9]).cos() * p[3] + p[4];
        let tube = ((r - p[5]).squared() + theta * p[6] * theta).sqrt().min(r + p[5]);
        -(-rho + (p[4] + p[5] - p[0])).max(g - tube)
    }

    fn helix1(&self) -> N {
        let p = &self.p;
        let rho = self.s().sqrt();
        let x = self.x.off_axis(self.z, POV_OFF_AXIS);
        let theta = (self.z.atan2(x) * p[0] + self.y * (p[0] * p[1])).positive_remainder(TAU);
        let (mut u, mut v) = (rho - p[3], (theta - PI) / (p[0] * p[1] * p[4]));
        if p[5] != 1.0 && p[6] != 0.0 {
            let (sin, cos) = p[6].to_radians().sin_cos();
            (u, v) = (u * cos - v * sin, u * sin + v * cos);
        }
        (rho + p[3]).min(superellipse(u, v, p[5])) - p[2]
    }

    fn mesh(&self) -> N {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let wave = |t: N, w: f64| (t.positive_remainder(2.0 * w) - w).abs() * p[2];
        let (u, v) = ((z * PI / p[1]).cos() * p[3], (x * PI / p[0]).cos() * p[3]);
        let thread = |t: N, d: N| (t.squared() + d * (p[4] * p[4]) * d).sqrt();
        thread(wave(x, p[0]), y - u)
            .min(thread(wave(x - p[0], p[0]), y + u))
            .min(thread(wave(z, p[1]), y + v))
            .min(thread(wave(z - p[1], p[1]), y - v))
    }

    fn polytubes(&self) -> N {
        let (y, p) = (self.y, &self.p);
        let r = y * (y * (y * (y * p[5] + p[4]) + p[3]) + p[2]) + p[1];
        (0..int32(p[0]).max(0.0) as u32)
            .map(|i| {
                let (sin, cos) = (TAU * f64::from(i) / p[0]).sin_cos();
                ((self.x - r * sin).squared() + (self.z - r * cos).squared()).sqrt()
            })
            .fold(N::constant(10_000.0), N::min) // POV-Ray's value for no tube at all
    }

    fn quantum(&self) -> N {
        let x = self.x.off_axis(self.z, POV_OFF_AXIS);
        let s = x.squared() + self.z.squared();
        let r = (s + self.y.squared()).sqrt() * 2.0;
        let c = s.sqrt().atan2(self.y).cos();
        let t = r.squared() * (r * -0.333_333_33).exp() * (c * 3.0 * c - 1.0);
        (-t.squared() + 12.0) / 10.0
    }

    fn rounded_box(&self) -> N {
        let p = &self.p;
        let beyond = |c: N, half: f64| (c.abs() - (half - p[0])).max(N::constant(0.0)).squared();
        let squares = beyond(self.x, p[1]) + beyond(self.y, p[2]) + beyond(self.z, p[3]);
        squares.sqrt() - p[0] - 1e-6 // POV-Ray's own offset
    }

    fn spiral(&self) -> N {
        let (y, p) = (self.y, &self.p);
        let rho = self.s().sqrt();
        let x = self.x.off_axis(self.z, POV_OFF_AXIS);
        let u = (rho + self.z.atan2(x) * p[0] / TAU).remainder(p[0]) - p[0] / 2.0;
        let r = self.q().sqrt();
        let turn = -superellipse(u, y, p[5]).min(r) + p[1];
        -(-r + p[2]).min(turn)
    }
}

impl Call<f64> {
    pub(super) fn hexagon(&self, along_y: bool) -> f64 {
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
}
