//! Identifiers as small integers.

use rustc_hash::FxHashMap;
use std::rc::Rc;

/// An identifier; equal symbols are equal words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// All identifiers met so far.
#[derive(Debug, Default)]
pub struct Words {
    words: Vec<Rc<str>>,
    symbols: FxHashMap<Rc<str>, Symbol>,
}

impl Words {
    /// The symbol of a word, made on first sight.
    pub fn intern(&mut self, word: &str) -> Symbol {
        if let Some(&symbol) = self.symbols.get(word) {
            return symbol;
        }
        let symbol = Symbol(u32::try_from(self.words.len()).unwrap_or(u32::MAX));
        let word: Rc<str> = word.into();
        self.words.push(Rc::clone(&word));
        self.symbols.insert(word, symbol);
        symbol
    }

    /// The word of a symbol.
    pub fn word(&self, symbol: Symbol) -> &Rc<str> {
        &self.words[symbol.0 as usize]
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.words.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// All words, oldest first.
    pub fn iter(&self) -> impl Iterator<Item = (Symbol, &str)> {
        self.words.iter().enumerate().map(|(i, w)| (Symbol(i as u32), &**w))
    }
}
