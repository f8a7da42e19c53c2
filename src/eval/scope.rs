//! Names and what they stand for.
//!
//! Scoping is dynamic: a stack of tables, the global one at the bottom, one more for each
//! active include file and macro call. Each symbol keeps the stack of its own bindings,
//! so looking a name up is one access whatever the depth.
//!
//! Source: language facts, section 8.

use super::Value;
use crate::syntax::Symbol;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::cell::RefCell;
use std::rc::Rc;

/// Where a value lives, shared by all names that alias it.
pub(super) type Slot = Rc<RefCell<Value>>;

/// What a name, or a name with indices, refers to.
#[derive(Debug)]
pub(super) struct Place {
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
    pub(super) fn new(value: Value) -> Self {
        Self { slot: Rc::new(RefCell::new(value)), path: SmallVec::new() }
    }

    /// Whether it is a variable that holds a float or vector.
    #[inline]
    pub(super) fn holds_number(&self) -> bool {
        self.path.is_empty() && matches!(&*self.slot.borrow(), Value::Float(_) | Value::Vector(_))
    }

    /// Its value, if it is a variable that holds a float.
    #[inline]
    pub(super) fn float(&self) -> Option<f64> {
        match &*self.slot.borrow() {
            Value::Float(f) if self.path.is_empty() => Some(*f),
            _ => None,
        }
    }

    /// Looks at the value; `None` for an unset element.
    #[inline]
    pub(super) fn with<T>(&self, look: impl FnOnce(Option<&Value>) -> T) -> T {
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
    pub(super) fn get(&self) -> Option<Value> {
        self.with(|value| value.cloned())
    }

    /// The flat index of an element, if an array stands here.
    pub(super) fn flat_index(&self, indices: &[f64]) -> Result<usize, String> {
        self.with(|value| match value {
            Some(Value::Array(array)) => array.flat_index(indices),
            _ => Ok(0),
        })
    }

    /// Stores a value, or unsets an element.
    pub(super) fn set(&self, value: Option<Value>) {
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

/// One meaning of a name.
#[derive(Clone, Debug)]
struct Binding {
    /// Index of the table it belongs to.
    table: u32,
    place: Place,
}

/// A table of names, open while a file is read or a macro runs.
#[derive(Debug)]
struct Table {
    /// Distinguishes tables that follow each other at the same depth.
    id: u64,
    names: Vec<Symbol>,
}

/// Identifies a table for as long as it is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TableId {
    index: u32,
    id: u64,
}

/// All names in force.
#[derive(Debug)]
pub(super) struct Scopes {
    bindings: Vec<SmallVec<[Binding; 1]>>,
    tables: Vec<Table>,
    /// Lists of names of closed tables, to be used again.
    spare: Vec<Vec<Symbol>>,
    /// Variables of closed tables that nothing refers to, to be used again.
    spare_slots: Vec<Slot>,
    opened: u64,
    /// Of each name, whether what it stands for was used.
    used: Vec<bool>,
    /// Names declared `deprecated`: whether to warn only once, and the text.
    pub(super) deprecated: FxHashMap<Symbol, (bool, Rc<str>)>,
}

impl Default for Scopes {
    fn default() -> Self {
        let global = Table { id: 0, names: Vec::new() };
        let deprecated = FxHashMap::default();
        Self {
            bindings: Vec::new(),
            tables: vec![global],
            spare: Vec::new(),
            spare_slots: Vec::new(),
            opened: 0,
            used: Vec::new(),
            deprecated,
        }
    }
}

impl Scopes {
    /// Opens a table.
    pub(super) fn push(&mut self) {
        self.opened += 1;
        let names = self.spare.pop().unwrap_or_default();
        self.tables.push(Table { id: self.opened, names });
    }

    /// Closes the innermost table with all its names.
    pub(super) fn pop(&mut self) {
        if self.tables.len() < 2 {
            return;
        }
        let Some(mut table) = self.tables.pop() else { return };
        let index = self.tables.len() as u32;
        for name in table.names.drain(..) {
            let bindings = &mut self.bindings[name.0 as usize];
            if bindings.last().is_some_and(|b| b.table == index)
                && let Some(closed) = bindings.pop()
            {
                Self::keep(&mut self.spare_slots, closed.place.slot);
            }
        }
        self.spare.push(table.names);
    }

    /// Keeps a variable for another name if nothing else refers to it.
    fn keep(spare: &mut Vec<Slot>, mut slot: Slot) {
        /// As many as the macros and files that are open at a time declare, more or less.
        const MAX_SPARE: usize = 256;
        if spare.len() < MAX_SPARE
            && let Some(value) = Rc::get_mut(&mut slot)
        {
            *value.get_mut() = Value::Float(0.0);
            spare.push(slot);
        }
    }

    /// A new variable.
    #[inline]
    pub(super) fn place(&mut self, value: Value) -> Place {
        match self.spare_slots.pop() {
            Some(slot) => {
                *slot.borrow_mut() = value;
                Place { slot, path: SmallVec::new() }
            }
            None => Place::new(value),
        }
    }

    /// The innermost table.
    pub(super) fn innermost(&self) -> TableId {
        let index = self.tables.len() - 1;
        TableId { index: index as u32, id: self.tables[index].id }
    }

    /// The global table.
    pub(super) const GLOBAL: TableId = TableId { index: 0, id: 0 };

    /// What the name stands for.
    #[inline]
    pub(super) fn find(&self, name: Symbol) -> Option<&Place> {
        self.bindings.get(name.0 as usize)?.last().map(|b| &b.place)
    }

    /// What the name stands for, if that is a variable that holds a float.
    #[inline]
    pub(super) fn float(&self, name: Symbol) -> Option<f64> {
        self.find(name)?.float()
    }

    /// Whether the name stands for a macro.
    #[inline]
    pub(super) fn is_macro(&self, name: Symbol) -> bool {
        self.find(name).is_some_and(|place| matches!(&*place.slot.borrow(), Value::Macro(_)))
    }

    /// What the name stands for in the innermost table alone.
    pub(super) fn find_innermost(&self, name: Symbol) -> Option<&Place> {
        let binding = self.bindings.get(name.0 as usize)?.last()?;
        (binding.table as usize + 1 == self.tables.len()).then_some(&binding.place)
    }

    /// Lets the name stand for `place` in a table, if that is still open.
    pub(super) fn bind(&mut self, table: TableId, name: Symbol, place: Place) {
        match self.tables.get_mut(table.index as usize) {
            Some(open) if open.id == table.id => open.names.push(name),
            _ => return,
        }
        let index = name.0 as usize;
        if self.bindings.len() <= index {
            self.bindings.resize_with(index + 1, SmallVec::new);
        }
        let bindings = &mut self.bindings[index];
        if bindings.last().is_none_or(|last| last.table < table.index) {
            bindings.push(Binding { table: table.index, place });
            return;
        }
        let at = bindings.partition_point(|b| b.table < table.index);
        match bindings.get_mut(at) {
            Some(same) if same.table == table.index => same.place = place,
            _ => bindings.insert(at, Binding { table: table.index, place }),
        }
    }

    /// Notes that what a name stands for is used.
    #[inline]
    pub(super) fn note_use(&mut self, name: Symbol) {
        let index = name.0 as usize;
        if self.used.len() <= index {
            self.used.resize(self.bindings.len().max(index + 1), false);
        }
        self.used[index] = true;
    }

    /// What names that were never used stand for.
    pub(super) fn unused(&self) -> impl Iterator<Item = &Place> {
        let is_used = |name: &Symbol| self.used.get(name.0 as usize).is_some_and(|used| *used);
        self.names().filter(move |name| !is_used(name)).filter_map(|name| self.find(name))
    }

    /// Removes the innermost meaning of a name; false if there is none.
    pub(super) fn unbind(&mut self, name: Symbol) -> bool {
        self.bindings.get_mut(name.0 as usize).is_some_and(|b| b.pop().is_some())
    }

    /// All names with a meaning.
    pub(super) fn names(&self) -> impl Iterator<Item = Symbol> {
        self.bindings.iter().enumerate().filter(|(_, b)| !b.is_empty()).map(|(i, _)| Symbol(i as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn float(scopes: &Scopes, name: Symbol) -> Option<f64> {
        scopes.find(name)?.get()?.number().map(|n| n.v[0])
    }

    #[test]
    fn inner_tables_hide_outer_ones_until_they_close() {
        let (mut scopes, name) = (Scopes::default(), Symbol(3));
        scopes.bind(Scopes::GLOBAL, name, Place::new(Value::Float(1.0)));
        scopes.push();
        let inner = scopes.innermost();
        assert!(scopes.find_innermost(name).is_none());
        scopes.bind(inner, name, Place::new(Value::Float(2.0)));
        assert_eq!(float(&scopes, name), Some(2.0));
        scopes.pop();
        assert_eq!(float(&scopes, name), Some(1.0));
        scopes.push();
        scopes.bind(inner, name, Place::new(Value::Float(3.0)));
        assert_eq!(float(&scopes, name), Some(1.0), "a closed table takes nothing");
    }

    #[test]
    fn a_global_made_under_a_local_stays_hidden() {
        let (mut scopes, name) = (Scopes::default(), Symbol(0));
        scopes.push();
        scopes.bind(scopes.innermost(), name, Place::new(Value::Float(1.0)));
        scopes.bind(Scopes::GLOBAL, name, Place::new(Value::Float(2.0)));
        assert_eq!(float(&scopes, name), Some(1.0));
        scopes.pop();
        assert_eq!(float(&scopes, name), Some(2.0));
        assert!(scopes.unbind(name) && !scopes.unbind(name));
    }
}
