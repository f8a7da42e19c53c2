//! What a function does along a stretch of a ray: bounds of its values and of its slope.
//!
//! A program is run once over the whole stretch instead of over one point. From the bounds follows
//! where it cannot fall below zero, and where it can do so only once; this is what makes a search
//! for surfaces certain.
//!
//! Source: Moore, Kearfott, Cloud, Introduction to Interval Analysis, 2009, section 6.4 (mean value
//! form); Rall, Automatic Differentiation, 1981. Where a function has a kink, slopes on both sides
//! are enclosed, and the mean value theorem holds all the same: Clarke, Optimization and Nonsmooth
//! Analysis, 1983, theorem 2.3.7.

use super::interval::Interval;
use super::number::Number;
use super::program::{Binary, Callee, Op, Program, Slot, Unary, int32};
use super::{External, Function, FunctionBody};
use smallvec::SmallVec;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Bounds of a value, and of its change for each unit of the ray's parameter.
///
/// A whole slope says that nothing is known about changes, jumps included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// Of the value.
    pub value: Interval,
    /// Of the slope.
    pub slope: Interval,
}

/// Enclosures of all operations during an evaluation.
pub type EnclosureSlots = SmallVec<[Enclosure; 32]>;

/// Terms of a `sum` or `prod` beyond which nothing is said about it.
const MOST_TERMS: f64 = 1000.0;

impl Enclosure {
    /// Nothing is known.
    pub const WHOLE: Self = Self { value: Interval::WHOLE, slope: Interval::WHOLE };

    /// A number that does not change.
    pub const fn constant(v: f64) -> Self {
        Self { value: Interval::point(v), slope: Interval::ZERO }
    }

    /// A value that may jump.
    const fn jumping(value: Interval) -> Self {
        Self { value, slope: Interval::WHOLE }
    }

    /// Through a function with these values, whose derivative is `factor`.
    #[inline]
    fn through(self, value: Interval, factor: impl FnOnce() -> Interval) -> Self {
        if self.slope == Interval::ZERO {
            Self { value, slope: Interval::ZERO }
        } else {
            Self { value, slope: factor() * self.slope }
        }
    }

    /// Either of two that meet without a jump.
    fn either(self, other: Self, value: Interval) -> Self {
        Self { value, slope: self.slope.hull(other.slope) }
    }

    /// A step function.
    fn step(self, f: impl Fn(f64) -> f64) -> Self {
        let (low, high) = (f(self.value.low), f(self.value.high));
        if low == high && self.value.is_bounded() {
            Self::constant(low)
        } else {
            Self::jumping(Interval::new(low, high))
        }
    }

    /// As 32-bit integers; out of their range truncation no longer rises.
    fn truncated(self) -> Self {
        if self.value.magnitude() < f64::from(i32::MAX) { self.step(int32) } else { Self::WHOLE }
    }

    fn one_over(factor: Interval) -> Interval {
        Interval::point(1.0) / factor
    }

    fn unary(self, f: Unary) -> Self {
        let v = self.value;
        let one = Interval::point(1.0);
        let within_one = -1.0 <= v.low && v.high <= 1.0;
        match f {
            Unary::Neg => -self,
            Unary::Sin => Number::sin(self),
            Unary::Cos => Number::cos(self),
            Unary::Tan => self.through(v.tan(), || one + v.tan().squared()),
            Unary::Asin if within_one => {
                self.through(v.rising(f64::asin), || Self::one_over((one - v.squared()).sqrt()))
            }
            Unary::Acos if within_one => {
                self.through(-v.rising(|x| -x.acos()), || -Self::one_over((one - v.squared()).sqrt()))
            }
            Unary::Asin | Unary::Acos => Self::WHOLE,
            Unary::Atan => self.through(v.rising(f64::atan), || Self::one_over(one + v.squared())),
            Unary::Sinh => self.through(v.rising(f64::sinh), || hyperbolic_cosine(v)),
            Unary::Cosh => self.through(hyperbolic_cosine(v), || v.rising(f64::sinh)),
            Unary::Tanh => self.through(v.rising(f64::tanh), || one - v.rising(f64::tanh).squared()),
            Unary::Asinh => self.through(v.rising(f64::asinh), || Self::one_over((one + v.squared()).sqrt())),
            Unary::Acosh if v.low >= 1.0 => {
                self.through(v.rising(f64::acosh), || Self::one_over((v.squared() - one).sqrt()))
            }
            Unary::Atanh if v.low > -1.0 && v.high < 1.0 => {
                self.through(v.rising(f64::atanh), || Self::one_over(one - v.squared()))
            }
            Unary::Acosh | Unary::Atanh => Self::WHOLE,
            Unary::Abs => Number::abs(self),
            Unary::Radians => self * 1f64.to_radians(),
            Unary::Degrees => self * 1f64.to_degrees(),
            Unary::Int => self.truncated(),
            Unary::Floor => self.step(f64::floor),
            Unary::Ceil => self.step(f64::ceil),
            Unary::Sqrt => Number::sqrt(self),
            Unary::Exp => Number::exp(self),
            Unary::Ln | Unary::Log if v.low <= 0.0 => Self::WHOLE,
            Unary::Ln => self.through(v.rising(f64::ln), || Self::one_over(v)),
            Unary::Log => self.through(v.rising(f64::log10), || Self::one_over(v * Interval::point(10f64.ln()))),
        }
    }

    fn binary(self, f: Binary, o: Self) -> Self {
        let (a, b) = (self.value, o.value);
        match f {
            Binary::Add => self + o,
            Binary::Sub => self - o,
            Binary::Mul => self * o,
            Binary::Div => self / o,
            Binary::Pow => self.pow(o),
            Binary::Atan2 => Number::atan2(self, o),
            Binary::Mod => b.single().filter(|d| *d != 0.0).map_or(Self::WHOLE, |d| self.remainder(d)),
            Binary::IntDiv => (self / o).truncated(),
            Binary::Min => Number::min(self, o),
            Binary::Max => Number::max(self, o),
            Binary::Less => truth(a.high < b.low, a.low >= b.high, a, b),
            Binary::LessEqual => truth(a.high <= b.low, a.low > b.high, a, b),
            Binary::Greater => truth(a.low > b.high, a.high <= b.low, a, b),
            Binary::GreaterEqual => truth(a.low >= b.high, a.high < b.low, a, b),
            Binary::Equal => truth(a.single().is_some() && a == b, a.high < b.low || b.high < a.low, a, b),
            Binary::NotEqual => truth(a.high < b.low || b.high < a.low, a.single().is_some() && a == b, a, b),
            Binary::And => {
                truth(!a.contains(0.0) && !b.contains(0.0), a == Interval::ZERO || b == Interval::ZERO, a, b)
            }
            Binary::Or => truth(!a.contains(0.0) || !b.contains(0.0), a == Interval::ZERO && b == Interval::ZERO, a, b),
        }
    }

    fn pow(self, o: Self) -> Self {
        if let Some(n) = o.value.single().filter(|_| o.slope == Interval::ZERO) {
            return self.powf(n);
        }
        let (base, exponent) = (self.value, o.value);
        let value = base.pow(exponent);
        if value.is_whole() {
            return Self::WHOLE;
        }
        let grown = o.slope * base.rising(f64::ln) + exponent * self.slope / base;
        Self { value, slope: value * grown }
    }
}

/// A comparison that is sure to hold, sure to fail, or neither.
fn truth(holds: bool, fails: bool, a: Interval, b: Interval) -> Enclosure {
    match (holds, fails) {
        _ if a.is_whole() || b.is_whole() => Enclosure::jumping(Interval::EITHER),
        (true, _) => Enclosure::constant(1.0),
        (_, true) => Enclosure::constant(0.0),
        _ => Enclosure::jumping(Interval::EITHER),
    }
}

fn hyperbolic_cosine(v: Interval) -> Interval {
    let size = v.abs().rising(f64::cosh);
    Interval { low: size.low.max(1.0), ..size }
}

impl Neg for Enclosure {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Add for Enclosure {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, slope: self.slope + o.slope }
    }
}

impl Sub for Enclosure {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, slope: self.slope - o.slope }
    }
}

impl Mul for Enclosure {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        let part = |factor: Interval, slope: Interval| if slope == Interval::ZERO { slope } else { factor * slope };
        Self { value: self.value * o.value, slope: part(o.value, self.slope) + part(self.value, o.slope) }
    }
}

impl Div for Enclosure {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        if o.slope == Interval::ZERO {
            return self.through(value, || Self::one_over(o.value));
        }
        Self { value, slope: (self.slope - value * o.slope) / o.value }
    }
}

impl Add<f64> for Enclosure {
    type Output = Self;
    #[inline]
    fn add(self, o: f64) -> Self {
        Self { value: self.value + Interval::point(o), ..self }
    }
}

impl Sub<f64> for Enclosure {
    type Output = Self;
    #[inline]
    fn sub(self, o: f64) -> Self {
        Self { value: self.value - Interval::point(o), ..self }
    }
}

impl Mul<f64> for Enclosure {
    type Output = Self;
    #[inline]
    fn mul(self, o: f64) -> Self {
        self.through(self.value * Interval::point(o), || Interval::point(o))
    }
}

impl Div<f64> for Enclosure {
    type Output = Self;
    fn div(self, o: f64) -> Self {
        self / Self::constant(o)
    }
}

impl Number for Enclosure {
    fn constant(v: f64) -> Self {
        Self::constant(v)
    }

    #[inline]
    fn squared(self) -> Self {
        self.through(self.value.squared(), || self.value * Interval::point(2.0))
    }

    fn cubed(self) -> Self {
        self.through(self.value.cubed(), || self.value.squared() * Interval::point(3.0))
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.through(root, || Interval::point(0.5) / root)
    }

    fn exp(self) -> Self {
        let power = self.value.rising(f64::exp);
        let power = Interval { low: power.low.max(0.0), ..power };
        self.through(power, || power)
    }

    fn sin(self) -> Self {
        self.through(self.value.sin(), || self.value.cos())
    }

    fn cos(self) -> Self {
        self.through(self.value.cos(), || -self.value.sin())
    }

    fn abs(self) -> Self {
        let v = self.value;
        if v.low >= 0.0 {
            self
        } else if v.high <= 0.0 {
            -self
        } else {
            self.either(-self, v.abs())
        }
    }

    fn powf(self, n: f64) -> Self {
        self.through(self.value.powf(n), || Interval::point(n) * self.value.powf(n - 1.0))
    }

    fn atan2(self, x: Self) -> Self {
        let (y, value) = (self, self.value.atan2(x.value));
        if value.is_whole() || y.value.crosses_cut(&x.value) {
            return Self::jumping(value);
        }
        let turned = x.value * y.slope - y.value * x.slope;
        Self { value, slope: turned / (x.value.squared() + y.value.squared()) }
    }

    fn min(self, o: Self) -> Self {
        let (a, b) = (self.value, o.value);
        if a.is_whole() || b.is_whole() {
            Self::WHOLE
        } else if a.high < b.low {
            self
        } else if b.high < a.low {
            o
        } else {
            self.either(o, Interval::new(a.low.min(b.low), a.high.min(b.high)))
        }
    }

    fn max(self, o: Self) -> Self {
        -(-self).min(-o)
    }

    fn remainder(self, divisor: f64) -> Self {
        let value = self.value.remainder(divisor);
        let (low, high) = (self.value.low % divisor, self.value.high % divisor);
        if self.value.stays_in_step(low, high, divisor.abs()) { Self { value, ..self } } else { Self::jumping(value) }
    }

    fn positive_remainder(self, divisor: f64) -> Self {
        let size = divisor.abs();
        let (low, high) = (self.value.low.rem_euclid(size), self.value.high.rem_euclid(size));
        if self.value.stays_in_step(low, high, size) {
            Self { value: Interval::new(low, high), ..self }
        } else {
            Self::jumping(Interval::new(0.0, size))
        }
    }

    fn off_axis(self, z: Self, step: f64) -> Self {
        if self.value.contains(0.0) && z.value.contains(0.0) {
            Self::jumping(self.value.hull(Interval::point(step)))
        } else {
            self
        }
    }
}

impl<T: External> Program<T> {
    /// Bounds over arguments within bounds; missing ones are 0.
    pub fn enclose(&self, arguments: &[Enclosure], slots: &mut EnclosureSlots) -> Enclosure {
        slots.resize(self.ops().len(), Enclosure::WHOLE);
        for (i, op) in self.ops().iter().enumerate() {
            let at = |slot: &Slot| slots[*slot as usize];
            let enclosed = match op {
                Op::Constant(c) => Enclosure::constant(*c),
                Op::Argument(i) => arguments.get(*i as usize).copied().unwrap_or(Enclosure::constant(0.0)),
                Op::Unary(f, a) => at(a).unary(*f),
                Op::Binary(Binary::Mul, a, b) if a == b => at(a).squared(),
                Op::Binary(f, a, b) => at(a).binary(*f, at(b)),
                Op::Select(slots) => select(slots.each_ref().map(at)),
                Op::Call { callee, arguments, component, .. } => {
                    let arguments: SmallVec<[Enclosure; 8]> = arguments.iter().map(at).collect();
                    match callee {
                        Callee::Internal(internal) => internal.enclose(&arguments),
                        Callee::Function(function) => function.enclose(&arguments, *component),
                        Callee::External(_) | Callee::Spline(_) => Enclosure::WHOLE,
                    }
                }
                Op::Fold { product, from, to, body, arguments } => {
                    let arguments: SmallVec<[Enclosure; 8]> = arguments.iter().map(at).collect();
                    fold(*product, [at(from), at(to)], body, arguments)
                }
            };
            slots[i] = enclosed;
        }
        slots[self.result() as usize]
    }

    /// Whether bounds are known of everything in it, so that enclosures close in on the values.
    pub fn is_enclosable(&self) -> bool {
        self.ops().iter().all(|op| match op {
            Op::Call { callee: Callee::Internal(internal), .. } => internal.is_enclosable(),
            Op::Call { callee: Callee::Function(function), .. } => function.is_enclosable(),
            Op::Call { callee: Callee::External(_) | Callee::Spline(_), .. } => false,
            Op::Fold { body, .. } => body.is_enclosable(),
            _ => true,
        })
    }
}

impl<T: External> Function<T> {
    /// Bounds of one returned number, over arguments within bounds.
    pub fn enclose(&self, arguments: &[Enclosure], component: u8) -> Enclosure {
        match &self.body {
            FunctionBody::Program(program) => program.enclose(arguments, &mut EnclosureSlots::new()),
            FunctionBody::Internal(internal) => internal.enclose(arguments),
            FunctionBody::External(_) | FunctionBody::Spline(_) => Enclosure::WHOLE,
            FunctionBody::Transform(transform) => {
                let at = |i: usize| arguments.get(i).copied().unwrap_or(Enclosure::constant(0.0));
                let (linear, i) = (transform.linear(), usize::from(component));
                if i > 2 {
                    return Enclosure::constant(0.0);
                }
                at(0) * linear.x_axis[i] + at(1) * linear.y_axis[i] + at(2) * linear.z_axis[i] + transform.origin()[i]
            }
        }
    }

    /// As [`enclose`](Self::enclose) of the first number, with working memory to use again.
    pub fn enclose_in(&self, arguments: &[Enclosure], slots: &mut EnclosureSlots) -> Enclosure {
        match &self.body {
            FunctionBody::Program(program) => program.enclose(arguments, slots),
            _ => self.enclose(arguments, 0),
        }
    }

    /// Whether enclosures close in on the values as the arguments' bounds do.
    pub fn is_enclosable(&self) -> bool {
        match &self.body {
            FunctionBody::Program(program) => program.is_enclosable(),
            FunctionBody::Internal(internal) => internal.is_enclosable(),
            FunctionBody::External(_) | FunctionBody::Spline(_) => false,
            FunctionBody::Transform(_) => true,
        }
    }
}

/// The branches that the condition allows.
fn select([condition, negative, zero, positive]: [Enclosure; 4]) -> Enclosure {
    let c = condition.value;
    if c.is_whole() {
        return Enclosure::jumping(negative.value.hull(zero.value).hull(positive.value));
    }
    let branches = [(c.low < 0.0, negative), (c.contains(0.0), zero), (c.high > 0.0, positive)];
    let mut possible = branches.into_iter().filter(|(may, _)| *may).map(|(_, branch)| branch);
    let first = possible.next().unwrap_or(Enclosure::WHOLE);
    possible
        .fold(first, |sum, branch| if branch == sum { sum } else { Enclosure::jumping(sum.value.hull(branch.value)) })
}

/// A `sum` or `prod` whose ends are known.
fn fold<T: External>(
    product: bool,
    [from, to]: [Enclosure; 2],
    body: &Program<T>,
    mut arguments: SmallVec<[Enclosure; 8]>,
) -> Enclosure {
    let (Some(from), Some(to)) = (from.value.single(), to.value.single()) else { return Enclosure::WHOLE };
    if to - from > MOST_TERMS {
        return Enclosure::WHOLE;
    }
    let mut total = Enclosure::constant(if product { 1.0 } else { 0.0 });
    let (mut i, last) = (from, arguments.len());
    arguments.push(Enclosure::constant(0.0));
    let mut slots = EnclosureSlots::new();
    while i <= to {
        arguments[last] = Enclosure::constant(i);
        let term = body.enclose(&arguments, &mut slots);
        total = if product { total * term } else { total + term };
        i += 1.0;
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::function::{Callable, Internal, ProgramBuilder};
    use crate::math::noise::NoiseGenerator;

    /// These functions call nothing external.
    #[derive(Clone, Debug)]
    enum Nothing {}

    impl External for Nothing {
        fn width(&self) -> usize {
            match *self {}
        }
    }

    impl Callable for Nothing {
        fn call(&self, _: &[f64]) -> [f64; 5] {
            match *self {}
        }
    }

    /// Random numbers in -2..2. Source: Steele, Lea, Flood, 2014 (SplitMix64).
    fn random(state: &mut u64) -> f64 {
        *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = *state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64 * 4.0 - 2.0
    }

    /// Along random stretches of rays, values between lie within the bounds, as do the slopes between
    /// neighbouring ones; short stretches have narrow bounds unless `wild`.
    fn check(name: &str, function: &Function<Nothing>, wild: bool) {
        let mut state = 7;
        let (mut narrow, mut known) = (0, 0);
        for round in 0..300 {
            let origin = [0; 3].map(|_| random(&mut state));
            let direction = [0; 3].map(|_| random(&mut state));
            let low = random(&mut state);
            let high = low + 2f64.powi(-(round % 12));
            let arguments: SmallVec<[Enclosure; 3]> = (0..3)
                .map(|i| {
                    let d = Interval::point(direction[i]);
                    Enclosure { value: Interval::point(origin[i]) + Interval::new(low, high) * d, slope: d }
                })
                .collect();
            let enclosed = function.enclose(&arguments, 0);
            let step = (high - low) / 16.0;
            let value = |i: i32| {
                let t = low + step * f64::from(i);
                function.call(&[0, 1, 2].map(|i: usize| origin[i] + direction[i] * t))[0]
            };
            for i in 0..16 {
                let (here, next) = (value(i), value(i + 1));
                assert!(
                    here.is_nan() && enclosed.value.is_whole() || enclosed.value.contains(here),
                    "{name}: {here} in {enclosed:?}"
                );
                let slope = (next - here) / step;
                // Differences of rounded values: a few units in the last place, divided by the step.
                let slack = 64.0 * f64::EPSILON * (here.abs() + next.abs() + 1.0) / step;
                let bounds = Interval { low: enclosed.slope.low - slack, high: enclosed.slope.high + slack };
                assert!(slope.is_nan() || bounds.contains(slope), "{name}: slope {slope} in {enclosed:?}");
            }
            if round % 12 == 11 {
                known += 1;
                narrow += i32::from(enclosed.value.high - enclosed.value.low < 0.5 && enclosed.slope.is_bounded());
            }
        }
        assert!(wild || narrow * 10 > known * 8, "{name}: only {narrow} of {known} short stretches have narrow bounds");
    }

    #[test]
    fn internal_functions_stay_within_their_bounds() {
        for number in (0..=78).filter(|n| *n != 77) {
            let internal = Internal::new(number, NoiseGenerator::Corrected).expect("known number");
            let wild = !internal.is_enclosable();
            let mut b = ProgramBuilder::default();
            let mut arguments: SmallVec<[Slot; 4]> = (0..3).map(|i| b.argument(i)).collect();
            let parameters = [0.9, 0.7, 0.8, 0.6, 1.2, 0.4, 1.3, 0.5, 1.1, 0.3];
            arguments.extend(parameters[..internal.n_extra()].iter().map(|p| b.constant(*p)));
            let callee = Function { n_parameters: 3, body: FunctionBody::Internal(internal) };
            let result = b.call(&std::sync::Arc::new(callee), arguments, 0);
            let function = Function { n_parameters: 3, body: FunctionBody::Program(b.finish(result)) };
            check(&format!("internal({number})"), &function, wild);
        }
    }

    #[test]
    fn operators_stay_within_their_bounds() {
        use Unary as U;
        let unary = [
            U::Neg,
            U::Sin,
            U::Cos,
            U::Tan,
            U::Asin,
            U::Acos,
            U::Atan,
            U::Sinh,
            U::Cosh,
            U::Tanh,
            U::Asinh,
            U::Acosh,
            U::Atanh,
            U::Abs,
            U::Radians,
            U::Degrees,
            U::Int,
            U::Floor,
            U::Ceil,
            U::Sqrt,
            U::Exp,
            U::Ln,
            U::Log,
        ];
        let build = |f: &dyn Fn(&mut ProgramBuilder<Nothing>, [Slot; 3]) -> Slot| {
            let mut b = ProgramBuilder::default();
            let xyz = [0, 1, 2].map(|i| b.argument(i));
            let result = f(&mut b, xyz);
            Function { n_parameters: 3, body: FunctionBody::Program(b.finish(result)) }
        };
        for f in unary {
            check(&format!("{f:?}"), &build(&|b, [x, ..]| b.unary(f, x)), true);
        }
        use Binary as B;
        let binary = [
            B::Add,
            B::Sub,
            B::Mul,
            B::Div,
            B::Pow,
            B::Atan2,
            B::Mod,
            B::IntDiv,
            B::Min,
            B::Max,
            B::Less,
            B::LessEqual,
            B::Greater,
            B::GreaterEqual,
            B::Equal,
            B::NotEqual,
            B::And,
            B::Or,
        ];
        for f in binary {
            check(&format!("{f:?}"), &build(&|b, [x, y, _]| b.binary(f, x, y)), true);
            let constant = |b: &mut ProgramBuilder<Nothing>, [x, ..]: [Slot; 3]| {
                let c = b.constant(1.7);
                b.binary(f, x, c)
            };
            check(&format!("{f:?} 1.7"), &build(&constant), true);
        }
        check("select", &build(&|b, [x, y, z]| b.select([x, y, z, x])), true);
        check(
            "x y - z x",
            &build(&|b, [x, y, z]| {
                let (xy, zx) = (b.binary(B::Mul, x, y), b.binary(B::Mul, z, x));
                b.binary(B::Sub, xy, zx)
            }),
            false,
        );
    }
}
