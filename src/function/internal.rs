//! The built-in functions that `functions.inc` declares as `internal(N)`.

/// An internal function by number.
#[derive(Clone, Debug)]
pub struct Internal {
    number: u32,
}

impl Internal {
    /// The function with this number; `None` where POV-Ray has none.
    pub fn new(number: u32) -> Option<Self> {
        (number <= 78).then_some(Self { number })
    }

    /// How many parameters follow x, y and z.
    pub fn n_extra(&self) -> usize {
        match self.number {
            47 | 57 | 69 => 0,
            _ => 1,
        }
    }

    /// The value; NaN for the functions still to come.
    pub fn eval(&self, args: &[f64]) -> f64 {
        let at = |i: usize| args.get(i).copied().unwrap_or(0.0);
        let (x, y, z) = (at(0), at(1), at(2));
        match self.number {
            47 => x.hypot(z).atan2(y),
            57 => (x * x + y * y + z * z).sqrt(),
            61 => (x * x + y * y + z * z).sqrt() - at(3),
            69 => x.atan2(z),
            _ => f64::NAN,
        }
    }
}
