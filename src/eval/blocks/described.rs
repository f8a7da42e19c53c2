//! What tables tell people: pages about blocks, and what else could have stood where a block ends with something unknown.

use crate::diag::{Diagnostic, completed, nearest};
use crate::syntax::Keyword;

/// A word of a block, for people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Described {
    /// The word.
    pub word: &'static str,
    /// Another spelling.
    pub alias: Option<&'static str>,
    /// What stands behind it, in the words of the manual; brackets around what may be left out.
    pub takes: &'static str,
    /// What holds without it, if that can be written down.
    pub default: &'static str,
    /// The version it came with, in hundredths; 0 for what was always there.
    pub since: u32,
    /// What it does, in one line.
    pub help: &'static str,
}

/// A block of the language, for people.
#[derive(Clone, Debug)]
pub struct DescribedBlock {
    /// The word before its brace.
    pub name: &'static str,
    /// What it is, in one line.
    pub help: &'static str,
    /// Its own words.
    pub words: Vec<Described>,
    /// What it takes as other blocks do.
    pub parts: Vec<Self>,
}

impl DescribedBlock {
    pub(super) fn of(table: &dyn Table) -> Self {
        let parts = table.parts().iter().map(|part| Self::of(*part)).collect();
        Self { name: table.name(), help: table.help(), words: table.own_words(), parts }
    }

    /// All of its words.
    pub fn all_words(&self) -> Vec<Described> {
        let of_parts = self.parts.iter().flat_map(Self::all_words);
        self.words.iter().copied().chain(of_parts).collect()
    }
}

/// Words that every block takes which can be moved.
pub(super) const TRANSFORMATIONS: &[Described] = &[
    transformation("translate", "VECTOR", "moves it"),
    transformation("rotate", "VECTOR", "turns it about x, then y, then z, in degrees"),
    transformation("scale", "VECTOR", "stretches it along the axes"),
    transformation("matrix", "<12 FLOATS>", "moves it as the images of x, y, z and 0 say"),
    transformation("transform", "{ items }", "moves it as several transformations do"),
];

const fn transformation(word: &'static str, takes: &'static str, help: &'static str) -> Described {
    Described { word, alias: None, takes, default: "", since: 0, help }
}

/// A table, whatever it makes.
pub(in crate::eval) trait Table: Sync {
    /// The word before its brace.
    fn name(&self) -> &'static str;
    /// What it is, in one line.
    fn help(&self) -> &'static str;
    /// Its own words, in the order of the table.
    fn own_words(&self) -> Vec<Described>;
    /// The tables whose words it takes beside these.
    fn parts(&self) -> &'static [&'static dyn Table];

    /// All of its words.
    fn words(&self) -> Vec<Described> {
        let parts = self.parts().iter().flat_map(|part| part.words());
        self.own_words().into_iter().chain(parts).collect()
    }
}

/// What may have been meant by a word that a block does not know.
pub(in crate::eval) fn meant_in(table: &dyn Table, word: &str) -> Option<String> {
    let words = table.words();
    let words = || words.iter().map(|described| described.word);
    let near = nearest(word, words()).or_else(|| completed(word, words()))?;
    Some(format!("did you mean '{near}'?"))
}

/// More words than this are no help in a message.
const MOST_TOLD: usize = 60;

/// What a block takes.
pub(in crate::eval) fn words_of(table: &dyn Table) -> String {
    let mut words: Vec<_> = table.words().iter().map(|described| described.word).collect();
    words.sort_unstable();
    words.dedup();
    if words.len() > MOST_TOLD {
        return format!("'whitted language {}' lists what it takes", table.name());
    }
    format!("{} takes {}", table.name(), words.join(", "))
}

/// The errors of something that was expected in a block, with advice from its table.
pub(in crate::eval) fn with_words(
    mut errors: Vec<Diagnostic>,
    table: &dyn Table,
    found: Option<&str>,
) -> Vec<Diagnostic> {
    if let Some(error) = errors.first_mut() {
        if let Some(meant) = found.and_then(|word| meant_in(table, word)) {
            error.hints = vec![meant];
        }
        // Words of the language that only other blocks take help nobody.
        error.hints.retain(|hint| {
            let word = hint.strip_prefix("did you mean '").and_then(|rest| rest.split('\'').next());
            let keyword = word.filter(|word| Keyword::from_word(word).is_some());
            keyword.is_none_or(|keyword| table.words().iter().any(|described| described.word == keyword))
        });
        if error.hints.is_empty() {
            error.hints.push(words_of(table));
        }
    }
    errors
}

#[cfg(test)]
mod tests {
    use super::{meant_in, with_words, words_of};
    use crate::diag::{Diagnostic, Span};
    use crate::eval::blocks::table::{Block, Item, Takes};
    use crate::syntax::Keyword as K;

    /// A block that can be read without anything.
    static LAMP: Block<(f64, bool)> = Block::new(
        "lamp",
        "a light that can be held",
        &[
            Item::since(350, K::Radius, Takes::Float(|lamp| &mut lamp.0), "1", "how large it is"),
            Item::spelt(K::Colour, K::Color, Takes::Switch(|lamp| &mut lamp.1), "off", "whether it is coloured"),
        ],
    );

    #[test]
    fn tables_say_what_could_have_stood_there() {
        assert_eq!(meant_in(&LAMP, "raduis"), Some("did you mean 'radius'?".into()));
        assert_eq!(words_of(&LAMP), "lamp takes color, radius");
        let hints = |found| with_words(vec![Diagnostic::error(Span::default(), "wrong")], &LAMP, found).remove(0).hints;
        assert_eq!(hints(Some("colr")), ["did you mean 'color'?"]);
        assert_eq!(hints(Some("spere")), ["lamp takes color, radius"]);
        assert_eq!(hints(None), ["lamp takes color, radius"]);
    }
}
