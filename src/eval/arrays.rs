//! Arrays and what a name with indices refers to.

use super::declarations::Argument;
use super::expressions::EPSILON;
use super::{Array, Evaluator, Place, Value};
use crate::diag::{SourceResult, Span};
use crate::syntax::{Symbol, TokenKind};
use smallvec::SmallVec;
use std::rc::Rc;

/// Most dimensions of an array.
const MAX_DIMENSIONS: usize = 5;

impl Array {
    /// The flat index of an element.
    pub(super) fn flat_index(&self, indices: &[f64]) -> Result<usize, String> {
        let mut flat = 0;
        for (index, size) in indices.iter().zip(&self.dimensions) {
            flat = flat * size + whole_index(*index, *size)?;
        }
        Ok(flat)
    }
}

/// The element that an index means in a dimension of that size.
fn whole_index(index: f64, size: usize) -> Result<usize, String> {
    let whole = (index + EPSILON).trunc();
    // Down to -1 the truncation gives zero, but only a rounding error may lie below it.
    if index < -EPSILON || whole.is_nan() || whole >= size as f64 {
        return Err(format!("index {index} is outside of an array of size {size}"));
    }
    Ok(whole as usize)
}

impl Evaluator<'_> {
    /// Takes a declared name with its indices.
    pub(super) fn place(&mut self) -> SourceResult<Place> {
        let TokenKind::Name(name) = self.fill(false)? else { return self.expected("a declared name") };
        let span = self.span();
        self.names.note_use(name);
        self.note_use(name);
        self.take();
        match self.place_after(name, span)? {
            Some(place) => Ok(place),
            None => self.undeclared(name, span),
        }
    }

    /// What a name, which was just taken, and the indices behind it refer to.
    pub(super) fn place_after(&mut self, name: Symbol, span: Span) -> SourceResult<Option<Place>> {
        let Some(place) = self.names.find(name) else { return Ok(None) };
        let place = place.clone();
        self.indexed(place, span).map(Some)
    }

    /// Goes from an array to its element as long as indices follow.
    pub(super) fn indexed(&mut self, mut place: Place, span: Span) -> SourceResult<Place> {
        /// What stands at a place, as far as indices are concerned.
        enum Found {
            Array(SmallVec<[usize; MAX_DIMENSIONS]>),
            Unset,
            Other,
        }
        loop {
            let found = place.with(|value| match value {
                Some(Value::Array(array)) => Found::Array(SmallVec::from_slice(&array.dimensions)),
                Some(_) => Found::Other,
                None => Found::Unset,
            });
            let sizes = match found {
                Found::Other => return Ok(place),
                _ if self.fill(true)? != TokenKind::Punct('[') => return Ok(place),
                Found::Unset => return self.error(span, "this array element was never set"),
                Found::Array(sizes) => sizes,
            };
            let mut flat = 0;
            for size in sizes {
                flat = flat * size + self.index(size)?;
            }
            place.path.push(flat as u32);
        }
    }

    /// `[ index ]` into a dimension of that size.
    fn index(&mut self, size: usize) -> SourceResult<usize> {
        let span = self.span();
        let index = self.bracketed('[', "before an index", ']', "behind the index", Self::float)?;
        match whole_index(index, size) {
            Ok(index) => Ok(index),
            Err(message) => self.error(span, message),
        }
    }

    /// `array [n] … { initialiser }`, after its keyword.
    pub(super) fn array(&mut self) -> SourceResult<Array> {
        let span = self.span();
        let bare = std::mem::replace(&mut self.bare, false);
        let (mut dimensions, mut total) = (Vec::new(), 1_usize);
        while self.fill(true)? == TokenKind::Punct('[') {
            let size = self.bracketed('[', "before a size", ']', "behind the size", Self::float)?;
            let whole = (size + EPSILON).trunc();
            if whole.is_nan() || whole < 1.0 {
                return self.error(span, format!("an array cannot have the size {size}"));
            }
            total = total.saturating_mul(whole as usize);
            dimensions.push(whole as usize);
            self.within(self.budget.elements(total, "array", "elements"), span)?;
        }
        if dimensions.is_empty() || dimensions.len() > MAX_DIMENSIONS {
            return self.error(span, "an array has one to five dimensions, each in square brackets");
        }
        let mut array = Array::new(dimensions, Vec::new());
        if self.fill(true)? == TokenKind::Punct('{') {
            self.initialise(&mut array, 0)?;
        } else {
            array.elements = vec![None; total];
        }
        self.bare = bare;
        Ok(array)
    }

    /// One level of braces of an initialiser. Directives and macros work only inside values.
    fn initialise(&mut self, array: &mut Array, depth: usize) -> SourceResult<()> {
        if self.fill(true)? != TokenKind::Punct('{') {
            return self.expected("'{' of an array initialiser");
        }
        self.take();
        for _ in 0..array.dimensions[depth] {
            if depth + 1 < array.dimensions.len() {
                self.initialise(array, depth + 1)?;
            } else {
                let value = self.element()?;
                let span = self.feed.last_span();
                self.check_element(array.any(), &value, span)?;
                array.elements.push(Some(value));
            }
            if self.fill(true)? == TokenKind::Punct(',') {
                self.take();
            }
        }
        if self.fill(true)? != TokenKind::Punct('}') {
            let size = array.dimensions[depth];
            return self.expected(&format!("'}}' after {size} elements of the array"));
        }
        self.take();
        Ok(())
    }

    /// A value in an initialiser.
    fn element(&mut self) -> SourceResult<Value> {
        match self.fill(true)? {
            TokenKind::Directive(_) => self.expected("an array element (directives cannot stand here)"),
            TokenKind::Name(name) if matches!(self.names.get(name), Some(Value::Macro(_))) => {
                self.expected("an array element (a macro call must stand in parentheses here)")
            }
            _ => match self.argument()? {
                Argument::Value(value) => Ok(value),
                Argument::Alias(place) => match place.get() {
                    Some(value) => Ok(value),
                    None => self.expected("a value that is set"),
                },
            },
        }
    }

    /// All elements of an array have one type.
    pub(super) fn check_element(&self, old: Option<&Value>, new: &Value, span: Span) -> SourceResult<()> {
        let Some(old) = old else { return Ok(()) };
        let same = match (old, new) {
            (Value::Vector(a), Value::Vector(b)) => a.n == b.n,
            _ => std::mem::discriminant(old) == std::mem::discriminant(new),
        };
        if same {
            return Ok(());
        }
        let (old, new) = (old.kind(), new.kind());
        self.error(span, format!("the elements of this array are of type {old}; this one is of type {new}"))
    }

    /// Stores into a variable or element, or unsets an element.
    pub(super) fn store(&self, place: &Place, value: Option<Value>, span: Span) -> SourceResult<()> {
        if let (Some(new), Some((_, outer))) = (&value, place.path.split_last()) {
            let parent = Place { slot: Rc::clone(&place.slot), path: outer.into() };
            let sample = place.get().or_else(|| match parent.get() {
                Some(Value::Array(array)) => array.any().cloned(),
                _ => None,
            });
            self.check_element(sample.as_ref(), new, span)?;
        }
        place.set(value);
        Ok(())
    }
}
