//! Where values live: variables, and elements of arrays within them.

use crate::eval::Value;
use smallvec::SmallVec;
use std::cell::RefCell;
use std::rc::Rc;

/// Where a value lives, shared by all names that alias it.
pub(in crate::eval) type Slot = Rc<RefCell<Value>>;

/// What a name, or a name with indices, refers to.
#[derive(Debug)]
pub(in crate::eval) struct Place {
    /// The variable.
    pub slot: Slot,
    /// For an element: its flat index in each nested array, outermost first.
    pub path: SmallVec<[u32; 2]>,
}

impl Clone for Place {
    #[inline]
    fn clone(&self) -> Self {
        let path = if self.path.is_empty() { SmallVec::new() } else { SmallVec::from_slice(&self.path) };
        Self { slot: Rc::clone(&self.slot), path }
    }
}

impl Place {
    /// A new variable.
    pub(in crate::eval) fn new(value: Value) -> Self {
        Self { slot: Rc::new(RefCell::new(value)), path: SmallVec::new() }
    }

    /// Whether it is a variable that holds a float or vector.
    #[inline]
    pub(in crate::eval) fn holds_number(&self) -> bool {
        self.path.is_empty() && matches!(&*self.slot.borrow(), Value::Float(_) | Value::Vector(_))
    }

    /// Its value, if it is a variable that holds a float.
    #[inline]
    pub(in crate::eval) fn float(&self) -> Option<f64> {
        match &*self.slot.borrow() {
            Value::Float(f) if self.path.is_empty() => Some(*f),
            _ => None,
        }
    }

    /// Looks at the value; `None` for an unset element.
    #[inline]
    pub(in crate::eval) fn with<T>(&self, look: impl FnOnce(Option<&Value>) -> T) -> T {
        let value = self.slot.borrow();
        if self.path.is_empty() {
            return look(Some(&value));
        }
        let mut at = Some(&*value);
        for index in &self.path {
            at = match at {
                Some(Value::Array(array)) => array.elements.get(*index as usize).and_then(Option::as_ref),
                _ => None,
            };
        }
        look(at)
    }

    /// The value; `None` for an unset element.
    pub(in crate::eval) fn get(&self) -> Option<Value> {
        self.with(|value| value.cloned())
    }

    /// The flat index of an element, if an array stands here.
    pub(in crate::eval) fn flat_index(&self, indices: &[f64]) -> Result<usize, String> {
        self.with(|value| match value {
            Some(Value::Array(array)) => array.flat_index(indices),
            _ => Ok(0),
        })
    }

    /// Stores a value, or unsets an element.
    pub(in crate::eval) fn set(&self, value: Option<Value>) {
        let mut slot = self.slot.borrow_mut();
        if self.path.is_empty() {
            if let Some(value) = value {
                *slot = value;
            }
            return;
        }
        let mut at = &mut *slot;
        for (depth, index) in self.path.iter().enumerate() {
            let Value::Array(array) = at else { return };
            let Some(element) = Rc::make_mut(array).elements.get_mut(*index as usize) else { return };
            if depth + 1 == self.path.len() {
                *element = value;
                return;
            }
            let Some(inner) = element else { return };
            at = inner;
        }
    }
}
