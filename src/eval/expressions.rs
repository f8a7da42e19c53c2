//! Float, vector and colour expressions, evaluated as their tokens arrive.
//!
//! A place expects a certain width (1 for a float, 3 for a vector, …). Operands widen to
//! it, and an operator widens its narrower side: a single number is replicated, anything
//! else is filled up with zeros. Inside parentheses the width starts at 1 again.
//!
//! Two strengths exist: `arithmetic` knows `+ - * /`, signs and components; `full` adds
//! comparisons, `& |` and `?:`. Which place takes which: language facts, section 5.

use super::{Evaluator, Number, Value};
use crate::diag::{Diagnostic, SourceResult, Span, Topic};
use crate::math::{DVec2, DVec3, DVec4};
use crate::stack::roomy;
use crate::syntax::TokenKind;
use crate::syntax::expression::{Build, Choose, Language, Operands, Operator, Strength, chain, expression, go_on};
use smallvec::SmallVec;

/// POV-Ray's tolerance of comparisons and truth. Source: language facts, section 4.
pub(super) const EPSILON: f64 = 1e-10;

/// Whether a condition holds; NaN does not.
pub(super) fn truth(value: f64) -> bool {
    value.abs() > EPSILON
}

impl Number {
    /// Componentwise, at the width of the wider side.
    pub(super) fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        if self.n == 1 && other.n == 1 {
            return Self::scalar(f(self.v[0], other.v[0]));
        }
        let n = self.n.max(other.n);
        let (a, b) = (self.widened(n), other.widened(n));
        let mut v = [0.0; 5];
        for ((out, a), b) in v[..n as usize].iter_mut().zip(a.v).zip(b.v) {
            *out = f(a, b);
        }
        Self { n, v }
    }

    /// Componentwise, for operations that give 0 for two zeros: what lies past the width stays 0.
    #[inline]
    pub(super) fn zip_all(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let n = self.n.max(other.n);
        let (a, b) = (self.widened(n), other.widened(n));
        let at = |i: usize| f(a.v[i], b.v[i]);
        Self { n, v: [at(0), at(1), at(2), at(3), at(4)] }
    }

    /// Whether a component is exactly 0.
    pub(super) fn has_zero(&self) -> bool {
        self.v[..usize::from(self.n)].contains(&0.0)
    }

    /// Componentwise.
    pub(super) fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
        for c in &mut self.v[..self.n as usize] {
            *c = f(*c);
        }
        self
    }
}

#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// A float.
    pub fn float(&mut self) -> SourceResult<f64> {
        self.fill(false)?;
        let span = self.span();
        let value = self.arithmetic(1)?;
        self.want_float(value, span)
    }

    /// A float, truncated towards zero.
    pub fn integer(&mut self) -> SourceResult<i64> {
        self.float().map(|f| f as i64)
    }

    /// A vector of two components.
    pub fn vector2(&mut self) -> SourceResult<DVec2> {
        let value = self.number_of_width(2)?;
        Ok(DVec2::new(value.v[0], value.v[1]))
    }

    /// A vector of three components; a float is replicated, a missing third one is 0.
    #[inline]
    pub fn vector(&mut self) -> SourceResult<DVec3> {
        self.number_of_width(3).map(|value| value.xyz())
    }

    /// A vector of four components.
    pub fn vector4(&mut self) -> SourceResult<DVec4> {
        let v = self.number_of_width(4)?.v;
        Ok(DVec4::new(v[0], v[1], v[2], v[3]))
    }

    /// Any number of components, as a declaration takes it.
    pub fn any_expression(&mut self) -> SourceResult<Number> {
        self.arithmetic(1)
    }

    fn number_of_width(&mut self, n: u8) -> SourceResult<Number> {
        self.fill(false)?;
        let span = self.span();
        let value = self.arithmetic(n)?;
        if value.n > n {
            let found = value.n;
            return self.error(span, format!("expected a vector of {n} components, found one of {found}"));
        }
        Ok(value)
    }

    pub(super) fn want_float(&self, value: Number, span: Span) -> SourceResult<f64> {
        match value.n {
            1 => Ok(value.v[0]),
            5 => self.error(span, "expected a float, found a colour"),
            n => self.error(span, format!("expected a float, found a vector of {n} components")),
        }
    }

    /// A float in which comparisons and logic are allowed.
    pub(super) fn full_float(&mut self) -> SourceResult<f64> {
        self.fill(false)?;
        let span = self.span();
        let value = self.full(1)?;
        self.want_float(value, span)
    }

    /// `( full expression )`, as a condition.
    pub(super) fn condition(&mut self) -> SourceResult<f64> {
        self.bracketed('(', "before the condition", ')', "behind the condition", Self::full_float)
    }

    /// Something between brackets, where directives and macros work everywhere.
    pub(super) fn bracketed<T>(
        &mut self,
        open: char,
        why_open: &str,
        close: char,
        why_close: &str,
        read: impl FnOnce(&mut Self) -> SourceResult<T>,
    ) -> SourceResult<T> {
        let bare = std::mem::replace(&mut self.bare, false);
        self.parentheses += 1;
        if self.fill(false)? != TokenKind::Punct(open) {
            return self.expected(&format!("'{open}' {why_open}"));
        }
        self.take();
        self.deeper()?;
        let value = roomy(|| read(self))?;
        if self.fill(false)? != TokenKind::Punct(close) {
            return self.expected(&format!("'{close}' {why_close}"));
        }
        self.take();
        self.budget.shallower();
        self.parentheses -= 1;
        self.bare = bare;
        Ok(value)
    }

    /// With comparisons, logic and choice.
    pub(super) fn full(&mut self, n: u8) -> SourceResult<Number> {
        if let Some(value) = self.formula(true, n)? {
            return Ok(value);
        }
        expression(self, n)
    }

    fn string_comparison(&mut self) -> SourceResult<f64> {
        let left = self.string()?;
        let relation = self.operator()?.filter(|operator| operator.operands() == Operands::Ordered);
        let Some(relation) = relation else {
            return self.expected("a comparison behind the string");
        };
        self.take();
        let right = self.string()?;
        let order = left.encode_utf16().cmp(right.encode_utf16());
        Ok(relation.apply(f64::from(order as i8), 0.0))
    }

    /// Signs, components, `* / + -`.
    #[inline]
    pub(super) fn arithmetic(&mut self, n: u8) -> SourceResult<Number> {
        if let Some(value) = self.lone_literal()? {
            return Ok(value.widened(n));
        }
        if let Some(value) = self.formula(false, n)? {
            return Ok(value);
        }
        self.arithmetic_by_tokens(n)
    }

    pub(super) fn arithmetic_by_tokens(&mut self, n: u8) -> SourceResult<Number> {
        chain(self, Strength::Sum, n)
    }

    /// Goes on with an expression whose first operand was already read.
    pub(super) fn arithmetic_from(&mut self, operand: Number, n: u8) -> SourceResult<Number> {
        let mut value = self.component(operand)?.widened(n);
        go_on(self, &mut value, Strength::Sum, Strength::Product, n)?;
        Ok(value)
    }

    /// A component was divided by an exact zero.
    pub(super) fn warn_division(&mut self, span: Span) {
        self.warn_here(Topic::Arithmetic, span, "division by zero; the result is taken to be infinite");
    }

    /// Whether the next token can start a float, vector or colour expression without a colour word.
    pub fn starts_expression(&mut self) -> SourceResult<bool> {
        Ok(match self.fill(false)? {
            TokenKind::Number(_) | TokenKind::Vector => true,
            TokenKind::Punct(c) => matches!(c, '(' | '<' | '+' | '-' | '!'),
            TokenKind::Keyword(keyword) => super::float_functions::starts_expression(keyword),
            TokenKind::Name(name) => self.names.stands_for(name, gives_number),
            _ => false,
        })
    }

    /// `hollow`, `hollow on`, `hollow F`: on unless a float says otherwise.
    pub fn optional_bool(&mut self) -> SourceResult<bool> {
        Ok(!self.starts_expression()? || self.float()? > 0.0)
    }
}

impl Build for Evaluator<'_> {
    type Built = Number;
    /// The width that is expected.
    type Place = u8;
    type Mark = Span;
    type Stop = Vec<Diagnostic>;
    const LANGUAGE: Language = Language::Values;

    #[inline]
    fn operator(&mut self) -> SourceResult<Option<Operator>> {
        let operator = Operator::of(self.fill(self.bare)?);
        // Below version 1.5 even arithmetic stands in parentheses.
        let hidden = |operator: &Operator| {
            self.version < 150 && self.parentheses == 0 && operator.operands() == Operands::Numbers
        };
        Ok(operator.filter(|operator| !hidden(operator)))
    }

    #[inline]
    fn take_operator(&mut self) -> Span {
        let span = self.span();
        self.take();
        span
    }

    /// An operand with its signs and component, widened.
    fn operand(&mut self, n: u8) -> SourceResult<Number> {
        let mut signs = SmallVec::<[u8; 8]>::new();
        while let TokenKind::Punct(sign @ ('-' | '+' | '!')) = self.fill(false)? {
            self.take();
            signs.push(sign as u8);
        }
        let operand = self.bare_operand()?;
        let mut value = self.component(operand)?.widened(n);
        while let Some(sign) = signs.pop() {
            value = match sign {
                b'-' => value.map(|c| -c),
                b'!' => value.map(|c| f64::from(c.abs() <= EPSILON)),
                _ => value,
            };
        }
        Ok(value)
    }

    fn comparison(&mut self, n: u8) -> SourceResult<Option<Number>> {
        if !self.starts_string()? {
            return Ok(None);
        }
        self.string_comparison().map(|truth| Some(Number::scalar(truth).widened(n)))
    }

    #[inline]
    fn beside(n: u8, left: &Number) -> u8 {
        n.max(left.n)
    }

    #[inline]
    fn combine(&mut self, operator: Operator, left: &mut Number, right: Number, span: Span) -> SourceResult<()> {
        // By an exact zero division gives plus infinity, whatever the numerator.
        if operator == Operator::Divide && right.widened(left.n).has_zero() {
            self.warn_division(span);
        }
        *left = operator.combine(*left, right);
        Ok(())
    }
}

impl Choose for Evaluator<'_> {
    fn start(&mut self) -> SourceResult<Span> {
        self.fill(false)?;
        Ok(self.span())
    }

    fn accept_question(&mut self) -> SourceResult<bool> {
        let found = self.fill(self.bare)? == TokenKind::Punct('?');
        if found {
            self.take();
        }
        Ok(found)
    }

    fn choose(&mut self, condition: Number, start: Span, n: u8) -> SourceResult<Number> {
        if condition.n > n {
            return self.error(start, "the condition before '?' must be a float");
        }
        self.deeper()?;
        let yes = roomy(|| self.full(n))?;
        if self.fill(self.bare)? != TokenKind::Punct(':') {
            return self.expected("':' of the choice that '?' began");
        }
        self.take();
        let no = roomy(|| self.full(n))?;
        self.budget.shallower();
        Ok(if truth(condition.v[0]) { yes } else { no })
    }
}

/// Whether a value is a number or something that gives one.
pub(super) fn gives_number(value: &Value) -> bool {
    matches!(value, Value::Float(_) | Value::Vector(_) | Value::Function(_) | Value::Spline(_))
}
