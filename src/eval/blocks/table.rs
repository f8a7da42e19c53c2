//! Blocks as tables: which words they take, with what behind each, its default, since when, and what it does.
//!
//! A table reads the block, says what else could have stood there, and is what documentation and completion are made of
//! ([`described`](super::described())). What has no word but its place (the centre of a sphere) stands in what the block's own
//! word takes; words that several blocks have in common are a table that is [part](Block::with) of theirs.
//!
//! ```text
//! static FOG: Block<Fog> = Block::<Fog>::new("fog", "haze that hides what is far away", &[
//!     Item::new(K::Distance, Takes::Float(|fog| &mut fog.distance), "0", "how far one sees"),
//! ])
//! .with(&[&TURBULENCE]);
//! while evaluator.item_of(&FOG, &mut fog)? {}
//! evaluator.close_of(&FOG)
//! ```

use super::described::{Described, TRANSFORMATIONS, Table};
use crate::diag::{SourceResult, Span};
use crate::eval::Evaluator;
use crate::math::{DVec3, Rgb, Transform};
use crate::syntax::{Keyword, TokenKind};

/// A block that makes a `T`.
pub(in crate::eval) struct Block<T: 'static> {
    /// The word before its brace, as messages call it.
    name: &'static str,
    help: &'static str,
    items: &'static [Item<T>],
    /// For each keyword the number of its item, counted from 1.
    numbers: [u8; Keyword::ALL.len()],
    /// What a transformation does to it, if it takes any.
    moves: Option<Move<T>>,
    /// What else it takes, which other tables read.
    parts: &'static [&'static dyn Table],
}

/// Moves what a block makes.
type Move<T> = fn(&Evaluator<'_>, &mut T, &Transform);

/// A word of a block.
pub(super) struct Item<T> {
    word: Keyword,
    /// Another spelling.
    alias: Option<Keyword>,
    takes: Takes<T>,
    default: &'static str,
    /// In hundredths; 0 for what was always there.
    since: u32,
    help: &'static str,
}

/// What stands behind a word, and where it goes.
pub(super) enum Takes<T> {
    /// A float.
    Float(fn(&mut T) -> &mut f64),
    /// A float of which single precision is kept.
    Single(fn(&mut T) -> &mut f32),
    Vector(fn(&mut T) -> &mut DVec3),
    /// Red, green and blue.
    Rgb(fn(&mut T) -> &mut Rgb),
    /// Nothing, or whether it holds.
    Switch(fn(&mut T) -> &mut bool),
    /// Nothing, or an amount; the bare word means 1.
    Amount(fn(&mut T) -> &mut f32),
    /// Nothing.
    Nothing(fn(&mut T)),
    /// What makes all of the target, in the manual's words.
    Whole(&'static str, fn(&mut Evaluator<'_>, Word) -> SourceResult<T>),
    /// Something that is read elsewhere, in the manual's words.
    Elsewhere(&'static str),
    /// Something else, in the manual's words.
    Other(&'static str, Read<T>),
}

/// Reads what stands behind a word.
pub(super) type Read<T> = fn(&mut Evaluator<'_>, &mut T, Word) -> SourceResult<()>;

/// A word that was met, and where.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word {
    pub(super) word: Keyword,
    pub(super) span: Span,
}

impl<T> Item<T> {
    /// A word that was always there; `default` is what holds without it, as it would be written behind it, or nothing.
    pub(super) const fn new(word: Keyword, takes: Takes<T>, default: &'static str, help: &'static str) -> Self {
        Self { word, alias: None, takes, default, since: 0, help }
    }

    /// A word that came with a version.
    pub(super) const fn since(
        version: u32,
        word: Keyword,
        takes: Takes<T>,
        default: &'static str,
        help: &'static str,
    ) -> Self {
        Self { word, alias: None, takes, default, since: version, help }
    }

    /// A word that has another spelling.
    pub(super) const fn spelt(
        alias: Keyword,
        word: Keyword,
        takes: Takes<T>,
        default: &'static str,
        help: &'static str,
    ) -> Self {
        Self { word, alias: Some(alias), takes, default, since: 0, help }
    }

    fn described(&self) -> Described {
        let takes = match self.takes {
            Takes::Float(_) | Takes::Single(_) => "FLOAT",
            Takes::Vector(_) => "VECTOR",
            Takes::Rgb(_) => "COLOUR",
            Takes::Switch(_) => "[BOOL]",
            Takes::Amount(_) => "[FLOAT]",
            Takes::Nothing(_) => "",
            Takes::Elsewhere(takes) | Takes::Whole(takes, _) | Takes::Other(takes, _) => takes,
        };
        let alias = self.alias.map(Keyword::word);
        Described { word: self.word.word(), alias, takes, default: self.default, since: self.since, help: self.help }
    }
}

impl<T> Block<T> {
    /// Of these words.
    pub(super) const fn new(name: &'static str, help: &'static str, items: &'static [Item<T>]) -> Self {
        let mut numbers = [0; Keyword::ALL.len()];
        let mut i = 0;
        while i < items.len() {
            assert!(numbers[items[i].word as usize] == 0, "a word stands twice in a block");
            numbers[items[i].word as usize] = i as u8 + 1;
            if let Some(alias) = items[i].alias {
                numbers[alias as usize] = i as u8 + 1;
            }
            i += 1;
        }
        Self { name, help, items, numbers, moves: None, parts: &[] }
    }

    /// Of these words and transformations.
    pub(super) const fn moved(
        name: &'static str,
        help: &'static str,
        moves: Move<T>,
        items: &'static [Item<T>],
    ) -> Self {
        Self { moves: Some(moves), ..Self::new(name, help, items) }
    }

    /// The same with words that are in other tables.
    pub(super) const fn with(self, parts: &'static [&'static dyn Table]) -> Self {
        Self { parts, ..self }
    }

    /// Whether this is one of its own words.
    #[inline]
    pub(super) fn knows(&self, word: Keyword) -> bool {
        self.numbers[word as usize] != 0
    }

    #[inline]
    fn item(&self, word: Keyword) -> Option<&'static Item<T>> {
        let number = self.numbers[word as usize];
        self.items.get(usize::from(number).checked_sub(1)?)
    }
}

impl<T> Table for Block<T> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn help(&self) -> &'static str {
        self.help
    }

    fn own_words(&self) -> Vec<Described> {
        let moving = if self.moves.is_some() { TRANSFORMATIONS } else { &[] };
        self.items.iter().map(Item::described).chain(moving.iter().copied()).collect()
    }

    fn parts(&self) -> &'static [&'static dyn Table] {
        self.parts
    }
}

/// All of these run directives and macro calls first and fail with what those fail with.
impl Evaluator<'_> {
    /// Reads the item of a block that comes next; false if none does.
    #[inline]
    pub(super) fn item_of<T>(&mut self, block: &Block<T>, target: &mut T) -> SourceResult<bool> {
        let TokenKind::Keyword(word) = self.fill(false)? else { return Ok(false) };
        let Some(item) = block.item(word) else {
            let Some(moves) = block.moves else { return Ok(false) };
            let Some(transform) = self.transformation()? else { return Ok(false) };
            moves(self, target, &transform);
            return Ok(true);
        };
        let at = Word { word, span: self.span() };
        self.take();
        self.read_item(item, target, at)?;
        Ok(true)
    }

    /// Reads what stands behind the word of an item, which was taken.
    #[inline]
    fn read_item<T>(&mut self, item: &Item<T>, target: &mut T, at: Word) -> SourceResult<()> {
        match item.takes {
            Takes::Float(field) => *field(target) = self.float()?,
            Takes::Single(field) => *field(target) = self.float()? as f32,
            Takes::Vector(field) => *field(target) = self.vector()?,
            Takes::Rgb(field) => *field(target) = self.rgb_only(item.word.word())?,
            Takes::Switch(field) => *field(target) = self.optional_bool()?,
            Takes::Amount(field) => *field(target) = self.optional_amount()?,
            Takes::Nothing(act) => act(target),
            Takes::Whole(_, make) => *target = make(self, at)?,
            Takes::Elsewhere(_) => return self.misplaced(at),
            Takes::Other(_, read) => read(self, target, at)?,
        }
        Ok(())
    }

    /// The same for a word that another block has taken.
    pub(super) fn item_behind<T>(&mut self, block: &Block<T>, target: &mut T, at: Word) -> SourceResult<()> {
        block.item(at.word).map_or(Ok(()), |item| self.read_item(item, target, at))
    }

    /// What a word that was taken makes as a whole.
    #[inline]
    pub(super) fn whole_of<T>(&mut self, block: &Block<T>, at: Word) -> SourceResult<T> {
        match block.item(at.word).map(|item| &item.takes) {
            Some(Takes::Whole(_, make)) => make(self, at),
            _ => self.misplaced(at),
        }
    }

    #[cold]
    fn misplaced<T>(&self, at: Word) -> SourceResult<T> {
        self.error(at.span, format!("'{}' cannot stand here", at.word.word()))
    }

    /// Reads all items of a block, with or without commas behind them.
    pub(super) fn items_of<T>(&mut self, block: &Block<T>, target: &mut T) -> SourceResult<()> {
        while self.item_of(block, target)? {
            self.comma()?;
        }
        Ok(())
    }

    /// Takes the `}` of a block, or says what it takes.
    pub(super) fn close_of<T>(&mut self, block: &Block<T>) -> SourceResult<()> {
        if !self.accept_punct('}')? {
            return self.expected_in(block, &format!("'}}' to close {}", block.name));
        }
        self.budget.shallower();
        Ok(())
    }

    /// An optional number; the bare word means 1.
    pub(super) fn optional_amount(&mut self) -> SourceResult<f32> {
        Ok(if self.starts_expression()? { self.float()? as f32 } else { 1.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::{Block, Item, Table, Takes};
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
    fn words_find_their_items() {
        let found = |word| LAMP.item(word).map(|item| item.word);
        assert_eq!(
            [K::Radius, K::Color, K::Colour, K::Fog].map(found),
            [Some(K::Radius), Some(K::Color), Some(K::Color), None]
        );
        let radius = LAMP.words()[0];
        assert_eq!((radius.word, radius.takes, radius.default, radius.since), ("radius", "FLOAT", "1", 350));
    }
}
