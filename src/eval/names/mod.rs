//! Names and what they stand for.
//!
//! Scoping is dynamic: a stack of tables, the global one at the bottom, one more for each
//! active include file and macro call. Each symbol keeps the stack of its own bindings,
//! so looking a name up is one access whatever the depth.
//!
//! Source: language facts, section 8.

mod place;
#[cfg(test)]
mod tests;

pub(super) use place::{Place, Slot};

use super::{Macro, Number, Value};
use crate::scene::Function;
use crate::syntax::formula::Scope;
use crate::syntax::{Symbol, Words};
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::rc::Rc;
use std::sync::Arc;

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
pub(super) struct Names {
    /// The words of the symbols.
    pub(super) words: Words,
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
    deprecated: FxHashMap<Symbol, (bool, Rc<str>)>,
}

impl Default for Names {
    fn default() -> Self {
        let global = Table { id: 0, names: Vec::new() };
        let deprecated = FxHashMap::default();
        Self {
            words: Words::default(),
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

impl Names {
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

    /// What the name stands for, if that is a number.
    pub(super) fn number(&self, name: Symbol) -> Option<Number> {
        self.find(name)?.with(|value| value.and_then(Value::number))
    }

    /// The value of that name; an element that is not set has none.
    pub(super) fn get(&self, name: Symbol) -> Option<Value> {
        self.find(name).and_then(Place::get)
    }

    /// The function of that name.
    pub(super) fn function(&self, name: Symbol) -> Option<Arc<Function>> {
        self.find(name)?.with(|value| match value {
            Some(Value::Function(function)) => Some(Arc::clone(function)),
            _ => None,
        })
    }

    /// The macro of that name.
    pub(super) fn macro_named(&self, name: Symbol) -> Option<Rc<Macro>> {
        let place = self.find(name)?;
        match &*place.slot.borrow() {
            Value::Macro(called) if place.path.is_empty() => Some(Rc::clone(called)),
            _ => None,
        }
    }

    /// Whether the name, or an element of the array it stands for, is a value of which that holds.
    pub(super) fn stands_for(&self, name: Symbol, holds: impl Fn(&Value) -> bool) -> bool {
        self.find(name).is_some_and(|place| {
            place.with(|value| match value {
                Some(Value::Array(array)) => array.sample().is_some_and(holds),
                value => value.is_some_and(holds),
            })
        })
    }

    /// What a declaration in that scope changes.
    #[inline]
    pub(super) fn find_in(&self, scope: Scope, name: Symbol) -> Option<&Place> {
        match scope {
            Scope::Any => self.find(name),
            Scope::Local => self.find_innermost(name),
        }
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

    /// Lets every use of a name be warned of, or only the first one.
    pub(super) fn deprecate(&mut self, name: Symbol, once: bool, text: Rc<str>) {
        self.deprecated.insert(name, (once, text));
    }

    /// What to warn of at a use of a name.
    #[inline]
    pub(super) fn deprecation(&mut self, name: Symbol) -> Option<Rc<str>> {
        if self.deprecated.is_empty() {
            return None;
        }
        let (once, text) = self.deprecated.get(&name).cloned()?;
        if once {
            self.deprecated.remove(&name);
        }
        Some(text)
    }

    /// Whether there are names whose use is to be warned of.
    #[inline]
    pub(super) fn any_deprecated(&self) -> bool {
        !self.deprecated.is_empty()
    }

    /// What a message calls a name: what it stands for, and its word.
    pub(super) fn describe(&self, name: Symbol) -> String {
        let word = self.words.word(name);
        match self.find(name).map(|place| place.with(|value| value.map(Value::kind))) {
            Some(Some(kind)) => format!("the {kind} '{word}'"),
            Some(None) => format!("the unset '{word}'"),
            None => format!("the undeclared name '{word}'"),
        }
    }

    /// What names that were never used stand for.
    pub(super) fn unused(&self) -> impl Iterator<Item = &Place> {
        let is_used = |name: &Symbol| self.used.get(name.0 as usize).is_some_and(|used| *used);
        self.declared().filter(move |name| !is_used(name)).filter_map(|name| self.find(name))
    }

    /// Removes the innermost meaning of a name; false if there is none.
    pub(super) fn unbind(&mut self, name: Symbol) -> bool {
        self.bindings.get_mut(name.0 as usize).is_some_and(|b| b.pop().is_some())
    }

    /// All names with a meaning.
    pub(super) fn declared(&self) -> impl Iterator<Item = Symbol> {
        self.bindings.iter().enumerate().filter(|(_, b)| !b.is_empty()).map(|(i, _)| Symbol(i as u32))
    }
}
