//! A function body as a list of operations, each on earlier results.
//!
//! The list is in static single assignment form: operation `i` writes slot `i`, equal
//! operations are stored once, calls of small functions are inlined, and constants are
//! folded, so evaluation is one pass without jumps. The same list can be run over other
//! kinds of numbers than `f64`.
//!
//! Numerics follow POV-Ray bit for bit where its folding is sound: division by a
//! constant multiplies by the reciprocal, small integer powers are products,
//! neighbouring constants of a sum are added first.

use super::{Callable, Caller, Direct, External, Function, FunctionBody, Spline, internal::Internal};
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::sync::Arc;

/// Index of an operation and of the slot that holds its result.
pub type Slot = u32;

/// Results of all operations during an evaluation.
pub type Slots = SmallVec<[f64; 64]>;

/// One step; slots refer to earlier steps.
#[derive(Clone, Debug)]
pub enum Op<T> {
    /// A number known when the function was declared.
    Constant(f64),
    /// A parameter.
    Argument(u32),
    /// A function of one number.
    Unary(Unary, Slot),
    /// A function of two numbers.
    Binary(Binary, Slot, Slot),
    /// `select(c, negative, zero, positive)`.
    Select([Slot; 4]),
    /// One component of what a pigment, pattern, spline or large function returns.
    Call {
        /// What is called.
        callee: Callee<T>,
        /// Its arguments.
        arguments: SmallVec<[Slot; 4]>,
        /// Which of the returned numbers.
        component: u8,
        /// The last call before this one returned it, too.
        repeats: bool,
    },
    /// `sum` or `prod` of a body over `from, from + 1, … <= to`.
    Fold {
        /// Product instead of sum.
        product: bool,
        /// First index.
        from: Slot,
        /// Last index.
        to: Slot,
        /// Takes the enclosing function's arguments, the indices of enclosing folds, then its own index.
        body: Arc<Program<T>>,
        /// Indices of enclosing folds and whatever else the body takes, in order.
        arguments: SmallVec<[Slot; 4]>,
    },
}

/// What a call reaches.
#[derive(Clone, Debug)]
pub enum Callee<T> {
    /// Another declared function.
    Function(Arc<Function<T>>),
    /// A pigment or pattern.
    External(Arc<T>),
    /// A spline.
    Spline(Arc<Spline>),
    /// One of the built-in functions behind `functions.inc`.
    Internal(Internal),
}

/// Functions of one number, as in C's library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Unary {
    Neg,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Abs,
    Radians,
    Degrees,
    Int,
    Floor,
    Ceil,
    Sqrt,
    Exp,
    Ln,
    Log,
}

/// Functions of two numbers; comparisons give exactly 0 or 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Pow,
    Atan2,
    Mod,
    IntDiv,
    Min,
    Max,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// A compiled function body.
#[derive(Clone, Debug)]
pub struct Program<T> {
    ops: Vec<Op<T>>,
    result: Slot,
}

/// Truncation to a signed 32-bit integer as x86 does it: -2^31 when out of range or NaN.
pub fn int32(v: f64) -> f64 {
    let truncated = v.trunc();
    if (-2_147_483_648.0..=2_147_483_647.0).contains(&truncated) { truncated + 0.0 } else { -2_147_483_648.0 }
}

impl Unary {
    /// The value at `v`; out of domain is NaN or infinite, as IEEE has it.
    pub fn apply(self, v: f64) -> f64 {
        match self {
            Self::Neg => -v,
            Self::Sin => v.sin(),
            Self::Cos => v.cos(),
            Self::Tan => v.tan(),
            Self::Asin => v.asin(),
            Self::Acos => v.acos(),
            Self::Atan => v.atan(),
            Self::Sinh => v.sinh(),
            Self::Cosh => v.cosh(),
            Self::Tanh => v.tanh(),
            Self::Asinh => v.asinh(),
            Self::Acosh => v.acosh(),
            Self::Atanh => v.atanh(),
            Self::Abs => v.abs(),
            Self::Radians => v * (std::f64::consts::PI / 180.0),
            Self::Degrees => v * (180.0 / std::f64::consts::PI),
            Self::Int => int32(v),
            Self::Floor => v.floor(),
            Self::Ceil => v.ceil(),
            Self::Sqrt => v.sqrt(),
            Self::Exp => v.exp(),
            Self::Ln => v.ln(),
            Self::Log => v.log10(),
        }
    }
}

impl Binary {
    /// The value at `(a, b)`. NaN counts as greater than everything, and `min` and `max`
    /// depend on the order of their arguments then, as in POV-Ray.
    pub fn apply(self, a: f64, b: f64) -> f64 {
        let truth = |holds: bool| f64::from(u8::from(holds));
        match self {
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::Mul => a * b,
            Self::Div => a / b,
            Self::Pow => a.powf(b),
            Self::Atan2 => a.atan2(b),
            Self::Mod => a % b,
            Self::IntDiv => int32(a / b),
            Self::Min => {
                if a < b {
                    a
                } else {
                    b
                }
            }
            Self::Max => {
                if a < b {
                    b
                } else {
                    a
                }
            }
            Self::Less => truth(a < b),
            Self::LessEqual => truth(a <= b),
            Self::Greater => 1.0 - truth(a <= b),
            Self::GreaterEqual => 1.0 - truth(a < b),
            Self::Equal => truth(a == b),
            Self::NotEqual => truth(a != b),
            Self::And => truth(a != 0.0 && b != 0.0),
            Self::Or => truth(a != 0.0 || b != 0.0),
        }
    }
}

impl<T: External> Callee<T> {
    /// Where it is, by which it is known; built-in functions are anywhere.
    fn address(&self) -> Option<usize> {
        match self {
            Self::Function(f) => Some(Arc::as_ptr(f) as usize),
            Self::External(e) => Some(Arc::as_ptr(e) as usize),
            Self::Spline(s) => Some(Arc::as_ptr(s) as usize),
            Self::Internal(_) => None,
        }
    }

    fn call(&self, arguments: &[f64], caller: &(impl Caller<T> + ?Sized)) -> [f64; 5] {
        match self {
            Self::Function(f) => f.call_by(arguments, caller),
            Self::External(e) => caller.call(e, arguments),
            Self::Spline(s) => s.at(arguments.first().copied().unwrap_or(0.0)),
            Self::Internal(i) => [i.eval(arguments), 0.0, 0.0, 0.0, 0.0],
        }
    }
}

impl<T> Program<T> {
    /// Of these operations, of which `result` gives the value.
    pub(super) fn new(ops: Vec<Op<T>>, result: Slot) -> Self {
        Self { ops, result }
    }

    /// Working memory with room for all operations.
    pub(super) fn slots(&self) -> Slots {
        Slots::with_capacity(self.ops.len())
    }

    /// The operations in order of evaluation.
    pub fn ops(&self) -> &[Op<T>] {
        &self.ops
    }

    /// Which operation gives the function's value.
    pub fn result(&self) -> Slot {
        self.result
    }
}

impl<T: Callable> Program<T> {
    /// The value for these arguments; missing ones are 0. The working memory can be used again for the next call.
    pub fn eval_in(&self, arguments: &[f64], slots: &mut Slots) -> f64 {
        self.eval_by(arguments, slots, &Direct)
    }
}

impl<T: External> Program<T> {
    /// The value for these arguments, missing ones 0, where `caller` calls what is external.
    pub(super) fn eval_by(&self, arguments: &[f64], slots: &mut Slots, caller: &(impl Caller<T> + ?Sized)) -> f64 {
        slots.resize(self.ops.len(), 0.0);
        // Once for all, where the memory is.
        let slots = &mut slots[..];
        let mut returned = [0.0; 5];
        for (i, op) in self.ops.iter().enumerate() {
            let value = match op {
                Op::Constant(c) => *c,
                Op::Argument(i) => arguments.get(*i as usize).copied().unwrap_or(0.0),
                Op::Unary(f, a) => f.apply(slots[*a as usize]),
                Op::Binary(f, a, b) => f.apply(slots[*a as usize], slots[*b as usize]),
                Op::Select([condition, negative, zero, positive]) => {
                    let c = slots[*condition as usize];
                    let chosen = if c < 0.0 {
                        negative
                    } else if c == 0.0 {
                        zero
                    } else {
                        positive
                    };
                    slots[*chosen as usize]
                }
                Op::Call { callee, arguments, component, repeats } => {
                    if !repeats {
                        let mut values = SmallVec::<[f64; 8]>::new();
                        // Growing for each saves asking for room that there is.
                        arguments.iter().for_each(|a| values.push(slots[*a as usize]));
                        returned = callee.call(&values, caller);
                    }
                    returned[usize::from(*component)]
                }
                Op::Fold { product, from, to, body, arguments } => {
                    let mut values: SmallVec<[f64; 8]> = arguments.iter().map(|a| slots[*a as usize]).collect();
                    values.push(0.0);
                    fold(*product, slots[*from as usize], slots[*to as usize], body, &mut values, caller)
                }
            };
            slots[i] = value;
        }
        slots[self.result as usize]
    }
}

/// Runs a `sum` or `prod`; the last element of `values` is the running index.
fn fold<T: External>(
    product: bool,
    from: f64,
    to: f64,
    body: &Program<T>,
    values: &mut [f64],
    caller: &(impl Caller<T> + ?Sized),
) -> f64 {
    let (mut total, mut i) = (if product { 1.0 } else { 0.0 }, from);
    while i <= to {
        if let Some(last) = values.last_mut() {
            *last = i;
        }
        let term = body.eval_by(values, &mut body.slots(), caller);
        total = if product { total * term } else { total + term };
        let next = i + 1.0;
        if next == i {
            break; // beyond 2^53 the index no longer moves
        }
        i = next;
    }
    total
}

/// Builds a [`Program`], storing equal operations once and folding constants.
#[derive(Debug)]
pub struct ProgramBuilder<T> {
    ops: Vec<Op<T>>,
    known: FxHashMap<Key, Slot>,
}

impl<T> Default for ProgramBuilder<T> {
    fn default() -> Self {
        Self { ops: Vec::new(), known: FxHashMap::default() }
    }
}

/// What makes two operations equal.
#[derive(Debug, PartialEq, Eq, Hash)]
enum Key {
    Constant(u64),
    Argument(u32),
    Unary(Unary, Slot),
    Binary(Binary, Slot, Slot),
    Select([Slot; 4]),
    External(usize, SmallVec<[Slot; 4]>, u8),
}

/// Inlining stops at this many operations, so that functions calling functions cannot explode.
const INLINE_LIMIT: usize = 4096;

impl<T: External> ProgramBuilder<T> {
    /// Ends with `result` as the value. Operations that do not reach it are dropped.
    pub fn finish(self, result: Slot) -> Program<T> {
        let mut needed = vec![false; self.ops.len()];
        needed[result as usize] = true;
        for i in (0..self.ops.len()).rev().filter(|&i| i <= result as usize) {
            if needed[i] {
                self.ops[i].each_operand(|slot| needed[slot as usize] = true);
            }
        }
        let mut moved = vec![0; self.ops.len()];
        let mut ops = Vec::new();
        let mut last_call = None;
        for (i, mut op) in self.ops.into_iter().enumerate().filter(|(i, _)| needed[*i]) {
            each_operand_mut(&mut op, |slot| *slot = moved[*slot as usize]);
            moved[i] = ops.len() as Slot;
            if let Op::Call { callee, arguments, repeats, .. } = &mut op {
                let call = (callee.address(), arguments.clone());
                *repeats = call.0.is_some() && last_call.as_ref() == Some(&call);
                last_call = Some(call);
            }
            ops.push(op);
        }
        Program { ops, result: moved[result as usize] }
    }

    fn push(&mut self, key: Option<Key>, op: Op<T>) -> Slot {
        let slot = self.ops.len() as Slot;
        if let Some(key) = key {
            let known = *self.known.entry(key).or_insert(slot);
            if known != slot {
                return known;
            }
        }
        self.ops.push(op);
        slot
    }

    /// Whether the operation is the number 0.
    pub fn is_zero(&self, slot: Slot) -> bool {
        self.constant_at(slot) == Some(0.0)
    }

    fn constant_at(&self, slot: Slot) -> Option<f64> {
        match self.ops[slot as usize] {
            Op::Constant(c) => Some(c),
            _ => None,
        }
    }

    /// A number.
    pub fn constant(&mut self, value: f64) -> Slot {
        self.push(Some(Key::Constant(value.to_bits())), Op::Constant(value))
    }

    /// Parameter number `index`.
    pub fn argument(&mut self, index: u32) -> Slot {
        self.push(Some(Key::Argument(index)), Op::Argument(index))
    }

    /// A function of one number.
    pub fn unary(&mut self, f: Unary, a: Slot) -> Slot {
        match self.constant_at(a) {
            Some(c) => self.constant(f.apply(c)),
            None => self.push(Some(Key::Unary(f, a)), Op::Unary(f, a)),
        }
    }

    /// A function of two numbers.
    pub fn binary(&mut self, f: Binary, a: Slot, b: Slot) -> Slot {
        match (f, self.constant_at(a), self.constant_at(b)) {
            (_, Some(x), Some(y)) => self.constant(f.apply(x, y)),
            (Binary::Sub, None, Some(c)) => {
                let negated = self.constant(-c);
                self.binary(Binary::Add, a, negated)
            }
            (Binary::Add, None, Some(c)) => match self.ops[a as usize] {
                Op::Binary(Binary::Add, rest, last) if self.constant_at(last).is_some() => {
                    let total = self.constant(self.constant_at(last).unwrap_or(0.0) + c);
                    self.plain(f, rest, total)
                }
                _ => self.plain(f, a, b),
            },
            (Binary::Div, None, Some(1.0)) => a,
            (Binary::Div, None, Some(c)) if c != 0.0 => {
                let reciprocal = self.constant(1.0 / c);
                self.plain(Binary::Mul, a, reciprocal)
            }
            (Binary::Pow, None, Some(n)) => self.power(a, n).unwrap_or_else(|| self.plain(f, a, b)),
            _ => self.plain(f, a, b),
        }
    }

    fn plain(&mut self, f: Binary, a: Slot, b: Slot) -> Slot {
        self.push(Some(Key::Binary(f, a, b)), Op::Binary(f, a, b))
    }

    /// Small whole powers as products, in POV-Ray's order of multiplication.
    fn power(&mut self, e: Slot, n: f64) -> Option<Slot> {
        let mut mul = |a, b| self.plain(Binary::Mul, a, b);
        Some(match n {
            0.0 => self.constant(1.0),
            1.0 => e,
            2.0 => mul(e, e),
            3.0 => {
                let e2 = mul(e, e);
                mul(e2, e)
            }
            4.0 | 5.0 | 6.0 | 7.0 | 8.0 => {
                let e2 = mul(e, e);
                let e4 = mul(e2, e2);
                match n {
                    4.0 => e4,
                    5.0 => mul(e4, e),
                    6.0 => mul(e4, e2),
                    7.0 => {
                        let e5 = mul(e4, e);
                        mul(e5, e2)
                    }
                    _ => mul(e4, e4),
                }
            }
            _ => return None,
        })
    }

    /// `select` with four arguments; with three, pass the last twice.
    pub fn select(&mut self, slots: [Slot; 4]) -> Slot {
        self.push(Some(Key::Select(slots)), Op::Select(slots))
    }

    /// A `sum` or `prod`; `arguments` are what the body takes before its index.
    pub fn fold(
        &mut self,
        product: bool,
        from: Slot,
        to: Slot,
        body: Program<T>,
        arguments: SmallVec<[Slot; 4]>,
    ) -> Slot {
        self.push(None, Op::Fold { product, from, to, body: Arc::new(body), arguments })
    }

    /// Component `component` of a call; small programs are inlined.
    pub fn call(&mut self, function: &Arc<Function<T>>, arguments: SmallVec<[Slot; 4]>, component: u8) -> Slot {
        match &function.body {
            FunctionBody::Program(p) if self.ops.len() + p.ops.len() < INLINE_LIMIT => self.inline(p, &arguments),
            FunctionBody::External(external) => {
                let key = Key::External(Arc::as_ptr(external) as usize, arguments.clone(), component);
                let callee = Callee::External(external.clone());
                self.push(Some(key), Op::Call { callee, arguments, component, repeats: false })
            }
            FunctionBody::Spline(spline) => {
                let key = Key::External(Arc::as_ptr(spline) as usize, arguments.clone(), component);
                let callee = Callee::Spline(spline.clone());
                self.push(Some(key), Op::Call { callee, arguments, component, repeats: false })
            }
            FunctionBody::Internal(internal) => {
                let callee = Callee::Internal(internal.clone());
                self.push(None, Op::Call { callee, arguments, component, repeats: false })
            }
            _ => {
                let key = Key::External(Arc::as_ptr(function) as usize, arguments.clone(), component);
                let callee = Callee::Function(function.clone());
                self.push(Some(key), Op::Call { callee, arguments, component, repeats: false })
            }
        }
    }

    fn inline(&mut self, program: &Program<T>, arguments: &[Slot]) -> Slot {
        let mut placed: Vec<Slot> = Vec::with_capacity(program.ops.len());
        for op in &program.ops {
            let at = |slot: &Slot| placed[*slot as usize];
            let slot = match op {
                Op::Constant(c) => self.constant(*c),
                Op::Argument(i) => match arguments.get(*i as usize) {
                    Some(slot) => *slot,
                    None => self.constant(0.0),
                },
                Op::Unary(f, a) => self.unary(*f, at(a)),
                Op::Binary(f, a, b) => self.as_written(*f, at(a), at(b)),
                Op::Select(slots) => self.select(slots.each_ref().map(at)),
                Op::Call { callee, arguments, component, .. } => {
                    let (callee, arguments) = (callee.clone(), arguments.iter().map(at).collect());
                    self.push(None, Op::Call { callee, arguments, component: *component, repeats: false })
                }
                Op::Fold { product, from, to, body, arguments } => {
                    let arguments = arguments.iter().map(at).collect();
                    let (from, to) = (at(from), at(to));
                    self.push(None, Op::Fold { product: *product, from, to, body: body.clone(), arguments })
                }
            };
            placed.push(slot);
        }
        placed[program.result as usize]
    }

    /// A function of two numbers that keeps its own rounding, as inlined operations do: only whole constants are folded.
    pub fn as_written(&mut self, f: Binary, a: Slot, b: Slot) -> Slot {
        match (self.constant_at(a), self.constant_at(b)) {
            (Some(x), Some(y)) => self.constant(f.apply(x, y)),
            _ => self.plain(f, a, b),
        }
    }
}

impl<T> Op<T> {
    /// Visits the slots that it reads.
    pub fn each_operand(&self, mut visit: impl FnMut(Slot)) {
        match self {
            Self::Constant(_) | Self::Argument(_) => {}
            Self::Unary(_, a) => visit(*a),
            Self::Binary(_, a, b) => [*a, *b].into_iter().for_each(visit),
            Self::Select(slots) => slots.iter().copied().for_each(visit),
            Self::Call { arguments, .. } => arguments.iter().copied().for_each(visit),
            Self::Fold { from, to, arguments, .. } => {
                visit(*from);
                visit(*to);
                arguments.iter().copied().for_each(visit);
            }
        }
    }
}

fn each_operand_mut<T>(op: &mut Op<T>, mut visit: impl FnMut(&mut Slot)) {
    match op {
        Op::Constant(_) | Op::Argument(_) => {}
        Op::Unary(_, a) => visit(a),
        Op::Binary(_, a, b) => [a, b].into_iter().for_each(visit),
        Op::Select(slots) => slots.iter_mut().for_each(visit),
        Op::Call { arguments, .. } => arguments.iter_mut().for_each(visit),
        Op::Fold { from, to, arguments, .. } => {
            visit(from);
            visit(to);
            arguments.iter_mut().for_each(visit);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Builds a body of x, y, z and checks its value.
    fn check(build: impl Fn(&mut ProgramBuilder<Counter>, [Slot; 3]) -> Slot, at: [f64; 3], expected: f64) {
        let mut builder = ProgramBuilder::default();
        let xyz = [0, 1, 2].map(|i| builder.argument(i));
        let result = build(&mut builder, xyz);
        assert_eq!(builder.finish(result).eval_in(&at, &mut Slots::new()).to_bits(), expected.to_bits());
    }

    #[test]
    fn rounding_follows_the_probes() {
        let binary = |f: Binary, n: f64| {
            move |b: &mut ProgramBuilder<Counter>, [x, _, _]: [Slot; 3]| {
                let c = b.constant(n);
                b.binary(f, x, c)
            }
        };
        check(binary(Binary::Div, 3.0), [5.0, 0.0, 0.0], 1.6666666666666665);
        check(|b, [x, y, _]| b.binary(Binary::Div, x, y), [5.0, 3.0, 0.0], 1.6666666666666667);
        check(binary(Binary::Pow, 7.0), [1.1, 0.0, 0.0], 1.948717100000001);
        check(|b, [x, y, _]| b.binary(Binary::Pow, x, y), [1.1, 7.0, 0.0], 1.9487171000000012);
        check(|b, [x, y, _]| b.binary(Binary::IntDiv, x, y), [-7.0, 2.0, 0.0], -3.0);
        check(|b, [x, _, _]| b.unary(Unary::Int, x), [3e9, 0.0, 0.0], -2147483648.0);
    }

    #[test]
    fn neighbouring_constants_of_a_sum_meet_first() {
        let sum = |b: &mut ProgramBuilder<Counter>, [x, _, _]: [Slot; 3]| {
            let c = b.constant(1e16);
            let less = b.binary(Binary::Sub, x, c);
            b.binary(Binary::Add, less, c)
        };
        check(sum, [1.0, 0.0, 0.0], 1.0);
    }

    #[test]
    fn nan_counts_as_greater() {
        let root = |f: Binary| {
            move |b: &mut ProgramBuilder<Counter>, [x, _, _]: [Slot; 3]| {
                let (r, one) = (b.unary(Unary::Sqrt, x), b.constant(1.0));
                b.binary(f, r, one)
            }
        };
        check(root(Binary::Greater), [-1.0, 0.0, 0.0], 1.0);
        check(root(Binary::Less), [-1.0, 0.0, 0.0], 0.0);
    }

    /// Counts how often it is called.
    #[derive(Clone, Debug, Default)]
    struct Counter(Arc<std::sync::atomic::AtomicU64>);

    impl External for Counter {
        fn width(&self) -> usize {
            5
        }
    }

    impl Callable for Counter {
        fn call(&self, args: &[f64]) -> [f64; 5] {
            self.0.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            [args[0], 10.0 * args[0], 100.0 * args[0], 0.0, 0.0]
        }
    }

    #[test]
    fn components_of_a_call_come_from_one() {
        let counter = Arc::new(Counter::default());
        let body = FunctionBody::External(counter.clone());
        let function = Arc::new(Function { n_parameters: 1, body });
        let mut b = ProgramBuilder::<Counter>::default();
        let [x, y] = [0, 1].map(|i| b.argument(i));
        let of = |b: &mut ProgramBuilder<Counter>, at: Slot, component: u8| {
            b.call(&function, smallvec::smallvec![at], component)
        };
        let (first, second, other) = (of(&mut b, x, 1), of(&mut b, x, 2), of(&mut b, y, 2));
        let sum = b.binary(Binary::Add, first, second);
        let sum = b.binary(Binary::Add, sum, other);
        assert_eq!(b.finish(sum).eval_in(&[1.0, 2.0], &mut Slots::new()), 310.0);
        assert_eq!(counter.0.load(std::sync::atomic::Ordering::Relaxed), 2);
    }

    #[test]
    fn equal_operations_are_stored_once() {
        let mut b = ProgramBuilder::<Counter>::default();
        let x = b.argument(0);
        let (s, t) = (b.unary(Unary::Sin, x), b.unary(Unary::Sin, x));
        let product = b.binary(Binary::Mul, s, t);
        assert_eq!(b.finish(product).ops().len(), 3);
    }
}
