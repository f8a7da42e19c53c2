//! Rounding to whole numbers, and where what is lost goes.
//!
//! Source: camera and image facts, section 4.2.

use super::{Curve, Dither, Encoding};

/// Rounds pixel by pixel, row by row, and keeps what was lost for those that it goes to.
pub(super) struct Spread {
    curve: Curve,
    dither: Option<Dither>,
    max: f32,
    /// For the row at hand and the one below.
    rows: [Vec<[f32; 4]>; 2],
}

/// Thresholds in steps of a square of n pixels, the first index being the column.
const ORDER_2: [[u8; 2]; 2] = [[1, 3], [4, 2]];
const ORDER_3: [[u8; 3]; 3] = [[3, 7, 4], [6, 1, 9], [2, 8, 5]];
const ORDER_4: [[u8; 4]; 4] = [[1, 9, 3, 11], [13, 5, 15, 7], [4, 12, 2, 10], [16, 8, 14, 6]];

impl Spread {
    /// For a picture so many pixels wide, and values from 0 to `max`.
    pub(super) fn new(encoding: &Encoding, max: u16, width: usize) -> Self {
        let row = vec![[0.0; 4]; if encoding.dither.is_some() { width } else { 0 }];
        Self { curve: encoding.curve, dither: encoding.dither, max: f32::from(max), rows: [row.clone(), row] }
    }

    /// The whole numbers of a pixel at a place: light by the curve, alpha, the fourth, as it is.
    pub(super) fn rounded(&mut self, light: [f32; 4], [x, y]: [usize; 2]) -> [u16; 4] {
        match self.dither {
            None => self.nearest(light, 0.0),
            Some(Dither::Ordered(n)) => self.nearest(light, threshold(n, [x, y])),
            Some(method) => {
                let arrived = self.arrived(x, method);
                let light = std::array::from_fn(|i| light[i] + arrived[i]);
                let values = self.nearest(light, 0.0);
                let lost = std::array::from_fn(|i| {
                    let lost = light[i].clamp(0.0, 1.0) - self.light_of(values[i], i);
                    // What is no number spreads nothing.
                    if lost.is_finite() { lost } else { 0.0 }
                });
                self.pass_on(lost, x, method);
                values
            }
        }
    }

    /// NaN becomes 0: a comparison with it is false.
    fn nearest(&self, light: [f32; 4], shift: f32) -> [u16; 4] {
        std::array::from_fn(|i| {
            let value = if i == 3 { light[i] } else { self.curve.encode(light[i]) };
            let steps = if value > 0.0 { (value.min(1.0) * self.max + 0.5 + shift).floor() } else { 0.0 };
            steps.clamp(0.0, self.max) as u16
        })
    }

    fn light_of(&self, value: u16, channel: usize) -> f32 {
        let value = f32::from(value) / self.max;
        if channel == 3 { value } else { self.curve.decode(value) }
    }

    /// What other pixels have passed on to this one. As in POV-Ray the rows change places only behind the first
    /// pixel, which therefore gets what the one above it has got.
    fn arrived(&mut self, x: usize, method: Dither) -> [f32; 4] {
        let arrived = self.rows[0][if method == Dither::Next { 0 } else { x }];
        if x == 0 && method != Dither::Next {
            self.rows.swap(0, 1);
            self.rows[1].fill([0.0; 4]);
        }
        arrived
    }

    fn pass_on(&mut self, lost: [f32; 4], x: usize, method: Dither) {
        if method == Dither::Next {
            self.rows[0][0] = lost;
        }
        for &(row, right, share) in shares(method) {
            if let Some(to) = x.checked_add_signed(right).and_then(|to| self.rows[row].get_mut(to)) {
                to.iter_mut().zip(lost).for_each(|(to, lost)| *to += lost * share);
            }
        }
    }
}

/// Rows below, columns to the right, part of what is lost.
fn shares(method: Dither) -> &'static [(usize, isize, f32)] {
    match method {
        Dither::FloydSteinberg => &[(0, 1, 7.0 / 16.0), (1, -1, 3.0 / 16.0), (1, 0, 5.0 / 16.0), (1, 1, 1.0 / 16.0)],
        Dither::Simple => &[(0, 1, 0.5), (1, 0, 0.25), (1, 1, 0.25)],
        Dither::Next | Dither::Ordered(_) => &[],
    }
}

/// Of a pixel in a square of n, in steps of the values.
fn threshold(n: u8, [x, y]: [usize; 2]) -> f32 {
    let side = usize::from(n);
    let order = match n {
        2 => ORDER_2[x % side][y % side],
        3 => ORDER_3[x % side][y % side],
        _ => ORDER_4[x % side][y % side],
    };
    f32::from(order) / f32::from(n * n) - 0.5
}
