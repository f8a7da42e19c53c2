//! Surfaces of one polynomial, scaled and clamped, and plane curves that may be revolved.

use super::{Call, Number, square};

impl<N: Number> Call<N> {
    /// The plane point of a curve that may be revolved about y: switch, offset and angle start at `p[i]`.
    fn revolved(&self, i: usize) -> (N, N) {
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
    pub(super) fn plane_curve(&self, number: u32) -> N {
        let p = &self.p;
        let first = match number {
            0..=3 => 2,
            50 | 67 => 4,
            _ => 3,
        };
        let (x, y) = self.revolved(first);
        let (x2, y2) = (x.squared(), y.squared());
        let field = match number {
            0 => x.abs() * x2 - x2 + y2,
            1 => -(x2 * 2.0 * x2 - x2 * 3.0 * y + y2 - y * 2.0 * y2 + y2.squared()),
            2 => -(x2.squared() + x2 * y2 - x2 * 2.0 * y - x * y2 + y2),
            3 => -((x2 + y2).squared() + x2 * 3.0 * y - y * y2),
            15 => -(x2 * (x2 - square(p[1])) - y2 * (y2 - square(p[2]))),
            21 => -(y2 * (x * (p[2] - 4.0 * p[1]) + 1.0) + x2 * (1.0 + p[2])),
            34 => -(y2 - x2 * square(p[2]) * x2 + x2 * (p[1] * p[2].cubed())),
            39 => -(y2 - x2 * (square(p[1]) * square(p[2])) + x2 * square(p[2]) * x2),
            50 => -(y2 - x * (p[1] * square(p[3])) * x2 - x2 * (p[2] * square(p[3])) * x2),
            67 => -((-x + p[2]) * y2 - x2 * square(p[3]) * (x + p[1])),
            _ => y * square(p[1]) + x2 * y - p[2],
        };
        let limit = if number <= 3 { p[1] } else { 10.0 };
        let sign = if number == 75 { -1.0 } else { 1.0 };
        N::constant(limit).min((field * (p[0] * sign)).max(N::constant(-limit)))
    }

    /// Polynomial surfaces: `p[0]` times the field, kept between -10 and 10.
    pub(super) fn clamped(&self, number: u32) -> N {
        let field = if matches!(number, 8 | 16 | 31 | 35 | 46 | 71) {
            self.long_polynomial(number)
        } else {
            self.polynomial(number)
        };
        N::constant(10.0).min((field * self.p[0]).max(N::constant(-10.0)))
    }

    fn polynomial(&self, number: u32) -> N {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let (x2, y2, z2, q, s) = (x.squared(), y.squared(), z.squared(), self.q(), self.s());
        match number {
            4 => y2 * (-s + square(p[1])) - (s + y * (2.0 * p[1]) - square(p[1])).squared(),
            5 => s * p[1] * y - q.squared(),
            11 => x2 * z2 - y,
            12 => -(x * x2 - y * y2 - z),
            13 | 43 => {
                z2 * x2 - z2.squared() - z * 2.0 * x2 + z * 2.0 * z2 + x2
                    - z2
                    - (x2 - z).squared()
                    - y2.squared()
                    - x2 * 2.0 * y2
                    - y2 * z2
                    + y2 * 2.0 * z
                    + y2
            }
            14 => -(x2.squared() + x2 * 2.0 * z2 - x2 * 0.36 - y2.squared() + y2 * 0.25 + z2.squared()),
            20 => (y2 + z2) * (x * (p[2] - 4.0 * p[1]) + 1.0) + x2 * (1.0 + p[2]),
            22 => x2 * 0.5 * x2 * x + x2 * 0.5 * x2 - y2 - z2,
            23 => -((x2 * 2.0 + y2 + z2 - 1.0).cubed() - x2 * 0.1 * z * z2 - y2 * z * z2),
            30 => -((q - 13.0).cubed() * 4.0 + (x2 * 3.0 + y2 - z2 * 4.0 - 12.0).squared() * 27.0),
            33 => -(y2 + z2 - x2 * square(p[2]) * x2 + x2 * (square(p[1]) * square(p[2]))),
            36 => -(x2.squared() + y2.squared() + z2.squared() - q - x2 * y2 - x2 * z2 - y2 * z2 + 1.0),
            37 => {
                let mixed = (x2 * y2 + x2 * z2 + y2 * z2) * p[2];
                -(x2.squared() + y2.squared() + z2.squared() + q * p[1] + mixed + x * p[3] * y * z - 1.0)
            }
            38 => -(x2.squared() - x2 + y2 + z2),
            41 => -(x2 * 4.0 * q - y2 * (-y2 + 1.0 - z2)),
            42 => -(y * y2 + z * z2 - y * 6.0 * z),
            44 => -((q + square(p[1])).squared() - s * (p[3] * square(p[1])) - square(p[2])),
            45 => y - s,
            48 => x2.squared() + y2.squared() + z2.squared() - q,
            49 => x2.squared() - x * x2 + y2 + z2,
            54 => -(x2.squared() + z2.squared() - y),
            55 => -(x2.squared() - z2.squared() - y),
            56 => -(s * y2 + s * square(p[2]) - square(p[1]) * square(p[2])),
            65 => -(x2 * y2 + x2 * z2 + y2 * z2 + x * y * z),
            66 => -((-x + p[2]) * (y2 + z2) - x2 * square(p[3]) * (x + p[1])),
            72 => {
                let t = y2 + z2;
                -((x2.squared() + t.squared()) * 4.0 + x2 * 17.0 * t - q * 20.0 + 17.0)
            }
            73 => -(x2 - y * z2),
            _ => -((y - 1.0) * p[1] + s * y),
        }
    }

    fn long_polynomial(&self, number: u32) -> N {
        let (x, y, z, p) = (self.x, self.y, self.z, &self.p);
        let (x2, y2, z2, q, s) = (x.squared(), y.squared(), z.squared(), self.q(), self.s());
        let (a, b) = (square(p[1]), square(p[2]));
        let quartic = || x2.squared() + x2 * 2.0 * y2;
        match number {
            8 => self.boy_surface(),
            16 => self.dupin_cyclid(),
            31 => {
                -(quartic() - x2 * 2.0 * z2 - x2 * (2.0 * (a + b)) + y2.squared() - y2 * 2.0 * z2
                    + y2 * (2.0 * (a - b))
                    + z2.squared()
                    + z2 * (2.0 * (a + b))
                    + square(a - b))
            }
            35 => {
                let m = q - y * 2.0 - 1.0;
                -((q + y * 2.0 - 1.0) * (m.squared() - z2 * 8.0) + x * 16.0 * z * m)
            }
            46 => {
                -(quartic() - x2 * 2.0 * z - x2 * (a + b) + y2.squared() - y2 * 2.0 * z
                    + y2 * (a - b)
                    + z2
                    + z * (a + b)
                    + square(a - b))
            }
            _ => -(q.squared() - s * (2.0 * (a + b)) + y2 * (2.0 * (a - b)) + square(a - b)),
        }
    }

    fn boy_surface(&self) -> N {
        let (x, y, z) = (self.x, self.y, self.z);
        let (x2, y2, z2) = (x.squared(), y.squared(), z.squared());
        let (w, t, r2) = (-z + 1.0, x2 + y2, 2.0_f64.sqrt());
        let inner = t * 27.0 * t - z2 * 24.0 * t + y * (36.0 * r2) * z * (y2 - x2 * 3.0) + z2 * 4.0 * z2;
        let outer = t * -81.0 * t - z2 * 72.0 * t + x * (108.0 * r2) * z * (x2 - y2 * 3.0) + z2 * 4.0 * z2;
        let sum = w.cubed() * 64.0 * z.cubed() - w * 48.0 * w * z2 * (t * 3.0 + z2 * 2.0)
            + w * 12.0 * z * inner
            + (t * 9.0 - z2 * 2.0) * outer;
        sum * self.p[1]
    }

    fn dupin_cyclid(&self) -> N {
        let (x, y, q) = (self.x, self.y, self.q());
        let [_, a, b, c, d, k, ..] = self.p;
        let kappa = k * k;
        let mu = b * b - d * d - square(c + a);
        let nu = b * b - d * d - square(c - a);
        let line = x * c + y * d;
        let spread = (line * 2.0 - kappa) * (a * a + b * b - c * c - d * d) - y * (4.0 * d * b * b);
        -(q * (mu * nu) * q
            + q * (2.0 * kappa) * spread
            + line * (4.0 * kappa * kappa) * (line - kappa)
            + y.squared() * (4.0 * kappa * kappa * a * a)
            + square(kappa * kappa))
    }
}

impl Call<f64> {
    /// Two pieces that do not meet, so that only its values are known.
    pub(super) fn enneper(&self) -> f64 {
        let (x2, y2, z) = (square(self.x), square(self.y), self.z);
        // Kept from dividing by 0; the square below keeps the true z, as in POV-Ray.
        let zeta = if z.abs() < 0.2 { 0.2 } else { z };
        let a = (y2 - x2) / (2.0 * zeta) + 2.0 * square(z) / 9.0;
        let b = (y2 - x2) / (4.0 * zeta);
        10.0_f64.min((-self.p[0] * (a.cubed() - 6.0 * square(b))).max(-10.0))
    }
}
