//! Built-in constants and functions that give a float.

use super::expressions::truth;
use super::{Evaluator, Number, Value};
use crate::diag::{SourceResult, Span, Topic};
use crate::syntax::built_in::{BuiltIn, Gives, Takes};
use crate::syntax::{Keyword, TokenKind};

/// Truncation to a signed 32-bit integer; what does not fit, and NaN, gives the smallest one.
///
/// Source: language facts, section 7.
pub(super) fn int32(value: f64) -> i32 {
    let whole = value.trunc();
    if whole >= f64::from(i32::MIN) && whole <= f64::from(i32::MAX) { whole as i32 } else { i32::MIN }
}

/// Whether an expression may start with that word.
#[inline]
pub(super) fn starts_expression(keyword: Keyword) -> bool {
    BuiltIn::in_values(keyword).is_some_and(|built_in| built_in.gives != Gives::String)
}

/// Functions of one float without a case of their own.
pub(super) fn one_argument(keyword: Keyword) -> Option<fn(f64) -> f64> {
    Some(match keyword {
        Keyword::Abs => f64::abs,
        Keyword::Ceil => f64::ceil,
        Keyword::Floor => f64::floor,
        Keyword::Cos => f64::cos,
        Keyword::Sin => f64::sin,
        Keyword::Tan => f64::tan,
        Keyword::Atan => f64::atan,
        Keyword::Sinh => f64::sinh,
        Keyword::Cosh => f64::cosh,
        Keyword::Tanh => f64::tanh,
        Keyword::Asinh => f64::asinh,
        Keyword::Acosh => f64::acosh,
        Keyword::Atanh => f64::atanh,
        Keyword::Exp => f64::exp,
        Keyword::Int => |a| f64::from(int32(a)),
        Keyword::Degrees => |a| a * 180.0 / std::f64::consts::PI,
        Keyword::Radians => |a| a * std::f64::consts::PI / 180.0,
        _ => return None,
    })
}

/// A result, or a complaint with the value to go on with if there is one.
pub(super) type Partial = Result<f64, (String, Option<f64>)>;

/// Functions of one float that are not defined everywhere.
pub(super) fn within_bounds(keyword: Keyword, a: f64) -> Partial {
    let clamped = a.clamp(-1.0, 1.0);
    let inverse = || if keyword == Keyword::Acos { clamped.acos() } else { clamped.asin() };
    match keyword {
        Keyword::Sqrt if a < 0.0 => Err((format!("square root of the negative number {a}"), None)),
        Keyword::Sqrt => Ok(a.sqrt()),
        Keyword::Ln | Keyword::Log if a <= 0.0 => Err((format!("logarithm of {a}, which is not positive"), None)),
        Keyword::Ln => Ok(a.ln()),
        Keyword::Log => Ok(a.log10()),
        _ if a.abs() > 1.0 => {
            Err((format!("{}({a}) is taken at the nearer end of [-1, 1]", keyword.word()), Some(inverse())))
        }
        _ => Ok(inverse()),
    }
}

/// Functions of two floats.
pub(super) fn two_arguments(keyword: Keyword, a: f64, b: f64) -> Partial {
    match keyword {
        Keyword::Pow if a == 0.0 && b == 0.0 => Err(("pow(0, 0) is not defined".to_owned(), None)),
        Keyword::Pow => Ok(a.powf(b)),
        Keyword::Atan2 if !truth(a) && !truth(b) => Err(("atan2(0, 0) is not defined".to_owned(), None)),
        Keyword::Atan2 => Ok(a.atan2(b)),
        Keyword::Div => Ok(f64::from(int32(a / b))),
        _ => Ok(a % b),
    }
}

/// `max`.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().reduce(|a, b| if b > a { b } else { a }).unwrap_or(0.0)
}

/// `min`.
pub(super) fn smallest(values: &[f64]) -> f64 {
    values.iter().copied().reduce(|a, b| if b < a { b } else { a }).unwrap_or(0.0)
}

/// `select(a, less, equal, greater)`; without the last one, greater is as equal.
pub(super) fn selected(values: &[f64]) -> f64 {
    let (a, last) = (values[0], values.len() - 1);
    values[if a < 0.0 {
        1
    } else if a == 0.0 {
        2
    } else {
        last
    }]
}

impl Evaluator<'_> {
    /// `rand` of something that is no stream.
    pub(super) fn no_stream<T>(&self, span: Span) -> SourceResult<T> {
        self.error(span, "there is no such random stream; seed() gives their numbers")
    }

    /// The value of a built-in constant or function call; `None`, and nothing taken, for other words.
    pub(super) fn built_in(&mut self, keyword: Keyword) -> SourceResult<Option<Number>> {
        let Some(known) = BuiltIn::in_values(keyword) else { return Ok(None) };
        if let Takes::Number(value) = known.takes {
            self.take();
            return Ok(Some(Number::scalar(value)));
        }
        if let Some(function) = one_argument(keyword) {
            self.take();
            return Ok(Some(Number::scalar(function(self.one_float()?))));
        }
        match known.gives {
            Gives::Float => {}
            Gives::Vector => return self.vector_function(keyword, known.takes).map(Some),
            Gives::String => return Ok(None),
        }
        let span = self.span();
        self.take();
        let value = match keyword {
            Keyword::Clock => self.options.clock,
            Keyword::ClockOn => f64::from(self.options.animated),
            Keyword::Version => f64::from(self.version) / 100.0,
            Keyword::Now => self.options.now,
            Keyword::Seed => {
                let seed = self.one_float()?;
                self.within(self.budget.random_stream(self.random.len()), span)?;
                self.random.seed(seed)
            }
            Keyword::Rand => {
                let stream = self.one_float()?;
                match self.random.next(stream) {
                    Some(value) => value,
                    None => return self.no_stream(span),
                }
            }
            Keyword::Acos | Keyword::Asin | Keyword::Ln | Keyword::Log | Keyword::Sqrt => {
                let argument = self.one_float()?;
                self.settle(within_bounds(keyword, argument), span)?
            }
            Keyword::Pow | Keyword::Atan2 | Keyword::Div | Keyword::Mod => {
                let [a, b] = self.floats()?;
                self.settle(two_arguments(keyword, a, b), span)?
            }
            Keyword::Max => largest(&self.listed_floats()?),
            Keyword::Min => smallest(&self.listed_floats()?),
            Keyword::BitwiseAnd => self.bitwise(|a, b| a & b)?,
            Keyword::BitwiseOr => self.bitwise(|a, b| a | b)?,
            Keyword::BitwiseXor => self.bitwise(|a, b| a ^ b)?,
            Keyword::Select => self.select()?,
            Keyword::Defined => f64::from(self.arguments(Self::defined)?),
            Keyword::Dimensions | Keyword::DimensionSize => self.array_function(keyword)?,
            Keyword::FileExists | Keyword::Strcmp | Keyword::Strlen | Keyword::Asc | Keyword::Val => {
                self.string_measure(keyword)?
            }
            Keyword::Inside => self.inside()?,
            Keyword::Vdot => {
                let [a, b] = self.vectors()?;
                a.dot(b)
            }
            Keyword::Vlength => {
                let [a] = self.vectors()?;
                a.length()
            }
            _ => return self.error(span, format!("'{}' gives no number here", keyword.word())),
        };
        Ok(Some(Number::scalar(value)))
    }

    /// The result of a function that is not defined everywhere, or its complaint.
    pub(super) fn settle(&mut self, result: Partial, span: Span) -> SourceResult<f64> {
        match result {
            Ok(value) => Ok(value),
            Err((message, None)) => self.error(span, message),
            Err((message, Some(value))) => {
                self.warn_here(Topic::Arithmetic, span, message);
                Ok(value)
            }
        }
    }

    fn bitwise(&mut self, f: impl Fn(i32, i32) -> i32) -> SourceResult<f64> {
        let values = self.listed_floats()?;
        Ok(values.into_iter().map(int32).reduce(f).map_or(0.0, f64::from))
    }

    /// `select(a, less, equal [, greater])`; only the last comma is needed.
    fn select(&mut self) -> SourceResult<f64> {
        self.arguments(|e| {
            let a = e.float()?;
            e.comma()?;
            let less = e.float()?;
            e.comma()?;
            let equal = e.float()?;
            let greater = if e.accept_punct(',')? { e.float()? } else { equal };
            Ok(selected(&[a, less, equal, greater]))
        })
    }

    /// Whether a name, or an element, has a value. Reserved words have none.
    pub(super) fn defined(&mut self) -> SourceResult<bool> {
        match self.fill(true)? {
            TokenKind::Name(name) => {
                let span = self.span();
                self.take();
                let place = self.place_after(name, span)?;
                Ok(place.is_some_and(|p| p.with(|value| value.is_some())))
            }
            TokenKind::Keyword(_) => {
                self.take();
                Ok(false)
            }
            _ => self.expected("a name"),
        }
    }

    /// `dimensions(A)` and `dimension_size(A, n)`.
    fn array_function(&mut self, keyword: Keyword) -> SourceResult<f64> {
        self.arguments(|e| {
            e.fill(false)?;
            let span = e.span();
            let value = e.place()?.get();
            let Some(Value::Array(array)) = value else { return e.error(span, "expected an array") };
            if keyword == Keyword::Dimensions {
                return Ok(array.dimensions.len() as f64);
            }
            e.comma()?;
            let n = e.float()?;
            let index = int32(n + super::expressions::EPSILON) - 1;
            Ok(usize::try_from(index).ok().and_then(|i| array.dimensions.get(i)).map_or(0.0, |size| *size as f64))
        })
    }
}
